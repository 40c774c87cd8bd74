"""Lengthwise curves: how a tooth turns about its axis from toe to heel (theory 4)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.errors import GeometryError

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Lengthwise:
    """The azimuth by which the section at a cone distance is turned.

    Attributes
    ----------
    law : {"archimedean", "circular_arc", "logarithmic"}
    mean_cone_distance : float
        R_m [mm]; the azimuth is zero there.
    mean_spiral_angle : float
        beta_m [rad] on the pitch cone at R_m.
    pitch_angle : float
        delta [rad].
    hand : int
        +1 right, -1 left.
    cutter_radius : float
        r_0 [mm]; used by the circular arc only.
    """

    law: str
    mean_cone_distance: float
    mean_spiral_angle: float
    pitch_angle: float
    hand: int
    cutter_radius: float = 0.0

    @property
    def cutter_distance(self) -> float:
        """S, from the apex to the centre of the cutter arc in the developed pitch plane [mm]."""
        r_m, r_0 = self.mean_cone_distance, self.cutter_radius
        return float(np.sqrt(r_m**2 + r_0**2 - 2 * r_m * r_0 * np.sin(self.mean_spiral_angle)))

    def trace(self, rho: ArrayLike) -> tuple[Floats, Floats, Floats]:
        """Polar angle of the tooth trace in the developed pitch plane, with two derivatives.

        Parameters
        ----------
        rho : array_like, shape (...)
            Cone distance [mm].

        Returns
        -------
        psi_t, psi_t', psi_t'' : ndarray, shape (...)
            [rad], [rad/mm], [rad/mm^2], for a right hand.

        Raises
        ------
        GeometryError
            The cutter arc does not reach this cone distance.

        Notes
        -----
        theory.md section 4; the derivatives follow from psi_t' = tan(beta)/rho with sin(beta) of that table.
        """
        rho = np.asarray(rho, dtype=np.float64)
        r_m, tan_m = self.mean_cone_distance, np.tan(self.mean_spiral_angle)
        if self.law == "archimedean":
            slope = np.full_like(rho, tan_m / r_m)
            return slope * (rho - r_m), slope, np.zeros_like(rho)
        if self.law == "logarithmic":
            return tan_m * np.log(rho / r_m), tan_m / rho, -tan_m / rho**2
        sin_beta = self._arc_sine(rho)
        cos_beta = np.sqrt((1 - sin_beta) * (1 + sin_beta))
        tan_beta = sin_beta / cos_beta
        sine_slope = 1 / self.cutter_radius - sin_beta / rho
        second = sine_slope / (cos_beta**3 * rho) - tan_beta / rho**2
        return self._arc_polar(np.asarray(r_m)) - self._arc_polar(rho), tan_beta / rho, second

    def azimuth(self, rho: ArrayLike) -> Floats:
        """theta(rho) = hand psi_t / sin(delta) [rad]."""
        return self._turn * self.trace(rho)[0]

    def azimuth_derivatives(self, rho: ArrayLike) -> tuple[Floats, Floats, Floats]:
        """theta, theta', theta'' in [rad], [rad/mm], [rad/mm^2]."""
        psi, first, second = self.trace(rho)
        return self._turn * psi, self._turn * first, self._turn * second

    def azimuth_slope(self, rho: ArrayLike) -> Floats:
        """theta'(rho) [rad/mm]."""
        return self._turn * self.trace(rho)[1]

    def spiral_angle(self, rho: ArrayLike) -> Floats:
        """beta(rho) on the pitch cone [rad], unsigned by hand: tan(beta) = rho psi_t'."""
        rho = np.asarray(rho, dtype=np.float64)
        return np.asarray(np.arctan(rho * self.trace(rho)[1]))

    @property
    def _turn(self) -> float:
        return self.hand / float(np.sin(self.pitch_angle))

    def _arc_sine(self, rho: Floats) -> Floats:
        r_m, r_0 = self.mean_cone_distance, self.cutter_radius
        sine = (rho**2 + 2 * r_0 * r_m * np.sin(self.mean_spiral_angle) - r_m**2) / (2 * r_0 * rho)
        if not np.all(np.abs(sine) < 1):
            raise GeometryError(f"a cutter of radius {r_0:.6g} mm does not cross the whole face width")
        return np.asarray(sine)

    def _arc_polar(self, rho: Floats) -> Floats:
        s, r_0 = self.cutter_distance, self.cutter_radius
        opposite = np.sqrt(np.maximum((r_0**2 - (rho - s) ** 2) * ((rho + s) ** 2 - r_0**2), 0.0))
        return np.asarray(np.arctan2(opposite, rho**2 + s**2 - r_0**2))
