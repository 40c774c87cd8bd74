"""Which fields of a draft have no effect, and why; and what stands for an optional field left empty."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from gearstudio.design import all_field_specs, field_specs
from ui.formatting import choice_title, number_text

if TYPE_CHECKING:
    from gearstudio.design import Design
    from gearstudio.theory.cones import MemberGeometry, PairGeometry


def idle_fields(draft: Mapping[str, Any]) -> dict[str, str]:
    """Fields that the other values make meaningless, each with the reason."""
    curve = draft.get("lengthwise.curve")
    idle: dict[str, str] = {}
    for spec in field_specs():
        if spec.used_when is not None and draft.get(spec.used_when[0]) != spec.used_when[1]:
            other = all_field_specs()[spec.used_when[0]]
            idle[spec.path] = f"It needs “{choice_title(spec.used_when[1])}” as {other.title.lower()}."
    if curve != "archimedean":
        idle["lengthwise.spiral_angle_at"] = "Only the Archimedean spiral can take its angle at the toe."
    if draft.get("pair.face_width") is not None:
        idle["pair.face_width_factor"] = "The face width is given in millimetres: empty that field to use the factor."
    return idle


def derived_hints(design: Design, pair: PairGeometry) -> dict[str, str]:
    """Values that the program takes for empty optional fields, as grey text."""
    hints = {"pair.face_width": number_text(round(pair.wheel.face_width, 3))}
    for member in (pair.pinion, pair.wheel):
        hints |= _blank_hints(design, member)
    return hints


def _blank_hints(design: Design, member: MemberGeometry) -> dict[str, str]:
    """The sizes of a member's body that its empty fields stand for."""
    from gearstudio.theory.blank import BlankError, BlankSizes, blank_outline

    try:
        used = blank_outline(member, BlankSizes(**getattr(design.blank, member.name).model_dump())).sizes
    except BlankError:
        return {}
    names = ("bore_diameter", "hub_diameter", "hub_length", "mounting_distance", "web_thickness")
    return {f"blank.{member.name}.{name}": number_text(round(getattr(used, name), 3)) for name in names}
