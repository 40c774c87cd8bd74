"""Chamfers at the ends of the teeth: a cone turned over all of them in place of the edge between tip and end.

A face of a tooth keeps its surface and ends on the cone instead; where, is a curve v(u) over its parameters.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.errors import GeometryError
from gearstudio.nurbs import NurbsSurface, basis_matrix
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.limit import ConeLimit

if TYPE_CHECKING:
    from scipy.interpolate import BSpline

Floats = NDArray[np.float64]
Point = tuple[float, float]

_LARGEST_SHARE = 0.8
_SMALLEST_SHARE = 2e-3
_DEGREE = 5
_NODES = (9, 17, 33, 65, 129)
_SHARE = 3e-8
_PROBE = 65
_ROUNDS = 8
_SLIVER = 1e-9


@dataclass(frozen=True)
class EndChamfer:
    """The chamfer of all teeth at one end, as an element of its cone.

    Attributes
    ----------
    heel : bool
        At the heel, or else at the toe.
    face, foot : (float, float)
        Where it meets the face cone and the end surface, (radius, height) [mm].
    normal : (float, float)
        Unit vector out of the metal.
    """

    heel: bool
    face: Point
    foot: Point
    normal: Point

    @property
    def end(self) -> int:
        """1 at the heel, 0 at the toe."""
        return int(self.heel)

    @property
    def title(self) -> str:
        """What its face on a tooth is called."""
        return "heel chamfer" if self.heel else "toe chamfer"

    def beyond(self, points: Floats) -> Floats:
        """How far points (..., 3) lie outside the cone, square to its element [mm], shape (...)."""
        radius = np.hypot(points[..., 0], points[..., 1])
        return np.asarray((radius - self.face[0]) * self.normal[0] + (points[..., 2] - self.face[1]) * self.normal[1])


def end_point(member: MemberGeometry, limit: ConeLimit, v: float) -> Floats:
    """(radius, height) where a cone meets an end of the teeth, v = 0 at the toe, 1 at the heel [mm]."""
    rho_u = member.along_face(v)
    delta = member.limit_angle(limit, rho_u)
    rho = member.cone_distance(rho_u, delta)
    return np.array([float(rho * np.sin(delta)), float(rho * np.cos(delta))])


def end_chamfers(member: MemberGeometry, length: float) -> tuple[EndChamfer, ...]:
    """The chamfers at toe and heel whose legs along face cone and end surface have a length [mm]; none for 0."""
    return () if length == 0 else tuple(_chamfer(member, heel, length) for heel in (False, True))


def chamfer_limits(member: MemberGeometry) -> tuple[float, float]:
    """Smallest and largest length that can be made [mm]: over the roots, and with some tip left between both ends."""
    tips, roots = (_ends(member, limit) for limit in (member.tip_limit, member.root_limit))
    depths = np.linalg.norm(tips - roots, axis=-1)
    largest = _LARGEST_SHARE * min(float(depths.min()), float(np.linalg.norm(tips[1] - tips[0])) / 2)
    return _SMALLEST_SHARE * largest, largest


def _ends(member: MemberGeometry, limit: ConeLimit) -> Floats:
    return np.array([end_point(member, limit, v) for v in (0.0, 1.0)])


def _chamfer(member: MemberGeometry, heel: bool, length: float) -> EndChamfer:
    tips, root = _ends(member, member.tip_limit), end_point(member, member.root_limit, float(heel))
    corner, other = tips[int(heel)], tips[1 - int(heel)]
    face = corner + length * (other - corner) / np.linalg.norm(other - corner)
    if member.ends == "sphere":
        rho = float(np.hypot(*corner))
        delta = float(np.arctan2(*corner)) - length / rho
        foot = rho * np.array([np.sin(delta), np.cos(delta)])
    else:
        foot = corner + length * (root - corner) / np.linalg.norm(root - corner)
    along = (foot - face) / np.linalg.norm(foot - face)
    normal = np.array([along[1], -along[0]])
    normal = normal if normal @ (corner - face) > 0 else -normal
    return EndChamfer(heel, _point(face), _point(foot), _point(normal))


def _point(values: Floats) -> Point:
    return float(values[0]), float(values[1])


@dataclass(frozen=True)
class EndCut:
    """Where a chamfer cuts a face off: v over u from ``first`` to ``last``; elsewhere the face keeps its end."""

    heel: bool
    first: float
    last: float
    spline: BSpline

    def v(self, u: ArrayLike) -> Floats:
        """Where the face ends at u, shape as u."""
        u = np.asarray(u, dtype=np.float64)
        inside = (u >= self.first) & (u <= self.last)
        cut = np.clip(self.spline(np.clip(u, self.first, self.last)), 0.0, 1.0)
        return np.asarray(np.where(inside, cut, float(self.heel)))


def end_cut(surface: NurbsSurface, chamfer: EndChamfer) -> EndCut | None:
    """Where a chamfer cuts a face of a tooth, over [0, 1]² with v from toe to heel; None when it does not.

    Raises
    ------
    GeometryError
        It does not cut straight across the face.
    """
    from scipy.interpolate import make_interp_spline
    from scipy.optimize import brentq

    end = float(chamfer.heel)

    def at_end(u: float) -> float:
        return float(chamfer.beyond(surface.points(u, end)))

    probe = np.linspace(0.0, 1.0, _PROBE)
    outside = chamfer.beyond(surface.grid(probe, [end])[:, 0]) > 0
    if not outside.any():
        return None
    changes = np.flatnonzero(np.diff(outside))
    if len(changes) > 1:
        raise GeometryError("a chamfer at the end of the teeth cuts a face more than once")
    first, last = 0.0, 1.0
    for k in changes:
        root = float(brentq(at_end, probe[k], probe[k + 1], xtol=1e-15))
        first, last = (root, 1.0) if outside[-1] else (0.0, root)
    if last - first < _SLIVER:
        return None
    first, last = (first if first > _SLIVER else 0.0), (last if last < 1 - _SLIVER else 1.0)
    scale = float(np.abs(surface.poles).max())
    for count in _NODES:
        u = first + (last - first) * (1 - np.cos(np.pi * np.arange(count) / (count - 1))) / 2
        cut = EndCut(chamfer.heel, first, last, make_interp_spline(u, _solved(surface, chamfer, u), k=_DEGREE))
        fine = np.linspace(first, last, 4 * count)
        if np.abs(chamfer.beyond(surface.points(fine, cut.v(fine)))).max() <= _SHARE * scale:
            return cut
    raise GeometryError("the edge of a chamfer at the end of the teeth could not be followed")


def _solved(surface: NurbsSurface, chamfer: EndChamfer, u: Floats) -> Floats:
    """v on the cone at each u, by Newton from the nearest change of sign."""
    places = np.linspace(0.0, 1.0, _PROBE)
    beyond = chamfer.beyond(surface.grid(u, places))
    beyond = beyond if chamfer.heel else beyond[:, ::-1]
    last_inside = np.argmax(np.cumsum(beyond <= 0, axis=1), axis=1)
    v = places[last_inside] if chamfer.heel else 1 - places[last_inside]
    for _ in range(_ROUNDS):
        points, along = _with_slope(surface, u, v)
        radius = np.hypot(points[:, 0], points[:, 1])
        rise = (points[:, 0] * along[:, 0] + points[:, 1] * along[:, 1]) / radius
        v = v - chamfer.beyond(points) / (rise * chamfer.normal[0] + along[:, 2] * chamfer.normal[1])
    return np.asarray(np.clip(v, 0.0, 1.0))


def _with_slope(surface: NurbsSurface, u: Floats, v: Floats) -> tuple[Floats, Floats]:
    rows = np.einsum("ai,ijk->ajk", basis_matrix(u, surface.knots_u, surface.degree_u), surface.poles)
    bases = (basis_matrix(v, surface.knots_v, surface.degree_v, order) for order in (0, 1))
    points, along = (np.einsum("ajk,aj->ak", rows, basis) for basis in bases)
    return np.asarray(points), np.asarray(along)
