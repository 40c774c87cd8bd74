"""The pair as a record: cones, bodies, teeth and placing of both members."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import acos, asin, atan, cos, pi, radians, sin, tan

from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import FlankName, name_of, side_of
from gearstudio.theory.hypoid.axes import Axes, placed
from gearstudio.theory.hypoid.bodies import Bodies, Body, bodies
from gearstudio.theory.hypoid.checks import nearest, pitch_cones
from gearstudio.theory.hypoid.depth import ToothDepth, tooth_depth
from gearstudio.theory.hypoid.exact import exact_cones
from gearstudio.theory.hypoid.inputs import HypoidError, HypoidInput, MemberName
from gearstudio.theory.hypoid.pitch import PitchCone, PitchCones
from gearstudio.theory.lengthwise import Lengthwise

_DRIVE: dict[MemberName, FlankName] = {"pinion": "concave", "wheel": "convex"}


@dataclass(frozen=True)
class HypoidPair:
    """Both members of a pair with offset axes, and how they stand and roll.

    Attributes
    ----------
    given : HypoidInput
    cones : PitchCones
    depth : ToothDepth
    bodies : Bodies
    """

    given: HypoidInput
    cones: PitchCones
    depth: ToothDepth
    bodies: Bodies

    @property
    def ratio(self) -> float:
        """u = z_2 / z_1; the members roll by phi_1 = -u phi_2."""
        return self.given.ratio

    def hand(self, name: MemberName) -> int:
        """+1 right, -1 left."""
        return self.given.wheel_hand if name == "wheel" else -self.given.wheel_hand

    def pitch_cone(self, name: MemberName) -> PitchCone:
        """Pitch cone of a member."""
        return self.cones.wheel if name == "wheel" else self.cones.pinion

    def body(self, name: MemberName) -> Body:
        """Face and root cone and face width of a member."""
        return self.bodies.wheel if name == "wheel" else self.bodies.pinion

    def side(self, name: MemberName, flank: FlankName) -> int:
        """+1 or -1; flanks of equal side meet."""
        return side_of(self.hand(name), flank)

    def flank_name(self, name: MemberName, side: int) -> FlankName:
        """The flank of a member on a side."""
        return name_of(self.hand(name), side)

    def is_drive(self, side: int) -> bool:
        """Whether a side is the drive flank: concave on the pinion, convex on the wheel."""
        return side == self.side("wheel", _DRIVE["wheel"])

    def normal_pressure_angle(self, side: int) -> float:
        """alpha_n at the mean point [rad]: alpha_d + f alpha_lim on the drive flank, minus on the coast flank."""
        lean = self.given.limit_pressure_angle_factor * self.cones.limit_pressure_angle
        return radians(self.given.pressure_angle_deg) + (lean if self.is_drive(side) else -lean)

    def transverse_pressure_angle(self, name: MemberName, side: int) -> float:
        """tan(alpha_t) = tan(alpha_n) / cos(beta_m), each member's own spiral angle [rad]."""
        return atan(tan(self.normal_pressure_angle(side)) / cos(self.pitch_cone(name).spiral_angle))

    @property
    def half_space_azimuth(self) -> float:
        """Half the wheel's tooth space at the mean point, without backlash [rad]."""
        grown = self.depth.thickness_shift + self.depth.profile_shift * tan(radians(self.given.pressure_angle_deg))
        return (pi / 2 + 2 * grown) / self.given.wheel_teeth

    @property
    def backlash_azimuth(self) -> float:
        """The wheel's share of the backlash per flank [rad]; the pinion's is u times as much."""
        return self.given.backlash / (2 * self.given.wheel_outer_pitch_diameter)

    def half_tooth_azimuth(self, name: MemberName) -> float:
        """Half a tooth's azimuth on the pitch cone at the mean point [rad]."""
        if name == "wheel":
            return pi / self.given.wheel_teeth - self.half_space_azimuth - self.backlash_azimuth
        return self.ratio * (self.half_space_azimuth - self.backlash_azimuth)

    def member(self, name: MemberName, flank: FlankName) -> MemberGeometry:
        """Geometry of a member as one of its flanks has it: the base cone differs from flank to flank.

        The pinion's base cone is that of the involute pinion which touches at the mean point; for a pair without
        offset it is the pinion's own, otherwise only a reference (`own_cone`).
        """
        cone, body, side = self.pitch_cone(name), self.body(name), self.side(name, flank)
        transverse = self.transverse_pressure_angle(name, side)
        base = asin(sin(cone.angle) * cos(transverse))
        add, ded = self.depth.addenda[name == "wheel"], self.depth.dedenda[name == "wheel"]
        outer = cone.mean_cone_distance + body.outer_width
        teeth = self.given.wheel_teeth if name == "wheel" else self.given.pinion_teeth
        return MemberGeometry(
            name=name,
            teeth=teeth,
            hand=self.hand(name),
            module=2 * outer * sin(cone.angle) / teeth,
            pitch_angle=cone.angle,
            base_angle=base,
            transverse_pressure_angle=transverse,
            gamma=acos(cos(cone.angle) / cos(base)),
            outer_cone_distance=outer,
            face_width=body.face_width,
            addendum=add + body.outer_width * tan(body.face.angle - cone.angle),
            dedendum=ded + body.outer_width * tan(cone.angle - body.root.angle),
            half_tooth_azimuth=self.half_tooth_azimuth(name),
            fillet_radius=self.given.fillet_factor * self.cones.mean_normal_module,
            lengthwise=Lengthwise(
                self.given.curve,
                cone.mean_cone_distance,
                cone.spiral_angle,
                cone.angle,
                self.hand(name),
                self.given.cutter_radius,
            ),
            tip_limit=body.face.limit(cone),
            root_limit=body.root.limit(cone),
            ends=self.given.ends,
        )

    @property
    def axes(self) -> Axes:
        """Where the members stand in the world."""
        return placed(self.cones, self.hand("wheel"))

    def misaligned(self, offset: float, pinion_axial: float, wheel_axial: float, shaft_angle: float) -> Axes:
        """Where they stand when misaligned by E, P, G [mm] and the shaft angle [rad] (see `Axes.moved`)."""
        return self.axes.moved(self.hand("wheel") * offset, pinion_axial, wheel_axial, shaft_angle)


