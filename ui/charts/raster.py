"""Values on a flank, drawn flat: the axial projection and its even raster; numpy alone."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.vectors import spherical

Floats = NDArray[np.float64]


def drawn_flat(rho: Floats, polar_angle: Floats, pitch_angle: float) -> tuple[Floats, Floats]:
    """Place along the pitch cone's element and height above it [mm], of the shape given; angles in radians."""
    lean = polar_angle - pitch_angle
    return rho * np.cos(lean), rho * np.sin(lean)


def points_flat(points: Floats, pitch_angle: float) -> tuple[Floats, Floats]:
    """`drawn_flat` of points, shape (..., 3)."""
    return drawn_flat(*spherical(points)[:2], pitch_angle)


def frame(edge: Floats) -> tuple[float, ...]:
    """The least rectangle (x0, y0, width, height) around points of shape (n, 2)."""
    return (*map(float, edge.min(axis=0)), *map(float, np.ptp(edge, axis=0)))


def raster(x: Floats, y: Floats, values: Floats, size: tuple[int, int], extent: tuple[float, ...]) -> Floats:
    """Values on a curved grid brought to an even raster.

    Parameters
    ----------
    x, y, values : ndarray, shape (n_u, n_v)
        x must grow along v, y must grow or fall along u. Values may be infinite.
    size : (int, int)
        Rows and columns.
    extent : (x0, y0, width, height)
        Of the raster.

    Returns
    -------
    ndarray, shape size
        Row 0 at the least y; NaN outside the grid.
    """
    rows, columns = size
    if y[-1].mean() < y[0].mean():
        x, y, values = x[::-1], y[::-1], values[::-1]
    across = extent[0] + (np.arange(columns) + 0.5) / columns * extent[2]
    up = extent[1] + (np.arange(rows) + 0.5) / rows * extent[3]
    outside = {"left": np.nan, "right": np.nan}
    at_y = np.array([np.interp(across, xs, ys, **outside) for xs, ys in zip(x, y, strict=True)])
    at_v = np.array([np.interp(across, xs, vs, **outside) for xs, vs in zip(x, values, strict=True)])
    image = np.full(size, np.nan)
    for column in range(columns):
        inside = np.isfinite(at_y[:, column])
        if np.count_nonzero(inside) > 1:
            image[:, column] = np.interp(up, at_y[inside, column], at_v[inside, column], **outside)
    return image


def inside(edge: Floats, size: tuple[int, int], extent: tuple[float, ...]) -> NDArray[np.bool_]:
    """Which places of a raster lie inside a closed polygon of shape (n, 2)."""
    rows, columns = size
    x = extent[0] + (np.arange(columns) + 0.5) / columns * extent[2]
    y = extent[1] + (np.arange(rows) + 0.5) / rows * extent[3]
    found = np.zeros(size, dtype=bool)
    for (x0, y0), (x1, y1) in zip(edge, np.roll(edge, -1, axis=0), strict=True):
        spans = (y0 > y) != (y1 > y)
        if np.any(spans):
            crossing = x0 + (y[spans] - y0) / (y1 - y0) * (x1 - x0)
            found[spans] ^= x[None, :] < crossing[:, None]
    return found


def outline(x: Floats, y: Floats) -> Floats:
    """The edge of a grid as a closed polygon, shape (n, 2)."""
    edges = [(x[0], y[0]), (x[:, -1], y[:, -1]), (x[-1, ::-1], y[-1, ::-1]), (x[::-1, 0], y[::-1, 0])]
    return np.concatenate([np.stack(edge, axis=-1) for edge in edges])
