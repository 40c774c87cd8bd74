"""Volume, area, centre of mass and inertia of a solid from its faces, by integrals along their edges.

The divergence theorem makes integrals over a solid of integrals over its faces. On a face, with g the integral of
the integrand by v from a fixed place, Green's theorem makes of those the sum of ``-g du`` along the edges as they lie
on the surface. Every integral is by Gauss' rule between the places where the integrand is less smooth; there is no
tolerance to set. The kernel's own integrals are 2e-6 off where the profile of a chamfered tooth bounds a narrow face.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache, lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Curve2d
from OCP.Geom2d import Geom2d_BSplineCurve, Geom2d_Curve, Geom2d_Line, Geom2d_TrimmedCurve
from OCP.gp import gp_Pnt2d, gp_Vec2d
from OCP.TopAbs import TopAbs_Orientation, TopAbs_ShapeEnum
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS, TopoDS_Edge, TopoDS_Face, TopoDS_Shape
from scipy.interpolate import BSpline

from gearstudio.kernel.convert import numbers
from gearstudio.kernel.parametric import Parametric, SplinePatch, parametric
from gearstudio.nurbs import basis_matrix

Floats = NDArray[np.float64]

Integrand = Callable[[Floats, Floats], Floats]

_AREA = 1
_NODES_ON_SPLINE = 10
_PARTS_OF_ANY = 16
_NEWTON_STEPS = 3
_SAME_PLACE = 1e-9
_STRAIGHT = 1e-12
_REVERSED, _FORWARD = TopAbs_Orientation.TopAbs_REVERSED, TopAbs_Orientation.TopAbs_FORWARD


@dataclass(frozen=True)
class Weight:
    """What a solid of unit density weighs.

    Attributes
    ----------
    volume : float
        [mm^3], positive when the faces look outward.
    area : float
        [mm^2]
    centre : ndarray, shape (3,)
        Centre of mass [mm].
    inertia : ndarray, shape (3, 3)
        About the centre of mass [mm^5].
    """

    volume: float
    area: float
    centre: Floats
    inertia: Floats


def weigh(shape: TopoDS_Shape) -> Weight:
    """Integrate over all faces of a shape."""
    totals = sum((_face_integrals(face, _integrand) for face in _faces(shape)), np.zeros(11))
    volume, area, first = float(totals[0]), float(totals[1]), totals[2:5]
    centre = first / volume if volume else np.zeros(3)
    xx, yy, zz, xy, yz, zx = totals[5:]
    second = np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]]) - volume * np.outer(centre, centre)
    return Weight(volume, area, centre, np.trace(second) * np.eye(3) - second)


def volume_of(shape: TopoDS_Shape) -> float:
    """The volume alone [mm^3], in half the time."""
    return float(sum(_face_integrals(face, _volume_alone)[0] for face in _faces(shape)))


def _faces(shape: TopoDS_Shape) -> Iterator[TopoDS_Face]:
    explorer = TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_FACE)
    while explorer.More():
        yield TopoDS.Face(explorer.Current())
        explorer.Next()


def _integrand(points: Floats, normals: Floats) -> Floats:
    """Volume, area, moments of first and second order per unit of the parameters, shape (..., 11)."""
    x, y, z = points[..., 0], points[..., 1], points[..., 2]
    n_x, n_y, n_z = normals[..., 0], normals[..., 1], normals[..., 2]
    x_n, y_n, z_n = x * n_x, y * n_y, z * n_z
    found = np.empty((*points.shape[:-1], 11))
    found[..., 0] = (x_n + y_n + z_n) / 3
    found[..., 1] = np.sqrt(n_x * n_x + n_y * n_y + n_z * n_z)
    for first, (a, next_a, a_n) in enumerate(((x, y, x_n), (y, z, y_n), (z, x, z_n))):
        found[..., 2 + first] = half = a * a_n / 2
        found[..., 5 + first] = a * half / 1.5
        found[..., 8 + first] = next_a * half
    return found


def _volume_alone(points: Floats, normals: Floats) -> Floats:
    return np.asarray(np.sum(points * normals, axis=-1, keepdims=True) / 3)


def _face_integrals(face: TopoDS_Face, integrand: Integrand) -> Floats:
    """The integrals over a face; the area counts, the others have the sign of the side that looks outward."""
    surface = parametric(BRep_Tool.Surface_s(face))
    upright = TopoDS.Face(face.Oriented(_FORWARD))
    pieces = [piece for edge in _edges(upright) for piece in _along(edge, upright, surface)]
    if not isinstance(surface, SplinePatch):
        pieces = [Piece(*(np.concatenate(parts) for parts in zip(*pieces, strict=True)))]
    start = _first_v(surface, pieces[0].places)
    total = -np.sum([piece.steps @ _across(surface, piece.places, start, integrand) for piece in pieces], axis=0)
    if face.Orientation() == _REVERSED:
        total[np.arange(len(total)) != _AREA] *= -1
    return np.asarray(total)


def _edges(face: TopoDS_Face) -> Iterator[TopoDS_Edge]:
    explorer = TopExp_Explorer(face, TopAbs_ShapeEnum.TopAbs_EDGE)
    while explorer.More():
        yield TopoDS.Edge(explorer.Current())
        explorer.Next()


def _first_v(surface: Parametric, places: Floats) -> float:
    return float(surface.breaks_v[0]) if isinstance(surface, SplinePatch) else float(places[0, 1])


class Piece(NamedTuple):
    """Gauss' nodes along an edge: where on the surface (u, v), shape (n, 2), and their weights times du, (n,)."""

    places: Floats
    steps: Floats


