"""Undercut, pointed teeth and tips inside a base cone: found up to where they end."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from gearstudio.theory.hypoid.conjugate import envelope, pinion_flank
from gearstudio.theory.hypoid.inputs import DepthInput, HypoidError, HypoidInput
from gearstudio.theory.hypoid.pair import hypoid_pair
from gearstudio.theory.hypoid.undercut import trouble, worst_place
from tests.theory.hypoid.pairs import AXLE, REFERENCE, least_top_land, reference_input, sound_pair

EVEN = DepthInput(mean_addendum_factor=0.5)
UNDERCUT: list[tuple[HypoidInput, dict[str, float]]] = [
    (HypoidInput(5, 37, 20.0, 225.0, 34.0, 50.0, 88.9, depth=EVEN), {"mean_addendum_factor": 0.44}),
    (
        HypoidInput(6, 41, -15.0, 225.0, 34.0, 35.0, 114.3, depth=EVEN, pinion_hand="right"),
        {"mean_addendum_factor": 0.28},
    ),
    (
        HypoidInput(7, 43, 0.0, 225.0, 34.0, 0.0, 88.9, depth=EVEN, curve="archimedean"),
        {"depth_factor": 1.8, "mean_addendum_factor": 0.2},
    ),
]
"""Pairs with undercut, and depths with which they have none."""


def deeper(given: HypoidInput, **depth: Any) -> HypoidInput:
    """The pair with other depths."""
    return replace(given, depth=replace(given.depth, **depth))


@pytest.mark.parametrize(("given", "cure"), UNDERCUT)
def test_undercut_is_found(given: HypoidInput, cure: dict[str, float]) -> None:
    pair = hypoid_pair(given)
    wrong = trouble(pair, pair.side("pinion", "concave"))
    assert wrong is not None and "undercut near the" in wrong
    with pytest.raises(HypoidError, match="undercut near the"):
        sound_pair(deeper(given, mean_addendum_factor=cure["mean_addendum_factor"] + 0.05))
    sound = sound_pair(deeper(given, **cure))
    assert min(worst_place(sound, side).area_ratio for side in (1, -1)) > 0


@pytest.mark.parametrize("record", REFERENCE, ids=lambda r: r["name"])
def test_reference_pairs_are_sound(record: dict[str, object]) -> None:
    pair = sound_pair(reference_input(record))
    for side in (1, -1):
        worst = worst_place(pair, side)
        assert worst.harmless and 0 <= worst.place <= 1
        assert pair.member("pinion", "concave").root_angle < worst.polar_angle < 1.2 * pair.cones.pinion.angle


def test_worst_place_is_the_smallest_ratio() -> None:
    pair = hypoid_pair(AXLE)
    flank = pinion_flank(pair, "concave")
    assert trouble(pair, flank.side) is None
    u, v = np.meshgrid(np.linspace(0, 1, 41), np.linspace(0, 1, 61))
    ratio = flank.envelope.at(*flank.coordinates(u, v)).area_ratio
    assert worst_place(pair, flank.side).area_ratio == pytest.approx(ratio.min(), rel=0.02)


def test_pointed_teeth_are_pointed() -> None:
    given = replace(AXLE, pressure_angle_deg=30.0, depth=DepthInput(mean_addendum_factor=0.05, depth_factor=2.4))
    assert least_top_land(hypoid_pair(given), "pinion") < 0
    with pytest.raises(HypoidError, match="pointed"):
        sound_pair(deeper(given, mean_addendum_factor=0.35))
    sound_pair(deeper(given, mean_addendum_factor=0.36))


@pytest.mark.parametrize(("offset", "cure"), [(5.0, 0.34), (-5.0, 0.21), (0.0, 0.05)])
def test_tips_that_reach_inside_the_wheels_base_cone(offset: float, cure: float) -> None:
    given = HypoidInput(15, 16, offset, 100.0, 15.0, 10.0, 60.0, depth=DepthInput(mean_addendum_factor=0.0))
    for factor in (0.0, cure - 0.01):
        with pytest.raises(HypoidError, match="inside its base cone with its tips"):
            sound_pair(deeper(given, mean_addendum_factor=factor))
    sound_pair(deeper(given, mean_addendum_factor=cure))


def test_wheels_base_cone_is_no_undercut() -> None:
    """J is infinite on the wheel's base cone, whatever the sign of a rounded zero."""
    for side in (1, -1):
        made = envelope(hypoid_pair(HypoidInput(8, 8, 0.0, 1700.0, 320.0, 17.0, 1000.0)), side)
        member = made.wheel.member
        rho = np.linspace(member.inner_cone_distance, member.outer_cone_distance, 31)
        assert np.all(made.made(0.0, rho).area_ratio == np.inf)


def test_lopsided_flanks_are_refused() -> None:
    given = replace(AXLE, offset=60.0, pressure_angle_deg=10.0, limit_pressure_angle_factor=3.0)
    with pytest.raises(HypoidError, match="outside 0° to 45°") as caught:
        hypoid_pair(given)
    most = float(str(caught.value).split()[-1])
    hypoid_pair(replace(given, limit_pressure_angle_factor=most))
    with pytest.raises(HypoidError):
        hypoid_pair(replace(given, limit_pressure_angle_factor=most + 0.02))
