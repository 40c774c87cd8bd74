"""Chamfers at the ends of the teeth: where they are, how much they take away, and which cannot be made."""

from __future__ import annotations

import numpy as np
import pytest

from gearstudio.catalogue import METHOD_IDS
from gearstudio.kernel.solids import is_closed, is_valid, measured_gap, solid_volume
from gearstudio.methods.gear import blank_sizes, build_gear, design_tooth, target_of
from gearstudio.methods.gear_mesh import gear_mesh, tooth_mesh
from gearstudio.methods.single import tooth_names, tooth_solid
from gearstudio.presets import PRESETS_BY_KEY
from gearstudio.theory.blank import BlankError, blank_outline
from gearstudio.theory.chamfer import chamfer_limits, end_point
from gearstudio.theory.cones import pair_geometry
from gearstudio.validation import check
from tests.kernel.gears import Changes, by_name, changed, points_inside
from tests.volume import gear_volume

pytestmark = pytest.mark.kernel

CASES: list[tuple[Changes, str, float]] = [
    ({}, "wheel", 0.5),
    ({}, "pinion", 3.0),
    ({"tooth.ends": "sphere", "tooth.fillet_factor": 1.0}, "pinion", 5.0),
    ({"tooth.tip_cone": "constant_clearance", "pair.wheel_teeth": 17}, "wheel", 1.0),
    ({"lengthwise.curve": "archimedean", "lengthwise.spiral_angle_deg": 0.0}, "wheel", 2.0),
    ({"pair.face_width_factor": 0.02}, "pinion", 0.4),
]


@pytest.mark.parametrize(("changes", "member", "length"), CASES)
@pytest.mark.parametrize("variant", ["published", "optimised"])
def test_chamfered_gears_are_valid_and_of_the_right_size(
    changes: Changes, member: str, length: float, variant: str
) -> None:
    design = changed({**changes, f"blank.{member}.end_chamfer": length})
    method = METHOD_IDS[int(10 * length) % len(METHOD_IDS)]
    gear = build_gear(design, member, method, variant)
    assert is_valid(gear.solid)
    assert is_closed(gear.solid)
    assert measured_gap(gear.solid) <= gear.gap <= 5e-5
    if variant == "optimised":
        wanted = gear_volume(gear.member, gear.outline.points, gear.outline.chamfers)
        assert solid_volume(gear.solid) == pytest.approx(wanted, rel=1e-6)
        assert wanted < gear_volume(gear.member, gear.outline.points)


@pytest.mark.parametrize("method", METHOD_IDS)
@pytest.mark.parametrize("member", ["pinion", "wheel"])
def test_every_method_takes_chamfers(method: str, member: str) -> None:
    gear = build_gear(changed({f"blank.{member}.end_chamfer": 1.5}), member, method, "optimised")
    assert is_valid(gear.solid)
    wanted = gear_volume(gear.member, gear.outline.points, gear.outline.chamfers)
    assert solid_volume(gear.solid) == pytest.approx(wanted, rel=1e-6)


@pytest.mark.parametrize("ends", ["back_cone", "sphere"])
def test_each_tooth_has_one_at_either_end_as_long_as_asked(ends: str) -> None:
    design = changed({"tooth.ends": ends, "blank.pinion.end_chamfer": 2.0})
    gear = build_gear(design, "pinion", "point_cloud", "optimised")
    faces = by_name(gear.faces)
    toe, heel = gear.outline.chamfers
    for chamfer in (toe, heel):
        corner = end_point(gear.member, gear.member.tip_limit, float(chamfer.heel))
        assert np.linalg.norm(corner - chamfer.face) == pytest.approx(2.0)
        assert np.linalg.norm(corner - chamfer.foot) == pytest.approx(2.0, rel=1e-3)
        rho = np.hypot(*np.array([corner, chamfer.foot]).T)
        assert ends != "sphere" or rho[0] == pytest.approx(rho[1])
        for tooth in range(1, gear.member.teeth + 1):
            (face,) = faces[f"tooth {tooth} {chamfer.title}"]
            assert np.abs(chamfer.beyond(points_inside(face))).max() < 1e-9
    for name in ("concave", "convex", "tip", "heel end"):
        for chamfer in (toe, heel):
            assert chamfer.beyond(points_inside(faces[name if "end" in name else f"tooth 3 {name}"][0])).max() < 0


@pytest.mark.parametrize("member", ["pinion", "wheel"])
def test_meshes_and_single_teeth_have_them_too(member: str) -> None:
    design = changed({f"blank.{member}.end_chamfer": 2.0})
    gear = build_gear(design, member, "rotating_line", "optimised")
    whole = gear_mesh(gear.tooth, gear.outline.points, 0.004)
    assert whole.is_closed
    assert whole.volume == pytest.approx(solid_volume(gear.solid), rel=1e-4)
    on_teeth = whole.points[np.unique(np.concatenate([whole.groups[name] for name in ("concave", "convex", "tip")]))]
    assert max(chamfer.beyond(on_teeth).max() for chamfer in gear.outline.chamfers) < 1e-6
    tooth = design_tooth(design, member, "rotating_line", "optimised")
    shell, single = tooth_solid(tooth, target_of(design, tooth.member)), tooth_mesh(tooth, 0.004)
    assert is_valid(shell.solid)
    assert single.is_closed
    assert single.volume == pytest.approx(solid_volume(shell.solid), rel=1e-3)
    assert [name for name, _ in tooth_names(tooth, shell)][-2:] == ["toe chamfer", "heel chamfer"]


@pytest.mark.parametrize("preset", ["default", "automotive"])
@pytest.mark.parametrize("member", ["pinion", "wheel"])
def test_the_largest_can_be_made_and_a_larger_one_is_refused_with_the_limit(preset: str, member: str) -> None:
    design = PRESETS_BY_KEY[preset].design
    geometry = pair_geometry(design).member(member)
    least, most = chamfer_limits(geometry)
    field = f"blank.{member}.end_chamfer"
    for length in (least, most):
        gear = build_gear(changed({field: length}, design), member, "point_cloud", "optimised")
        assert is_valid(gear.solid)
        wanted = gear_volume(gear.member, gear.outline.points, gear.outline.chamfers)
        assert solid_volume(gear.solid) == pytest.approx(wanted, rel=1e-6)
    for length, words in ((1.01 * most, "use at most"), (0.5 * least, "use 0 for none, or at least")):
        wrong = changed({field: length}, design)
        with pytest.raises(BlankError, match=words) as told:
            blank_outline(geometry, blank_sizes(wrong, member))
        assert [issue.field for issue in check(wrong) if issue.severity == "error"] == [field]
        offered = float(str(told.value).rsplit(" mm", 1)[0].rsplit(" ", 1)[1])
        assert blank_outline(geometry, blank_sizes(changed({field: offered}, design), member)).chamfers