def _along(edge: TopoDS_Edge, face: TopoDS_Face, surface: Parametric) -> Iterator[Piece]:
    """An edge as it lies on a face, seen from its upper side."""
    sign = -1.0 if edge.Orientation() == _REVERSED else 1.0
    adaptor = BRepAdaptor_Curve2d(edge, face)
    first, last, curve = adaptor.FirstParameter(), adaptor.LastParameter(), adaptor.Curve()
    while isinstance(curve, Geom2d_TrimmedCurve):
        curve = curve.BasisCurve()
    if isinstance(curve, Geom2d_BSplineCurve) and not (curve.IsRational() or curve.IsPeriodic()):
        yield _on_spline(curve, first, last, sign, surface)
    elif isinstance(curve, Geom2d_Line):
        yield from _on_line(curve, first, last, sign, surface)
    else:
        yield _on_any(curve, first, last, sign)


def _on_spline(curve: Geom2d_BSplineCurve, first: float, last: float, sign: float, surface: Parametric) -> Piece:
    poles = np.array([pole.Coord() for pole in map(curve.Poles().Value, range(1, curve.NbPoles() + 1))])
    knots, degree = numbers(curve.KnotSequence()), curve.Degree()
    breaks = _between(first, last, np.unique(knots))
    if isinstance(surface, SplinePatch) and len(surface.breaks_u) > 2:
        breaks = _between(
            first, last, np.union1d(breaks, _crossings(BSpline(knots, poles[:, 0], degree), breaks, surface))
        )
    values, slopes, weights = _spline_rule(knots, degree, tuple(breaks.tolist()))
    return Piece(values @ poles, sign * weights * (slopes @ poles[:, 0]))


def _crossings(u: BSpline, breaks: Floats, surface: SplinePatch) -> Floats:
    """Where along an edge u grows or falls past the places at which the surface is less smooth."""
    t = np.unique(_gauss(breaks, _NODES_ON_SPLINE)[0])
    along = u(t)
    t, along = (t, along) if along[-1] >= along[0] else (t[::-1], along[::-1])
    wanted = surface.breaks_u[(surface.breaks_u > along[0]) & (surface.breaks_u < along[-1])]
    found = np.interp(wanted, along, t)
    for _ in range(_NEWTON_STEPS):
        found = found - (u(found) - wanted) / u(found, nu=1)
    known = np.abs(found[:, None] - breaks).min(axis=1, initial=np.inf) <= _SAME_PLACE * (breaks[-1] - breaks[0])
    return np.asarray(found[~known])


