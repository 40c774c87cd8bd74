"""The flank that a spherical involute sweeps: points, normals, derivatives, the deviation of points (theory 5)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import FlankName, border_gap, name_of, side_of
from gearstudio.theory.involute import (
    involute_azimuth,
    polar_angle,
    roll_arc,
    start_azimuth,
    tangent_plane,
)
from gearstudio.theory.limit import Limit
from gearstudio.theory.vectors import matched, quarter, spherical, wrapped

Floats = NDArray[np.float64]

_ITERATE_ABOVE = 1e-6
_FOOT_POINT_STEPS = 8
_FOOT_POINT_ACCURACY = 1e-11
_FOOT_POINT_TRUST = 1e-2


@dataclass(frozen=True)
class InvoluteFlank:
    """A flank swept by the spherical involute; natural coordinates are (psi, rho).

    Attributes
    ----------
    member : MemberGeometry
    side : {+1, -1}
        The flank at larger or smaller azimuth of the tooth centred at azimuth 0.
    foot : Limit, optional
        Where the flank begins; by default at the root or base cone, whichever is higher.
    """

    member: MemberGeometry
    side: int
    foot: Limit | None = None

    @property
    def name(self) -> FlankName:
        """``concave`` or ``convex``."""
        return name_of(self.member.hand, self.side)

    @property
    def swept(self) -> InvoluteFlank:
        """The flank that one rigid line sweeps (theory 5.1): this one."""
        return self

    def limits(self, v: ArrayLike) -> tuple[Floats, Floats]:
        """Polar angles of the working flank's lower and upper edge at places v along the face, (...) each [rad]."""
        m = self.member
        rho_u = self.member.along_face(v)
        upper = m.limit_angle(m.tip_limit, rho_u)
        if self.foot is not None:
            return m.limit_angle(self.foot, rho_u), upper
        return self._lowest(rho_u), upper

    def _lowest(self, rho_u: Floats) -> Floats:
        """Root or base cone, whichever is higher; where they cross along the face, a line over both, without corner."""
        m = self.member
        ends = np.array([m.inner_cone_distance, m.outer_cone_distance])
        base = m.base_angle
        if m.root_limit.offset != 0.0 and np.prod(np.sign(m.limit_angle(m.root_limit, ends) - base)) < 0:
            toe, heel = np.maximum(m.limit_angle(m.root_limit, ends), base)
            return np.asarray(np.maximum(toe + (rho_u - ends[0]) / m.face_width * (heel - toe), base))
        return np.maximum(m.limit_angle(m.root_limit, rho_u), m.limit_angle(m.base_limit, rho_u))

    @property
    def starts_on_base(self) -> bool:
        """Whether the lower edge is the base cone, where the flank's first derivative by u vanishes."""
        low = roll_arc(self.limits(np.linspace(0.0, 1.0, 9))[0], self.member.base_angle)
        return bool(np.all(low < 1e-9))

    def coordinates(self, u: ArrayLike, v: ArrayLike) -> tuple[Floats, Floats]:
        """psi [rad] and rho [mm] at (u, v); psi is linear in u, in which the flank is analytic."""
        u, v = matched(u, v)
        low, high = (roll_arc(limit, self.member.base_angle) for limit in self.limits(v))
        psi = low + u * (high - low)
        return psi, self.member.cone_distance(self.member.along_face(v), polar_angle(psi, self.member.base_angle))

    def points(self, u: ArrayLike, v: ArrayLike) -> Floats:
        """Points of the working flank, shape (..., 3) [mm]."""
        return self.at(*self.coordinates(u, v))

    def along(self, share: ArrayLike) -> Floats:
        """Places v at which shares in [0, 1] divide the face for an interpolation (see `Lengthwise.divided`)."""
        m = self.member
        rho_u = m.lengthwise.divided(m.inner_cone_distance, m.outer_cone_distance, share)
        return m.face_share(rho_u)

    def evenly_divided(self, n_u: int, n_v: int) -> Floats:
        """Points of the working flank at evenly spaced polar angles and places along the face, (n_u, n_v, 3)."""
        v = np.linspace(0.0, 1.0, n_v)
        lower, upper = self.limits(v)
        delta = lower + np.linspace(0.0, 1.0, n_u)[:, None] * (upper - lower)
        return self.points_at(self.member.cone_distance(self.member.along_face(v), delta), delta)

    def trace(self, v: ArrayLike) -> Floats:
        """Points of the tooth trace, where the flank meets the pitch cone, shape (..., 3)."""
        rho = self.member.along_face(v)
        return self.points_at(rho, np.full_like(rho, self.member.pitch_angle))

    def normals(self, u: ArrayLike, v: ArrayLike) -> Floats:
        """Unit normals pointing out of the tooth's metal, shape (..., 3)."""
        return self.normals_at(*self.coordinates(u, v))

    def points_at(self, rho: ArrayLike, polar_angle: ArrayLike) -> Floats:
        """Points at cone distance rho [mm] and polar angle delta_k [rad], shape (..., 3).

        Raises
        ------
        GeometryError
            A polar angle lies inside the base cone.
        """
        return self.at(roll_arc(polar_angle, self.member.base_angle), rho)

    def at(self, psi: ArrayLike, rho: ArrayLike) -> Floats:
        """Points rho [cos(psi) e_t(a) + side sin(psi) e_phi(a)] at natural coordinates, shape (..., 3) (theory 5.1)."""
        psi, rho = matched(psi, rho)
        return np.asarray(rho[..., None] * self._ray(psi, rho, self.member.base_angle)[0])

    def contact_azimuth(self, psi: ArrayLike, rho: ArrayLike) -> Floats:
        """Azimuth a [rad] of the rolling plane's line of contact when it makes the point (psi, rho)."""
        roll = np.asarray(psi, dtype=np.float64) / np.sin(self.member.base_angle)
        return np.asarray(start_azimuth(self.member, self.side, rho) - self.side * roll)

    def derivatives_at(self, psi: ArrayLike, rho: ArrayLike) -> tuple[Floats, Floats, Floats, Floats, Floats]:
        """First and second derivatives by the natural coordinates.

        Returns
        -------
        X_psi, X_rho, X_psi_psi, X_psi_rho, X_rho_rho : ndarray, shape (..., 3)

        Notes
        -----
        With K the unit vector of `at` and e_n the normal of the rolling plane,
        K_psi = sin(psi) cot(delta_b) e_n: the flank's point moves square to the plane that generates it.
        """
        psi, rho = matched(psi, rho)
        cot_b = 1 / np.tan(self.member.base_angle)
        along, across, normal = tangent_plane(self.member.base_angle, self.contact_azimuth(psi, rho))
        sin_psi, cos_psi, r = np.sin(psi)[..., None], np.cos(psi)[..., None], rho[..., None]
        unit = cos_psi * along + self.side * sin_psi * across
        unit_psi = sin_psi * cot_b * normal
        unit_psi_psi = cot_b * (cos_psi * normal - self.side * sin_psi * cot_b * across)
        _, first, second = (x[..., None] for x in self.member.lengthwise.azimuth_derivatives(rho))
        turned, turned_psi, turned_twice = quarter(unit), quarter(unit_psi), quarter(quarter(unit))
        return (
            r * unit_psi,
            unit + r * first * turned,
            r * unit_psi_psi,
            unit_psi + r * first * turned_psi,
            2 * first * turned + r * (second * turned + first**2 * turned_twice),
        )

    def normals_at(self, psi: ArrayLike, rho: ArrayLike) -> Floats:
        """Unit normals out of the metal at natural coordinates; regular on the base cone too, shape (..., 3)."""
        psi, rho = matched(psi, rho)
        return self._normal(*self._ray(psi, rho, self.member.base_angle), rho)

    def locate(self, points: ArrayLike) -> tuple[Floats, Floats, Floats]:
        """Spherical coordinates rho [mm], delta_k [rad], phi [rad] of points, shape (...) each (theory 1)."""
        return spherical(points)

    def natural(self, points: ArrayLike) -> tuple[Floats, Floats]:
        """Natural coordinates (psi, rho) of the flank at points on or near it; not below the base cone, (...) each."""
        rho, delta, _ = self.locate(points)
        return self.natural_at(rho, delta)

    def natural_at(self, rho: ArrayLike, polar_angle: ArrayLike) -> tuple[Floats, Floats]:
        """Natural coordinates (psi, rho) at places on the flank; those below the base cone count as on it."""
        return roll_arc(self._above(polar_angle), self.member.base_angle), np.asarray(rho, dtype=np.float64)

    def deviation(self, points: ArrayLike) -> Floats:
        """Signed normal distance of points from the flank, positive where metal is added.

        Parameters
        ----------
        points : array_like, shape (..., 3)
            Near this flank of the tooth centred at azimuth 0 [mm].

        Returns
        -------
        ndarray, shape (...)
            e [mm]. Below the base cone the flank continues along its meridian (theory 6).

        Notes
        -----
        theory.md section 5: the difference in azimuth times the lever, exact to second order; where it
        exceeds a millionth of the cone distance the foot point is iterated.
        """
        points = np.asarray(points, dtype=np.float64)
        rho, delta, phi = self.locate(points)
        error = np.asarray(self.side * wrapped(phi - self._continued_azimuth(rho, delta)) * self.lever(rho, delta))
        far = np.abs(error) > _ITERATE_ABOVE * rho
        if np.any(far):
            error = np.array(error)
            error[far] = self._foot_point_deviation(points[far], error[far])
        return error

    def edge_deviation(self, points: Floats) -> float:
        """Farthest that the border of a surface lies from the edges of the working flank [mm].

        Parameters
        ----------
        points : ndarray, shape (n_u, n_v, 3)
            On the surface, u root to tip, v toe to heel; only the border rows are looked at.

        Notes
        -----
        Measured along the flank: polar angle times cone distance at root and tip, cone distance at toe and heel.
        """
        return border_gap(self, points)

    def _continued_azimuth(self, rho: Floats, delta: Floats) -> Floats:
        """Azimuth of the flank, and of the meridians that continue it below the base cone [rad]."""
        return InvoluteFlank.azimuth(self, rho, self._above(delta))

    def _above(self, polar_angle: ArrayLike) -> Floats:
        """Polar angles, those below the base cone brought up to it [rad]."""
        return np.clip(polar_angle, self.member.base_angle, np.pi - self.member.base_angle)

    def _foot_point_deviation(self, points: Floats, start: Floats) -> Floats:
        """Distance along the normal of the foot point; ``start`` stands where the iteration finds none."""
        rho, delta, _ = self.locate(points)
        gap, change = start, np.full_like(start, np.inf)
        for _ in range(_FOOT_POINT_STEPS):
            foot, normal = self._continued(rho, delta)
            before, gap = gap, np.sum((points - foot) * normal, axis=-1)
            change = np.abs(gap - before)
            if np.all(change <= _FOOT_POINT_ACCURACY * rho):
                break
            rho, delta, _ = self.locate(points - gap[..., None] * normal)
        return np.where(change <= _FOOT_POINT_TRUST * np.abs(gap), gap, start)

    def _continued(self, rho: Floats, delta: Floats) -> tuple[Floats, Floats]:
        """Points and outward normals of the flank and of the meridians that continue it below the base cone."""
        unit, plane = self._continued_ray(rho, delta)
        return rho[..., None] * unit, self._normal(unit, plane, rho)

    def _continued_ray(self, rho: Floats, delta: Floats) -> tuple[Floats, Floats]:
        """As `_ray`, along the meridians too."""
        base = self.member.base_angle
        return self._ray(roll_arc(self._above(delta), base), rho, np.minimum(delta, base))

    def _ray(self, psi: Floats, rho: Floats, cone_angle: float | Floats) -> tuple[Floats, Floats]:
        """Direction of a point from the apex, and the normal of the plane that rolls on a cone and makes it."""
        along, across, plane = tangent_plane(cone_angle, self.contact_azimuth(psi, rho))
        return np.cos(psi)[..., None] * along + self.side * np.sin(psi)[..., None] * across, plane

    def _normal(self, unit: Floats, plane: Floats, rho: Floats) -> Floats:
        """Unit normals out of the metal: square to trace and profile, which runs along the rolling plane's normal."""
        lengthwise = unit + (rho * self.member.lengthwise.azimuth_slope(rho))[..., None] * quarter(unit)
        normal = self.side * np.cross(lengthwise, plane)
        return np.asarray(normal / np.linalg.norm(normal, axis=-1, keepdims=True))

    def lever(self, rho: Floats, polar_angle: Floats) -> Floats:
        """Normal distance per difference in azimuth [mm/rad] (theory 5); as on the base cone below it."""
        m = self.member
        profile = (np.sin(self._above(polar_angle)) / np.sin(m.base_angle)) ** 2  # 1 + (sin(delta_k) beta'(delta_k))^2
        spiral = (np.sin(polar_angle) * rho * m.lengthwise.azimuth_slope(rho)) ** 2
        return np.asarray(rho * np.sin(polar_angle) / np.sqrt(profile + spiral))

    def lower_angle(self, rho: ArrayLike) -> Floats:
        """Polar angle of root or base cone, whichever is higher, at cone distances [rad]."""
        return np.maximum(self.member.root_limit.at_sphere(rho), self.member.base_angle)

    def azimuth(self, rho: ArrayLike, polar_angle: ArrayLike) -> Floats:
        """phi(rho, delta_k) of theory 5 [rad]."""
        beta = involute_azimuth(polar_angle, self.member.base_angle)
        return np.asarray(start_azimuth(self.member, self.side, rho) - self.side * beta)


def involute_flank(member: MemberGeometry, name: FlankName) -> InvoluteFlank:
    """The concave or convex flank of a member's tooth without micro-geometry.

    Raises
    ------
    GeometryError
        The cutter arc does not cross the whole face width.
    """
    nearest, farthest = member.lengthwise.reach
    if not nearest < member.inner_cone_distance < member.outer_cone_distance < farthest:
        raise GeometryError(
            f"a cutter of radius {member.lengthwise.cutter_radius:.6g} mm does not cross the whole face width"
        )
    return InvoluteFlank(member, side_of(member.hand, name))
