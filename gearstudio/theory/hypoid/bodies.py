"""Face and root cones of both members, each with its own apex, and the face widths (ISO 23509)."""

from __future__ import annotations

from dataclasses import dataclass
from math import asin, atan, atan2, cos, pi, sin, tan

from gearstudio.theory.hypoid.depth import ToothDepth
from gearstudio.theory.hypoid.inputs import HypoidError, HypoidInput
from gearstudio.theory.hypoid.pitch import PitchCone, PitchCones
from gearstudio.theory.limit import ConeLimit

_LEAST_DEPTH = 0.25


@dataclass(frozen=True)
class TurnedCone:
    """A cone about a member's axis.

    Attributes
    ----------
    angle : float
        Half angle [rad].
    apex_beyond : float
        t_zF or t_zR: how far its apex lies beyond the crossing point, away from the teeth [mm].
    """

    angle: float
    apex_beyond: float

    def limit(self, pitch: PitchCone) -> ConeLimit:
        """The cone as a limit of teeth about the member's pitch apex."""
        return ConeLimit(self.angle, (self.apex_beyond - pitch.apex_beyond) * sin(self.angle), pitch.angle)


@dataclass(frozen=True)
class Body:
    """A member's turned cones and its face width on either side of the mean point [mm, rad]."""

    face: TurnedCone
    root: TurnedCone
    outer_width: float
    inner_width: float

    @property
    def face_width(self) -> float:
        """b [mm]."""
        return self.outer_width + self.inner_width


@dataclass(frozen=True)
class Bodies:
    """Both members' bodies; the offset angles in the planes of the wheel's root and face cone [rad]."""

    pinion: Body
    wheel: Body
    root_plane_offset_angle: float
    face_plane_offset_angle: float


def bodies(given: HypoidInput, cones: PitchCones, depth: ToothDepth) -> Bodies:
    """Turned cones of both members.

    Notes
    -----
    The pinion's face cone touches the plane that touches the wheel's root cone, moved by the clearance; its root
    cone likewise the plane on the wheel's face cone.

    Raises
    ------
    HypoidError
        The taper leaves a member no face or root cone.
    """
    wheel, add, ded = cones.wheel, depth.addendum_angle, depth.dedendum_angle
    face = TurnedCone(wheel.angle + add, _beyond(wheel, add, depth.addenda[1]))
    root = TurnedCone(wheel.angle - ded, _beyond(wheel, -ded, -depth.dedenda[1]))
    if not (0 < root.angle < pi / 2 and 0 < face.angle < pi / 2):
        raise HypoidError(
            "depth.taper",
            f"face angle {face.angle * 180 / pi:.4g}° and root angle {root.angle * 180 / pi:.4g}° of the wheel must "
            "lie between 0° and 90°; use smaller addendum and dedendum angles or the uniform taper",
        )
    _refuse_no_depth(given, cones, depth)
    pinion_face, in_root = _touching(cones, root, depth.clearance)
    pinion_root, in_face = _touching(cones, face, depth.clearance)
    outer = cones.outer_share * given.face_width
    widths = _pinion_widths(given, cones, depth, pinion_face.angle, in_root)
    return Bodies(
        Body(pinion_face, pinion_root, *widths),
        Body(face, root, outer, given.face_width - outer),
        in_root,
        in_face,
    )


def _refuse_no_depth(given: HypoidInput, cones: PitchCones, depth: ToothDepth) -> None:
    """Refuse a taper that leaves the teeth too little of their depth at an end."""
    mean = depth.addenda[1] + depth.dedenda[1]
    growth = (tan(depth.addendum_angle) + tan(depth.dedendum_angle)) * given.face_width
    least = mean - max(growth * (1 - cones.outer_share), -growth * cones.outer_share)
    if least < _LEAST_DEPTH * mean:
        angles = f"{depth.addendum_angle * 180 / pi:.4g}° and {depth.dedendum_angle * 180 / pi:.4g}°"
        raise HypoidError(
            "depth.taper",
            f"addendum and dedendum angles of {angles} leave {max(least / mean, 0.0):.0%} of the mean depth at an end "
            f"of the face, less than {_LEAST_DEPTH:.0%}; use smaller ones, the standard taper or a smaller face width",
        )


def _beyond(wheel: PitchCone, lean: float, height: float) -> float:
    """Apex of a cone that leans by an angle from the pitch cone and passes it at a height over the mean point."""
    drop = wheel.mean_cone_distance * sin(lean) - height * cos(lean)
    return wheel.apex_beyond - drop / sin(wheel.angle + lean)


def _touching(cones: PitchCones, mate: TurnedCone, clearance: float) -> tuple[TurnedCone, float]:
    """The pinion's cone that touches a plane on a wheel's cone, and the offset angle in that plane [rad].

    The plane touches the wheel's cone along the element at azimuth zeta, chosen so that the plane's normal at the
    element's point next to the mean point meets the pinion's axis too.
    """
    wheel, shaft, offset = cones.wheel, cones.shaft_angle, cones.offset
    sin_m, cos_m = sin(mate.angle), cos(mate.angle)
    lean = mate.angle - wheel.angle
    reach = wheel.mean_cone_distance * cos(lean) - wheel.apex_beyond * cos_m
    swing = atan(offset * cos(shaft) / sin(shaft) * cos_m / reach)
    sine = offset * sin_m * cos(swing) / reach
    if abs(sine) >= 1:
        raise HypoidError("pair.offset", f"an offset of {offset:.6g} mm leaves the pinion no face and root cone")
    zeta = asin(sine) + swing
    sin_pinion = sin(shaft) * cos_m * cos(zeta) - cos(shaft) * sin_m
    if not 0 < sin_pinion < 1:
        raise HypoidError(
            "depth.taper",
            f"the wheel's cone of {mate.angle * 180 / pi:.4g}° leaves the pinion no cone to match; use smaller "
            "addendum and dedendum angles, the uniform taper or a smaller shaft angle",
        )
    beyond = (offset * sin(zeta) * cos_m - mate.apex_beyond * sin_m - clearance) / sin_pinion
    return TurnedCone(asin(sin_pinion), beyond), zeta


def _pinion_widths(
    given: HypoidInput, cones: PitchCones, depth: ToothDepth, face_angle: float, root_offset_angle: float
) -> tuple[float, float]:
    """b_e1 and b_i1 [mm]: the wheel's width turned into the pinion's direction, and the increment along its axis."""
    pinion, wheel, plane = cones.pinion, cones.wheel, cones.offset_angle_pitch
    lead = given.ratio * cos(pinion.angle) + cos(wheel.angle) * cos(plane)
    turn = atan2(sin(plane) * cos(wheel.angle), lead)
    width = given.face_width * cos(turn) / cos(plane - turn)
    increment = depth.working_depth * sin(root_offset_angle) * (1 - 1 / given.ratio)
    addendum_angle = face_angle - pinion.angle
    slope = cos(pinion.angle) - tan(addendum_angle) * sin(pinion.angle)
    share = cones.outer_share
    return share * width + increment / slope, (1 - share) * width + increment / slope
