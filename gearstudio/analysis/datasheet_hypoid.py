"""The data sheet of pairs with an offset, or with a depth after ISO 23509: the standard's names and symbols."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np

from gearstudio.analysis.datasheet_rows import Row, Subject, Unit
from gearstudio.errors import GeometryError
from gearstudio.theory.hypoid.dimensions import MemberDimensions, PairDimensions, dimensions
from gearstudio.theory.hypoid.method1 import method_0, method_1
from gearstudio.theory.hypoid.pair import HypoidPair
from gearstudio.theory.hypoid.pitch import PitchCone, PitchCones
from gearstudio.theory.modified import flank_member
from gearstudio.theory.pair import overlap_ratio, total_contact_ratio, transverse_contact_ratio

_ISO = "ISO 23509"


@lru_cache(maxsize=16)
def _dimensions(pair: HypoidPair) -> PairDimensions:
    return dimensions(pair)


def _of_pair(read: Callable[[PairDimensions], float]) -> Callable[[Subject], float]:
    def value(subject: Subject) -> float:
        assert subject.pair.hypoid is not None
        return read(_dimensions(subject.pair.hypoid))

    return value


def _of_member(read: Callable[[MemberDimensions], float]) -> Callable[[Subject], float]:
    def value(subject: Subject) -> float:
        assert subject.pair.hypoid is not None
        found = _dimensions(subject.pair.hypoid)
        return read(found.pinion if subject.member.name == "pinion" else found.wheel)

    return value


def standard_rows(pair: HypoidPair) -> tuple[Row, ...]:
    """Every quantity of the sheet; the standard's recursion where it has cones for this pair."""
    literal = _method_rows() if literal_cones(pair) is not None else ()
    return (*_pair_rows(), *_cone_rows(), *_end_rows(), *_tooth_rows(), *literal)


def _pair_rows() -> tuple[Row, ...]:
    def row(key: str, name: str, symbol: str, unit: Unit, formula: str, value: Callable[[Subject], float]) -> Row:
        return Row(key, "Pair", name, symbol, unit, formula, _ISO, (), value, True)

    def given(key: str, name: str, symbol: str, unit: Unit, read: Callable[[PairDimensions], float]) -> Row:
        return row(key, name, symbol, unit, "given", _of_pair(read))

    def found(
        key: str, name: str, symbol: str, unit: Unit, formula: str, read: Callable[[PairDimensions], float]
    ) -> Row:
        return row(key, name, symbol, unit, formula, _of_pair(read))

    return (
        given("sigma", "Shaft angle", "Σ", "°", lambda d: d.shaft_angle),
        given("a", "Hypoid offset", "a", "mm", lambda d: d.offset),
        found("u", "Gear ratio", "u", "", "u = z₂/z₁", lambda d: d.ratio),
        row("m", "Outer transverse module of the wheel", "m_et2", "mm", "given", lambda s: s.pair.wheel.module),
        found("m_mn", "Mean normal module", "m_mn", "mm", "m_mn = 2 R_m2 sin δ₂ cos β_m2 / z₂",
              lambda d: d.mean_normal_module),
        found("zeta_m", "Offset angle, axial plane", "ζ_m", "°", "a = r₂ sin ζ_m + r₁ sin η",
              lambda d: d.offset_angle_axial),
        found("zeta_mp", "Offset angle, pitch plane", "ζ_mp", "°", "sin ζ_mp = sin Σ sin ζ_m / cos δ₁",
              lambda d: d.offset_angle_pitch),
        found("zeta_R", "Offset angle, root plane", "ζ_R", "°", "plane that touches the wheel's root cone",
              lambda d: d.offset_angle_root),
        found("zeta_o", "Offset angle, face plane", "ζ_o", "°", "plane that touches the wheel's face cone",
              lambda d: d.offset_angle_face),
        found("a_p", "Offset in the pitch plane", "a_p", "mm", "a_p = R_m2 sin ζ_mp", lambda d: d.pitch_plane_offset),
        found("alpha_lim", "Limit pressure angle", "α_lim", "°",
              "tan α_lim = −tan δ₁ tan δ₂ (R_m1 sin β_m1 − R_m2 sin β_m2) / (cos ζ_mp (R_m1 tan δ₁ + R_m2 tan δ₂))",
              lambda d: d.limit_pressure_angle),
        found("alpha_nD", "Normal pressure angle, drive flank", "α_nD", "°", "α_nD = α_d + f_αlim α_lim",
              lambda d: d.drive_pressure_angle),
        found("alpha_nC", "Normal pressure angle, coast flank", "α_nC", "°", "α_nC = α_d − f_αlim α_lim",
              lambda d: d.coast_pressure_angle),
        found("h_mw", "Mean working depth", "h_mw", "mm", "h_mw = k_d m_mn", lambda d: d.working_depth),
        found("clearance", "Clearance", "c", "mm", "c = k_c h_mw", lambda d: d.clearance),
        row("j_t", "Transverse backlash, outer", "j_t", "mm", "given", lambda s: s.design.tooth.backlash),
        row("eps_alpha", "Transverse contact ratio", "ε_α", "",
            "turn of contact over the profile in the middle of the face, over the pitch",
            lambda s: transverse_contact_ratio(s.pair)),
        row("eps_beta", "Overlap ratio", "ε_β", "", "turn of contact over the face at half the depth, over the pitch",
            lambda s: overlap_ratio(s.pair)),
        row("eps_o", "Total contact ratio", "ε_γ", "", "turn of contact over the whole flank, over the pitch",
            lambda s: total_contact_ratio(s.pair)),
    )  # fmt: skip


