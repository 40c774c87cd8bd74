"""One closed shell from tooth faces and a turned outline, every edge and vertex shared; no Boolean, no sewing."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from OCP.BRep import BRep_Builder
from OCP.Geom import Geom_Curve, Geom_Surface
from OCP.Geom2d import Geom2d_BSplineCurve, Geom2d_Curve, Geom2d_Line
from OCP.gp import gp_Ax1, gp_Dir, gp_Dir2d, gp_Pnt, gp_Pnt2d, gp_Trsf, gp_Vec2d
from OCP.TopAbs import TopAbs_Orientation
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS_Edge, TopoDS_Face, TopoDS_Shell, TopoDS_Solid, TopoDS_Vertex, TopoDS_Wire
from scipy.interpolate import make_interp_spline

from gearstudio.kernel.convert import CONFUSION_MM, knots_and_multiplicities, point_row_2d, to_curve, to_surface
from gearstudio.kernel.revolved import TURN, Revolved, circle
from gearstudio.nurbs import NurbsSurface, basis_matrix

Floats = NDArray[np.float64]
Point = tuple[float, float]

_FORWARD, _REVERSED = TopAbs_Orientation.TopAbs_FORWARD, TopAbs_Orientation.TopAbs_REVERSED
_HERE = TopLoc_Location()
_TRACE_DEGREE = 5
_TRACE_NODES_A_SPAN = (6, 12, 24)
_TRACE_SHARE = 1e-8
_MARGIN = 1.5


@dataclass(frozen=True)
class GearShell:
    """A gear's solid; the faces of each tooth in the order in which their surfaces were given."""

    solid: TopoDS_Solid
    tooth_faces: tuple[tuple[TopoDS_Face, ...], ...]
    body_faces: tuple[TopoDS_Face, ...]
    tolerance: float


def assembled(surfaces: Sequence[NurbsSurface], teeth: int, outline: Floats, spherical_ends: bool) -> GearShell:
    """Join the faces of all teeth, the two end faces and the turned body into a solid.

    Parameters
    ----------
    surfaces : sequence of NurbsSurface
        Faces of one pitch with growing azimuth over [0, 1]², each meeting the next in its edge u = 1, the
        last the first of the next tooth; v runs from toe to heel, normals point out of the metal.
    teeth : int
    outline : ndarray, shape (n, 2)
        (radius, height) of the body from heel to toe [mm].
    spherical_ends : bool
        Whether the teeth end on spheres about the apex instead of cones.

    Returns
    -------
    GearShell
        ``tolerance`` is the largest gap between neighbours [mm].
    """
    maker = _Maker()
    pitch = _Pitch.of(surfaces, TURN / teeth)
    teeth_made = _make_teeth(maker, pitch, teeth)
    body = _make_body(maker, pitch, teeth_made, outline, spherical_ends, TURN / teeth)
    return GearShell(maker.solid(), tuple(tuple(t.faces) for t in teeth_made), tuple(body), maker.gap)


