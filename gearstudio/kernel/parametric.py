"""Surfaces of the kernel as functions of arrays of parameters: points and normals, many at once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Protocol

import numpy as np
from numpy.typing import NDArray
from OCP.Geom import (
    Geom_BSplineSurface,
    Geom_ConicalSurface,
    Geom_Curve,
    Geom_CylindricalSurface,
    Geom_ElementarySurface,
    Geom_Line,
    Geom_Plane,
    Geom_RectangularTrimmedSurface,
    Geom_SphericalSurface,
    Geom_Surface,
    Geom_SurfaceOfRevolution,
    Geom_ToroidalSurface,
    Geom_TrimmedCurve,
)
from OCP.gp import gp_Pnt, gp_Vec

from gearstudio.kernel.convert import to_record
from gearstudio.nurbs import NurbsSurface, basis_matrix

Floats = NDArray[np.float64]
Placed = tuple[Floats, Floats]

_ELEMENTARY_NODES, _STRAIGHT_NODES = 8, 4
_MORE_FOR_RATIONAL = 12
_EIGHTHS = np.linspace(-8 * np.pi, 8 * np.pi, 65)


class Parametric(Protocol):
    """A surface, and how to divide its parameters for Gauss' rule."""

    @property
    def breaks_u(self) -> Floats:
        """Parameters u between which it is analytic, or short enough; none where it is a polynomial."""
        ...

    @property
    def breaks_v(self) -> Floats:
        """The same of v."""
        ...

    @property
    def nodes(self) -> tuple[int, int]:
        """Gauss' nodes in each part of u and of v that integrate a product of three coordinates."""
        ...

    def at(self, u: Floats, v: Floats) -> Placed:
        """Points and their derivatives by u crossed with those by v, at u (n,) and v (n, k) or (k,): (n, k, 3) each."""
        ...


def parametric(surface: Geom_Surface) -> Parametric:
    """A kernel surface as a function of arrays."""
    while isinstance(surface, Geom_RectangularTrimmedSurface):
        surface = surface.BasisSurface()
    if isinstance(surface, Geom_BSplineSurface):
        return SplinePatch.of(to_record(_opened(surface)))
    for kind, meridian in _MERIDIANS.items():
        if isinstance(surface, kind):
            return Turned.of(surface, meridian(surface))
    return Flat.of(surface) if isinstance(surface, Geom_Plane) else Evaluated.of(surface)


def _opened(surface: Geom_BSplineSurface) -> Geom_BSplineSurface:
    """The same surface with clamped knots."""
    if not (surface.IsUPeriodic() or surface.IsVPeriodic()):
        return surface
    opened = surface.Copy()
    opened.SetUNotPeriodic()
    opened.SetVNotPeriodic()
    return opened


