"""Solids of pairs with an offset: valid, exact, as large as theory says, and in mesh without entering each other."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from gearstudio.analysis.gear_deviation import GearTheory
from gearstudio.design import Design, with_field
from gearstudio.jobs import ExportJob
from gearstudio.kernel.solids import check_solid, is_valid, solid_volume
from gearstudio.methods.gear import Gear, build_gear
from gearstudio.presets import PRESETS, PRESETS_BY_KEY
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.pair import placement
from gearstudio.theory.place import Place
from tests.kernel.test_gear_pair import CHORD, Body
from tests.theory.hypoid.pairs import in_world
from tests.volume import gear_volume

pytestmark = pytest.mark.kernel

HYPOID = [preset.key for preset in PRESETS if preset.design.pair.offset != 0]
MODIFIED = {
    "modifications.pinion.concave.lengthwise_crowning_um": 20.0,
    "modifications.pinion.convex.root_relief_um": 10.0,
    "modifications.wheel.convex.profile_crowning_um": 10.0,
}


def modified() -> Design:
    design = PRESETS_BY_KEY[HYPOID[0]].design
    for field, value in MODIFIED.items():
        design = with_field(design, field, value)
    return design


def assert_as_theory(gear: Gear) -> None:
    """One valid closed shell, as large as theory's integral, every face where theory has it."""
    check = check_solid(gear.solid)
    assert is_valid(gear.solid) and check.closed
    assert gear.gap < 5e-5
    assert solid_volume(gear.solid) == pytest.approx(gear_volume(gear.tooth.member, gear.outline.points), rel=1e-6)
    theory = GearTheory(gear.tooth.member, gear.tooth.profile)
    for face in gear.tooth.faces:
        name = face.title(gear.member.hand)
        off = np.abs(theory.distance(name, face.surface.uniform_grid(23, 29))).max()
        assert off < (1e-4 if face.kind == "flank" else 1e-3), (name, off)


@pytest.mark.parametrize("member", ["pinion", "wheel"])
@pytest.mark.parametrize("key", HYPOID)
def test_gears_are_as_theory_says(key: str, member: str) -> None:
    method = "point_cloud" if HYPOID.index(key) % 2 else "profile_sweep"
    assert_as_theory(build_gear(PRESETS_BY_KEY[key].design, member, method, "optimised"))


@pytest.mark.parametrize("member", ["pinion", "wheel"])
def test_modified_flanks_have_fillets_that_follow(member: str) -> None:
    gear = build_gear(modified(), member, "profile_sweep", "optimised")
    assert_as_theory(gear)
    plain = build_gear(PRESETS_BY_KEY[HYPOID[0]].design, member, "profile_sweep", "optimised")
    assert solid_volume(gear.solid) < solid_volume(plain.solid) - 1.0


@pytest.mark.parametrize("ends", ["sphere", "back_cone"])
def test_a_bevel_pair_with_a_tilted_root_has_a_root_cone_of_its_own(ends: str) -> None:
    design = Design()
    for field, value in {"depth.system": "iso23509", "depth.taper": "tilted_root", "tooth.ends": ends}.items():
        design = with_field(design, field, value)
    gear = build_gear(design, "wheel", "profile_sweep", "optimised")
    assert gear.member.root_limit.offset != 0
    assert_as_theory(gear)


@pytest.mark.parametrize("variant", ["published", "optimised"])
@pytest.mark.parametrize("method", ["rotating_line", "profile_sweep", "point_cloud"])
def test_every_variant_makes_a_valid_pinion(method: str, variant: str) -> None:
    gear = build_gear(PRESETS_BY_KEY["hypoid-80"].design, "pinion", method, variant)
    assert is_valid(gear.solid) and gear.gap < 5e-5


def test_cutting_gives_the_same_solid() -> None:
    design = PRESETS_BY_KEY["hypoid-truck"].design
    joined, cut = (build_gear(design, "pinion", "profile_sweep", "optimised", how) for how in ("assemble", "cut"))
    assert is_valid(cut.solid)
    assert solid_volume(cut.solid) == pytest.approx(solid_volume(joined.solid), rel=1e-6)


@pytest.mark.parametrize("key", [HYPOID[0], HYPOID[-1]])
def test_gears_roll_without_entering_each_other(key: str) -> None:
    design = PRESETS_BY_KEY[key].design
    pair = pair_geometry(design)
    pinion, wheel = Body(design, "pinion"), Body(design, "wheel")

    def depths(turn: float, too_far: float = 0.0) -> tuple[float, float]:
        """Of wheel in pinion and pinion in wheel [mm], the pinion turned too far by an angle [rad]."""
        pinion_at = Place(*placement(pair, "pinion", turn + too_far))
        wheel_at = Place(*placement(pair, "wheel", turn))
        return (
            pinion.depth(pinion_at.back(wheel_at.of(wheel.mesh.points))),
            wheel.depth(wheel_at.back(pinion_at.of(pinion.mesh.points))),
        )

    for turn in (0.0, 0.17):
        assert max(depths(turn)) < 2 * CHORD
    outer = pair.pinion.outer_cone_distance * np.sin(pair.pinion.pitch_angle)
    for way in (-1, 1):
        assert max(depths(0.0, way * (design.tooth.backlash / outer + 0.02))) > 5 * CHORD


def test_the_exported_pair_stands_in_the_world(tmp_path: Path) -> None:
    design = PRESETS_BY_KEY[HYPOID[0]].design
    job = ExportJob(design, "pair", "gear", "profile_sweep", "optimised", ("step", "glb"), tmp_path)
    files = job.run(lambda stage, fraction: None)
    for file in files:
        assert not file.check.problems(), (file.format, file.check.problems())
        flanks = [face for face in file.check.deviations if face.name in ("concave", "convex")]
        assert len(flanks) >= 2 * (design.pair.pinion_teeth + design.pair.wheel_teeth)
        assert max(face.largest_um for face in flanks) < 0.1
    hypoid = pair_geometry(design).hypoid
    assert hypoid is not None
    points = [in_world(hypoid.axes, Body(design, "pinion").mesh.points)]
    points.append(Body(design, "wheel").mesh.points + hypoid.axes.wheel_apex)
    box = np.array([np.min([p.min(axis=0) for p in points], axis=0), np.max([p.max(axis=0) for p in points], axis=0)])
    for file in files:
        assert np.allclose(file.check.box, box, atol=0.3)
