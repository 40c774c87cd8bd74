"""Lengthwise laws against their definitions in the developed pitch plane."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry, pair_geometry
from gearstudio.theory.involute_flank import involute_flank
from gearstudio.theory.lengthwise import Lengthwise
from tests.theory.members import MEMBERS, made

ARCS = [(75.0, 80.0, 35.0), (1.0, 1e5, 35.0), (1.0, 1e5, 0.0), (100.0, 30.0, 10.0), (100.0, 500.0, 54.9)]


def arc(mean: float, radius: float, spiral_deg: float) -> tuple[Lengthwise, np.ndarray]:
    law = Lengthwise("circular_arc", mean, np.radians(spiral_deg), 0.5, 1, radius)
    low, high = law.reach
    return law, np.linspace(max(1.001 * low, 0.7 * mean), min(0.999 * high, 1.3 * mean), 9)


@pytest.mark.parametrize(("mean", "radius", "spiral_deg"), ARCS)
def test_the_arc_is_a_circle_through_the_mean_point_at_the_spiral_angle(
    mean: float, radius: float, spiral_deg: float
) -> None:
    """To 50 digits: where a circle about the cutter's centre meets circles about the apex."""
    law, places = arc(mean, radius, spiral_deg)
    with mpmath.workdps(50):
        beta, r_0 = mpmath.mpf(float(np.radians(spiral_deg))), mpmath.mpf(radius)
        centre = mpmath.mpc(mean) + r_0 * mpmath.mpc(-mpmath.sin(beta), mpmath.cos(beta))
        away = abs(centre)

        def turn(rho: float) -> mpmath.mpf:
            apart = mpmath.acos((mpmath.mpf(rho) ** 2 + away**2 - r_0**2) / (2 * mpmath.mpf(rho) * away))
            return mpmath.arg(centre) - apart

        expected = [float(turn(rho) - turn(mean)) for rho in places.tolist()]
        assert abs(turn(mean)) < mpmath.mpf(10) ** -40
    assert np.abs(law.trace(places)[0] - expected).max() < 2e-15 * max(1.0, law.reach[1] / 1e5)


@pytest.mark.parametrize("member", MEMBERS.values(), ids=MEMBERS)
def test_derivatives_are_those_of_the_trace(member: MemberGeometry) -> None:
    law, step = member.lengthwise, 1e-5 * member.outer_cone_distance
    rho = np.linspace(member.inner_cone_distance, member.outer_cone_distance, 9)
    _, first, second = law.azimuth_derivatives(rho)
    differences = (law.azimuth(rho + step) - law.azimuth(rho - step)) / (2 * step)
    assert first == pytest.approx(differences, rel=1e-6, abs=1e-9 / step)
    slopes = (law.azimuth_slope(rho + step) - law.azimuth_slope(rho - step)) / (2 * step)
    assert second == pytest.approx(slopes, rel=1e-5, abs=1e-10 / step**2 * 1e-2)
    assert np.tan(law.spiral_angle(rho)) == pytest.approx(
        member.hand * rho * np.sin(member.pitch_angle) * differences, rel=1e-6, abs=1e-8
    )
    assert law.spiral_angle(member.mean_cone_distance) == pytest.approx(law.mean_spiral_angle, abs=1e-14)
    assert law.azimuth(member.mean_cone_distance) == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize("member", MEMBERS.values(), ids=MEMBERS)
def test_division_of_the_face(member: MemberGeometry) -> None:
    law, ends = member.lengthwise, (member.inner_cone_distance, member.outer_cone_distance)
    shares = np.linspace(0.0, 1.0, 33)
    rho = law.divided(*ends, shares)
    assert (rho[0], rho[-1]) == ends
    assert law.share(*ends, rho) == pytest.approx(shares, abs=1e-13)
    if law.law == "circular_arc":
        plane = rho * np.exp(1j * law.trace(rho)[0])
        chords = np.abs(np.diff(plane))
        assert chords == pytest.approx(np.full(32, chords.mean()), rel=1e-9)


def test_beyond_the_arc_the_trace_goes_straight_on() -> None:
    law, _ = arc(100.0, 30.0, 10.0)
    _, end = law.reach
    inside, outside = end - 1e-7, end + np.array([1e-7, 1e-3, 1.0])
    assert law.trace(outside)[1] == pytest.approx(np.full(3, law.trace(inside)[1]), rel=1e-5)
    assert np.diff(law.trace(outside)[0]) == pytest.approx(law.trace(inside)[1] * np.diff(outside), rel=1e-5)


def test_a_cutter_too_small_makes_no_flank() -> None:
    design = made(cutter_radius=20.0)
    with pytest.raises(GeometryError, match="does not cross"):
        involute_flank(pair_geometry(design).wheel, "concave")


def test_angle_at_the_toe_comes_out_at_the_toe_of_the_base_cone() -> None:
    for kind in ("normal", "transverse"):
        design = made(curve="archimedean", spiral_angle_at="toe", spiral_angle_deg=28.0, pressure_angle_kind=kind)
        for member in (pair_geometry(design).pinion, pair_geometry(design).wheel):
            toe = member.inner_cone_distance
            slope = abs(float(member.lengthwise.azimuth_slope(toe)))
            assert np.degrees(np.arctan(toe * np.sin(member.base_angle) * slope)) == pytest.approx(28.0, abs=1e-10)


def test_a_right_hand_tooth_leans_clockwise_seen_from_the_apex() -> None:
    for hand, sign in (("right", 1), ("left", -1)):
        member = pair_geometry(made(pinion_hand=hand)).pinion
        toe, heel = member.lengthwise.azimuth([member.inner_cone_distance, member.outer_cone_distance])
        assert np.sign(heel - toe) == sign
        assert pair_geometry(made(pinion_hand=hand)).wheel.hand == -sign
