"""Tables of what the design asks for and of the geometry that follows from it."""

from __future__ import annotations

from collections.abc import Iterator

from gearstudio.catalogue import MEMBERS
from gearstudio.design import Design, FieldSpec, field_specs
from gearstudio.design.choices import choice_title
from gearstudio.report.blocks import Block, Heading, Table, Text, rows
from gearstudio.report.content import Content
from gearstudio.report.language import MEMBERS_SAID, notation, number, tr
from gearstudio.report.mathematics import breakable, mathematics
from gearstudio.theory.flank import FLANKS
from gearstudio.words import noted

_FLANKS, _BLANKS = "modifications", "blank"
_DESIGN_SHARES = (1.0, 0.0, 0.0, 0.0, 1.0)
_SHEET_SHARES = (1.1, 0.0, 0.0, 0.0, 0.0, 1.4, 0.0)
_SOURCES = {"hypoid": noted("offset axes")}


def design_blocks(content: Content) -> list[Block]:
    """Every field of the design; what members or flanks have alike is beside each other."""
    design = content.design
    single = [spec for spec in _specs() if spec.path.split(".")[0] not in (_FLANKS, _BLANKS)]
    made: list[tuple[str, ...]] = []
    group = ""
    for spec in single:
        if spec.group != group:
            group = spec.group
            made.append((tr(group),))
        made.append((tr(spec.title), mathematics(spec.symbol), shown(design, spec), tr(spec.unit), spec.path))
    head = (tr("Field"), tr("Symbol"), tr("Value"), tr("Unit"), tr("Key in the design file"))
    blocks: list[Block] = [Table(head, rows(made), "lmdlk", _DESIGN_SHARES)]
    return [*blocks, Heading(tr("Blanks")), _blanks(design), Heading(tr("Micro-geometry")), _micro_geometry(design)]


def sheet_blocks(content: Content) -> list[Block]:
    """Dimensions of both members with their formulas."""
    if content.sheet is None:
        return [Text(tr("This design has no complete tooth; see the notes."))]
    made: list[tuple[str, ...]] = []
    group = ""
    for line in content.sheet.lines():
        first = line[0]
        if first.group != group:
            group = first.group
            made.append((tr(group),))
        values = (notation(line[0].text), notation(line[-1].text))
        where = _where(first.equation) if first.formula != "given" else ""
        formula = breakable(mathematics(tr(first.formula)))
        made.append((tr(first.name), mathematics(first.symbol), *values, tr(first.unit), formula, where))
    head = (tr("Quantity"), tr("Symbol"), tr("Pinion"), tr("Wheel"), tr("Unit"), tr("Formula"), tr("Source"))
    note = tr(
        "The last column says where the formula stands: section of the theory, and in brackets the paper's equation."
    )
    return [Text(note), Table(head, rows(made), "lmddlml", _SHEET_SHARES)]


def shown(design: Design, spec: FieldSpec) -> str:
    """A field's value as text."""
    value: object = design
    for name in spec.path.split("."):
        value = getattr(value, name)
    if value is None:
        return tr("derived")
    if isinstance(value, float):
        return number(value)
    return tr(choice_title(value)) if isinstance(value, str) else str(value)


def _specs() -> Iterator[FieldSpec]:
    return (spec for spec in field_specs() if spec.path != "name")


def _like(*path: str) -> dict[str, FieldSpec]:
    head = ".".join(path) + "."
    return {spec.path.removeprefix(head): spec for spec in _specs() if spec.path.startswith(head)}


def _blanks(design: Design) -> Block:
    members = [_like(_BLANKS, member) for member in MEMBERS]
    made = [
        (tr(spec.title), mathematics(spec.symbol), *(shown(design, of[name]) for of in members), tr(spec.unit), name)
        for name, spec in members[0].items()
    ]
    head = (tr("Field"), tr("Symbol"), *(tr(MEMBERS_SAID[member]) for member in MEMBERS), tr("Unit"),
            tr("Key in {table}", table="[blank.MEMBER]"))  # fmt: skip
    return Table(head, rows(made), "lmddlk")


def _micro_geometry(design: Design) -> Block:
    flanks = {(member, flank): _like(_FLANKS, member, flank) for member in MEMBERS for flank in FLANKS}
    if all(_plain(design, spec) for fields in flanks.values() for spec in fields.values()):
        return Text(tr("None: all four flanks are the theoretical ones."))
    made = [
        (tr(spec.title), mathematics(spec.symbol), *(shown(design, of[name]) for of in flanks.values()), tr(spec.unit))
        for name, spec in next(iter(flanks.values())).items()
    ]
    heads = (f"{tr(MEMBERS_SAID[member])}, {tr(flank)}" for member, flank in flanks)
    return Table((tr("Field"), tr("Symbol"), *heads, tr("Unit")), rows(made), "lmddddl")


def _plain(design: Design, spec: FieldSpec) -> bool:
    return not spec.unit or shown(design, spec) == "0"


def _where(equation: str) -> str:
    """``2 [7]`` as the section of the theory and the paper's equation: ``2 (7)``; names of standards as they are."""
    section, _, printed = equation.partition(" [")
    return tr(_SOURCES.get(section, section)) + (f" ({printed.rstrip(']')})" if printed else "")
