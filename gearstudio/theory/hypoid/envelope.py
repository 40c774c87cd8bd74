"""The pinion's flank as the envelope of the wheel's, in closed form.

While both members roll, a point of the wheel's flank touches the pinion where its normal stands square to the relative
velocity. With N the wheel's normal and m = p x N its moment about the wheel's apex, turned by t about the wheel's axis,

    F(t) = A cos t + B sin t + C = 0,   t = atan2(B, A) +- arccos(-C / hypot(A, B)),

which is linear in (N, m): its derivatives along the flank follow from those of N and m.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.errors import GeometryError
from gearstudio.theory.hypoid.axes import Axes
from gearstudio.theory.involute import roll_arc, tangent_plane
from gearstudio.theory.involute_flank import InvoluteFlank
from gearstudio.theory.vectors import cross, dot, matched, quarter, turned, wrapped

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class WheelPoint:
    """Points of the wheel's flank about its apex, with their normals (not of length one) and derivatives.

    Attributes
    ----------
    point, by_psi, by_rho : ndarray, shape (..., 3)
    normal, normal_by_psi, normal_by_rho : ndarray, shape (..., 3)
        Out of the wheel's metal.
    """

    point: Floats
    by_psi: Floats
    by_rho: Floats
    normal: Floats
    normal_by_psi: Floats
    normal_by_rho: Floats


@dataclass(frozen=True)
class PinionPoint:
    """Points of the pinion's flank in its own frame, about its pitch apex.

    Attributes
    ----------
    point, by_psi, by_rho : ndarray, shape (..., 3)
        With derivatives by the wheel's natural coordinates.
    normal : ndarray, shape (..., 3)
        Unit vectors out of the pinion's metal.
    normal_by_psi, normal_by_rho : ndarray, shape (..., 3)
        Derivatives of the normal, in the tangent plane.
    area_ratio : ndarray, shape (...)
        J: area of the pinion's flank over that of the wheel's; 0 is a cusp and less than 0 undercut. It is
        infinite on the wheel's base cone.
    wheel_turn : ndarray, shape (...)
        phi_2 [rad] at which the point touches; phi_1 = -u phi_2.
    """

    point: Floats
    by_psi: Floats
    by_rho: Floats
    normal: Floats
    normal_by_psi: Floats
    normal_by_rho: Floats
    area_ratio: Floats
    wheel_turn: Floats


@dataclass(frozen=True)
class Envelope:
    """What a wheel flank, rolling with a pinion, leaves of it.

    Attributes
    ----------
    wheel : InvoluteFlank
        Of the tooth centred at azimuth 0, without backlash.
    axes : Axes
    ratio : float
        u = z_2 / z_1.
    half_space : float
        Half the wheel's tooth space at the mean point [rad].
    thinning : float
        Azimuth taken from the pinion's flank for backlash [rad].
    """

    wheel: InvoluteFlank
    axes: Axes
    ratio: float
    half_space: float
    thinning: float = 0.0

    @property
    def side(self) -> int:
        """+1 or -1, of both flanks."""
        return self.wheel.side

    def wheel_point(self, psi: ArrayLike, rho: ArrayLike) -> WheelPoint:
        """Points, normals and first derivatives of the wheel's flank at natural coordinates psi [rad], rho [mm].

        Notes
        -----
        N = side X_rho x e_n with e_n square to the rolling plane, which is side (K x e_n - rho theta' sin(delta_b) K)
        for the unit vector K to the point; all of it turns by theta(rho) about the axis. Regular on the base cone.
        """
        psi, rho = matched(psi, rho)
        member, side = self.wheel.member, self.side
        sin_b, cos_b = np.sin(member.base_angle), np.cos(member.base_angle)
        along, across, plane = tangent_plane(member.base_angle, self.wheel.contact_azimuth(psi, rho))
        sin_psi, cos_psi, r = np.sin(psi)[..., None], np.cos(psi)[..., None], rho[..., None]
        slope, bend = (x[..., None] for x in member.lengthwise.azimuth_derivatives(rho)[1:])
        ray = cos_psi * along + side * sin_psi * across
        lean = r * slope
        normal = side * (cos_psi * across - lean * sin_b * ray) - sin_psi * along
        return WheelPoint(
            point=r * ray,
            by_psi=(r * sin_psi * (cos_b / sin_b)) * plane,
            by_rho=ray + lean * quarter(ray),
            normal=normal,
            normal_by_psi=(cos_b / sin_b * cos_psi - side * cos_b * lean * sin_psi) * plane,
            normal_by_rho=slope * quarter(normal) - (side * sin_b * (slope + r * bend)) * ray,
        )

    def at(self, psi: ArrayLike, rho: ArrayLike) -> PinionPoint:
        """Points of the pinion's flank that the wheel's points at natural coordinates generate.

        Raises
        ------
        GeometryError
            A point of the wheel's flank never touches.
        """
        made = self.made(psi, rho)
        _refuse_missed(made.wheel_turn)
        return made

    def made(self, psi: ArrayLike, rho: ArrayLike) -> PinionPoint:
        """As `at`, but not a number where the wheel's points never touch."""
        w = self.wheel_point(psi, rho)
        turn, slopes = self.turn(w)
        point, by = self.moved(w, turn, slopes)
        normal = turned(w.normal, turn)
        length = np.sqrt(dot(normal, normal))[..., None]
        outward = -normal / length
        spin = quarter(normal) + self.ratio * cross(self.axes.pinion_axis, normal)
        leaning = []
        for d, slope in zip((w.normal_by_psi, w.normal_by_rho), slopes, strict=True):
            change = -(turned(d, turn) + spin * slope[..., None]) / length
            leaning.append(change - outward * dot(change, outward)[..., None])
        before = dot(cross(w.by_psi, w.by_rho), w.normal)
        with np.errstate(divide="ignore", invalid="ignore"):
            area = np.where(before == 0, np.inf, dot(cross(by[0], by[1]), normal) / before)
        wheel_turn = self.turn_of_wheel(turn)
        own = [self.to_pinion(x, wheel_turn) for x in (point, *by, outward, *leaning)]
        return PinionPoint(own[0], own[1], own[2], own[3], own[4], own[5], area, wheel_turn)

    def tangents(self, psi: ArrayLike, rho: ArrayLike) -> tuple[Floats, Floats, Floats]:
        """Points of the pinion's flank and their derivatives by psi and rho, not a number where none touches."""
        w = self.wheel_point(psi, rho)
        turn, slopes = self.turn(w)
        point, by = self.moved(w, turn, slopes)
        wheel_turn = self.turn_of_wheel(turn)
        return (
            self.to_pinion(point, wheel_turn),
            self.to_pinion(by[0], wheel_turn),
            self.to_pinion(by[1], wheel_turn),
        )

    def points(self, psi: ArrayLike, rho: ArrayLike) -> Floats:
        """Points alone, shape (..., 3); raises as `at`."""
        w = self.wheel_point(psi, rho)
        turn, _ = self.turn(w)
        _refuse_missed(turn)
        return self.to_pinion(turned(w.point, turn) - self._reach, self.turn_of_wheel(turn))

    def wheel_turn(self, psi: ArrayLike, rho: ArrayLike) -> Floats:
        """phi_2 [rad] at which the wheel's points at natural coordinates touch, shape (...); raises as `at`."""
        turn, _ = self.turn(self.wheel_point(psi, rho))
        _refuse_missed(turn)
        return self.turn_of_wheel(turn)

    @cached_property
    def _reach(self) -> Floats:
        """d = A_1 - A_2."""
        return self.axes.pinion_apex - self.axes.wheel_apex

    @cached_property
    def _moment(self) -> Floats:
        """k = e_1 x d."""
        return np.cross(self.axes.pinion_axis, self._reach)

    @cached_property
    def _mean_turn(self) -> float:
        """t at the mean point, where the flanks touch by construction [rad]."""
        return self.axes.mean_azimuth - self.side * (np.pi / self.wheel.member.teeth - self.half_space)

    @cached_property
    def _branch(self) -> float:
        """Sign before the arccosine, fixed by the mean point."""
        member = self.wheel.member
        psi = roll_arc(member.pitch_angle, member.base_angle)
        w = self.wheel_point(psi, member.lengthwise.mean_cone_distance)
        a, b, _ = self.coefficients(w.normal, cross(w.point, w.normal))
        return 1.0 if np.sin(self._mean_turn - np.arctan2(b, a)) >= 0 else -1.0

    def coefficients(self, normal: Floats, moment: Floats) -> tuple[Floats, Floats, Floats]:
        """A, B, C of F for a normal and its moment."""
        (sin_s, _, cos_s), (kx, ky, kz) = self.axes.pinion_axis, self._moment
        nx, ny, nz = normal[..., 0], normal[..., 1], normal[..., 2]
        mx, my, mz = moment[..., 0], moment[..., 1], moment[..., 2]
        return (
            sin_s * mx - kx * nx - ky * ny,
            kx * ny - ky * nx - sin_s * my,
            (cos_s + 1 / self.ratio) * mz - kz * nz,
        )

    def turn(self, w: WheelPoint) -> tuple[Floats, tuple[Floats, Floats]]:
        """t of the wheel's tooth at contact, and its derivatives by psi and rho."""
        a, b, c = self.coefficients(w.normal, cross(w.point, w.normal))
        with np.errstate(invalid="ignore"):
            turn = np.arctan2(b, a) + self._branch * np.arccos(-c / np.hypot(a, b))
        turn = self._mean_turn + wrapped(turn - self._mean_turn)
        cos_t, sin_t = np.cos(turn), np.sin(turn)
        steep = b * cos_t - a * sin_t

        def slope(normal: Floats, by: Floats) -> Floats:
            moment = cross(by, w.normal) + cross(w.point, normal)
            a_j, b_j, c_j = self.coefficients(normal, moment)
            return np.asarray(-(a_j * cos_t + b_j * sin_t + c_j) / steep)

        with np.errstate(divide="ignore", invalid="ignore"):
            return turn, (slope(w.normal_by_psi, w.by_psi), slope(w.normal_by_rho, w.by_rho))

    def moved(self, w: WheelPoint, turn: Floats, slopes: tuple[Floats, Floats]) -> tuple[Floats, list[Floats]]:
        """Points about the pinion's apex and their derivatives as the pinion sees them, in the world's directions."""
        arm = turned(w.point, turn) - self._reach
        sliding = quarter(arm + self._reach) + self.ratio * cross(self.axes.pinion_axis, arm)
        return arm, [
            turned(d, turn) + sliding * slope[..., None] for d, slope in zip((w.by_psi, w.by_rho), slopes, strict=True)
        ]

    def turn_of_wheel(self, turn: Floats) -> Floats:
        """phi_2 at turns t of the wheel's tooth [rad]."""
        return np.asarray(turn - self.axes.mean_azimuth + self.side * np.pi / self.wheel.member.teeth)

    def to_pinion(self, vectors: Floats, wheel_turn: Floats) -> Floats:
        """Vectors of the world's directions in the pinion's frame when the wheel has turned by phi_2."""
        own = vectors @ self.axes.pinion_frame
        return turned(own, self.ratio * wheel_turn - self.side * self.thinning)


def _refuse_missed(turn: Floats) -> None:
    if np.any(np.isnan(turn)):
        raise GeometryError("points of the wheel's flank never touch the pinion")
