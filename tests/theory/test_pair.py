"""The pair in mesh: conjugate flanks found by rolling them, contact ratio by counting, clearance by measuring."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq, minimize

from gearstudio.design import Design
from gearstudio.theory.cones import MemberGeometry, PairGeometry, pair_geometry
from gearstudio.theory.involute_flank import InvoluteFlank
from gearstudio.theory.pair import (
    interference,
    overlap_ratio,
    pinion_placement,
    tip_half_azimuth,
    transverse_contact_ratio,
    wheel_placement,
)
from tests.theory.members import DESIGNS, made


def lag(pair: PairGeometry, side: int, turn: float, points: np.ndarray) -> np.ndarray:
    """Angle by which the wheel may still turn before its flank meets pinion points; infinite off the flank."""
    wheel = pair.wheel
    seen = points @ pinion_placement(pair, turn).T @ wheel_placement(pair, turn)
    rho, delta = np.linalg.norm(seen, axis=-1), np.arctan2(np.hypot(seen[..., 0], seen[..., 1]), seen[..., 2])
    azimuth = np.arctan2(seen[..., 1], seen[..., 0])
    flank = InvoluteFlank(wheel, side)
    ahead = azimuth - flank.azimuth(rho, np.maximum(delta, wheel.base_angle))
    ahead = np.remainder(ahead + wheel.pitch / 2, wheel.pitch) - wheel.pitch / 2
    there = (delta >= wheel.base_angle) & (delta <= wheel.tip_limit.at_sphere(rho))
    return np.where(there, side * ahead, np.inf)


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("name", DESIGNS)
def test_flanks_roll_on_each_other_without_gap_or_cut(name: str, side: int) -> None:
    design = DESIGNS[name]
    plain = design.model_copy(update={"tooth": design.tooth.model_copy(update={"backlash": 0.0})})
    pair = pair_geometry(plain)
    pinion = InvoluteFlank(pair.pinion, side)
    u, v = np.linspace(0, 1, 41)[:, None], np.linspace(0, 1, 41)[None, :]
    grid = pinion.points(u, v)
    errors = []
    for turn in np.array([-0.37, 0.0, 0.23]) * pair.pinion.pitch:
        lags = lag(pair, side, turn, grid)
        best = np.unravel_index(np.argmin(lags), lags.shape)

        def objective(x: np.ndarray, turn: float = turn) -> float:
            return float(np.minimum(lag(pair, side, turn, pinion.points(*np.clip(x, 0, 1))), 1.0))

        start = np.array([u[best[0], 0], v[0, best[1]]])
        found = minimize(
            objective, start, method="Nelder-Mead", options={"xatol": 1e-12, "fatol": 1e-16, "maxfev": 400}
        )
        errors.append(min(found.fun, float(lags[best])))
    assert min(errors) > -1e-10  # nowhere do they cut
    assert max(np.abs(errors)) < 1e-8  # at every position they touch: no transmission error


def test_backlash_opens_a_gap_of_that_size() -> None:
    pair = pair_geometry(made(backlash=0.2, ends="sphere"))
    turns = []
    for side in (1, -1):
        points = InvoluteFlank(pair.pinion, side).points(
            np.linspace(0, 1, 400)[:, None], np.linspace(0, 1, 60)[None, :]
        )
        turns.append(float(lag(pair, side, 0.1, points).min()))
    play = sum(turns) * pair.wheel.outer_cone_distance * np.sin(pair.wheel.pitch_angle)
    assert play == pytest.approx(0.2, rel=2e-3)


def contact_turn(member: MemberGeometry, polar: float) -> float:
    """Turn at which the profile's normal at a polar angle runs through the pitch element: the law of gearing."""
    flank = InvoluteFlank(member, 1)

    def at(delta: float) -> np.ndarray:
        return flank.points_at(1.0, delta)

    step = 1e-6
    tangent = (at(polar + step) - at(polar - step)) / (2 * step)

    def miss(turn: float) -> float:
        pitch = np.array([np.sin(member.pitch_angle) * np.cos(turn), np.sin(member.pitch_angle) * np.sin(turn), 0.0])
        pitch[2] = np.cos(member.pitch_angle)
        return float(tangent @ (pitch - at(polar) * (pitch @ at(polar))))

    # The pitch point travels in the pinion's frame; near the point of contact there is one crossing.
    turns = np.linspace(-1.2, 1.2, 301)
    values = np.array([miss(turn) for turn in turns])
    crossings = np.flatnonzero(np.sign(values[:-1]) != np.sign(values[1:]))
    azimuth = float(flank.azimuth(1.0, polar))
    nearest = min(crossings, key=lambda i: abs(turns[i] - azimuth))
    return float(brentq(miss, turns[nearest], turns[nearest + 1], xtol=1e-14))


@pytest.mark.parametrize("fields", [{}, {"pinion_teeth": 24, "wheel_teeth": 31, "shaft_angle_deg": 75.0}])
def test_contact_ratio_is_the_turn_in_contact_over_the_pitch(fields: dict[str, float]) -> None:
    """Straight teeth on the heel sphere: from the contact at the wheel's tip to that at the pinion's."""
    pair = pair_geometry(made(curve="archimedean", spiral_angle_deg=0.0, pressure_angle_deg=24.0, **fields))
    swept = 0.0
    for member in (pair.pinion, pair.wheel):
        turn = abs(contact_turn(member, member.tip_angle) - contact_turn(member, member.pitch_angle))
        swept += turn / member.pitch
    assert transverse_contact_ratio(pair) == pytest.approx(swept, abs=1e-6)


