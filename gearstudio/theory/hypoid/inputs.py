"""What a hypoid or bevel pair after the standard is made from: the numbers of a drawing, in mm and degrees."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from gearstudio.errors import FieldError

MemberName = Literal["pinion", "wheel"]
Taper = Literal["standard", "uniform", "duplex", "tilted_root"]
Curve = Literal["archimedean", "circular_arc", "logarithmic"]


class HypoidError(FieldError):
    """A pair that cannot be made; ``field`` is the dotted name of the entry to change."""


@dataclass(frozen=True)
class DepthInput:
    """Depth and thickness after ISO 23509, data type II, at the mean point.

    Attributes
    ----------
    taper : {"standard", "uniform", "duplex", "tilted_root"}
        Duplex is the standard's constant slot width, tilted_root its modified slot width.
    depth_factor : float
        k_d: working depth over mean normal module.
    clearance_factor : float
        k_c: clearance over working depth.
    mean_addendum_factor : float or None
        c_ham: the wheel's mean addendum over the working depth; None takes `depth.suggested_addendum_factor`.
    thickness_factor : float
        k_t: thickness that the pinion gains over the wheel, over mean normal module.
    addendum_angle_deg, dedendum_angle_deg : float or None
        Of the wheel [deg]; given, they override the taper.
    """

    taper: Taper = "standard"
    depth_factor: float = 2.0
    clearance_factor: float = 0.125
    mean_addendum_factor: float | None = None
    thickness_factor: float = 0.0
    addendum_angle_deg: float | None = None
    dedendum_angle_deg: float | None = None


@dataclass(frozen=True)
class HypoidInput:
    """A pair as a drawing gives it.

    Attributes
    ----------
    offset : float
        a [mm], sign of ISO 23509: positive makes the pinion's spiral angle the larger one; 0 is a bevel pair.
    wheel_outer_pitch_diameter, face_width : float
        d_e2 and b_2 of the wheel [mm].
    spiral_angle_deg, spiral_angle_of
        Mean spiral angle [deg] and the member that has it.
    cutter_radius : float
        r_c0 [mm]; closes the pitch cones of a circular arc. Other curves close them by their own curvature.
    pressure_angle_deg : float
        alpha_d [deg], normal, half the angle between the two flanks.
    limit_pressure_angle_factor : float
        f_alim: share of the limit pressure angle that is added to drive and taken from coast.
    backlash : float
        j_t [mm], transverse, at the wheel's heel, half from each member.
    fillet_factor : float
        Fillet radius over mean normal module, at the heel.
    """

    pinion_teeth: int
    wheel_teeth: int
    offset: float
    wheel_outer_pitch_diameter: float
    face_width: float
    spiral_angle_deg: float
    cutter_radius: float
    shaft_angle_deg: float = 90.0
    spiral_angle_of: MemberName = "pinion"
    pressure_angle_deg: float = 20.0
    limit_pressure_angle_factor: float = 1.0
    pinion_hand: Literal["left", "right"] = "left"
    curve: Curve = "circular_arc"
    backlash: float = 0.0
    fillet_factor: float = 0.3
    ends: Literal["back_cone", "sphere"] = "back_cone"
    depth: DepthInput = field(default_factory=DepthInput)

    @property
    def ratio(self) -> float:
        """u = z_2 / z_1."""
        return self.wheel_teeth / self.pinion_teeth

    @property
    def wheel_hand(self) -> int:
        """+1 right, -1 left: the opposite of the pinion's."""
        return -1 if self.pinion_hand == "right" else 1
