"""A conjugate flank with micro-geometry: turned about the axis by as much as metal is taken off."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.theory.hypoid.conjugate import ConjugateFlank
from gearstudio.theory.hypoid.envelope import PinionPoint
from gearstudio.theory.hypoid.second import derivatives
from gearstudio.theory.relief import FlankRelief
from gearstudio.theory.vectors import cross, dot, matched, quarter, turned, turned_derivatives, unit

Floats = NDArray[np.float64]

_STEP = 2e-3
_PLACES = (-2, -1, 1, 2)


@dataclass(frozen=True)
class ModifiedConjugate(ConjugateFlank):
    """A conjugate flank from which metal is taken off; natural coordinates and limits stay those of the conjugate.

    A point X is turned by s = -e(rho, delta_k) / (z x X . n) about the axis, which moves it by e along its normal n.
    """

    relief: FlankRelief | None = None

    def at(self, psi: ArrayLike, rho: ArrayLike, /) -> Floats:
        """Points at natural coordinates, shape (..., 3)."""
        made = self.envelope.at(psi, rho)
        if self.relief is None:
            return made.point
        distance, delta, _ = self.locate(made.point)
        return turned(made.point, self.relief.value(distance, delta) * _turning(made))

    @property
    def plain(self) -> ConjugateFlank:
        """The flank without micro-geometry."""
        return ConjugateFlank(self.member, self.side, self.envelope, self.lower, self.alike)

    def turning(self, psi: ArrayLike, rho: ArrayLike) -> Floats:
        """Azimuth by which metal taken off turns the point at natural coordinates [rad/mm]."""
        return _turning(self.envelope.at(psi, rho))

    def normals_at(self, psi: ArrayLike, rho: ArrayLike, /) -> Floats:
        """Unit normals out of the metal at natural coordinates, shape (..., 3)."""
        psi, rho = matched(psi, rho)
        return self._surface(psi, rho)[1]

    def derivatives_at(self, psi: ArrayLike, rho: ArrayLike, /) -> tuple[Floats, Floats, Floats, Floats, Floats]:
        """First and second derivatives by the natural coordinates, shape (..., 3) each: those of R_z(s) X.

        All are in closed form but for the second derivatives of the turn per metal, differences of fourth order of
        the first; they count by as much as metal is taken off.
        """
        psi, rho = matched(psi, rho)
        made, by = self.envelope.at(psi, rho), derivatives(self.envelope, psi, rho)
        length = _STEP * self.member.mean_cone_distance
        twice = (
            *_differences([_turning_slopes(self.envelope.at(psi + k * _STEP, rho)) for k in _PLACES], _STEP),
            _differences([_turning_slopes(self.envelope.at(psi, rho + k * length)) for k in _PLACES], length)[1],
        )
        return turned_derivatives(made.point, by, self._shift(made, by, twice))

    def _surface(self, psi: Floats, rho: Floats) -> tuple[Floats, Floats]:
        made = self.envelope.at(psi, rho)
        first = (made.by_psi, made.by_rho)
        shift = self._shift(made, first)
        spun = quarter(made.point)
        by_psi, by_rho = (d + s[..., None] * spun for d, s in zip(first, shift[1:3], strict=True))
        normal = unit(cross(by_psi, by_rho))
        normal = np.where(dot(normal, made.normal)[..., None] < 0, -normal, normal)
        return turned(made.point, shift[0]), turned(normal, shift[0])

    def _shift(self, made: PinionPoint, by: tuple[Floats, ...], twice: tuple[Floats, ...] = ()) -> tuple[Floats, ...]:
        """s = e g, its first derivatives, and with second derivatives of X and of the turn per metal g its second."""
        if self.relief is None:
            return (np.zeros(made.area_ratio.shape),) * (6 if twice else 3)
        rho, delta, places = _polar(made.point, by)
        e, e_r, e_d, e_rr, e_rd, e_dd = self.relief.derivatives(rho, delta)
        g, (g_psi, g_rho) = _turning(made), _turning_slopes(made)
        (r_a, d_a), (r_b, d_b), *second = places
        e_a, e_b = e_r * r_a + e_d * d_a, e_r * r_b + e_d * d_b
        first = (e * g, e_a * g + e * g_psi, e_b * g + e * g_rho)
        if not twice:
            return first
        taken = [
            e_rr * r_i * r_j + e_rd * (r_i * d_j + r_j * d_i) + e_dd * d_i * d_j + e_r * r_ij + e_d * d_ij
            for (r_i, d_i, r_j, d_j), (r_ij, d_ij) in zip(
                ((r_a, d_a, r_a, d_a), (r_a, d_a, r_b, d_b), (r_b, d_b, r_b, d_b)), second, strict=True
            )
        ]
        return (
            *first,
            taken[0] * g + 2 * e_a * g_psi + e * twice[0],
            taken[1] * g + e_a * g_rho + e_b * g_psi + e * twice[1],
            taken[2] * g + 2 * e_b * g_rho + e * twice[2],
        )


def _turning(made: PinionPoint) -> Floats:
    """g = -1 / (z x X . n) [rad/mm]."""
    return np.asarray(-1 / dot(quarter(made.point), made.normal))


def _turning_slopes(made: PinionPoint) -> tuple[Floats, Floats]:
    """First derivatives of g by psi and rho."""
    square = dot(quarter(made.point), made.normal) ** 2
    by_psi, by_rho = (
        (dot(quarter(d), made.normal) + dot(quarter(made.point), n)) / square
        for d, n in ((made.by_psi, made.normal_by_psi), (made.by_rho, made.normal_by_rho))
    )
    return by_psi, by_rho


def _polar(point: Floats, by: tuple[Floats, ...]) -> tuple[Floats, Floats, list[tuple[Floats, Floats]]]:
    """Distance from the apex and polar angle of points, and their derivatives in the order of the points' own."""
    x, y, z = point[..., 0], point[..., 1], point[..., 2]
    radius = np.hypot(x, y)
    rho, delta = np.hypot(radius, z), np.arctan2(radius, z)
    flat = [(x * d[..., 0] + y * d[..., 1]) / radius for d in by[:2]]
    places = [(dot(point, d) / rho, (z * r - radius * d[..., 2]) / rho**2) for d, r in zip(by[:2], flat, strict=True)]
    for (i, j), d in zip(((0, 0), (0, 1), (1, 1)), by[2:], strict=False):
        a, b = by[i], by[j]
        out = (
            a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1] + x * d[..., 0] + y * d[..., 1] - flat[i] * flat[j]
        ) / radius
        far = (dot(a, b) + dot(point, d) - places[i][0] * places[j][0]) / rho
        lean = (b[..., 2] * flat[i] + z * out - flat[j] * a[..., 2] - radius * d[..., 2]) / rho**2
        places.append((far, lean - 2 * places[j][0] * places[i][1] / rho))
    return rho, delta, places


def _differences(values: list[tuple[Floats, Floats]], step: float) -> tuple[Floats, Floats]:
    """First derivatives of fourth order of two functions, from values at -2, -1, 1 and 2 steps."""
    first, second = (
        (8 * (after - near) - (beyond - far)) / (12 * step) for far, near, after, beyond in zip(*values, strict=True)
    )
    return first, second
