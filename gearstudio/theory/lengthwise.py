"""Lengthwise curves: how a tooth turns about its axis from toe to heel (theory 4)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]

_STEEPEST_SINE = float(np.sin(np.radians(85.0)))


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
        return float(np.sqrt(self.cutter_radius**2 + self._excess))

    @property
    def reach(self) -> tuple[float, float]:
        """Cone distances between which the law holds [mm]: where the cutter arc leans less than 85 degrees."""
        if self.law != "circular_arc":
            return 0.0, np.inf
        steep = self.cutter_radius * _STEEPEST_SINE
        half = float(np.sqrt(max(steep**2 + self._excess, 0.0)))
        return (steep - half if self._excess < 0 else half - steep), half + steep

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

        Notes
        -----
        theory.md section 4; the derivatives follow from psi_t' = tan(beta)/rho with sin(beta) of that table.
        Outside `reach` the trace goes on with the slope it has there, so that points beside a tooth can be measured.
        """
        rho = np.asarray(rho, dtype=np.float64)
        r_m, tan_m = self.mean_cone_distance, np.tan(self.mean_spiral_angle)
        if self.law == "archimedean":
            slope = np.full_like(rho, tan_m / r_m)
            return slope * (rho - r_m), slope, np.zeros_like(rho)
        if self.law == "logarithmic":
            return tan_m * np.log(rho / r_m), tan_m / rho, -tan_m / rho**2
        within = np.clip(rho, *self.reach)
        sin_beta = self._arc_sine(within)
        cos_beta = np.sqrt((1 - sin_beta) * (1 + sin_beta))
        slope = sin_beta / (cos_beta * within)
        sine_slope = 1 / self.cutter_radius - sin_beta / within
        second = np.where(rho == within, sine_slope / (cos_beta**3 * within) - slope / within, 0.0)
        return self._arc_polar(np.asarray(r_m)) - self._arc_polar(within) + slope * (rho - within), slope, second

    def divided(self, low: float, high: float, share: ArrayLike) -> Floats:
        """Cone distances at shares in [0, 1] of the way from low to high, the way measured so that the trace is smooth.

        Along the cutter arc equal shares are equal arcs: its trace is analytic in the arc and has, in the cone
        distance, a square root at the arc's nearest and farthest points. The other laws are divided evenly.
        """
        share = np.asarray(share, dtype=np.float64)
        if self.law != "circular_arc":
            return low + share * (high - low)
        first, last = self._arc_angle(np.array([low, high]))
        chord = np.sin((first + share * (last - first)) / 2)
        rho = np.sqrt(self._nearest**2 + 4 * self.cutter_distance * self.cutter_radius * chord**2)
        return np.asarray(np.where(share == 0, low, np.where(share == 1, high, rho)))

    def share(self, low: float, high: float, rho: ArrayLike) -> Floats:
        """The share of the way from low to high at which a cone distance lies; the inverse of `divided`."""
        rho = np.asarray(rho, dtype=np.float64)
        if self.law != "circular_arc":
            return np.asarray((rho - low) / (high - low))
        first, last = self._arc_angle(np.array([low, high]))
        return np.asarray((self._arc_angle(rho) - first) / (last - first))

    def azimuth(self, rho: ArrayLike) -> Floats:
        """theta(rho) = hand psi_t / sin(delta) [rad]."""
        rho = np.asarray(rho, dtype=np.float64)
        if self.law == "circular_arc" and rho.size:
            near, far = self.reach
            if near <= rho.min() and rho.max() <= far:
                return self._turn * (self._arc_polar(np.asarray(self.mean_cone_distance)) - self._arc_polar(rho))
        return self._turn * self.trace(rho)[0]

    def azimuth_derivatives(self, rho: ArrayLike) -> tuple[Floats, Floats, Floats]:
        """theta, theta', theta'' in [rad], [rad/mm], [rad/mm^2]."""
        psi, first, second = self.trace(rho)
        return self._turn * psi, self._turn * first, self._turn * second

    def azimuth_third(self, rho: ArrayLike) -> Floats:
        """theta'''(rho) [rad/mm^3]: by the chain rule from tan(beta)/rho with sin(beta) of the law."""
        rho = np.asarray(rho, dtype=np.float64)
        if self.law == "archimedean":
            return np.zeros_like(rho)
        if self.law == "logarithmic":
            return np.asarray(self._turn * 2 * np.tan(self.mean_spiral_angle) / rho**3)
        within = np.clip(rho, *self.reach)
        sine = self._arc_sine(within)
        cosine = np.sqrt((1 - sine) * (1 + sine))
        sine_1 = 1 / self.cutter_radius - sine / within
        sine_2 = (sine / within - sine_1) / within
        tangent = sine / cosine
        tangent_1 = sine_1 / cosine**3
        tangent_2 = sine_2 / cosine**3 + 3 * sine_1**2 * sine / cosine**5
        third = tangent_2 / within - 2 * tangent_1 / within**2 + 2 * tangent / within**3
        return np.asarray(self._turn * np.where(rho == within, third, 0.0))

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

    @property
    def _excess(self) -> float:
        """S^2 - r_0^2 [mm^2], without the cancellation of large cutters."""
        r_m, r_0 = self.mean_cone_distance, self.cutter_radius
        return float(r_m * (r_m - 2 * r_0 * np.sin(self.mean_spiral_angle)))

    @property
    def _nearest(self) -> float:
        """S - r_0: signed distance of the apex from the cutter circle [mm]."""
        return self._excess / (self.cutter_distance + self.cutter_radius)

    def _arc_angle(self, rho: Floats) -> Floats:
        """Angle at the cutter's centre from the line to the apex, 0 at the circle's nearest point [rad]."""
        square = (rho**2 - self._nearest**2) / (4 * self.cutter_distance * self.cutter_radius)
        return np.asarray(2 * np.arcsin(np.sqrt(np.clip(square, 0.0, 1.0))))

    def _arc_sine(self, rho: Floats) -> Floats:
        return np.asarray((rho**2 - self._excess) / (2 * self.cutter_radius * rho))

    def _arc_polar(self, rho: Floats) -> Floats:
        s, r_0, near = self.cutter_distance, self.cutter_radius, self._nearest
        opposite = np.sqrt(np.maximum((rho - near) * (rho + near) * (r_0 + s - rho) * (r_0 + s + rho), 0.0))
        return np.asarray(np.arctan2(opposite, rho**2 + self._excess))