@lru_cache(maxsize=64)
def _spline_rule(knots: tuple[float, ...], degree: int, breaks: tuple[float, ...]) -> tuple[Floats, Floats, Floats]:
    """Basis and its derivatives at Gauss' nodes, and their weights: the same for every tooth."""
    t, weights = _gauss(np.array(breaks), _NODES_ON_SPLINE)
    values, slopes = (basis_matrix(t, np.array(knots), degree, n) for n in (0, 1))
    return values, slopes, weights


def _on_line(curve: Geom2d_Line, first: float, last: float, sign: float, surface: Parametric) -> Iterator[Piece]:
    """Along u it is divided where the surface is; along v it adds nothing."""
    start, way = curve.Location(), curve.Direction()
    if abs(way.X()) <= _STRAIGHT:
        return
    t, weights = _gauss(_between(first, last, np.sort((surface.breaks_u - start.X()) / way.X())), surface.nodes[0])
    yield Piece(np.stack([start.X() + t * way.X(), start.Y() + t * way.Y()], axis=-1), sign * weights * way.X())


def _on_any(curve: Geom2d_Curve, first: float, last: float, sign: float) -> Piece:
    breaks = np.linspace(first, last, _PARTS_OF_ANY + 1)
    if isinstance(curve, Geom2d_BSplineCurve):
        breaks = np.union1d(breaks, numbers(curve.Knots()))
    t, weights = _gauss(_between(first, last, breaks), _NODES_ON_SPLINE)
    point, way = gp_Pnt2d(), gp_Vec2d()
    places, slopes = np.empty((len(t), 2)), np.empty(len(t))
    for i, place in enumerate(t.tolist()):
        curve.D1(place, point, way)
        places[i], slopes[i] = (point.X(), point.Y()), way.X()
    return Piece(places, sign * weights * slopes)


def _between(first: float, last: float, breaks: Floats) -> Floats:
    """Both ends and the breaks between them."""
    return np.asarray(np.r_[first, breaks[(breaks > first) & (breaks < last)], last])


def _across(surface: Parametric, places: Floats, start: float, integrand: Integrand) -> Floats:
    """The integrals by v from a start to each place, shape (n, number of integrals)."""
    u, v = places.T
    if np.ptp(v) == 0:
        nodes, weights = _gauss(_from(start, float(v[0]), surface.breaks_v), surface.nodes[1])
        return np.asarray(np.einsum("k,nkj->nj", weights, integrand(*surface.at(u, nodes))))
    breaks = surface.breaks_v[(surface.breaks_v > min(start, v.min())) & (surface.breaks_v < max(start, v.max()))]
    low, high = np.minimum(start, v)[:, None], np.maximum(start, v)[:, None]
    bounds = np.hstack([low, np.clip(np.broadcast_to(breaks, (len(v), len(breaks))), low, high), high])
    x, w = _rule(surface.nodes[1])
    size = np.diff(bounds)[..., None]
    nodes = (bounds[:, :-1, None] + size * x).reshape(len(v), -1)
    weights = np.where(v >= start, 1.0, -1.0)[:, None] * (size * w).reshape(len(v), -1)
    return np.asarray(np.einsum("nk,nkj->nj", weights, integrand(*surface.at(u, nodes))))


def _from(start: float, end: float, breaks: Floats) -> Floats:
    """From start to end with the breaks between, in the order of the way."""
    bounds = _between(min(start, end), max(start, end), breaks)
    return bounds if end >= start else bounds[::-1]


def _gauss(bounds: Floats, count: int) -> tuple[Floats, Floats]:
    """Nodes and weights of Gauss' rule in every part, shape (n,) each; of either sense."""
    x, w = _rule(count)
    size = np.diff(bounds)[:, None]
    return np.asarray((bounds[:-1, None] + size * x).ravel()), np.asarray((size * w).ravel())


@cache
def _rule(count: int) -> tuple[Floats, Floats]:
    x, w = np.polynomial.legendre.leggauss(count)
    return (x + 1) / 2, w / 2
