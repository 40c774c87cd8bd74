"""What goes on below a flank that ends above its fillet: in every section a great circle that touches the flank.

Below a base cone it is the meridian; below a conjugate flank that is undercut next to its start of contact it is
the tangent of the lowest place where the flank is regular.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.theory.vectors import dot, from_spherical, of, quarter, spherical

Floats = NDArray[np.float64]
Angle = Callable[[Floats], Floats]
"""Polar angle [rad] at places along the face [mm]."""


class Straight(Protocol):
    """A great circle in every section, between fillet and flank. Azimuths count towards the space."""

    def points(self, x: Floats, rho_u: Floats) -> tuple[Floats, Floats]:
        """Polar angle and azimuth from the fillet (x = 0) to the flank (x = 1) [rad]."""
        ...

    def pole(self, rho_u: Floats) -> Floats:
        """Unit vector square to it, into the space, shape (..., 3); its azimuth is that of a section, without theta."""
        ...

    def top(self, rho_u: Floats) -> Floats:
        """Polar angle at which the flank begins [rad]."""
        ...


@dataclass(frozen=True)
class Meridian:
    """The meridian below a base cone of an angle, at the azimuth where the flank starts [rad]."""

    base_angle: float
    azimuth: float
    foot: Angle

    def points(self, x: Floats, rho_u: Floats) -> tuple[Floats, Floats]:
        """See `Straight`."""
        foot = self.foot(rho_u)
        delta = foot + x * (self.base_angle - foot)
        return delta, np.full_like(delta, self.azimuth)

    def pole(self, rho_u: Floats) -> Floats:
        """See `Straight`."""
        return from_spherical(1.0, np.full_like(rho_u, np.pi / 2), np.full_like(rho_u, self.azimuth + np.pi / 2))

    def top(self, rho_u: Floats) -> Floats:
        """See `Straight`."""
        return np.full_like(rho_u, self.base_angle)


@dataclass(frozen=True)
class Touched:
    """Where great circles touch flanks: polar angle, azimuth, and its slope d(phi) sin(delta) / d(delta) there."""

    angle: Floats
    azimuth: Floats
    lean: Floats

    @property
    def place(self) -> Floats:
        """Unit vectors to the places, shape (..., 3)."""
        return from_spherical(1.0, self.angle, self.azimuth)

    @property
    def upward(self) -> Floats:
        """Unit vectors along the great circles, up the tooth, shape (..., 3)."""
        down, across = self._axes
        return np.asarray((down + self.lean[..., None] * across) / np.hypot(1.0, self.lean)[..., None])

    @property
    def pole(self) -> Floats:
        """Unit vectors square to the great circles, into the space, shape (..., 3)."""
        down, across = self._axes
        return np.asarray((across - self.lean[..., None] * down) / np.hypot(1.0, self.lean)[..., None])

    @property
    def _axes(self) -> tuple[Floats, Floats]:
        cos_d, sin_d, cos_p, sin_p = (f(x) for x in (self.angle, self.azimuth) for f in (np.cos, np.sin))
        return of(cos_d * cos_p, cos_d * sin_p, -sin_d), of(-sin_p, cos_p, np.float64(0.0))

    def largest(self, root: Floats) -> Floats:
        """Radius of the circle that touches here and touches the root's circle: of those below, the largest [rad].

        From pole . centre = sin(radius) with the centre at root + radius and cos(radius) times the place.
        """
        return np.arctan((np.cos(root) - np.cos(self.angle)) / (self.pole[..., 2] + np.sin(root)))

    def circle(self, radius: ArrayLike, root: Floats) -> tuple[Floats, Floats]:
        """The circle of a radius that touches the great circle and the root's circle below.

        Returns
        -------
        azimuth, foot : ndarray
            Of its centre, whose polar angle is root + radius, and the polar angle at which it touches [rad].

        Notes
        -----
        The centre lies at the distance of the radius from the great circle: pole . centre = sin(radius).
        """
        pole, angle = self.pole, root + np.asarray(radius)
        flat = np.hypot(pole[..., 0], pole[..., 1])
        cosine = (np.sin(radius) - pole[..., 2] * np.cos(angle)) / (flat * np.sin(angle))
        azimuth = np.arctan2(pole[..., 1], pole[..., 0]) - np.arccos(np.clip(cosine, -1.0, 1.0))
        sine = np.broadcast_to(np.sin(radius), azimuth.shape)[..., None]
        foot = (from_spherical(1.0, angle, azimuth) - sine * pole) / np.sqrt(1 - sine**2)
        return azimuth, spherical(foot)[1]


@dataclass(frozen=True)
class Tangent:
    """The great circles that touch a conjugate flank where it begins, down to a fillet."""

    touched: Callable[[Floats], Touched]
    foot: Angle

    def points(self, x: Floats, rho_u: Floats) -> tuple[Floats, Floats]:
        """See `Straight`."""
        touched = self.touched(rho_u)
        place, up = touched.place, touched.upward
        # at the distance s below the place, cos(delta) = z cos(s) - z_up sin(s)
        cosine = np.cos(self.foot(rho_u)) / np.hypot(place[..., 2], up[..., 2])
        length = np.arctan2(-up[..., 2], place[..., 2]) - np.arccos(np.clip(cosine, -1.0, 1.0))
        s = (1 - x) * length
        point = np.cos(s)[..., None] * place - np.sin(s)[..., None] * up
        return spherical(point)[1:]

    def pole(self, rho_u: Floats) -> Floats:
        """See `Straight`."""
        return self.touched(rho_u).pole

    def top(self, rho_u: Floats) -> Floats:
        """See `Straight`."""
        return self.touched(rho_u).angle


def off_great_circle(pole: Floats, rho: Floats, delta: Floats, phi: Floats, turning: Floats) -> Floats:
    """Normal distance of points from a face of great circles that turn along it [mm], positive beyond the metal.

    Parameters
    ----------
    pole : ndarray, shape (..., 3)
        Of the sections' great circles, into the space.
    rho, delta, phi : ndarray, shape (...)
        Of the points; phi towards the space, without theta(rho).
    turning : ndarray, shape (...)
        rho theta'(rho).
    """
    place = from_spherical(1.0, delta, phi)
    along = turning * dot(pole, quarter(place))
    return np.asarray(rho * np.arcsin(dot(pole, place)) / np.hypot(1.0, along))
