"""What the geometry data sheet holds: every quantity with its names, its formula and where its value comes from.

Symbols and names are those of ISO 23509; equations are the numbers of the theory's sections and of the paper.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from gearstudio.design import Design
from gearstudio.theory.cones import MemberGeometry, PairGeometry
from gearstudio.theory.limit import ConeLimit
from gearstudio.theory.pair import overlap_ratio, transverse_contact_ratio

Unit = Literal["mm", "°", ""]


@dataclass(frozen=True)
class Subject:
    """A member whose quantities are asked for, in its pair."""

    design: Design
    pair: PairGeometry
    member: MemberGeometry

    @property
    def opposite(self) -> Subject:
        """The same of the other member."""
        return Subject(self.design, self.pair, self.mate)

    @property
    def mate(self) -> MemberGeometry:
        """The other member."""
        return self.pair.wheel if self.member is self.pair.pinion else self.pair.pinion

    def spiral_angle(self, rho: float) -> float:
        """Spiral angle on the pitch cone at a cone distance [rad]."""
        return float(self.member.lengthwise.spiral_angle(rho))


@dataclass(frozen=True)
class Row:
    """One quantity of the sheet.

    Attributes
    ----------
    key : str
        Unique; other rows name it as their input.
    group, name, symbol, unit : str
    formula, equation : str
        As a person reads it, and where it stands.
    inputs : tuple of str
        Keys of the numbers put in; ``"mate:KEY"`` for one of the other member.
    value : callable
        From the subject, in mm or radians.
    of_pair : bool
        Shared by both members.
    """

    key: str
    group: str
    name: str
    symbol: str
    unit: Unit
    formula: str
    equation: str
    inputs: tuple[str, ...]
    value: Callable[[Subject], float]
    of_pair: bool = False


def height(limit: ConeLimit, rho_u: float) -> float:
    """Height of a cone above the pitch cone, square to it, at a cone distance [mm]."""
    lean = limit.angle - limit.pitch_angle
    return float(limit.offset / np.cos(lean) + rho_u * np.tan(lean))


def cone_distance(place: str, member: MemberGeometry) -> float:
    """R_e, R_m or R_i [mm]."""
    return {
        "e": member.outer_cone_distance,
        "m": member.mean_cone_distance,
        "i": member.inner_cone_distance,
    }[place]


def pair_rows() -> tuple[Row, ...]:
    """What both members share."""

    def row(key: str, name: str, symbol: str, unit: Unit, formula: str, equation: str, inputs: str,
            value: Callable[[Subject], float]) -> Row:  # fmt: skip
        return Row(key, "Pair", name, symbol, unit, formula, equation, tuple(inputs.split()), value, True)

    return (
        row("sigma", "Shaft angle", "Σ", "°", "given", "1", "", lambda s: s.pair.shaft_angle),
        row("u", "Gear ratio", "u", "", "u = z₂/z₁", "1", "z",
            lambda s: s.pair.wheel.teeth / s.pair.pinion.teeth),
        row("m", "Outer transverse module", "m_et", "mm", "given", "1", "", lambda s: s.member.module),
        row("m_mn", "Mean normal module", "m_mn", "mm", "m_mn = m_et (R_m/R_e) cos β_m", "6", "m R_m R_e beta_m",
            lambda s: s.pair.mean_normal_module),
        row("alpha_n", "Normal pressure angle, mean point", "α_n", "°", "tan α_n = tan α cos β_m", "2",
            "alpha beta_m", lambda s: s.pair.normal_pressure_angle),
        row("alpha", "Transverse pressure angle", "α", "°", "tan α = tan α_n / cos β_m", "2", "alpha_n beta_m",
            lambda s: s.member.transverse_pressure_angle),
        row("ha", "Addendum factor", "h_a*", "", "given", "1", "", lambda s: s.design.tooth.addendum_factor),
        row("c", "Clearance factor", "c*", "", "given", "1", "", lambda s: s.design.tooth.clearance_factor),
        row("j_t", "Transverse backlash, outer", "j_t", "mm", "given", "1", "", lambda s: s.design.tooth.backlash),
        row("R_e", "Outer cone distance", "R_e", "mm", "R_e = m_et z / (2 sin δ)", "2 [7]", "m z delta",
            lambda s: s.member.outer_cone_distance),
        row("b", "Face width", "b", "mm", "given, or as a part of R_e", "1", "", lambda s: s.member.face_width),
        row("R_m", "Mean cone distance", "R_m", "mm", "R_m = R_e − b/2", "1", "R_e b",
            lambda s: s.member.mean_cone_distance),
        row("R_i", "Inner cone distance", "R_i", "mm", "R_i = R_e − b", "1", "R_e b",
            lambda s: s.member.inner_cone_distance),
        row("beta_e", "Spiral angle, heel", "β_e", "°", "tan β(ρ) = ρ ψ_t′(ρ) at R_e", "4", "R_e R_m beta_m",
            lambda s: s.spiral_angle(s.member.outer_cone_distance)),
        row("beta_m", "Spiral angle, mean", "β_m", "°", "tan β(ρ) = ρ ψ_t′(ρ) at R_m", "4", "R_m",
            lambda s: s.pair.mean_spiral_angle),
        row("beta_i", "Spiral angle, toe", "β_i", "°", "tan β(ρ) = ρ ψ_t′(ρ) at R_i", "4", "R_i R_m beta_m",
            lambda s: s.spiral_angle(s.member.inner_cone_distance)),
        row("eps_alpha", "Transverse contact ratio", "ε_α", "",
            "ε_α = Σ[arccos(cos δ_a/cos δ_b) − γ] z₁ / (2π sin δ_b1)", "8", "delta_a delta_b gamma z",
            lambda s: transverse_contact_ratio(s.pair)),
        row("eps_beta", "Overlap ratio", "ε_β", "", "ε_β = |θ(R_e) − θ(R_i)| z / 2π", "8", "R_e R_i z",
            lambda s: overlap_ratio(s.pair)),
        row("eps_gamma", "Total contact ratio", "ε_γ", "", "ε_γ = ε_α + ε_β", "8", "eps_alpha eps_beta",
            lambda s: transverse_contact_ratio(s.pair) + overlap_ratio(s.pair)),
        row("eps_o", "Modified contact ratio", "ε_o", "", "ε_o = √(ε_α² + ε_β²)", "8", "eps_alpha eps_beta",
            lambda s: float(np.hypot(transverse_contact_ratio(s.pair), overlap_ratio(s.pair)))),
    )  # fmt: skip


def cone_rows() -> tuple[Row, ...]:
    """Angles of the cones and places along the axis."""

    def row(key: str, name: str, symbol: str, formula: str, equation: str, inputs: str,
            value: Callable[[Subject], float], unit: Unit = "°") -> Row:  # fmt: skip
        return Row(key, "Cones", name, symbol, unit, formula, equation, tuple(inputs.split()), value)

    return (
        row("z", "Number of teeth", "z", "given", "1", "", lambda s: s.member.teeth, ""),
        row("x", "Profile shift factor", "x", "given for the pinion; x₂ = −x₁", "2", "",
            lambda s: s.design.tooth.profile_shift * (1 if s.member is s.pair.pinion else -1), ""),
        row("delta", "Pitch angle", "δ", "tan δ = sin Σ / (z_mate/z + cos Σ)", "2", "sigma z mate:z",
            lambda s: s.member.pitch_angle),
        row("delta_a", "Face angle", "δ_a", "δ_a = δ + θ_a", "2", "delta theta_a", lambda s: s.member.tip_angle),
        row("delta_f", "Root angle", "δ_f", "δ_f = δ − θ_f", "2", "delta theta_f", lambda s: s.member.root_angle),
        row("delta_b", "Base angle", "δ_b", "sin δ_b = sin δ cos α", "2 [5]", "delta alpha",
            lambda s: s.member.base_angle),
        row("gamma", "Pitch to base element, in the tangent plane", "γ", "cos γ = cos δ / cos δ_b", "2 [6]",
            "delta delta_b", lambda s: s.member.gamma),
        row("theta_a", "Addendum angle", "θ_a",
            "common apex: tan θ_a = h_ae/R_e; constant clearance: θ_a = θ_f of the mate", "2", "h_ae R_e mate:theta_f",
            lambda s: s.member.tip_angle - s.member.pitch_angle),
        row("theta_f", "Dedendum angle", "θ_f", "tan θ_f = h_fe / R_e", "2", "h_fe R_e",
            lambda s: s.member.pitch_angle - s.member.root_angle),
        row("R_b", "Base radius, heel", "R_b", "R_b = (m_et z / 2) cos α", "2 [4]", "m z alpha",
            lambda s: s.member.base_radius, "mm"),
        row("t_xo", "Crown to apex", "t_xo", "t_xo = R_e cos δ − h_ae sin δ", "2", "R_e delta h_ae",
            lambda s: float(s.member.outer_cone_distance * np.cos(s.member.pitch_angle)
                            - s.member.addendum * np.sin(s.member.pitch_angle)), "mm"),
        row("t_xi", "Front crown to apex", "t_xi", "t_xi = R_i cos δ − h_ai sin δ", "2", "R_i delta h_ai",
            lambda s: float(s.member.inner_cone_distance * np.cos(s.member.pitch_angle)
                            - height(s.member.tip_limit, s.member.inner_cone_distance)
                            * np.sin(s.member.pitch_angle)), "mm"),
        row("b_x", "Axial face width", "b_x", "b_x = t_xo − t_xi", "2", "t_xo t_xi", _axial_width, "mm"),
        row("t_zF", "Face apex beyond crossing point", "t_zF", "t_zF = h_ae cos θ_a / sin δ_a − R_e sin θ_a / sin δ_a",
            "2", "R_e h_ae theta_a delta_a", lambda s: _beyond(s.member.tip_limit), "mm"),
        row("t_zR", "Root apex beyond crossing point", "t_zR", "t_zR = R_e sin θ_f / sin δ_f − h_fe cos θ_f / sin δ_f",
            "2", "R_e h_fe theta_f delta_f", lambda s: _beyond(s.member.root_limit), "mm"),
    )  # fmt: skip


def _axial_width(subject: Subject) -> float:
    m = subject.member
    shorter = height(m.tip_limit, m.outer_cone_distance) - height(m.tip_limit, m.inner_cone_distance)
    return float(m.face_width * np.cos(m.pitch_angle) - shorter * np.sin(m.pitch_angle))


def _beyond(limit: ConeLimit) -> float:
    return float(limit.offset / np.sin(limit.angle))
