"""Points of a pinion flank as the wheel meets them: placing, misalignment and the explicit azimuth (theory 8)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.theory.cones import MemberGeometry, PairGeometry
from gearstudio.theory.flank import Flank, FlankName, name_of, side_of
from gearstudio.theory.involute import involute_azimuth, polar_angle, roll_arc
from gearstudio.theory.involute_flank import InvoluteFlank
from gearstudio.theory.modified import flank_member, flank_of, relief_on, swept_on

Floats = NDArray[np.float64]

MARKING_THICKNESS_UM = 6.35

_REACH_ROUNDS = 3


@dataclass(frozen=True)
class Misalignment:
    """How far the pinion stands from its theoretical place.

    Attributes
    ----------
    offset : float
        E [mm]; positive as a positive hypoid offset.
    pinion_axial : float
        P [mm], along the pinion's axis; positive away from the crossing point.
    wheel_axial : float
        G [mm], along the wheel's axis; positive moves the wheel away from the crossing point.
    shaft_angle_deg : float
        S [deg]; positive opens the shaft angle.
    """

    offset: float = 0.0
    pinion_axial: float = 0.0
    wheel_axial: float = 0.0
    shaft_angle_deg: float = 0.0


@dataclass(frozen=True)
class Place:
    """Where pinion points are about the wheel's axis, all of one shape.

    Attributes
    ----------
    rho, radius, height : ndarray
        Distance from the wheel's apex and axis, and height above the apex [mm].
    """

    rho: Floats
    radius: Floats
    height: Floats

    @property
    def polar_angle(self) -> Floats:
        """delta_k on the wheel [rad]."""
        return np.asarray(np.arctan2(self.radius, self.height))


@dataclass(frozen=True)
class Meeting(Place):
    """Pinion points as seen from the wheel tooth that they face.

    Attributes
    ----------
    lag : ndarray
        Angle by which the wheel tooth would have to turn, against the drive, to touch the point [rad]; its
        place at phi_2 = -phi_1 z_1/z_2 without backlash is 0, and less than 0 is inside the metal.
    """

    lag: Floats


@dataclass(frozen=True)
class FlankMesh:
    """A pinion flank and the wheel flank that it meets.

    Attributes
    ----------
    pair : PairGeometry
    side : {+1, -1}
        The same for both members: equal sides meet.
    misalignment : Misalignment
    """

    pair: PairGeometry
    side: int
    misalignment: Misalignment = Misalignment()

    @cached_property
    def wheel(self) -> MemberGeometry:
        """The wheel as this flank of it has it."""
        return flank_member(self.pair.wheel, self.side)

    @cached_property
    def pinion_flank(self) -> Flank:
        """The flank of the pinion; raises GeometryError as `involute_flank`."""
        return flank_of(self.pair.pinion, name_of(self.pair.pinion.hand, self.side))

    @cached_property
    def wheel_flank(self) -> InvoluteFlank:
        """The flank of the wheel; raises GeometryError as `involute_flank`."""
        flank_of(self.pair.wheel, name_of(self.pair.wheel.hand, self.side))
        return swept_on(self.pair.wheel, self.side)

    @cached_property
    def play(self) -> float:
        """Lag of the perfect pair: the backlash of this side as an angle of the wheel [rad]."""
        pinion, wheel = self.pair.pinion, self.pair.wheel
        return float(
            np.pi / wheel.teeth - wheel.half_tooth_azimuth - pinion.half_tooth_azimuth * pinion.teeth / wheel.teeth
        )

    @cached_property
    def _start(self) -> float:
        """Half the wheel's tooth space where its flank meets the base cone [rad]."""
        wheel = self.wheel
        pitch_beta = float(involute_azimuth(wheel.pitch_angle, wheel.base_angle))
        return np.pi / wheel.teeth - wheel.half_tooth_azimuth - pitch_beta

    @property
    def misaligned(self) -> bool:
        """Whether the pinion stands anywhere but in its place."""
        return self.misalignment != Misalignment()

    def meet(self, points: Floats, turn: ArrayLike) -> Meeting:
        """Where pinion points are, seen from the wheel, when the pinion has turned.

        Parameters
        ----------
        points : ndarray, shape (..., 3)
            In the pinion's frame [mm].
        turn : array_like, broadcastable with (...)
            phi_1 [rad].

        Notes
        -----
        With q = rho cos(delta_b) sin(psi) the flank's azimuth needs two arctangents and no polar angle:
        psi = atan2(q, z) and beta = psi / sin(delta_b) - atan2(q, z sin(delta_b)); the second is taken together
        with the azimuth of the point. Metal taken off the wheel adds its thickness over the lever to the lag.
        """
        wheel, side = self.wheel, self.side
        x, y, z = self._world(points, turn)
        square = x * x + y * y
        height = z * z
        rho = np.sqrt(square + height)
        sin_b, cos_b = np.sin(wheel.base_angle), np.cos(wheel.base_angle)
        q = np.sqrt(np.maximum(cos_b**2 * square - sin_b**2 * height, 0.0))
        y *= side
        lean = z * sin_b
        lag = np.arctan2(y * lean - x * q, x * lean + y * q)
        lag += np.arctan2(q, z) / sin_b
        lag -= side * wheel.lengthwise.azimuth(rho)
        lag += side * self.pair.pinion.teeth / wheel.teeth * np.asarray(turn) + self._start
        radius, relief = np.sqrt(square), relief_on(wheel, side)
        if relief is not None:
            lag += relief.value(rho, np.arctan2(radius, z)) / self.lever(rho)
        return Meeting(rho, radius, z, lag)

    def place(self, points: Floats, turn: ArrayLike) -> Place:
        """As `meet`, without the lag."""
        x, y, z = self._world(points, turn)
        square = x * x + y * y
        return Place(np.sqrt(square + z * z), np.sqrt(square), z)

    def margins(self, met: Place) -> tuple[Floats, Floats, Floats, Floats]:
        """Distances of points from the wheel flank's tip, lower edge, toe and heel, positive inside [mm]."""
        wheel = self.wheel
        tip, root, base = wheel.tip_limit, wheel.root_limit, wheel.base_limit

        def below(angle: float, offset: float) -> Floats:
            return np.asarray(offset - met.radius * np.cos(angle) + met.height * np.sin(angle))

        lower = np.maximum(below(root.angle, root.offset), below(base.angle, base.offset))
        if wheel.ends == "sphere":
            end = met.rho
        else:
            end = met.height * np.cos(wheel.pitch_angle) + met.radius * np.sin(wheel.pitch_angle)
        return (
            below(tip.angle, tip.offset),
            -lower,
            end - wheel.inner_cone_distance,
            wheel.outer_cone_distance - end,
        )

    def least_margin(self, met: Place, longer: float = 0.0) -> Floats:
        """Distance of points from the nearest edge of the wheel flank, negative where it has none [mm].

        ``longer`` is by how much the face width goes on at either end [mm].
        """
        tip, lower, toe, heel = self.margins(met)
        return np.minimum(np.minimum(tip, lower), np.minimum(toe, heel) + longer)

    def lever(self, rho: ArrayLike) -> Floats:
        """Normal gap per angle of the wheel [mm/rad]: 1 / sqrt(1/(rho sin delta_b)^2 + theta'^2) (theory 5)."""
        rho = np.asarray(rho, dtype=np.float64)
        wheel = self.wheel
        slope = wheel.lengthwise.azimuth_slope(rho)
        return np.asarray(1 / np.sqrt(1 / (rho * np.sin(wheel.base_angle)) ** 2 + slope**2))

    def contact_turn(self, psi: ArrayLike, rho: ArrayLike) -> Floats:
        """phi_1 at which a point of the pinion flank touches in the perfect pair [rad].

        The plane of action touches both base cones; the point touches as that plane generates it (theory 5.1).
        """
        pinion = self.pair.pinion
        pitch_beta = float(involute_azimuth(pinion.pitch_angle, pinion.base_angle))
        action = self.side * (pitch_beta - pinion.gamma / np.sin(pinion.base_angle))
        return np.asarray(action - swept_on(pinion, self.side).contact_azimuth(psi, rho))

    def start_of_contact(self, v: ArrayLike) -> Floats:
        """u in [0, 1] on the pinion that the wheel's tip reaches: psi_1 = gamma_1 + gamma_2 - psi_2, shape (...)."""
        pinion, wheel, flank = self.pair.pinion, self.pair.wheel, self.pinion_flank
        low, high = (roll_arc(limit, pinion.base_angle) for limit in flank.limits(v))
        u = np.zeros_like(low)
        for _ in range(_REACH_ROUNDS):
            _, rho = flank.coordinates(u, v)
            tip = np.clip(wheel.tip_limit.at_sphere(rho), wheel.base_angle, np.pi - wheel.base_angle)
            start = pinion.gamma + wheel.gamma - roll_arc(tip, wheel.base_angle)
            u = np.clip((start - low) / (high - low), 0.0, 1.0)
        return u

    def reach(self, v: ArrayLike) -> tuple[Floats, Floats]:
        """Polar angles on the pinion from which the wheel's tip reaches, and of its tip [rad], shape (...) each."""
        base, flank = self.pair.pinion.base_angle, self.pinion_flank
        first, last = (polar_angle(flank.coordinates(u, v)[0], base) for u in (self.start_of_contact(v), 1.0))
        return first, last

    def on_wheel(self, met: Place) -> Floats:
        """Points of the wheel flank, of the tooth at azimuth 0, that pinion points face, shape (..., 3)."""
        flank, wheel = self.wheel_flank, self.wheel
        return flank.points_at(met.rho, np.clip(met.polar_angle, wheel.base_angle, np.pi - wheel.base_angle))

    def _world(self, points: Floats, turn: ArrayLike) -> tuple[Floats, Floats, Floats]:
        """World coordinates of pinion points: R_y(Sigma + S) R_z(pi + phi_1) and the shifts of the misalignment."""
        m, wheel = self.misalignment, self.pair.wheel
        shaft = self.pair.shaft_angle + float(np.radians(m.shaft_angle_deg))
        cos_s, sin_s = np.cos(shaft), np.sin(shaft)
        cos_t, sin_t = np.cos(turn), np.sin(turn)
        x, y, z = points[..., 0], points[..., 1], points[..., 2]
        along, across = y * sin_t - x * cos_t, -(x * sin_t + y * cos_t)
        out = z + m.pinion_axial
        return (
            cos_s * along + sin_s * out,
            across + wheel.hand * m.offset,
            cos_s * out - sin_s * along - m.wheel_axial,
        )


def flank_mesh(pair: PairGeometry, pinion_flank: FlankName, misalignment: Misalignment | None = None) -> FlankMesh:
    """The mesh of the pinion's concave flank (drive) or convex flank (coast)."""
    side = side_of(pair.pinion.hand, pinion_flank)
    if pair.has_offset:
        from gearstudio.analysis.contact_hypoid import HypoidMesh

        return HypoidMesh(pair, side, misalignment or Misalignment())
    return FlankMesh(pair, side, misalignment or Misalignment())
