"""Spline spaces: fitting grids of points in a given one, so that neighbouring faces share their edge exactly."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.errors import GeometryError
from gearstudio.nurbs import NurbsSurface, basis_matrix

Floats = NDArray[np.float64]
Points = Callable[[Floats, Floats], Floats]
"""Points (n, m, 3) on the tensor grid of x (n,) and y (m,)."""

_LARGEST = 700
_ROUNDS = 12
_SAME_KNOT = 1e-9


@dataclass(frozen=True)
class Space:
    """The splines of a degree over clamped knots on [0, 1], multiplicities written out."""

    degree: int
    knots: Floats

    @staticmethod
    def even(degree: int, spans: int) -> Space:
        """Evenly spaced simple knots."""
        return Space(degree, np.r_[[0.0] * degree, np.linspace(0.0, 1.0, spans + 1), [1.0] * degree])

    @property
    def nodes(self) -> Floats:
        """Greville's places, at which any values are taken by exactly one spline of the space, shape (n,)."""
        windows = np.lib.stride_tricks.sliding_window_view(self.knots[1:-1], self.degree)
        return np.asarray(windows.mean(axis=1))

    @property
    def breaks(self) -> Floats:
        """The distinct knots."""
        return np.unique(self.knots)

    def between(self) -> Floats:
        """Places inside every span at which a fit is looked at."""
        breaks = self.breaks
        inner = np.linspace(0.0, 1.0, 2 * self.degree + 4)[1:-1]
        return np.asarray((breaks[:-1, None] + np.diff(breaks)[:, None] * inner).ravel())

    def refined(self) -> Space:
        """The larger space with every span halved; it holds every spline of this one."""
        breaks = self.breaks
        return Space(self.degree, np.sort(np.r_[self.knots, (breaks[:-1] + breaks[1:]) / 2]))

    def joined(self, other: Space) -> Space:
        """The smallest space that holds both."""
        degree = max(self.degree, other.degree)
        multiplicity: dict[float, int] = {}
        for space in (self, other):
            knots, counts = np.unique(space.knots, return_counts=True)
            for knot, count in zip(knots.tolist(), counts.tolist(), strict=True):
                same = next((k for k in multiplicity if abs(k - knot) < _SAME_KNOT), knot)
                multiplicity[same] = max(multiplicity.get(same, 0), degree - space.degree + count)
        pairs = sorted(multiplicity.items())
        return Space(degree, np.repeat([k for k, _ in pairs], [min(n, degree + 1) for _, n in pairs]))


def space_u(surface: NurbsSurface) -> Space:
    """The space of a surface's lines along u."""
    return Space(surface.degree_u, surface.knots_u)


def space_v(surface: NurbsSurface) -> Space:
    """The space of a surface's lines along v."""
    return Space(surface.degree_v, surface.knots_v)


def interpolated(u: Space, v: Space, points: Points) -> NurbsSurface:
    """The surface of two spaces through points at their nodes."""
    grid = points(u.nodes, v.nodes)
    along_u = np.linalg.solve(basis_matrix(u.nodes, u.knots, u.degree), grid.reshape(len(grid), -1))
    half = along_u.reshape(grid.shape).transpose(1, 0, 2)
    poles = np.linalg.solve(basis_matrix(v.nodes, v.knots, v.degree), half.reshape(len(half), -1))
    return NurbsSurface(poles.reshape(half.shape).transpose(1, 0, 2), u.knots, v.knots, u.degree, v.degree)


def fitted(what: str, u: Space, v: Space, points: Points, goal: float) -> NurbsSurface:
    """The surface through points, in spaces refined until it keeps to the points between its nodes.

    Parameters
    ----------
    what : str
        For the message.
    u, v : Space
        To begin with.
    points : callable
    goal : float
        [mm]

    Raises
    ------
    GeometryError
        The goal was not met with the largest spaces allowed.
    """
    for _ in range(_ROUNDS):
        surface = interpolated(u, v, points)
        errors = [gap(surface, points, x, y) for x, y in ((u.between(), v.nodes), (u.nodes, v.between()))]
        if sum(errors) <= goal:
            return surface
        u, v = (s if 2 * error <= goal else s.refined() for s, error in zip((u, v), errors, strict=True))
        if max(len(u.nodes), len(v.nodes)) > _LARGEST:
            break
    raise GeometryError(f"the {what} could not be fitted within {goal * 1e3:.3g} µm (got {sum(errors) * 1e3:.3g} µm)")


def gap(surface: NurbsSurface, points: Points, x: Floats, y: Floats) -> float:
    """Farthest that a surface lies from points on a grid [mm]."""
    return float(np.linalg.norm(surface.grid(x, y) - points(x, y), axis=-1).max())
