"""Rules of the mesh and of the blanks; most are warnings, for the teeth exist all the same."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from gearstudio.design import Design, field_value
from gearstudio.theory.blank import BlankError, BlankSizes, blank_outline
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.fillet import Fillet, fillet
from gearstudio.theory.pair import interference, total_contact_ratio
from gearstudio.validation.nearest import Cure, cure
from gearstudio.validation.rule import (
    ARC,
    BLANKS,
    DEPTH,
    PROFILE,
    THICKNESS,
    TIP,
    Finding,
    Rule,
    fields,
    geometry,
    mate_of,
    members,
    present,
)
from gearstudio.validation.tooth_rules import FLANKED, LEAST_FLANK_FACTOR, TOOTHED, tip_angles


def _working_depth(design: Design) -> Iterator[Finding]:
    tooth = design.tooth
    for member in members(design):
        for part, height in (("addendum", member.addendum), ("dedendum", member.dedendum)):
            if height > 0:
                continue
            bound = tooth.addendum_factor + (tooth.clearance_factor if part == "dedendum" else 0.0)
            above = (member.name == "pinion") == (part == "addendum")
            yield Finding(
                "tooth.profile_shift",
                f"{present(design, 'tooth.profile_shift')} leaves the {member.name} no {part} ({height:.4g} mm): its "
                "teeth do not reach across the pitch cone; "
                f"use {f'more than {-bound:.4g}' if above else f'less than {bound:.4g}'}",
            )


def _interference(design: Design) -> Iterator[Finding]:
    pair = geometry(design)
    for member in members(design):
        mate = mate_of(pair, member)
        if interference(pair, member) <= 0:
            continue
        name = member.name

        def clears(changed: Design, name: str = name) -> bool:
            pair = geometry(changed)
            return interference(pair, pair.member(name)) <= 0

        found = cure(
            design,
            clears,
            [("tooth.profile_shift", 1.5 if mate.name == "pinion" else -1.5), ("tooth.addendum_factor", 0.1)],
        )
        field = found.field or "tooth.profile_shift"
        yield Finding(
            field,
            f"{present(design, field)} lets the {name}'s tip reach below the {mate.name}'s base cone, where "
            "no conjugate flank is: the teeth interfere there; "
            f"use {found.text or 'a larger pressure angle or more teeth'}",
        )


def _with_common_root(design: Design) -> list[MemberGeometry]:
    """The members whose root cone shares the apex: one profile is enough to judge their fillets."""
    return [member for member in members(design) if member.root_limit.offset == 0]


def _full_round(design: Design) -> Iterator[Finding]:
    for member in _with_common_root(design):
        made = fillet(member)
        if made.full_round:
            found = _fillet_cure(design, member.name, lambda _, fillet: not fillet.full_round)
            yield Finding(
                "tooth.fillet_factor",
                f"{design.tooth.fillet_factor:.10g} makes the {member.name}'s fillets overlap: its root is rounded "
                f"fully, with a radius of {made.radius * member.outer_cone_distance:.4g} mm instead of "
                f"{member.fillet_radius:.4g} mm; use {found.text or 'a smaller one'} to keep a root land",
            )


def _leaves_flank(member: MemberGeometry, made: Fillet) -> bool:
    least = LEAST_FLANK_FACTOR * member.module / member.outer_cone_distance
    return bool(made.foot_angle + least <= np.min(tip_angles(member)))


def _fillet_over_flank(design: Design) -> Iterator[Finding]:
    for member in _with_common_root(design):
        if not _leaves_flank(member, fillet(member)):
            found = _fillet_cure(design, member.name, _leaves_flank)
            yield Finding(
                "tooth.fillet_factor",
                f"{design.tooth.fillet_factor:.10g} makes the {member.name}'s fillet reach its tip: no flank is left; "
                f"use {found.text or 'a smaller fillet factor or deeper teeth'}",
            )


def _fillet_in_mesh(design: Design) -> Iterator[Finding]:
    for member in _with_common_root(design):
        if not _clears_mate(design, member.name):
            found = cure(
                design,
                lambda changed, name=member.name: _clears_mate(changed, name),  # type: ignore[misc]
                [("tooth.fillet_factor", 0.01), ("tooth.clearance_factor", 1.0)],
            )
            yield Finding(
                found.field or "tooth.fillet_factor",
                f"{field_value(design, found.field or 'tooth.fillet_factor'):.10g} lets the {member.name}'s fillet "
                f"reach into the flank that meets the mate's tip; use {found.text or 'a smaller fillet factor'}",
            )


def _clears_mate(design: Design, name: str) -> bool:
    """Whether a member's fillet ends below the arc at which the mate's tip meets its flank (theory 8)."""
    pair = geometry(design)
    member = pair.member(name)
    made = fillet(member)
    past_base = interference(pair, mate_of(pair, member))
    return made.on_meridian or past_base >= 0 or made.foot_arc <= -past_base


def _fillet_cure(design: Design, name: str, holds: Callable[[MemberGeometry, Fillet], bool]) -> Cure:
    def works(changed: Design) -> bool:
        member = geometry(changed).member(name)
        return holds(member, fillet(member))

    return cure(design, works, [("tooth.fillet_factor", 0.01)])


def _face_cone(design: Design) -> Iterator[Finding]:
    for member in members(design):
        if member.tip_angle >= np.pi / 2:
            yield Finding(
                "pair.shaft_angle_deg",
                f"{design.pair.shaft_angle_deg:.10g}° makes the {member.name}'s face cone, "
                f"{np.degrees(member.tip_angle):.4g}°, open backwards (above 90°) as that of an internal gear; "
                "a smaller shaft angle avoids it",
            )


def _contact_ratio(design: Design) -> Iterator[Finding]:
    pair = geometry(design)
    total = total_contact_ratio(pair)
    if total < 1:
        yield Finding(
            "tooth.addendum_factor",
            f"{present(design, 'tooth.addendum_factor')} makes the contact ratio only {total:.3g}: a pair of teeth "
            "parts before the next one meets; a larger addendum factor, spiral angle or face width raises it",
        )


def _blank(design: Design) -> Iterator[Finding]:
    for member in members(design):
        try:
            blank_outline(member, BlankSizes(**getattr(design.blank, member.name).model_dump()))
        except BlankError as error:
            yield Finding(f"blank.{member.name}.{error.field}", error.reason)


FILLET = THICKNESS | fields("tooth", "fillet_factor")
FILLETED = TOOTHED | {"no_space", "pointed_tip"}
MESH_RULES = (
    Rule("working_depth", "warning", DEPTH, frozenset({"pitch_cone"}), "tooth.profile_shift", _working_depth),
    Rule("full_round", "warning", FILLET, FILLETED, "tooth.fillet_factor", _full_round),
    Rule("fillet_over_flank", "error", FILLET, FILLETED, "tooth.fillet_factor", _fillet_over_flank),
    Rule("fillet_in_mesh", "warning", FILLET, FILLETED | {"fillet_over_flank"}, "tooth.fillet_factor", _fillet_in_mesh),
    Rule("interference", "warning", PROFILE, FLANKED, "tooth.profile_shift", _interference),
    Rule("face_cone", "warning", TIP, frozenset({"pitch_cone"}), "pair.shaft_angle_deg", _face_cone),
    Rule("contact_ratio", "warning", PROFILE | ARC, FLANKED | {"cutter_arc"}, "tooth.addendum_factor", _contact_ratio),
    Rule(
        "blank",
        "error",
        PROFILE | ARC | BLANKS,
        frozenset({"face_width", "root_cone"}),
        "blank.pinion.bore_diameter",
        _blank,
    ),
)
