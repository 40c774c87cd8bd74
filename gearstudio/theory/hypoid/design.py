"""A pair with offset axes, or with a depth after ISO 23509, from its design."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from math import atan, cos, degrees, radians, sin, tan

from gearstudio.design import Design
from gearstudio.theory.cones import MemberGeometry, PairGeometry, bevel_angles, face_width
from gearstudio.theory.flank import FLANKS, FlankName
from gearstudio.theory.hypoid.checks import pitch_cones
from gearstudio.theory.hypoid.inputs import DepthInput, HypoidError, HypoidInput, MemberName
from gearstudio.theory.hypoid.pair import HypoidPair, hypoid_pair
from gearstudio.theory.hypoid.pitch import PitchCones
from gearstudio.theory.hypoid.relief import relief_of

_STANDING_FOR: FlankName = "concave"


def hypoid_geometry(design: Design) -> PairGeometry:
    """Both members of a pair with an offset or an ISO depth; `MemberGeometry.hypoid` is set with an offset only.

    Raises
    ------
    HypoidError
        As `hypoid_pair`; or the design gives an angle in a way that has no meaning with an offset.
    """
    pair = hypoid_of(design)
    wheel = pair.cones.wheel
    return PairGeometry(
        pinion=_member(design, pair, "pinion"),
        wheel=_member(design, pair, "wheel"),
        shaft_angle=pair.cones.shaft_angle,
        normal_pressure_angle=radians(pair.given.pressure_angle_deg),
        mean_spiral_angle=wheel.spiral_angle,
        mean_normal_module=pair.cones.mean_normal_module,
        hypoid=pair,
    )


@lru_cache(maxsize=64)
def _derived(given: HypoidInput) -> HypoidPair:
    return hypoid_pair(given)


def hypoid_of(design: Design) -> HypoidPair:
    """The pair of a design as the theory of offset axes has it, whatever the offset.

    Raises
    ------
    HypoidError
        As `hypoid_geometry`.
    """
    return _derived(hypoid_input(design))


def hypoid_input(design: Design) -> HypoidInput:
    """What a design says of a pair with offset axes: lengths and the face width are the wheel's."""
    pair, tooth, lengthwise = design.pair, design.tooth, design.lengthwise
    pressure, spiral = pair.pressure_angle_deg, lengthwise.spiral_angle_deg
    if pair.offset != 0:
        _refuse_bevel_angles(design)
    elif pair.pressure_angle_kind != "normal" or lengthwise.spiral_angle_at != "mean":
        transverse, mean = bevel_angles(design)
        pressure, spiral = degrees(atan(tan(transverse) * cos(mean))), degrees(mean)
    given = HypoidInput(
        pinion_teeth=pair.pinion_teeth,
        wheel_teeth=pair.wheel_teeth,
        offset=pair.offset,
        wheel_outer_pitch_diameter=pair.outer_module * pair.wheel_teeth,
        face_width=face_width(design),
        spiral_angle_deg=spiral,
        cutter_radius=lengthwise.cutter_radius,
        shaft_angle_deg=pair.shaft_angle_deg,
        spiral_angle_of=lengthwise.spiral_angle_of,
        pressure_angle_deg=pressure,
        limit_pressure_angle_factor=tooth.limit_pressure_angle_factor,
        pinion_hand=pair.pinion_hand,
        curve=lengthwise.curve,
        backlash=tooth.backlash,
        fillet_factor=tooth.fillet_factor,
        ends=tooth.ends,
    )
    return replace(given, depth=_depth(design, given))


def _refuse_bevel_angles(design: Design) -> None:
    if design.pair.pressure_angle_kind != "normal":
        raise HypoidError(
            "pair.pressure_angle_kind",
            "with an offset each member has a transverse pressure angle of its own; give the normal one",
        )
    if design.lengthwise.spiral_angle_at != "mean":
        raise HypoidError(
            "lengthwise.spiral_angle_at",
            "with an offset the spiral angle is given at the mean point; use mean",
        )


def _depth(design: Design, given: HypoidInput) -> DepthInput:
    depth = design.depth
    if depth.system == "outer_module":
        return _depth_of_outer_module(design, given, pitch_cones(given))
    return DepthInput(
        taper=depth.taper,
        depth_factor=depth.depth_factor,
        clearance_factor=depth.clearance_factor,
        mean_addendum_factor=depth.mean_addendum_factor,
        thickness_factor=depth.thickness_factor,
        addendum_angle_deg=depth.addendum_angle_deg,
        dedendum_angle_deg=depth.dedendum_angle_deg,
    )


def _depth_of_outer_module(design: Design, given: HypoidInput, cones: PitchCones) -> DepthInput:
    """Depth and thickness at the mean point of teeth whose factors hold at the wheel's heel.

    Notes
    -----
    Root lines run through the pitch apex and face cones parallel to the mate's root, as with `tip_cone =
    "constant_clearance"` of a bevel pair, which this tends to without an offset.
    """
    tooth, module, wheel = design.tooth, design.pair.outer_module, cones.wheel
    outer = given.wheel_outer_pitch_diameter / (2 * sin(wheel.angle))
    inward = outer - wheel.mean_cone_distance
    shifts = (tooth.profile_shift, -tooth.profile_shift)
    slopes = [module * (tooth.addendum_factor + tooth.clearance_factor - x) / outer for x in shifts]
    heels = [module * (tooth.addendum_factor + x) for x in shifts]
    pinion, of_wheel = heels[0] - inward * slopes[1], heels[1] - inward * slopes[0]
    working, normal = pinion + of_wheel, cones.mean_normal_module
    if working <= 0 or of_wheel < 0 or pinion < 0:
        raise HypoidError(
            "tooth.profile_shift",
            f"{tooth.profile_shift:.10g} leaves a member no addendum at the mean point; use a smaller profile shift "
            "or a larger addendum factor",
        )
    mean_module = module * wheel.mean_cone_distance / outer
    thicker = tooth.profile_shift * mean_module / normal - (pinion - of_wheel) / (2 * normal)
    return DepthInput(
        depth_factor=working / normal,
        clearance_factor=tooth.clearance_factor * module / working,
        mean_addendum_factor=of_wheel / working,
        thickness_factor=2 * thicker * tan(radians(given.pressure_angle_deg)),
        addendum_angle_deg=degrees(atan(slopes[0])),
        dedendum_angle_deg=degrees(atan(slopes[1])),
    )


def _member(design: Design, pair: HypoidPair, name: MemberName) -> MemberGeometry:
    """A member; with an offset its base cone is that of the concave flank (`flank_member` has each flank's)."""
    member = pair.member(name, _STANDING_FOR)
    given = design.modifications.pinion if name == "pinion" else design.modifications.wheel
    concave, convex = (relief_of(pair, name, flank, getattr(given, flank)) for flank in FLANKS)
    return replace(member, reliefs=(concave, convex), hypoid=pair if design.pair.offset != 0 else None)
