"""What two designs have and have not in common, value by value. Plain data."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from gearstudio.design import Design, all_field_specs, field_value
from ui.formatting import choice_title, number, written
from ui.words import tr


@dataclass(frozen=True)
class Line:
    """A value of two designs: where it belongs, its name and unit, both as text, the second less the first."""

    group: str
    name: str
    unit: str
    first: str
    second: str
    difference: str

    @property
    def differs(self) -> bool:
        """Whether the two are not the same."""
        return bool(self.difference)


def differences(first: Design, second: Design) -> tuple[Line, ...]:
    """Every field of the two designs, then every value of their data sheets.

    Raises
    ------
    GeometryError
        One of them has no teeth.
    """
    from gearstudio.analysis.datasheet import data_sheet

    sheets = data_sheet(first), data_sheet(second)
    return (*_fields(first, second), *_quantities(*sheets))


def as_text(lines: tuple[Line, ...]) -> str:
    """Lines for a spreadsheet, columns parted by tabs."""
    heads = "\t".join((tr("Group"), tr("Quantity"), tr("Unit"), tr("This design"), tr("Other"), tr("Difference")))
    rows = ("\t".join((one.group, one.name, one.unit, one.first, one.second, one.difference)) for one in lines)
    return "\n".join((heads, *rows)) + "\n"


def _fields(first: Design, second: Design) -> Iterator[Line]:
    for path, spec in all_field_specs().items():
        if path == "name":
            continue
        one, other = field_value(first, path), field_value(second, path)
        group = tr("Parameters: {group}", group=tr(spec.group))
        yield Line(group, tr(spec.title), tr(spec.unit), _text(one), _text(other), _difference(one, other))


def _quantities(first: Any, second: Any) -> Iterator[Line]:
    others = {(one.key, one.owner): one for one in second.quantities}
    owners = {"pair": tr("Pair"), "pinion": tr("Pinion"), "wheel": tr("Wheel")}
    for one in first.quantities:
        other = others.get((one.key, one.owner))
        if other is None:
            continue
        same = one.text == other.text
        difference = "" if same else _difference(one.value, other.value)
        owner = owners[one.owner]
        group = owner if tr(one.group) == owner else f"{owner}: {tr(one.group)}"
        yield Line(group, tr(one.name), one.unit, written(one.text), written(other.text), difference)


def _text(value: object) -> str:
    if value is None:
        return tr("derived")
    if isinstance(value, float):
        return number(value, ".10g")
    return tr(choice_title(value)) if isinstance(value, str) else str(value)


def _difference(one: object, other: object) -> str:
    if one == other:
        return ""
    if isinstance(one, int | float) and isinstance(other, int | float):
        return number(other - one, "+.5g")
    return "≠"
