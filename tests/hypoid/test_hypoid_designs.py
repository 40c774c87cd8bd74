"""Pairs with offset axes from the design file on: what the design means, and that everything follows it."""

from __future__ import annotations

import re
from dataclasses import asdict, fields, replace
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings

from gearstudio.analysis.comparison import build_variant
from gearstudio.analysis.contact import contact_analysis
from gearstudio.analysis.contact_placing import Misalignment
from gearstudio.analysis.datasheet import data_sheet
from gearstudio.analysis.measurement import MeasuredPoints, measure
from gearstudio.cli import main
from gearstudio.cli.info import info
from gearstudio.design import Design, with_field
from gearstudio.exchange.points import point_cloud
from gearstudio.presets import PRESETS
from gearstudio.project import design_text
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.hypoid.conjugate import pinion_flank
from gearstudio.theory.hypoid.design import hypoid_input
from gearstudio.theory.hypoid.inputs import HypoidInput
from gearstudio.theory.involute_flank import InvoluteFlank
from gearstudio.theory.modified import flank_of
from gearstudio.validation import check, read_design
from tests.strategies import offset_designs
from tests.theory.hypoid.pairs import PAIRS, REFERENCE, reference_input

OFFSETS = {preset.key: preset.design for preset in PRESETS if preset.design.pair.offset}
CAR = OFFSETS["hypoid-car"]
U, V = np.linspace(0.0, 1.0, 7)[:, None], np.linspace(0.0, 1.0, 9)


def design_of(given: HypoidInput) -> Design:
    """The design that says the same."""
    pair = {
        "pinion_teeth": given.pinion_teeth,
        "wheel_teeth": given.wheel_teeth,
        "shaft_angle_deg": given.shaft_angle_deg,
        "outer_module": given.wheel_outer_pitch_diameter / given.wheel_teeth,
        "pressure_angle_deg": given.pressure_angle_deg,
        "face_width": given.face_width,
        "pinion_hand": given.pinion_hand,
        "offset": given.offset,
    }
    lengthwise = {
        "curve": given.curve,
        "spiral_angle_deg": given.spiral_angle_deg,
        "cutter_radius": given.cutter_radius,
        "spiral_angle_of": given.spiral_angle_of,
    }
    tooth = {
        "backlash": given.backlash,
        "fillet_factor": given.fillet_factor,
        "ends": given.ends,
        "limit_pressure_angle_factor": given.limit_pressure_angle_factor,
    }
    depth = {"system": "iso23509", **asdict(given.depth)}
    return Design.model_validate({"pair": pair, "lengthwise": lengthwise, "tooth": tooth, "depth": depth})


@pytest.mark.parametrize("given", [*PAIRS.values(), *(reference_input(record) for record in REFERENCE)])
def test_a_design_says_all_there_is_to_say(given: HypoidInput) -> None:
    found = hypoid_input(design_of(given))
    assert found.wheel_outer_pitch_diameter == pytest.approx(given.wheel_outer_pitch_diameter, rel=1e-15)
    assert replace(found, wheel_outer_pitch_diameter=given.wheel_outer_pitch_diameter) == given


def test_presets_of_both_signs_and_other_shaft_angles() -> None:
    offsets = [design.pair.offset for design in OFFSETS.values()]
    assert sum(offset > 0 for offset in offsets) >= 3 and min(offsets) < 0
    assert any(design.pair.shaft_angle_deg != 90 for design in OFFSETS.values())


@pytest.mark.parametrize("shift", [0.0, 0.3])
def test_a_vanishing_offset_tends_to_the_bevel_pair(shift: float) -> None:
    bevel = Design.model_validate(
        {"tooth": {"tip_cone": "constant_clearance", "profile_shift": shift, "backlash": 0.1, "ends": "sphere"}}
    )
    near, exact = (pair_geometry(with_field(bevel, "pair.offset", offset)) for offset in (1e-6, 0.0))
    assert near.has_offset and not exact.has_offset
    for name in ("pinion", "wheel"):
        for field in fields(exact.member(name)):
            value = getattr(exact.member(name), field.name)
            if isinstance(value, float):
                assert getattr(near.member(name), field.name) == pytest.approx(value, abs=1e-6), field.name
        for flank in FLANKS:
            theory = flank_of(exact.member(name), flank)
            above = np.linspace(0.3, 1.0, 5)[:, None]
            assert np.abs(theory.deviation(flank_of(near.member(name), flank).points(above, V))).max() < 1e-6


