"""The `cut` construction: blank minus tooth spaces, from the same flanks as the assembled gear."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from gearstudio.kernel.boxes import corners
from gearstudio.kernel.cutting import CutGear, Face, Report, cut_spaces
from gearstudio.kernel.shell import closed_tooth
from gearstudio.kernel.turned import turned_solid
from gearstudio.methods.base import SAFETY, Target
from gearstudio.methods.grafts import Angles, blended, edge_of, profile_space, reversed_across
from gearstudio.methods.space import fitted, space_v
from gearstudio.methods.tooth import Tooth, graft
from gearstudio.methods.trimming import trimmed
from gearstudio.nurbs import NurbsSurface
from gearstudio.theory.blank import BlankOutline
from gearstudio.theory.chamfer import end_point
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.limit import ConeLimit
from gearstudio.theory.section import Profile

Floats = NDArray[np.float64]

_END_SHARE = 0.03
_TIP_SHARE = 0.05
_EDGE_SHARE = 0.1
_SEAM_CANDIDATES = 181


def cut_gear(tooth: Tooth, outline: BlankOutline, target: Target, report: Report) -> CutGear:
    """The gear's solid, cut by Booleans.

    Parameters
    ----------
    tooth : Tooth
        Whose flanks are continued beyond tip and ends to make the tooth space.
    outline : BlankOutline
    target : Target
    report : callable
        Takes the stage that begins and the fraction done.

    Raises
    ------
    GeometryError
        A flank cannot be continued, or the Boolean failed.
    """
    member = tooth.member
    report("continuing the flanks", 0.0)
    space = closed_tooth(space_faces(tooth, target), member.ends == "sphere", inside_out=True)
    report("turning the blank", 0.02)
    points, sphere = blank_polygon(member, outline)
    blank = turned_solid(points, sphere, seam_azimuth(tooth.profile))
    return cut_spaces(blank, space, member.teeth, report)


def cut_names(tooth: Tooth, outline: BlankOutline, cut: CutGear) -> tuple[tuple[str, Face], ...]:
    """Names of all faces, the same as of an assembled gear; a face that the blank's seam divides is named twice."""
    names = [*_space_names(tooth, cut)]
    side, *others = sorted(cut.blank)
    titles = {others[-1]: "tip"}
    if outline.chamfers:
        titles |= {side: "heel chamfer", others[-2]: "toe chamfer"}
    body = [k for k in (side, *others) if k not in titles]
    for k, title in titles.items():
        names += [(f"tooth {_tooth_number(tooth.member, face)} {title}", face) for face in cut.blank[k]]
    for k, title in zip(body, body_titles(len(body)), strict=True):
        names += [(title, face) for face in cut.blank[k]]
    return tuple(names)


def body_titles(count: int) -> list[str]:
    """Names of the body's faces, from the heel end round to the toe end."""
    return ["heel end", *(f"body {i}" for i in range(1, count - 1)), "toe end"]


def _tooth_number(member: MemberGeometry, face: Face) -> int:
    """The tooth, counted from 1 at azimuth 0, on which a face across its tip lies."""
    x, y, z = corners(face).T
    in_section = np.arctan2(y, x) - member.lengthwise.azimuth(np.sqrt(x**2 + y**2 + z**2))
    middle = np.angle(np.exp(1j * in_section).mean())
    return int(np.round(middle / member.pitch)) % member.teeth + 1


def _space_names(tooth: Tooth, cut: CutGear) -> Iterator[tuple[str, Face]]:
    """Names of the faces that the tooth spaces left; space i lies between tooth i and the next, counted from 1."""
    faces = tooth.faces
    order = [face for face in faces if face.side > 0] + [face for face in faces if face.kind == "root"]
    after = [face for face in faces if face.side < 0]
    for number, space in enumerate(cut.spaces, start=1):
        following = number % tooth.member.teeth + 1
        titles = [f"tooth {number} {face.title(tooth.member.hand)}" for face in order]
        titles += [f"tooth {following} {face.title(tooth.member.hand)}" for face in after]
        for title, left in zip(titles, space, strict=False):
            yield from ((title, made) for made in left)