def _cone_rows() -> tuple[Row, ...]:
    def row(
        key: str, name: str, symbol: str, formula: str, read: Callable[[MemberDimensions], float], unit: Unit = "°"
    ) -> Row:
        return Row(key, "Cones", name, symbol, unit, formula, _ISO, (), _of_member(read))

    def base(drive: bool) -> Callable[[Subject], float]:
        def value(subject: Subject) -> float:
            side = subject.pair.pinion.hand if drive else -subject.pair.pinion.hand
            return flank_member(subject.member, side).base_angle

        return value

    return (
        Row("z", "Cones", "Number of teeth", "z", "", "given", _ISO, (), lambda s: s.member.teeth),
        row("delta", "Pitch angle", "δ", "exact: tangent pitch cones, ρ_lim = r_c0", lambda d: d.pitch_angle),
        row("delta_a", "Face angle", "δ_a", "δ_a = δ + θ_a", lambda d: d.face_angle),
        row("delta_f", "Root angle", "δ_f", "δ_f = δ − θ_f", lambda d: d.root_angle),
        row("theta_a", "Addendum angle", "θ_a", "by the taper", lambda d: d.addendum_angle),
        row("theta_f", "Dedendum angle", "θ_f", "by the taper", lambda d: d.dedendum_angle),
        Row("delta_bD", "Cones", "Base angle, drive flank", "δ_bD", "°", "sin δ_b = sin δ cos α_t", "hypoid", (),
            base(True)),
        Row("delta_bC", "Cones", "Base angle, coast flank", "δ_bC", "°", "sin δ_b = sin δ cos α_t", "hypoid", (),
            base(False)),
        row("t_z", "Pitch apex beyond crossing point", "t_z", "t_z = R_m cos δ − t_zm", lambda d: d.pitch_apex, "mm"),
        row("t_zF", "Face apex beyond crossing point", "t_zF", "face cone's apex", lambda d: d.face_apex, "mm"),
        row("t_zR", "Root apex beyond crossing point", "t_zR", "root cone's apex", lambda d: d.root_apex, "mm"),
        row("b", "Face width", "b", "given for the wheel", lambda d: d.face_width, "mm"),
        row("b_e", "Face width from mean point to heel", "b_e", "b = b_e + b_i", lambda d: d.outer_face_width, "mm"),
        row("b_i", "Face width from mean point to toe", "b_i", "b = b_e + b_i", lambda d: d.inner_face_width, "mm"),
    )  # fmt: skip