def hypoid_pair(given: HypoidInput) -> HypoidPair:
    """Derive a pair.

    Raises
    ------
    HypoidError
        No pitch cones, no cones of face and root, or a pressure angle that a flank cannot have, with what would do.
    """
    cones = pitch_cones(given)
    depth = tooth_depth(given, cones)
    pair = HypoidPair(given, cones, depth, bodies(given, cones, depth))
    _refuse_small_cutter(pair)
    _refuse_lopsided_flanks(pair)
    return pair


def _refuse_lopsided_flanks(pair: HypoidPair) -> None:
    """Refuse normal pressure angles outside 0 to 45 degrees."""
    angles = [pair.normal_pressure_angle(side) for side in (1, -1)]
    if min(angles) > 0 and max(angles) < pi / 4:
        return
    middle = radians(pair.given.pressure_angle_deg)
    most = min(middle, pi / 4 - middle) / abs(pair.cones.limit_pressure_angle)
    raise HypoidError(
        "tooth.limit_pressure_angle_factor",
        f"the flanks' normal pressure angles would be {angles[0] * 180 / pi:.4g}° and {angles[1] * 180 / pi:.4g}°, "
        f"outside 0° to 45°; use a factor of at most {int(most * 100) / 100:g}",
    )


def _refuse_small_cutter(pair: HypoidPair) -> None:
    wheel = pair.member("wheel", "convex")
    near, far = wheel.lengthwise.reach
    if not near < wheel.inner_cone_distance < wheel.outer_cone_distance < far:
        given, largest = pair.given, 5 * wheel.outer_cone_distance
        found = nearest(given.cutter_radius, largest, lambda radius: _crosses(replace(given, cutter_radius=radius)))
        remedy = _smaller_spiral(given) if found is None else f"use at least {found:.6g} mm"
        raise HypoidError(
            "lengthwise.cutter_radius",
            f"a cutter of radius {given.cutter_radius:.6g} mm does not cross the wheel's whole face width; {remedy}",
        )


def _smaller_spiral(given: HypoidInput) -> str:
    found = nearest(given.spiral_angle_deg, 0.0, lambda angle: _crosses(replace(given, spiral_angle_deg=angle)))
    if found is None:
        return "use a smaller offset or face width"
    return f"no radius does with this spiral angle; use a spiral angle of at most {found:.4g}°"


def _crosses(given: HypoidInput) -> bool:
    cones = exact_cones(given)
    if cones is None:
        return False
    wheel = cones.wheel
    trace = Lengthwise(
        given.curve, wheel.mean_cone_distance, wheel.spiral_angle, wheel.angle, given.wheel_hand, given.cutter_radius
    )
    near, far = trace.reach
    outer = given.wheel_outer_pitch_diameter / (2 * sin(wheel.angle))
    return near < outer - given.face_width < outer < far
