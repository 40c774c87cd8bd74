"""The profile of a hypoid tooth, whose sides differ and whose sections change along the face."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import Flank
from gearstudio.theory.hypoid.conjugate import ConjugateFlank
from gearstudio.theory.hypoid.conjugate_fillets import ConjugateSide
from gearstudio.theory.hypoid.fillets import BEYOND, FilletError, FilletSide, involute_side
from gearstudio.theory.hypoid.straight import off_great_circle
from gearstudio.theory.involute_flank import InvoluteFlank
from gearstudio.theory.section import Segment, Shift, faded, off_circle, on_circle
from gearstudio.theory.vectors import wrapped

Floats = NDArray[np.float64]

_PLACES = 9
_LEAST_ROOT = 0.02
"""Part of the pitch that fillets leave between them at least."""
_FIRST_STEP, _LEAST_STEP, _MOST_STEP = 0.95, 0.5, 0.99
_SURPLUS, _CAUTION, _FLAT = 1.02, 0.95, 1e-6
_ATTEMPTS, _REFINEMENTS, _CLOSE = 12, 4, 0.02


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
        return float(min(side.radius for side in self.sides.values()) * self.member.outer_cone_distance)

    def below(self, side: int) -> tuple[Segment, ...]:
        """See `Profile`."""
        return ("fillet",) if self.sides[side].straight is None else ("fillet", "meridian")

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
        low = self.flank_foot(side, rho_u)
        value, slope = fillet.turn(rho, np.maximum(delta, low))
        return faded(value, slope, delta, root, low)

    def places(self, share: Floats) -> Floats:
        """See `Profile`."""
        m = self.member
        return m.along_face(self.flank(1).along(share))

    def rising(self, name: Segment, side: int, x: Floats, rho_u: Floats) -> tuple[Floats, Floats]:
        """See `Profile`."""
        straight = self.sides[side].straight
        if name == "meridian" and straight is not None:
            delta, phi = straight.points(x, rho_u)
            return delta, side * phi
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

    def flank_foot(self, side: int, rho_u: Floats) -> Floats:
        """See `Profile`."""
        straight = self.sides[side].straight
        return self.foot_angle(side, rho_u) if straight is None else straight.top(rho_u)

    def off_straight(self, side: int, rho: Floats, delta: Floats, phi: Floats) -> Floats:
        """See `Profile`."""
        straight = self.sides[side].straight
        assert straight is not None
        pole, turned = straight.pole(self._near(rho, delta)), side * (phi - self.shift(side, rho, delta))
        return off_great_circle(pole, rho, delta, turned, rho * self.member.lengthwise.azimuth_slope(rho))

    def off_fillet(self, side: int, rho: Floats, delta: Floats, phi: Floats) -> Floats:
        """See `Profile`."""
        circle = self.sides[side].circle(self._near(rho, delta))
        turned = phi - self.shift(side, rho, delta)
        azimuth = wrapped(side * turned - circle.centre_azimuth)
        return off_circle(circle.radius, circle.centre_angle, delta, azimuth) * rho

    def _near(self, rho: Floats, delta: Floats) -> Floats:
        """rho_u of places, not far beyond the ends."""
        m, reach = self.member, BEYOND * self.member.face_width
        return np.clip(m.end_distance(rho, delta), m.inner_cone_distance - reach, m.outer_cone_distance + reach)

    def root_left(self, places: Floats) -> float:
        """Least azimuth that fillets leave between them at places along the face, over what they must leave [rad]."""
        _, first, last = self.across("root", places)
        return float(np.min(last - first)) - _LEAST_ROOT * self.member.pitch

    def extended(self, member: MemberGeometry) -> HypoidProfile:
        """See `Profile`."""
        reach = {"outer_cone_distance", "face_width", "fillet_radius", "tip_limit"}
        changes = {name: getattr(member, name) for name in reach}
        sides: dict[int, FilletSide] = {}
        for number, side in self.sides.items():
            sides[number] = side.extended(replace(side.flank.member, **changes))
        return HypoidProfile(member, sides)

    def unmodified(self, flanks: dict[int, Flank]) -> HypoidProfile:
        """See `Profile`."""
        profile = hypoid_profile(flanks)
        return replace(profile, member=replace(profile.member, reliefs=(None, None)))


def hypoid_profile(flanks: Mapping[int, Flank]) -> HypoidProfile:
    """The profile between two flanks by side.

    Where the fillet does not touch a conjugate flank, for that is undercut below the start of contact, a larger one
    may; where those leave no root, the tangent of the flank goes on down to fillets of the radius asked for. Fillets
    that leave no root even so become smaller.

    Raises
    ------
    GeometryError
        Fillets do not join flanks and root, neighbouring fillets leave no root, or a tooth is pointed.
    """
    member = flanks[1].member
    places = member.along_face(np.linspace(0.0, 1.0, _PLACES))
    asked = HypoidProfile(member, {side: _side(flank, member.fillet_angle) for side, flank in flanks.items()})
    profile = _with_root(asked, places)
    _refuse_pointed(profile, places)
    return profile


def _with_root(asked: HypoidProfile, places: Floats) -> HypoidProfile:
    """The profile, with fillets that leave a root: those asked for, or nearly the largest that do."""
    bad, (profile, missing) = 1.0, _led_down(asked, places)
    if missing >= 0:
        return profile
    share = _FIRST_STEP
    for _ in range(_ATTEMPTS):
        good, left = _with_share(asked, share, places)
        if left >= 0:
            break
        slope = max(left - missing, _FLAT * asked.member.pitch) / (bad - share)
        bad, missing = share, left
        share = min(max(share + _SURPLUS * left / slope, _LEAST_STEP * share), _MOST_STEP * share)
    else:
        raise FilletError(
            f"the fillets of neighbouring {asked.member.name} teeth overlap, however small they are",
            "use a smaller clearance, or other depths that leave the teeth more space at the root",
        )
    for _ in range(_REFINEMENTS):
        if bad - share < _CLOSE * share:
            break
        between = share + (bad - share) * min(max(_CAUTION * left / (left - missing), 0.1), 0.9)
        tried, there = _with_share(asked, between, places)
        if there >= 0:
            good, share, left = tried, between, there
        else:
            bad, missing = between, there
    return good


def _with_share(asked: HypoidProfile, share: float, places: Floats) -> tuple[HypoidProfile, float]:
    """The profile with a share of its fillets' radius, and what root is left."""
    return _led_down(replace(asked, sides={n: side.smaller(share) for n, side in asked.sides.items()}), places)


def _led_down(profile: HypoidProfile, places: Floats) -> tuple[HypoidProfile, float]:
    """The profile, with tangents in the place of larger circles where these leave no root, and what root is left."""
    left = profile.root_left(places)
    if left >= 0 or not any(_is_larger(side) for side in profile.sides.values()):
        return profile, left
    led = replace(profile, sides={number: _on_tangent(side) for number, side in profile.sides.items()})
    return led, led.root_left(places)


def _is_larger(side: FilletSide) -> bool:
    return isinstance(side, ConjugateSide) and side.is_larger


def _on_tangent(side: FilletSide) -> FilletSide:
    return replace(side, on_tangent=True) if isinstance(side, ConjugateSide) and side.is_larger else side


def _refuse_pointed(profile: HypoidProfile, places: Floats) -> None:
    _, first, last = profile.across("tip", places)
    if np.min(last - first) <= 0:
        raise GeometryError(f"the {profile.member.name}'s teeth are pointed below their face cone")


def _side(flank: Flank, radius: float) -> FilletSide:
    """The fillet of a radius [rad] below a flank."""
    if isinstance(flank, ConjugateFlank):
        return ConjugateSide(flank, radius)
    assert isinstance(flank, InvoluteFlank)
    return involute_side(flank, radius)
