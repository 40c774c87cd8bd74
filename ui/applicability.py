"""Which fields of a draft have no effect, and why; and what stands for an optional field left empty."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from gearstudio.design import all_field_specs, field_specs
from ui.explain import title_in_text
from ui.formatting import choice_title
from ui.offset_fields import depth_hints, idle_by_offset
from ui.units import factor, from_shown, shown_text, to_shown
from ui.words import tr

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
            idle[spec.path] = tr(
                "It needs “{choice}” as {field}.",
                choice=tr(choice_title(spec.used_when[1])),
                field=title_in_text(other),
            )
    for path in draft:
        flank, _, key = path.rpartition(".")
        amount = {"tip_relief_start": f"{flank}.tip_relief_um", "root_relief_end": f"{flank}.root_relief_um"}.get(key)
        if amount is not None and draft.get(amount) == 0:
            idle[path] = tr("There is no {field} to begin or end.", field=title_in_text(all_field_specs()[amount]))
    if curve != "archimedean":
        idle["lengthwise.spiral_angle_at"] = tr("Only the Archimedean spiral can take its angle at the toe.")
    idle |= idle_by_offset(draft)
    if draft.get("pair.face_width") is not None:
        idle["pair.face_width_factor"] = tr("The face width is given as a length: empty that field to use the factor.")
    return idle


def derived_hints(design: Design, pair: PairGeometry) -> dict[str, str]:
    """Values that the program takes for empty optional fields, as grey text."""
    hints = {"pair.face_width": _hint(pair.wheel.face_width)}
    hints |= depth_hints(pair)
    for member in (pair.pinion, pair.wheel):
        hints |= _blank_hints(design, member)
    return hints


def _hint(millimetres: float) -> str:
    places = 3 if factor("mm") == 1 else 5
    return shown_text(from_shown(round(to_shown(millimetres, "mm"), places), "mm"), "mm")


def _blank_hints(design: Design, member: MemberGeometry) -> dict[str, str]:
    """The sizes of a member's body that its empty fields stand for."""
    from gearstudio.theory.blank import BlankError, BlankSizes, blank_outline

    try:
        used = blank_outline(member, BlankSizes(**getattr(design.blank, member.name).model_dump())).sizes
    except BlankError:
        return {}
    names = ("bore_diameter", "hub_diameter", "hub_length", "mounting_distance", "web_thickness")
    return {f"blank.{member.name}.{name}": _hint(getattr(used, name)) for name in names}
