"""The numbers that a member puts into the equations of the theory, each by the equation's own formula."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from gearstudio.equations.records import Numbers, Subject, deg, mm, pure, rad
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.involute import azimuth_from_arc, involute_azimuth, roll_arc
from gearstudio.theory.modified import flank_member
from gearstudio.theory.pair import overlap_ratio, tip_arc, transverse_contact_ratio


def _involutes(s: Subject) -> tuple[tuple[str, MemberGeometry], ...]:
    """The member as its involute flanks have it: once, or with an offset for the wheel's drive and coast flank."""
    if not s.pair.has_offset:
        return (("", s.member),)
    if s.is_conjugate:
        return ()
    drive = s.pair.pinion.hand
    return ("D", flank_member(s.member, drive)), ("C", flank_member(s.member, -drive))


def _of(symbol: str, flank: str) -> str:
    """A symbol with the name of a flank in its index."""
    head, _, index = symbol.partition("_")
    return symbol if not flank else f"{head}_({index} {flank})"


def _for_each(s: Subject, put: Callable[[str, MemberGeometry], Numbers]) -> Numbers | None:
    """The numbers of the involute flanks one after the other; None where there is none."""
    found = [put(name, m) for name, m in _involutes(s)]
    if not found:
        return None
    return Numbers(tuple(g for one in found for g in one.inputs), tuple(g for one in found for g in one.outputs))


def involute(s: Subject) -> Numbers | None:
    """beta at the tip of the heel."""

    def put(flank: str, m: MemberGeometry) -> Numbers:
        tip = float(m.tip_limit.at_sphere(m.outer_cone_distance))
        beta = float(involute_azimuth(tip, m.base_angle))
        given = (deg("delta_k = delta_a", tip), deg(_of("delta_b", flank), m.base_angle))
        return Numbers(given, (rad(_of("beta_k", flank), beta),))

    return _for_each(s, put)


def pitch_angle(s: Subject) -> Numbers:
    """delta of the member."""
    m, mate = s.member, s.mate
    angle = float(np.arctan2(np.sin(s.pair.shaft_angle), mate.teeth / m.teeth + np.cos(s.pair.shaft_angle)))
    return Numbers(
        (deg("Sigma", s.pair.shaft_angle), pure("z", m.teeth), pure("z'", mate.teeth)), (deg("delta", angle),)
    )


def base_radius(s: Subject) -> Numbers | None:
    """R_b = m z cos(alpha) / 2."""

    def put(flank: str, m: MemberGeometry) -> Numbers:
        alpha = m.transverse_pressure_angle
        given = (mm("m", m.module), pure("z", m.teeth), deg(_of("alpha", flank), alpha))
        return Numbers(given, (mm(_of("R_b", flank), m.module * m.teeth * np.cos(alpha) / 2),))

    return _for_each(s, put)


def base_angle(s: Subject) -> Numbers | None:
    """delta_b by tangents."""

    def put(flank: str, m: MemberGeometry) -> Numbers:
        alpha, delta = m.transverse_pressure_angle, m.pitch_angle
        angle = float(np.arctan(np.sqrt(np.sin(delta) ** 2 / (np.tan(alpha) ** 2 + np.cos(delta) ** 2))))
        return Numbers((deg("delta", delta), deg(_of("alpha", flank), alpha)), (deg(_of("delta_b", flank), angle),))

    return _for_each(s, put)


def element_angle(s: Subject) -> Numbers | None:
    """gamma between pitch and base element."""

    def put(flank: str, m: MemberGeometry) -> Numbers:
        gamma = float(np.arccos(np.cos(m.pitch_angle) / np.cos(m.base_angle)))
        given = (deg("delta", m.pitch_angle), deg(_of("delta_b", flank), m.base_angle))
        return Numbers(given, (deg(_of("gamma", flank), gamma),))

    return _for_each(s, put)


def cone_distance(s: Subject) -> Numbers:
    """R = R_b / sin(delta_b)."""
    m = s.member
    radius = m.module * m.teeth * np.cos(m.transverse_pressure_angle) / 2
    return Numbers((mm("R_b", radius), deg("delta_b", m.base_angle)), (mm("R", radius / np.sin(m.base_angle)),))


def transverse_angle(s: Subject) -> Numbers:
    """alpha from the normal pressure angle."""
    normal, spiral = s.pair.normal_pressure_angle, s.pair.mean_spiral_angle
    alpha = float(np.arctan(np.tan(normal) / np.cos(spiral)))
    return Numbers((deg("alpha_n", normal), deg("beta_m", spiral)), (deg("alpha", alpha),))


def depths(s: Subject) -> Numbers:
    """Face and root cone angles from the depths at the heel."""
    m = s.member
    given = (deg("delta", m.pitch_angle), mm("h_(f e)", m.dedendum), mm("R", m.outer_cone_distance))
    root = deg("delta_f", m.root_angle)
    if m.tip_limit.offset:
        return Numbers(given, (root,))
    return Numbers((mm("h_(a e)", m.addendum), *given), (deg("delta_a", m.tip_angle), root))


def face(s: Subject) -> Numbers:
    """Cone distances of the ends."""
    m = s.member
    return Numbers((mm("R", m.outer_cone_distance), mm("B", m.face_width)), (mm("R - B", m.inner_cone_distance),))


