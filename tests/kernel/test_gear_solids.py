"""Whole gears: valid, closed, as large as theory says, over all that the design file permits."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st

from gearstudio.analysis.volume import gear_volume
from gearstudio.catalogue import METHOD_IDS
from gearstudio.design import Design, with_field
from gearstudio.kernel.convert import to_record
from gearstudio.kernel.shell import assembled
from gearstudio.kernel.solids import check_solid, is_closed, is_valid, solid_volume
from gearstudio.methods.gear import Gear, build_gear, design_tooth, target_of
from gearstudio.methods.single import tooth_solid
from gearstudio.presets import PRESETS
from gearstudio.validation import check
from tests.designs import GOLDEN
from tests.strategies import designs

pytestmark = pytest.mark.kernel

NAMED = {**{name: design for name, (design, _) in GOLDEN.items()}, **{p.key: p.design for p in PRESETS}}
SMALL = with_field(with_field(Design(), "pair.pinion_teeth", 9), "pair.wheel_teeth", 14)


def largest_gap(gear: Gear) -> float:
    return 5e-5 * max(1.0, gear.member.outer_cone_distance / 250)


@pytest.mark.parametrize("member", ["pinion", "wheel"])
@pytest.mark.parametrize("name", NAMED)
def test_named_designs_make_valid_gears_of_the_right_size(name: str, member: str) -> None:
    gear = build_gear(NAMED[name], member, "rotating_line", "optimised")
    assert is_valid(gear.solid)
    assert is_closed(gear.solid)
    assert gear.gap <= largest_gap(gear)
    assert solid_volume(gear.solid) == pytest.approx(gear_volume(gear.member, gear.outline.points), rel=1e-6)


EXTREMES = {
    "five teeth": {"pair": {"pinion_teeth": 5}, "tooth": {"profile_shift": 0.4, "addendum_factor": 0.9}},
    "two hundred teeth": {"pair": {"pinion_teeth": 60, "wheel_teeth": 200}, "lengthwise": {"cutter_radius": 400.0}},
    "module 0.1": {"pair": {"outer_module": 0.1}, "lengthwise": {"cutter_radius": 2.0}},
    "module 100": {"pair": {"outer_module": 100.0}, "lengthwise": {"cutter_radius": 2000.0}},
    "face of 1 %": {"pair": {"face_width_factor": 0.01}},
    "face of 50 %": {"pair": {"face_width_factor": 0.5}},
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


@pytest.mark.slow
@seed(20260101)
@settings(max_examples=100, deadline=None, database=None, phases=[Phase.generate], suppress_health_check=[*HealthCheck])
@given(design=designs(), member=st.sampled_from(["pinion", "wheel"]), method=st.sampled_from(METHOD_IDS))
def test_any_valid_design_makes_a_valid_gear(design: Design, member: str, method: str) -> None:
    gear = build_gear(design, member, method, "optimised")
    assert is_valid(gear.solid)
    assert is_closed(gear.solid)
    assert gear.gap <= largest_gap(gear)


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


@pytest.mark.slow
@pytest.mark.parametrize("changes", [{}, {"tooth.ends": "sphere", "tooth.tip_cone": "constant_clearance"}])
def test_both_constructions_make_the_same_gear(changes: dict[str, str]) -> None:
    design = SMALL
    for field, value in changes.items():
        design = with_field(design, field, value)
    stages: list[str] = []
    joined = build_gear(design, "pinion", "profile_sweep", "optimised")
    cut = build_gear(design, "pinion", "profile_sweep", "optimised", "cut", lambda stage, _: stages.append(stage))
    assert is_valid(cut.solid)
    assert is_closed(cut.solid)
    assert solid_volume(cut.solid) == pytest.approx(solid_volume(joined.solid), rel=1e-6)
    assert len(stages) >= 4
    names = {name for name, _ in cut.faces}
    assert names == {name for name, _ in joined.faces if not name.endswith("tip")}
    assert_same_faces(cut, joined)


def assert_same_faces(cut: Gear, joined: Gear) -> None:
    """Points of every named face of one lie on the face of the same name of the other."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
    from OCP.BRepExtrema import BRepExtrema_DistShapeShape
    from OCP.gp import gp_Pnt

    others = dict(cut.faces)
    for name, face in joined.faces[:9]:
        if name.endswith("tip"):
            continue
        points = to_record(BRep_Tool.Surface_s(face)).grid([0.1, 0.5, 0.9], [0.1, 0.5, 0.9]).reshape(-1, 3)
        for point in points:
            vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(*point.tolist())).Vertex()
            assert BRepExtrema_DistShapeShape(vertex, others[name]).Value() < 1e-4, name
