"""Validation: every problem at once, in words that help, and never an exception."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from gearstudio.design import Design, FieldSpec, all_field_specs, field_specs, field_value, with_field
from gearstudio.errors import GeometryError, Issue
from gearstudio.presets import PRESETS
from gearstudio.validation import check, read_design
from gearstudio.validation.pair_rules import cutter_radius_range
from gearstudio.validation.rules import RULES
from tests.designs import GOLDEN

NUMBERS = [spec for spec in field_specs() if spec.kind in ("int", "float")]


def table(paths: Mapping[str, Any]) -> dict[str, Any]:
    """Nested tables from dotted keys."""
    nested: dict[str, Any] = {}
    for path, value in paths.items():
        *heads, key = path.split(".")
        place = nested
        for head in heads:
            place = place.setdefault(head, {})
        place[key] = value
    return nested


def issues_of(paths: Mapping[str, Any]) -> tuple[Issue, ...]:
    return read_design(table(paths))[1]


def codes(issues: tuple[Issue, ...], severity: str = "error") -> set[str]:
    return {issue.code for issue in issues if issue.severity == severity}


# --- sound designs


@pytest.mark.parametrize("name", GOLDEN)
def test_golden_designs_are_sound(name: str) -> None:
    assert codes(check(GOLDEN[name][0])) == set()


@pytest.mark.parametrize("preset", PRESETS, ids=lambda preset: preset.key)
def test_presets_are_sound_and_described(preset: Any) -> None:
    assert check(preset.design) == ()
    assert preset.title and preset.description and "\n" not in preset.description


def test_presets_cover_the_kinds_of_gear() -> None:
    assert len(PRESETS) >= 8
    assert len({preset.key for preset in PRESETS}) == len(PRESETS)
    designs = [preset.design for preset in PRESETS]
    assert {d.lengthwise.curve for d in designs} == {"archimedean", "circular_arc", "logarithmic"}
    assert {0.5, 20.0} <= {d.pair.outer_module for d in designs}
    assert any(d.pair.shaft_angle_deg > 90 for d in designs) and any(d.pair.shaft_angle_deg < 60 for d in designs)
    assert any((d.pair.pinion_teeth, d.pair.wheel_teeth) == (9, 41) for d in designs)


# --- single fields


def test_a_message_names_field_value_limit_and_remedy() -> None:
    (issue,) = issues_of({"pair.pinion_teeth": 3})
    assert str(issue) == "pair.pinion_teeth: 3 is below the least of 5 teeth; use 5 to 200"


@pytest.mark.parametrize("spec", NUMBERS, ids=lambda spec: spec.path)
@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (True, "true"),
        ("17", '"17"'),
        ("", "the value is empty"),
        (float("nan"), "nan"),
        (float("inf"), "inf"),
        (-1e300, "-1e+300"),
        pytest.param(10**5000, "more than 40 digits", id="huge"),
        ([1], "a list"),
        ({"a": 1}, "a table"),
        (b"17", "bytes"),
        (object(), "object"),
    ],
)
def test_nonsense_in_a_number_is_one_clear_issue(spec: FieldSpec, value: Any, shown: str) -> None:
    (issue,) = [issue for issue in issues_of({spec.path: value}) if issue.field == spec.path]
    assert issue.severity == "error"
    assert shown in issue.message
    assert f"use {spec.range_text}" in issue.message
    assert "\n" not in issue.message and len(issue.message) < 200


@pytest.mark.parametrize("value", [17.5, 17.0])
def test_numbers_of_teeth_are_whole(value: float) -> None:
    (issue,) = issues_of({"pair.wheel_teeth": value})
    assert (issue.code, issue.field) == ("not_whole", "pair.wheel_teeth")


@pytest.mark.parametrize(
    ("path", "near"),
    [
        ("pair.pinion_tooth", "pair.pinion_teeth"),
        ("lengthwise.cutterradius", "lengthwise.cutter_radius"),
        ("pinion_teeth", "pair.pinion_teeth"),
        ("tooht.backlash", "tooth"),
        ("blank.gear.bore_diameter", "blank.wheel"),
        ("formt", "format"),
    ],
)
def test_an_unknown_key_is_told_its_nearest(path: str, near: str) -> None:
    issues = issues_of({path: 1})
    assert any(issue.code == "unknown_key" and near in issue.message for issue in issues), issues


def test_values_without_effect_on_bevel_pairs_are_accepted() -> None:
    design, issues = read_design(
        table(
            {
                "pair.offset": 0,
                "lengthwise.spiral_angle_of": "wheel",
                "tooth.limit_pressure_angle_factor": 0.5,
                "depth.system": "outer_module",
            }
        )
    )
    assert issues == () and design is not None


@pytest.mark.parametrize("name", ["two\nlines", "bell\a", "x" * 121, 5, "\ud800"])
def test_a_name_is_one_line(name: Any) -> None:
    (issue,) = issues_of({"name": name})
    assert issue.field == "name" and "\n" not in issue.message


@pytest.mark.parametrize(
    ("value", "code"),
    [(7, "other_format"), (0, "other_format"), (-1, "other_format"), ("1", "not_a_format"), (True, "not_a_format")],
)
def test_other_formats_are_refused(value: Any, code: str) -> None:
    design, issues = read_design({"format": value})
    assert design is None
    assert [issue.code for issue in issues] == [code]


def test_everything_is_found_at_once() -> None:
    issues = issues_of(
        {
            "pair.pinion_teeth": 3,
            "pair.wheel_teeth": 40.5,
            "pair.pitch": 1,
            "methods.tolerance_um": 0,
            "tooth.tip_cone": "flat",
            "lengthwise.curve": "logarithmic",
            "lengthwise.spiral_angle_at": "toe",
        }
    )
    assert {issue.field for issue in issues} == {
        "pair.pinion_teeth",
        "pair.wheel_teeth",
        "pair.pitch",
        "methods.tolerance_um",
        "tooth.tip_cone",
        "lengthwise.spiral_angle_at",
    }


def test_rules_whose_fields_are_fine_still_run() -> None:
    issues = issues_of({"methods.tolerance_um": "x", "pair.face_width": 60.0})
    assert {issue.code for issue in issues} == {"not_a_number", "face_width"}


def test_rules_whose_fields_are_not_fine_keep_quiet() -> None:
    assert {issue.code for issue in issues_of({"pair.outer_module": 0, "pair.face_width": 60.0})} == {"below_minimum"}
    assert {issue.code for issue in issues_of({"pair": 5, "lengthwise.cutter_radius": 1.0})} == {"not_a_table"}


# --- geometry


@pytest.mark.parametrize(
    ("paths", "code", "field"),
    [
        ({"pair.shaft_angle_deg": 116.0}, "pitch_cone", "pair.shaft_angle_deg"),
        ({"pair.face_width": 44.0}, "face_width", "pair.face_width"),
        ({"pair.face_width": 0.01}, "face_width", "pair.face_width"),
        ({"pair.face_width_factor": 1e-9}, "face_width", "pair.face_width_factor"),
        ({"lengthwise.spiral_angle_at": "toe"}, "toe_curve", "lengthwise.spiral_angle_at"),
        (
            {
                "lengthwise.curve": "archimedean",
                "lengthwise.spiral_angle_at": "toe",
                "lengthwise.spiral_angle_deg": 55.0,
                "pair.pressure_angle_deg": 35.0,
            },
            "toe_angle",
            "lengthwise.spiral_angle_deg",
        ),
        ({"lengthwise.cutter_radius": 20.0}, "cutter_arc", "lengthwise.cutter_radius"),
        (
            {
                "lengthwise.cutter_radius": 5000.0,
                "lengthwise.spiral_angle_deg": 55.0,
                "pair.face_width_factor": 0.5,
            },
            "cutter_arc",
            "lengthwise.cutter_radius",
        ),
        (
            {"pair.pinion_teeth": 5, "pair.wheel_teeth": 30, "tooth.addendum_factor": 2.0, "tooth.profile_shift": -1.0},
            "root_cone",
            "tooth.addendum_factor",
        ),
        (
            {"tooth.addendum_factor": 0.1, "tooth.profile_shift": -1.5},
            "no_involute",
            "tooth.profile_shift",
        ),
        ({"tooth.backlash": 13.0}, "no_thickness", "tooth.backlash"),
        ({"tooth.addendum_factor": 2.0}, "no_space", "tooth.addendum_factor"),
        ({"tooth.profile_shift": 1.2}, "pointed_tip", "tooth.addendum_factor"),
        (
            {"tooth.fillet_factor": 1.0, "tooth.addendum_factor": 0.1, "tooth.clearance_factor": 0.0},
            "fillet_over_flank",
            "tooth.fillet_factor",
        ),
        ({"blank.wheel.bore_diameter": 110.0}, "blank", "blank.wheel.bore_diameter"),
        ({"blank.pinion.bore_diameter": 42.0}, "blank", "blank.pinion.bore_diameter"),
    ],
)
def test_what_makes_no_gear_is_an_error_at_its_field(paths: dict[str, Any], code: str, field: str) -> None:
    design, issues = read_design(table(paths))
    assert design is None
    assert (code, field) in {(issue.code, issue.field) for issue in issues if issue.severity == "error"}, issues


@pytest.mark.parametrize(
    ("paths", "code"),
    [
        ({"pair.pinion_teeth": 9, "pair.wheel_teeth": 41}, "interference"),
        ({"tooth.fillet_factor": 0.6}, "full_round"),
        ({"tooth.profile_shift": 1.05}, "working_depth"),
        ({"pair.pinion_teeth": 41, "pair.wheel_teeth": 17}, "larger_pinion"),
        ({"pair.shaft_angle_deg": 114.9}, "face_cone"),
        (
            {
                "tooth.addendum_factor": 0.3,
                "lengthwise.curve": "archimedean",
                "lengthwise.spiral_angle_deg": 0.0,
            },
            "contact_ratio",
        ),
        ({"pair.pinion_teeth": 9, "pair.wheel_teeth": 41, "tooth.profile_shift": 0.5}, "thin_tip"),
    ],
)
def test_what_makes_a_doubtful_gear_is_a_warning(paths: dict[str, Any], code: str) -> None:
    design, issues = read_design(table(paths))
    assert design is not None, issues
    assert code in codes(issues, "warning")


def test_the_largest_shaft_angle_leaves_the_wheel_flat() -> None:
    # A wheel of 90 degrees is a crown gear: cos(Sigma) = -z1/z2.
    largest = float(np.degrees(np.arccos(-17 / 40)))
    assert "pitch_cone" not in codes(issues_of({"pair.shaft_angle_deg": largest - 1e-6}))
    assert "pitch_cone" in codes(issues_of({"pair.shaft_angle_deg": largest + 1e-6}))


def test_half_the_cone_distance_is_the_widest_face() -> None:
    outer = 4 * np.hypot(17, 40) / 2  # at 90 degrees the pitch radii are the legs of a right-angled triangle
    assert "face_width" not in codes(issues_of({"pair.face_width": float(outer / 2) * (1 - 1e-9)}))
    assert "face_width" in codes(issues_of({"pair.face_width": float(outer / 2) * (1 + 1e-9)}))


@given(st.floats(0.01, 0.5), st.floats(0.0, np.radians(55.0)), st.floats(-3.0, 3.0).map(lambda power: 10.0**power))
def test_an_arc_crosses_two_circles_exactly_within_the_range(width: float, spiral: float, radius: float) -> None:
    mean, inner, outer = 1 - width / 2, 1 - width, 1.0
    least, most = cutter_radius_range(mean, spiral, inner, outer, np.pi / 2)
    assume(min(abs(radius / least - 1), abs(radius / most - 1)) > 1e-9)
    # Triangle of apex, cutter centre and a point of the arc: it exists when no side exceeds the other two.
    centre = float(np.sqrt(mean**2 + radius**2 - 2 * mean * radius * np.sin(spiral)))
    crosses = all(abs(centre - radius) < rho < centre + radius for rho in (inner, outer))
    assert (least < radius < most) == crosses


# --- remedies

FIRST_OFFER = re.compile(r"use (?:an?|at) .*?(?:most|least) (-?[\d.e+-]+)")


KIND = ("pair.offset", "depth.system")
"""The fields that decide which rules there are."""


@st.composite
def loose_designs(draw: st.DrawFn) -> Design:
    """Bevel designs whose fields are each within limits, whatever gear they make."""
    design = Design()
    for spec in field_specs():
        if spec.path == "name" or spec.path in KIND or not draw(st.booleans()):
            continue
        design = with_field(design, spec.path, draw(field_values(spec)))
    return design


def field_values(spec: FieldSpec) -> st.SearchStrategy[Any]:
    if spec.kind == "choice":
        return st.sampled_from(spec.choices)
    assert spec.minimum is not None and spec.maximum is not None
    if spec.kind == "int":
        return st.integers(int(spec.minimum), int(spec.maximum))
    if spec.maximum > 1000:
        return st.floats(-1.0, 3.0).map(lambda power: 10.0**power)
    return st.floats(spec.minimum, spec.maximum, exclude_min=spec.above_minimum)


@settings(max_examples=100, deadline=None)
@given(loose_designs())
def test_the_first_change_that_an_error_offers_removes_it(design: Design) -> None:
    for issue in check(design):
        offer = FIRST_OFFER.search(issue.message)
        if issue.severity == "warning" or offer is None:
            continue
        value = float(offer[1])
        spec = all_field_specs()[issue.field]
        changed = with_field(design, issue.field, int(value) if spec.kind == "int" else value)
        assert same_problem(issue) not in {same_problem(i) for i in check(changed)}, str(issue)


@settings(max_examples=12, deadline=None)
@given(loose_designs(), st.floats(-0.4, 0.4), st.sampled_from(["outer_module", "iso23509"]))
def test_offsets_and_iso_depths_are_judged_whatever_the_rest(design: Design, share: float, system: str) -> None:
    offset = share * design.pair.outer_module * design.pair.wheel_teeth
    design = with_field(with_field(design, "pair.offset", min(max(offset, -5000.0), 5000.0)), "depth.system", system)
    for issue in check(design, 0.5):
        assert issue.field in all_field_specs() and issue.message


def same_problem(issue: Issue) -> tuple[str, str]:
    """A rule, and the size or the member that breaks it."""
    return issue.code, issue.field if issue.code == "blank" else str("pinion's" in issue.message)


def test_a_rule_can_be_asked_whenever_its_own_fields_are_fine() -> None:
    for rule in RULES:
        needed = [other for other in RULES if other.code in rule.needs]
        assert len(needed) == len(rule.needs)
        assert all(other.inputs <= rule.inputs and other.severity == "error" for other in needed), rule.code
        assert all(RULES.index(other) < RULES.index(rule) for other in needed), rule.code


@pytest.mark.parametrize(
    ("fields", "code", "offer"),
    [
        ({"tip_relief_um": 400.0}, "steep_relief", "a tip relief of at most"),
        ({"lengthwise_crowning_um": -900.0, "profile_crowning_um": -900.0}, "steep_relief", "use"),
        ({"root_relief_um": 900.0, "root_relief_end": 0.9}, "steep_relief", "a root relief of at most"),
    ],
)
@pytest.mark.parametrize("member", ["pinion", "wheel"])
def test_micro_geometry_too_large_for_the_tooth(fields: dict[str, float], code: str, offer: str, member: str) -> None:
    design = Design.model_validate({"modifications": {member: {"convex": fields}}})
    (issue,) = (i for i in check(design) if i.code == code)
    assert issue.severity == "error" and issue.field.startswith(f"modifications.{member}.convex.")
    assert f"{member}'s convex flank" in issue.message and offer in issue.message


@pytest.mark.parametrize(("amount", "expected"), [(150.0, False), (250.0, True)])
def test_relief_that_leaves_no_tip_is_refused(amount: float, expected: bool) -> None:
    flanks = {key: {"tip_relief_um": amount, "tip_relief_start": 0.05} for key in ("concave", "convex")}
    design = Design.model_validate({"tooth": {"addendum_factor": 1.25}, "modifications": {"pinion": flanks}})
    assert ("pointed_relief" in codes(check(design))) == expected
    assert "pointed_tip" not in codes(check(design))


@settings(max_examples=60, deadline=None)
@given(loose_designs(), loose_designs())
def test_a_rule_reads_no_field_but_those_it_declares(design: Design, other: Design) -> None:
    expected = outcomes(design)
    for inputs in {rule.inputs for rule in RULES}:
        paths = {path: field_value(design if path in inputs else other, path) for path in all_field_specs()}
        mixed = outcomes(Design.model_validate(table(paths)))
        for rule in RULES:
            if rule.inputs == inputs:
                assert mixed[rule.code] == expected[rule.code], rule.code


def outcomes(design: Design) -> dict[str, object]:
    """What each rule says, None where it cannot be asked."""
    said: dict[str, object] = {}
    for rule in RULES:
        if any(said[code] != () for code in rule.needs):
            said[rule.code] = None
            continue
        try:
            said[rule.code] = tuple(rule.find(design))
        except GeometryError as error:
            said[rule.code] = str(error)
    return said


# --- nonsense

scalars = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.integers(5, 60),
    st.floats(),
    st.floats(-2, 100),
    st.text(max_size=5),
    st.binary(max_size=3),
    st.sampled_from(["archimedean", "circular_arc", "toe", "mean", "left", 10**400, -(10**4000), "\ud800"]),
    st.dates(),
)
keys = st.one_of(
    st.sampled_from([part for path in all_field_specs() for part in path.split(".")]),
    st.sampled_from([*all_field_specs(), "format", "depth", "taper"]),
    st.text(max_size=4),
    st.integers(),
    st.tuples(st.integers()),
)
anything = st.recursive(scalars, lambda inner: st.lists(inner, max_size=2) | st.dictionaries(keys, inner, max_size=4))
known_tables = st.dictionaries(st.sampled_from(list(all_field_specs())), scalars, max_size=12).map(table)


@settings(max_examples=300, deadline=None)
@given(st.one_of(st.dictionaries(keys, anything, max_size=6), known_tables, anything))
@example({"pair.pinion_teeth": 17})
@example({"pair": {"pinion_teeth": {"pinion_teeth": 5}}})
@example({("a", 1): 2})
@example([])
@example(None)
def test_no_nonsense_raises(data: Any) -> None:
    design, issues = read_design(data)
    assert (design is None) == any(issue.severity == "error" for issue in issues)
    assert all(issue.message and "\n" not in str(issue) for issue in issues)
    assert list(issues) == sorted(issues, key=lambda issue: issue.severity != "error")


@settings(max_examples=100, deadline=None)
@given(loose_designs())
def test_check_never_raises_and_agrees_with_reading(design: Design) -> None:
    issues = check(design)
    assert read_design(design.model_dump()) == (None if codes(issues) else design, issues)
