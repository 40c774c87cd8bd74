"""The faces, edges and vertices of one pitch, made once and turned for every tooth."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from OCP.Geom import Geom_Curve, Geom_Surface
from OCP.Geom2d import Geom2d_BSplineCurve, Geom2d_Curve, Geom2d_Line
from OCP.gp import gp_Ax1, gp_Dir, gp_Dir2d, gp_Pnt, gp_Pnt2d, gp_Trsf
from OCP.TopoDS import TopoDS_Edge, TopoDS_Face, TopoDS_Vertex
from scipy.interpolate import make_interp_spline

from gearstudio.kernel.convert import knots_and_multiplicities, point_row_2d, to_curve, to_surface
from gearstudio.kernel.maker import Maker, Point
from gearstudio.kernel.revolved import TURN, Revolved
from gearstudio.nurbs import NurbsSurface, basis_matrix

Floats = NDArray[np.float64]

_TRACE_DEGREE = 5
_TRACE_NODES_A_SPAN = (6, 12, 24)
_TRACE_SHARE = 1e-8


@dataclass(frozen=True)
class Pitch:
    """The geometry of one tooth, to be turned for the others; index 0 is the toe, 1 the heel."""

    records: tuple[NurbsSurface, ...]
    surfaces: tuple[Geom_Surface, ...]
    seams: tuple[Geom_Curve, ...]
    seam_gaps: tuple[float, ...]
    ends: tuple[tuple[Geom_Curve, ...], tuple[Geom_Curve, ...]]

    @staticmethod
    def of(records: Sequence[NurbsSurface], step: float) -> Pitch:
        """Of faces as for `assembled`, at an angular step between teeth [rad]."""
        seams = [to_curve(r.poles[0], r.knots_v, r.degree_v) for r in records]
        ends = [[to_curve(r.poles[:, j], r.knots_u, r.degree_u) for r in records] for j in (0, -1)]
        return Pitch(
            tuple(records),
            tuple(map(to_surface, records)),
            tuple(seams),
            _seam_gaps(records, step),
            (tuple(ends[0]), tuple(ends[1])),
        )

    def corner(self, j: int, end: int) -> Floats:
        """Where seam j meets the toe or heel."""
        return np.asarray(self.records[j].poles[0, -end])

    def end_points(self, j: int, end: int, places: Floats) -> Floats:
        """Points of face j's edge at the toe or heel, shape (n, 3)."""
        record = self.records[j]
        return np.asarray(
            basis_matrix(places, record.knots_u, record.degree_u) @ record.poles[:, -end], dtype=np.float64
        )


@dataclass
class ToothMade:
    """One tooth's vertices and edges, each list in the order of the faces, and its faces."""

    corners: tuple[list[TopoDS_Vertex], list[TopoDS_Vertex]]
    seams: list[TopoDS_Edge]
    ends: tuple[list[TopoDS_Edge], list[TopoDS_Edge]] = field(default_factory=lambda: ([], []))
    faces: list[TopoDS_Face] = field(default_factory=list)


def _seam_gaps(records: Sequence[NurbsSurface], step: float) -> tuple[float, ...]:
    """Largest distance between neighbours at each seam; the first face meets the last of the tooth before."""
    gaps = []
    for j, record in enumerate(records):
        previous = records[j - 1]
        places = np.union1d(_trace_nodes(record.knots_v), _trace_nodes(previous.knots_v))
        there = previous.grid([1.0], places)[0]
        if j == 0:
            there = there @ _rotation(-step).T
        gaps.append(float(np.linalg.norm(record.grid([0.0], places)[0] - there, axis=-1).max()))
    return tuple(gaps)


