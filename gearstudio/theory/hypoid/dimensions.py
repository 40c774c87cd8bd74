"""All dimensions of both members after ISO 23509, for the data sheet and the turned blank."""

from __future__ import annotations

from dataclasses import dataclass
from math import asin, cos, pi, radians, sin, sqrt, tan

from gearstudio.theory.hypoid.inputs import MemberName
from gearstudio.theory.hypoid.pair import HypoidPair


@dataclass(frozen=True)
class AtEnd:
    """A member's dimensions at the heel, the mean point or the toe [mm, rad].

    Attributes
    ----------
    cone_distance, spiral_angle : float
        R and beta; on the pinion's pitch cone at the same distance from the mean point along its element.
    pitch_diameter, tip_diameter, root_diameter : float
        d, d_a, d_f.
    addendum, dedendum : float
        h_a, h_f, square to the pitch cone.
    crown : float
        t_xo, t_xi: from the crossing point to the tip's circle, along the axis.
    """

    cone_distance: float
    spiral_angle: float
    pitch_diameter: float
    tip_diameter: float
    root_diameter: float
    addendum: float
    dedendum: float
    crown: float

    @property
    def depth(self) -> float:
        """h [mm]."""
        return self.addendum + self.dedendum


@dataclass(frozen=True)
class MemberDimensions:
    """One member's dimensions [mm, rad].

    Attributes
    ----------
    outer, mean, inner : AtEnd
    pitch_angle, face_angle, root_angle : float
        delta, delta_a, delta_f.
    addendum_angle, dedendum_angle : float
        theta_a, theta_f.
    pitch_apex, face_apex, root_apex : float
        t_z, t_zF, t_zR beyond the crossing point.
    face_width, outer_face_width, inner_face_width : float
        b, b_e, b_i.
    outer_transverse_module : float
        m_et = d_e / z.
    profile_shift, thickness_shift : float
        x_hm, x_sm (with the backlash's share).
    mean_normal_thickness : float
        s_mn, along the circle at the mean point.
    mean_chordal_thickness, mean_chordal_addendum : float
        s_mnc, h_amc.
    """

    outer: AtEnd
    mean: AtEnd
    inner: AtEnd
    pitch_angle: float
    face_angle: float
    root_angle: float
    addendum_angle: float
    dedendum_angle: float
    pitch_apex: float
    face_apex: float
    root_apex: float
    face_width: float
    outer_face_width: float
    inner_face_width: float
    outer_transverse_module: float
    profile_shift: float
    thickness_shift: float
    mean_normal_thickness: float
    mean_chordal_thickness: float
    mean_chordal_addendum: float


@dataclass(frozen=True)
class PairDimensions:
    """Both members' dimensions and what they share [mm, rad].

    Attributes
    ----------
    ratio, offset, shaft_angle
        u, a, Sigma.
    offset_angle_axial, offset_angle_pitch, offset_angle_root, offset_angle_face
        zeta_m, zeta_mp, zeta_R, zeta_o.
    pitch_plane_offset : float
        a_p.
    mean_normal_module : float
        m_mn.
    limit_pressure_angle, limit_radius : float
        alpha_lim and rho_lim; infinite without offset.
    drive_pressure_angle, coast_pressure_angle : float
        alpha_nD, alpha_nC.
    working_depth, clearance : float
        h_mw, c.
    """

    pinion: MemberDimensions
    wheel: MemberDimensions
    ratio: float
    offset: float
    shaft_angle: float
    offset_angle_axial: float
    offset_angle_pitch: float
    offset_angle_root: float
    offset_angle_face: float
    pitch_plane_offset: float
    mean_normal_module: float
    limit_pressure_angle: float
    limit_radius: float
    drive_pressure_angle: float
    coast_pressure_angle: float
    working_depth: float
    clearance: float


def dimensions(pair: HypoidPair) -> PairDimensions:
    """The dimensions of a pair."""
    cones, drive = pair.cones, pair.side("wheel", "convex")
    return PairDimensions(
        pinion=_member(pair, "pinion"),
        wheel=_member(pair, "wheel"),
        ratio=pair.ratio,
        offset=cones.offset,
        shaft_angle=cones.shaft_angle,
        offset_angle_axial=cones.offset_angle_axial,
        offset_angle_pitch=cones.offset_angle_pitch,
        offset_angle_root=pair.bodies.root_plane_offset_angle,
        offset_angle_face=pair.bodies.face_plane_offset_angle,
        pitch_plane_offset=cones.pitch_plane_offset,
        mean_normal_module=cones.mean_normal_module,
        limit_pressure_angle=cones.limit_pressure_angle,
        limit_radius=1 / cones.limit_curvature if cones.limit_curvature else float("inf"),
        drive_pressure_angle=pair.normal_pressure_angle(drive),
        coast_pressure_angle=pair.normal_pressure_angle(-drive),
        working_depth=pair.depth.working_depth,
        clearance=pair.depth.clearance,
    )