@pytest.mark.parametrize("taper", ["standard", "uniform", "duplex", "tilted_root"])
def test_iso_depths_of_a_bevel_pair_keep_the_flanks(taper: str) -> None:
    design = with_field(with_field(Design(), "depth.system", "iso23509"), "depth.taper", taper)
    pair = pair_geometry(design)
    assert not pair.has_offset and pair.hypoid is not None
    for name in FLANKS:
        conjugate = pinion_flank(pair.hypoid, name)
        assert np.abs(flank_of(pair.pinion, name).deviation(conjugate.points(U, V))).max() < 1e-10
    assert contact_analysis(pair, points=(20, 30), positions=12).drive.peak_to_peak_arcsec < 0.01


@pytest.mark.parametrize("key", OFFSETS)
def test_a_conjugate_pair_transmits_evenly_and_its_reference_does_not(key: str) -> None:
    pair = pair_geometry(OFFSETS[key])
    found = contact_analysis(pair, points=(20, 30), positions=12)
    own = contact_analysis(replace(pair, own_cone_pinion=True), points=(20, 30), positions=12)
    for name in ("drive", "coast"):
        side = found.direction(name)  # type: ignore[arg-type]
        assert side.peak_to_peak_arcsec <= 0.01
        assert np.abs(side.error_arcsec).max() <= 0.01
        assert np.abs(side.ease_off_um).max() < 1e-4
        assert own.direction(name).peak_to_peak_arcsec > 20  # type: ignore[arg-type]
    assert found.play_mm == pytest.approx(OFFSETS[key].tooth.backlash, abs=1e-6)


@settings(max_examples=10, deadline=None, suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow])
@given(offset_designs())
def test_random_pairs_transmit_evenly(design: Design) -> None:
    pair = pair_geometry(design)
    found = contact_analysis(pair, points=(16, 24), positions=8)
    assert max(found.drive.peak_to_peak_arcsec, found.coast.peak_to_peak_arcsec) <= 0.01
    assert found.play_mm == pytest.approx(design.tooth.backlash, abs=1e-6)


def test_misalignments_act_on_both_sides() -> None:
    pair = pair_geometry(CAR)
    for misalignment in (Misalignment(offset=0.05), Misalignment(shaft_angle_deg=0.05)):
        found = contact_analysis(pair, misalignment, points=(20, 30), positions=12)
        assert max(found.drive.peak_to_peak_arcsec, found.coast.peak_to_peak_arcsec) > 0.1


@pytest.mark.parametrize("member", ["pinion", "wheel"])
@pytest.mark.parametrize("key", ["hypoid-car", "hypoid-negative"])
def test_methods_on_members_with_offset_axes(key: str, member: str) -> None:
    for method in ("profile_sweep", "point_cloud"):
        assert build_variant(OFFSETS[key], member, method, "optimised", (41, 41)).statistics.max_um < 0.1
    line = build_variant(OFFSETS[key], member, "rotating_line", "optimised", (41, 41))
    if member == "wheel":
        assert line.statistics.max_um < 0.1
        return
    assert line.settings["line"] == "best fit"
    pair = pair_geometry(OFFSETS[key])
    assert pair.hypoid is not None
    conjugate = [pinion_flank(pair.hypoid, name) for name in FLANKS]
    own = max(np.abs(InvoluteFlank(f.member, f.side).deviation(f.points(U, V))).max() for f in conjugate) * 1e3
    assert 5.0 < line.statistics.max_um < 0.5 * own


def test_micro_geometry_of_a_conjugate_pinion() -> None:
    taken = {"lengthwise_crowning_um": 30.0, "profile_crowning_um": 10.0}
    design = Design.model_validate({**CAR.model_dump(), "modifications": {"pinion": {"concave": taken}}})
    plain, crowned = (flank_of(pair_geometry(one).pinion, "concave") for one in (CAR, design))
    points = crowned.points(U, V)
    assert np.abs(crowned.deviation(points)).max() < 1e-9
    wanted = 0.03 * (2 * V - 1) ** 2 + 0.01 * (2 * U - 1) ** 2
    assert np.abs(plain.deviation(points) + wanted).max() < 1e-3
    side = contact_analysis(pair_geometry(design), points=(30, 40), positions=12).drive
    assert side.peak_to_peak_arcsec > 1 and side.pattern_share < 0.9


