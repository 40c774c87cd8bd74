"""Pitch cones: independent numbers, contact checked in space, the standard's sample, what has no solution."""

from __future__ import annotations

from dataclasses import replace
from math import degrees, pi, radians

import numpy as np
import pytest

from gearstudio.theory.hypoid.axes import placed
from gearstudio.theory.hypoid.checks import pitch_cones
from gearstudio.theory.hypoid.inputs import HypoidError, HypoidInput
from gearstudio.theory.hypoid.method1 import method_0, method_1
from gearstudio.theory.hypoid.pair import hypoid_pair
from gearstudio.theory.hypoid.pitch import PitchCones, trace_curvature
from tests.theory.hypoid.pairs import AXLE, PAIRS, REFERENCE, Record, in_world, reference_input

ANGLES = {"delta1", "delta2", "beta1", "beta2", "zeta", "zetap", "eta", "alim"}


def named(cones: PitchCones) -> dict[str, float]:
    """The cones by the names of the reference."""
    pinion, wheel = cones.pinion, cones.wheel
    return {
        "delta1": pinion.angle, "delta2": wheel.angle, "beta1": pinion.spiral_angle, "beta2": wheel.spiral_angle,
        "zeta": cones.offset_angle_axial, "zetap": cones.offset_angle_pitch, "eta": cones.offset_angle_pinion,
        "Rm1": pinion.mean_cone_distance, "Rm2": wheel.mean_cone_distance, "rm1": pinion.mean_radius,
        "rm2": wheel.mean_radius, "tz1": pinion.apex_beyond, "tz2": wheel.apex_beyond, "tzm1": pinion.mean_height,
        "tzm2": wheel.mean_height, "mmn": cones.mean_normal_module, "alim": cones.limit_pressure_angle,
        "cbe2": cones.outer_share, "ap": cones.pitch_plane_offset,
    }  # fmt: skip


def differs(found: dict[str, float], wanted: Record) -> dict[str, float]:
    """What is off by more than 1e-9 mm or 1e-10 rad."""
    limit = {key: 1e-10 if key in ANGLES else 1e-9 for key in found}
    return {k: found[k] - wanted[k] for k in found if k in wanted and abs(found[k] - wanted[k]) > limit[k]}


@pytest.mark.parametrize("record", REFERENCE, ids=lambda r: r["name"])
def test_reference(record: Record) -> None:
    given = reference_input(record)
    assert not differs(named(pitch_cones(given)), record["pitch"])
    if "method1_iso_literal_k1.2" in record:
        assert not differs(named(method_1(given)), record["method1_iso_literal_k1.2"])


def test_sample_of_the_standard() -> None:
    """The printed sample of Method 1.

    Converged, R_m1 is 0.002 mm larger and alpha_lim rounds to -2.254 degrees: the printed values belong to an
    iterate whose limit radius is within 0.01 % of the cutter's, where the standard would stop at 1 %.
    """
    given = HypoidInput(13, 42, 15.0, 170.0, 30.0, 50.0, 63.5)

    def printed(cones: PitchCones) -> list[float]:
        angles = (
            cones.pinion.spiral_angle, cones.wheel.spiral_angle, cones.offset_angle_pitch,
            cones.limit_pressure_angle, cones.pinion.angle, cones.wheel.angle,
        )  # fmt: skip
        lengths = (cones.pinion.mean_cone_distance, cones.wheel.mean_cone_distance, cones.mean_normal_module)
        return [*lengths, *(degrees(angle) for angle in angles)]

    wanted = np.array([73.519, 76.337, 2.640, 49.998, 38.609, 11.390, -2.253, 21.288, 68.324])
    converged = printed(method_1(given)) - wanted
    assert np.all(np.abs(converged[[1, 2, 3, 4, 5, 7, 8]]) <= 0.0005)
    assert converged[0] == pytest.approx(0.00216, abs=1e-5) and converged[6] == pytest.approx(-0.00054, abs=1e-5)
    early = printed(method_1(replace(given, cutter_radius=63.5 / 1.00005))) - wanted
    assert np.all(np.abs(early[:8]) <= 0.0005) and abs(early[8]) <= 0.0007


