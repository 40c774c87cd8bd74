"""Tables of what the design asks for and of the geometry that follows from it."""

from __future__ import annotations

import re
from collections.abc import Iterator

from gearstudio.catalogue import MEMBERS
from gearstudio.design import Design, FieldSpec, field_specs
from gearstudio.report.blocks import Block, Heading, Table, Text, rows
from gearstudio.report.content import Content
from gearstudio.report.mathematics import mathematics
from gearstudio.theory.flank import FLANKS

_FLANKS, _BLANKS = "modifications", "blank"
_DESIGN_SHARES = (1.0, 0.0, 0.0, 0.0, 1.0)
_SHEET_SHARES = (1.15, 0.0, 0.0, 0.0, 0.0, 1.5, 0.0, 0.0)
_NO_RELIEF = "None: all four flanks are the theoretical ones."


def design_blocks(content: Content) -> list[Block]:
    """Every field of the design; what members or flanks have alike is beside each other."""
    design = content.design
    single = [spec for spec in _specs() if spec.path.split(".")[0] not in (_FLANKS, _BLANKS)]
    made: list[tuple[str, ...]] = []
    group = ""
    for spec in single:
        if spec.group != group:
            group = spec.group
            made.append((group,))
        made.append((spec.title, mathematics(spec.symbol), shown(design, spec), spec.unit, spec.path))
    head = ("Field", "Symbol", "Value", "Unit", "Key in the design file")
    blocks: list[Block] = [Table(head, rows(made), "lmdlk", _DESIGN_SHARES)]
    return [*blocks, Heading("Blanks"), _blanks(design), Heading("Micro-geometry"), _micro_geometry(design)]


def sheet_blocks(content: Content) -> list[Block]:
    """Dimensions of both members with their formulas."""
    if content.sheet is None:
        return [Text("This design has no complete tooth; see the notes.")]
    made: list[tuple[str, ...]] = []
    group = ""
    for line in content.sheet.lines():
        first = line[0]
        if first.group != group:
            group = first.group
            made.append((group,))
        values = (line[0].text, line[-1].text)
        section, equation = _where(first.equation) if first.formula != "given" else ("", "")
        made.append(
            (first.name, mathematics(first.symbol), *values, first.unit, mathematics(first.formula), section, equation)
        )
    head = ("Quantity", "Symbol", "Pinion", "Wheel", "Unit", "Formula", "Theory", "Paper")
    note = "Sections of the theory and equations of the paper where the formula stands are in the last two columns."
    return [Text(note), Table(head, rows(made), "lmddlmcc", _SHEET_SHARES)]


def shown(design: Design, spec: FieldSpec) -> str:
    """A field's value as text."""
    value: object = design
    for name in spec.path.split("."):
        value = getattr(value, name)
    if value is None:
        return "derived"
    return f"{value:.10g}" if isinstance(value, float) else str(value).replace("_", " ")


def _specs() -> Iterator[FieldSpec]:
    return (spec for spec in field_specs() if spec.path != "name")


def _like(*path: str) -> dict[str, FieldSpec]:
    head = ".".join(path) + "."
    return {spec.path.removeprefix(head): spec for spec in _specs() if spec.path.startswith(head)}


def _blanks(design: Design) -> Block:
    members = [_like(_BLANKS, member) for member in MEMBERS]
    made = [
        (spec.title, mathematics(spec.symbol), *(shown(design, of[name]) for of in members), spec.unit, name)
        for name, spec in members[0].items()
    ]
    head = ("Field", "Symbol", *(member.capitalize() for member in MEMBERS), "Unit", "Key in [blank.MEMBER]")
    return Table(head, rows(made), "lmddlk")


def _micro_geometry(design: Design) -> Block:
    flanks = {(member, flank): _like(_FLANKS, member, flank) for member in MEMBERS for flank in FLANKS}
    if all(_plain(design, spec) for fields in flanks.values() for spec in fields.values()):
        return Text(_NO_RELIEF)
    made = [
        (spec.title, mathematics(spec.symbol), *(shown(design, of[name]) for of in flanks.values()), spec.unit)
        for name, spec in next(iter(flanks.values())).items()
    ]
    head = ("Field", "Symbol", *(f"{member.capitalize()} {flank}" for member, flank in flanks), "Unit")
    return Table(head, rows(made), "lmddddl")


def _plain(design: Design, spec: FieldSpec) -> bool:
    return not spec.unit or shown(design, spec) == "0"


def _where(equation: str) -> tuple[str, str]:
    """``2 [7]`` as the section of the theory and the paper's equation."""
    section, _, printed = equation.partition(" [")
    return re.sub(r"\s", "", section), f"({printed.rstrip(']')})" if printed else ""
