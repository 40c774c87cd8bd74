"""The spherical involute against what it is: the path of a point of a plane that rolls on the base cone."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from gearstudio.design import Design
from gearstudio.errors import GeometryError
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.involute import (
    base_cone_spiral,
    generating_line,
    involute_azimuth,
    polar_angle,
    roll_arc,
    start_azimuth,
)
from gearstudio.theory.involute_flank import InvoluteFlank
from tests.designs import GOLDEN

EPS = np.finfo(float).eps


def rolled_azimuth(polar: float, base: float) -> mpmath.mpf:
    """Azimuth of the rolled point when it reaches a polar angle, to 60 digits, from the rolling alone."""
    with mpmath.workdps(60):
        delta, sin_b, cos_b = mpmath.mpf(polar), mpmath.sin(mpmath.mpf(base)), mpmath.cos(mpmath.mpf(base))

        def point(turn: mpmath.mpf) -> tuple[mpmath.mpf, ...]:
            arc = turn * sin_b  # rolling without slip: as much arc in the plane as on the base circle
            along = (sin_b * mpmath.cos(turn), sin_b * mpmath.sin(turn), cos_b)
            across = (-mpmath.sin(turn), mpmath.cos(turn), mpmath.mpf(0))
            return tuple(mpmath.cos(arc) * t - mpmath.sin(arc) * f for t, f in zip(along, across, strict=True))

        low, high = mpmath.mpf(0), mpmath.pi / (2 * sin_b)
        for _ in range(220):  # the height falls all the way; bisection needs no start
            middle = (low + high) / 2
            low, high = (middle, high) if point(middle)[2] > mpmath.cos(delta) else (low, middle)
        x, y, _ = point(low)
        return mpmath.atan2(y, x)


@pytest.mark.parametrize("base_deg", [1.3, 18.5, 45.0, 62.0, 80.0])
@pytest.mark.parametrize("above", [1e-12, 1e-10, 1e-8, 1e-5, 1e-3, 0.02])
def test_azimuth_near_the_base_cone_to_the_last_digits(base_deg: float, above: float) -> None:
    base = float(np.radians(base_deg))
    delta = base + above
    arc = float(roll_arc(delta, base))
    error = abs(float(involute_azimuth(delta, base)) - float(rolled_azimuth(delta, base)))
    assert error <= 3 * EPS * arc / np.sin(base)


def test_small_cone_is_the_plane_involute() -> None:
    base, pressure = 1e-9, np.linspace(0.0, 1.2, 25)
    with np.errstate(all="raise"):
        found = involute_azimuth(base / np.cos(pressure), base)
    assert found == pytest.approx(np.tan(pressure) - pressure, abs=1e-7)
    assert involute_azimuth(1e-4 / np.cos(pressure), 1e-4) == pytest.approx(np.tan(pressure) - pressure, abs=1e-7)


def test_it_ends_where_it_turned_half_a_great_circle() -> None:
    base = np.radians(25.0)
    assert involute_azimuth(np.pi - base, base) == pytest.approx(np.pi / np.sin(base) - np.pi, abs=1e-7)
    assert involute_azimuth(base, base) == 0.0
    assert np.all(np.diff(involute_azimuth(np.linspace(base, np.pi - base, 500), base)) > 0)


def test_arc_and_polar_angle_undo_each_other() -> None:
    for base in np.radians([1.0, 20.0, 60.0, 80.0]):
        arc = np.r_[0.0, np.geomspace(1e-7, 1.5, 60)]
        lost = 2 * np.sqrt(EPS * np.tan(base))  # of the polar angle itself, which is stationary on the base cone
        assert roll_arc(polar_angle(arc, base), base) == pytest.approx(arc, abs=lost)
        delta = np.linspace(base, np.pi / 2, 60)
        assert polar_angle(roll_arc(delta, base), base) == pytest.approx(delta, abs=1e-14)


@pytest.mark.parametrize("delta", [0.29, np.pi - 0.29, np.nan, np.inf])
def test_there_is_no_involute_inside_the_base_cone(delta: float) -> None:
    with pytest.raises(GeometryError):
        roll_arc(delta, 0.3)


@pytest.mark.parametrize("base", [0.0, -0.1, np.pi / 2, np.nan])
def test_base_angle_must_make_a_cone(base: float) -> None:
    with pytest.raises(GeometryError):
        roll_arc(1.0, base)


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("member_name", ["pinion", "wheel"])
@pytest.mark.parametrize("name", GOLDEN)
class TestGeneratingLine:
    def test_positions_are_one_rigid_line(self, name: str, member_name: str, side: int) -> None:
        member = pair_geometry(GOLDEN[name][0]).member(member_name)
        rho = np.linspace(member.inner_cone_distance, member.outer_cone_distance, 12)
        positions = [generating_line(member, side, rho, turn) for turn in np.linspace(-2.0, 3.0, 9)]
        first = np.linalg.norm(positions[0][:, None] - positions[0][None, :], axis=-1)
        for position in positions[1:]:
            distances = np.linalg.norm(position[:, None] - position[None, :], axis=-1)
            assert np.abs(distances - first).max() < 1e-12 * member.outer_cone_distance
            frame = np.stack([position[1] - position[0], position[5] - position[0], position[0]])
            start = np.stack([positions[0][1] - positions[0][0], positions[0][5] - positions[0][0], positions[0][0]])
            volumes = np.linalg.det(frame), np.linalg.det(start)  # not a mirror image
            assert volumes[0] == pytest.approx(volumes[1], abs=1e-10 * member.outer_cone_distance**3)

    def test_it_moves_as_the_plane_rolls(self, name: str, member_name: str, side: int) -> None:
        """dX/da = cos(delta_b) e_t(a) x X: the rotation about the line of contact that keeps the plane tangent."""
        member = pair_geometry(GOLDEN[name][0]).member(member_name)
        rho = np.linspace(member.inner_cone_distance, member.outer_cone_distance, 5)
        sin_b, cos_b = np.sin(member.base_angle), np.cos(member.base_angle)

        def velocity(a: float, flat: np.ndarray) -> np.ndarray:
            contact = np.array([sin_b * np.cos(a), sin_b * np.sin(a), cos_b])
            return cos_b * np.cross(contact, flat.reshape(-1, 3)).ravel()

        start = generating_line(member, side, rho, 0.2)
        moved = solve_ivp(velocity, (0.2, 0.9), start.ravel(), method="DOP853", rtol=1e-13, atol=1e-13)
        end = moved.y[:, -1].reshape(-1, 3)
        assert np.abs(end - generating_line(member, side, rho, 0.9)).max() < 1e-10 * member.outer_cone_distance

    def test_it_sweeps_the_explicit_flank(self, name: str, member_name: str, side: int) -> None:
        member = pair_geometry(GOLDEN[name][0]).member(member_name)
        flank = InvoluteFlank(member, side)
        rho = np.linspace(member.inner_cone_distance, member.outer_cone_distance, 11)[:, None]
        tip = float(roll_arc(member.tip_angle, member.base_angle))
        turn = start_azimuth(member, side, rho) - side * np.linspace(0, tip, 17) / np.sin(member.base_angle)
        swept = generating_line(member, side, rho, turn)
        assert np.hypot.reduce(swept, axis=-1) == pytest.approx(np.broadcast_to(rho, turn.shape), rel=1e-14)
        delta = np.arctan2(np.hypot(swept[..., 0], swept[..., 1]), swept[..., 2])
        azimuth = np.arctan2(swept[..., 1], swept[..., 0])
        explicit = flank.azimuth(rho, np.maximum(delta, member.base_angle))
        lever = rho * np.sin(delta)
        assert np.abs(np.remainder(azimuth - explicit + np.pi, 2 * np.pi) - np.pi).max() * lever.max() < 2e-11

    def test_it_starts_on_the_base_cone(self, name: str, member_name: str, side: int) -> None:
        member = pair_geometry(GOLDEN[name][0]).member(member_name)
        rho = np.linspace(member.inner_cone_distance, member.outer_cone_distance, 7)
        spiral = base_cone_spiral(member, side, rho)
        assert np.arccos(spiral[:, 2] / rho) == pytest.approx(np.full(7, member.base_angle), abs=1e-13)
        assert np.abs(spiral - InvoluteFlank(member, side).points_at(rho, member.base_angle)).max() < 1e-12


def test_turning_about_the_gear_axis_alone_would_be_no_flank() -> None:
    """What the paper's wording suggests: it gives a surface of revolution (theory 5.1)."""
    member = pair_geometry(Design()).wheel
    rho = np.linspace(member.inner_cone_distance, member.outer_cone_distance, 7)
    line = base_cone_spiral(member, 1, rho)
    c, s = np.cos(0.1), np.sin(0.1)
    turned = line @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
    rolled = generating_line(member, 1, rho, start_azimuth(member, 1, rho[3]) - 0.1)
    assert np.abs(turned - rolled).max() > 0.5
