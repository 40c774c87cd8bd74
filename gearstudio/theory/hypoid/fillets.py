"""Fillets of hypoid teeth: at every place along the face a circle that touches root and flank.

The circle lies on the unit sphere of the section's angles, as that of a bevel tooth does, with the radius R_f / R;
centre and foot follow the flank and the root cone along the face.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import Flank
from gearstudio.theory.hypoid.straight import Meridian, Straight
from gearstudio.theory.involute import azimuth_from_arc, base_azimuth, involute_azimuth, polar_angle, roll_arc
from gearstudio.theory.involute_flank import InvoluteFlank
from gearstudio.theory.modified import ModifiedFlank, azimuth_shift, azimuth_shift_slope
from gearstudio.theory.relief import FlankRelief

Floats = NDArray[np.float64]

BEYOND = 0.06
"""Share of the face width beyond either end for which fillets are known."""
_ALONG = 9
_CLEAR = 0.01


class FilletError(GeometryError):
    """Fillets that cannot be.

    Attributes
    ----------
    reason, remedy : str
        What is wrong, and what to do: the error's text.
    largest : float or None
        Radius of the largest fillet that can be, where that is known [mm].
    """

    def __init__(self, reason: str, remedy: str, largest: float | None = None) -> None:
        self.reason, self.remedy, self.largest = reason, remedy, largest
        super().__init__(f"{reason}; {remedy}")

    def __reduce__(self) -> tuple[type, tuple[str, str, float | None]]:
        return type(self), (self.reason, self.remedy, self.largest)


@dataclass(frozen=True)
class Circle:
    """Circles of a fillet at places along the face [rad], arrays of the same shape, and where they leave the flank.

    Azimuths count towards the space.
    """

    radius: Floats
    centre_angle: Floats
    centre_azimuth: Floats
    foot_angle: Floats


class FilletSide(Protocol):
    """Flank, fillet and what is between them on one side of a tooth."""

    @property
    def radius(self) -> float:
        """Of the circle [rad]; conjugate flanks may have larger ones."""
        ...

    @property
    def flank(self) -> Flank:
        """Down to the foot, or to the base cone where the foot is below it."""
        ...

    @property
    def straight(self) -> Straight | None:
        """What the fillet touches below the flank, where it does not touch the flank itself."""
        ...

    def circle(self, rho_u: Floats) -> Circle:
        """The fillet at places along the face [mm]."""
        ...

    def tip_azimuth(self, rho_u: Floats) -> Floats:
        """Half the tooth's azimuth at its tip [rad], towards the space."""
        ...

    @property
    def relief(self) -> FlankRelief | None:
        """Micro-geometry of the flank."""
        ...

    def turn(self, rho: Floats, delta: Floats) -> tuple[Floats, Floats]:
        """By how much micro-geometry turns the flank at cone distances and polar angles, and its slope over these."""
        ...

    def smaller(self, share: float) -> FilletSide:
        """The same with a share of the radius."""
        ...

    def extended(self, member: MemberGeometry) -> FilletSide:
        """The same teeth on a longer and higher member."""
        ...


@dataclass(frozen=True)
class InvoluteSide:
    """A fillet below a spherical involute, in closed form.

    Attributes
    ----------
    whole : InvoluteFlank
        Of any foot; micro-geometry turns the fillet, which is that of the flank without.
    radius : float
        Of the circle [rad].
    on_meridian : bool
        Whether the circle touches the meridian below the base cone.
    """

    whole: InvoluteFlank
    radius: float
    on_meridian: bool

    @cached_property
    def flank(self) -> InvoluteFlank:
        """See `FilletSide`."""
        member = self.whole.member
        foot = member.base_limit if self.on_meridian else _Foot(self.circle)
        return replace(self.whole, foot=foot)

    @cached_property
    def straight(self) -> Meridian | None:
        """See `FilletSide`."""
        if not self.on_meridian:
            return None
        member = self.whole.member
        return Meridian(member.base_angle, base_azimuth(member), lambda rho_u: self.circle(rho_u).foot_angle)

    def circle(self, rho_u: Floats) -> Circle:
        """See `FilletSide`."""
        member = self.whole.member
        centre = self._centre_angle(rho_u)
        radius = np.full_like(centre, self.radius)
        if self.on_meridian:
            azimuth = base_azimuth(member) + np.arcsin(np.sin(self.radius) / np.sin(centre))
            return Circle(radius, centre, azimuth, np.arccos(np.cos(centre) / np.cos(self.radius)))
        arc = self._arc(centre)
        azimuth = base_azimuth(member) - azimuth_from_arc(arc, member.base_angle)
        azimuth = azimuth + self.radius / np.sin(member.base_angle)
        return Circle(radius, centre, azimuth, polar_angle(arc - self.radius, member.base_angle))

    def tip_azimuth(self, rho_u: Floats) -> Floats:
        """See `FilletSide`."""
        m = self.whole.member
        return np.asarray(base_azimuth(m) - involute_azimuth(m.limit_angle(m.tip_limit, rho_u), m.base_angle))

    @property
    def relief(self) -> FlankRelief | None:
        """See `FilletSide`."""
        return self.whole.relief if isinstance(self.whole, ModifiedFlank) else None

    def turn(self, rho: Floats, delta: Floats) -> tuple[Floats, Floats]:
        """See `FilletSide`."""
        member, side = self.whole.member, self.whole.side
        assert self.relief is not None
        slope = azimuth_shift_slope(member, side, self.relief, rho, delta)
        return azimuth_shift(member, side, self.relief, rho, delta), slope

    def smaller(self, share: float) -> InvoluteSide:
        """See `FilletSide`."""
        return involute_side(self.whole, share * self.radius)

    def extended(self, member: MemberGeometry) -> InvoluteSide:
        """See `FilletSide`."""
        return replace(self, whole=replace(self.flank, member=member, foot=None))

    def _centre_angle(self, rho_u: Floats) -> Floats:
        m = self.whole.member
        return np.asarray(m.limit_angle(m.root_limit, rho_u) + self.radius)

    def _arc(self, centre: Floats) -> Floats:
        base = self.whole.member.base_angle
        return roll_arc(np.maximum(centre, base), base)


@dataclass(frozen=True)
class _Foot:
    """The foot of an involute flank, on whichever ends its teeth have."""

    circle: Callable[[Floats], Circle]

    def at_sphere(self, rho_u: ArrayLike) -> Floats:
        """Polar angle at a tooth end [rad]."""
        return self.circle(np.asarray(rho_u, dtype=np.float64)).foot_angle

    at_back_cone = at_sphere


def involute_side(whole: InvoluteFlank, radius: float) -> InvoluteSide:
    """The fillet of a radius below an involute flank, all along its face on the flank or all along on the meridian.

    Notes
    -----
    The circle that touches both where the base cone is has tan(radius) = (cos(delta_f) - cos(delta_b)) / sin(delta_f).
    Where the radius lies between the least and the largest of these along the face, the nearer of them is taken.
    """
    m = whole.member
    root = m.limit_angle(m.root_limit, m.along_face(np.linspace(-BEYOND, 1 + BEYOND, _ALONG)))
    limits = np.arctan(np.maximum(np.cos(root) - np.cos(m.base_angle), 0.0) / np.sin(root))
    least, most = float(limits.min()) * (1 - _CLEAR), float(limits.max()) * (1 + _CLEAR)
    if least < radius < most:
        radius = least if radius**2 < least * most else most
    return InvoluteSide(whole, radius, radius <= least)
