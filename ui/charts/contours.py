"""Contour lines of values on a curved grid; numpy alone."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
_STEPS = (1.0, 2.0, 5.0, 10.0)


def round_step(span: float, wanted: int = 8) -> float:
    """The least of 1, 2, 5 times a power of ten of which no more than so many go into a span; 0 for no span."""
    if not span > 0:
        return 0.0
    least = span / wanted
    power = 10.0 ** np.floor(np.log10(least))
    return float(next(step * power for step in _STEPS if step * power >= least * (1 - 1e-9)))


def contour_pairs(x: Floats, y: Floats, values: Floats, levels: Floats) -> Floats:
    """Strokes of the contours at some levels, as pairs of points, shape (2 n, 2).

    Parameters
    ----------
    x, y, values : ndarray, shape (n_u, n_v)
        Cells with a corner that is not finite are left out; a cell is two triangles, straight within each.
    levels : ndarray, shape (k,)
    """
    nodes = np.stack([x, y, values], axis=-1)
    first = np.stack([nodes[:-1, :-1], nodes[1:, :-1], nodes[1:, 1:]], axis=-2).reshape(-1, 3, 3)
    second = np.stack([nodes[:-1, :-1], nodes[1:, 1:], nodes[:-1, 1:]], axis=-2).reshape(-1, 3, 3)
    corners = np.concatenate([first, second])
    corners = corners[np.all(np.isfinite(corners), axis=(1, 2))]
    return np.concatenate([np.empty((0, 2)), *(_crossings(corners, level) for level in levels)])


def _crossings(corners: Floats, level: float) -> Floats:
    """Where the edges of triangles (n, 3 corners, 3) come to a level: two places for each that is crossed."""
    above = corners[..., 2] > level
    crossed = corners[np.any(above, axis=1) & ~np.all(above, axis=1)]
    ahead = np.roll(crossed, -1, axis=1)
    cut = (crossed[..., 2] > level) != (ahead[..., 2] > level)
    with np.errstate(divide="ignore", invalid="ignore"):
        share = (level - crossed[..., 2]) / (ahead[..., 2] - crossed[..., 2])
    places = crossed[..., :2] + share[..., None] * (ahead[..., :2] - crossed[..., :2])
    return np.asarray(places[cut])
