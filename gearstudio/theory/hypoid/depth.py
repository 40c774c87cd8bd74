"""Tooth depth, its taper and the tooth's thickness after ISO 23509, for hypoid and bevel pairs."""

from __future__ import annotations

from dataclasses import dataclass
from math import atan, cos, pi, radians, sin, tan

from gearstudio.theory.hypoid.inputs import HypoidError, HypoidInput
from gearstudio.theory.hypoid.pitch import PitchCones, trace_curvature

_STEEPEST_TILT = 1.3
_LARGEST_ANGLE = radians(15.0)


@dataclass(frozen=True)
class ToothDepth:
    """Depth at the mean point and the wheel's taper [mm, rad].

    Attributes
    ----------
    working_depth, clearance : float
        h_mw, c.
    addenda, dedenda : (float, float)
        h_am, h_fm of pinion and wheel.
    addendum_angle, dedendum_angle : float
        theta_a2, theta_f2 of the wheel.
    profile_shift, thickness_shift : float
        x_hm1 and x_smn of the pinion; the wheel has the negative.
    """

    working_depth: float
    clearance: float
    addenda: tuple[float, float]
    dedenda: tuple[float, float]
    addendum_angle: float
    dedendum_angle: float
    profile_shift: float
    thickness_shift: float


def suggested_addendum_factor(cones: PitchCones, ratio: float) -> float:
    """c_ham = 0.21 + 0.29 / u_90^2 with u_90^2 = u cos(d1) / cos(d2), the usual choice for ground and lapped pairs."""
    equivalent = ratio * cos(cones.pinion.angle) / cos(cones.wheel.angle)
    return 0.21 + 0.29 / max(equivalent, 1.0)


def addendum_factor_of_shift(profile_shift: float, depth_factor: float) -> float:
    """c_ham that gives the pinion a profile shift: x_hm1 = k_d (1/2 - c_ham)."""
    return 0.5 - profile_shift / depth_factor


def tooth_depth(given: HypoidInput, cones: PitchCones) -> ToothDepth:
    """Depths of both members.

    Raises
    ------
    HypoidError
        A taper or an angle that no tooth can have.
    """
    depth, module = given.depth, cones.mean_normal_module
    share = depth.mean_addendum_factor
    share = suggested_addendum_factor(cones, given.ratio) if share is None else share
    working = depth.depth_factor * module
    clearance = depth.clearance_factor * working
    wheel = share * working
    addenda = (working - wheel, wheel)
    dedenda = (clearance + wheel, clearance + working - wheel)
    addendum_angle, dedendum_angle = _taper(given, cones, wheel / working, dedenda)
    if depth.addendum_angle_deg is not None:
        addendum_angle = radians(depth.addendum_angle_deg)
    if depth.dedendum_angle_deg is not None:
        dedendum_angle = radians(depth.dedendum_angle_deg)
    return ToothDepth(
        working_depth=working,
        clearance=clearance,
        addenda=addenda,
        dedenda=dedenda,
        addendum_angle=addendum_angle,
        dedendum_angle=dedendum_angle,
        profile_shift=depth.depth_factor * (0.5 - share),
        thickness_shift=depth.thickness_factor / 2,
    )


def standard_sum(cones: PitchCones, dedenda: tuple[float, float]) -> float:
    """Sum of the dedendum angles of standard depth [rad]: both root lines through the wheel's pitch apex."""
    return sum(atan(dedendum / cones.wheel.mean_cone_distance) for dedendum in dedenda)


def duplex_sum(given: HypoidInput, cones: PitchCones) -> float:
    """Sum of the dedendum angles for which both slots keep their width along the face [rad].

    Notes
    -----
    The slots' widths at the root add up to pi m_n(R) - 2 (h_f1 + h_f2) tan(alpha_n); with m_n(R) = (m_mt / R_m) R
    cos(beta) and d(R cos beta)/dR = (1 - R_m sin(beta) kappa) / cos(beta) this does not depend on R for
    sum = (pi / 2) (m_mt / R_m) (1 - R_m sin(beta_m) kappa) / (tan(alpha_n) cos(beta_m)), kappa = 1 / r_c0 for an arc.
    """
    wheel = cones.wheel
    transverse = 2 * sin(wheel.angle) / given.wheel_teeth
    curvature = trace_curvature(given, wheel.mean_cone_distance, wheel.spiral_angle)
    straightness = 1 - wheel.mean_cone_distance * sin(wheel.spiral_angle) * curvature
    flatness = tan(radians(given.pressure_angle_deg)) * cos(wheel.spiral_angle)
    return pi / 2 * transverse * straightness / flatness


def _taper(
    given: HypoidInput, cones: PitchCones, wheel_share: float, dedenda: tuple[float, float]
) -> tuple[float, float]:
    """theta_a2 and theta_f2 [rad] of the depth's taper."""
    kind = given.depth.taper
    if kind == "uniform":
        return 0.0, 0.0
    standard = standard_sum(cones, dedenda)
    if kind == "standard":
        addendum = atan(dedenda[0] / cones.wheel.mean_cone_distance)
        return addendum, standard - addendum
    total = duplex_sum(given, cones)
    if kind == "tilted_root":
        total = min(total, _STEEPEST_TILT * standard)
    if abs(total) > _LARGEST_ANGLE:
        other = "the tilted root line" if kind == "duplex" and total > 0 else "the standard taper"
        raise HypoidError(
            "depth.taper",
            f"a constant slot width would taper the depth by {total * 180 / pi:.4g}°, beyond "
            f"{_LARGEST_ANGLE * 180 / pi:.4g}°; use {other}",
        )
    return total * wheel_share, total * (1 - wheel_share)
