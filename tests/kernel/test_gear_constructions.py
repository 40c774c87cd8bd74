"""Assembled and cut gears are the same: volume, names, and every face of either on the other's."""

from __future__ import annotations

import os
import random

import pytest
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
from OCP.BRepExtrema import BRepExtrema_DistShapeShape
from OCP.gp import gp_Pnt
from OCP.TopAbs import TopAbs_ShapeEnum

from gearstudio.kernel.cutting import Face, compound, parts
from gearstudio.kernel.solids import is_closed, is_valid, measured_gap, solid_volume
from gearstudio.methods.gear import Gear, build_gear
from tests.kernel.gears import Changes, by_name, changed, points_inside
from tests.volume import gear_volume

pytestmark = pytest.mark.kernel

SMALL = {"pair.pinion_teeth": 9, "pair.wheel_teeth": 14}
SPHERES = {"tooth.ends": "sphere", "tooth.tip_cone": "constant_clearance", "blank.pinion.end_chamfer": 0.6}
STEPPED = {"blank.wheel.hub_diameter": 20.0, "blank.wheel.hub_length": 14.0, "blank.wheel.end_chamfer": 1.5}
STRAIGHT = {"lengthwise.curve": "archimedean", "lengthwise.spiral_angle_deg": 0.0, "tooth.fillet_factor": 1.0}
SHANK = {"blank.pinion.shank_diameter": 10.0, "blank.pinion.shank_length": 20.0}
CASES = [
    pytest.param({}, "pinion", id="plain"),
    pytest.param(SPHERES, "pinion", id="spheres", marks=pytest.mark.slow),
    pytest.param(STEPPED, "wheel", id="stepped", marks=pytest.mark.slow),
    pytest.param(STRAIGHT, "wheel", id="straight", marks=pytest.mark.slow),
    pytest.param(SHANK, "pinion", id="shank", marks=pytest.mark.slow),
]
NEAR = 1e-5


@pytest.mark.parametrize(("changes", "member"), CASES)
def test_both_constructions_make_the_same_gear(changes: Changes, member: str) -> None:
    design = changed({**SMALL, **changes})
    told: list[float] = []
    joined = build_gear(design, member, "profile_sweep", "optimised")
    cut = build_gear(design, member, "profile_sweep", "optimised", "cut", lambda _, share: told.append(share))
    assert is_valid(cut.solid)
    assert is_closed(cut.solid)
    assert solid_volume(cut.solid) == pytest.approx(solid_volume(joined.solid), rel=1e-6)
    assert len(told) >= 6
    assert told == sorted(told)
    assert_alike(cut, joined)


FIVE = {"pair.pinion_teeth": 5, "tooth.profile_shift": 0.4, "tooth.addendum_factor": 0.9}
EXTREMES = [
    pytest.param(FIVE, "pinion", id="five teeth"),
    pytest.param({"pair.outer_module": 0.1, "lengthwise.cutter_radius": 2.0}, "pinion", id="module 0.1"),
    pytest.param({"pair.face_width_factor": 0.01}, "pinion", id="face of 1 %"),
    pytest.param({"pair.face_width_factor": 0.5}, "pinion", id="face of 50 %", marks=pytest.mark.slow),
    pytest.param(
        {**FIVE, "pair.outer_module": 100.0, "lengthwise.cutter_radius": 2000.0},
        "pinion",
        id="module 100",
        marks=pytest.mark.slow,
    ),
    pytest.param(
        {"pair.pinion_teeth": 60, "pair.wheel_teeth": 200, "lengthwise.cutter_radius": 400.0},
        "wheel",
        id="two hundred teeth",
        marks=[
            pytest.mark.slow,
            pytest.mark.timeout(900),
            pytest.mark.skipif(os.environ.get("HYPOTHESIS_PROFILE") != "explore", reason="takes two minutes"),
        ],
    ),
]


@pytest.mark.parametrize(("changes", "member"), EXTREMES)
def test_spaces_are_cut_at_the_ends_of_the_permitted_range(changes: Changes, member: str) -> None:
    cut = build_gear(changed(changes), member, "profile_sweep", "optimised", "cut")
    assert is_valid(cut.solid)
    assert is_closed(cut.solid)
    assert measured_gap(cut.solid) <= 5e-5 * max(1.0, cut.member.outer_cone_distance / 250)
    assert solid_volume(cut.solid) == pytest.approx(gear_volume(cut.member, cut.outline.points), rel=1e-6)
    names = {name for name, _ in cut.faces}
    assert {f"tooth {n} {part}" for n in range(1, cut.member.teeth + 1) for part in ("concave", "convex")} <= names


def assert_alike(cut: Gear, joined: Gear) -> None:
    """Every face has a name and lies on the faces of that name of the other gear: the body, the last tooth, others."""
    made = [by_name(gear.faces) for gear in (cut, joined)]
    for gear, faces in zip((cut, joined), made, strict=True):
        assert sum(map(len, faces.values())) == len(parts(gear.solid, TopAbs_ShapeEnum.TopAbs_FACE))
        assert 0 < measured_gap(gear.solid) <= gear.gap * (1 + 1e-9) <= 5e-5
    assert made[0].keys() == made[1].keys()
    teeth = {1, joined.member.teeth, *random.Random(7).sample(range(2, joined.member.teeth), 2)}
    looked_at = [name for name in made[0] if not name.startswith("tooth") or int(name.split()[1]) in teeth]
    for ours, theirs in (made, made[::-1]):
        for name in looked_at:
            assert farthest(ours[name], theirs[name]) < NEAR, name


def farthest(faces: list[Face], others: list[Face]) -> float:
    """Largest distance of points inside faces from other faces [mm]."""
    there = compound(list(others))
    distances = []
    for point in (point for face in faces for point in points_inside(face)):
        vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(*point.tolist())).Vertex()
        distances.append(float(BRepExtrema_DistShapeShape(vertex, there).Value()))
    assert distances, "no point inside the face"
    return max(distances)


def test_a_face_that_lies_elsewhere_is_noticed() -> None:
    gear = build_gear(changed(SMALL), "pinion", "profile_sweep", "optimised")
    faces = by_name(gear.faces)
    assert farthest(faces["tooth 1 concave"], faces["tooth 2 concave"]) > 1.0