def in_space(given: HypoidInput, cones: PitchCones) -> None:
    """Contact of both cones from their apexes and the mean point alone."""
    axes = placed(cones, given.wheel_hand)
    pinion, wheel = axes.pinion_axis, np.array([0.0, 0.0, 1.0])
    assert axes.crossing @ pinion == pytest.approx(0, abs=1e-12)
    to_pinion, to_wheel = axes.mean_point - axes.pinion_apex, axes.mean_point - axes.wheel_apex
    size = np.linalg.norm(to_wheel)
    g1, g2 = to_pinion / np.linalg.norm(to_pinion), to_wheel / size
    assert np.arccos(g1 @ pinion) == pytest.approx(cones.pinion.angle, abs=1e-10)
    assert np.arccos(g2 @ wheel) == pytest.approx(cones.wheel.angle, abs=1e-10)
    normals = [g - axis / (axis @ g) for g, axis in ((g1, pinion), (g2, wheel))]
    n1, n2 = (n / np.linalg.norm(n) for n in normals)
    assert n1 @ n2 == pytest.approx(-1, abs=1e-12)
    assert np.linalg.norm(np.cross(n1, n2)) < 1e-10
    assert np.arcsin(np.cross(g2, g1) @ n2) == pytest.approx(given.wheel_hand * cones.offset_angle_pitch, abs=1e-10)
    sliding = np.cross(wheel, axes.mean_point) + given.ratio * np.cross(pinion, axes.mean_point - axes.crossing)
    hand, spiral_1, spiral_2 = given.wheel_hand, cones.pinion.spiral_angle, cones.wheel.spiral_angle
    tooth = np.cos(spiral_2) * g2 + hand * np.sin(spiral_2) * np.cross(g2, n2)
    tooth_1 = np.cos(spiral_1) * g1 - hand * np.sin(spiral_1) * np.cross(g1, n1)
    if given.offset:
        assert np.linalg.norm(np.cross(sliding, tooth)) < 1e-10 * np.linalg.norm(sliding) + 1e-12 * size
    assert tooth @ tooth_1 == pytest.approx(1, abs=1e-10)


@pytest.mark.parametrize("hand", ["left", "right"])
@pytest.mark.parametrize("given", PAIRS.values(), ids=PAIRS)
def test_cones_touch_in_space(given: HypoidInput, hand: str) -> None:
    given = replace(given, pinion_hand=hand)
    cones = pitch_cones(given)
    in_space(given, cones)
    spiral = cones.pinion.spiral_angle if given.spiral_angle_of == "pinion" else cones.wheel.spiral_angle
    assert spiral == pytest.approx(radians(given.spiral_angle_deg), abs=1e-12)
    assert cones.outer_share == pytest.approx(0.5, abs=1e-12)
    if given.offset:
        trace = trace_curvature(given, cones.wheel.mean_cone_distance, cones.wheel.spiral_angle)
        assert cones.limit_curvature == pytest.approx(trace, rel=1e-10)


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("shaft", [75.0, 90.0, 100.0])
def test_small_offset_tends_to_bevel(sign: int, shaft: float) -> None:
    bevel = method_0(HypoidInput(17, 40, 0.0, 160.0, 26.0, 35.0, 80.0, shaft_angle_deg=shaft))
    for offset, tolerance in ((1e-2, 1e-3), (1e-3, 1e-4), (1e-5, 1e-6), (1e-8, 1e-9)):
        given = HypoidInput(17, 40, sign * offset, 160.0, 26.0, 35.0, 80.0, shaft_angle_deg=shaft)
        cones = pitch_cones(given)
        in_space(given, cones)
        assert cones.wheel.angle == pytest.approx(bevel.wheel.angle, abs=tolerance)
        assert cones.pinion.mean_cone_distance == pytest.approx(bevel.pinion.mean_cone_distance, rel=30 * tolerance)