def blank_polygon(member: MemberGeometry, outline: BlankOutline) -> tuple[Floats, list[bool]]:
    """Closed outline (radius, height) of the blank with its face cone, and which of its sides are spheres."""
    toe, heel = ([end_point(member, member.tip_limit, v)] for v in (0.0, 1.0))
    for chamfer in outline.chamfers:
        (heel if chamfer.heel else toe)[:] = [np.array(chamfer.face), np.array(chamfer.foot)]
    points = np.vstack([*heel, outline.points, *toe[::-1]])
    sphere = [False] * len(points)
    sphere[len(heel) - 1] = sphere[-len(toe) - 1] = member.ends == "sphere"
    return points, sphere


def seam_azimuth(profile: Profile) -> float:
    """Where the blank's faces are cut open: as far as can be from the flanks at heel and toe [rad]."""
    member = profile.member
    candidates = np.linspace(0.0, member.pitch, _SEAM_CANDIDATES)
    clearance = np.full_like(candidates, np.inf)
    for distance in (member.inner_cone_distance, member.outer_cone_distance):
        (_, first, last), (_, after, before) = (profile.across(name, np.array(distance)) for name in ("tip", "root"))
        tip = np.array([max(first, before - member.pitch), min(last, after)])
        root = np.array([max(last, after), min(member.pitch + first, before)])
        turned = candidates - member.lengthwise.azimuth(distance)
        clear = np.full_like(candidates, -np.inf)
        for low, high in (tip, root):
            from_middle = np.remainder(turned - (low + high) / 2 + member.pitch / 2, member.pitch) - member.pitch / 2
            clear = np.maximum(clear, (high - low) / 2 - np.abs(from_middle))
        clearance = np.minimum(clearance, clear)
    return float(candidates[np.argmax(clearance)])


def space_faces(tooth: Tooth, target: Target) -> list[NurbsSurface]:
    """Faces once round a tooth space, reaching beyond tip and ends; their normals point into the space."""
    member = extended(tooth.member)
    profile = tooth.profile.extended(member)
    goal = _EDGE_SHARE * target.tolerance
    flanks = {}
    for face in tooth.faces:
        if face.kind == "flank":
            surface = reversed_across(face.surface) if face.side > 0 else face.surface
            flanks[face.side] = trimmed(profile.flank(face.side), surface, goal)
    faces = graft(profile, flanks, SAFETY * target.tolerance)
    descending = [face.surface for face in faces if face.side > 0]
    bottom = [face.surface for face in faces if face.kind == "root"]
    rising = [_turned(face.surface, member.pitch) for face in faces if face.side < 0]

    cap = fitted(
        f"{member.name} tooth space",
        profile_space(),
        space_v(rising[-1]),
        blended(
            member,
            _cap_angles(profile),
            lambda y: edge_of(member, rising[-1], 1.0, y),
            lambda y: edge_of(member, descending[0], 0.0, y),
        ),
        SAFETY * target.tolerance,
    )
    return [*descending, *bottom, *rising, cap]


def extended(member: MemberGeometry) -> MemberGeometry:
    """The same teeth, a little longer at both ends and a little higher."""
    step = _END_SHARE * member.face_width
    outer = member.outer_cone_distance + step
    tip = member.tip_limit
    rise = _TIP_SHARE * (tip.angle - member.root_angle)
    return replace(
        member,
        outer_cone_distance=outer,
        face_width=member.face_width + 2 * step,
        fillet_radius=member.fillet_radius * outer / member.outer_cone_distance,
        tip_limit=ConeLimit(tip.angle + rise, tip.offset, tip.pitch_angle),
    )


def _cap_angles(profile: Profile) -> Angles:
    """The face over a tooth space, with falling azimuth."""

    def angles(x: Floats, rho_u: Floats) -> tuple[Floats, Floats]:
        delta, next_first, last = profile.across("tip", rho_u)
        return delta, (1 - x) * (profile.member.pitch + next_first) + x * last

    return angles


def _turned(surface: NurbsSurface, angle: float) -> NurbsSurface:
    c, s = np.cos(angle), np.sin(angle)
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    return replace(surface, poles=surface.poles @ turn.T)
