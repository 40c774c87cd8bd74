"""The `cut` construction: blank minus tooth spaces, from the same flanks as the assembled gear."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from gearstudio.kernel.cutting import CutGear, Face, Report, cut_spaces
from gearstudio.kernel.shell import closed_tooth
from gearstudio.kernel.turned import turned_solid
from gearstudio.methods.base import SAFETY, Target
from gearstudio.methods.grafts import Angles, blended, edge_of, profile_space, reversed_across
from gearstudio.methods.space import fitted, space_v
from gearstudio.methods.tooth import Tooth, graft, profile_flank
from gearstudio.methods.trimming import trimmed
from gearstudio.nurbs import NurbsSurface
from gearstudio.theory.cones import ConeLimit, MemberGeometry
from gearstudio.theory.profile import ToothProfile, tooth_profile

Floats = NDArray[np.float64]

_END_SHARE = 0.03
_TIP_SHARE = 0.05
_EDGE_SHARE = 0.1
_SEAM_CANDIDATES = 181


def cut_gear(tooth: Tooth, outline: Floats, target: Target, report: Report) -> CutGear:
    """The gear's solid, cut by Booleans.

    Parameters
    ----------
    tooth : Tooth
        Whose flanks are continued beyond tip and ends to make the tooth space.
    outline : ndarray, shape (n, 2)
        Of the body, as of `blank_outline`.
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
    blank = turned_solid(*blank_polygon(member, outline), seam_azimuth(tooth.profile))
    return cut_spaces(blank, space, member.teeth, report)


def space_names(tooth: Tooth, cut: CutGear) -> tuple[tuple[str, Face], ...]:
    """Names of the faces that the tooth spaces left; space i lies between tooth i and the next, counted from 1."""
    faces = tooth.faces
    order = [face for face in faces if face.side > 0] + [face for face in faces if face.kind == "root"]
    after = [face for face in faces if face.side < 0]
    names = []
    for number, space in enumerate(cut.spaces, start=1):
        following = number % tooth.member.teeth + 1
        titles = [f"tooth {number} {face.title(tooth.member.hand)}" for face in order]
        titles += [f"tooth {following} {face.title(tooth.member.hand)}" for face in after]
        names += [(title, made) for title, left in zip(titles, space, strict=False) for made in left]
    return tuple(names)


def blank_polygon(member: MemberGeometry, outline: Floats) -> tuple[Floats, list[bool]]:
    """Closed outline (radius, height) of the blank with its face cone, and which of its sides are spheres."""
    tips = [_tip_point(member, v) for v in (1.0, 0.0)]
    points = np.vstack([tips[0], outline, tips[1]])
    sphere = [False] * len(points)
    sphere[0] = sphere[-2] = member.ends == "sphere"
    return points, sphere


def seam_azimuth(profile: ToothProfile) -> float:
    """Where the blank's faces are cut open: as far as can be from the flanks at heel and toe [rad]."""
    member = profile.member
    candidates = np.linspace(0.0, member.pitch, _SEAM_CANDIDATES)
    tip = float(profile.angles("tip", 0.0)[1])
    low, high = min(tip, profile.fillet.centre_azimuth), max(tip, profile.fillet.centre_azimuth)
    clearance = np.full_like(candidates, np.inf)
    for distance in (member.inner_cone_distance, member.outer_cone_distance):
        inside = candidates - member.lengthwise.azimuth(distance) + member.pitch / 2
        from_middle = np.abs(np.remainder(inside, member.pitch) - member.pitch / 2)
        clearance = np.minimum(clearance, np.maximum(low - from_middle, from_middle - high))
    return float(candidates[np.argmax(clearance)])


def space_faces(tooth: Tooth, target: Target) -> list[NurbsSurface]:
    """Faces once round a tooth space, reaching beyond tip and ends; their normals point into the space."""
    member = extended(tooth.member)
    profile = tooth_profile(member)
    goal = _EDGE_SHARE * target.tolerance
    flanks = {}
    for face in tooth.faces:
        if face.kind == "flank":
            surface = reversed_across(face.surface) if face.side > 0 else face.surface
            flanks[face.side] = trimmed(profile_flank(profile, face.side), surface, goal)
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


def _cap_angles(profile: ToothProfile) -> Angles:
    """The face over a tooth space, with falling azimuth."""
    middle = profile.member.pitch / 2

    def angles(x: Floats, tip: Floats) -> tuple[Floats, Floats]:
        delta, phi = profile.angles("tip", np.zeros(np.broadcast_shapes(x.shape, tip.shape)), tip)
        return delta, middle + (1 - 2 * x) * (middle - phi)

    return angles


def _turned(surface: NurbsSurface, angle: float) -> NurbsSurface:
    c, s = np.cos(angle), np.sin(angle)
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    return replace(surface, poles=surface.poles @ turn.T)


def _tip_point(member: MemberGeometry, v: float) -> Floats:
    rho_u = member.inner_cone_distance + v * member.face_width
    delta = member.limit_angle(member.tip_limit, rho_u)
    rho = member.cone_distance(rho_u, delta)
    return np.array([float(rho * np.sin(delta)), float(rho * np.cos(delta))])
