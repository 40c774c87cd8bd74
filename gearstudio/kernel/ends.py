"""The edges of one pitch at toe and heel: the ends of its faces, and where chamfers cut them off."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from OCP.Geom import Geom_Curve, Geom_Surface
from OCP.Geom2d import Geom2d_BSplineCurve, Geom2d_Curve, Geom2d_Line
from OCP.gp import gp_Dir2d, gp_Pnt2d
from scipy.interpolate import BSpline, make_interp_spline

from gearstudio.errors import GeometryError
from gearstudio.kernel.convert import knots_and_multiplicities, point_row_2d, to_curve
from gearstudio.kernel.revolved import Revolved, circle
from gearstudio.nurbs import NurbsSurface
from gearstudio.theory.chamfer import EndChamfer, EndCut, end_cut

Floats = NDArray[np.float64]
Along = Callable[[Floats], Floats]
"""Points (n, 3) at parameters (n,) of an edge."""

_DEGREE = 5
_NODES_A_SPAN = (3, 6, 12, 24)
_LOOKS_A_SPAN = 31
_SEAM_NODES = 6
_SHARE = 1e-8
_CUT_SHARE = 3e-8
_SAME_KNOT = 1e-9


@dataclass(frozen=True)
class EndPiece:
    """An edge across a face at one end, with growing azimuth over ``span``; ``cut`` when a chamfer made it.

    ``trace`` is its curve on the face, ``gap`` how far that runs from it [mm], ``knots`` where it is less smooth.
    """

    face: int
    span: tuple[float, float]
    curve: Geom_Curve
    trace: Geom2d_Curve
    points: Along
    knots: Floats
    gap: float
    cut: bool

    def on(self, revolved: Revolved, anchor: Floats) -> tuple[Geom2d_Curve, float]:
        """As `trace_on`."""
        return trace_on(revolved, anchor, self.points, self.knots, self.span)


@dataclass(frozen=True)
class Arc:
    """The lower side of a chamfer: part of a circle about the axis."""

    curve: Geom_Curve
    span: tuple[float, float]
    points: Along

    def on(self, revolved: Revolved, anchor: Floats) -> tuple[Geom2d_Curve, float]:
        """As `trace_on`."""
        return trace_on(revolved, anchor, self.points, np.array(self.span), self.span)


@dataclass(frozen=True)
class ChamferPitch:
    """A chamfer over one pitch: its cone, its lower side, and the traces of its edges on the cone, the arc's last.

    ``cuts`` are the numbers of the pieces along its upper side; ``gap`` is how far the arc's ends lie from
    theirs [mm].
    """

    surface: Geom_Surface
    outward: bool
    cuts: tuple[int, ...]
    traces: tuple[tuple[Geom2d_Curve, float], ...]
    arc: Arc
    gap: float


def end_pieces(records: Sequence[NurbsSurface], curves: Sequence[Geom_Curve], end: int) -> tuple[EndPiece, ...]:
    """The edges of faces that nothing cuts off."""
    return tuple(
        _whole(record, curve, j, end, (0.0, 1.0)) for j, (record, curve) in enumerate(zip(records, curves, strict=True))
    )


def cut_pieces(
    records: Sequence[NurbsSurface], curves: Sequence[Geom_Curve], chamfer: EndChamfer
) -> tuple[tuple[EndPiece, ...], tuple[EndCut | None, ...]]:
    """The edges of faces whose end a chamfer cuts off, and the cuts by face."""
    cuts = tuple(end_cut(record, chamfer) for record in records)
    pieces: list[EndPiece] = []
    for j, (record, curve, cut) in enumerate(zip(records, curves, cuts, strict=True)):
        if cut is None:
            pieces.append(_whole(record, curve, j, chamfer.end, (0.0, 1.0)))
            continue
        made = [_cut(record, j, cut)]
        if cut.first > 0:
            made.insert(0, _whole(record, curve, j, chamfer.end, (0.0, cut.first)))
        if cut.last < 1:
            made.append(_whole(record, curve, j, chamfer.end, (cut.last, 1.0)))
        pieces += made
    return tuple(pieces), cuts


def _whole(record: NurbsSurface, curve: Geom_Curve, face: int, end: int, span: tuple[float, float]) -> EndPiece:
    spline = BSpline(record.knots_u, record.poles[:, -end], record.degree_u)
    trace = Geom2d_Line(gp_Pnt2d(0.0, float(end)), gp_Dir2d(1.0, 0.0))
    return EndPiece(face, span, curve, trace, spline, np.unique(record.knots_u), 0.0, False)


def _cut(record: NurbsSurface, face: int, cut: EndCut) -> EndPiece:
    knots = _within((cut.first, cut.last), record.knots_u)

    def on_face(u: Floats) -> Floats:
        return record.points(u, cut.v(u))

    scale = float(np.abs(record.poles).max())
    spline, gap = fitted_curve(on_face, knots, _CUT_SHARE * scale)
    curve = to_curve(spline.c, spline.t, spline.k)
    flat, _ = fitted_curve(lambda u: np.stack([u, cut.v(u)], axis=-1), knots, _CUT_SHARE)
    between = between_nodes(knots)
    off = float(np.linalg.norm(record.points(*flat(between).T) - spline(between), axis=-1).max())
    span = (cut.first, cut.last)
    return EndPiece(face, span, curve, flat_curve(flat), spline, np.unique(spline.t), max(gap, off), True)


def chamfer_pitch(pieces: Sequence[EndPiece], chamfer: EndChamfer) -> ChamferPitch:
    """Lay a chamfer's cone under the edges that it made.

    Raises
    ------
    GeometryError
        It does not cut off the tip of a tooth and nothing else.
    """
    cuts = tuple(k for k, piece in enumerate(pieces) if piece.cut)
    if not cuts or cuts != tuple(range(cuts[0], cuts[-1] + 1)) or cuts[0] == 0 or cuts[-1] + 1 == len(pieces):
        raise GeometryError("a chamfer at the end of the teeth does not cut off their tips alone")
    corners = np.array([pieces[k].points(np.array([pieces[k].span[i]]))[0] for k, i in ((cuts[0], 0), (cuts[-1], 1))])
    azimuths = np.unwrap(np.arctan2(corners[:, 1], corners[:, 0]))
    seam = float(azimuths.mean()) + np.pi
    way = (chamfer.face, chamfer.foot) if chamfer.heel else (chamfer.foot, chamfer.face)
    revolved = Revolved(*way, seam)
    radius, height = chamfer.foot
    span = (float(azimuths[0] - seam + 2 * np.pi), float(azimuths[1] - seam + 2 * np.pi))

    def arc_points(t: Floats) -> Floats:
        return np.stack([radius * np.cos(seam + t), radius * np.sin(seam + t), np.full_like(t, height)], axis=-1)

    arc = Arc(circle(radius, height, seam), span, arc_points)
    gap = float(np.linalg.norm(arc_points(np.array(span)) - corners, axis=-1).max())
    traces = [pieces[k].on(revolved, corners[0]) for k in cuts]
    traces.append(arc.on(revolved, corners[0]))
    return ChamferPitch(revolved.geometry(), revolved.outward, cuts, tuple(traces), arc, gap)


def trace_on(
    revolved: Revolved, anchor: Floats, points: Along, knots: Floats, span: tuple[float, float]
) -> tuple[Geom2d_Curve, float]:
    """Curve of an edge on a turned surface, and how far from the edge it runs [mm].

    ``anchor`` is a point near the edge, within half a turn of the seam's azimuth; ``knots`` tell where the
    edge is less smooth.
    """

    def on_surface(places: Floats) -> Floats:
        return revolved.parameters(np.vstack([anchor, places]))[1:]

    spans = _within(span, knots)
    for nodes_a_span in _nodes_a_span(spans):
        nodes = nodes_of(spans, nodes_a_span)
        spline = make_interp_spline(nodes, on_surface(points(nodes)), k=_DEGREE)
        fine = np.linspace(*span, 6 * len(nodes) + 1)
        edge = points(fine)
        off = np.hypot(*((spline(fine) - on_surface(edge)) * revolved.scale(edge)).T)
        if float(off.max()) <= _SHARE * np.abs(edge).max():
            break
    return flat_curve(spline), float(np.max(revolved.distance(edge) + off))


def _within(span: tuple[float, float], knots: Floats) -> Floats:
    """Both ends of a span and the distinct knots between."""
    places = np.sort(knots)
    inside = places[np.diff(places, prepend=-np.inf) > _SAME_KNOT]
    slack = _SAME_KNOT * (1 + span[1] - span[0])
    return np.asarray(np.r_[span[0], inside[(inside > span[0] + slack) & (inside < span[1] - slack)], span[1]])


def _nodes_a_span(knots: Floats) -> tuple[int, ...]:
    """Counts to try, from the fewest that determine a spline; the kernel's check of a face takes longer for more."""
    fewest = max(2, -(-(_DEGREE + 1) // (len(knots) - 1)))
    return fewest, *(n for n in _NODES_A_SPAN if n > fewest)


def fitted_curve(values: Along, knots: Floats, goal: float) -> tuple[BSpline, float]:
    """A spline through values over spans, with as many nodes as a goal asks for, and how far it is off between."""
    for nodes_a_span in _nodes_a_span(knots):
        nodes = nodes_of(knots, nodes_a_span)
        spline = make_interp_spline(nodes, values(nodes), k=_DEGREE)
        places = between_nodes(knots)
        gap = float(np.linalg.norm(spline(places) - values(places), axis=-1).max())
        if gap <= goal:
            break
    return spline, gap


def flat_curve(spline: BSpline) -> Geom2d_Curve:
    """A spline of points (u, v) as the kernel's."""
    return Geom2d_BSplineCurve(point_row_2d(spline.c), *knots_and_multiplicities(spline.t), spline.k)


def nodes_of(knots: Floats, nodes_a_span: int = _SEAM_NODES) -> Floats:
    """Several places in every span of distinct knots."""
    inner = np.linspace(0.0, 1.0, nodes_a_span, endpoint=False)
    return np.append((knots[:-1, None] + np.diff(knots)[:, None] * inner).ravel(), knots[-1])


def between_nodes(knots: Floats) -> Floats:
    """Places where a fit over spans is looked at."""
    return nodes_of(knots, _LOOKS_A_SPAN)
