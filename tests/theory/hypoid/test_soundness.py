"""Undercut and pointed teeth: found where rolling shows interference, and cured by what the message says."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from gearstudio.theory.hypoid.conjugate import envelope
from gearstudio.theory.hypoid.inputs import DepthInput, HypoidError, HypoidInput
from gearstudio.theory.hypoid.pair import hypoid_pair
from gearstudio.theory.hypoid.soundness import is_sound, least_top_land, sound_pair, sound_pinion_flank
from gearstudio.theory.hypoid.undercut import worst_place
from tests.theory.hypoid.pairs import AXLE, REFERENCE, reference_input

EVEN = DepthInput(mean_addendum_factor=0.5)
UNDERCUT = [
    HypoidInput(5, 37, 20.0, 225.0, 34.0, 50.0, 88.9, depth=EVEN),
    HypoidInput(6, 41, -15.0, 225.0, 34.0, 35.0, 114.3, depth=EVEN, pinion_hand="right"),
    HypoidInput(7, 43, 0.0, 225.0, 34.0, 0.0, 88.9, depth=EVEN, curve="archimedean"),
]


def cured(given: HypoidInput, message: str) -> HypoidInput:
    """The design with what the message offers."""
    offered = {
        "mean_addendum_factor": r"mean addendum factor of ([\d.]+)",
        "depth_factor": r"a depth factor of ([\d.]+)",
    }
    depth = {key: float(m[1].rstrip(".")) for key, text in offered.items() if (m := re.search(text, message))}
    angle = re.search(r"a pressure angle of ([\d.]+)", message)
    given = replace(given, depth=replace(given.depth, **depth))
    return replace(given, pressure_angle_deg=float(angle[1])) if angle else given


@pytest.mark.parametrize("given", UNDERCUT)
def test_undercut_is_found_and_cured(given: HypoidInput) -> None:
    pair = hypoid_pair(given)
    assert not is_sound(pair)
    with pytest.raises(HypoidError, match="undercut near the") as caught:
        sound_pinion_flank(pair, "concave")
    sound = sound_pair(cured(given, str(caught.value)))
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
    flank = sound_pinion_flank(pair, "concave")
    u, v = np.meshgrid(np.linspace(0, 1, 41), np.linspace(0, 1, 61))
    ratio = flank.envelope.at(*flank.coordinates(u, v)).area_ratio
    assert worst_place(pair, flank.side).area_ratio == pytest.approx(ratio.min(), rel=0.02)


def test_pointed_teeth_are_refused() -> None:
    given = replace(AXLE, pressure_angle_deg=30.0, depth=DepthInput(mean_addendum_factor=0.05, depth_factor=2.4))
    assert least_top_land(hypoid_pair(given), "pinion") < 0
    with pytest.raises(HypoidError, match="pointed") as caught:
        sound_pair(given)
    sound_pair(cured(given, str(caught.value)))


@pytest.mark.parametrize("offset", [5.0, -5.0, 0.0])
def test_tips_that_reach_inside_the_wheels_base_cone(offset: float) -> None:
    given = HypoidInput(15, 16, offset, 100.0, 15.0, 10.0, 60.0, depth=DepthInput(mean_addendum_factor=0.0))
    with pytest.raises(HypoidError, match="inside its base cone with its tips") as caught:
        sound_pair(given)
    sound_pair(cured(given, str(caught.value)))


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
