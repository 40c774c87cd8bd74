"""Rules of one member's teeth: a profile that exists from root to tip all along the face."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from gearstudio.design import Design
from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.involute import base_azimuth, involute_azimuth
from gearstudio.theory.pair import tip_half_azimuth
from gearstudio.validation.nearest import Cure, cure
from gearstudio.validation.rule import DEPTH, PROFILE, THICKNESS, Finding, Holds, Rule, geometry, members, present

LEAST_FLANK_FACTOR = 0.02
POINT_FACTOR = 0.005
THIN_FACTOR = 0.2
_PLACES = 9


def _member_cure(design: Design, name: str, holds: Holds, *candidates: tuple[str, float]) -> Cure:
    return cure(design, lambda changed: holds(geometry(changed).member(name)), candidates)


def _places(member: MemberGeometry) -> NDArray[np.float64]:
    """Cone distances from toe to heel, and to the heel's tip corner [mm]."""
    along = np.linspace(member.inner_cone_distance, member.outer_cone_distance, _PLACES)
    corner = float(np.hypot(member.outer_cone_distance, member.addendum))
    return np.append(along, corner) if member.ends == "back_cone" else along


def tip_angles(member: MemberGeometry) -> NDArray[np.float64]:
    """Polar angles of a tooth's tip along the face [rad]."""
    return member.tip_limit.at_sphere(_places(member))


def _flank_start(member: MemberGeometry) -> float:
    """Polar angle where the involute begins: the root cone or the base cone, the highest along the face [rad]."""
    return max(float(np.max(member.root_limit.at_sphere(_places(member)))), member.base_angle)


def _has_root(member: MemberGeometry) -> bool:
    return bool(np.min(member.root_limit.at_sphere(_places(member))) > 0)


def _root_cone(design: Design) -> Iterator[Finding]:
    for member in members(design):
        if _has_root(member):
            continue
        found = _member_cure(
            design,
            member.name,
            _has_root,
            ("tooth.addendum_factor", 0.1),
            ("tooth.clearance_factor", 0.0),
            ("tooth.profile_shift", 0.0),
        )
        yield Finding(
            found.field or "tooth.addendum_factor",
            f"{present(design, found.field or 'tooth.addendum_factor')} puts the {member.name}'s root cone at "
            f"{np.degrees(member.root_angle):.3g}°, and it must be above 0°; use {found.text or 'more teeth'}",
        )


def _has_flank(member: MemberGeometry) -> bool:
    least = LEAST_FLANK_FACTOR * member.module / member.outer_cone_distance
    tips = tip_angles(member)
    return bool(np.min(tips) >= _flank_start(member) + least and np.max(tips) < np.pi - member.base_angle)


def _no_involute(design: Design) -> Iterator[Finding]:
    for member in members(design):
        if _has_flank(member):
            continue
        tips, start = np.degrees(tip_angles(member)), np.degrees(_flank_start(member))
        cone = "base" if member.base_angle >= member.root_angle else "root"
        found = _member_cure(
            design,
            member.name,
            _has_flank,
            ("tooth.profile_shift", 0.0),
            ("tooth.addendum_factor", 2.0),
            ("tooth.addendum_factor", 0.1),
        )
        yield Finding(
            found.field or "tooth.addendum_factor",
            f"{present(design, found.field or 'tooth.addendum_factor')} puts the {member.name}'s tip at "
            f"{np.min(tips):.4g}° to {np.max(tips):.4g}° along the face and leaves no involute flank above its {cone} "
            f"cone of {start:.4g}°; use {found.text or 'another tooth depth or more teeth'}",
        )


def _has_thickness(member: MemberGeometry) -> bool:
    return member.half_tooth_azimuth > 0


