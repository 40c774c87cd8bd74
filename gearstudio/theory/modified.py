"""A flank with micro-geometry: the involute flank, turned about the axis by as much as metal is taken off."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import Flank, FlankName, side_of
from gearstudio.theory.hypoid.conjugate import ConjugateFlank, pinion_flank
from gearstudio.theory.hypoid.inputs import MemberName
from gearstudio.theory.hypoid.modified import ModifiedConjugate
from gearstudio.theory.involute import polar_angle as polar_angle_of
from gearstudio.theory.involute_flank import InvoluteFlank, involute_flank
from gearstudio.theory.limit import Limit
from gearstudio.theory.relief import Derivatives, FlankRelief
from gearstudio.theory.vectors import matched, turned, turned_derivatives

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class ModifiedFlank(InvoluteFlank):
    """An involute flank from which metal is taken off; natural coordinates and limits stay those of the involute.

    With s(rho, delta_k) = -side e/lever(rho), lever = 1/sqrt(1/(rho sin delta_b)^2 + theta'^2), the azimuth is
    phi + s and the point R_z(s) X. Below the base cone the turned meridians go on with the same s.
    """

    relief: FlankRelief | None = None

    @property
    def plain(self) -> InvoluteFlank:
        """The flank without micro-geometry."""
        return self.swept

    def turning(self, psi: ArrayLike, rho: ArrayLike) -> Floats:
        """Azimuth by which metal taken off turns the point at natural coordinates [rad/mm]."""
        psi, rho = matched(psi, rho)
        return -self.side * _lever_inverse(self.member, rho)[0]

    @property
    def swept(self) -> InvoluteFlank:
        """The flank without micro-geometry: no rigid line sweeps this one."""
        return InvoluteFlank(self.member, self.side, self.foot)

    def at(self, psi: ArrayLike, rho: ArrayLike) -> Floats:
        """Points at natural coordinates, shape (..., 3)."""
        psi, rho = matched(psi, rho)
        return turned(super().at(psi, rho), self.shift(rho, polar_angle_of(psi, self.member.base_angle)))

    def azimuth(self, rho: ArrayLike, polar_angle: ArrayLike) -> Floats:
        """phi'(rho, delta_k) [rad]."""
        return super().azimuth(rho, polar_angle) + self.shift(rho, polar_angle)

    def shift(self, rho: ArrayLike, polar_angle: ArrayLike) -> Floats:
        """s(rho, delta_k): by how much the flank is turned there [rad]."""
        return azimuth_shift(self.member, self.side, self.relief, rho, polar_angle)

    def derivatives_at(self, psi: ArrayLike, rho: ArrayLike) -> tuple[Floats, Floats, Floats, Floats, Floats]:
        """First and second derivatives by psi and rho: those of R_z(s) X, shape (..., 3) each."""
        psi, rho = matched(psi, rho)
        point, by = super().at(psi, rho), super().derivatives_at(psi, rho)
        return turned_derivatives(point, by, self._shift_by_natural(psi, rho))

    def normals_at(self, psi: ArrayLike, rho: ArrayLike) -> Floats:
        """Unit normals out of the metal at natural coordinates; regular on the base cone too, shape (..., 3)."""
        psi, rho = matched(psi, rho)
        profile = np.sin(psi) / np.tan(self.member.base_angle)
        return self._normals(self.at(psi, rho), rho, polar_angle_of(psi, self.member.base_angle), profile)

    def lever(self, rho: Floats, polar_angle: Floats) -> Floats:
        """Normal distance per difference in azimuth [mm/rad]."""
        across, along = self._slopes(rho, polar_angle, self._profile_slope(polar_angle))
        return np.asarray(rho * np.sin(polar_angle) / np.sqrt(1 + across**2 + along**2))

    def _profile_slope(self, delta: Floats) -> Floats:
        """sin(delta_k) beta'(delta_k) = sqrt(sin^2 delta_k / sin^2 delta_b - 1), 0 on the meridians below."""
        ratio = np.sin(self._above(delta)) / np.sin(self.member.base_angle)
        return np.asarray(np.sqrt(np.maximum(ratio**2 - 1, 0.0)))

    def _slopes(self, rho: Floats, delta: Floats, profile: Floats) -> tuple[Floats, Floats]:
        """sin(delta_k) phi'_delta and rho sin(delta_k) phi'_rho."""
        _, s_r, s_d, *_ = self._shift_derivatives(rho, delta)
        theta = self.member.lengthwise.azimuth_slope(rho)
        return np.sin(delta) * s_d - self.side * profile, rho * np.sin(delta) * (theta + s_r)

    def _continued_azimuth(self, rho: Floats, delta: Floats) -> Floats:
        return super()._continued_azimuth(rho, delta) + self.shift(rho, delta)

    def _continued(self, rho: Floats, delta: Floats) -> tuple[Floats, Floats]:
        points = turned(rho[..., None] * self._continued_ray(rho, delta)[0], self.shift(rho, delta))
        return points, self._normals(points, rho, delta, self._profile_slope(delta))

    def _normals(self, points: Floats, rho: Floats, delta: Floats, profile: Floats) -> Floats:
        """Gradient of side (phi - phi'(rho, delta_k)), which is regular everywhere, as unit vectors."""
        across, along = (part[..., None] for part in self._slopes(rho, delta, profile))
        phi = np.arctan2(points[..., 1], points[..., 0])
        cos_p, sin_p, cos_d, sin_d, zero = np.cos(phi), np.sin(phi), np.cos(delta), np.sin(delta), np.zeros_like(phi)
        radial = np.stack([sin_d * cos_p, sin_d * sin_p, cos_d], axis=-1)
        downward = np.stack([cos_d * cos_p, cos_d * sin_p, -sin_d], axis=-1)
        normal = self.side * (np.stack([-sin_p, cos_p, zero], axis=-1) - along * radial - across * downward)
        return np.asarray(normal / np.linalg.norm(normal, axis=-1, keepdims=True))

    def _shift_derivatives(self, rho: Floats, delta: Floats) -> Derivatives:
        """s with its derivatives by rho and delta_k: the product of e with g = 1/lever(rho)."""
        if self.relief is None:
            zero = np.zeros(np.broadcast_shapes(np.shape(rho), np.shape(delta)))
            return zero, zero, zero, zero, zero, zero
        e, e_r, e_d, e_rr, e_rd, e_dd = self.relief.derivatives(rho, delta)
        g, g_1, g_2 = _lever_inverse(self.member, rho)
        turn = -self.side
        return (
            turn * e * g,
            turn * (e_r * g + e * g_1),
            turn * e_d * g,
            turn * (e_rr * g + 2 * e_r * g_1 + e * g_2),
            turn * (e_rd * g + e_d * g_1),
            turn * e_dd * g,
        )

    def _shift_by_natural(self, psi: Floats, rho: Floats) -> Derivatives:
        """s with its derivatives by psi and rho; cos(delta_k) = cos(delta_b) cos(psi)."""
        base = self.member.base_angle
        delta = polar_angle_of(psi, base)
        first = np.cos(base) * np.sin(psi) / np.sin(delta)
        second = (np.cos(base) * np.cos(psi) - np.cos(delta) * first**2) / np.sin(delta)
        s, s_r, s_d, s_rr, s_rd, s_dd = self._shift_derivatives(rho, delta)
        return s, s_d * first, s_r, s_dd * first**2 + s_d * second, s_rd * first, s_rr


def flank_of(member: MemberGeometry, name: FlankName) -> Flank:
    """The concave or convex flank of a member's tooth, with the micro-geometry that its design gives it.

    Raises
    ------
    GeometryError
        As `involute_flank`.
    """
    side = side_of(member.hand, name) if member.hypoid is not None else involute_flank(member, name).side
    return flank_on(member, side)


def flank_on(member: MemberGeometry, side: int, foot: Limit | None = None) -> Flank:
    """The flank on a side (+1 or -1), with micro-geometry; ``foot`` as of `InvoluteFlank`.

    The pinion of a pair with offset axes has conjugate flanks, which begin where contact does: without ``foot``.
    """
    if member.hypoid is not None and member.name == "pinion":
        return conjugate_on(member, side)
    return swept_on(member, side, foot)


def swept_on(member: MemberGeometry, side: int, foot: Limit | None = None) -> InvoluteFlank:
    """The spherical involute on a side, with micro-geometry: on the pinion of offset axes a reference only."""
    own, relief = flank_member(member, side), relief_on(member, side)
    return InvoluteFlank(own, side, foot) if relief is None else ModifiedFlank(own, side, foot, relief)


def flank_member(member: MemberGeometry, side: int) -> MemberGeometry:
    """The member as its flank on a side has it: with offset axes each flank has a base cone of its own."""
    if member.hypoid is None:
        return member
    name: MemberName = "pinion" if member.name == "pinion" else "wheel"
    own = member.hypoid.member(name, member.hypoid.flank_name(name, side))
    return replace(own, reliefs=member.reliefs, hypoid=member.hypoid)


@lru_cache(maxsize=64)
def conjugate_on(member: MemberGeometry, side: int) -> ConjugateFlank:
    """The conjugate flank of the pinion of a pair with offset axes, with micro-geometry; remembered."""
    assert member.hypoid is not None
    own, relief = flank_member(member, side), relief_on(member, side)
    flank = pinion_flank(member.hypoid, member.hypoid.flank_name("pinion", side))
    if relief is None:
        return replace(flank, member=own)
    return ModifiedConjugate(own, side, flank.envelope, alike=flank.alike, relief=relief)


def relief_on(member: MemberGeometry, side: int) -> FlankRelief | None:
    """The micro-geometry of the flank on a side."""
    return member.reliefs[0 if side == member.hand else 1]


def azimuth_shift(
    member: MemberGeometry, side: int, relief: FlankRelief | None, rho: ArrayLike, polar_angle: ArrayLike
) -> Floats:
    """-side e/lever [rad]: by how much micro-geometry turns a flank at cone distances and polar angles."""
    if relief is None:
        return np.zeros(np.broadcast_shapes(np.shape(rho), np.shape(polar_angle)))
    return np.asarray(-side * relief.value(rho, polar_angle) * _lever_inverse(member, rho)[0])


def azimuth_shift_slope(
    member: MemberGeometry, side: int, relief: FlankRelief, rho: ArrayLike, polar_angle: ArrayLike
) -> Floats:
    """Derivative of `azimuth_shift` by the polar angle."""
    return np.asarray(-side * relief.derivatives(rho, polar_angle)[2] * _lever_inverse(member, rho)[0])


def azimuth_shift_slope_at_place(
    member: MemberGeometry, side: int, relief: FlankRelief, rho: ArrayLike, polar_angle: ArrayLike
) -> Floats:
    """Derivative of `azimuth_shift` by the polar angle at a place along the face: the cone distance varies with it."""
    rho, polar_angle = np.asarray(rho, dtype=np.float64), np.asarray(polar_angle, dtype=np.float64)
    e, by_rho, by_angle, *_ = relief.derivatives(rho, polar_angle)
    g, g_1, _ = _lever_inverse(member, rho)
    widening = 0.0 if member.ends == "sphere" else rho * np.tan(polar_angle - member.pitch_angle)
    return np.asarray(-side * (by_angle * g + (by_rho * g + e * g_1) * widening))


def _lever_inverse(member: MemberGeometry, rho: ArrayLike) -> tuple[Floats, Floats, Floats]:
    """g = sqrt(1/(rho sin delta_b)^2 + theta'^2) [rad/mm], with two derivatives by rho."""
    rho = np.asarray(rho, dtype=np.float64)
    square = np.sin(member.base_angle) ** 2
    _, theta_1, theta_2 = member.lengthwise.azimuth_derivatives(rho)
    theta_3 = member.lengthwise.azimuth_third(rho)
    g = np.sqrt(1 / (rho**2 * square) + theta_1**2)
    first = (theta_1 * theta_2 - 1 / (rho**3 * square)) / g
    return g, first, (3 / (rho**4 * square) + theta_2**2 + theta_1 * theta_3 - first**2) / g
