"""Whole gears: valid, closed, as large as theory says, over all that the design file permits."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st
from OCP.BRep import BRep_Tool

from gearstudio.catalogue import METHOD_IDS
from gearstudio.design import Design, with_field
from gearstudio.kernel.convert import to_record
from gearstudio.kernel.shell import assembled
from gearstudio.kernel.solids import check_solid, is_closed, is_valid, solid_volume
from gearstudio.kernel.step import read_flanks_step, write_flanks_step
from gearstudio.methods.gear import Gear, build_gear, design_tooth, target_of
from gearstudio.methods.single import tooth_solid
from gearstudio.presets import PRESETS
from gearstudio.theory.chamfer import chamfer_limits
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.pair import about_axis
from gearstudio.validation import check
from tests.designs import GOLDEN
from tests.kernel.gears import off_fillet
from tests.strategies import designs, modified_designs
from tests.volume import gear_volume

pytestmark = pytest.mark.kernel

NAMED = {**{name: design for name, (design, _) in GOLDEN.items()}, **{p.key: p.design for p in PRESETS}}
_MANY = 100 if os.environ.get("HYPOTHESIS_PROFILE") == "explore" else 12
SMALL = with_field(with_field(Design(), "pair.pinion_teeth", 9), "pair.wheel_teeth", 14)


def largest_gap(gear: Gear) -> float:
    return 5e-5 * max(1.0, gear.member.outer_cone_distance / 250)


@pytest.mark.parametrize("member", ["pinion", "wheel"])
@pytest.mark.parametrize("name", NAMED)
def test_named_designs_make_valid_gears_of_the_right_size(name: str, member: str) -> None:
    method = "rotating_line" if NAMED[name].pair.offset == 0 else "profile_sweep"
    gear = build_gear(NAMED[name], member, method, "optimised")
    assert is_valid(gear.solid)
    assert is_closed(gear.solid)
    assert gear.gap <= largest_gap(gear)
    assert solid_volume(gear.solid) == pytest.approx(gear_volume(gear.member, gear.outline.points), rel=1e-6)
    assert_as_exact_when_read_back(gear)


EXTREMES = {
    "five teeth": {"pair": {"pinion_teeth": 5}, "tooth": {"profile_shift": 0.4, "addendum_factor": 0.9}},
    "two hundred teeth": {"pair": {"pinion_teeth": 60, "wheel_teeth": 200}, "lengthwise": {"cutter_radius": 400.0}},
    "module 0.1": {"pair": {"outer_module": 0.1}, "lengthwise": {"cutter_radius": 2.0}},
    "module 100": {"pair": {"outer_module": 100.0}, "lengthwise": {"cutter_radius": 2000.0}},
    "face of 1 %": {"pair": {"face_width_factor": 0.01}},
    "face of 50 %": {"pair": {"face_width_factor": 0.5}},
    "a quarter of a millimetre": {
        "pair": {"pinion_teeth": 5, "wheel_teeth": 150, "outer_module": 0.1},
        "lengthwise": {"curve": "logarithmic"},
        "tooth": {"profile_shift": 0.4, "addendum_factor": 0.7},
    },
}


@pytest.mark.parametrize("member", ["pinion", "wheel"])
@pytest.mark.parametrize("name", EXTREMES)
def test_the_ends_of_the_permitted_range_make_valid_gears(name: str, member: str) -> None:
    design = Design.model_validate(EXTREMES[name])
    assert not [issue for issue in check(design) if issue.severity == "error"]
    gear = build_gear(design, member, "point_cloud", "optimised")
    assert is_valid(gear.solid)
    assert is_closed(gear.solid)
    assert gear.gap <= largest_gap(gear)
    assert solid_volume(gear.solid) == pytest.approx(gear_volume(gear.member, gear.outline.points), rel=1e-6)


@pytest.mark.slow
@pytest.mark.timeout(1200)
@seed(20260101)
@settings(
    max_examples=_MANY, deadline=None, database=None, phases=[Phase.generate], suppress_health_check=[*HealthCheck]
)
@given(
    design=st.one_of(designs(), modified_designs()),
    member=st.sampled_from(["pinion", "wheel"]),
    method=st.sampled_from(METHOD_IDS),
    chamfer=st.sampled_from([0.0, 0.0, 0.1, 0.5, 1.0]),
)
def test_any_valid_design_makes_a_valid_gear(design: Design, member: str, method: str, chamfer: float) -> None:
    """A dozen in every run, a hundred with ``HYPOTHESIS_PROFILE=explore``.

    Chamfers are drawn as a share of the way from the smallest to the largest; 0 for none.
    """
    if chamfer:
        least, most = chamfer_limits(pair_geometry(design).member(member))
        design = with_field(design, f"blank.{member}.end_chamfer", least + chamfer * (most - least))
    gear = build_gear(design, member, method, "optimised")
    made = check_solid(gear.solid)
    assert (made.valid, made.closed, made.shells) == (True, True, 1)
    wanted = gear_volume(gear.tooth.member, gear.outline.points, gear.outline.chamfers)
    assert made.volume == pytest.approx(wanted, rel=1e-6)
    assert gear.gap <= largest_gap(gear)
    assert_as_exact_when_read_back(gear)


def assert_as_exact_when_read_back(gear: Gear) -> None:
    """The first and the last tooth from a STEP file: flanks within 0.1 µm, fillets within 1 µm of theory."""
    scale = max(1.0, gear.member.outer_cone_distance / 250)
    faces = dict(gear.faces)
    kept = [
        (face, f"tooth {n} {face.title(gear.member.hand)}", n)
        for n in (1, gear.member.teeth)
        for face in gear.tooth.faces
    ]
    kept = [(face, name, n) for face, name, n in kept if face.kind in ("flank", "fillet")]
    with TemporaryDirectory() as folder:
        path = Path(folder) / "teeth.step"
        write_flanks_step(path, {name: to_record(BRep_Tool.Surface_s(faces[name])) for _, name, _ in kept}, "teeth")
        found = read_flanks_step(path)
    for face, name, number in kept:
        points = found[name].uniform_grid(25, 25) @ about_axis(-(number - 1) * gear.member.pitch).T
        if face.kind == "flank":
            off, most = np.abs(gear.tooth.profile.flank(face.side).deviation(points)), 1e-4
        else:
            off, most = np.abs(off_fillet(gear.tooth, face.side, points)), 1e-3
        assert off.max() < most * scale, name


@pytest.mark.parametrize("method", METHOD_IDS)
@pytest.mark.parametrize("member", ["pinion", "wheel"])
def test_the_published_variants_of_the_default_pair_make_valid_gears(member: str, method: str) -> None:
    gear = build_gear(Design(), member, method, "published")
    assert is_valid(gear.solid)
    assert gear.gap <= largest_gap(gear)


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("tooth.ends", "sphere"),
        ("tooth.tip_cone", "constant_clearance"),
        ("blank.pinion.bore_diameter", 0.0),
        ("tooth.fillet_factor", 1.0),
        ("pair.face_width_factor", 0.01),
        ("pair.face_width_factor", 0.5),
        ("pair.outer_module", 0.1),
        ("pair.outer_module", 100.0),
    ],
)
def test_every_kind_of_end_tip_body_and_root(field: str, value: object) -> None:
    design = with_field(Design(), "lengthwise.curve", "logarithmic")
    gear = build_gear(with_field(design, field, value), "pinion", "point_cloud", "optimised")
    assert is_valid(gear.solid)
    assert solid_volume(gear.solid) == pytest.approx(gear_volume(gear.member, gear.outline.points), rel=1e-6)


def test_a_shank_takes_the_place_of_the_bore() -> None:
    design = with_field(with_field(Design(), "blank.pinion.shank_diameter", 20.0), "blank.pinion.shank_length", 50.0)
    gear = build_gear(design, "pinion", "point_cloud", "optimised")
    assert is_valid(gear.solid)
    assert gear.outline.points[:, 0].min() == 0.0
    assert solid_volume(gear.solid) == pytest.approx(gear_volume(gear.member, gear.outline.points), rel=1e-6)


@pytest.mark.parametrize("member", ["pinion", "wheel"])
def test_a_single_tooth_is_a_solid(member: str) -> None:
    tooth = design_tooth(Design(), member, "profile_sweep", "optimised")
    check = check_solid(tooth_solid(tooth, target_of(Design(), tooth.member)).solid)
    assert (check.valid, check.closed, check.shells) == (True, True, 1)
    assert check.volume > 0


def test_a_gap_between_faces_is_noticed() -> None:
    gear = build_gear(SMALL, "pinion", "point_cloud", "optimised")
    surfaces = [face.surface for face in gear.tooth.faces]
    surfaces[1] = replace(surfaces[1], poles=surfaces[1].poles * 1.001)
    assert assembled(surfaces, 9, gear.outline.points, spherical_ends=False).tolerance > largest_gap(gear)
