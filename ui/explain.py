"""What a field is: its tooltip, and the longer answer to "What is this?"."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import Any

from gearstudio.design import FieldSpec, all_field_specs
from ui.formatting import choice_title, parse_number, subscripts, written
from ui.help.pages_of import term_of
from ui.units import factor, shown_text, spaced
from ui.words import retold, told, tr


@retold
def title_in_text(spec: FieldSpec) -> str:
    """A field's title within a sentence: small letters in English, as it is in other languages."""
    title = tr(spec.title)
    return title[0].lower() + title[1:] if title == spec.title and title[1:2].islower() else title


@retold
def full_title(spec: FieldSpec) -> str:
    """A field's title within a sentence, with its group where several have this title."""
    title = title_in_text(spec)
    twins = sum(other.title == spec.title for other in all_field_specs().values())
    return f"{tr(spec.group)}: {title}" if twins > 1 else title


@retold
def field_value_text(spec: FieldSpec, value: Any) -> str:
    """A value of a field in words: ``41``, ``80 mm``, ``Circular arc (milled)``, ``derived``."""
    if value is None:
        return tr("derived")
    if spec.kind == "choice":
        return tr(choice_title(str(value)))
    if isinstance(value, str):
        return f"“{value if len(value) <= 40 else value[:39] + '…'}”"
    shown = shown_text(value, spec.unit)
    return shown if spec.kind == "int" else f"{shown}{spaced(spec.unit)}"


def has_equation(spec: FieldSpec) -> bool:
    """Whether a field enters an equation of the browser."""
    from gearstudio.equations import equations_of_field

    return bool(equations_of_field(spec.path))


def tooltip(spec: FieldSpec) -> str:
    """What a parameter is, its symbol, where it enters the equations, its range and default."""
    head = f"<b>{escape(tr(spec.title))}</b>" + (f" &nbsp;<i>{subscripts(spec.symbol)}</i>" if spec.symbol else "")
    lines = [f"<p>{head}</p>", f"<p>{escape(tr(spec.description))}</p>"]
    if spec.equation:
        lines.append(f"<p>{subscripts(written(spec.equation))}</p>")
    lines += [f"<p>{escape(line)}</p>" for line in _facts(spec)]
    return "".join(lines)


def explanation(spec: FieldSpec, value: Any, idle: str, effects: Sequence[str]) -> str:
    """The answer to "What is this?": all of the tooltip, the value now, the file's key, and what a step changes."""
    lines = [tooltip(spec), f"<p>{tr('Now: {value}', value=escape(field_value_text(spec, value)))}</p>"]
    if idle:
        lines.append(f"<p><b>{tr('Not used now.')}</b> {escape(idle)}</p>")
    if effects:
        lines.append("<p>" + "<br>".join(escape(effect) for effect in effects) + "</p>")
    if has_equation(spec):
        lines.append(f'<p><a href="equation:{spec.path}">{tr("Show equation")}</a></p>')
    term = term_of(spec.title)
    if term:
        lines.append(f'<p><a href="glossary:{escape(term)}">{escape(tr("In the glossary: {term}", term=term))}</a></p>')
    lines.append(f"<p>{tr('In the design file: {key}', key=f'<code>{escape(spec.path)}</code>')}</p>")
    return "".join(lines)


def limits_text(spec: FieldSpec) -> str:
    """The range of a number in words: ``5 to 200``, ``at least 0 mm``."""
    low, high, unit = spec.minimum, spec.maximum, spaced(spec.unit)
    if low is not None and high is not None:
        words = tr("more than {low}, up to {high}") if spec.above_minimum else tr("{low} to {high}")
        return words.format(low=shown_text(low, spec.unit), high=shown_text(high, spec.unit)) + unit
    if low is not None:
        return tr("at least {low}", low=shown_text(low, spec.unit)) + unit
    return tr("at most {high}", high=shown_text(high, spec.unit)) + unit if high is not None else ""


def problem_text(message: str, spec: FieldSpec) -> str:
    """What is wrong with a value, in the unit shown; the core quotes value and range of a length without their unit."""
    text = str(told(message))
    if factor(spec.unit) == 1:
        return text
    first, *others = message.split(" ")
    value = parse_number(first)
    if not isinstance(value, str) and others[:1] != [spec.unit] and text.startswith(f"{written(first)} "):
        text = shown_text(value, spec.unit) + spaced(spec.unit) + text.removeprefix(written(first))
    return text.replace(told(spec.range_text), limits_text(spec))


def _facts(spec: FieldSpec) -> list[str]:
    lines = []
    if spec.choices:
        named = ", ".join(tr(choice_title(choice)) for choice in spec.choices)
        lines.append(tr("One of: {choices}.", choices=named))
    elif spec.kind != "text":
        lines.append(tr("Range: {limits}", limits=limits_text(spec)))
    if spec.optional:
        lines.append(tr("Leave it empty to use the derived value shown in grey."))
    else:
        lines.append(tr("Default: {value}", value=field_value_text(spec, spec.default)))
    return lines
