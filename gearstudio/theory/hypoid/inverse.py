"""Which point of the wheel generates the point of the pinion's flank at a given place of the pinion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from gearstudio.errors import GeometryError
from gearstudio.theory.hypoid.envelope import Envelope
from gearstudio.theory.involute import roll_arc
from gearstudio.theory.vectors import dot

Floats = NDArray[np.float64]

_STEPS, _STEPS_FROM_GUESS = 40, 16
_ACCURACY = 1e-12
_NEARLY = 2e-8
_GUESSES = 9
_BEYOND = 0.3
_LONGEST_PSI = 0.15
_LONGEST_SHARE = 0.15
_NEAREST, _FARTHEST = 0.2, 3.0


@dataclass(frozen=True)
class Guess:
    """Natural coordinates of a flank as polynomials of its shares along and across, good for starting from.

    Attributes
    ----------
    coefficients : ndarray, shape (n, n, 2)
        Of Chebyshev polynomials of v and u, for psi and rho.
    """

    coefficients: Floats

    @staticmethod
    def places() -> tuple[Floats, Floats]:
        """v and u at which a guess is made, shape (n, n) each."""
        nodes = (1 + chebyshev.chebpts1(_GUESSES)) / 2
        v, u = np.meshgrid(nodes, nodes, indexing="ij")
        return v, u

    @staticmethod
    def through(psi: Floats, rho: Floats) -> Guess:
        """The guess that is right at `places`, given there as flat arrays."""
        values = np.stack([psi, rho], axis=-1).reshape(_GUESSES, -1)
        to = np.linalg.inv(chebyshev.chebvander(chebyshev.chebpts1(_GUESSES), _GUESSES - 1))
        half = (to @ values).reshape(_GUESSES, _GUESSES, 2)
        return Guess(np.einsum("ju,vuk->vjk", to, half))

    def at(self, v: Floats, u: Floats) -> tuple[Floats, Floats]:
        """psi [rad] and rho [mm] at shares, shape (...) each; no farther beyond the flank than polynomials go."""
        along, across = (
            chebyshev.chebvander(2 * np.clip(x.ravel(), -_BEYOND, 1 + _BEYOND) - 1, _GUESSES - 1) for x in (v, u)
        )
        lines = (along @ self.coefficients.reshape(_GUESSES, -1)).reshape(-1, _GUESSES, 2)
        psi, rho = ((across * lines[..., k]).sum(axis=-1) for k in (0, 1))
        return psi.reshape(v.shape), rho.reshape(v.shape)


def generating_point(
    envelope: Envelope,
    rho: Floats,
    delta: Floats,
    mean_distance: float,
    pitch_angle: float,
    guess: tuple[Floats, Floats] | None = None,
) -> tuple[Floats, Floats]:
    """Natural coordinates psi [rad], rho_2 [mm] on the wheel of pinion points.

    Parameters
    ----------
    envelope : Envelope
    rho, delta : ndarray, shape (...)
        Distance from the pinion's pitch apex [mm] and polar angle [rad].
    mean_distance, pitch_angle : float
        R_m1 and delta_1 of the pinion: the start mirrors the place about the mean point.
    guess : tuple of ndarray, optional
        A better start.

    Raises
    ------
    GeometryError
        The flank has no point there.

    Notes
    -----
    Newton's method on both coordinates at once with limited steps; accurate to 1e-12 of the cone distance.
    """
    rho, delta = np.broadcast_arrays(rho, delta)
    member = envelope.wheel.member
    middle = member.lengthwise.mean_cone_distance
    near, far = _NEAREST * middle, _FARTHEST * middle
    if guess is not None:
        psi, along = guess[0], np.clip(guess[1], near, far)
    else:
        start = np.clip(member.pitch_angle + pitch_angle - delta, member.base_angle, np.pi - member.base_angle)
        psi = roll_arc(start, member.base_angle)
        along = np.clip(middle + rho - mean_distance, near, far)
    longest = _LONGEST_SHARE * middle
    finish = False
    for _ in range(_STEPS if guess is None else _STEPS_FROM_GUESS):
        point, by_psi, by_rho = envelope.tangents(psi, along)
        distance = np.sqrt(dot(point, point))
        radius = np.hypot(point[..., 0], point[..., 1])
        out = point / distance[..., None]
        flat = point[..., 2] / (radius * distance)
        down = np.stack([point[..., 0] * flat, point[..., 1] * flat, -radius / distance], axis=-1)
        e, f = rho - distance, distance * (delta - np.arctan2(radius, point[..., 2]))
        a, b, c, d = dot(out, by_psi), dot(out, by_rho), dot(down, by_psi), dot(down, by_rho)
        determinant = a * d - b * c
        psi = psi + np.clip((d * e - b * f) / determinant, -_LONGEST_PSI, _LONGEST_PSI)
        along = np.clip(along + np.clip((a * f - c * e) / determinant, -longest, longest), near, far)
        error = np.maximum(np.abs(e), np.abs(f))
        if finish or np.all(error <= _NEARLY * rho):
            return psi, along
        finish = bool(np.all(error <= _ACCURACY**0.5 * rho))
    if np.all(error <= _ACCURACY * rho):
        return psi, along
    raise GeometryError("the conjugate flank has no point where one was asked for; it is undercut or too short there")