def spiral_angle_at(pair: HypoidPair, name: MemberName, along: float) -> float:
    """beta [rad] at a distance from the mean point along a member's pitch element [mm], positive towards the heel.

    Notes
    -----
    The pinion's element runs through the pitch plane at zeta_mp to the wheel's; its tooth there has the direction of
    the wheel's trace at R_21 = sqrt(R_m2^2 + s^2 + 2 R_m2 s cos(zeta_mp)), plus arcsin(a_p / R_21).
    """
    wheel, lengthwise = pair.cones.wheel, pair.member("wheel", "convex").lengthwise
    mean = wheel.mean_cone_distance
    if name == "wheel":
        return float(lengthwise.spiral_angle(mean + along))
    distance = sqrt(mean**2 + along**2 + 2 * mean * along * cos(pair.cones.offset_angle_pitch))
    return float(lengthwise.spiral_angle(distance)) + asin(pair.cones.pitch_plane_offset / distance)


def _member(pair: HypoidPair, name: MemberName) -> MemberDimensions:
    cone, body, sign = pair.pitch_cone(name), pair.body(name), 1 if name == "pinion" else -1
    teeth = pair.given.pinion_teeth if name == "pinion" else pair.given.wheel_teeth
    shift, module = sign * pair.depth.profile_shift, pair.cones.mean_normal_module
    pressure = radians(pair.given.pressure_angle_deg)
    # all of the backlash's share at the mean point, as a normal width of this member's tooth
    thinning = pair.backlash_azimuth * module * pair.given.wheel_teeth
    thickness_shift = sign * pair.depth.thickness_shift - thinning / (2 * module)
    thickness = module * (pi / 2 + 2 * (thickness_shift + shift * tan(pressure)))
    curl = (1 - (sin(cone.spiral_angle) * cos(pressure)) ** 2) * cos(cone.angle)
    virtual = 2 * cone.mean_radius / curl
    outer = _at(pair, name, body.outer_width)
    addendum = pair.depth.addenda[name == "wheel"]
    return MemberDimensions(
        outer=outer,
        mean=_at(pair, name, 0.0),
        inner=_at(pair, name, -body.inner_width),
        pitch_angle=cone.angle,
        face_angle=body.face.angle,
        root_angle=body.root.angle,
        addendum_angle=body.face.angle - cone.angle,
        dedendum_angle=cone.angle - body.root.angle,
        pitch_apex=cone.apex_beyond,
        face_apex=body.face.apex_beyond,
        root_apex=body.root.apex_beyond,
        face_width=body.face_width,
        outer_face_width=body.outer_width,
        inner_face_width=body.inner_width,
        outer_transverse_module=outer.pitch_diameter / teeth,
        profile_shift=shift,
        thickness_shift=thickness_shift,
        mean_normal_thickness=thickness,
        mean_chordal_thickness=virtual * sin(thickness / virtual),
        mean_chordal_addendum=addendum + virtual * cos(cone.angle) / 2 * (1 - cos(thickness / virtual)),
    )


def _at(pair: HypoidPair, name: MemberName, along: float) -> AtEnd:
    """Dimensions at a distance from the mean point along the pitch element [mm]."""
    cone, body = pair.pitch_cone(name), pair.body(name)
    distance = cone.mean_cone_distance + along
    sin_d, cos_d = sin(cone.angle), cos(cone.angle)
    addendum = _height(distance, body.face.limit(cone).offset, body.face.angle - cone.angle)
    dedendum = -_height(distance, body.root.limit(cone).offset, body.root.angle - cone.angle)
    pitch = 2 * distance * sin_d
    return AtEnd(
        cone_distance=distance,
        spiral_angle=spiral_angle_at(pair, name, along),
        pitch_diameter=pitch,
        tip_diameter=pitch + 2 * addendum * cos_d,
        root_diameter=pitch - 2 * dedendum * cos_d,
        addendum=addendum,
        dedendum=dedendum,
        crown=distance * cos_d - cone.apex_beyond - addendum * sin_d,
    )


def _height(distance: float, offset: float, lean: float) -> float:
    """Height of a turned cone over the pitch cone, square to it, at a distance from the pitch apex [mm]."""
    return offset / cos(lean) + distance * tan(lean)
