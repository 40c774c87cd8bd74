"""The profile of a hypoid tooth, whose sides differ and whose sections change along the face."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import InvoluteFlank
from gearstudio.theory.flank_protocol import Flank
from gearstudio.theory.hypoid.conjugate import ConjugateFlank
from gearstudio.theory.hypoid.conjugate_fillets import ConjugateSide
from gearstudio.theory.hypoid.fillets import BEYOND, FilletSide, InvoluteSide
from gearstudio.theory.section import Segment, Shift, faded, off_circle, on_circle

Floats = NDArray[np.float64]

_PLACES = 9
_LEAST_ROOT = 0.02
"""Part of the pitch that fillets leave between them at least."""
_SMALLER = 0.9
_SAME = 1e-6
_ATTEMPTS = 12


@dataclass(frozen=True)
class HypoidProfile:
    """Both sides of a hypoid member's teeth.

    Attributes
    ----------
    member : MemberGeometry
        With the base cone of one of its flanks.
    sides : mapping of {+1, -1} to FilletSide
    """

    member: MemberGeometry
    sides: Mapping[int, FilletSide]

    @property
    def has_root(self) -> bool:
        """Always: the radius of the fillets is one that leaves a root."""
        return True

    @property
    def fillet_radius(self) -> float:
        """R_f at the heel as used [mm]: at most what was asked for."""
        return float(self.sides[1].radius * self.member.outer_cone_distance)

    def below(self, side: int) -> tuple[Segment, ...]:
        """See `Profile`."""
        return ("fillet", "meridian") if self.sides[side].on_meridian else ("fillet",)

    def flank(self, side: int) -> Flank:
        """See `Profile`."""
        return self.sides[side].flank

    def shift_on(self, side: int) -> Shift | None:
        """See `Profile`."""
        return None if self.sides[side].relief is None else partial(self.shift, side)

    def shift(self, side: int, rho: Floats, delta: Floats) -> Floats:
        """By how much micro-geometry turns the profile of one side [rad]; it fades out in the fillet."""
        rho, delta = np.broadcast_arrays(rho, delta)
        if self.sides[side].relief is None:
            return np.zeros(rho.shape)
        m, fillet = self.member, self.sides[side]
        rho_u = self._near(rho, delta)
        root = m.limit_angle(m.root_limit, rho_u)
        low = np.full(rho.shape, fillet.flank.member.base_angle) if fillet.on_meridian else self.foot_angle(side, rho_u)
        value, slope = fillet.turn(rho, np.maximum(delta, low))
        return faded(value, slope, delta, root, low)

    def places(self, share: Floats) -> Floats:
        """See `Profile`."""
        m = self.member
        return np.asarray(m.inner_cone_distance + self.flank(1).along(share) * m.face_width)

    def rising(self, name: Segment, side: int, x: Floats, rho_u: Floats) -> tuple[Floats, Floats]:
        """See `Profile`."""
        if name == "meridian":
            foot = self.sides[side].circle(rho_u).foot_angle
            delta = foot + x * (self.flank(side).member.base_angle - foot)
            return delta, np.full_like(delta, side * self.sides[side].start_azimuth())
        circle = self.sides[side].circle(rho_u)
        delta, phi = on_circle(x, circle.radius, circle.centre_angle, circle.foot_angle)
        return delta, side * (circle.centre_azimuth + phi)

    def across(self, name: Segment, rho_u: Floats) -> tuple[Floats, Floats, Floats]:
        """See `Profile`."""
        m = self.member
        if name == "tip":
            low, high = (self.sides[side].tip_azimuth(rho_u) for side in (-1, 1))
            return m.limit_angle(m.tip_limit, rho_u), -low, high
        after, before = (self.sides[side].circle(rho_u).centre_azimuth for side in (1, -1))
        return m.limit_angle(m.root_limit, rho_u), after, m.pitch - before

    def foot_angle(self, side: int, rho_u: Floats) -> Floats:
        """See `Profile`."""
        return self.sides[side].circle(rho_u).foot_angle

    def off_fillet(self, side: int, rho: Floats, delta: Floats, phi: Floats) -> Floats:
        """See `Profile`."""
        circle = self.sides[side].circle(self._near(rho, delta))
        turned = phi - self.shift(side, rho, delta)
        azimuth = np.remainder(side * turned - circle.centre_azimuth + np.pi, 2 * np.pi) - np.pi
        return off_circle(circle.radius, circle.centre_angle, delta, azimuth) * rho

    def _near(self, rho: Floats, delta: Floats) -> Floats:
        """rho_u of places, not far beyond the ends."""
        m, reach = self.member, BEYOND * self.member.face_width
        return np.clip(m.end_distance(rho, delta), m.inner_cone_distance - reach, m.outer_cone_distance + reach)

    def extended(self, member: MemberGeometry) -> HypoidProfile:
        """See `Profile`."""
        reach = {"outer_cone_distance", "face_width", "fillet_radius", "tip_limit"}
        changes = {name: getattr(member, name) for name in reach}
        sides: dict[int, FilletSide] = {}
        for number, side in self.sides.items():
            flank = _on(side.flank, replace(side.flank.member, **changes))
            sides[number] = _side(flank, side.radius)
            if isinstance(flank, ConjugateFlank) and isinstance(side, ConjugateSide):
                sides[number] = ConjugateSide(flank, side.radius, side)
        return HypoidProfile(member, sides)

    def unmodified(self, flanks: dict[int, Flank]) -> HypoidProfile:
        """See `Profile`."""
        profile = hypoid_profile(flanks)
        return replace(profile, member=replace(profile.member, reliefs=(None, None)))


def hypoid_profile(flanks: Mapping[int, Flank]) -> HypoidProfile:
    """The profile between two flanks by side.

    Raises
    ------
    GeometryError
        Fillets do not join flanks and root, neighbouring fillets leave no root, or a tooth is pointed.
    """
    member = flanks[1].member
    radius = member.fillet_angle
    for _ in range(_ATTEMPTS):
        profile = HypoidProfile(member, {side: _side(flank, radius) for side, flank in flanks.items()})
        places = member.inner_cone_distance + np.linspace(0.0, 1.0, _PLACES) * member.face_width
        _, first, last = profile.across("root", places)
        if np.min(last - first) >= _LEAST_ROOT * member.pitch:
            _refuse_pointed(profile, places)
            return profile
        radius *= _SMALLER
    if any(np.any(side.circle(places).radius > (1 + _SAME) * side.radius) for side in profile.sides.values()):
        raise GeometryError(
            f"the {member.name}'s flanks are undercut so near the start of contact that the fillets below overlap; "
            "use a smaller clearance factor, or a mean addendum factor that gives the pinion more profile shift"
        )
    raise GeometryError(f"the fillets of neighbouring {member.name} teeth overlap; use a smaller fillet factor")


def _refuse_pointed(profile: HypoidProfile, places: Floats) -> None:
    _, first, last = profile.across("tip", places)
    if np.min(last - first) <= 0:
        raise GeometryError(f"the {profile.member.name}'s teeth are pointed below their face cone")


def _on(flank: Flank, member: MemberGeometry) -> Flank:
    """A flank continued on a longer and higher member."""
    if isinstance(flank, ConjugateFlank):
        return replace(flank, member=member, lower=None)
    assert isinstance(flank, InvoluteFlank)
    return replace(flank, member=member, foot=None)


def _side(flank: Flank, radius: float) -> FilletSide:
    """The fillet of a radius [rad] below a flank."""
    if isinstance(flank, ConjugateFlank):
        return ConjugateSide(flank, radius)
    assert isinstance(flank, InvoluteFlank)
    return InvoluteSide(flank, radius)