def test_overlap_is_the_turn_from_toe_to_heel_over_the_pitch() -> None:
    pair = pair_geometry(made(curve="logarithmic", spiral_angle_deg=30.0))
    turn = np.tan(np.radians(30.0)) * np.log(1 / 0.7) / np.sin(pair.pinion.pitch_angle)
    assert overlap_ratio(pair) == pytest.approx(turn * 17 / (2 * np.pi), rel=1e-12)


def test_constant_clearance_is_constant_in_space() -> None:
    """Points of one member's face cone in the common axial plane, measured against the mate's root cone."""
    pair = pair_geometry(made(tip_cone="constant_clearance", clearance_factor=0.3, shaft_angle_deg=80.0, ends="sphere"))
    rho = np.linspace(pair.pinion.inner_cone_distance, pair.pinion.outer_cone_distance, 9)

    def in_plane(member: MemberGeometry, placement: np.ndarray, azimuth: float, delta: np.ndarray) -> np.ndarray:
        local = np.stack([rho * np.sin(delta) * np.cos(azimuth), rho * np.sin(delta) * np.sin(azimuth)], -1)
        return np.column_stack([local, rho * np.cos(delta)]) @ placement.T

    to_world = {"pinion": pinion_placement(pair), "wheel": wheel_placement(pair)}
    towards_mate = {"pinion": 0.0, "wheel": -np.pi / pair.wheel.teeth}
    for name, mate_name in (("pinion", "wheel"), ("wheel", "pinion")):
        member, mate = pair.member(name), pair.member(mate_name)
        tips = in_plane(member, to_world[name], towards_mate[name], member.tip_limit.at_sphere(rho))
        assert np.abs(tips[:, 1]).max() < 1e-12
        axis = to_world[mate_name] @ [0.0, 0.0, 1.0]
        along = tips @ axis
        away = np.linalg.norm(tips - along[:, None] * axis, axis=-1)
        clearance = along * np.sin(mate.root_angle) - away * np.cos(mate.root_angle)
        assert clearance == pytest.approx(np.full(9, clearance[0]), abs=1e-12)
        dedendum_angle = mate.pitch_angle - mate.root_angle
        assert abs(clearance[0]) == pytest.approx(0.3 * 4.0 * np.cos(dedendum_angle), rel=1e-9)


def test_the_pitch_cones_touch_along_one_element() -> None:
    for design in DESIGNS.values():
        pair = pair_geometry(design)
        element = []
        for member, place, azimuth in ((pair.pinion, pinion_placement(pair), 0.0), (pair.wheel, np.eye(3), 0.0)):
            sin_d, cos_d = np.sin(member.pitch_angle), np.cos(member.pitch_angle)
            element.append(place @ [sin_d * np.cos(azimuth), sin_d * np.sin(azimuth), cos_d])
        assert element[0] == pytest.approx(element[1], abs=1e-14)
        diameters = [2 * m.outer_cone_distance * np.sin(m.pitch_angle) for m in (pair.pinion, pair.wheel)]
        teeth = [pair.pinion.teeth, pair.wheel.teeth]
        assert diameters == pytest.approx([design.pair.outer_module * z for z in teeth], rel=1e-13)


def test_interference_starts_where_the_mate_has_no_involute_left() -> None:
    """At the limit the wheel's tip meets the pinion's flank exactly on the base cone."""

    def over(factor: float) -> float:
        pair = pair_geometry(made(addendum_factor=factor, pinion_teeth=12))
        return interference(pair, pair.wheel)

    limit = brentq(over, 0.2, 1.5, xtol=1e-13)
    pair = pair_geometry(made(addendum_factor=limit, pinion_teeth=12))
    wheel_tip = pair.wheel.tip_angle
    # The plane of action through the pitch element holds both points: base to base along one great circle.
    arc = np.arccos(np.cos(wheel_tip) / np.cos(pair.wheel.base_angle))
    reach = sum(np.arccos(np.cos(m.pitch_angle) / np.cos(m.base_angle)) for m in (pair.pinion, pair.wheel))
    assert arc == pytest.approx(reach, abs=1e-10)
    assert over(limit * 1.05) > 0 > over(limit * 0.95)


def test_a_pointed_tooth_has_no_tip() -> None:
    member = pair_geometry(made(pressure_angle_deg=32.0, addendum_factor=1.4)).pinion
    sides = [InvoluteFlank(member, side).points_at(80.0, member.tip_angle) for side in (1, -1)]
    azimuths = [np.arctan2(p[1], p[0]) - float(member.lengthwise.azimuth(80.0)) for p in sides]
    assert tip_half_azimuth(member, 80.0) == pytest.approx((azimuths[0] - azimuths[1]) / 2, abs=1e-12)
    assert tip_half_azimuth(member, 80.0) < 0
    assert tip_half_azimuth(pair_geometry(Design()).pinion, 80.0) > 0
