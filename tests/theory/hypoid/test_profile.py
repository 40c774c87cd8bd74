"""The profile of hypoid teeth: fillets touch flanks and roots wherever one looks along the face."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from gearstudio.design import FlankModification
from gearstudio.errors import GeometryError
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.hypoid.conjugate import pinion_flank, wheel_flank
from gearstudio.theory.hypoid.inputs import HypoidInput, MemberName
from gearstudio.theory.hypoid.modified import ModifiedConjugate
from gearstudio.theory.hypoid.pair import hypoid_pair
from gearstudio.theory.hypoid.profile import HypoidProfile, hypoid_profile
from gearstudio.theory.modified import ModifiedFlank
from gearstudio.theory.relief import flank_relief
from tests.theory.hypoid.pairs import PAIRS, PRESETS

Floats = NDArray[np.float64]

GIVEN = PRESETS | {name: PAIRS[name] for name in ("below", "truck", "archimedean", "bevel")}
RELIEF = FlankModification(lengthwise_crowning_um=20.0, profile_crowning_um=10.0, root_relief_um=8.0)
STEP = 1e-6


def profile_of_pair(given: HypoidInput, member: MemberName, modified: bool = False) -> HypoidProfile:
    pair = hypoid_pair(given)
    flanks = {}
    for name in FLANKS:
        flank = wheel_flank(pair, name) if member == "wheel" else pinion_flank(pair, name)
        if modified:
            relief = flank_relief(RELIEF, flank.member.relief_frame)
            if member == "wheel":
                flank = ModifiedFlank(flank.member, flank.side, relief=relief)
            else:
                flank = ModifiedConjugate(flank.member, flank.side, flank.envelope, relief=relief)
        flanks[flank.side] = flank
    return hypoid_profile(flanks)


def points(profile: HypoidProfile, side: int, x: float, rho_u: Floats) -> Floats:
    m = profile.member
    delta, phi = profile.rising("fillet", side, np.full((1, 1), x), rho_u)
    rho = m.cone_distance(rho_u, delta)
    azimuth = phi + m.lengthwise.azimuth(rho) + profile.shift(side, rho, delta)
    radius = rho * np.sin(delta)
    return np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), rho * np.cos(delta)], axis=-1)[0]


def unit(vectors: Floats) -> Floats:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


@pytest.mark.parametrize("modified", [False, True])
@pytest.mark.parametrize("member", ["pinion", "wheel"])
@pytest.mark.parametrize("name", GIVEN)
def test_fillets_meet_flank_and_root_without_an_edge(name: str, member: MemberName, modified: bool) -> None:
    profile = profile_of_pair(GIVEN[name], member, modified)
    m, v = profile.member, np.linspace(0.0, 1.0, 7)
    rho_u = m.inner_cone_distance + v * m.face_width
    for side in (1, -1):
        flank = profile.flank(side)
        if profile.below(side) == ("fillet",):
            foot = points(profile, side, 1.0, rho_u)
            assert np.abs(foot - flank.points(0.0, v)).max() < 1e-9 * m.outer_cone_distance
            along = unit(foot - points(profile, side, 1 - STEP, rho_u))
            assert np.abs(np.einsum("ij,ij->i", along, flank.normals(0.0, v))).max() < 3 * STEP
        low = points(profile, side, 0.0, rho_u)
        delta = np.arctan2(np.hypot(low[:, 0], low[:, 1]), low[:, 2])
        assert np.abs(delta - m.limit_angle(m.root_limit, rho_u)).max() < 1e-12
        along = unit(points(profile, side, STEP, rho_u) - low)
        root = m.root_limit.angle
        azimuth = np.arctan2(low[:, 1], low[:, 0])
        out = np.stack([np.cos(root) * np.cos(azimuth), np.cos(root) * np.sin(azimuth), 0 * azimuth - np.sin(root)], -1)
        assert np.abs(np.einsum("ij,ij->i", along, out)).max() < 1e-5


@pytest.mark.parametrize("name", PRESETS)
def test_the_fillet_asked_for_fits_and_stays_below_contact(name: str) -> None:
    profile = profile_of_pair(PRESETS[name], "pinion")
    m, v = profile.member, np.linspace(0.0, 1.0, 9)
    rho_u = m.inner_cone_distance + v * m.face_width
    assert profile.fillet_radius == pytest.approx(m.fillet_radius)
    _, after, before = profile.across("root", rho_u)
    assert np.min(before - after) > 0.02 * m.pitch
    pair = hypoid_pair(PRESETS[name])
    for side in (1, -1):
        start = pinion_flank(pair, pair.flank_name("pinion", side)).limits(v)[0]
        assert np.all(profile.foot_angle(side, rho_u) < start)
        circle = profile.sides[side].circle(rho_u)
        assert np.allclose(circle.radius, m.fillet_angle)


def test_a_large_fillet_is_made_smaller_until_it_fits_or_refused() -> None:
    given = replace(PRESETS["passenger car"], fillet_factor=0.9)
    with pytest.raises(GeometryError, match="fillet"):
        profile_of_pair(given, "pinion")
    profile = profile_of_pair(given, "wheel")
    assert profile.fillet_radius < 0.999 * profile.member.fillet_radius
