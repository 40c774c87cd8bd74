"""One closed shell from tooth faces and a turned outline, every edge and vertex shared; no Boolean, no sewing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from OCP.gp import gp_Vec2d
from OCP.TopoDS import TopoDS_Face, TopoDS_Solid

from gearstudio.kernel.maker import Maker, Point
from gearstudio.kernel.pitch import Pitch, ToothMade, end_trace, make_teeth, meridian_point
from gearstudio.kernel.revolved import TURN, Revolved
from gearstudio.kernel.turned import Ring, seam_edge, turned_face
from gearstudio.nurbs import NurbsSurface

Floats = NDArray[np.float64]


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
    maker = Maker()
    pitch = Pitch.of(surfaces, TURN / teeth)
    teeth_made = make_teeth(maker, pitch, teeth)
    body = _make_body(maker, pitch, teeth_made, outline, spherical_ends, TURN / teeth)
    return GearShell(maker.solid(), tuple(tuple(t.faces) for t in teeth_made), tuple(body), maker.gap)


def closed_tooth(surfaces: Sequence[NurbsSurface], spherical_ends: bool, inside_out: bool = False) -> GearShell:
    """Join faces that run once round a tooth, or round a tooth space, with two end faces into a solid.

    Parameters
    ----------
    surfaces : sequence of NurbsSurface
        As for `assembled`, the last meeting the first of the same tooth.
    spherical_ends : bool
    inside_out : bool
        Whether the normals point into the solid, as those of a gear's faces do round a tooth space.
    """
    maker = Maker()
    pitch = Pitch.of(surfaces, 0.0)
    tooth = make_teeth(maker, pitch, 1)[0]
    ends = [_loop_face(maker, pitch, tooth, end, spherical_ends, inside_out) for end in (0, 1)]
    solid = maker.solid(inside_out)
    return GearShell(solid, (tuple(tooth.faces),), tuple(ends), maker.gap)


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
    traces = [end_trace(pitch, revolved, j, end) for j in range(len(pitch.surfaces))]
    profile = []
    for index, tooth in enumerate(teeth):
        shift = gp_Vec2d(revolved.direction * index * step, 0.0)
        for edge, (trace, gap) in zip(tooth.ends[end], traces, strict=True):
            maker.lay(edge, trace.Translated(shift), surface, gap)
            profile.append((edge, bool(end)))
    maker.lay(ring.edge, revolved.circle_on(*ring.point), surface)
    corner = teeth[0].corners[end][0]
    start = meridian_point(pitch.corner(0, end))
    seam = seam_edge(maker, revolved, surface, start, ring.point, corner, ring.vertex)
    if not end:
        profile.reverse()
    return maker.face(surface, [[*profile, (seam, True), (ring.edge, not end), (seam, False)]], revolved.outward)


def _loop_face(
    maker: Maker, pitch: Pitch, tooth: ToothMade, end: int, spherical: bool, inside_out: bool
) -> TopoDS_Face:
    """The end face of a closed tooth."""
    corners = [pitch.corner(j, end) for j in range(len(pitch.surfaces))]
    points = sorted((meridian_point(c) for c in corners), key=lambda point: float(np.arctan2(*point)))
    top, bottom = points[-1], points[0]
    first, last = (top, bottom) if bool(end) != inside_out else (bottom, top)
    seam = float(np.arctan2(corners[0][1], corners[0][0])) + np.pi
    revolved = Revolved(first, last, seam, spherical)
    surface = revolved.geometry()
    profile = []
    for j, edge in enumerate(tooth.ends[end]):
        curve, gap = end_trace(pitch, revolved, j, end)
        maker.lay(edge, curve, surface, gap)
        profile.append((edge, bool(end)))
    if not end:
        profile.reverse()
    return maker.face(surface, [profile], revolved.outward)
