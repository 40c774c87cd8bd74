"""The faces, edges and vertices of one pitch, made once and turned for every tooth."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from OCP.Geom import Geom_Curve, Geom_Surface
from OCP.Geom2d import Geom2d_Line
from OCP.gp import gp_Ax1, gp_Dir, gp_Dir2d, gp_Pnt, gp_Pnt2d, gp_Trsf
from OCP.TopoDS import TopoDS_Edge, TopoDS_Face, TopoDS_Vertex

from gearstudio.kernel.convert import to_curve, to_surface
from gearstudio.kernel.ends import ChamferPitch, EndPiece, chamfer_pitch, cut_pieces, end_pieces, nodes_of
from gearstudio.kernel.maker import Maker, Point
from gearstudio.kernel.revolved import TURN
from gearstudio.nurbs import NurbsSurface
from gearstudio.theory.chamfer import EndChamfer

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class PitchEnd:
    """The edges of one pitch at the toe or heel, in the order of azimuth, and the chamfer below some of them.

    ``places`` tells where along each seam the end is met, ``corners`` (n, 3) the points there [mm].
    """

    pieces: tuple[EndPiece, ...]
    places: tuple[float, ...]
    corners: Floats
    chamfer: ChamferPitch | None

    @staticmethod
    def of(records: Sequence[NurbsSurface], end: int, chamfer: EndChamfer | None) -> PitchEnd:
        """The end of faces as for `assembled`."""
        curves = [to_curve(r.poles[:, -end], r.knots_u, r.degree_u) for r in records]
        if chamfer is None:
            corners = np.array([record.poles[0, -end] for record in records])
            return PitchEnd(end_pieces(records, curves, end), (float(end),) * len(records), corners, None)
        pieces, cuts = cut_pieces(records, curves, chamfer)
        places = tuple(float(end) if cut is None else float(cut.v(0.0)) for cut in cuts)
        corners = np.array([r.grid([0.0], [place])[0, 0] for r, place in zip(records, places, strict=True)])
        return PitchEnd(pieces, places, corners, chamfer_pitch(pieces, chamfer))


@dataclass(frozen=True)
class Pitch:
    """The geometry of one tooth, to be turned for the others; index 0 is the toe, 1 the heel."""

    records: tuple[NurbsSurface, ...]
    surfaces: tuple[Geom_Surface, ...]
    seams: tuple[Geom_Curve, ...]
    seam_gaps: tuple[float, ...]
    ends: tuple[PitchEnd, PitchEnd]

    @staticmethod
    def of(records: Sequence[NurbsSurface], step: float, chamfers: Sequence[EndChamfer] = ()) -> Pitch:
        """Of faces as for `assembled`, at an angular step between teeth [rad]."""
        at = {chamfer.end: chamfer for chamfer in chamfers}
        return Pitch(
            tuple(records),
            tuple(map(to_surface, records)),
            tuple(to_curve(r.poles[0], r.knots_v, r.degree_v) for r in records),
            _seam_gaps(records, step),
            (PitchEnd.of(records, 0, at.get(0)), PitchEnd.of(records, 1, at.get(1))),
        )

    def corner(self, j: int, end: int) -> Floats:
        """Where seam j meets the toe or heel."""
        return np.asarray(self.ends[end].corners[j])


@dataclass
class ToothMade:
    """One tooth's vertices, edges and faces.

    ``corners`` and ``seams`` in the order of the faces, ``ends`` in that of the pieces at either end, ``arcs``
    along the lower sides of the chamfers, by end.
    """

    corners: tuple[list[TopoDS_Vertex], list[TopoDS_Vertex]]
    seams: list[TopoDS_Edge]
    ends: tuple[list[TopoDS_Edge], list[TopoDS_Edge]] = field(default_factory=lambda: ([], []))
    arcs: dict[int, TopoDS_Edge] = field(default_factory=dict)
    faces: list[TopoDS_Face] = field(default_factory=list)
    chamfers: list[TopoDS_Face] = field(default_factory=list)


def _seam_gaps(records: Sequence[NurbsSurface], step: float) -> tuple[float, ...]:
    """Largest distance between neighbours at each seam; the first face meets the last of the tooth before."""
    gaps = []
    for j, record in enumerate(records):
        previous = records[j - 1]
        places = np.union1d(nodes_of(np.unique(record.knots_v)), nodes_of(np.unique(previous.knots_v)))
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
    for index, (tooth, turn) in enumerate(zip(made, turns, strict=True)):
        following = made[(index + 1) % teeth]
        for end in (0, 1):
            _make_end(maker, pitch, tooth, following, end, turn)
        _make_faces(maker, pitch, tooth, following, turn)
    return made


def _make_end(maker: Maker, pitch: Pitch, tooth: ToothMade, following: ToothMade, end: int, turn: gp_Trsf) -> None:
    """The edges of a tooth at one end, and its chamfer there."""
    pieces, chamfer = pitch.ends[end].pieces, pitch.ends[end].chamfer
    corners = [*tooth.corners[end], following.corners[end][0]]
    vertices = [corners[0]]
    for here, there in pairwise(pieces):
        if there.face > here.face:
            vertices.append(corners[there.face])
        else:
            point = _matrix(turn) @ there.points(np.array(there.span[:1]))[0]
            vertices.append(maker.vertex(point, chamfer.gap if chamfer else 0.0))
    vertices.append(corners[-1])
    for piece, (start, stop) in zip(pieces, pairwise(vertices), strict=True):
        gap = max(piece.gap, pitch.seam_gaps[piece.face], pitch.seam_gaps[(piece.face + 1) % len(pitch.surfaces)])
        tooth.ends[end].append(maker.edge(piece.curve.Transformed(turn), piece.span, start, stop, gap))
    if chamfer is not None:
        left, right = vertices[chamfer.cuts[0]], vertices[chamfer.cuts[-1] + 1]
        arc = maker.edge(chamfer.arc.curve.Transformed(turn), chamfer.arc.span, left, right, chamfer.gap)
        surface = chamfer.surface.Transformed(turn)
        edges = [tooth.ends[end][k] for k in chamfer.cuts]
        own = [*(pieces[k].gap for k in chamfer.cuts), 0.0]
        for edge, (trace, gap), on_face in zip((*edges, arc), chamfer.traces, own, strict=True):
            maker.lay(edge, trace, surface, gap + on_face)
        uses = [*((edge, bool(end)) for edge in edges), (arc, not end)]
        tooth.arcs[end] = arc
        tooth.chamfers.append(maker.face(surface, [uses if end else uses[::-1]], chamfer.outward))


def _make_faces(maker: Maker, pitch: Pitch, tooth: ToothMade, following: ToothMade, turn: gp_Trsf) -> None:
    for j, surface in enumerate(pitch.surfaces):
        geometry = surface.Transformed(turn)
        right, k = (tooth.seams[j + 1], j + 1) if j + 1 < len(pitch.surfaces) else (following.seams[0], 0)
        toe, heel = (_laid(maker, pitch, tooth, j, end, geometry) for end in (0, 1))
        maker.lay(right, _RIGHT, geometry, pitch.seam_gaps[k])
        maker.lay(tooth.seams[j], _LEFT, geometry)
        uses = [*((edge, True) for edge in toe), (right, True), *((edge, False) for edge in reversed(heel))]
        tooth.faces.append(maker.face(geometry, [[*uses, (tooth.seams[j], False)]], outward=True))


def _laid(maker: Maker, pitch: Pitch, tooth: ToothMade, j: int, end: int, geometry: Geom_Surface) -> list[TopoDS_Edge]:
    """The edges of face j at an end, laid on it."""
    edges = []
    for piece, edge in zip(pitch.ends[end].pieces, tooth.ends[end], strict=True):
        if piece.face == j:
            maker.lay(edge, piece.trace, geometry, piece.gap)
            edges.append(edge)
    return edges


_LEFT, _RIGHT = (Geom2d_Line(gp_Pnt2d(u, 0.0), gp_Dir2d(0.0, 1.0)) for u in (0.0, 1.0))


def _start_tooth(maker: Maker, pitch: Pitch, turn: gp_Trsf) -> ToothMade:
    """Vertices and seams of a tooth."""
    matrix = _matrix(turn)
    count = len(pitch.surfaces)
    toe, heel = (
        [maker.vertex(matrix @ pitch.corner(j, end), pitch.seam_gaps[j]) for j in range(count)] for end in (0, 1)
    )
    spans = zip(pitch.ends[0].places, pitch.ends[1].places, strict=True)
    seams = [
        maker.edge(pitch.seams[j].Transformed(turn), span, toe[j], heel[j], pitch.seam_gaps[j])
        for j, span in enumerate(spans)
    ]
    return ToothMade((toe, heel), seams)


def _matrix(turn: gp_Trsf) -> Floats:
    return np.array([[turn.Value(i, j) for j in (1, 2, 3)] for i in (1, 2, 3)])


def _turn(angle: float) -> gp_Trsf:
    turn = gp_Trsf()
    turn.SetRotation(gp_Ax1(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(0.0, 0.0, 1.0)), angle)
    return turn


def meridian_point(point: Floats) -> Point:
    """(radius, height) of a point [mm]."""
    return float(np.hypot(point[0], point[1])), float(point[2])
