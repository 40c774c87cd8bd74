"""The profile of the whole tooth on the unit sphere: closed, smooth where it should be, fillets round."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry, pair_geometry
from gearstudio.theory.fillet import fillet
from gearstudio.theory.involute_flank import InvoluteFlank
from gearstudio.theory.profile import ToothProfile, tooth_profile
from tests.theory.members import MEMBERS, about_axis, made

CASES = {
    "meridian": made(fillet_factor=0.05),
    "foot below the base cone without a meridian between": made(fillet_factor=0.3),
    "foot on the involute": made(pressure_angle_deg=30.0, fillet_factor=0.1, addendum_factor=0.8),
    "full round": made(fillet_factor=1.0, backlash=0.0),
    "full round below the base cone": made(
        pinion_teeth=6, wheel_teeth=12, pressure_angle_deg=14.0, curve="logarithmic", fillet_factor=1.0
    ),
    "finest": made(pinion_teeth=200, wheel_teeth=200, outer_module=100.0, curve="logarithmic", fillet_factor=0.01),
    "constant clearance": made(tip_cone="constant_clearance", ends="back_cone"),
}
PROFILED = MEMBERS | {
    f"{name} {side}": pair_geometry(design).member(side)
    for name, design in CASES.items()
    for side in ("pinion", "wheel")
}
over_members = pytest.mark.parametrize("member", PROFILED.values(), ids=PROFILED)


def on_sphere(delta: np.ndarray, phi: np.ndarray) -> np.ndarray:
    delta, phi = np.broadcast_arrays(delta, phi)
    return np.stack([np.sin(delta) * np.cos(phi), np.sin(delta) * np.sin(phi), np.cos(delta)], axis=-1)


def ends(profile: ToothProfile, segment: str) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """First and last point of a segment with the directions in which it runs there."""
    s = np.array([0.0, 1e-4, 1 - 1e-4, 1.0])
    points = on_sphere(*profile.angles(segment, s))
    start, end = points[1] - points[0], points[3] - points[2]
    return points[0], points[3], start / np.linalg.norm(start), end / np.linalg.norm(end)


@over_members
def test_segments_meet_and_are_tangent_below_the_tip(member: MemberGeometry) -> None:
    profile = tooth_profile(member)
    for here, there in pairwise(profile.segments):
        _, end, _, leaving = ends(profile, here)
        start, _, arriving, _ = ends(profile, there)
        assert np.abs(end - start).max() < 2e-15, (here, there)
        if there != "tip":
            # an involute that starts on the base cone does so with a direction of its own: along the meridian
            assert leaving @ arriving == pytest.approx(1.0, abs=1e-6), (here, there)


@over_members
def test_it_reaches_from_the_middle_of_a_space_to_the_middle_of_the_tooth(member: MemberGeometry) -> None:
    profile = tooth_profile(member)
    delta, phi = profile.angles(profile.segments[0], 0.0)
    assert phi == pytest.approx(np.pi / member.teeth, abs=1e-12)
    assert delta == pytest.approx(member.root_angle, abs=1e-12)
    if profile.fillet.full_round:
        _, _, across, _ = ends(profile, "fillet")
        assert abs(across[2]) < 1e-3  # level where it meets its mirror image
    delta, phi = profile.angles("tip", 1.0)
    assert (delta, phi) == pytest.approx((member.tip_angle, 0.0), abs=1e-12)


@over_members
def test_the_fillet_is_a_circle_that_touches_the_root_and_cuts_nothing(member: MemberGeometry) -> None:
    made_fillet, profile = fillet(member), tooth_profile(member)
    centre = on_sphere(made_fillet.centre_angle, made_fillet.centre_azimuth)
    points = made_fillet.points(np.linspace(0, 1, 50))
    apart = 2 * np.arcsin(np.linalg.norm(points - centre, axis=-1) / 2)
    assert apart == pytest.approx(np.full(50, made_fillet.radius), abs=1e-13)
    delta, phi = profile.angles("fillet", np.linspace(0, 1, 50))
    assert delta[0] == pytest.approx(member.root_angle, abs=1e-12)
    assert np.all(np.diff(delta) > -1e-14) and np.all(np.diff(phi) < 1e-14)
    if made_fillet.full_round:
        assert made_fillet.centre_azimuth == pytest.approx(np.pi / member.teeth, abs=1e-12)
        assert made_fillet.radius <= member.fillet_angle
    else:
        assert made_fillet.radius == member.fillet_radius / member.outer_cone_distance
    # Every other point of flank, meridian and root is at least a radius from the centre: touching, not crossing.
    for segment in set(profile.segments) - {"fillet", "tip"}:
        others = on_sphere(*profile.angles(segment, np.linspace(0, 1, 200)))
        distances = 2 * np.arcsin(np.linalg.norm(others - centre, axis=-1) / 2)
        assert distances.min() > made_fillet.radius - 1e-13


@over_members
def test_the_foot_lies_where_the_circle_says(member: MemberGeometry) -> None:
    made_fillet = fillet(member)
    foot = made_fillet.points(1.0)
    assert np.arccos(foot[2]) == pytest.approx(made_fillet.foot_angle, abs=1e-9)
    if made_fillet.on_meridian:
        assert made_fillet.foot_angle <= member.base_angle + 2e-8 or made_fillet.foot_arc == 0.0
    else:
        assert made_fillet.foot_angle >= member.base_angle


@over_members
@pytest.mark.parametrize("v", [0.0, 0.37, 1.0])
def test_the_outline_is_a_closed_tooth_with_the_exact_flanks(member: MemberGeometry, v: float) -> None:
    profile, samples = tooth_profile(member), 12
    outline = profile.outline(v, samples)
    count = len(profile.segments)
    assert len(outline) == 2 * (count * (samples - 1)) + 1
    if member.ends == "sphere":
        assert np.abs(outline[-1] - outline[0] @ about_axis(-member.pitch).T).max() < 1e-11 * member.outer_cone_distance
    else:
        assert outline[-1, 2] == pytest.approx(outline[0, 2], rel=1e-12)
    at = profile.segments.index("flank") * (samples - 1)
    ahead, behind = outline[at : at + samples], outline[::-1][at : at + samples]
    for side, points in ((1, ahead), (-1, behind)):
        assert np.abs(InvoluteFlank(member, side).deviation(points)).max() < 2e-11 * max(
            1.0, member.outer_cone_distance / 250
        )


def test_every_case_of_the_root_occurs() -> None:
    fillets = [fillet(member) for member in PROFILED.values()]
    segments = [tooth_profile(member).segments for member in PROFILED.values()]
    assert any(f.full_round for f in fillets) and not all(f.full_round for f in fillets)
    assert any(not f.on_meridian for f in fillets)
    assert any("meridian" in names for names in segments)
    assert any(f.on_meridian and f.full_round for f in fillets)


def test_flanks_that_meet_above_the_root_leave_no_space() -> None:
    design = made(pinion_teeth=60, wheel_teeth=60, profile_shift=1.4, clearance_factor=1.0, pressure_angle_deg=34.0)
    with pytest.raises(GeometryError, match="meet above the root"):
        tooth_profile(pair_geometry(design).pinion)


def test_mean_normal_module_sets_the_radius() -> None:
    design = made(
        outer_module=5.0, face_width_factor=0.2, spiral_angle_deg=30.0, cutter_radius=100.0, fillet_factor=0.25
    )
    pair = pair_geometry(design)
    normal_module = 5.0 * 0.9 * np.cos(np.radians(30.0))
    assert pair.mean_normal_module == pytest.approx(normal_module)
    assert pair.wheel.fillet_radius == pytest.approx(0.25 * normal_module)
