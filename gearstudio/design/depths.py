"""Depth and taper of the teeth: the factors of the outer module, or those of ISO 23509."""

from __future__ import annotations

from typing import Any, Literal

from gearstudio.design.fields import Part, Words, number, word

ISO = ("depth.system", "iso23509")
OWN = ("depth.system", "outer_module")
"""Depth systems as fields name them that have an effect with one of them only."""


def _angle_of_wheel(title: str, description: str, symbol: str) -> Any:
    """An angle of the wheel's taper [°]."""
    return number(None, -15.0, 15.0, Words(title, description, "°", symbol, "", 0.25, 4, ISO))


class Depth(Part):
    """Which rule the tooth depth follows."""

    system: Literal["outer_module", "iso23509"] = word(
        "outer_module",
        Words(
            "Depth system",
            "Outer module: the factors of the tooth, over the outer module at the heel. "
            "ISO 23509: factors of the mean normal module at the mean point, with a taper.",
        ),
    )
    taper: Literal["standard", "uniform", "duplex", "tilted_root"] = word(
        "standard",
        Words(
            "Taper",
            "Standard: root lines through the pitch apex. Uniform: the same depth from toe to heel. "
            "Duplex: constant slot width. Tilted root: constant slot width, but not steeper than 1.3 times standard.",
            symbol="Σθ_f",
            equation="Σθ_f = θ_f₁ + θ_f₂",
            used_when=ISO,
        ),
    )
    depth_factor: float = number(
        2.0, 0.5, 3.0,
        Words(
            "Depth factor", "Working depth at the mean point over mean normal module.",
            "", "k_d", "h_mw = k_d m_mn", 0.05, 4, ISO,
        ),
    )  # fmt: skip
    clearance_factor: float = number(
        0.125, 0.0, 0.5,
        Words("Clearance over depth", "Tip clearance over working depth.", "", "k_c", "c = k_c h_mw", 0.005, 4, ISO),
    )  # fmt: skip
    mean_addendum_factor: float | None = number(
        None, 0.0, 1.0,
        Words(
            "Mean addendum factor",
            "The wheel's mean addendum over working depth; leave empty for 0.21 + 0.29/u₉₀².",
            "", "c_ham", "h_am₂ = c_ham h_mw", 0.01, 4, ISO,
        ),
    )  # fmt: skip
    thickness_factor: float = number(
        0.0, -0.5, 0.5,
        Words(
            "Thickness factor", "Thickness that the pinion's teeth gain over the wheel's, over mean normal module.",
            "", "k_t", "s_mn₁ − s_mn₂ = 2 k_t m_mn", 0.01, 4, ISO,
        ),
    )  # fmt: skip
    addendum_angle_deg: float | None = _angle_of_wheel(
        "Addendum angle", "From the wheel's pitch cone to its face cone; leave empty to take the taper's.", "θₐ₂"
    )
    dedendum_angle_deg: float | None = _angle_of_wheel(
        "Dedendum angle", "From the wheel's root cone to its pitch cone; leave empty to take the taper's.", "θ_f₂"
    )
