"""Numbers of pairs with depths after ISO 23509, and of pairs with offset axes."""

from __future__ import annotations

from math import atan, isclose, radians

from gearstudio.equations.records import Given, Numbers, Subject, deg, mm, pure
from gearstudio.theory.hypoid.depth import duplex_sum
from gearstudio.theory.hypoid.dimensions import MemberDimensions, dimensions
from gearstudio.theory.hypoid.pair import HypoidPair
from gearstudio.theory.hypoid.pitch import PitchCone
from gearstudio.theory.hypoid.undercut import worst_place
from gearstudio.theory.modified import flank_member
from gearstudio.theory.pair import overlap_ratio, total_contact_ratio, transverse_contact_ratio


def _pair(s: Subject) -> HypoidPair:
    assert s.pair.hypoid is not None
    return s.pair.hypoid


def _cone(s: Subject) -> PitchCone:
    cones = _pair(s).cones
    return cones.pinion if s.member is s.pair.pinion else cones.wheel


def _sizes(s: Subject) -> MemberDimensions:
    found = dimensions(_pair(s))
    return found.pinion if s.member is s.pair.pinion else found.wheel


def working_depth(s: Subject) -> Numbers:
    """h_mw and c."""
    given, depth, cones = _pair(s).given.depth, _pair(s).depth, _pair(s).cones
    return Numbers(
        (
            mm("m_(m n)", cones.mean_normal_module),
            pure("k_d", given.depth_factor),
            pure("k_c", given.clearance_factor),
        ),
        (mm("h_(m w)", depth.working_depth), mm("c", depth.clearance)),
    )


def mean_depths(s: Subject) -> Numbers:
    """h_am and h_fm of the member."""
    depth, index = _pair(s).depth, int(s.member is s.pair.wheel)
    return Numbers(
        (
            mm("h_(m w)", depth.working_depth),
            mm("c", depth.clearance),
            pure("c_(h a m)", depth.addenda[1] / depth.working_depth),
        ),
        (mm(f"h_(a m {index + 1})", depth.addenda[index]), mm(f"h_(f m {index + 1})", depth.dedenda[index])),
    )


def taper(s: Subject) -> Numbers | None:
    """The wheel's angles, from its depths where the taper is the standard one."""
    if s.member is s.pair.pinion:
        return None
    depth, wheel = _pair(s).depth, _pair(s).cones.wheel
    add, ded, reach = depth.addendum_angle, depth.dedendum_angle, wheel.mean_cone_distance
    angles = (deg("theta_(a 2)", add), deg("theta_(f 2)", ded))
    cones = (deg("delta_(a 2)", wheel.angle + add), deg("delta_(f 2)", wheel.angle - ded))
    pitch = deg("delta_2", wheel.angle)
    standard = all(
        isclose(tilt, atan(height / reach), abs_tol=1e-12)
        for tilt, height in zip((add, ded), depth.dedenda, strict=True)
    )
    if not standard:
        return Numbers((pitch, *angles), cones)
    heights = tuple(mm(f"h_(f m {k})", height) for k, height in enumerate(depth.dedenda, start=1))
    return Numbers((*heights, mm("R_(m 2)", reach), pitch), (*angles, *cones))


def duplex(s: Subject) -> Numbers | None:
    """The sum of the dedendum angles for constant slots."""
    if s.member is s.pair.pinion:
        return None
    pair, wheel = _pair(s), _pair(s).cones.wheel
    arc = (mm("r_0", pair.given.cutter_radius),) if pair.given.curve == "circular_arc" else ()
    return Numbers(
        (
            pure("z_2", pair.given.wheel_teeth),
            deg("delta_2", wheel.angle),
            mm("R_(m 2)", wheel.mean_cone_distance),
            deg("beta_(m 2)", wheel.spiral_angle),
            deg("alpha_d", radians(pair.given.pressure_angle_deg)),
            *arc,
        ),
        (deg("Sigma theta_f", duplex_sum(pair.given, pair.cones)),),
    )


def touching_cones(s: Subject) -> Numbers | None:
    """Face and root angle of the pinion from the planes on the wheel's root and face cone."""
    if s.member is s.pair.wheel:
        return None
    bodies = _pair(s).bodies
    return Numbers(
        (
            deg("Sigma", s.pair.shaft_angle),
            deg("delta_(f 2)", bodies.wheel.root.angle),
            deg("zeta_R", bodies.root_plane_offset_angle),
            deg("delta_(a 2)", bodies.wheel.face.angle),
            deg("zeta_o", bodies.face_plane_offset_angle),
        ),
        (deg("delta_(a 1)", bodies.pinion.face.angle), deg("delta_(f 1)", bodies.pinion.root.angle)),
    )


def normal_thickness(s: Subject) -> Numbers:
    """s_mn at the mean point."""
    sizes = _sizes(s)
    return Numbers(
        (
            mm("m_(m n)", _pair(s).cones.mean_normal_module),
            pure("x_(h m)", sizes.profile_shift),
            pure("x_(s m)", sizes.thickness_shift),
            deg("alpha_d", radians(_pair(s).given.pressure_angle_deg)),
        ),
        (mm("s_(m n)", sizes.mean_normal_thickness), mm("s_(m n c)", sizes.mean_chordal_thickness)),
    )


