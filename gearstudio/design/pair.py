"""Both members of a pair together: the table ``pair`` of a design."""

from __future__ import annotations

from typing import Literal

from gearstudio.design.fields import Part, Words, number, word


class Pair(Part):
    """Both members together."""

    pinion_teeth: int = number(
        17,
        5,
        200,
        Words("Pinion teeth", "Number of teeth of the pinion.", "teeth", "z₁", "δ₁ = atan2(sin Σ, z₂/z₁ + cos Σ)"),
    )
    wheel_teeth: int = number(
        40, 5, 200, Words("Wheel teeth", "Number of teeth of the wheel.", "teeth", "z₂", "δ₂ = Σ − δ₁")
    )
    shaft_angle_deg: float = number(
        90.0, 30.0, 150.0,
        Words(
            "Shaft angle", "Angle between the two axes; both pitch cones must stay below 90°.",
            "°", "Σ", "Σ = δ₁ + δ₂", 1.0, 3,
        ),
    )  # fmt: skip
    outer_module: float = number(
        4.0, 0.1, 100.0,
        Words(
            "Outer module", "Outer transverse module: heel pitch diameter over teeth.",
            "mm", "m", "R = m z₁ / (2 sin δ₁)", 0.25, 4,
        ),
    )  # fmt: skip
    pressure_angle_deg: float = number(
        20.0, 10.0, 35.0,
        Words("Pressure angle", "Pressure angle of both flanks.", "°", "α", "tan α = tan αₙ / cos βₘ", 0.5, 3),
    )  # fmt: skip
    pressure_angle_kind: Literal["normal", "transverse"] = word(
        "normal",
        Words(
            "Pressure angle is",
            "Normal: in the normal section at the mean point, as standards give it. Transverse: as the paper gives it.",
            symbol="αₙ, α",
            equation="tan α = tan αₙ / cos βₘ",
        ),
    )
    face_width_factor: float = number(
        0.30, 0.0, 0.5,
        Words(
            "Face width factor", "Face width over outer cone distance; a face width that is given wins over it.",
            "", "B/R", "B = (B/R) R", 0.01, 4,
        ),
        above_minimum=True,
    )  # fmt: skip
    face_width: float | None = number(
        None, 0.0, 10000.0,
        Words(
            "Face width", "Face width along the pitch cone; leave empty to take the factor.",
            "mm", "B", "0 < B ≤ 0.5 R", 0.5, 4,
        ),
        above_minimum=True,
    )  # fmt: skip
    pinion_hand: Literal["left", "right"] = word(
        "left",
        Words(
            "Hand of the pinion",
            "Hand of spiral of the pinion; the wheel has the other.",
            symbol="hand₁",
            equation="hand₂ = −hand₁",
        ),
    )
    offset: float = number(
        0.0, -5000.0, 5000.0,
        Words(
            "Offset",
            "Distance between the axes of a hypoid pair; 0 is a bevel pair. Positive makes the pinion's spiral angle "
            "the larger one. With an offset the outer module and the face width are the wheel's.",
            "mm", "a", "a = r₂ sin ζ + r₁ sin η", 1.0, 4,
        ),
    )  # fmt: skip