@dataclass(frozen=True)
class SplinePatch:
    """A B-spline surface."""

    record: NurbsSurface
    breaks_u: Floats
    breaks_v: Floats
    nodes: tuple[int, int]

    @staticmethod
    def of(record: NurbsSurface) -> SplinePatch:
        """Of a record."""
        more = _MORE_FOR_RATIONAL if record.weights is not None else 1
        nodes = (3 * record.degree_u // 2 + more, 3 * record.degree_v // 2 + more)
        return SplinePatch(record, np.unique(record.knots_u), np.unique(record.knots_v), nodes)

    def at(self, u: Floats, v: Floats) -> Placed:
        """See `Parametric.at`."""
        s = self.record
        weights = np.ones(s.poles.shape[:2]) if s.weights is None else s.weights
        poles = np.concatenate([s.poles * weights[..., None], weights[..., None]], axis=-1)
        along_u = [np.tensordot(_basis(u, s.knots_u, s.degree_u, n), poles, 1) for n in (0, 1)]
        along_v = [_basis(v.ravel(), s.knots_v, s.degree_v, n) for n in (0, 1)]
        if v.ndim == 1:
            found = [np.matmul(along_v[b], along_u[a]) for a, b in ((0, 0), (1, 0), (0, 1))]
        else:
            rows = [basis.reshape(*v.shape, -1) for basis in along_v]
            found = [np.matmul(rows[b], along_u[a]) for a, b in ((0, 0), (1, 0), (0, 1))]
        place, by_u, by_v = found
        points = place[..., :3] / place[..., 3:]
        if s.weights is None:
            return points, np.cross(by_u[..., :3], by_v[..., :3])
        by_u, by_v = ((by[..., :3] - points * by[..., 3:]) / place[..., 3:] for by in (by_u, by_v))
        return points, np.cross(by_u, by_v)


@dataclass(frozen=True)
class Flat:
    """A plane."""

    origin: Floats
    axes: Floats
    breaks_u: Floats
    breaks_v: Floats
    nodes: tuple[int, int] = (_STRAIGHT_NODES, _STRAIGHT_NODES)

    @staticmethod
    def of(surface: Geom_Plane) -> Flat:
        """Of a kernel plane."""
        origin, axes = _frame(surface)
        return Flat(origin, axes, np.empty(0), np.empty(0))

    def at(self, u: Floats, v: Floats) -> Placed:
        """See `Parametric.at`."""
        u = np.broadcast_to(u[:, None], (len(u), v.shape[-1]))
        points = self.origin + u[..., None] * self.axes[0] + np.broadcast_to(v, u.shape)[..., None] * self.axes[1]
        return points, np.broadcast_to(np.cross(self.axes[0], self.axes[1]), points.shape)


Meridian = Callable[[Floats], tuple[Floats, Floats, Floats, Floats]]
"""Radius and height at v, and the derivatives of both."""


@dataclass(frozen=True)
class Turned:
    """A surface of revolution about the third of its axes, u the azimuth."""

    origin: Floats
    axes: Floats
    meridian: Meridian
    breaks_u: Floats
    breaks_v: Floats
    nodes: tuple[int, int] = (_ELEMENTARY_NODES, _STRAIGHT_NODES)

    @staticmethod
    def of(surface: Geom_ElementarySurface, meridian: Meridian) -> Turned:
        """Of a kernel surface and its meridian."""
        origin, axes = _frame(surface)
        if isinstance(surface, Geom_SphericalSurface | Geom_ToroidalSurface):
            return Turned(origin, axes, meridian, _EIGHTHS, _EIGHTHS, (_ELEMENTARY_NODES, _ELEMENTARY_NODES))
        return Turned(origin, axes, meridian, _EIGHTHS, np.empty(0))

    def at(self, u: Floats, v: Floats) -> Placed:
        """See `Parametric.at`."""
        radius, height, radius_v, height_v = self.meridian(v)
        c, s = np.cos(u)[:, None, None], np.sin(u)[:, None, None]
        out, round_ = c * self.axes[0] + s * self.axes[1], c * self.axes[1] - s * self.axes[0]
        points = self.origin + radius[..., None] * out + height[..., None] * self.axes[2]
        by_v = radius_v[..., None] * out + height_v[..., None] * self.axes[2]
        return points, np.cross(radius[..., None] * round_, by_v)


def _cylinder(surface: Geom_CylindricalSurface) -> Meridian:
    radius = surface.Radius()
    return lambda v: (np.full_like(v, radius), v, np.zeros_like(v), np.ones_like(v))


def _cone(surface: Geom_ConicalSurface) -> Meridian:
    radius, sine, cosine = surface.RefRadius(), np.sin(surface.SemiAngle()), np.cos(surface.SemiAngle())
    return lambda v: (radius + v * sine, v * cosine, np.full_like(v, sine), np.full_like(v, cosine))


def _sphere(surface: Geom_SphericalSurface) -> Meridian:
    r = surface.Radius()
    return lambda v: (r * np.cos(v), r * np.sin(v), -r * np.sin(v), r * np.cos(v))


def _torus(surface: Geom_ToroidalSurface) -> Meridian:
    major, r = surface.MajorRadius(), surface.MinorRadius()
    return lambda v: (major + r * np.cos(v), r * np.sin(v), -r * np.sin(v), r * np.cos(v))


_MERIDIANS: dict[type, Callable[..., Meridian]] = {
    Geom_CylindricalSurface: _cylinder,
    Geom_ConicalSurface: _cone,
    Geom_SphericalSurface: _sphere,
    Geom_ToroidalSurface: _torus,
}


@dataclass(frozen=True)
class Evaluated:
    """A surface of any other kind, point by point; most often a turned line that a file has as such."""

    surface: Geom_Surface
    breaks_u: Floats
    breaks_v: Floats
    nodes: tuple[int, int] = (_ELEMENTARY_NODES, _ELEMENTARY_NODES)

    @staticmethod
    def of(surface: Geom_Surface) -> Evaluated:
        """Of a kernel surface."""
        straight = isinstance(surface, Geom_SurfaceOfRevolution) and _is_line(surface.BasisCurve())
        if straight:
            return Evaluated(surface, _EIGHTHS, np.empty(0), (_ELEMENTARY_NODES, _STRAIGHT_NODES))
        return Evaluated(surface, _EIGHTHS, _EIGHTHS)

    def at(self, u: Floats, v: Floats) -> Placed:
        """See `Parametric.at`."""
        v = np.broadcast_to(v, (len(u), v.shape[-1]))
        point, by_u, by_v = gp_Pnt(), gp_Vec(), gp_Vec()
        found = np.empty((*v.shape, 9))
        for i, (here, row) in enumerate(zip(u.tolist(), v.tolist(), strict=True)):
            for j, there in enumerate(row):
                self.surface.D1(here, there, point, by_u, by_v)
                found[i, j] = (*point.Coord(), *by_u.Coord(), *by_v.Coord())
        return found[..., :3], np.cross(found[..., 3:6], found[..., 6:])


def _is_line(curve: Geom_Curve) -> bool:
    while isinstance(curve, Geom_TrimmedCurve):
        curve = curve.BasisCurve()
    return isinstance(curve, Geom_Line)


def _frame(surface: Geom_ElementarySurface) -> tuple[Floats, Floats]:
    """Origin (3,) and axes (3, 3) of an elementary surface, a left-handed one's too."""
    place = surface.Position()
    at = place.Location()
    ways = (place.XDirection(), place.YDirection(), place.Direction())
    return np.array([at.X(), at.Y(), at.Z()]), np.array([(way.X(), way.Y(), way.Z()) for way in ways])


def _basis(parameters: Floats, knots: Floats, degree: int, derivative: int) -> Floats:
    return _kept(parameters.tobytes(), knots.tobytes(), degree, derivative)


@lru_cache(maxsize=64)
def _kept(parameters: bytes, knots: bytes, degree: int, derivative: int) -> Floats:
    """The basis of splines that all teeth share is made once."""
    return basis_matrix(np.frombuffer(parameters), np.frombuffer(knots), degree, derivative)
