"""What a modelled flank is like at one place of the theoretical flank."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.curvature import (
    CurvatureMap,
    surface_curvature,
    surface_derivatives,
    theory_curvature_at,
)
from gearstudio.errors import GeometryError
from gearstudio.nurbs import NurbsSurface
from gearstudio.theory.flank import Flank

Floats = NDArray[np.float64]
_START_GRID = (17, 33)
_STEPS = 20
_CLOSE = 1e-9
"""Of the cone distance; farther from the place wanted, the surface does not reach it."""


@dataclass(frozen=True)
class Curvature:
    """At a point: Gaussian [1/mm²], mean and principal curvatures [1/mm]."""

    gaussian: float
    mean: float
    largest: float
    smallest: float


@dataclass(frozen=True)
class Probe:
    """Of a surface at a place: parameters, point [mm], deviation [µm], curvature (None where it is infinite)."""

    u: float
    v: float
    point: Floats
    deviation_um: float
    curvature: Curvature | None


def probe(surface: NurbsSurface, flank: Flank, rho: float, delta: float) -> Probe | None:
    """The point of a surface with a given cone distance [mm] and polar angle [rad]; None where it does not reach.

    Newton's method for (ρ, δ)(u, v), started from the nearest of a coarse grid.
    """
    u, v = _start(surface, flank, rho, delta)
    u0, u1, v0, v1 = surface.bounds
    for _ in range(_STEPS):
        points, (along_u, along_v, *_) = surface_derivatives(surface, [u], [v])
        point = points[0, 0]
        miss = _miss(point, rho, delta)
        if float(np.hypot(*miss)) < _CLOSE * rho:
            break
        columns = [_change(point, along[0, 0]) for along in (along_u, along_v)]
        try:
            step = np.linalg.solve(np.stack(columns, axis=-1), miss)
        except np.linalg.LinAlgError:
            return None
        u, v = float(np.clip(u + step[0], u0, u1)), float(np.clip(v + step[1], v0, v1))
    else:
        return None
    return Probe(u, v, point, float(flank.deviation(point)) * 1e3, _curvature_of(surface, flank, u, v))


def theory_at(flank: Flank, rho: float, delta: float) -> Curvature | None:
    """Curvature of the theoretical flank at a place; None on the base cone, where it is infinite."""
    try:
        return _single(theory_curvature_at(flank, *flank.natural_at(rho, delta)))
    except GeometryError:
        return None


def _start(surface: NurbsSurface, flank: Flank, rho: float, delta: float) -> tuple[float, float]:
    u0, u1, v0, v1 = surface.bounds
    u, v = np.linspace(u0, u1, _START_GRID[0]), np.linspace(v0, v1, _START_GRID[1])
    points = surface.grid(u, v)
    rhos, deltas, _ = flank.locate(points)
    row, col = np.unravel_index(int(np.argmin((rhos - rho) ** 2 + (rho * (deltas - delta)) ** 2)), rhos.shape)
    return float(u[row]), float(v[col])


def _miss(point: Floats, rho: float, delta: float) -> Floats:
    """What is missing to the place wanted, in mm along ρ and along δ."""
    radius = float(np.hypot(point[0], point[1]))
    return np.array([rho - float(np.linalg.norm(point)), rho * (delta - float(np.arctan2(radius, point[2])))])


def _change(point: Floats, along: Floats) -> Floats:
    """Change of ρ and of ρ·δ along a tangent."""
    rho, radius = float(np.linalg.norm(point)), float(np.hypot(point[0], point[1]))
    outward = (point[0] * along[0] + point[1] * along[1]) / radius
    return np.array([point @ along / rho, (point[2] * outward - radius * along[2]) / rho])


def _curvature_of(surface: NurbsSurface, flank: Flank, u: float, v: float) -> Curvature | None:
    try:
        return _single(surface_curvature(surface, flank, [u], [v]))
    except GeometryError:
        return None


def _single(found: CurvatureMap) -> Curvature:
    return Curvature(*(float(np.ravel(x)[0]) for x in (found.gaussian, found.mean, found.largest, found.smallest)))