class _Maker:
    """The kernel's builder, the shell it fills, and the largest gap it had to bridge."""

    def __init__(self) -> None:
        self.builder = BRep_Builder()
        self.shell = TopoDS_Shell()
        self.builder.MakeShell(self.shell)
        self.gap = 0.0

    def vertex(self, point: Floats, gap: float) -> TopoDS_Vertex:
        vertex = TopoDS_Vertex()
        self.builder.MakeVertex(vertex, gp_Pnt(*point.tolist()), self._tolerance(gap))
        return vertex

    def edge(
        self, curve: Geom_Curve, span: Point, start: TopoDS_Vertex, end: TopoDS_Vertex, gap: float = 0.0
    ) -> TopoDS_Edge:
        edge = TopoDS_Edge()
        self.builder.MakeEdge(edge, curve, self._tolerance(gap))
        self.builder.Add(edge, start.Oriented(_FORWARD))
        self.builder.Add(edge, end.Oriented(_REVERSED))
        self.builder.Range(edge, *span)
        return edge

    def lay(self, edge: TopoDS_Edge, trace: Geom2d_Curve, surface: Geom_Surface, gap: float = 0.0) -> None:
        """Give an edge its curve on a surface."""
        self.builder.UpdateEdge(edge, trace, surface, _HERE, self._tolerance(gap))

    def face(
        self, surface: Geom_Surface, wires: Iterable[Sequence[tuple[TopoDS_Edge, bool]]], outward: bool
    ) -> TopoDS_Face:
        """Add a face to the shell; edges are told as they run seen from outside the metal."""
        face = TopoDS_Face()
        self.builder.MakeFace(face, surface, CONFUSION_MM)
        for uses in wires:
            wire = TopoDS_Wire()
            self.builder.MakeWire(wire)
            for edge, forward in uses if outward else reversed(uses):
                self.builder.Add(wire, edge.Oriented(_FORWARD if forward == outward else _REVERSED))
            wire.Closed(True)
            self.builder.Add(face, wire)
        face = face if outward else face.Reversed()
        self.builder.Add(self.shell, face)
        return face

    def solid(self) -> TopoDS_Solid:
        self.shell.Closed(True)
        solid = TopoDS_Solid()
        self.builder.MakeSolid(solid)
        self.builder.Add(solid, self.shell)
        return solid

    def _tolerance(self, gap: float) -> float:
        self.gap = max(self.gap, gap)
        return max(CONFUSION_MM, _MARGIN * gap)


