"""Pinions whose fillet does not reach the flank: the flank's tangent goes on below it, and nothing touches there."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings

from gearstudio.analysis.gear_deviation import GearTheory
from gearstudio.design import Design, with_field
from gearstudio.kernel.solids import check_solid, is_valid, solid_volume
from gearstudio.methods.gear import build_gear
from gearstudio.presets import PRESETS_BY_KEY
from gearstudio.theory.cones import MemberGeometry, PairGeometry, pair_geometry
from gearstudio.theory.hypoid.conjugate import wheel_flank
from gearstudio.theory.hypoid.profile import HypoidProfile
from gearstudio.theory.hypoid.straight import Touched
from gearstudio.theory.profile import profile_of
from gearstudio.theory.section import Profile, Segment
from gearstudio.theory.vectors import from_spherical
from tests.strategies import offset_designs
from tests.theory.hypoid.rolling import lag
from tests.volume import gear_volume

Floats = np.ndarray
DEEP: dict[str, dict[str, float]] = {
    "hypoid-car": {"depth.clearance_factor": 0.4},
    "hypoid-truck": {"depth.clearance_factor": 0.25},
    "hypoid-negative": {"depth.clearance_factor": 0.2, "depth.mean_addendum_factor": 0.35},
}
RELIEF = {
    "modifications.pinion.concave.root_relief_um": 10.0,
    "modifications.pinion.convex.lengthwise_crowning_um": 20.0,
}
STEP = 1e-6


def deep(key: str, ends: str = "back_cone", relieved: bool = False) -> Design:
    """A preset with so much clearance that its pinion is undercut below the start of contact."""
    design = with_field(PRESETS_BY_KEY[key].design, "depth.system", "iso23509")
    changes = DEEP[key] | (RELIEF if relieved else {}) | {"tooth.fillet_factor": 0.2}
    for path, value in changes.items():
        design = with_field(design, path, value)
    return with_field(design, "tooth.ends", ends)


def places(member: MemberGeometry, count: int = 9) -> Floats:
    return member.inner_cone_distance + np.linspace(0.0, 1.0, count) * member.face_width


def points(profile: Profile, name: Segment, side: int, x: Floats, rho_u: Floats) -> Floats:
    member = profile.member
    delta, phi = profile.rising(name, side, x, rho_u)
    rho = member.cone_distance(rho_u, delta)
    shift = profile.shift_on(side)
    azimuth = phi + member.lengthwise.azimuth(rho) + (0.0 if shift is None else shift(rho, delta))
    return from_spherical(rho, delta, azimuth)


def unit(vectors: Floats) -> Floats:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


@pytest.mark.parametrize("relieved", [False, True])
@pytest.mark.parametrize("ends", ["back_cone", "sphere"])
@pytest.mark.parametrize("key", DEEP)
def test_faces_below_the_flank_touch_each_other(key: str, ends: str, relieved: bool) -> None:
    pinion = pair_geometry(deep(key, ends, relieved)).pinion
    profile = profile_of(pinion)
    assert isinstance(profile, HypoidProfile)
    rho_u, v = places(pinion), np.linspace(0.0, 1.0, 9)
    assert profile.fillet_radius == pytest.approx(pinion.fillet_radius)
    assert any(profile.below(side) == ("fillet", "meridian") for side in (1, -1))
    for side in (1, -1):
        names = profile.below(side)
        ends_of = [[points(profile, name, side, np.array([[x]]), rho_u)[0] for x in (0.0, 1.0)] for name in names]
        for lower, upper in pairwise(ends_of):
            assert np.abs(lower[1] - upper[0]).max() < 1e-9 * pinion.outer_cone_distance
        flank = profile.flank(side)
        top = points(profile, names[-1], side, np.array([[1.0]]), rho_u)[0]
        assert np.abs(top - flank.points(0.0, v)).max() < 1e-8 * pinion.outer_cone_distance
        along = unit(top - points(profile, names[-1], side, np.array([[1 - STEP]]), rho_u)[0])
        assert np.abs(np.einsum("ij,ij->i", along, flank.normals(0.0, v))).max() < 5e-5
        if len(names) > 1:
            before = unit(ends_of[0][1] - points(profile, "fillet", side, np.array([[1 - STEP]]), rho_u)[0])
            after = unit(points(profile, "meridian", side, np.array([[STEP]]), rho_u)[0] - ends_of[1][0])
            assert np.abs(before - after).max() < 1e-4


@pytest.mark.parametrize("key", DEEP)
def test_distances_from_the_tangent_face(key: str) -> None:
    """Points moved along the normal of the face by a known height come back with it."""
    pinion = pair_geometry(deep(key)).pinion
    profile = profile_of(pinion)
    theory = GearTheory(pinion, profile)
    for side in (1, -1):
        if "meridian" not in profile.below(side):
            continue
        name = f"{profile.flank(side).name} meridian"
        x, rho_u = np.linspace(0.1, 0.9, 5)[:, None], places(pinion)
        here = points(profile, "meridian", side, x, rho_u)
        assert np.abs(theory.distance(name, here)).max() < 1e-9
        across = points(profile, "meridian", side, x + STEP, rho_u) - here
        along = points(profile, "meridian", side, x, rho_u + STEP) - here
        normal = side * unit(np.cross(unit(across), unit(along)))
        normal *= np.sign(np.einsum("...i,...i->...", normal, profile.flank(side).normals(0.0, 0.5)))[..., None]
        assert theory.distance(name, here + 1e-3 * normal) == pytest.approx(1e-3, rel=0.1)


def deepest(pair: PairGeometry, profile: Profile) -> float:
    """How far faces below the pinion's flanks come into the wheel's teeth while the pair rolls, negative [mm]."""
    member, hypoid = profile.member, pair.hypoid
    assert hypoid is not None
    worst = np.inf
    for side in (1, -1):
        wheel = wheel_flank(hypoid, hypoid.flank_name("wheel", side))
        for name in profile.below(side):
            here = points(profile, name, side, np.linspace(0.0, 1.0, 15)[:, None], places(member, 21))
            for turn in np.linspace(-1.2, 1.2, 41) * member.pitch:
                gap, lever = lag(hypoid, wheel, here, float(turn))
                worst = min(worst, float(np.min(gap * lever)))
    return worst


@pytest.mark.parametrize("key", DEEP)
def test_the_wheel_does_not_reach_the_tangent_face(key: str) -> None:
    pair = pair_geometry(deep(key))
    assert deepest(pair, profile_of(pair.pinion)) > 0


@settings(max_examples=6, deadline=None, suppress_health_check=list(HealthCheck))
@given(offset_designs())
def test_the_wheel_does_not_reach_below_the_flanks_of_random_pinions(design: Design) -> None:
    assume(design.depth.clearance_factor > 0)
    pair = pair_geometry(design)
    assert deepest(pair, profile_of(pair.pinion)) > 0


def test_a_circle_touches_great_circle_and_root() -> None:
    touched = Touched(np.array([0.6, 0.7]), np.array([0.1, -0.2]), np.array([0.3, -0.1]))
    root = np.array([0.5, 0.62])
    largest = touched.largest(root)
    for share in (0.2, 1.0):
        azimuth, foot = touched.circle(share * largest, root)
        centre = from_spherical(1.0, root + share * largest, azimuth)
        assert np.arcsin(np.einsum("ij,ij->i", touched.pole, centre)) == pytest.approx(share * largest, abs=1e-12)
        assert np.all(foot <= touched.angle + 1e-12)
    assert foot == pytest.approx(touched.angle, abs=1e-12)


@pytest.mark.kernel
@pytest.mark.parametrize(("key", "method"), [("hypoid-truck", "profile_sweep"), ("hypoid-negative", "point_cloud")])
def test_solids_with_tangent_faces(key: str, method: str) -> None:
    gear = build_gear(deep(key, relieved=key == "hypoid-truck"), "pinion", method, "optimised")
    check = check_solid(gear.solid)
    assert is_valid(gear.solid) and check.closed and gear.gap < 5e-5
    assert solid_volume(gear.solid) == pytest.approx(gear_volume(gear.tooth.member, gear.outline.points), rel=1e-6)
    theory = GearTheory(gear.tooth.member, gear.tooth.profile)
    assert any(face.kind == "meridian" for face in gear.tooth.faces)
    for face in gear.tooth.faces:
        name = face.title(gear.member.hand)
        off = np.abs(theory.distance(name, face.surface.uniform_grid(23, 29))).max()
        assert off < (1e-4 if face.kind == "flank" else 1e-3), (name, off)


@pytest.mark.parametrize("key", DEEP)
def test_points_of_every_face_are_known_by_all_of_them(key: str) -> None:
    """Far from a flank, where it would be undercut, its distance is told all the same: so are faces of a file named."""
    pinion = pair_geometry(deep(key)).pinion
    profile = profile_of(pinion)
    theory = GearTheory(pinion, profile)
    beyond = pinion.inner_cone_distance + np.linspace(-0.05, 1.05, 9) * pinion.face_width
    for side in (1, -1):
        for name in profile.below(side):
            here = points(profile, name, side, np.linspace(0.0, 1.0, 5)[:, None], beyond)
            for far in (here, 0.8 * here, 1.2 * here):
                assert all(np.all(np.isfinite(theory.distance(face, far))) for face in theory.names)
