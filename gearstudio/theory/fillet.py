"""The fillet between root and flank: a circle on the unit sphere (theory 6)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.involute import azimuth_from_arc, base_azimuth, polar_angle, roll_arc

Floats = NDArray[np.float64]

_BISECTIONS = 200


@dataclass(frozen=True)
class Fillet:
    """The circle on the unit sphere that joins flank and root.

    Attributes
    ----------
    radius : float
        Angular radius epsilon [rad].
    centre_angle, centre_azimuth : float
        delta_c, phi_c [rad].
    foot_arc : float
        psi [rad] where it touches the involute; 0 when it touches the meridian below.
    foot_angle : float
        Polar angle [rad] of that foot.
    on_meridian : bool
    full_round : bool
        The fillets of a space would overlap, so the radius is the one at which they meet.
    """

    radius: float
    centre_angle: float
    centre_azimuth: float
    foot_arc: float
    foot_angle: float
    on_meridian: bool
    full_round: bool

    def points(self, s: ArrayLike) -> Floats:
        """Unit vectors along the fillet from the root (s = 0) to its foot (s = 1), shape (..., 3)."""
        centre, outward, onward = _frame(self.centre_angle, self.centre_azimuth)
        turn = np.asarray(s, dtype=np.float64)[..., None] * self.sweep
        rim = -np.cos(turn) * outward - np.sin(turn) * onward
        return np.asarray(np.cos(self.radius) * centre + np.sin(self.radius) * rim)

    @property
    def sweep(self) -> float:
        """Angle of the arc about its centre [rad]."""
        foot_azimuth = self._foot_azimuth
        sin_foot = np.sin(self.foot_angle)
        foot = np.array([sin_foot * np.cos(foot_azimuth), sin_foot * np.sin(foot_azimuth), np.cos(self.foot_angle)])
        _, outward, onward = _frame(self.centre_angle, self.centre_azimuth)
        return float(np.arctan2(-foot @ onward, -foot @ outward))

    @property
    def _foot_azimuth(self) -> float:
        """From the right-angled spherical triangle of centre, foot and axis."""
        if self.on_meridian:
            return self.centre_azimuth - float(np.arcsin(np.sin(self.radius) / np.sin(self.centre_angle)))
        rise = self.centre_angle - self.foot_angle
        square = np.sin((self.radius + rise) / 2) * np.sin((self.radius - rise) / 2)
        square /= np.sin(self.centre_angle) * np.sin(self.foot_angle)
        return self.centre_azimuth - 2 * float(np.arcsin(np.sqrt(np.clip(square, 0.0, 1.0))))


def fillet(member: MemberGeometry) -> Fillet:
    """The fillet of the radius asked for, or the full-round one where that does not fit (theory 6).

    Raises
    ------
    GeometryError
        Neighbouring flanks meet above the root: there is no tooth space.
    """
    half_pitch = member.pitch / 2
    wanted = _touching(member, member.fillet_angle, full_round=False)
    if wanted.centre_azimuth <= half_pitch:
        return wanted
    low, high = 0.0, member.fillet_angle
    if _touching(member, low, full_round=True).centre_azimuth >= half_pitch:
        raise GeometryError(f"the flanks of neighbouring {member.name} teeth meet above the root cone")
    for _ in range(_BISECTIONS):
        middle = (low + high) / 2
        if middle in (low, high):
            break
        fits = _touching(member, middle, full_round=True).centre_azimuth <= half_pitch
        low, high = (middle, high) if fits else (low, middle)
    return _touching(member, low, full_round=True)


def _touching(member: MemberGeometry, radius: float, full_round: bool) -> Fillet:
    """The circle of a radius that touches the root circle and the flank or the meridian below it."""
    base = member.base_angle
    centre = member.root_angle + radius
    start = base_azimuth(member)
    arc = float(roll_arc(centre, base)) if centre >= base else 0.0
    if centre >= base and arc >= radius:
        azimuth = start - float(azimuth_from_arc(arc, base)) + radius / float(np.sin(base))
        foot = arc - radius
        return Fillet(radius, centre, azimuth, foot, float(polar_angle(foot, base)), False, full_round)
    azimuth = start + float(np.arcsin(np.sin(radius) / np.sin(centre)))
    foot_angle = float(np.arccos(np.clip(np.cos(centre) / np.cos(radius), -1.0, 1.0)))
    return Fillet(radius, centre, azimuth, 0.0, foot_angle, True, full_round)


def _frame(angle: float, azimuth: float) -> tuple[Floats, Floats, Floats]:
    """A point of the unit sphere and the directions of growing polar angle and azimuth there."""
    sin_d, cos_d, sin_a, cos_a = np.sin(angle), np.cos(angle), np.sin(azimuth), np.cos(azimuth)
    point = np.array([sin_d * cos_a, sin_d * sin_a, cos_d])
    outward = np.array([cos_d * cos_a, cos_d * sin_a, -sin_d])
    return point, outward, np.array([-sin_a, cos_a, 0.0])
