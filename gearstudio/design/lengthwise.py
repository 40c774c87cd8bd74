"""How the teeth run along the face: the table ``lengthwise`` of a design."""

from __future__ import annotations

from typing import Literal

from gearstudio.design.fields import Part, Words, number, word


class LengthwiseCurve(Part):
    """How a tooth runs along the face width."""

    curve: Literal["archimedean", "circular_arc", "logarithmic"] = word(
        "circular_arc",
        Words(
            "Lengthwise curve",
            "Archimedean: the paper's spiral on the base cone. Circular arc: the cutter's path. "
            "Logarithmic: the same spiral angle everywhere.",
            symbol="ψₜ(ρ)",
            equation="θ(ρ) = hand · ψₜ(ρ) / sin δ",
        ),
    )
    spiral_angle_deg: float = number(
        35.0, 0.0, 55.0,
        Words(
            "Spiral angle", "Spiral angle; 0 gives straight teeth, or zerol teeth with the circular arc.",
            "°", "β", "tan β(ρ) = ρ ψₜ′(ρ)", 1.0, 3,
        ),
    )  # fmt: skip
    spiral_angle_at: Literal["mean", "toe"] = word(
        "mean",
        Words(
            "Spiral angle at",
            "Mean: at the mean point on the pitch cone. Toe: at the toe on the base cone, as the paper gives it.",
            symbol="βₘ, β₀",
            equation="tan β₀ = (R − B) sin δ_b |dθ/dρ|",
        ),
    )
    cutter_radius: float = number(
        80.0, 0.1, 100000.0,
        Words(
            "Cutter radius", "Radius of the cutter whose arc the tooth follows.", "mm", "r₀",
            "sin β(ρ) = (ρ² + 2 r₀ Rₘ sin βₘ − Rₘ²) / (2 r₀ ρ)", 1.0, 4, ("lengthwise.curve", "circular_arc"),
        ),
    )  # fmt: skip
    spiral_angle_of: Literal["pinion", "wheel"] = word(
        "pinion",
        Words(
            "Spiral angle of",
            "Member whose mean spiral angle is given; both have the same without an offset.",
            symbol="βₘ₁, βₘ₂",
            equation="βₘ₁ = βₘ₂ + ζₘₚ",
        ),
    )
