"""The profile of the teeth: the table ``tooth`` of a design."""

from __future__ import annotations

from typing import Literal

from gearstudio.design.depths import OWN
from gearstudio.design.fields import Part, Words, number, word


class Tooth(Part):
    """The profile of the teeth."""

    addendum_factor: float = number(
        1.0, 0.1, 2.0,
        Words(
            "Addendum factor", "Addendum at the heel over outer module, before profile shift.",
            "", "hₐ*", "hₐₑ = m (hₐ* + x)", 0.05, 4, OWN,
        ),
    )  # fmt: skip
    clearance_factor: float = number(
        0.25, 0.0, 1.0,
        Words(
            "Clearance factor", "Tip clearance at the heel over outer module.",
            "", "c*", "h_fe = m (hₐ* + c* − x)", 0.01, 4, OWN,
        ),
    )  # fmt: skip
    profile_shift: float = number(
        0.0, -1.5, 1.5,
        Words(
            "Profile shift", "Profile shift factor of the pinion; the wheel takes the negative.",
            "", "x₁", "x₂ = −x₁", 0.05, 4, OWN,
        ),
    )  # fmt: skip
    backlash: float = number(
        0.0, 0.0, 100.0,
        Words(
            "Backlash", "Transverse backlash at the heel pitch circle, half from each member.",
            "mm", "jₜ", "half = (π/2 + 2 x tan α)/z − jₜ/(2 m z)", 0.01, 4,
        ),
    )  # fmt: skip
    fillet_factor: float = number(
        0.3, 0.01, 1.0,
        Words(
            "Fillet factor", "Fillet radius on the heel sphere over mean normal module.",
            "", "R_f/mₙ", "R_f = 0.3 mₙ, mₙ = m (Rₘ/R) cos βₘ", 0.01, 4,
        ),
    )  # fmt: skip
    tip_cone: Literal["common_apex", "constant_clearance"] = word(
        "common_apex",
        Words(
            "Tip cone",
            "Common apex: all cones share the apex, as in the paper. "
            "Constant clearance: the tip runs parallel to the mate's root.",
            symbol="δₐ",
            equation="δₐ₁ = δ₁ + (δ₂ − δ_f2)",
            used_when=OWN,
        ),
    )
    ends: Literal["back_cone", "sphere"] = word(
        "back_cone",
        Words(
            "Tooth ends",
            "Back cone: as blanks are turned. Sphere: as in the paper.",
            symbol="ρᵤ",
            equation="ρ = ρᵤ / cos(δₖ − δ)",
        ),
    )
    limit_pressure_angle_factor: float = number(
        1.0, 0.0, 2.0,
        Words(
            "Limit pressure angle factor",
            "Share of the limit pressure angle that the drive flank gains and the coast flank loses; "
            "no effect without an offset.",
            "", "f_αlim", "αₙ = α ± f_αlim α_lim", 0.1, 3,
        ),
    )  # fmt: skip
