"""Micro-geometry in theory: heights at stated places, derivatives, normals, deviation, mirror and scale."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings

from gearstudio.design import Design, field_specs, with_field
from gearstudio.theory.cones import MemberGeometry, pair_geometry
from gearstudio.theory.flank import FLANKS, FlankName
from gearstudio.theory.involute_flank import InvoluteFlank, involute_flank
from gearstudio.theory.modified import ModifiedFlank, flank_of
from gearstudio.theory.profile import tooth_profile
from gearstudio.theory.relief import FlankRelief
from tests.strategies import modified_designs
from tests.theory.members import CORNERS, made

Floats = np.ndarray
ALL = {
    "lengthwise_crowning_um": 15.0,
    "profile_crowning_um": 8.0,
    "spiral_angle_correction_um": 12.0,
    "pressure_angle_correction_um": -9.0,
    "bias_um": 7.0,
    "tip_relief_um": 20.0,
    "tip_relief_start": 0.75,
    "root_relief_um": 11.0,
    "root_relief_end": 0.2,
}
DESIGNS = {
    "default": Design(),
    "spheres": made(ends="sphere", tip_cone="constant_clearance"),
    "archimedean": made(curve="archimedean", tip_cone="constant_clearance", profile_shift=0.3),
    "logarithmic": made(curve="logarithmic", pinion_hand="right"),
    "crown": CORNERS["crown"],
    "steep": CORNERS["steep"],
}
KEYS = [spec.path.rpartition(".")[2] for spec in field_specs() if spec.path.startswith("modifications.pinion.concave.")]


def modified(design: Design, fields: dict[str, float] | None = None) -> Design:
    """The design with the same micro-geometry on all four flanks."""
    flanks = dict.fromkeys(FLANKS, ALL if fields is None else fields)
    return Design.model_validate({**design.model_dump(), "modifications": {"pinion": flanks, "wheel": flanks}})


def flanks_of(design: Design) -> list[ModifiedFlank]:
    pair = pair_geometry(design)
    found = [flank_of(member, name) for member in (pair.pinion, pair.wheel) for name in FLANKS]
    assert all(isinstance(flank, ModifiedFlank) for flank in found)
    return found  # type: ignore[return-value]


def relief_of(flank: InvoluteFlank) -> FlankRelief:
    assert isinstance(flank, ModifiedFlank) and flank.relief is not None
    return flank.relief


over_flanks = pytest.mark.parametrize(
    "flank",
    [flank for design in DESIGNS.values() for flank in flanks_of(modified(design))],
    ids=[f"{name} {member} {side}" for name in DESIGNS for member in ("pinion", "wheel") for side in FLANKS],
)
U, V = np.linspace(0.0, 1.0, 9)[:, None], np.linspace(0.0, 1.0, 7)[None, :]


def test_without_micro_geometry_the_flank_is_the_involute_itself() -> None:
    pair = pair_geometry(modified(Design(), {"tip_relief_start": 0.6, "lengthwise_crowning_um": 0.0}))
    assert pair == pair_geometry(Design())
    for name in FLANKS:
        assert type(flank_of(pair.wheel, name)) is InvoluteFlank
        assert flank_of(pair.wheel, name) == involute_flank(pair.wheel, name)


@over_flanks
def test_points_lie_on_the_flank_and_on_its_limits(flank: ModifiedFlank) -> None:
    points, scale = flank.points(U, V), flank.member.outer_cone_distance
    assert np.abs(flank.deviation(points)).max() < 1e-14 * scale
    assert flank.edge_deviation(points) < 1e-12 * scale
    rho, delta, phi = flank.locate(points)
    turned = np.remainder(phi - flank.azimuth(rho, np.maximum(delta, flank.member.base_angle)) + 1, 2 * np.pi) - 1
    assert np.abs(turned).max() < 1e-13


@over_flanks
def test_the_unmodified_flank_is_missed_by_what_is_taken_off(flank: ModifiedFlank) -> None:
    points = flank.points(U, V)
    taken = relief_of(flank).value(*flank.locate(points)[:2])
    missed = -flank.swept.deviation(points)
    assert np.ptp(taken) > 0.03
    assert missed == pytest.approx(taken, abs=2e-4)  # of second order in 60 µm


@over_flanks
@pytest.mark.parametrize("share", [1e-9, -1e-9, 1e-6, -1e-6, 1e-4, -1e-4])
def test_a_point_moved_along_the_normal_deviates_by_that_much(flank: ModifiedFlank, share: float) -> None:
    scale = flank.member.outer_cone_distance
    u = np.linspace(0.05, 1.0, 7)[:, None]
    error = flank.deviation(flank.points(u, V) + share * scale * flank.normals(u, V)) - share * scale
    assert np.abs(error).max() < 2e-12 * scale + 1e-5 * abs(share) * scale


@over_flanks
@pytest.mark.parametrize("share", [1e-9, -1e-9, 1e-6])
def test_so_it_does_on_the_lower_edge(flank: ModifiedFlank, share: float) -> None:
    scale = flank.member.outer_cone_distance
    error = flank.deviation(flank.points(0.0, V) + share * scale * flank.normals(0.0, V)) - share * scale
    assert np.abs(error).max() < 2e-12 * scale + 1e-5 * abs(share) * scale


@over_flanks
def test_derivatives_are_those_of_differences(flank: ModifiedFlank) -> None:
    psi, rho = flank.coordinates(np.linspace(0.05, 0.95, 7)[:, None], V)
    h, k = 1e-5, 1e-5 * flank.member.outer_cone_distance
    ahead, behind = flank.derivatives_at(psi + h, rho), flank.derivatives_at(psi - h, rho)
    out, back = flank.derivatives_at(psi, rho + k), flank.derivatives_at(psi, rho - k)
    differences = (
        (flank.at(psi + h, rho) - flank.at(psi - h, rho)) / (2 * h),
        (flank.at(psi, rho + k) - flank.at(psi, rho - k)) / (2 * k),
        (ahead[0] - behind[0]) / (2 * h),
        (ahead[1] - behind[1]) / (2 * h),
        (out[1] - back[1]) / (2 * k),
    )
    for found, expected in zip(flank.derivatives_at(psi, rho), differences, strict=True):
        assert found == pytest.approx(expected, abs=1e-7 * np.abs(expected).max())
    x_psi, x_rho, *_ = flank.derivatives_at(psi, rho)
    cross = np.cross(x_psi, x_rho)
    cross /= np.linalg.norm(cross, axis=-1, keepdims=True)
    assert np.abs(np.sum(cross * flank.normals_at(psi, rho), axis=-1)) == pytest.approx(1.0, abs=1e-12)


@over_flanks
def test_the_flank_starts_regularly(flank: ModifiedFlank) -> None:
    """On the base cone the derivative by psi vanishes as without micro-geometry, and the normal has a limit."""
    psi, rho = flank.coordinates(0.0, np.linspace(0, 1, 5))
    if flank.starts_on_base:
        assert np.abs(flank.derivatives_at(psi, rho)[0]).max() < 1e-7 * flank.member.outer_cone_distance
    near = flank.normals_at(psi + 1e-7, rho)
    assert flank.normals_at(psi, rho) == pytest.approx(near, abs=1e-5)


def test_third_derivative_of_the_lengthwise_curves() -> None:
    for design in DESIGNS.values():
        law = pair_geometry(design).pinion.lengthwise
        rho = law.mean_cone_distance * np.linspace(0.9, 1.1, 7)
        h = 1e-5 * law.mean_cone_distance
        differences = (law.azimuth_derivatives(rho + h)[2] - law.azimuth_derivatives(rho - h)[2]) / (2 * h)
        assert law.azimuth_third(rho) == pytest.approx(differences, rel=1e-6, abs=1e-16)


CORNER = {"toe": -1.0, "heel": 1.0, "root": -1.0, "tip": 1.0, "middle": 0.0}


@pytest.mark.parametrize(
    ("fields", "along", "across", "taken_um"),
    [
        ({"lengthwise_crowning_um": 12.0}, "toe", "middle", 12.0),
        ({"lengthwise_crowning_um": 12.0}, "heel", "tip", 12.0),
        ({"lengthwise_crowning_um": 12.0}, "middle", "tip", 0.0),
        ({"profile_crowning_um": 9.0}, "heel", "root", 9.0),
        ({"profile_crowning_um": 9.0}, "toe", "middle", 0.0),
        ({"spiral_angle_correction_um": 10.0}, "heel", "middle", -5.0),
        ({"spiral_angle_correction_um": 10.0}, "toe", "root", 5.0),
        ({"pressure_angle_correction_um": 10.0}, "middle", "tip", -5.0),
        ({"pressure_angle_correction_um": 10.0}, "heel", "root", 5.0),
        ({"bias_um": 8.0}, "heel", "tip", -4.0),
        ({"bias_um": 8.0}, "toe", "root", -4.0),
        ({"bias_um": 8.0}, "toe", "tip", 4.0),
        ({"tip_relief_um": 20.0}, "toe", "tip", 20.0),
        ({"tip_relief_um": 20.0}, "toe", "middle", 0.0),
        ({"root_relief_um": 20.0}, "heel", "root", 20.0),
        ({"root_relief_um": 20.0}, "heel", "middle", 0.0),
    ],
)
def test_heights_at_their_places(fields: dict[str, float], along: str, across: str, taken_um: float) -> None:
    for base in DESIGNS.values():
        for flank in flanks_of(modified(base, fields)):
            v = (CORNER[along] + 1) / 2
            low, high = (np.asarray(x) for x in flank.limits(np.array([v])))
            delta = (low + high) / 2 + CORNER[across] * (high - low) / 2
            rho = flank.member.cone_distance(flank.member.inner_cone_distance + v * flank.member.face_width, delta)
            found = 1e3 * relief_of(flank).value(rho, delta)
            # on back cones the tip cone of another apex is nearer or farther at the middle of the depth
            assert found == pytest.approx(taken_um, abs=0.02 * abs(taken_um) + 0.02)


def test_relief_begins_where_it_is_said_to_and_without_a_kink() -> None:
    (flank, *_) = flanks_of(modified(Design(), {"tip_relief_um": 20.0, "tip_relief_start": 0.7}))
    eta = np.array([0.39, 0.4, 0.41, 1.0])
    below, start, above, tip = relief_of(flank).over(0.3, eta) * 1e3
    assert (below, start, tip) == pytest.approx((0.0, 0.0, 20.0), abs=1e-12)
    assert 0 < above == pytest.approx(20.0 * (0.01 / 0.6) ** 3)


def test_effects_add_up() -> None:
    singles = [{key: value} for key, value in ALL.items() if key.endswith("_um")]
    places = {key: value for key, value in ALL.items() if not key.endswith("_um")}
    together = flanks_of(modified(Design()))
    parts = [flanks_of(modified(Design(), {**places, **one})) for one in singles]
    for index, flank in enumerate(together):
        rho, delta, _ = flank.locate(flank.points(U, V))
        summed = sum(relief_of(part[index]).value(rho, delta) for part in parts)
        assert relief_of(flank).value(rho, delta) == pytest.approx(summed, abs=1e-15)


@pytest.mark.parametrize("member", ["pinion", "wheel"])
@pytest.mark.parametrize("name", FLANKS)
@pytest.mark.parametrize("key", KEYS)
def test_every_field_moves_its_own_flank_alone(member: str, name: FlankName, key: str) -> None:
    amount = {"tip_relief_start": "tip_relief_um", "root_relief_end": "root_relief_um"}.get(key)
    path = f"modifications.{member}.{name}."
    before = Design() if amount is None else with_field(Design(), path + amount, 20.0)
    after = with_field(before, path + key, 5.0 if amount is None else 0.5)
    for other in ("pinion", "wheel"):
        for side in FLANKS:
            old, new = (flank_of(pair_geometry(d).member(other), side).points(U, V) for d in (before, after))
            assert np.array_equal(old, new) != (other == member and side == name)


def test_the_other_hand_is_the_mirror_image() -> None:
    ours = flanks_of(modified(Design()))
    theirs = flanks_of(modified(made(pinion_hand="right")))
    for a, b in zip(ours, theirs, strict=True):
        assert a.name == b.name and a.side == -b.side
        assert b.points(U, V) * [1, -1, 1] == pytest.approx(a.points(U, V), abs=1e-12)


def test_twice_as_large_with_twice_the_micrometres_is_twice_as_large() -> None:
    doubled = {key: value * (2 if key.endswith("_um") else 1) for key, value in ALL.items()}
    small = flanks_of(modified(Design()))
    large = flanks_of(modified(made(outer_module=8.0, cutter_radius=160.0), doubled))
    for a, b in zip(small, large, strict=True):
        assert b.points(U, V) == pytest.approx(2 * a.points(U, V), abs=1e-11)


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("name", DESIGNS)
def test_the_profile_goes_on_below_the_flank_and_fades_out(name: str, side: int) -> None:
    for member in (pair_geometry(modified(DESIGNS[name])).member(m) for m in ("pinion", "wheel")):
        profile = tooth_profile(member)
        top = member.base_angle if profile.fillet.on_meridian else profile.fillet.foot_angle
        rho = member.mean_cone_distance
        h = 1e-4 * (top - member.root_angle)
        below, at, above = profile.shift(side, rho, top + h * np.array([-1.0, 0.0, 1.0]))
        assert above - at == pytest.approx(at - below, rel=5e-3, abs=1e-9 * abs(at) + 1e-12)
        root, next_to = profile.shift(side, rho, member.root_angle + np.array([0.0, h]))
        assert root == 0.0 and abs(next_to) < 1e-6 * abs(at) + 1e-9


def test_outline_of_a_modified_tooth_has_its_flanks() -> None:
    member: MemberGeometry = pair_geometry(modified(Design())).wheel
    points = tooth_profile(member).outline(1.0, samples=12)
    deviations = np.stack([np.abs(flank_of(member, name).deviation(points)) for name in FLANKS])
    on_flank = np.sum(deviations < 1e-9, axis=1)
    assert np.all(on_flank >= 12)


@settings(max_examples=12, deadline=None, suppress_health_check=list(HealthCheck))
@given(modified_designs())
def test_random_modified_flanks_are_consistent(design: Design) -> None:
    pair = pair_geometry(design)
    for member in (pair.pinion, pair.wheel):
        scale: Any = member.outer_cone_distance
        for name in FLANKS:
            flank = flank_of(member, name)
            points, normals = flank.points(U, V), flank.normals(U, V)
            assert np.abs(flank.deviation(points)).max() < 1e-12 * scale
            moved = flank.deviation(points[1:] + 1e-6 * scale * normals[1:])
            assert moved == pytest.approx(np.full(moved.shape, 1e-6 * scale), rel=1e-3)