@dataclass(frozen=True)
class _Pitch:
    """The geometry of one tooth, to be turned for the others; index 0 is the toe, 1 the heel."""

    records: tuple[NurbsSurface, ...]
    surfaces: tuple[Geom_Surface, ...]
    seams: tuple[Geom_Curve, ...]
    seam_gaps: tuple[float, ...]
    ends: tuple[tuple[Geom_Curve, ...], tuple[Geom_Curve, ...]]

    @staticmethod
    def of(records: Sequence[NurbsSurface], step: float) -> _Pitch:
        seams = [to_curve(r.poles[0], r.knots_v, r.degree_v) for r in records]
        ends = [[to_curve(r.poles[:, j], r.knots_u, r.degree_u) for r in records] for j in (0, -1)]
        return _Pitch(
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
class _ToothMade:
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


def _make_teeth(maker: _Maker, pitch: _Pitch, teeth: int) -> list[_ToothMade]:
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


def _start_tooth(maker: _Maker, pitch: _Pitch, turn: gp_Trsf) -> _ToothMade:
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
    return _ToothMade((toe, heel), seams)


def _turn(angle: float) -> gp_Trsf:
    turn = gp_Trsf()
    turn.SetRotation(gp_Ax1(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(0.0, 0.0, 1.0)), angle)
    return turn


def _make_body(
    maker: _Maker, pitch: _Pitch, teeth: list[_ToothMade], outline: Floats, spherical: bool, step: float
) -> list[TopoDS_Face]:
    """The heel face, the turned faces and the toe face."""
    points: list[Point] = [(float(r), float(z)) for r, z in outline]
    azimuths = [float(np.arctan2(*pitch.corner(0, end)[1::-1])) for end in (0, 1)]
    first_plane = next(k for k in range(len(points) - 1) if points[k][1] == points[k + 1][1])
    seams = [azimuths[1] if k <= first_plane else azimuths[0] for k in range(len(points))]
    rings = [_Ring.of(maker, point, seam) for point, seam in zip(points, seams, strict=True)]
    heel_start, toe_start = (_meridian_point(pitch.corner(0, end)) for end in (1, 0))
    faces = [_end_face(maker, pitch, teeth, 1, rings[0], Revolved(heel_start, points[0], seams[0], spherical), step)]
    for here, there in pairwise(rings):
        if here.edge is None and there.edge is None:
            continue
        faces.append(_turned_face(maker, here, there))
    toe = Revolved(points[-1], toe_start, seams[-1], spherical)
    faces.append(_end_face(maker, pitch, teeth, 0, rings[-1], toe, step))
    return faces


@dataclass(frozen=True)
class _Ring:
    """A circle of the body; on the axis there is none."""

    point: Point
    seam: float
    edge: TopoDS_Edge | None
    vertex: TopoDS_Vertex | None

    @staticmethod
    def of(maker: _Maker, point: Point, seam: float) -> _Ring:
        radius, height = point
        if radius <= CONFUSION_MM:
            return _Ring((0.0, height), seam, None, None)
        vertex = maker.vertex(np.array([radius * np.cos(seam), radius * np.sin(seam), height]), 0.0)
        return _Ring(point, seam, maker.edge(circle(radius, height, seam), (0.0, TURN), vertex, vertex), vertex)


def _turned_face(maker: _Maker, here: _Ring, there: _Ring) -> TopoDS_Face:
    revolved = Revolved(here.point, there.point, here.seam)
    surface = revolved.geometry()
    wires: list[list[tuple[TopoDS_Edge, bool]]] = []
    for ring, forward in ((here, True), (there, False)):
        if ring.edge is not None:
            maker.lay(ring.edge, _Placed(revolved, ring).trace(), surface)
            wires.append([(ring.edge, forward)])
    if not revolved.is_plane:
        seam = _seam_edge(maker, revolved, surface, here.point, there.point, here.vertex, there.vertex)
        wires = [[wires[0][0], (seam, True), wires[1][0], (seam, False)]]
    return maker.face(surface, wires, revolved.outward)


@dataclass(frozen=True)
class _Placed:
    """A ring on a surface of revolution, whose azimuths may begin elsewhere."""

    revolved: Revolved
    ring: _Ring

    def trace(self) -> Geom2d_Curve:
        """Curve of the ring on the surface."""
        trace = self.revolved.circle_on(*self.ring.point)
        if self.revolved.is_plane:
            trace = trace.Rotated(gp_Pnt2d(0.0, 0.0), self.ring.seam - self.revolved.seam)
        return trace


def _seam_edge(
    maker: _Maker,
    revolved: Revolved,
    surface: Geom_Surface,
    start: Point,
    end: Point,
    start_vertex: TopoDS_Vertex,
    end_vertex: TopoDS_Vertex,
) -> TopoDS_Edge:
    """The edge along which a turned face is cut open; it grows with the surface's v."""
    curve, low, high = revolved.meridian(start, end)
    if revolved.v_at(*start) > revolved.v_at(*end):
        start_vertex, end_vertex = end_vertex, start_vertex
    edge = maker.edge(curve, (low, high), start_vertex, end_vertex)
    traces = [revolved.meridian_on(start, end, turned) for turned in (True, False)]
    maker.builder.UpdateEdge(edge, *traces, surface, _HERE, CONFUSION_MM)
    return edge


def _end_face(
    maker: _Maker, pitch: _Pitch, teeth: list[_ToothMade], end: int, ring: _Ring, revolved: Revolved, step: float
) -> TopoDS_Face:
    """The face between the tooth profiles at toe or heel and the body."""
    surface = revolved.geometry()
    traces = [_trace(pitch, revolved, j, end) for j in range(len(pitch.surfaces))]
    profile = []
    for index, tooth in enumerate(teeth):
        shift = gp_Vec2d(revolved.direction * index * step, 0.0)
        for edge, (trace, gap) in zip(tooth.ends[end], traces, strict=True):
            maker.lay(edge, trace.Translated(shift), surface, gap)
            profile.append((edge, bool(end)))
    maker.lay(ring.edge, revolved.circle_on(*ring.point), surface)
    corner = teeth[0].corners[end][0]
    start = _meridian_point(pitch.corner(0, end))
    seam = _seam_edge(maker, revolved, surface, start, ring.point, corner, ring.vertex)
    if not end:
        profile.reverse()
    return maker.face(surface, [[*profile, (seam, True), (ring.edge, not end), (seam, False)]], revolved.outward)


def _trace(pitch: _Pitch, revolved: Revolved, j: int, end: int) -> tuple[Geom2d_Curve, float]:
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


def _meridian_point(point: Floats) -> Point:
    return float(np.hypot(point[0], point[1])), float(point[2])