def turn(s: Subject) -> Numbers | None:
    """Turn of the sections at toe and heel against the mean point's."""
    m = s.member
    if s.is_conjugate:
        return None
    places = [m.inner_cone_distance, m.outer_cone_distance]
    low, high = (float(theta) for theta in m.lengthwise.azimuth(places))
    sine = m.hand * float(np.sin(m.pitch_angle))
    return Numbers(
        (
            pure('"hand"', m.hand),
            deg("delta", m.pitch_angle),
            rad("psi_t (R - B)", low * sine),
            rad("psi_t (R)", high * sine),
        ),
        (rad("theta(R - B)", low), rad("theta(R)", high)),
    )


def toe_spiral(s: Subject) -> Numbers:
    """The spiral angle at the toe on the base cone."""
    m = s.member
    spiral = float(m.lengthwise.spiral_angle(m.inner_cone_distance))
    angle = float(np.arctan(np.sin(m.base_angle) / np.sin(m.pitch_angle) * np.tan(spiral)))
    return Numbers(
        (deg("delta", m.pitch_angle), deg("delta_b", m.base_angle), deg("beta_i", abs(spiral))),
        (deg("beta_0", abs(angle)),),
    )


def spiral_start(s: Subject) -> Numbers:
    """The base cone spiral's azimuth from toe to heel."""
    theta = s.member.lengthwise.azimuth([s.member.inner_cone_distance, s.member.outer_cone_distance])
    return Numbers(
        (
            mm("B", s.member.face_width),
            mm("R", s.member.outer_cone_distance),
            deg("delta_b", s.member.base_angle),
            deg("beta_m", s.pair.mean_spiral_angle),
        ),
        (rad("theta_max", abs(float(theta[1] - theta[0]))),),
    )


def roll_range(s: Subject) -> Numbers:
    """Roll angles at the lowest and highest point of the heel's flank."""
    m = s.member
    low = float(roll_arc(max(m.root_angle, m.base_angle), m.base_angle)) / np.sin(m.base_angle)
    high = tip_arc(m) / np.sin(m.base_angle)
    return Numbers(
        (deg("delta_b", m.base_angle), deg("delta_f", m.root_angle), deg("delta_a", m.tip_angle)),
        (rad("Theta_f", low), rad("Theta_a", high)),
    )


def half_thickness(s: Subject) -> Numbers:
    """Half the tooth's azimuth on the pitch cone; shift and backlash follow from depths and thickness."""
    m, alpha = s.member, s.member.transverse_pressure_angle
    shift = (m.addendum - s.mate.addendum) / (2 * m.module)
    full = (np.pi / 2 + 2 * shift * np.tan(alpha)) / m.teeth
    play = 2 * m.module * m.teeth * (full - m.half_tooth_azimuth)
    return Numbers(
        (
            pure("z", m.teeth),
            deg("alpha", alpha),
            pure("x", shift),
            mm("j_t", round(float(play), 12)),
            mm("m", m.module),
        ),
        (rad('"half"', m.half_tooth_azimuth),),
    )


def flank(s: Subject) -> Numbers:
    """Azimuth of the flank at the pitch cone and on the tip of the heel, side +1."""
    m = s.member
    tip = float(m.tip_limit.at_sphere(m.outer_cone_distance))
    pitch_beta = float(azimuth_from_arc(roll_arc(m.pitch_angle, m.base_angle), m.base_angle))
    tip_beta = float(involute_azimuth(tip, m.base_angle))
    turned = float(m.lengthwise.azimuth(m.outer_cone_distance))
    return Numbers(
        (
            rad('"half"', m.half_tooth_azimuth),
            rad("beta(delta)", pitch_beta),
            rad("beta(delta_a)", tip_beta),
            rad("theta(R)", turned),
        ),
        (rad("phi(R, delta_a)", m.half_tooth_azimuth + pitch_beta - tip_beta + turned),),
    )


def fillet(s: Subject) -> Numbers:
    """Fillet radius on the heel sphere."""
    m = s.member
    return Numbers(
        (
            pure("f", m.fillet_radius / s.pair.mean_normal_module),
            mm("m_n", s.pair.mean_normal_module),
            mm("R", m.outer_cone_distance),
        ),
        (mm("R_f", m.fillet_radius), rad("epsilon", m.fillet_angle)),
    )


def spiral_angle(s: Subject) -> Numbers | None:
    """Spiral angles on the pitch cone at toe, mean and heel."""
    m = s.member
    if s.is_conjugate:
        return None
    places = (("i", m.inner_cone_distance), ("m", m.lengthwise.mean_cone_distance), ("e", m.outer_cone_distance))
    given = (mm("r_0", m.lengthwise.cutter_radius),) if m.lengthwise.law == "circular_arc" else ()
    return Numbers(
        (*given, *(mm(f"R_{place}", rho) for place, rho in places)),
        tuple(deg(f"beta_{place}", float(m.lengthwise.spiral_angle(rho))) for place, rho in places),
    )


def contact_ratio(s: Subject) -> Numbers:
    """epsilon_alpha and epsilon_beta of the pair."""
    pinion, wheel = s.pair.pinion, s.pair.wheel
    return Numbers(
        (
            deg("gamma_1", pinion.gamma),
            deg("gamma_2", wheel.gamma),
            *(
                deg(f"delta_(a {k})", float(m.tip_limit.at_sphere(m.outer_cone_distance)))
                for k, m in ((1, pinion), (2, wheel))
            ),
        ),
        (
            pure("epsilon_alpha", transverse_contact_ratio(s.pair)),
            pure("epsilon_beta", overlap_ratio(s.pair)),
        ),
    )
