"""Micro-geometry as a drawing gives it: µm at stated places, for each flank of each member."""

from __future__ import annotations

from typing import Any

from pydantic import Field

from gearstudio.design.fields import Part, Words, number

MOST_UM = 1000.0
"""Largest crowning, correction or relief [µm]."""


def _height(title: str, description: str, symbol: str, equation: str, least: float = -MOST_UM) -> Any:
    """An amount of metal [µm]."""
    return number(0.0, least, MOST_UM, Words(title, description, "µm", symbol, equation, 1.0, 2))


def _place(default: float, title: str, description: str, symbol: str, equation: str) -> Any:
    """A place on the profile, as a share of its depth."""
    return number(default, 0.05, 0.95, Words(title, description, "", symbol, equation, 0.05, 3))


class FlankModification(Part):
    """What is taken off one flank, normal to it; ξ runs from −1 at the toe to 1 at the heel, η from root to tip."""

    lengthwise_crowning_um: float = _height(
        "Lengthwise crowning",
        "Metal taken off at toe and heel, rising as a parabola from the middle of the face.",
        "c_l",
        "e = c_l ξ²",
    )
    profile_crowning_um: float = _height(
        "Profile crowning",
        "Metal taken off at root and tip of the flank, rising as a parabola from the middle of its depth.",
        "c_p",
        "e = c_p η²",
    )
    spiral_angle_correction_um: float = _height(
        "Spiral angle correction",
        "Metal at the heel more than at the toe, over the whole face; nothing changes in the middle.",
        "s",
        "e = −s ξ/2",
    )
    pressure_angle_correction_um: float = _height(
        "Pressure angle correction",
        "Metal at the tip more than at the root, over the whole depth of the flank; nothing changes in the middle.",
        "p",
        "e = −p η/2",
    )
    bias_um: float = _height(
        "Bias",
        "Metal at the corners root-toe and tip-heel more than at the other two.",
        "b",
        "e = −b ξη/2",
    )
    tip_relief_um: float = _height(
        "Tip relief",
        "Metal taken off at the tip; it grows from where it starts as a cube, without a kink in slope or curvature.",
        "c_t",
        "e = c_t ((η − ηₜ)/(1 − ηₜ))³",
        0.0,
    )
    tip_relief_start: float = _place(
        0.7,
        "Tip relief starts at",
        "Share of the flank's depth, from 0 at its lower edge to 1 at the tip; no effect without tip relief.",
        "ηₜ",
        "ηₜ = 2 share − 1",
    )
    root_relief_um: float = _height(
        "Root relief",
        "Metal taken off at the lower edge of the flank; it fades out as a cube, without a kink.",
        "c_r",
        "e = c_r ((ηᵣ − η)/(1 + ηᵣ))³",
        0.0,
    )
    root_relief_end: float = _place(
        0.3,
        "Root relief ends at",
        "Share of the flank's depth, from 0 at its lower edge to 1 at the tip; no effect without root relief.",
        "ηᵣ",
        "ηᵣ = 2 share − 1",
    )

    @property
    def is_none(self) -> bool:
        """Whether nothing is taken off or added anywhere."""
        return not any(getattr(self, key) for key in type(self).model_fields if key.endswith("_um"))


class MemberModifications(Part):
    """Micro-geometry of both flanks of a member."""

    concave: FlankModification = Field(default_factory=FlankModification)
    convex: FlankModification = Field(default_factory=FlankModification)


class Modifications(Part):
    """Micro-geometry of both members."""

    pinion: MemberModifications = Field(default_factory=MemberModifications)
    wheel: MemberModifications = Field(default_factory=MemberModifications)