def _end_rows() -> tuple[Row, ...]:
    rows: list[Row] = []
    for place, word, end in (("e", "Outer", "outer"), ("m", "Mean", "mean"), ("i", "Inner", "inner")):
        crown = {"e": ("t_xo", "Crown to crossing point"), "i": ("t_xi", "Front crown to crossing point")}
        parts: list[tuple[str, str, str, Unit, str, str]] = [
            ("Cones", f"R_{place}", "cone distance", "mm", "cone_distance", f"R_{place} from the pitch apex"),
            ("Cones", f"β_{place}", "spiral angle", "°", "spiral_angle", "at this cone distance"),
            ("Diameters", f"d_{place}", "pitch diameter", "mm", "pitch_diameter", f"d = 2 R_{place} sin δ"),
            ("Diameters", f"d_a{place}", "tip diameter", "mm", "tip_diameter", "d_a = d + 2 h_a cos δ"),
            ("Diameters", f"d_f{place}", "root diameter", "mm", "root_diameter", "d_f = d − 2 h_f cos δ"),
            ("Depths", f"h_a{place}", "addendum", "mm", "addendum", "square to the pitch cone"),
            ("Depths", f"h_f{place}", "dedendum", "mm", "dedendum", "square to the pitch cone"),
            ("Depths", f"h_{place}", "whole depth", "mm", "depth", "h = h_a + h_f"),
        ]
        for group, symbol, name, unit, field, formula in parts:
            rows.append(_at_end(symbol, group, f"{word} {name}", unit, formula, end, field))
        if place in crown:
            symbol, name = crown[place]
            formula = f"{symbol} = R_{place} cos δ − t_z − h_a{place} sin δ"
            rows.append(_at_end(symbol, "Cones", name, "mm", formula, end, "crown"))
    order = ("Cones", "Diameters", "Depths")
    return tuple(sorted(rows, key=lambda row: order.index(row.group)))


def _at_end(symbol: str, group: str, name: str, unit: Unit, formula: str, end: str, field: str) -> Row:
    key = symbol.replace("β", "beta")
    value = _of_member(lambda d: float(getattr(getattr(d, end), field)))
    return Row(key, group, name, symbol, unit, formula, _ISO, (), value)


def _tooth_rows() -> tuple[Row, ...]:
    def row(key: str, name: str, formula: str, read: Callable[[MemberDimensions], float], unit: Unit = "mm") -> Row:
        return Row(key, "Thickness", name, key, unit, formula, _ISO, (), _of_member(read))

    return (
        row("x_hm", "Profile shift coefficient", "x_hm1 = k_d (1/2 − c_ham)", lambda d: d.profile_shift, ""),
        row("x_sm", "Thickness modification coefficient", "with the backlash's share", lambda d: d.thickness_shift, ""),
        row("s_mn", "Mean normal circular thickness", "s_mn = m_mn (π/2 + 2 (x_sm + x_hm tan α_d))",
            lambda d: d.mean_normal_thickness),
        row("s_mnc", "Mean normal chordal thickness", "s_mnc = d_v sin(s_mn / d_v)",
            lambda d: d.mean_chordal_thickness),
        row("h_amc", "Mean chordal addendum", "h_amc = h_am + (d_v cos δ/2)(1 − cos(s_mn / d_v))",
            lambda d: d.mean_chordal_addendum),
        row("m_et", "Outer transverse module", "m_et = d_e / z", lambda d: d.outer_transverse_module),
    )  # fmt: skip


def _method_rows() -> tuple[Row, ...]:
    """The standard's own pitch cones beside the exact ones."""

    def row(key: str, name: str, symbol: str, unit: Unit, read: Callable[[PitchCones, str], float]) -> Row:
        def value(subject: Subject) -> float:
            assert subject.pair.hypoid is not None
            cones = literal_cones(subject.pair.hypoid)
            assert cones is not None
            return read(cones, subject.member.name)

        return Row(key, "As the standard's recursion has it", name, symbol, unit,
                   "Method 1 as written; Method 0 without an offset", _ISO, (), value)  # fmt: skip

    def cone(cones: PitchCones, name: str) -> PitchCone:
        return cones.pinion if name == "pinion" else cones.wheel

    return (
        row("delta_iso", "Pitch angle", "δ", "°", lambda c, n: cone(c, n).angle),
        row("R_m_iso", "Mean cone distance", "R_m", "mm", lambda c, n: cone(c, n).mean_cone_distance),
        row("beta_m_iso", "Mean spiral angle", "β_m", "°", lambda c, n: cone(c, n).spiral_angle),
    )


@lru_cache(maxsize=16)
def literal_cones(pair: HypoidPair) -> PitchCones | None:
    """Cones by Method 0 or 1; None where the recursion has none or takes other inputs."""
    if pair.given.offset == 0:
        return method_0(pair.given)
    if pair.given.spiral_angle_of == "wheel" or pair.given.curve != "circular_arc":
        return None
    try:
        return method_1(pair.given)
    except (GeometryError, ValueError, ZeroDivisionError, np.linalg.LinAlgError):
        return None