@pytest.mark.parametrize(
    ("change", "field", "key", "worse"),
    [
        ({"offset": -60.0}, "pair.offset", "offset", -0.5),
        ({"offset": 90.0, "spiral_angle_of": "wheel"}, "pair.offset", "offset", 0.5),
        ({"spiral_angle_deg": 5.0}, "lengthwise.spiral_angle_deg", "spiral_angle_deg", -0.2),
        ({"shaft_angle_deg": 120.0}, "pair.shaft_angle_deg", "shaft_angle_deg", 1.0),
        ({"face_width": 200.0}, "pair.face_width", None, 0.0),
    ],
)
def test_refused_with_the_nearest_value(change: dict[str, float], field: str, key: str | None, worse: float) -> None:
    given = replace(AXLE, **change)
    with pytest.raises(HypoidError) as caught:
        pitch_cones(given)
    assert caught.value.field == field
    if key is None:
        return
    offered = float(str(caught.value).split("use")[-1].replace("°", " ").split("mm")[0].split(" or ")[0].split()[-1])
    if key == "shaft_angle_deg":
        pitch_cones(replace(given, shaft_angle_deg=offered, offset=0.0))
        given = replace(given, offset=0.0)
    else:
        pitch_cones(replace(given, **{key: offered}))
    with pytest.raises(HypoidError):
        pitch_cones(replace(given, **{key: offered + worse}))


def test_offset_of_either_sign_turns_the_spiral_the_other_way() -> None:
    plus, minus = pitch_cones(AXLE), pitch_cones(replace(AXLE, offset=-25.0, spiral_angle_deg=30.0))
    assert plus.pinion.spiral_angle > plus.wheel.spiral_angle
    assert minus.pinion.spiral_angle < minus.wheel.spiral_angle
    assert 0 < plus.pinion.angle < pi / 2 and 0 < minus.wheel.angle < pi / 2


@pytest.mark.parametrize("hand", ["left", "right"])
@pytest.mark.parametrize("given", [PAIRS["axle"], PAIRS["below"], PAIRS["bevel"]], ids=["axle", "below", "bevel"])
def test_misalignment(given: HypoidInput, hand: str) -> None:
    """E enlarges the offset, S the shaft angle, P and G move the members away from each other along their axes."""
    pair = hypoid_pair(replace(given, pinion_hand=hand))
    axes, point = pair.axes, np.array([3.0, -2.0, 40.0])
    away = pair.misaligned(0.3, 0.0, 0.0, 0.0)
    assert away.crossing[1] * given.wheel_hand * (-1 if hand != given.pinion_hand else 1) == pytest.approx(
        given.offset + 0.3
    )
    assert in_world(away, point, 0.7) - in_world(axes, point, 0.7) == pytest.approx(away.crossing - axes.crossing)
    away = pair.misaligned(0.0, 0.2, 0.0, 0.0)
    assert in_world(away, point, 0.7) - in_world(axes, point, 0.7) == pytest.approx(0.2 * axes.pinion_axis)
    away = pair.misaligned(0.0, 0.0, 0.2, 0.0)
    assert in_world(away, point, 0.7) - in_world(axes, point, 0.7) == pytest.approx([0.0, 0.0, -0.2])
    away = pair.misaligned(0.0, 0.0, 0.0, 0.01)
    assert np.arccos(away.pinion_axis[2]) == pytest.approx(pair.cones.shaft_angle + 0.01)
    assert away.crossing == pytest.approx(axes.crossing)
    assert in_world(away, [0.0, 0.0, 5.0], 0.7) - away.pinion_apex == pytest.approx(5 * away.pinion_axis)
