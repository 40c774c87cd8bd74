"""What a parameter changes: the design is computed once more with the next value, and what moves is told."""

from __future__ import annotations

from typing import Any

from gearstudio.design import Design, FieldSpec, field_value, with_field
from gearstudio.errors import GeometryError
from ui.derived_panel import pair_rows, quantities
from ui.explain import field_value_text
from ui.formatting import MEMBER_TITLES
from ui.units import spaced
from ui.words import tr

MOST = 4


def effect_lines(design: Design, spec: FieldSpec) -> list[str]:
    """What the next value of a field would do to the derived values: a heading, and up to four lines.

    Empty where the field is derived itself, or where no next value makes a gear.
    """
    from pydantic import ValidationError

    from gearstudio.theory.cones import pair_geometry

    value = _next(spec, field_value(design, spec.path))
    if value is None:
        return []
    try:
        before, after = (_table(pair_geometry(one)) for one in (design, with_field(design, spec.path, value)))
    except (GeometryError, ValidationError):
        return []
    moved = [(name, was, after[name]) for name, was in before.items() if after.get(name, was) != was]
    shown = field_value_text(spec, value)
    if not moved:
        return [tr("With {value} no derived value would change.", value=shown)]
    lines = [tr("With {value}:", value=shown)]
    lines += [f"{name}: {was} → {now}" for name, was, now in moved[:MOST]]
    if len(moved) > MOST:
        lines.append(tr("and {count} more", count=len(moved) - MOST))
    return lines


def _next(spec: FieldSpec, value: Any) -> Any:
    """The next value that a user might try, None when there is none."""
    if spec.kind == "choice":
        others = [choice for choice in spec.choices if choice != value]
        return others[0] if others else None
    if spec.kind == "text" or value is None:
        return None
    step = spec.step or 1
    up = value + step
    if spec.maximum is not None and up > spec.maximum:
        up = value - step
    return round(up) if spec.kind == "int" else float(f"{up:.12g}")


def _table(pair: Any) -> dict[str, str]:
    rows = {
        f"{tr(MEMBER_TITLES[member.name])}, {quantity.name}": quantity.text(member) + spaced(quantity.unit)
        for quantity in quantities(pair)
        if quantity.unit
        for member in (pair.pinion, pair.wheel)
        if quantity.text(member)
    }
    return rows | {tr(title): text for title, _, text, _ in pair_rows(pair)}