def _no_thickness(design: Design) -> Iterator[Finding]:
    for member in members(design):
        if _has_thickness(member):
            continue
        found = _member_cure(design, member.name, _has_thickness, ("tooth.backlash", 0.0), ("tooth.profile_shift", 0.0))
        field = found.field or "tooth.profile_shift"
        yield Finding(
            field,
            f"{present(design, field)} leaves the {member.name}'s teeth no thickness at the pitch cone; "
            f"use {found.text or 'a smaller profile shift and backlash'}",
        )


def _has_space(member: MemberGeometry) -> bool:
    start = _flank_start(member)
    foot = base_azimuth(member) - involute_azimuth(start, member.base_angle)
    width = 2 * float(member.pitch / 2 - foot) * np.sin(start) * member.outer_cone_distance
    return bool(width > POINT_FACTOR * member.module)


def _no_space(design: Design) -> Iterator[Finding]:
    for member in members(design):
        if _has_space(member):
            continue
        found = _member_cure(
            design,
            member.name,
            _has_space,
            ("tooth.profile_shift", 0.0),
            ("tooth.addendum_factor", 0.1),
            ("pair.pressure_angle_deg", 10.0),
        )
        yield Finding(
            found.field or "tooth.profile_shift",
            f"{present(design, found.field or 'tooth.profile_shift')} makes the {member.name}'s teeth touch "
            f"each other at the foot: there is no tooth space; "
            f"use {found.text or 'a smaller profile shift or pressure angle'}",
        )


def _tip_land(member: MemberGeometry) -> float:
    """Least width of the tooth's tip, brought to the heel [mm]; -inf where the flanks end before it."""
    places = _places(member)
    try:
        half = tip_half_azimuth(member, places)
    except GeometryError:
        return -np.inf
    return float(np.min(2 * half * np.sin(member.tip_limit.at_sphere(places))) * member.outer_cone_distance)


def _has_tip(member: MemberGeometry) -> bool:
    return _tip_land(member) > POINT_FACTOR * member.module


def _pointed_tip(design: Design) -> Iterator[Finding]:
    for member in members(design):
        if _has_tip(member):
            continue
        found = _member_cure(
            design,
            member.name,
            _has_tip,
            ("tooth.addendum_factor", 0.1),
            ("tooth.profile_shift", 0.0),
            ("tooth.backlash", 0.0),
            ("pair.pressure_angle_deg", 10.0),
        )
        yield Finding(
            found.field or "tooth.addendum_factor",
            f"{present(design, found.field or 'tooth.addendum_factor')} makes the {member.name}'s flanks meet "
            "below its tip cone: the teeth are pointed; "
            f"use {found.text or 'a smaller addendum factor, profile shift or pressure angle'}",
        )


def _thin_tip(design: Design) -> Iterator[Finding]:
    for member in members(design):
        land = _tip_land(member)
        if land <= THIN_FACTOR * member.module:
            yield Finding(
                "tooth.addendum_factor",
                f"{present(design, 'tooth.addendum_factor')} makes the {member.name}'s tip only {land:.3g} mm wide "
                f"at the heel, less than {THIN_FACTOR:g} modules; "
                "a smaller addendum factor or profile shift makes it wider",
            )


_SOUND = frozenset({"face_width", "toe_angle", "root_cone"})
FLANKED = _SOUND | {"no_involute"}
TOOTHED = FLANKED | {"no_thickness"}
TOOTH_RULES = (
    Rule("root_cone", "error", DEPTH, frozenset({"pitch_cone"}), "tooth.addendum_factor", _root_cone),
    Rule("no_involute", "error", PROFILE, _SOUND, "tooth.addendum_factor", _no_involute),
    Rule("no_thickness", "error", THICKNESS, _SOUND, "tooth.backlash", _no_thickness),
    Rule("no_space", "error", THICKNESS, TOOTHED, "tooth.profile_shift", _no_space),
    Rule("pointed_tip", "error", THICKNESS, TOOTHED, "tooth.addendum_factor", _pointed_tip),
    Rule("thin_tip", "warning", THICKNESS, TOOTHED | {"pointed_tip"}, "tooth.addendum_factor", _thin_tip),
)
