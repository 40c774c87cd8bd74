"""Rules of the mesh and of the blanks; most are warnings, for the teeth exist all the same."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gearstudio.design import Design, field_value
from gearstudio.theory.pair import interference, overlap_ratio, transverse_contact_ratio
from gearstudio.validation.nearest import cure, round_toward
from gearstudio.validation.rule import (
    ARC,
    BORES,
    DEPTH,
    PROFILE,
    TIP,
    Finding,
    Rule,
    fields,
    geometry,
    mate_of,
    members,
)
from gearstudio.validation.tooth_rules import TOOTHED

LEAST_WALL_FACTOR = 0.02


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
                f"{tooth.profile_shift:.10g} leaves the {member.name} no {part} ({height:.4g} mm): its teeth do not "
                f"reach across the pitch cone; use {f'more than {-bound:.4g}' if above else f'less than {bound:.4g}'}",
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
            f"{field_value(design, field):.10g} lets the {name}'s tip reach below the {mate.name}'s base cone, where "
            f"no conjugate flank is: the teeth interfere there; use {found.text or 'a larger pressure angle or more teeth'}",
        )


def _face_cone(design: Design) -> Iterator[Finding]:
    for member in members(design):
        if member.tip_angle >= np.pi / 2:
            yield Finding(
                "pair.shaft_angle_deg",
                f"{design.pair.shaft_angle_deg:.10g}° makes the {member.name}'s face cone, "
                f"{np.degrees(member.tip_angle):.4g}°, open backwards (above 90°), as that of an internal gear; a smaller shaft angle avoids it",
            )


def _contact_ratio(design: Design) -> Iterator[Finding]:
    pair = geometry(design)
    total = float(np.hypot(transverse_contact_ratio(pair), overlap_ratio(pair)))
    if total < 1:
        yield Finding(
            "tooth.addendum_factor",
            f"{design.tooth.addendum_factor:.10g} makes the contact ratio only {total:.3g}: a pair of teeth parts before the next one meets; "
            "a larger addendum factor, spiral angle or face width raises it",
        )


def _bore(design: Design) -> Iterator[Finding]:
    for member in members(design):
        path = f"blank.{member.name}.bore_diameter"
        bore = field_value(design, path)
        inner = member.inner_cone_distance
        toe_root = 2 * float(member.cone_distance(inner, member.root_angle) * np.sin(member.root_angle))
        if bore is not None and bore >= (1 - LEAST_WALL_FACTOR) * toe_root:
            yield Finding(
                path,
                f"{bore:.10g} mm cuts into the teeth: the root is {toe_root:.5g} mm across at the toe; "
                f"use at most {round_toward((1 - LEAST_WALL_FACTOR) * toe_root, up=False):.10g} mm",
            )


MESH_RULES = (
    Rule("working_depth", "warning", DEPTH, frozenset({"pitch_cone"}), "tooth.profile_shift", _working_depth),
    Rule("interference", "warning", PROFILE, TOOTHED, "tooth.profile_shift", _interference),
    Rule("face_cone", "warning", TIP, frozenset({"pitch_cone"}), "pair.shaft_angle_deg", _face_cone),
    Rule("contact_ratio", "warning", PROFILE | ARC, TOOTHED | {"cutter_arc"}, "tooth.addendum_factor", _contact_ratio),
    Rule(
        "bore",
        "error",
        DEPTH | ARC | fields("tooth", "ends") | BORES,
        frozenset({"face_width", "root_cone"}),
        "blank.pinion.bore_diameter",
        _bore,
    ),
)
