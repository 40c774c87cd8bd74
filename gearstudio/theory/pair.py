"""The pair in mesh: placing, contact ratios, limits (theory 8)."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.theory.cones import MemberGeometry, PairGeometry
from gearstudio.theory.hypoid.ratios import contact_ratios
from gearstudio.theory.involute import base_azimuth, involute_azimuth
from gearstudio.theory.vectors import about_axis

Floats = NDArray[np.float64]


def pinion_placement(pair: PairGeometry, pinion_turn: float = 0.0) -> Floats:
    """Matrix that takes pinion points to the world frame, R_y(Sigma) R_z(pi) R_z(phi_1), shape (3, 3).

    The wheel's axis is the world's +z; a pinion tooth stands in the common pitch plane at turn 0.
    """
    c, s = np.cos(pair.shaft_angle), np.sin(pair.shaft_angle)
    tilt = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
    return tilt @ about_axis(np.pi + pinion_turn)


def wheel_placement(pair: PairGeometry, pinion_turn: float = 0.0) -> Floats:
    """Matrix that takes wheel points to the world frame: phi_2 = -phi_1 z_1/z_2, a space facing the pinion tooth."""
    ratio = pair.pinion.teeth / pair.wheel.teeth
    return about_axis(np.pi / pair.wheel.teeth - pinion_turn * ratio)


def placement(pair: PairGeometry, name: str, pinion_turn: float = 0.0) -> tuple[Floats, Floats]:
    """Matrix (3, 3) and shift (3,) [mm] that take a member's points, about its pitch apex, to the world.

    Without an offset both apexes are the world's origin; with one it is the wheel's crossing point.
    """
    if pair.hypoid is None or not pair.has_offset:
        turn = pinion_placement if name == "pinion" else wheel_placement
        return turn(pair, pinion_turn), np.zeros(3)
    axes = pair.hypoid.axes
    if name == "pinion":
        return axes.pinion_placement(pinion_turn)
    return axes.wheel_placement(pair.wheel.teeth, -pinion_turn * pair.pinion.teeth / pair.wheel.teeth)


def transverse_contact_ratio(pair: PairGeometry) -> float:
    """epsilon_alpha on the heel sphere (theory 8); with an offset that of `contact_ratios`."""
    if pair.hypoid is not None and pair.has_offset:
        return contact_ratios(pair.hypoid)[0]
    path = sum(tip_arc(m) - m.gamma for m in (pair.pinion, pair.wheel))
    return float(path * pair.pinion.teeth / (2 * np.pi * np.sin(pair.pinion.base_angle)))


def overlap_ratio(pair: PairGeometry) -> float:
    """epsilon_beta (theory 8); with an offset that of `contact_ratios`."""
    if pair.hypoid is not None and pair.has_offset:
        return contact_ratios(pair.hypoid)[1]
    wheel = pair.wheel
    theta = wheel.lengthwise.azimuth([wheel.inner_cone_distance, wheel.outer_cone_distance])
    return float(abs(theta[1] - theta[0]) / wheel.pitch)


def total_contact_ratio(pair: PairGeometry) -> float:
    """The modified contact ratio, the root of the sum of both squares; with an offset that of the whole flank."""
    if pair.hypoid is not None and pair.has_offset:
        return contact_ratios(pair.hypoid)[2]
    return float(np.hypot(transverse_contact_ratio(pair), overlap_ratio(pair)))


def tip_arc(member: MemberGeometry) -> float:
    """arccos(cos delta_a / cos delta_b): rolled arc at which the heel's tip is reached [rad]."""
    tip = float(member.tip_limit.at_sphere(member.outer_cone_distance))
    return float(np.arccos(np.clip(np.cos(tip) / np.cos(member.base_angle), -1.0, 1.0)))


def interference(pair: PairGeometry, member: MemberGeometry) -> float:
    """How far the tip of a member passes the mate's base cone, as arc [rad]; positive interferes (theory 8)."""
    return tip_arc(member) - (pair.pinion.gamma + pair.wheel.gamma)


def tip_half_azimuth(member: MemberGeometry, rho: ArrayLike) -> Floats:
    """Half the tooth's azimuth at its tip at cone distances rho [rad]; not positive means pointed (theory 8)."""
    tip_beta = involute_azimuth(member.tip_limit.at_sphere(rho), member.base_angle)
    return np.asarray(base_azimuth(member) - tip_beta)
