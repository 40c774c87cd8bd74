"""Where both members of a pair stand in the world."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import atan2, cos, sin

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.hypoid.pitch import PitchCones
from gearstudio.theory.vectors import about_axis

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Axes:
    """Where both members stand in the world: the wheel's axis is +z, its crossing point the origin.

    Attributes
    ----------
    pinion_axis : ndarray, shape (3,)
        (sin Sigma, 0, cos Sigma).
    crossing : ndarray, shape (3,)
        The pinion's crossing point (0, A, 0) with A = hand_2 a.
    pinion_apex, wheel_apex : ndarray, shape (3,)
        Pitch apexes A_1 and A_2 [mm].
    pinion_frame : ndarray, shape (3, 3)
        M_1: takes the pinion's frame, whose azimuth 0 goes through the mean point, to the world's directions.
    mean_azimuth : float
        Of the mean point about the wheel's axis [rad]: a tooth space of the wheel stands there.
    mean_point : ndarray, shape (3,)
    """

    pinion_axis: Floats
    crossing: Floats
    pinion_apex: Floats
    wheel_apex: Floats
    pinion_frame: Floats
    mean_azimuth: float
    mean_point: Floats

    def moved(self, across: float, pinion_axial: float, wheel_axial: float, opened: float) -> Axes:
        """The pinion out of its place [mm, rad].

        Parameters
        ----------
        across : float
            Along the world's y; a misalignment E, positive as a positive offset, is hand_2 E.
        pinion_axial, wheel_axial : float
            P along the pinion's axis and G along the wheel's, positive away from the crossing point.
        opened : float
            By how much the shaft angle opens.
        """
        c, s = cos(opened), sin(opened)
        tilt = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
        axis = tilt @ self.pinion_axis
        shift = np.array([0.0, across, -wheel_axial]) + pinion_axial * axis
        return replace(
            self,
            pinion_axis=axis,
            crossing=tilt @ self.crossing + shift,
            pinion_apex=tilt @ self.pinion_apex + shift,
            pinion_frame=tilt @ self.pinion_frame,
        )

    def pinion_placement(self, turn: float = 0.0) -> tuple[Floats, Floats]:
        """Matrix and shift that take pinion points to the world when the pinion has turned by phi_1."""
        return self.pinion_frame @ about_axis(turn), self.pinion_apex

    def wheel_placement(self, wheel_teeth: int, turn: float = 0.0) -> tuple[Floats, Floats]:
        """Matrix and shift that take wheel points to the world when the wheel has turned by phi_2."""
        return about_axis(self.mean_azimuth + np.pi / wheel_teeth + turn), self.wheel_apex


def placed(cones: PitchCones, wheel_hand: int) -> Axes:
    """The members' places.

    This is the one spot where the offset's sign meets the hand: A = hand_2 a, and zeta_m counts hand_2 times.
    """
    shaft, wheel = cones.shaft_angle, cones.wheel
    axis = np.array([sin(shaft), 0.0, cos(shaft)])
    crossing = np.array([0.0, wheel_hand * cones.offset, 0.0])
    azimuth = wheel_hand * cones.offset_angle_axial
    wheel_apex = np.array([0.0, 0.0, -wheel.apex_beyond])
    mean = np.array([wheel.mean_radius * cos(azimuth), wheel.mean_radius * sin(azimuth), wheel.mean_height])
    pinion_apex = crossing - cones.pinion.apex_beyond * axis
    tilt = np.array([[cos(shaft), 0.0, sin(shaft)], [0.0, 1.0, 0.0], [-sin(shaft), 0.0, cos(shaft)]])
    seen = tilt.T @ (mean - pinion_apex)
    frame = tilt @ about_axis(atan2(seen[1], seen[0]))
    return Axes(axis, crossing, pinion_apex, wheel_apex, frame, azimuth, mean)
