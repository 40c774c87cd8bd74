"""Two pitch cones that touch at the mean point with their axes offset, and what follows from them.

Index 1 is the pinion, 2 the wheel. Cones and tooth direction at the mean point P satisfy

(a) sin d1 = cos zeta sin S cos d2 - cos S sin d2        (b) sin zetap = sin S sin zeta / cos d1
(c) a = sin zeta (r2 + r1 cos d2 / cos d1)               (d) beta1 = beta2 + zetap
(e) r1 = (r2 / u) cos beta2 / cos beta1                  (f) Rm = r / sin d

They leave one number free, which the lengthwise curvature closes (`exact`), or the standard's recursion (`method1`).
"""

from __future__ import annotations

from dataclasses import dataclass
from math import asin, atan, cos, pi, sin, tan

from gearstudio.theory.hypoid.inputs import HypoidInput


@dataclass(frozen=True)
class PitchCone:
    """One member's pitch cone [mm, rad].

    Attributes
    ----------
    angle : float
        delta.
    spiral_angle : float
        beta_m.
    mean_radius, mean_cone_distance : float
        r_m and R_m of the mean point.
    apex_beyond : float
        t_z: how far the apex lies beyond the crossing point, away from the teeth.
    mean_height : float
        t_zm: from the crossing point to the mean point, along the axis.
    """

    angle: float
    spiral_angle: float
    mean_radius: float
    mean_cone_distance: float
    apex_beyond: float
    mean_height: float


@dataclass(frozen=True)
class PitchCones:
    """Both pitch cones and what they share [mm, rad].

    Attributes
    ----------
    offset, shaft_angle
        a (sign of the standard) and Sigma.
    offset_angle_axial, offset_angle_pitch, offset_angle_pinion
        zeta_m about the wheel's axis, zeta_mp in the pitch plane, eta about the pinion's axis; signs of a.
    mean_normal_module : float
        m_mn.
    limit_pressure_angle : float
        alpha_lim.
    limit_curvature : float
        1 / rho_lim [1/mm]: curvature of the tooth that meshes without lengthwise rolling; 0 for a = 0, where any does.
    outer_share : float
        c_be2: the share of the wheel's face width outside the mean point.
    """

    pinion: PitchCone
    wheel: PitchCone
    offset: float
    shaft_angle: float
    offset_angle_axial: float
    offset_angle_pitch: float
    offset_angle_pinion: float
    mean_normal_module: float
    limit_pressure_angle: float
    limit_curvature: float
    outer_share: float

    @property
    def pitch_plane_offset(self) -> float:
        """a_p = R_m2 sin(zeta_mp) [mm]."""
        return self.wheel.mean_cone_distance * sin(self.offset_angle_pitch)


@dataclass(frozen=True)
class Touching:
    """The angles that relations (a) to (d) tie together [rad]."""

    pinion_angle: float
    wheel_angle: float
    pinion_spiral: float
    wheel_spiral: float
    axial: float
    in_plane: float


def assemble(given: HypoidInput, touching: Touching, wheel_radius: float) -> PitchCones:
    """Everything that follows from the angles and the wheel's mean pitch radius r_2 [mm]."""
    t, shaft = touching, given.shaft_angle_deg * pi / 180
    sin_1, cos_1, sin_2, cos_2 = sin(t.pinion_angle), cos(t.pinion_angle), sin(t.wheel_angle), cos(t.wheel_angle)
    pinion_radius = wheel_radius / given.ratio * cos(t.wheel_spiral) / cos(t.pinion_spiral)
    axes = wheel_radius + pinion_radius * cos_2 / cos_1
    cot_shaft = cos(shaft) / sin(shaft)
    wheel_height = pinion_radius * sin_2 / cos_1 + cot_shaft * cos(t.axial) * axes
    pinion_height = wheel_radius * cos(t.axial) * sin(shaft) + wheel_height * cos(shaft)
    pinion_distance, wheel_distance = pinion_radius / sin_1, wheel_radius / sin_2
    outer = given.wheel_outer_pitch_diameter / (2 * sin_2)
    pressure, curvature = limits(t, pinion_distance, wheel_distance)
    return PitchCones(
        pinion=PitchCone(
            t.pinion_angle,
            t.pinion_spiral,
            pinion_radius,
            pinion_distance,
            pinion_distance * cos_1 - pinion_height,
            pinion_height,
        ),
        wheel=PitchCone(
            t.wheel_angle,
            t.wheel_spiral,
            wheel_radius,
            wheel_distance,
            wheel_distance * cos_2 - wheel_height,
            wheel_height,
        ),
        offset=given.offset,
        shaft_angle=shaft,
        offset_angle_axial=t.axial,
        offset_angle_pitch=t.in_plane,
        offset_angle_pinion=asin(given.offset / (pinion_radius + wheel_radius * cos_1 / cos_2)),
        mean_normal_module=2 * wheel_radius * cos(t.wheel_spiral) / given.wheel_teeth,
        limit_pressure_angle=pressure,
        limit_curvature=curvature,
        outer_share=(outer - wheel_distance) / given.face_width,
    )


def limits(t: Touching, pinion_distance: float, wheel_distance: float) -> tuple[float, float]:
    """Limit pressure angle [rad] and limit curvature [1/mm] (0 without offset) at cone distances R_m1, R_m2.

    tan(alpha_lim) = -(tan d1 tan d2 / cos zetap) (Rm1 sin b1 - Rm2 sin b2) / (Rm1 tan d1 + Rm2 tan d2)
    """
    tan_1, tan_2 = tan(t.pinion_angle), tan(t.wheel_angle)
    first, second = pinion_distance * tan_1, wheel_distance * tan_2
    slide = pinion_distance * sin(t.pinion_spiral) - wheel_distance * sin(t.wheel_spiral)
    tan_limit = -tan_1 * tan_2 / cos(t.in_plane) * slide / (first + second)
    lean = tan(t.pinion_spiral) - tan(t.wheel_spiral)
    if lean == 0:
        return atan(tan_limit), 0.0
    bend = tan_limit * (tan(t.pinion_spiral) / first + tan(t.wheel_spiral) / second)
    turn = 1 / (pinion_distance * cos(t.pinion_spiral)) - 1 / (wheel_distance * cos(t.wheel_spiral))
    return atan(tan_limit), cos(atan(tan_limit)) * (turn - bend) / lean


def trace_curvature(given: HypoidInput, wheel_distance: float, wheel_spiral: float) -> float:
    """Curvature of the wheel's tooth trace in its developed pitch plane, at the mean point [1/mm] (theory 4)."""
    if given.curve == "circular_arc":
        return 1 / given.cutter_radius
    turn = sin(wheel_spiral) / wheel_distance
    return turn if given.curve == "logarithmic" else turn * (1 + cos(wheel_spiral) ** 2)
