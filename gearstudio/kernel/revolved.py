"""Surfaces of revolution about the gear axis, with azimuth and height read off as surface parameters."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from OCP.Geom import (
    Geom_Circle,
    Geom_ConicalSurface,
    Geom_Curve,
    Geom_CylindricalSurface,
    Geom_Line,
    Geom_Plane,
    Geom_SphericalSurface,
    Geom_Surface,
)
from OCP.Geom2d import Geom2d_Circle, Geom2d_Curve, Geom2d_Line
from OCP.gp import gp_Ax2, gp_Ax3, gp_Ax22d, gp_Dir, gp_Dir2d, gp_Pnt, gp_Pnt2d

Floats = NDArray[np.float64]
TURN = 2 * np.pi


@dataclass(frozen=True)
class Revolved:
    """A plane, cylinder, cone or sphere about the z axis, cut open at an azimuth.

    Attributes
    ----------
    first, last : (float, float)
        Two points (radius, height) of its meridian [mm]; for a sphere, both at the same distance from the apex.
    seam : float
        Azimuth at which its parameter u begins [rad].
    sphere : bool
    """

    first: tuple[float, float]
    last: tuple[float, float]
    seam: float
    sphere: bool = False

    @property
    def is_plane(self) -> bool:
        """No seam edge is needed."""
        return not self.sphere and abs(self.last[1] - self.first[1]) < 1e-12 * self._size

    @property
    def is_cylinder(self) -> bool:
        """Whether both ends have the same radius."""
        return not self.sphere and abs(self.last[0] - self.first[0]) < 1e-12 * self._size

    @property
    def direction(self) -> int:
        """+1 where u grows with azimuth; a cone that narrows upward stands on its head."""
        if self.sphere or self.is_plane or self.is_cylinder:
            return 1
        return 1 if (self.last[0] - self.first[0]) * (self.last[1] - self.first[1]) > 0 else -1

    @property
    def outward(self) -> bool:
        """Whether the natural normal points to the right of the way from first to last, out of the metal."""
        if self.is_plane:
            return self.last[0] < self.first[0]
        return self.last[1] > self.first[1]

    def geometry(self) -> Geom_Surface:
        """The kernel's surface."""
        if self.sphere:
            return Geom_SphericalSurface(self._axes(0.0), float(np.hypot(*self.first)))
        axes = self._axes(self.first[1])
        if self.is_plane:
            return Geom_Plane(axes)
        if self.is_cylinder:
            return Geom_CylindricalSurface(axes, self.first[0])
        return Geom_ConicalSurface(axes, self._half_angle, self.first[0])

    def parameters(self, points: Floats) -> Floats:
        """Surface parameters (u, v) of points (n, 3) on it; u runs on continuously from the seam, shape (n, 2)."""
        x, y, z = points.T
        if self.is_plane:
            c, s = np.cos(self.seam), np.sin(self.seam)
            return np.stack([c * x + s * y, c * y - s * x], axis=-1)
        azimuth = np.unwrap(np.arctan2(y, x))
        azimuth -= TURN * np.round((azimuth[0] - self.seam) / TURN)
        return np.stack([self.u_at(azimuth - self.seam), self.v_at(np.hypot(x, y), z)], axis=-1)

    def u_at(self, turn: ArrayLike) -> Floats:
        """u after a turn from the seam [rad]."""
        turn = np.asarray(turn, dtype=np.float64)
        return turn if self.direction > 0 else TURN - turn

    def v_at(self, radius: ArrayLike, height: ArrayLike) -> Floats:
        """v at (radius, height)."""
        radius, height = np.asarray(radius, dtype=np.float64), np.asarray(height, dtype=np.float64)
        if self.sphere:
            return np.asarray(np.arctan2(height, radius))
        sin_a, cos_a = np.sin(self._half_angle), np.cos(self._half_angle)
        return np.asarray((radius - self.first[0]) * sin_a + (height - self.first[1]) * self.direction * cos_a)

    def distance(self, points: Floats) -> Floats:
        """How far points (n, 3) lie off the surface [mm], shape (n,)."""
        radius, height = np.hypot(points[:, 0], points[:, 1]), points[:, 2]
        if self.sphere:
            return np.asarray(np.abs(np.hypot(radius, height) - np.hypot(*self.first)))
        along = np.subtract(self.last, self.first) / np.hypot(*np.subtract(self.last, self.first))
        return np.asarray(np.abs((radius - self.first[0]) * along[1] - (height - self.first[1]) * along[0]))

    def scale(self, points: Floats) -> Floats:
        """Length on the surface of a unit of u and of v at points (n, 3), shape (n, 2)."""
        radius = np.hypot(points[:, 0], points[:, 1])
        return np.stack([radius, np.full_like(radius, np.hypot(*self.first) if self.sphere else 1.0)], axis=-1)

    def circle_on(self, radius: float, height: float) -> Geom2d_Curve:
        """Curve on the surface of the circle `circle` at (radius, height)."""
        if self.is_plane:
            return Geom2d_Circle(gp_Ax22d(gp_Pnt2d(0.0, 0.0), gp_Dir2d(1.0, 0.0)), radius)
        start, v = float(self.u_at(0.0)), float(self.v_at(radius, height))
        return Geom2d_Line(gp_Pnt2d(start, v), gp_Dir2d(float(self.direction), 0.0))

    def meridian(self, start: tuple[float, float], end: tuple[float, float]) -> tuple[Geom_Curve, float, float]:
        """The seam between two of its points (radius, height): curve and parameter range."""
        c, s = float(np.cos(self.seam)), float(np.sin(self.seam))
        if self.sphere:
            axes = gp_Ax2(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(s, -c, 0.0), gp_Dir(c, s, 0.0))
            low, high = sorted(float(np.arctan2(z, r)) for r, z in (start, end))
            return Geom_Circle(axes, float(np.hypot(*start))), low, high
        lower, upper = (start, end) if self._v(start) < self._v(end) else (end, start)
        step = np.subtract(upper, lower)
        length = float(np.hypot(*step))
        way = gp_Dir(c * step[0], s * step[0], float(step[1]))
        return Geom_Line(gp_Pnt(c * lower[0], s * lower[0], lower[1]), way), 0.0, length

    def meridian_on(self, start: tuple[float, float], end: tuple[float, float], turned: bool) -> Geom2d_Curve:
        """Curve on the surface of `meridian`, at u = 0 or, turned, at u = 2 pi."""
        v = 0.0 if self.sphere else min(self._v(start), self._v(end))
        return Geom2d_Line(gp_Pnt2d(TURN if turned else 0.0, v), gp_Dir2d(0.0, 1.0))

    def _v(self, point: tuple[float, float]) -> float:
        return float(self.v_at(*point))

    @property
    def _half_angle(self) -> float:
        return float(np.arctan2(abs(self.last[0] - self.first[0]), abs(self.last[1] - self.first[1])))

    @property
    def _size(self) -> float:
        return float(max(*np.abs(self.first), *np.abs(self.last)))

    def _axes(self, height: float) -> gp_Ax3:
        c, s = float(np.cos(self.seam)), float(np.sin(self.seam))
        return gp_Ax3(gp_Pnt(0.0, 0.0, height), gp_Dir(0.0, 0.0, float(self.direction)), gp_Dir(c, s, 0.0))


def circle(radius: float, height: float, seam: float) -> Geom_Circle:
    """Circle about the axis, beginning at an azimuth."""
    c, s = float(np.cos(seam)), float(np.sin(seam))
    return Geom_Circle(gp_Ax2(gp_Pnt(0.0, 0.0, height), gp_Dir(0.0, 0.0, 1.0), gp_Dir(c, s, 0.0)), radius)
