"""A conjugate flank with micro-geometry: turned about the axis by as much as metal is taken off."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.theory.hypoid.conjugate import ConjugateFlank
from gearstudio.theory.relief import FlankRelief
from gearstudio.theory.vectors import cross, dot, quarter, turned, unit

Floats = NDArray[np.float64]

_STEP = 2e-3
_PLACES = (-2, -1, 1, 2)


@dataclass(frozen=True)
class ModifiedConjugate(ConjugateFlank):
    """A conjugate flank from which metal is taken off; natural coordinates and limits stay those of the conjugate.

    A point X is turned by s = -side e(rho, delta_k) / lever about the axis, which moves it by e along its normal.
    """

    relief: FlankRelief | None = None

    def at(self, psi: ArrayLike, rho: ArrayLike, /) -> Floats:
        """Points at natural coordinates, shape (..., 3)."""
        made = self.envelope.at(psi, rho)
        if self.relief is None:
            return made.point
        distance, delta, _ = self.locate(made.point)
        taken = self.relief.value(distance, delta) / dot(quarter(made.point), made.normal)
        return turned(made.point, -taken)

    @property
    def plain(self) -> ConjugateFlank:
        """The flank without micro-geometry."""
        return ConjugateFlank(self.member, self.side, self.envelope, self.raised, self.lower, self.alike)

    def turning(self, psi: ArrayLike, rho: ArrayLike) -> Floats:
        """Azimuth by which metal taken off turns the point at natural coordinates [rad/mm]."""
        made = self.envelope.at(psi, rho)
        return np.asarray(-1 / dot(quarter(made.point), made.normal))

    def normals_at(self, psi: ArrayLike, rho: ArrayLike, /) -> Floats:
        """Unit normals out of the metal at natural coordinates, shape (..., 3)."""
        psi, rho = np.broadcast_arrays(np.asarray(psi, dtype=np.float64), np.asarray(rho, dtype=np.float64))
        return self._surface(psi, rho)[1]

    def derivatives_at(self, psi: ArrayLike, rho: ArrayLike, /) -> tuple[Floats, Floats, Floats, Floats, Floats]:
        """First and second derivatives by the natural coordinates, shape (..., 3) each: differences of fourth order."""
        psi, rho = np.broadcast_arrays(np.asarray(psi, dtype=np.float64), np.asarray(rho, dtype=np.float64))
        far, long = 4 * _STEP, 4 * self._length
        a, b = self._first(psi, rho)
        return (
            a,
            b,
            _second(lambda k: self.at(psi + k * far, rho), far),
            _first(lambda k: self._first(psi, rho + k * long)[0], long),
            _second(lambda k: self.at(psi, rho + k * long), long),
        )

    def curvatures_at(self, psi: ArrayLike, rho: ArrayLike, /) -> tuple[Floats, Floats]:
        """Principal curvatures, the larger first, positive where convex [1/mm], (...) each."""
        a, b, aa, ab, bb = self.derivatives_at(psi, rho)
        normal = self.normals_at(psi, rho)
        E, F, G = dot(a, a), dot(a, b), dot(b, b)
        L, M, N = -dot(aa, normal), -dot(ab, normal), -dot(bb, normal)
        square = E * G - F * F
        mean, gaussian = (E * N - 2 * F * M + G * L) / (2 * square), (L * N - M * M) / square
        spread = np.sqrt(np.maximum(mean**2 - gaussian, 0.0))
        return mean + spread, mean - spread

    @property
    def _length(self) -> float:
        return _STEP * self.member.mean_cone_distance

    def _first(self, psi: Floats, rho: Floats) -> tuple[Floats, Floats]:
        by_psi = _first(lambda k: self.at(psi + k * _STEP, rho), _STEP)
        return by_psi, _first(lambda k: self.at(psi, rho + k * self._length), self._length)

    def _surface(self, psi: Floats, rho: Floats) -> tuple[Floats, Floats]:
        normal = unit(cross(*self._first(psi, rho)))
        outward = self.envelope.at(psi, rho).normal
        return self.at(psi, rho), np.where(dot(normal, outward)[..., None] < 0, -normal, normal)


def _first(at: Callable[[int], Floats], step: float) -> Floats:
    """First derivative of fourth order."""
    far, near, after, beyond = (at(k) for k in _PLACES)
    return np.asarray((8 * (after - near) - (beyond - far)) / (12 * step))


def _second(at: Callable[[int], Floats], step: float) -> Floats:
    """Second derivative of fourth order."""
    far, near, after, beyond = (at(k) for k in _PLACES)
    return np.asarray((16 * (after + near) - (beyond + far) - 30 * at(0)) / (12 * step**2))
