"""Depth, taper, turned cones and the dimensions of the standard."""

from __future__ import annotations

from dataclasses import replace
from math import degrees, pi, radians, tan

import numpy as np
import pytest

from gearstudio.theory.hypoid.bodies import TurnedCone
from gearstudio.theory.hypoid.depth import duplex_sum, standard_sum
from gearstudio.theory.hypoid.dimensions import dimensions
from gearstudio.theory.hypoid.inputs import DepthInput, HypoidError, HypoidInput
from gearstudio.theory.hypoid.pair import HypoidPair, hypoid_pair
from tests.theory.hypoid.pairs import AXLE, PAIRS, REFERENCE, Record, reference_input


@pytest.mark.parametrize("record", REFERENCE, ids=lambda r: r["name"])
def test_reference(record: Record) -> None:
    pair = hypoid_pair(reference_input(record))
    depth, both = pair.depth, pair.bodies
    found = {
        "hmw": depth.working_depth, "c": depth.clearance, "ham1": depth.addenda[0], "ham2": depth.addenda[1],
        "hfm1": depth.dedenda[0], "hfm2": depth.dedenda[1], "ta2": depth.addendum_angle, "tf2": depth.dedendum_angle,
        "da1": both.pinion.face.angle, "df1": both.pinion.root.angle, "da2": both.wheel.face.angle,
        "df2": both.wheel.root.angle, "tzF1": both.pinion.face.apex_beyond, "tzR1": both.pinion.root.apex_beyond,
        "tzF2": both.wheel.face.apex_beyond, "tzR2": both.wheel.root.apex_beyond,
        "zR": both.root_plane_offset_angle, "zO": both.face_plane_offset_angle,
        "be1": both.pinion.outer_width, "bi1": both.pinion.inner_width,
        "be2": both.wheel.outer_width, "bi2": both.wheel.inner_width,
    }  # fmt: skip
    lengths = {key for key in found if key[0] in "hct" and key not in ("ta2", "tf2")} | {"be1", "bi1", "be2", "bi2"}
    assert {k: v - record["blank"][k] for k, v in found.items() if k in lengths} == pytest.approx(
        dict.fromkeys(lengths, 0.0), abs=1e-9
    )
    angles = found.keys() - lengths
    assert {k: found[k] - record["blank"][k] for k in angles} == pytest.approx(dict.fromkeys(angles, 0.0), abs=1e-10)


def standing(pair: HypoidPair, cone: TurnedCone, name: str) -> tuple[np.ndarray, np.ndarray]:
    """Apex and axis of a turned cone in the world."""
    if name == "wheel":
        return np.array([0.0, 0.0, -cone.apex_beyond]), np.array([0.0, 0.0, 1.0])
    return pair.axes.crossing - cone.apex_beyond * pair.axes.pinion_axis, pair.axes.pinion_axis


def cone_points(pair: HypoidPair, cone: TurnedCone, name: str) -> np.ndarray:
    """Points of a turned cone in the world, around the mean point."""
    apex, axis = standing(pair, cone, name)
    towards = pair.axes.mean_point - apex
    out = towards - axis * (towards @ axis)
    first = out / np.linalg.norm(out)
    second = np.cross(axis, first)
    s, t = np.meshgrid(np.linspace(0.9, 1.1, 121) * np.linalg.norm(towards), np.linspace(-0.2, 0.2, 241))
    ring = np.cos(t)[..., None] * first + np.sin(t)[..., None] * second
    return np.asarray(apex + s[..., None] * (np.cos(cone.angle) * axis + np.sin(cone.angle) * ring))


def outside(pair: HypoidPair, points: np.ndarray, cone: TurnedCone, name: str) -> np.ndarray:
    """Height of points over a turned cone, square to it."""
    apex, axis = standing(pair, cone, name)
    height = (points - apex) @ axis
    radius = np.linalg.norm(points - apex - height[..., None] * axis, axis=-1)
    return np.asarray(radius * np.cos(cone.angle) - height * np.sin(cone.angle))


@pytest.mark.parametrize("taper", ["standard", "uniform"])
@pytest.mark.parametrize("given", PAIRS.values(), ids=PAIRS)
def test_clearance_in_space(given: HypoidInput, taper: str) -> None:
    """Face and root cones of mates stand off by the clearance where they are nearest."""
    pair = hypoid_pair(replace(given, depth=replace(given.depth, taper=taper)))
    pinion, wheel, wanted = pair.bodies.pinion, pair.bodies.wheel, pytest.approx(pair.depth.clearance, abs=2e-3)
    assert outside(pair, cone_points(pair, pinion.face, "pinion"), wheel.root, "wheel").min() == wanted
    assert outside(pair, cone_points(pair, wheel.face, "wheel"), pinion.root, "pinion").min() == wanted


