"""One closed shell from tooth faces and a turned outline, every edge and vertex shared; no Boolean, no sewing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray
from OCP.Geom2d import Geom2d_Curve
from OCP.gp import gp_Vec2d
from OCP.TopoDS import TopoDS_Edge, TopoDS_Face, TopoDS_Solid

from gearstudio.kernel.maker import Maker, Point
from gearstudio.kernel.pitch import Pitch, PitchEnd, ToothMade, make_teeth, meridian_point
from gearstudio.kernel.revolved import TURN, Revolved
from gearstudio.kernel.turned import Ring, seam_edge, turned_face
from gearstudio.nurbs import NurbsSurface
from gearstudio.theory.chamfer import EndChamfer

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class GearShell:
    """A gear's solid; the faces of each tooth in the order in which their surfaces and chamfers were given."""

    solid: TopoDS_Solid
    tooth_faces: tuple[tuple[TopoDS_Face, ...], ...]
    chamfer_faces: tuple[tuple[TopoDS_Face, ...], ...]
    body_faces: tuple[TopoDS_Face, ...]
    tolerance: float


def assembled(
    surfaces: Sequence[NurbsSurface],
    teeth: int,
    outline: Floats,
    spherical_ends: bool,
    chamfers: Sequence[EndChamfer] = (),
) -> GearShell:
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
    chamfers : sequence of EndChamfer
        At the toe, the heel or both, in this order.

    Returns
    -------
    GearShell
        ``tolerance`` is the largest gap between neighbours [mm].

    Raises
    ------
    GeometryError
        A chamfer does not cut off the tips of the teeth alone.
    """
    maker = Maker()
    pitch = Pitch.of(surfaces, TURN / teeth, chamfers)
    teeth_made = make_teeth(maker, pitch, teeth)
    body = _make_body(maker, pitch, teeth_made, outline, spherical_ends, TURN / teeth)
    return _shell(maker, teeth_made, body)


def _shell(
    maker: Maker, teeth: Sequence[ToothMade], body: Sequence[TopoDS_Face], inside_out: bool = False
) -> GearShell:
    faces, chamfers = (tuple(map(tuple, made)) for made in ([t.faces for t in teeth], [t.chamfers for t in teeth]))
    return GearShell(maker.solid(inside_out), faces, chamfers, tuple(body), maker.gap)


def closed_tooth(
    surfaces: Sequence[NurbsSurface],
    spherical_ends: bool,
    inside_out: bool = False,
    chamfers: Sequence[EndChamfer] = (),
) -> GearShell:
    """Join faces that run once round a tooth, or round a tooth space, with two end faces into a solid.

    Parameters
    ----------
    surfaces : sequence of NurbsSurface
        As for `assembled`, the last meeting the first of the same tooth.
    spherical_ends : bool
    inside_out : bool
        Whether the normals point into the solid, as those of a gear's faces do round a tooth space.
    chamfers : sequence of EndChamfer
        As for `assembled`.
    """
    maker = Maker()
    pitch = Pitch.of(surfaces, 0.0, chamfers)
    tooth = make_teeth(maker, pitch, 1)[0]
    ends = [_loop_face(maker, pitch, tooth, end, spherical_ends, inside_out) for end in (0, 1)]
    return _shell(maker, [tooth], ends, inside_out)


def _make_body(
    maker: Maker, pitch: Pitch, teeth: list[ToothMade], outline: Floats, spherical: bool, step: float
) -> list[TopoDS_Face]:
    """The heel face, the turned faces and the toe face."""
    points: list[Point] = [(float(r), float(z)) for r, z in outline]
    azimuths = [float(np.arctan2(*pitch.corner(0, end)[1::-1])) for end in (0, 1)]
    first_plane = next(k for k in range(len(points) - 1) if points[k][1] == points[k + 1][1])
    seams = [azimuths[1] if k <= first_plane else azimuths[0] for k in range(len(points))]
    rings = [Ring.of(maker, point, seam) for point, seam in zip(points, seams, strict=True)]
    heel_start, toe_start = (meridian_point(pitch.corner(0, end)) for end in (1, 0))
    faces = [_end_face(maker, pitch, teeth, 1, rings[0], Revolved(heel_start, points[0], seams[0], spherical), step)]
    for here, there in pairwise(rings):
        if here.edge is None and there.edge is None:
            continue
        faces.append(turned_face(maker, here, there))
    toe = Revolved(points[-1], toe_start, seams[-1], spherical)
    faces.append(_end_face(maker, pitch, teeth, 0, rings[-1], toe, step))
    return faces


def _end_face(
    maker: Maker, pitch: Pitch, teeth: list[ToothMade], end: int, ring: Ring, revolved: Revolved, step: float
) -> TopoDS_Face:
    """The face between the tooth profiles at toe or heel and the body."""
    surface = revolved.geometry()
    traces = _end_traces(pitch, revolved, end)
    profile = []
    for index, tooth in enumerate(teeth):
        shift = gp_Vec2d(revolved.direction * index * step, 0.0)
        for edge, (trace, gap) in zip(_end_edges(pitch, tooth, end), traces, strict=True):
            maker.lay(edge, trace.Translated(shift), surface, gap)
            profile.append((edge, bool(end)))
    maker.lay(ring.edge, revolved.circle_on(*ring.point), surface)
    corner = teeth[0].corners[end][0]
    start = meridian_point(pitch.corner(0, end))
    seam = seam_edge(maker, revolved, surface, start, ring.point, corner, ring.vertex)
    if not end:
        profile.reverse()
    return maker.face(surface, [[*profile, (seam, True), (ring.edge, not end), (seam, False)]], revolved.outward)


def _end_traces(pitch: Pitch, revolved: Revolved, end: int) -> list[tuple[Geom2d_Curve, float]]:
    """Curves on an end surface of one pitch's edges there, in the order of azimuth, and how far off they run [mm]."""
    anchor, at = pitch.corner(0, end), pitch.ends[end]
    return [edge.on(revolved, anchor) for edge in _on_end(at, at.pieces, at.chamfer.arc if at.chamfer else None)]