def pitch_cones(s: Subject) -> Numbers:
    """Pitch angle of the pinion, and the offset angle in the pitch plane."""
    cones = _pair(s).cones
    return Numbers(
        (
            deg("Sigma", cones.shaft_angle),
            deg("zeta_m", cones.offset_angle_axial),
            deg("delta_2", cones.wheel.angle),
        ),
        (deg("delta_1", cones.pinion.angle), deg("zeta_(m p)", cones.offset_angle_pitch)),
    )


def offset_arms(s: Subject) -> Numbers:
    """a from both mean radii."""
    cones = _pair(s).cones
    return Numbers(
        (
            mm("r_1", cones.pinion.mean_radius),
            mm("r_2", cones.wheel.mean_radius),
            deg("zeta_m", cones.offset_angle_axial),
            deg("eta", cones.offset_angle_pinion),
        ),
        (mm("a", cones.offset), mm("a_p", cones.pitch_plane_offset)),
    )


def spiral_angles(s: Subject) -> Numbers:
    """beta_m1 and beta_m2."""
    cones = _pair(s).cones
    return Numbers(
        (deg("beta_(m 2)", cones.wheel.spiral_angle), deg("zeta_(m p)", cones.offset_angle_pitch)),
        (deg("beta_(m 1)", cones.pinion.spiral_angle),),
    )


def mean_radii(s: Subject) -> Numbers:
    """r_1, both R_m and m_mn."""
    pair = _pair(s)
    pinion, wheel = pair.cones.pinion, pair.cones.wheel
    return Numbers(
        (
            pure("z_1", pair.given.pinion_teeth),
            pure("z_2", pair.given.wheel_teeth),
            mm("r_2", wheel.mean_radius),
            deg("beta_(m 1)", pinion.spiral_angle),
            deg("beta_(m 2)", wheel.spiral_angle),
        ),
        (
            mm("r_1", pinion.mean_radius),
            mm("R_(m 1)", pinion.mean_cone_distance),
            mm("R_(m 2)", wheel.mean_cone_distance),
            mm("m_(m n)", pair.cones.mean_normal_module),
        ),
    )


def _limit_inputs(s: Subject) -> tuple[Given, ...]:
    cones = _pair(s).cones
    both = ((1, cones.pinion), (2, cones.wheel))
    return tuple(
        one
        for k, cone in both
        for one in (
            deg(f"delta_{k}", cone.angle),
            deg(f"beta_(m {k})", cone.spiral_angle),
            mm(f"R_(m {k})", cone.mean_cone_distance),
        )
    )


def limit_angle(s: Subject) -> Numbers:
    """alpha_lim."""
    cones = _pair(s).cones
    return Numbers(
        (*_limit_inputs(s), deg("zeta_(m p)", cones.offset_angle_pitch)),
        (deg("alpha_lim", cones.limit_pressure_angle),),
    )


def limit_radius(s: Subject) -> Numbers | None:
    """rho_lim, which the cones make that of the wheel's tooth trace."""
    cones = _pair(s).cones
    if not cones.limit_curvature:
        return None
    return Numbers(
        (*_limit_inputs(s), deg("alpha_lim", cones.limit_pressure_angle)),
        (mm("rho_lim", 1 / cones.limit_curvature),),
    )


def flank_angles(s: Subject) -> Numbers:
    """Pressure angles and base angles of drive and coast flank."""
    pair, drive = _pair(s), s.pair.pinion.hand
    sides = (("D", drive), ("C", -drive))
    bases = () if s.is_conjugate else tuple(
        deg(f"delta_(b {name})", flank_member(s.member, side).base_angle) for name, side in sides
    )  # fmt: skip
    return Numbers(
        (
            deg("alpha_d", radians(pair.given.pressure_angle_deg)),
            pure("f", pair.given.limit_pressure_angle_factor),
            deg("alpha_lim", pair.cones.limit_pressure_angle),
            deg("beta_m", _cone(s).spiral_angle),
            deg("delta", _cone(s).angle),
        ),
        (*(deg(f"alpha_(n {name})", pair.normal_pressure_angle(side)) for name, side in sides), *bases),
    )


def apexes(s: Subject) -> Numbers:
    """t_z of the pitch apex."""
    cone = _cone(s)
    return Numbers(
        (
            mm("R_m", cone.mean_cone_distance),
            deg("delta", cone.angle),
            mm("t_(z m)", cone.mean_height),
        ),
        (mm("t_z", cone.apex_beyond),),
    )


def area_ratio(s: Subject) -> Numbers | None:
    """Smallest J of both flanks of the pinion."""
    if not s.is_conjugate:
        return None
    worst = [(name, worst_place(_pair(s), side)) for name, side in (("D", s.member.hand), ("C", -s.member.hand))]
    return Numbers(
        tuple(mm(f"rho_{name}", place.rho) for name, place in worst),
        tuple(pure(f"min J_{name}", place.area_ratio) for name, place in worst),
    )


def contact_turns(s: Subject) -> Numbers:
    """Contact ratios of flanks that are conjugate with an offset."""
    return Numbers(
        (pure("z_2", s.pair.wheel.teeth),),
        (
            pure("epsilon_alpha", transverse_contact_ratio(s.pair)),
            pure("epsilon_beta", overlap_ratio(s.pair)),
            pure("epsilon_gamma", total_contact_ratio(s.pair)),
        ),
    )
