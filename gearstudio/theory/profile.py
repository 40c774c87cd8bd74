"""The profile of the whole tooth on the unit sphere: root, fillet, flank, tip (theory 6).

Everything is given for the half of the tooth at larger azimuth; the other half is its mirror image.
A profile is self-similar: at every cone distance it is the same, turned by theta(rho). Micro-geometry turns it
further, by `ToothProfile.shift`.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache, partial

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.fillet import Fillet, fillet
from gearstudio.theory.flank import Flank
from gearstudio.theory.hypoid.profile import hypoid_profile
from gearstudio.theory.involute import azimuth_from_arc, base_azimuth, involute_azimuth, polar_angle, roll_arc
from gearstudio.theory.limit import ConeLimit
from gearstudio.theory.modified import azimuth_shift, azimuth_shift_slope_at_place, flank_on, relief_on
from gearstudio.theory.section import Profile, Segment, Shift, faded, off_circle
from gearstudio.theory.vectors import from_spherical, matched, spherical, wrapped

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class ToothProfile:
    """The half profile of a member's tooth, as curves on the unit sphere."""

    member: MemberGeometry
    fillet: Fillet

    @property
    def segments(self) -> tuple[Segment, ...]:
        """Names of the curves from the middle of the space to the middle of the tooth."""
        names: list[Segment] = [] if self.fillet.full_round else ["root"]
        names.append("fillet")
        if self.fillet.on_meridian and self.fillet.foot_angle < self.member.base_angle:
            names.append("meridian")
        return (*names, "flank", "tip")

    def angles(self, segment: Segment, s: ArrayLike, tip_angle: ArrayLike | None = None) -> tuple[Floats, Floats]:
        """Polar angle and azimuth along a segment [rad], s from 0 at the root's side to 1.

        Parameters
        ----------
        segment : str
        s : array_like, shape (...)
        tip_angle : array_like, optional
            delta_tip where it depends on the place along the face; by default the face cone angle.
        """
        m, fillet = self.member, self.fillet
        s = np.asarray(s, dtype=np.float64)
        top = np.asarray(m.tip_angle if tip_angle is None else tip_angle, dtype=np.float64)
        start = base_azimuth(m)
        if segment == "root":
            azimuth = m.pitch / 2 + s * (fillet.centre_azimuth - m.pitch / 2)
            return np.full_like(s, m.root_angle), azimuth
        if segment == "fillet":
            return spherical(fillet.points(s))[1:]
        if segment == "meridian":
            return fillet.foot_angle + s * (m.base_angle - fillet.foot_angle), np.full_like(s, start)
        if segment == "flank":
            psi = fillet.foot_arc + s * (roll_arc(top, m.base_angle) - fillet.foot_arc)
            return polar_angle(psi, m.base_angle), start - azimuth_from_arc(psi, m.base_angle)
        tip_azimuth = start - involute_azimuth(top, m.base_angle)
        return np.broadcast_to(top, np.broadcast_shapes(top.shape, s.shape)), np.asarray((1 - s) * tip_azimuth)

    def shift(self, side: int, rho: ArrayLike, delta: ArrayLike) -> Floats:
        """By how much micro-geometry turns the profile of one side [rad], at cone distances and polar angles.

        Above the foot of the flank it is the flank's own; below, in fillet and meridian, it goes on with the same
        value and slope at its place along the face and fades out, slope included, at the root. Turning about the axis
        by a smooth function of the place leaves faces tangent that were tangent.
        """
        rho, delta = matched(rho, delta)
        m, relief = self.member, relief_on(self.member, side)
        if relief is None:
            return np.zeros(rho.shape)
        top = m.base_angle if self.fillet.on_meridian else self.fillet.foot_angle
        above = np.maximum(delta, top)
        rho = m.cone_distance(m.end_distance(rho, delta), above)
        value = azimuth_shift(m, side, relief, rho, above)
        if not np.any(delta < top):
            return value
        slope = azimuth_shift_slope_at_place(m, side, relief, rho, above)
        return faded(value, slope, delta, np.asarray(m.root_angle), np.asarray(top))

    @property
    def has_root(self) -> bool:
        """See `Profile`."""
        return not self.fillet.full_round

    def below(self, side: int) -> tuple[Segment, ...]:
        """See `Profile`."""
        return ("fillet", "meridian") if "meridian" in self.segments else ("fillet",)

    def flank(self, side: int) -> Flank:
        """See `Profile`."""
        m = self.member
        foot = m.base_limit if self.fillet.on_meridian else ConeLimit(self.fillet.foot_angle, 0.0, m.pitch_angle)
        return flank_on(m, side, foot)

    def shift_on(self, side: int) -> Shift | None:
        """See `Profile`."""
        return None if relief_on(self.member, side) is None else partial(self.shift, side)

    def places(self, share: Floats) -> Floats:
        """See `Profile`."""
        m = self.member
        return m.lengthwise.divided(m.inner_cone_distance, m.outer_cone_distance, share)

    def rising(self, name: Segment, side: int, x: Floats, rho_u: Floats) -> tuple[Floats, Floats]:
        """See `Profile`."""
        delta, phi = self.angles(name, x)
        return delta, side * phi

    def across(self, name: Segment, rho_u: Floats) -> tuple[Floats, Floats, Floats]:
        """See `Profile`."""
        m = self.member
        if name == "tip":
            delta, phi = self.angles("tip", np.zeros_like(rho_u), m.limit_angle(m.tip_limit, rho_u))
            return delta, -phi, phi
        edge = np.full_like(rho_u, self.fillet.centre_azimuth)
        return np.full_like(rho_u, m.root_angle), edge, m.pitch - edge

    def foot_angle(self, side: int, rho_u: Floats) -> Floats:
        """See `Profile`."""
        return np.full_like(rho_u, self.fillet.foot_angle)

    def flank_foot(self, side: int, rho_u: Floats) -> Floats:
        """See `Profile`."""
        fillet = self.fillet
        return np.full_like(rho_u, self.member.base_angle if fillet.on_meridian else fillet.foot_angle)

    def off_straight(self, side: int, rho: Floats, delta: Floats, phi: Floats) -> Floats:
        """See `Profile`."""
        m = self.member
        across = side * (phi - self.shift(side, rho, delta)) - base_azimuth(m)
        along = rho * m.lengthwise.azimuth_slope(rho) * np.sin(delta)
        return np.asarray(rho * np.arcsin(np.sin(delta) * np.sin(across)) / np.hypot(1.0, along))

    def off_fillet(self, side: int, rho: Floats, delta: Floats, phi: Floats) -> Floats:
        """See `Profile`."""
        turned = phi - self.shift(side, rho, delta)
        azimuth = wrapped(side * turned - self.fillet.centre_azimuth)
        return off_circle(np.asarray(self.fillet.radius), np.asarray(self.fillet.centre_angle), delta, azimuth) * rho

    def extended(self, member: MemberGeometry) -> Profile:
        """See `Profile`."""
        return tooth_profile(member)

    def unmodified(self, flanks: dict[int, Flank]) -> Profile:
        """See `Profile`."""
        return tooth_profile(replace(self.member, reliefs=(None, None)))

    def outline(self, v: float, samples: int = 16) -> Floats:
        """Points of the whole profile at a place along the face, from space to space, shape (n, 3) [mm].

        Parameters
        ----------
        v : float
            0 at the toe, 1 at the heel.
        samples : int
            Points on each segment.
        """
        m = self.member
        rho_u = m.along_face(v)
        tip = m.limit_angle(m.tip_limit, rho_u)
        s = np.linspace(0.0, 1.0, samples)
        half = [self.angles(name, s, tip) for name in self.segments]
        delta = np.concatenate([half[0][0][:1], *(part[0][1:] for part in half)])
        phi = np.concatenate([half[0][1][:1], *(part[1][1:] for part in half)])
        rho = m.cone_distance(rho_u, delta)
        # the tip's two halves meet in the tooth's middle, which stays
        share = np.concatenate([np.ones(len(phi) - samples + 1), (1 - s)[1:]])
        sides = [side * phi + share * self.shift(side, rho, delta) for side in (1, -1)]
        delta, phi = np.concatenate([delta, delta[-2::-1]]), np.concatenate([sides[0], sides[1][-2::-1]])
        rho = m.cone_distance(rho_u, delta)
        return from_spherical(rho, delta, phi + m.lengthwise.azimuth(rho))


def profile_of(member: MemberGeometry) -> Profile:
    """The profile of a member's tooth, of whatever kind its pair is.

    Raises
    ------
    GeometryError
        As `tooth_profile` and `hypoid_profile`.
    """
    if member.hypoid is None and member.root_limit.offset == 0:
        return tooth_profile(member)
    return _changing_profile(member)


@lru_cache(maxsize=16)
def _changing_profile(member: MemberGeometry) -> Profile:
    """The profile of a tooth that changes along its face; remembered, for validation, views and methods ask for it."""
    return hypoid_profile({side: flank_on(member, side) for side in (-1, 1)})


def tooth_profile(member: MemberGeometry) -> ToothProfile:
    """The profile of a member's tooth whose root cone has the apex of the pitch cone, without an offset.

    Raises
    ------
    GeometryError
        Neighbouring flanks meet above the root: there is no tooth space.
    """
    return ToothProfile(member, fillet(member))