def _end_edges(pitch: Pitch, tooth: ToothMade, end: int) -> list[TopoDS_Edge]:
    """The edges that belong to `_end_traces`."""
    return _on_end(pitch.ends[end], tooth.ends[end], tooth.arcs.get(end))


def _on_end(end: PitchEnd, along: Sequence[Any], arc: Any) -> list[Any]:
    """What lies on the end surface: the pieces, the arc in place of those that a chamfer cut."""
    if end.chamfer is None:
        return list(along)
    return [*along[: end.chamfer.cuts[0]], arc, *along[end.chamfer.cuts[-1] + 1 :]]


def _loop_face(
    maker: Maker, pitch: Pitch, tooth: ToothMade, end: int, spherical: bool, inside_out: bool
) -> TopoDS_Face:
    """The end face of a closed tooth."""
    corners = [record.poles[0, -end] for record in pitch.records]
    points = sorted((meridian_point(c) for c in corners), key=lambda point: float(np.arctan2(*point)))
    top, bottom = points[-1], points[0]
    first, last = (top, bottom) if bool(end) != inside_out else (bottom, top)
    seam = float(np.arctan2(corners[0][1], corners[0][0])) + np.pi
    revolved = Revolved(first, last, seam, spherical)
    surface = revolved.geometry()
    profile = []
    for edge, (trace, gap) in zip(_end_edges(pitch, tooth, end), _end_traces(pitch, revolved, end), strict=True):
        maker.lay(edge, trace, surface, gap)
        profile.append((edge, bool(end)))
    if not end:
        profile.reverse()
    return maker.face(surface, [profile], revolved.outward)
