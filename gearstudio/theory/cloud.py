"""Points of a flank on U lines (cone distance constant) and V lines (place on the profile constant) (theory 7)."""

from __future__ import annotations

from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.errors import GeometryError
from gearstudio.theory.flank import Flank

Floats = NDArray[np.float64]
Spacing = Literal["uniform", "arc", "cosine"]
SPACINGS: tuple[Spacing, ...] = get_args(Spacing)
_ARC_SAMPLES = 400


def graded(count: int, spacing: Spacing = "uniform") -> Floats:
    """Places in [0, 1], both ends included: even, or (``cosine``) denser toward the ends, shape (count,)."""
    even = np.linspace(0.0, 1.0, count)
    return np.asarray((1 - np.cos(np.pi * even)) / 2) if spacing == "cosine" else even


def flank_grid(flank: Flank, rows: int, cols: int, spacing: Spacing = "uniform") -> Floats:
    """Theoretical point cloud of a flank.

    Parameters
    ----------
    flank : Flank
    rows : int
        U lines: cone distances from toe (R - B) to heel (R).
    cols : int
        Points on each, from root (or base cone) to tip.
    spacing : {"uniform", "arc", "cosine"}
        Even in cone distance and polar angle; even in arc length along both; denser toward the ends.

    Returns
    -------
    ndarray, shape (rows, cols, 3)
    """
    rho, delta = flank_coordinates(flank, rows, cols, spacing)
    return flank.points_at(rho, delta)


def flank_coordinates(flank: Flank, rows: int, cols: int, spacing: Spacing = "uniform") -> tuple[Floats, Floats]:
    """Cone distances [mm] and polar angles [rad] of `flank_grid`, each of shape (rows, cols).

    Raises
    ------
    GeometryError
        Fewer than two rows or columns, or an unknown spacing.
    """
    if rows < 2 or cols < 2:
        raise GeometryError(f"a grid of {rows} x {cols} points has no area; use 2 or more each way")
    if spacing not in SPACINGS:
        raise GeometryError(f"unknown spacing {spacing!r}; use one of {', '.join(SPACINGS)}")
    member = flank.member

    def at(place_rho: ArrayLike, place_delta: ArrayLike) -> tuple[Floats, Floats]:
        rho = member.along_face(place_rho)
        low = flank.lower_angle(rho)
        high = member.tip_limit.at_sphere(rho)
        rho, delta = np.broadcast_arrays(rho, low + np.asarray(place_delta) * (high - low))
        return np.asarray(rho), np.asarray(delta)

    if spacing != "arc":
        return at(graded(rows, spacing)[:, None], graded(cols, spacing)[None, :])
    fine = np.linspace(0.0, 1.0, _ARC_SAMPLES)
    along = _even_in_length(flank.points_at(*at(fine, np.full_like(fine, 0.5))), fine, rows)
    profiles = [_even_in_length(flank.points_at(*at(np.full_like(fine, r), fine)), fine, cols) for r in along]
    return at(along[:, None], np.array(profiles))


def _even_in_length(points: Floats, places: Floats, count: int) -> Floats:
    """Places that divide a curve, sampled at the given places, into equal lengths."""
    steps = np.linalg.norm(np.diff(points, axis=0), axis=-1)
    length = np.concatenate([[0.0], np.cumsum(steps)])
    return np.asarray(np.interp(np.linspace(0.0, length[-1], count), length, places))
