"""Micro-geometry: the metal taken off a flank, as an explicit function of the place on it.

With xi in [-1, 1] from toe to heel and eta in [-1, 1] from the flank's lower edge to its tip (both even in
distance and in polar angle), the metal removed, normal to the flank, is

    e = c_l xi^2 + c_p eta^2 - (s xi + p eta + b xi eta)/2 + c_t t^3 + c_r r^3

with c_l, c_p the crownings (height of the middle above both ends), s, p, b the spiral-angle, pressure-angle and
bias corrections (metal added over the whole flank: at the heel, at the tip, at root-toe and tip-heel), and the
tip relief c_t with t = (eta - eta_t)/(1 - eta_t) above its start, the root relief c_r with
r = (eta_r - eta)/(1 + eta_r) below its end. The cubes join with continuous slope and curvature.

The flank stays explicit in azimuth: phi' = phi - side e / lever(rho) (theory 5). eta is even in the polar angle,
not in the roll angle, so that a flank which starts on the base cone keeps its tangent there.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.design import FlankModification
from gearstudio.theory.vectors import matched

Floats = NDArray[np.float64]
Derivatives = tuple[Floats, Floats, Floats, Floats, Floats, Floats]
"""A function of two places with its derivatives: f, f_x, f_y, f_xx, f_xy, f_yy."""

_FARTHEST = 2.0
_NEAREST = 1.5


@dataclass(frozen=True)
class Edge:
    """A cone that bounds the flank: polar angle = angle + arcsin(offset / rho) [rad, mm]."""

    angle: float
    offset: float

    def at(self, rho: Floats) -> tuple[Floats, Floats, Floats]:
        """Polar angle at cone distances, with two derivatives by them, (...) each."""
        if self.offset == 0.0:
            zero = np.zeros_like(rho)
            return zero + self.angle, zero, zero
        rho = np.maximum(rho, _NEAREST * abs(self.offset))
        sine = self.offset / rho
        cosine = np.sqrt((1 - sine) * (1 + sine))
        first = -sine / (rho * cosine)
        return self.angle + np.arcsin(sine), first, -first * (1 + 1 / cosine**2) / rho


@dataclass(frozen=True)
class ReliefFrame:
    """What xi and eta are measured from.

    Attributes
    ----------
    mean_distance, half_face : float
        R_m and B/2 [mm].
    pitch_angle : float
        delta [rad], to which the back cones stand square.
    back_cone : bool
        Whether the tooth ends on back cones (xi is even in rho cos(delta_k - delta)) or on spheres (in rho).
    low, tip : Edge
        Lower edge of the flank, root or base cone, and face cone.
    """

    mean_distance: float
    half_face: float
    pitch_angle: float
    back_cone: bool
    low: Edge
    tip: Edge

    def lengthwise(self, rho: Floats, delta: Floats) -> Derivatives:
        """xi at cone distances [mm] and polar angles [rad], with its derivatives by them."""
        zero = np.zeros(np.broadcast_shapes(rho.shape, delta.shape))
        if not self.back_cone:
            along = zero + (rho - self.mean_distance) / self.half_face
            return along, zero + 1 / self.half_face, zero, zero, zero, zero
        cos, sin = np.cos(delta - self.pitch_angle), np.sin(delta - self.pitch_angle)
        b = self.half_face
        along = (rho * cos - self.mean_distance) / b
        return along, zero + cos / b, -rho * sin / b, zero, zero - sin / b, -rho * cos / b

    def profile(self, rho: Floats, delta: Floats) -> Derivatives:
        """eta at cone distances [mm] and polar angles [rad], with its derivatives by them."""
        zero = np.zeros(np.broadcast_shapes(rho.shape, delta.shape))
        low, low_1, low_2 = self.low.at(rho)
        tip, tip_1, tip_2 = self.tip.at(rho)
        depth, depth_1, depth_2 = tip - low, tip_1 - low_1, tip_2 - low_2
        share = (delta - low) / depth
        # share * depth = delta - low, differentiated
        first = (-low_1 - share * depth_1) / depth
        second = (-low_2 - 2 * first * depth_1 - share * depth_2) / depth
        return 2 * share - 1, 2 * first, zero + 2 / depth, 2 * second, zero - 2 * depth_1 / depth**2, zero


@dataclass(frozen=True)
class FlankRelief:
    """The micro-geometry of one flank; lengths in mm, places as eta.

    Attributes
    ----------
    frame : ReliefFrame
    lengthwise_crown, profile_crown, spiral, pressure, bias : float
    tip, tip_start, root, root_end : float
    """

    frame: ReliefFrame
    lengthwise_crown: float = 0.0
    profile_crown: float = 0.0
    spiral: float = 0.0
    pressure: float = 0.0
    bias: float = 0.0
    tip: float = 0.0
    tip_start: float = 0.4
    root: float = 0.0
    root_end: float = -0.4

    def value(self, rho: ArrayLike, delta: ArrayLike) -> Floats:
        """e [mm] at cone distances rho [mm] and polar angles delta_k [rad], broadcast together."""
        rho, delta = np.asarray(rho, dtype=np.float64), np.asarray(delta, dtype=np.float64)
        frame = self.frame
        ends = rho * np.cos(delta - frame.pitch_angle) if frame.back_cone else rho
        low, tip = frame.low.at(rho)[0], frame.tip.at(rho)[0]
        return self.over((ends - frame.mean_distance) / frame.half_face, 2 * (delta - low) / (tip - low) - 1)

    def over(self, xi: ArrayLike, eta: ArrayLike) -> Floats:
        """e [mm] at places xi and eta; constant beyond twice the flank."""
        x, y = (np.clip(np.asarray(place, dtype=np.float64), -_FARTHEST, _FARTHEST) for place in (xi, eta))
        above = np.maximum(y - self.tip_start, 0.0) / (1 - self.tip_start)
        below = np.maximum(self.root_end - y, 0.0) / (1 + self.root_end)
        return np.asarray(
            self.lengthwise_crown * x**2
            + self.profile_crown * y**2
            - (self.spiral * x + self.pressure * y + self.bias * x * y) / 2
            + self.tip * above**3
            + self.root * below**3
        )

    def derivatives(self, rho: ArrayLike, delta: ArrayLike) -> Derivatives:
        """e, e_rho, e_delta, e_rho_rho, e_rho_delta, e_delta_delta, broadcast together."""
        rho, delta = matched(rho, delta)
        x, x_r, x_d, x_rr, x_rd, x_dd = self.frame.lengthwise(rho, delta)
        y, y_r, y_d, y_rr, y_rd, y_dd = self.frame.profile(rho, delta)
        f_x, f_y, f_xx, f_xy, f_yy = self._by_place(x, y)
        return (
            self.over(x, y),
            f_x * x_r + f_y * y_r,
            f_x * x_d + f_y * y_d,
            f_xx * x_r**2 + 2 * f_xy * x_r * y_r + f_yy * y_r**2 + f_x * x_rr + f_y * y_rr,
            f_xx * x_r * x_d + f_xy * (x_r * y_d + x_d * y_r) + f_yy * y_r * y_d + f_x * x_rd + f_y * y_rd,
            f_xx * x_d**2 + 2 * f_xy * x_d * y_d + f_yy * y_d**2 + f_x * x_dd + f_y * y_dd,
        )

    def _by_place(self, xi: Floats, eta: Floats) -> tuple[Floats, ...]:
        """Derivatives of `over`: e_xi, e_eta, e_xi_xi, e_xi_eta, e_eta_eta."""
        on_x, on_y = np.abs(xi) < _FARTHEST, np.abs(eta) < _FARTHEST
        x, y = np.clip(xi, -_FARTHEST, _FARTHEST), np.clip(eta, -_FARTHEST, _FARTHEST)
        upper, lower = 1 - self.tip_start, 1 + self.root_end
        above, below = np.maximum(y - self.tip_start, 0.0) / upper, np.maximum(self.root_end - y, 0.0) / lower
        by_y = 2 * self.profile_crown * y - (self.pressure + self.bias * x) / 2
        by_y += 3 * (self.tip / upper * above**2 - self.root / lower * below**2)
        twice_y = 2 * self.profile_crown + 6 * (self.tip / upper**2 * above + self.root / lower**2 * below)
        return (
            on_x * (2 * self.lengthwise_crown * x - (self.spiral + self.bias * y) / 2),
            on_y * by_y,
            np.asarray(on_x * (2 * self.lengthwise_crown), dtype=np.float64),
            np.asarray(on_x * on_y * (-self.bias / 2), dtype=np.float64),
            np.asarray(on_y * twice_y),
        )


def flank_relief(given: FlankModification, frame: ReliefFrame) -> FlankRelief | None:
    """The micro-geometry that a design gives a flank; None where it takes nothing off."""
    if given.is_none:
        return None
    return FlankRelief(
        frame,
        lengthwise_crown=given.lengthwise_crowning_um * 1e-3,
        profile_crown=given.profile_crowning_um * 1e-3,
        spiral=given.spiral_angle_correction_um * 1e-3,
        pressure=given.pressure_angle_correction_um * 1e-3,
        bias=given.bias_um * 1e-3,
        tip=given.tip_relief_um * 1e-3,
        tip_start=2 * given.tip_relief_start - 1,
        root=given.root_relief_um * 1e-3,
        root_end=2 * given.root_relief_end - 1,
    )
