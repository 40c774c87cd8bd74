"""The pinion flank as a grid of points, and the closer look around the best of them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.analysis.contact_placing import FlankMesh, Meeting, Misalignment
from gearstudio.analysis.contact_series import FlankSeries, flank_series
from gearstudio.errors import GeometryError
from gearstudio.theory.flank import Flank

Floats = NDArray[np.float64]

_STENCIL = np.linspace(-1.0, 1.0, 5)
_SHRINKING = 0.4
_ROUNDS = 14
_FIRST_CELLS = 4
_FARTHEST = 0.5
_EDGE_SLACK = 1e-3
_CORRECTIONS = 2
_BESIDE = 1e-6
_KEPT = 8


@dataclass(frozen=True)
class PinionGrid:
    """A grid on a pinion flank; one of its lines is where the wheel's tip begins to reach.

    Attributes
    ----------
    mesh : FlankMesh
    flank : Flank
        Of the pinion.
    u : ndarray, shape (n_u, n_v)
    v : ndarray, shape (n_v,)
    nodes : ndarray, shape (n_u, n_v, 3)
        Points of the grid [mm].
    contact_turn : ndarray, shape (n_u, n_v)
        phi_1 at which each point touches in the perfect pair [rad].
    series : FlankSeries or None
        The flank as polynomials.
    """

    mesh: FlankMesh
    flank: Flank
    u: Floats
    v: Floats
    nodes: Floats
    contact_turn: Floats
    series: FlankSeries | None

    def points(self, u: ArrayLike, v: ArrayLike) -> Floats:
        """Points of the flank, shape (..., 3) [mm]."""
        return self.flank.points(u, v)

    def points_near(self, u: Floats, v: Floats) -> Floats:
        """Points of the flank, by its series where it has one, shape (..., 3) [mm]."""
        return self.flank.points(u, v) if self.series is None else self.series.points(u, v)


def pinion_grid(mesh: FlankMesh, shape: tuple[int, int]) -> PinionGrid:
    """A grid of (along the profile, along the face) points on the pinion flank of a mesh."""
    n_u, n_v = shape
    if n_u < 3 or n_v < 3:
        raise GeometryError(f"a grid of {n_u} x {n_v} points is too coarse for a contact analysis; use 3 or more")
    return replace(_grid_in_place(replace(mesh, misalignment=Misalignment()), n_u, n_v), mesh=mesh)


@lru_cache(maxsize=_KEPT)
def _grid_in_place(mesh: FlankMesh, n_u: int, n_v: int) -> PinionGrid:
    """The grid of a mesh without misalignment, which none changes."""
    v = np.linspace(0.0, 1.0, n_v)
    start = mesh.start_of_contact(v)
    dead = int(np.ceil(start.max() * (n_u - 1) / 2))
    below = np.linspace(0.0, 1.0, dead, endpoint=False)[:, None] * start
    u = np.concatenate([below, start + np.linspace(0.0, 1.0, n_u - dead)[:, None] * (1 - start)])
    flank = mesh.pinion_flank
    psi, rho = flank.coordinates(u, v)
    nodes, turn = flank.at(psi, rho), mesh.contact_turn(psi, rho)
    for shared in (u, v, nodes, turn):
        shared.setflags(write=False)
    return PinionGrid(mesh, flank, u, v, nodes, turn, flank_series(flank))


def bounded_lag(mesh: FlankMesh, met: Meeting) -> Floats:
    """The lag, infinite where the wheel has no flank or the tooth is far on the other side."""
    near = np.abs(met.lag - mesh.play) < _FARTHEST * mesh.pair.wheel.pitch
    return np.where((mesh.least_margin(met) >= -_BESIDE) & near, met.lag, np.inf)


def closer(grid: PinionGrid, u: Floats, v: Floats, turn: Floats) -> tuple[Floats, Floats, Floats]:
    """Look closer around the best grid points: a 5 x 5 pattern along the lines of contact, and 5 along the face.

    All turns at once. Each direction shrinks once its best is not on the pattern's border. What lies beyond the
    wheel's tip or ends is moved onto them, so that contact on an edge is found as well.
    """
    mesh, each = grid.mesh, np.arange(len(turn))
    du, dv = float(np.diff(grid.u, axis=0).max()), float(grid.v[1] - grid.v[0])
    pattern_u, pattern_v = (part.ravel() for part in np.meshgrid(_STENCIL, _STENCIL, indexing="ij"))
    pattern_u, pattern_v = np.append(pattern_u, 0 * _STENCIL), np.append(pattern_v, _STENCIL)
    sheared = np.arange(len(pattern_u)) < len(_STENCIL) ** 2
    edges = _Edges.near(grid, u, v, turn, du, dv)
    step_u, step_v = np.full(len(turn), du), np.full(len(turn), _FIRST_CELLS * dv)
    lag = np.full(len(turn), np.inf)
    for _ in range(_ROUNDS):
        ahead = step_v[:, None] * pattern_v
        near_u = u[:, None] + step_u[:, None] * pattern_u + edges.line_slope * ahead * sheared
        near_v = v[:, None] + ahead
        inset = _EDGE_SLACK * edges.cell * step_u[:, None] / du
        near_u, near_v = edges.within(grid, *_clipped(near_u, near_v), turn[:, None], inset)
        found = bounded_lag(mesh, mesh.meet(grid.points_near(near_u, near_v), turn[:, None]))
        best = np.argmin(found, axis=1)
        better = found[each, best] < lag
        u, v = np.where(better, near_u[each, best], u), np.where(better, near_v[each, best], v)
        lag = np.where(better, found[each, best], lag)
        step_u *= np.where(better & (np.abs(pattern_u[best]) == 1), 1.0, _SHRINKING)
        step_v *= np.where(better & (np.abs(pattern_v[best]) == 1), 1.0, _SHRINKING)
    return u, v, lag


@dataclass(frozen=True)
class _Edges:
    """How fast the wheel's edges are reached from the best point of each turn, and du/dv along the line of contact.

    Arrays have shape (n, 1); ``cell`` is what a cell of the grid measures along the profile [mm].
    """

    tip_by_u: Floats
    tip_by_v: Floats
    end_by_v: Floats
    line_slope: Floats
    cell: float

    @classmethod
    def near(cls, grid: PinionGrid, u: Floats, v: Floats, turn: Floats, du: float, dv: float) -> _Edges:
        """By differences over a cell of the grid, taken inward."""
        step_u, step_v = np.where(u < 0.5, du, -du), np.where(v < 0.5, dv, -dv)
        places = np.stack([u, u + step_u, u]), np.stack([v, v, v + step_v])
        tip, _, toe, _ = grid.mesh.margins(grid.mesh.place(grid.points_near(*places), turn))
        by_u, by_v, end = (tip[1] - tip[0]) / step_u, (tip[2] - tip[0]) / step_v, (toe[2] - toe[0]) / step_v
        reached = grid.mesh.contact_turn(*grid.flank.coordinates(*places))
        slope = -(reached[2] - reached[0]) / step_v / ((reached[1] - reached[0]) / step_u)
        cell = float(np.abs(by_u).max(initial=0.0) * du)
        return cls(by_u[:, None], by_v[:, None], end[:, None], slope[:, None], cell)

    def within(self, grid: PinionGrid, u: Floats, v: Floats, turn: Floats, inset: Floats) -> tuple[Floats, Floats]:
        """Places beyond an edge moved inside by the inset: of the ends along the face, then of the tip."""
        for _ in range(_CORRECTIONS):
            tip, _, toe, heel = grid.mesh.margins(grid.mesh.place(grid.points_near(u, v), turn))
            if np.all(np.minimum(tip, np.minimum(toe, heel)) >= 0):
                break
            ahead = np.where(toe < 0, inset - toe, 0.0) - np.where(heel < 0, inset - heel, 0.0)
            ahead /= self.end_by_v
            tip += self.tip_by_v * ahead
            u, v = _clipped(u + np.where(tip < 0, inset - tip, 0.0) / self.tip_by_u, v + ahead)
        return u, v


def _clipped(u: Floats, v: Floats) -> tuple[Floats, Floats]:
    return np.clip(u, 0.0, 1.0), np.clip(v, 0.0, 1.0)
