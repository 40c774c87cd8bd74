"""Numbers of the sizes that a tooth has at its ends and in the middle."""

from __future__ import annotations

import numpy as np

from gearstudio.equations.records import Numbers, Subject, deg, mm, pure, rad
from gearstudio.theory.involute import azimuth_from_arc, involute_azimuth, roll_arc
from gearstudio.theory.limit import ConeLimit
from gearstudio.theory.pair import interference, tip_arc, tip_half_azimuth


def mean_module(s: Subject) -> Numbers:
    """m_n of a pair without offset."""
    m, spiral = s.member, s.pair.mean_spiral_angle
    outer, mean = m.outer_cone_distance, m.mean_cone_distance
    return Numbers(
        (mm("m", m.module), mm("R_m", mean), mm("R", outer), deg("beta_m", spiral)),
        (mm("m_n", m.module * mean / outer * np.cos(spiral)),),
    )


def own_depth(s: Subject) -> Numbers:
    """Addendum and dedendum at the heel; the factors follow from both members' depths."""
    m, mate, sign = s.member, s.mate, 1 if s.member is s.pair.pinion else -1
    factor = (m.addendum + mate.addendum) / (2 * m.module)
    shift = (m.addendum - mate.addendum) / (2 * m.module)
    clearance = m.dedendum / m.module - factor + shift
    return Numbers(
        (
            mm("m", m.module),
            pure("h_a^*", factor),
            pure("c^*", clearance),
            pure("x_1" if sign > 0 else "x_2", shift),
        ),
        (mm("h_(a e)", m.module * (factor + shift)), mm("h_(f e)", m.module * (factor + clearance - shift))),
    )


def heights(s: Subject) -> Numbers:
    """Addendum and dedendum at the mean point."""
    m = s.member
    outer, mean = m.outer_cone_distance, m.mean_cone_distance
    add, ded = m.tip_angle - m.pitch_angle, m.pitch_angle - m.root_angle
    return Numbers(
        (
            mm("h_(a e)", m.addendum),
            mm("R", outer),
            mm("R_m", mean),
            deg("theta_a", add),
            deg("theta_f", ded),
        ),
        (mm("h_(a m)", m.addendum - (outer - mean) * np.tan(add)), mm("h_(f m)", mean * np.tan(ded))),
    )


def tip_parallel(s: Subject) -> Numbers | None:
    """Face angle of a member whose tips run parallel to the mate's root."""
    m, mate = s.member, s.mate
    if not m.tip_limit.offset:
        return None
    return Numbers(
        (deg("delta", m.pitch_angle), deg("delta'", mate.pitch_angle), deg("delta'_f", mate.root_angle)),
        (deg("delta_a", m.pitch_angle + mate.pitch_angle - mate.root_angle),),
    )


def _above(limit: ConeLimit, rho: float) -> float:
    """Height of a cone over the pitch cone at a cone distance, square to it [mm]."""
    lean = limit.angle - limit.pitch_angle
    return float(limit.offset / np.cos(lean) + rho * np.tan(lean))


def diameters(s: Subject) -> Numbers:
    """Diameters at the heel."""
    m, outer = s.member, s.member.outer_cone_distance
    add, ded = _above(m.tip_limit, outer), -_above(m.root_limit, outer)
    pitch, cosine = 2 * outer * np.sin(m.pitch_angle), np.cos(m.pitch_angle)
    return Numbers(
        (mm("R", outer), deg("delta", m.pitch_angle), mm("h_(a e)", add), mm("h_(f e)", ded)),
        (mm("d_e", pitch), mm("d_(a e)", pitch + 2 * add * cosine), mm("d_(f e)", pitch - 2 * ded * cosine)),
    )


def crown(s: Subject) -> Numbers:
    """Crown to the crossing point."""
    m, outer, pair = s.member, s.member.outer_cone_distance, s.pair.hypoid
    apex = 0.0 if pair is None else (pair.cones.pinion if m is s.pair.pinion else pair.cones.wheel).apex_beyond
    add = _above(m.tip_limit, outer)
    return Numbers(
        (mm("R", outer), deg("delta", m.pitch_angle), mm("h_(a e)", add), mm("t_z", apex)),
        (mm("t_(x o)", outer * np.cos(m.pitch_angle) - apex - add * np.sin(m.pitch_angle)),),
    )


def ends(s: Subject) -> Numbers | None:
    """Cone distance of the tip's corner on the back cone."""
    m = s.member
    if m.ends == "sphere":
        return None
    outer = m.outer_cone_distance
    tip = float(m.limit_angle(m.tip_limit, outer))
    return Numbers(
        (mm("rho_u = R", outer), deg("delta", m.pitch_angle), deg("delta_k = delta_a (rho)", tip)),
        (mm("rho", float(m.cone_distance(outer, tip))),),
    )


def thickness(s: Subject) -> Numbers:
    """Thickness of the tooth along the pitch circle, and its chord in the normal section."""
    m = s.member
    spiral, half = s.pair.mean_spiral_angle, m.half_tooth_azimuth
    outer, mean = (2 * r * np.sin(m.pitch_angle) for r in (m.outer_cone_distance, m.mean_cone_distance))
    normal, virtual = mean * half * np.cos(spiral), mean / (np.cos(m.pitch_angle) * np.cos(spiral) ** 2)
    return Numbers(
        (
            mm("d_e", outer),
            mm("d_m", mean),
            rad('"half"', half),
            deg("delta", m.pitch_angle),
            deg("beta_m", spiral),
        ),
        (
            mm("s_(e t)", outer * half),
            mm("s_(m n)", normal),
            mm("s_(m n c)", virtual * np.sin(normal / virtual)),
        ),
    )


def tip_land(s: Subject) -> Numbers:
    """Thickness of the tip at the heel."""
    m = s.member
    rho = m.outer_cone_distance
    tip = float(m.tip_limit.at_sphere(rho))
    pitch_beta = float(azimuth_from_arc(roll_arc(m.pitch_angle, m.base_angle), m.base_angle))
    return Numbers(
        (
            mm("rho = R", rho),
            deg("delta_a", tip),
            rad('"half"', m.half_tooth_azimuth),
            rad("beta(delta)", pitch_beta),
            rad("beta(delta_a)", float(involute_azimuth(tip, m.base_angle))),
        ),
        (mm("s_a", 2 * rho * np.sin(tip) * float(tip_half_azimuth(m, rho))),),
    )


def undercut(s: Subject) -> Numbers:
    """Rolled arc that is left below the mate's tip."""
    m, mate = s.member, s.mate
    return Numbers(
        (deg("gamma", m.gamma), deg("gamma'", mate.gamma), deg("psi'_a", tip_arc(mate))),
        (deg("gamma + gamma' - psi'_a", -interference(s.pair, mate)),),
    )
