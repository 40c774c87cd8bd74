"""A flank as a method made it, cut off where it meets foot cone, tip cone, and the ends of the tooth."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.polynomial.chebyshev import chebfit, chebval
from numpy.typing import NDArray

from gearstudio.errors import GeometryError
from gearstudio.methods.space import Space, fitted, space_u, space_v
from gearstudio.nurbs import NurbsSurface
from gearstudio.theory.flank import Flank
from gearstudio.theory.involute_flank import InvoluteFlank
from gearstudio.theory.vectors import matched

Floats = NDArray[np.float64]

_SAMPLES = 33
_ROUNDS = 12
_STEP = 1e-6
_SETTLED = 1e-12
_FARTHEST = 0.25
_SAME_WEIGHT = 1e-9
_CLEAR_OF_THE_CUSP = 5.0
_FIT_SHARE = 1e-3


def trimmed(flank: Flank, surface: NurbsSurface, goal: float) -> NurbsSurface:
    """The surface, shortened or continued so that its four edges lie on the limits of the flank.

    A surface whose edges lie there within the goal [mm] stays as it is. One that starts on the base cone, where
    the flank has a cusp, or so near that its deviation reaches it, keeps its foot: the fillet follows it.

    Raises
    ------
    GeometryError
        It would have to be continued too far, or the cut surface could not be fitted.
    """
    weights = surface.weights
    if weights is not None and np.ptp(weights) <= _SAME_WEIGHT * weights.max():
        surface = replace(surface, weights=None)
    cut = _Cut(flank, surface, moves_foot=not flank.starts_on_base)
    if cut.foot_clearance() < _CLEAR_OF_THE_CUSP * cut.foot_miss():
        cut = replace(cut, moves_foot=False)
    miss = cut.miss()
    if surface.weights is None and miss <= goal:
        return surface
    borders = cut.borders()
    along_u, along_v = space_u(surface), space_v(surface)
    x = _mapped(along_u, np.linspace(0.0, 1.0, _SAMPLES), borders.at(_GRID, 0.5)[0])
    y = _mapped(along_v, np.linspace(0.0, 1.0, _SAMPLES), borders.at(0.5, _GRID)[1])

    def points(x: Floats, y: Floats) -> Floats:
        return surface.points(*borders.at(x[:, None], y[None, :]))

    what = f"{flank.member.name} {flank.name} flank, cut off at its limits,"
    return fitted(what, x, y, points, max(goal, _FIT_SHARE * miss))


_GRID = np.linspace(0.0, 1.0, _SAMPLES)


def _mapped(space: Space, new: Floats, old: Floats) -> Space:
    """The space with its inner knots moved to where a monotonic map from new to old parameters takes them."""
    inner = (space.knots > 0) & (space.knots < 1)
    moved = np.interp(space.knots[inner], old, new)
    degree = space.degree
    keep = (moved > 1e-3) & (moved < 1 - 1e-3)
    return Space(degree, np.r_[[0.0] * (degree + 1), np.sort(moved[keep]), [1.0] * (degree + 1)])


@dataclass(frozen=True)
class _Borders:
    """Parameters (u, v) on the surface of the four edges of the cut: polynomials of the place on the edge."""

    corners: Floats
    foot: Floats
    tip: Floats
    toe: Floats
    heel: Floats

    def at(self, x: Floats | float, y: Floats | float) -> tuple[Floats, Floats]:
        """Parameters at places x from foot to tip and y from toe to heel, by Coons' blending of the edges."""
        x, y = matched(x, y)

        def edge(coefficients: Floats, t: Floats) -> Floats:
            return np.moveaxis(np.asarray(chebval(2 * t - 1, coefficients), np.float64), 0, -1)

        X, Y = x[..., None], y[..., None]
        ruled = (1 - X) * edge(self.foot, y) + X * edge(self.tip, y) + (1 - Y) * edge(self.toe, x)
        ruled = ruled + Y * edge(self.heel, x)
        c = self.corners
        bilinear = (1 - X) * ((1 - Y) * c[0, 0] + Y * c[0, 1]) + X * ((1 - Y) * c[1, 0] + Y * c[1, 1])
        return ruled[..., 0] - bilinear[..., 0], ruled[..., 1] - bilinear[..., 1]