def _rotation(angle: float) -> Floats:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def make_teeth(maker: Maker, pitch: Pitch, teeth: int) -> list[ToothMade]:
    """Faces of all teeth, each a turned copy that shares its edges with its neighbours."""
    turns = [_turn(i * TURN / teeth) for i in range(teeth)]
    made = [_start_tooth(maker, pitch, turn) for turn in turns]
    lines = [Geom2d_Line(gp_Pnt2d(*at), gp_Dir2d(*way)) for at, way in _BORDERS]
    for index, (tooth, turn) in enumerate(zip(made, turns, strict=True)):
        following = made[(index + 1) % teeth]
        for j, surface in enumerate(pitch.surfaces):
            last = j + 1 == len(pitch.surfaces)
            nxt, k = (following, 0) if last else (tooth, j + 1)
            geometry = surface.Transformed(turn)
            for end in (0, 1):
                curve = pitch.ends[end][j].Transformed(turn)
                gap = max(pitch.seam_gaps[j], pitch.seam_gaps[k])
                tooth.ends[end].append(maker.edge(curve, (0.0, 1.0), tooth.corners[end][j], nxt.corners[end][k], gap))
            toe, heel, left, right = tooth.ends[0][j], tooth.ends[1][j], tooth.seams[j], nxt.seams[k]
            for edge, line, gap in zip(
                (toe, right, heel, left), lines, (0.0, pitch.seam_gaps[k], 0.0, 0.0), strict=True
            ):
                maker.lay(edge, line, geometry, gap)
            uses = [(toe, True), (right, True), (heel, False), (left, False)]
            tooth.faces.append(maker.face(geometry, [uses], outward=True))
    return made


_BORDERS = (((0.0, 0.0), (1.0, 0.0)), ((1.0, 0.0), (0.0, 1.0)), ((0.0, 1.0), (1.0, 0.0)), ((0.0, 0.0), (0.0, 1.0)))


def _start_tooth(maker: Maker, pitch: Pitch, turn: gp_Trsf) -> ToothMade:
    """Vertices and seams of a tooth."""
    matrix = np.array([[turn.Value(i, j) for j in (1, 2, 3)] for i in (1, 2, 3)])
    count = len(pitch.surfaces)
    toe, heel = (
        [maker.vertex(matrix @ pitch.corner(j, end), pitch.seam_gaps[j]) for j in range(count)] for end in (0, 1)
    )
    seams = [
        maker.edge(pitch.seams[j].Transformed(turn), (0.0, 1.0), toe[j], heel[j], pitch.seam_gaps[j])
        for j in range(count)
    ]
    return ToothMade((toe, heel), seams)


def _turn(angle: float) -> gp_Trsf:
    turn = gp_Trsf()
    turn.SetRotation(gp_Ax1(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(0.0, 0.0, 1.0)), angle)
    return turn


def end_trace(pitch: Pitch, revolved: Revolved, j: int, end: int) -> tuple[Geom2d_Curve, float]:
    """Curve of a profile edge on an end face, and how far from the edge it runs [mm]."""
    corner = pitch.corner(0, end)

    def on_surface(points: Floats) -> Floats:
        return revolved.parameters(np.vstack([corner, points]))[1:]

    knots = pitch.records[j].knots_u
    for nodes_a_span in _TRACE_NODES_A_SPAN:
        nodes = _trace_nodes(knots, nodes_a_span)
        spline = make_interp_spline(nodes, on_surface(pitch.end_points(j, end, nodes)), k=_TRACE_DEGREE)
        trace = Geom2d_BSplineCurve(point_row_2d(spline.c), *knots_and_multiplicities(spline.t), _TRACE_DEGREE)
        points = pitch.end_points(j, end, np.linspace(0.0, 1.0, 6 * len(nodes) + 1))
        off = (spline(np.linspace(0.0, 1.0, len(points))) - on_surface(points)) * revolved.scale(points)
        along = float(np.max(np.hypot(*off.T)))
        gap = float(np.max(revolved.distance(points) + np.hypot(*off.T)))
        if along <= _TRACE_SHARE * np.abs(points).max():
            break
    return trace, gap


def _trace_nodes(knots: Floats, nodes_a_span: int = _TRACE_NODES_A_SPAN[0]) -> Floats:
    """Several places in every span of the edge's own knots, where it is less smooth."""
    spans = np.unique(knots)
    inner = np.linspace(0.0, 1.0, nodes_a_span, endpoint=False)
    return np.append((spans[:-1, None] + np.diff(spans)[:, None] * inner).ravel(), spans[-1])


def meridian_point(point: Floats) -> Point:
    """(radius, height) of a point [mm]."""
    return float(np.hypot(point[0], point[1])), float(point[2])
