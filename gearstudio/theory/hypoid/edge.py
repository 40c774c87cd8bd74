"""Where contact starts on the pinion: the image of the wheel's face cone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import ArrayLike, NDArray

from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.hypoid.envelope import Envelope
from gearstudio.theory.involute import roll_arc
from gearstudio.theory.vectors import dot, spherical

Floats = NDArray[np.float64]

_NODES = 33
_BEYOND, _LEAST_BEYOND = 0.15, 0.01
_STEPS = 30
_ACCURACY = 1e-13
_NEAREST, _FARTHEST = 0.2, 3.0


@dataclass(frozen=True)
class StartOfContact:
    """Polar angle of a lower edge along the pinion's face, as a polynomial of the place v.

    Attributes
    ----------
    coefficients : ndarray, shape (n,)
        Of Chebyshev polynomials over -beyond <= v <= 1 + beyond; the curve itself is met to about 1e-13 rad.
    beyond : float
        Share of the face width by which the polynomial goes on at either end.
    """

    coefficients: Floats
    beyond: float

    def __call__(self, v: ArrayLike) -> Floats:
        """delta_1 [rad] at places v, as at the end of the range beyond it."""
        v = np.clip(np.asarray(v, dtype=np.float64), -self.beyond, 1 + self.beyond)
        return np.asarray(chebyshev.chebval((v - 0.5) / (0.5 + self.beyond), self.coefficients))


def start_of_contact(envelope: Envelope, pinion: MemberGeometry) -> StartOfContact:
    """Fit the image of the wheel's face cone.

    Raises
    ------
    GeometryError
        The image folds back or does not reach over the pinion's face.
    """
    try:
        return _fitted(envelope, pinion, _BEYOND)
    except GeometryError:
        return _fitted(envelope, pinion, _LEAST_BEYOND)


def _fitted(envelope: Envelope, pinion: MemberGeometry, beyond: float) -> StartOfContact:
    nodes = chebyshev.chebpts1(_NODES)
    v = 0.5 + (0.5 + beyond) * nodes
    rho = _on_face_cone(envelope, pinion, pinion.along_face(v))
    _, delta, _ = spherical(face_cone_image(envelope, rho)[0])
    return StartOfContact(np.asarray(chebyshev.chebfit(nodes, delta, _NODES - 1), dtype=np.float64), beyond)


def face_cone_image(envelope: Envelope, rho: Floats) -> tuple[Floats, Floats]:
    """Pinion points that the wheel's tip at cone distances rho [mm] generates, and their derivatives by rho."""
    wheel = envelope.wheel.member
    tip = wheel.tip_limit
    delta = tip.at_sphere(rho)
    psi = roll_arc(delta, wheel.base_angle)
    # cos(psi) = cos(delta) / cos(delta_b), sin(delta - angle) = offset / rho
    leaning = -tip.offset / (rho**2 * np.cos(delta - tip.angle))
    slope = np.sin(delta) * leaning / (np.cos(wheel.base_angle) * np.sin(psi))
    point, by_psi, by_rho = envelope.tangents(psi, rho)
    return point, by_rho + by_psi * slope[..., None]


def _on_face_cone(envelope: Envelope, pinion: MemberGeometry, wanted: Floats) -> Floats:
    """Cone distances on the wheel's tip whose images lie on the pinion's end surfaces wanted [mm]."""
    wheel = envelope.wheel.member
    middle = wheel.lengthwise.mean_cone_distance
    near, far = _NEAREST * middle, _FARTHEST * middle
    rho = np.clip(middle + (wanted - pinion.lengthwise.mean_cone_distance), near, far)
    longest = 0.2 * middle
    for _ in range(_STEPS):
        point, slope = face_cone_image(envelope, rho)
        radius, distance = np.hypot(point[..., 0], point[..., 1]), np.sqrt(dot(point, point))
        place = pinion.end_distance(distance, np.arctan2(radius, point[..., 2]))
        if pinion.ends == "sphere":
            steep = dot(point, slope) / distance
        else:
            outward = (point[..., 0] * slope[..., 0] + point[..., 1] * slope[..., 1]) / radius
            steep = np.cos(pinion.pitch_angle) * slope[..., 2] + np.sin(pinion.pitch_angle) * outward
        change = (wanted - place) / steep
        if np.all(np.abs(change) <= _ACCURACY * middle):
            return rho
        rho = np.clip(rho + np.clip(change, -longest, longest), near, far)
    raise GeometryError("the start of contact does not reach over the pinion's whole face; the pair is undercut there")