@dataclass(frozen=True)
class _Cut:
    flank: Flank
    surface: NurbsSurface
    moves_foot: bool

    def place(self, u: Floats, v: Floats) -> tuple[Floats, Floats]:
        """Shares of the way from foot to tip, by polar angle, and from toe to heel, at which points lie."""
        rho, delta, _ = self.flank.locate(self.surface.points(u, v))
        m = self.flank.member
        along = m.face_share(m.end_distance(rho, delta))
        low, high = self.flank.limits(along)
        return (delta - low) / (high - low), along

    def miss(self) -> float:
        """Farthest that the edges lie from where they belong [mm]."""
        zero, one = np.zeros(_SAMPLES), np.ones(_SAMPLES)
        ends = max(np.abs(self.place(_GRID, end)[1] - end).max() for end in (zero, one)) * self.flank.member.face_width
        tip = np.abs(self.place(one, _GRID)[0] - 1).max() * self._height()
        return float(max(ends, tip, self.foot_miss() if self.moves_foot else 0.0))

    def foot_miss(self) -> float:
        """Farthest that the lower edge lies from the foot of the flank [mm]."""
        return float(np.abs(self.place(np.zeros(_SAMPLES), _GRID)[0]).max()) * self._height()

    def foot_clearance(self) -> float:
        """Least height of the foot of the flank above the base cone [mm]; a conjugate flank has no cusp there."""
        m = self.flank.member
        if not isinstance(self.flank, InvoluteFlank):
            return np.inf
        return float(np.min(self.flank.limits(_GRID)[0] - m.base_angle)) * m.inner_cone_distance

    def _height(self) -> float:
        low, high = self.flank.limits(1.0)
        return float(high - low) * self.flank.member.outer_cone_distance

    def borders(self) -> _Borders:
        """Solve for the four edges; foot and tip run evenly between the corners in v, toe and heel in u."""
        corners = np.array([[self._solve(x, y, x, y) for y in (0.0, 1.0)] for x in (0.0, 1.0)])[..., 0, :]
        t = (1 - np.cos(np.pi * (np.arange(_SAMPLES) + 0.5) / _SAMPLES)) / 2

        def between(a: Floats, b: Floats) -> Floats:
            return a + t[:, None] * (b - a)

        edges = []
        for x in (0.0, 1.0):
            start = between(corners[int(x), 0], corners[int(x), 1])
            edges.append(self._solve(x, None, start[:, 0], start[:, 1]))
        for y in (0.0, 1.0):
            start = between(corners[0, int(y)], corners[1, int(y)])
            edges.append(self._solve(None, y, start[:, 0], start[:, 1]))
        foot, tip, toe, heel = (np.asarray(chebfit(2 * t - 1, edge, _SAMPLES - 1), np.float64) for edge in edges)
        return _Borders(corners, foot, tip, toe, heel)

    def _solve(self, x: float | None, y: float | None, u: Floats | float, v: Floats | float) -> Floats:
        """Parameters, shape (n, 2), at which the points lie at x, at y, or (in corners) both.

        Raises
        ------
        GeometryError
            They lie too far outside the surface.
        """
        u, v = np.atleast_1d(np.asarray(u, dtype=np.float64)), np.atleast_1d(np.asarray(v, dtype=np.float64))
        fixed = x == 0.0 and not self.moves_foot
        for _ in range(_ROUNDS):
            here = self.place(u, v)
            by_u, by_v = self._slopes(u, v)
            f = [here[0] - x if x is not None and not fixed else 0 * u, here[1] - y if y is not None else 0 * v]
            if x is None or fixed:
                du, dv = 0 * u, f[1] / by_v[1]
            elif y is None:
                du, dv = f[0] / by_u[0], 0 * v
            else:
                det = by_u[0] * by_v[1] - by_v[0] * by_u[1]
                du, dv = (by_v[1] * f[0] - by_v[0] * f[1]) / det, (by_u[0] * f[1] - by_u[1] * f[0]) / det
            u, v = u - np.clip(du, -0.2, 0.2), v - np.clip(dv, -0.2, 0.2)
            if max(np.max(np.abs(du)), np.max(np.abs(dv))) <= _SETTLED:
                break
        self._check(u, v, np.max(np.abs(f)))
        return np.stack([u, v], axis=-1)

    def _slopes(self, u: Floats, v: Floats) -> tuple[list[Floats], list[Floats]]:
        ahead_u, behind_u = self.place(u + _STEP, v), self.place(u - _STEP, v)
        ahead_v, behind_v = self.place(u, v + _STEP), self.place(u, v - _STEP)
        by_u = [(a - b) / (2 * _STEP) for a, b in zip(ahead_u, behind_u, strict=True)]
        by_v = [(a - b) / (2 * _STEP) for a, b in zip(ahead_v, behind_v, strict=True)]
        return by_u, by_v

    def _check(self, u: Floats, v: Floats, residual: float) -> None:
        outside = max(float(np.max(-w)) for w in (u, v, 1 - u, 1 - v))
        if not (outside <= _FARTHEST and residual < 1e-6):
            name = f"{self.flank.member.name} {self.flank.name} flank"
            raise GeometryError(
                f"the {name} misses its limits by {self.miss():.3g} mm and cannot be continued that far; "
                "the variant is too inaccurate for this design to make a tooth of"
            )
