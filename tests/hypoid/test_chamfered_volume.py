"""Volume of chamfered teeth whose profile changes along the face: theory's integral against solids and itself."""

from __future__ import annotations

import pytest

from gearstudio.design import Design, with_field
from gearstudio.kernel.solids import is_valid, solid_volume
from gearstudio.methods.gear import build_gear
from gearstudio.presets import PRESETS_BY_KEY
from gearstudio.theory.chamfer import chamfer_limits
from gearstudio.theory.cones import pair_geometry
from tests.hypoid.test_tangent_faces import deep
from tests.volume import gear_volume

CASES = [
    (PRESETS_BY_KEY["hypoid-car"].design, "pinion", 1.5),
    (with_field(PRESETS_BY_KEY["hypoid-80"].design, "tooth.ends", "sphere"), "wheel", 2.0),
    (deep("hypoid-negative", relieved=True), "pinion", 2.0),
]


@pytest.mark.kernel
@pytest.mark.parametrize(("design", "member", "length"), CASES)
def test_chamfered_solids_are_as_large_as_theory_says(design: Design, member: str, length: float) -> None:
    gear = build_gear(with_field(design, f"blank.{member}.end_chamfer", length), member, "point_cloud", "optimised")
    assert is_valid(gear.solid) and len(gear.outline.chamfers) == 2
    wanted = gear_volume(gear.tooth.member, gear.outline.points, gear.outline.chamfers)
    assert solid_volume(gear.solid) == pytest.approx(wanted, rel=1e-6)
    assert wanted < gear_volume(gear.tooth.member, gear.outline.points)


@pytest.mark.kernel
def test_a_chamfer_into_the_fillets() -> None:
    design = PRESETS_BY_KEY["hypoid-truck"].design
    member = pair_geometry(design).pinion
    length = 0.98 * chamfer_limits(member)[1]
    gear = build_gear(with_field(design, "blank.pinion.end_chamfer", length), "pinion", "point_cloud", "optimised")
    wanted = gear_volume(gear.tooth.member, gear.outline.points, gear.outline.chamfers)
    assert solid_volume(gear.solid) == pytest.approx(wanted, rel=2e-6)