@pytest.mark.parametrize("member", ["pinion", "wheel"])
def test_nominal_points_measure_as_nominal(member: str) -> None:
    geometry = pair_geometry(CAR)
    clouds = [point_cloud(flank_of(geometry.member(member), name), 9, 7, "uniform") for name in FLANKS]
    points = np.concatenate([cloud.points.reshape(-1, 3) for cloud in clouds])
    normals = np.concatenate([cloud.normals.reshape(-1, 3) for cloud in clouds])
    found = measure(geometry, member, [MeasuredPoints(points, normals)])
    assert np.abs(found.deviation_um).max() < 1e-3


@pytest.mark.parametrize(
    ("offset", "field"),
    [(60.0, "depth.mean_addendum_factor"), (80.0, "lengthwise.spiral_angle_deg"), (500.0, "pair.offset")],
)
def test_offsets_that_cannot_be_are_refused_with_a_value_that_can(offset: float, field: str) -> None:
    issues = check(with_field(CAR, "pair.offset", offset))
    assert issues and issues[0].severity == "error" and "use" in issues[0].message
    found = re.search(r"at least ([\d.]+)°|use (-?[\d.]+) mm or nearer", issues[0].message)
    assert issues[0].field == field or found is not None
    if found is not None and found[2]:
        other = check(with_field(CAR, "pair.offset", float(found[2])), 0.1)
        assert "admits no pitch cones" not in " ".join(issue.message for issue in other)


def test_undercut_says_where_and_what_cures_it() -> None:
    negative = OFFSETS["hypoid-negative"]
    (issue, *_) = check(with_field(negative, "depth.system", "outer_module"))
    assert issue.code == "undercut" and "polar angle" in issue.message
    found = re.search(r"a profile shift of at least ([\d.]+)", issue.message)
    assert issue.field == "tooth.profile_shift" and found is not None
    cured = with_field(with_field(negative, "depth.system", "outer_module"), issue.field, float(found[1]))
    assert "undercut" not in {other.code for other in check(cured, 0.1)}


@pytest.mark.parametrize(
    ("path", "value"), [("pair.pressure_angle_kind", "transverse"), ("lengthwise.spiral_angle_at", "toe")]
)
def test_angles_that_have_no_meaning_with_an_offset(path: str, value: str) -> None:
    design = with_field(with_field(CAR, "lengthwise.curve", "archimedean"), path, value)
    assert path in {issue.field for issue in check(design, 0.1)}


def test_info_and_data_sheet_have_the_standards_names() -> None:
    found: dict[str, Any] = info(CAR)
    assert found["pair"]["offset"] == 25.4
    assert found["pair"]["pinion_spiral_angle_deg"] == pytest.approx(48.0)
    assert found["wheel"]["convex"]["base_angle_deg"] != pytest.approx(found["wheel"]["concave"]["base_angle_deg"])
    sheet = data_sheet(CAR)
    for key in ("zeta_mp", "alpha_lim", "a_p", "t_zF", "delta_iso", "h_amc"):
        assert np.isfinite(sheet.get(key, "wheel").value)
    assert sheet.get("delta_iso", "pinion").value == pytest.approx(sheet.get("delta", "pinion").value, abs=0.1)


def test_a_design_file_keeps_all_of_it() -> None:
    import tomllib

    for design in OFFSETS.values():
        assert read_design(tomllib.loads(design_text(design))) == (design, ())


def test_the_reference_pinion_on_the_command_line(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["contact", "preset:default", "--pinion", "own_cone"]) == 2
    assert "offset" in capsys.readouterr().err


def test_a_wheel_angle_at_which_the_pinion_would_be_flat_is_passed_over() -> None:
    """At a shaft angle of 91° a wheel of 1°, the first that is tried, would have a pinion of 90°."""
    pair = {"pinion_teeth": 7, "wheel_teeth": 19, "outer_module": 22.5559, "face_width": 59.45, "offset": 4.2856}
    lengthwise = {"curve": "archimedean", "spiral_angle_deg": 42.988}
    design = Design.model_validate(
        {"pair": {**pair, "shaft_angle_deg": 91.0}, "lengthwise": lengthwise, "depth": {"system": "iso23509"}}
    )
    assert pair_geometry(design).wheel.pitch_angle == pytest.approx(np.radians(71.0), abs=0.03)
