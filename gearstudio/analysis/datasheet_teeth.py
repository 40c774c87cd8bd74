"""Diameters, depths, thicknesses and margins of the geometry data sheet."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from gearstudio.analysis.datasheet_rows import Row, Subject, Unit, cone_distance, height
from gearstudio.theory.fillet import fillet
from gearstudio.theory.pair import interference, tip_half_azimuth


def size_rows() -> tuple[Row, ...]:
    """Diameters and depths at the heel, the middle and the toe."""
    rows = [row for place, word in (("e", "Outer"), ("m", "Mean"), ("i", "Inner")) for row in _sizes(place, word)]
    return tuple(sorted(rows, key=lambda row: row.group, reverse=True))


def _sizes(p: str, word: str) -> tuple[Row, ...]:
    """Diameters and depths at one place: p is e, m or i."""

    def row(group: str, key: str, name: str, formula: str, inputs: str, value: Callable[[Subject], float]) -> Row:
        return Row(key, group, f"{word} {name}", key, "mm", formula, "2", tuple(inputs.split()), value)

    def tip(s: Subject) -> float:
        return height(s.member.tip_limit, cone_distance(p, s.member))

    def root(s: Subject) -> float:
        return height(s.member.root_limit, cone_distance(p, s.member))

    addendum = ("h_ae = m_et (h_a* + x)", "m ha x")
    dedendum = ("h_fe = m_et (h_a* + c* − x)", "m ha c x")
    if p != "e":
        addendum = (f"h_a{p} = h_ae − (R_e − R_{p}) tan θ_a", f"h_ae R_e R_{p} theta_a")
        dedendum = (f"h_f{p} = R_{p} tan θ_f", f"R_{p} theta_f")
    wide, deep = "Diameters", "Depths"
    return (
        row(wide, f"d_{p}", "pitch diameter", f"d_{p} = 2 R_{p} sin δ", f"R_{p} delta", lambda s: _diameter(s, p)),
        row(wide, f"d_a{p}", "tip diameter", f"d_a{p} = d_{p} + 2 h_a{p} cos δ", f"d_{p} h_a{p} delta",
            lambda s: _diameter(s, p, tip(s))),
        row(wide, f"d_f{p}", "root diameter", f"d_f{p} = d_{p} − 2 h_f{p} cos δ", f"d_{p} h_f{p} delta",
            lambda s: _diameter(s, p, root(s))),
        row(deep, f"h_a{p}", "addendum", *addendum, tip),
        row(deep, f"h_f{p}", "dedendum", *dedendum, lambda s: -root(s)),
        row(deep, f"h_{p}", "whole depth", f"h_{p} = h_a{p} + h_f{p}", f"h_a{p} h_f{p}", lambda s: tip(s) - root(s)),
        row(deep, f"c_{p}", "clearance", f"c_{p} = h_f{p} − h_a{p} of the mate", f"h_f{p} mate:h_a{p}",
            lambda s: -root(s) - tip(s.opposite)),
    )  # fmt: skip


def _diameter(subject: Subject, place: str, above: float = 0.0) -> float:
    m = subject.member
    return float(2 * (cone_distance(place, m) * np.sin(m.pitch_angle) + above * np.cos(m.pitch_angle)))


def tooth_rows() -> tuple[Row, ...]:
    """Thickness of the teeth and the margins that they have left."""

    def row(group: str, key: str, name: str, formula: str, equation: str, inputs: str,
            value: Callable[[Subject], float], unit: Unit = "mm") -> Row:  # fmt: skip
        return Row(key, group, name, key, unit, formula, equation, tuple(inputs.split()), value)

    thick = "Thickness"
    return (
        row(thick, "half", "Half the tooth, azimuth on the pitch cone", "half = (π/2 + 2 x tan α)/z − j_t/(2 m_et z)",
            "5", "x alpha z j_t m", lambda s: s.member.half_tooth_azimuth, "°"),
        row(thick, "s_et", "Transverse circular thickness, outer", "s_et = d_e · half", "5", "d_e half",
            _circular("e")),
        row(thick, "s_etc", "Transverse chordal thickness, outer", "s_etc = d_e sin(half)", "5", "d_e half",
            lambda s: float(_diameter(s, "e") * np.sin(s.member.half_tooth_azimuth))),
        row(thick, "h_aec", "Chordal addendum, outer", "h_aec = h_ae + (d_e/2)(1 − cos half) cos δ", "5",
            "h_ae d_e half delta", _outer_chordal_addendum),
        row(thick, "s_mt", "Transverse circular thickness, mean", "s_mt = d_m · half", "5", "d_m half", _circular("m")),
        row(thick, "s_mn", "Normal circular thickness, mean", "s_mn = s_mt cos β_m", "5", "s_mt beta_m",
            _normal_thickness),
        row(thick, "d_v", "Virtual normal diameter, mean", "d_v = d_m / (cos δ cos² β_m)", "5", "d_m delta beta_m",
            _virtual_diameter),
        row(thick, "s_mnc", "Normal chordal thickness, mean", "s_mnc = d_v sin(s_mn / d_v)", "5", "d_v s_mn",
            lambda s: float(_virtual_diameter(s) * np.sin(_normal_thickness(s) / _virtual_diameter(s)))),
        row(thick, "h_amc", "Chordal addendum, mean", "h_amc = h_am + (d_v/2)(1 − cos(s_mn / d_v))", "5",
            "h_am d_v s_mn", _mean_chordal_addendum),
        row("Margins", "s_ae", "Tip land, heel", "s_ae = 2 R_e sin δ_tip [half + β(δ) − β(δ_tip)]", "8 [3]",
            "R_e delta_a half delta_b", _tip_land("e")),
        row("Margins", "s_ai", "Tip land, toe", "s_ai = 2 R_i sin δ_tip [half + β(δ) − β(δ_tip)]", "8 [3]",
            "R_i delta_a half delta_b", _tip_land("i")),
        row("Margins", "undercut", "Undercut margin: rolled arc left below the mate's tip",
            "γ + γ_mate − arccos(cos δ_a/cos δ_b) of the mate", "8", "gamma mate:gamma mate:delta_a mate:delta_b",
            lambda s: -interference(s.pair, s.mate), "°"),
        row("Margins", "R_f", "Fillet radius, heel", "R_f as asked, or of the full-round root", "6 [19]", "R_e m_mn",
            lambda s: fillet(s.member).radius * s.member.outer_cone_distance),
    )  # fmt: skip


def _circular(place: str) -> Callable[[Subject], float]:
    return lambda s: _diameter(s, place) * s.member.half_tooth_azimuth


def _outer_chordal_addendum(s: Subject) -> float:
    m = s.member
    rise = _diameter(s, "e") / 2 * (1 - np.cos(m.half_tooth_azimuth)) * np.cos(m.pitch_angle)
    return float(m.addendum + rise)


def _normal_thickness(s: Subject) -> float:
    return float(_circular("m")(s) * np.cos(s.pair.mean_spiral_angle))


def _virtual_diameter(s: Subject) -> float:
    return float(_diameter(s, "m") / (np.cos(s.member.pitch_angle) * np.cos(s.pair.mean_spiral_angle) ** 2))


def _mean_chordal_addendum(s: Subject) -> float:
    virtual = _virtual_diameter(s)
    rise = virtual / 2 * (1 - np.cos(_normal_thickness(s) / virtual))
    return float(height(s.member.tip_limit, s.member.mean_cone_distance) + rise)


def _tip_land(place: str) -> Callable[[Subject], float]:
    def value(s: Subject) -> float:
        rho = cone_distance(place, s.member)
        return float(2 * rho * np.sin(s.member.tip_limit.at_sphere(rho)) * tip_half_azimuth(s.member, rho))

    return value