def test_sample_of_the_standard_without_offset() -> None:
    found = dimensions(hypoid_pair(HypoidInput(14, 39, 0.0, 176.893, 25.4, 35.0, 114.3)))
    pinion, wheel = found.pinion, found.wheel
    assert degrees(pinion.pitch_angle) == pytest.approx(19.747, abs=5e-4)
    assert degrees(wheel.pitch_angle) == pytest.approx(70.253, abs=5e-4)
    for member in (pinion, wheel):
        ends = (member.outer, member.mean, member.inner)
        assert [e.cone_distance for e in ends] == pytest.approx([93.973, 81.273, 68.573], abs=6e-4)
        assert [degrees(e.spiral_angle) for e in ends] == pytest.approx([36.846, 35.0, 33.946], abs=6e-4)
        assert member.outer_transverse_module == pytest.approx(4.536, abs=5e-4)
    assert [e.pitch_diameter for e in (pinion.outer, pinion.mean, pinion.inner)] == pytest.approx(
        [63.5, 54.918, 46.337], abs=6e-4
    )
    assert wheel.mean.pitch_diameter == pytest.approx(152.987, abs=6e-4)
    assert wheel.inner.pitch_diameter == pytest.approx(129.080, abs=6e-4)
    assert found.mean_normal_module == pytest.approx(3.213, abs=5e-4)


def test_duplex_keeps_both_slots_at_their_width() -> None:
    """Widths at both roots, a little to either side of the mean point, add up to the same."""
    given = replace(AXLE, depth=DepthInput(taper="duplex"), cutter_radius=88.9)
    pair = hypoid_pair(given)
    wheel = pair.member("wheel", "convex")
    rate = tan(radians(given.pressure_angle_deg)) * duplex_sum(given, pair.cones)

    def width(rho: float) -> float:
        pitch = 2 * pi * np.sin(wheel.pitch_angle) / wheel.teeth * rho * np.cos(wheel.lengthwise.spiral_angle(rho))
        return float(pitch - 2 * rate * (rho - wheel.mean_cone_distance))

    mean = wheel.mean_cone_distance
    assert width(mean + 1e-3) == pytest.approx(width(mean - 1e-3), abs=1e-8)
    assert pair.depth.addendum_angle + pair.depth.dedendum_angle == pytest.approx(duplex_sum(given, pair.cones))


def test_tapers() -> None:
    def depth(**words: object) -> HypoidPair:
        return hypoid_pair(replace(AXLE, depth=replace(DepthInput(), **words)))  # type: ignore[arg-type]

    uniform, tilted = depth(taper="uniform"), depth(taper="tilted_root")
    assert uniform.depth.addendum_angle == uniform.depth.dedendum_angle == 0
    assert uniform.bodies.wheel.face.angle == uniform.bodies.wheel.root.angle == uniform.cones.wheel.angle
    total = tilted.depth.addendum_angle + tilted.depth.dedendum_angle
    limit = 1.3 * standard_sum(tilted.cones, tilted.depth.dedenda)
    assert total == pytest.approx(min(limit, duplex_sum(tilted.given, tilted.cones)))
    wide = hypoid_pair(replace(AXLE, offset=5.0, cutter_radius=250.0, depth=DepthInput(taper="tilted_root")))
    limit = 1.3 * standard_sum(wide.cones, wide.depth.dedenda)
    assert duplex_sum(wide.given, wide.cones) > limit
    assert wide.depth.addendum_angle + wide.depth.dedendum_angle == pytest.approx(limit)
    given = depth(taper="uniform", addendum_angle_deg=1.0, dedendum_angle_deg=2.5)
    assert degrees(given.bodies.wheel.face.angle - given.cones.wheel.angle) == pytest.approx(1.0)
    assert degrees(given.cones.wheel.angle - given.bodies.wheel.root.angle) == pytest.approx(2.5)
    with pytest.raises(HypoidError, match="mean depth at an end"):
        depth(addendum_angle_deg=14.0, dedendum_angle_deg=14.0)


@pytest.mark.parametrize("given", PAIRS.values(), ids=PAIRS)
def test_thicknesses_leave_the_backlash(given: HypoidInput) -> None:
    found = dimensions(hypoid_pair(given))
    both = found.pinion.mean_normal_thickness + found.wheel.mean_normal_thickness
    share = (
        2 * found.wheel.mean.pitch_diameter * np.cos(found.wheel.mean.spiral_angle) / given.wheel_outer_pitch_diameter
    )
    assert pi * found.mean_normal_module - both == pytest.approx(given.backlash * share / 2, abs=1e-12)
    assert found.pinion.mean.addendum == pytest.approx(
        hypoid_pair(given).depth.addenda[0], abs=4e-3 * found.mean_normal_module
    )
