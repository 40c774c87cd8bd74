"""Plain words for what is wrong with a single field: field, value, limit and remedy."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from difflib import SequenceMatcher

from gearstudio.design import FieldSpec, all_field_specs
from gearstudio.errors import Issue

_LONGEST_ECHO = 40
_NUMBER = re.compile(r"[+-]?\d{1,15}([.,]\d{1,15})?", re.ASCII)


def shown(value: object) -> str:
    """A value as a message quotes it: short, on one line, and never failing."""
    if value is None:
        return "nothing"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int) and abs(value) >= 10**_LONGEST_ECHO:
        return "a whole number of more than 40 digits"
    if isinstance(value, int | float):
        return f"{value:.10g}" if isinstance(value, float) else str(int(value))
    if isinstance(value, str):
        short = value if len(value) <= _LONGEST_ECHO else value[: _LONGEST_ECHO - 1] + "…"
        return '"' + "".join(letter if letter.isprintable() else "\N{REPLACEMENT CHARACTER}" for letter in short) + '"'
    if isinstance(value, Mapping):
        return "a table"
    if isinstance(value, Sequence) and not isinstance(value, bytes | bytearray | memoryview):
        return "a list"
    return f"a value of type {type(value).__name__}"


def field_issue(spec: FieldSpec, value: object) -> Issue:
    """The issue of a value that the model refuses for a field."""
    unit = f" {spec.unit}" if spec.unit else ""
    remedy = f"use {spec.range_text}"
    if spec.kind == "choice":
        return Issue("unknown_choice", spec.path, f"{shown(value)} is not one of the choices; {remedy}")
    if spec.kind == "text":
        return Issue("not_a_line", spec.path, f"{shown(value)} cannot be a {spec.title.lower()}; {remedy}")
    noun = "whole number" if spec.kind == "int" else "number"
    if isinstance(value, str) and not value.strip():
        return Issue("empty_value", spec.path, f"the value is empty; {remedy}")
    if isinstance(value, str) and _NUMBER.fullmatch(value.strip()):
        text = f"{shown(value)} is a text; {remedy}, with a point and without quotation marks"
        return Issue("not_a_number", spec.path, text)
    if isinstance(value, bool) or not isinstance(value, int | float):
        return Issue("not_a_number", spec.path, f"{shown(value)} is not a {noun}; {remedy}")
    if isinstance(value, float) and not math.isfinite(value):
        return Issue("not_finite", spec.path, f"{shown(value)} is not a finite number; {remedy}")
    if spec.kind == "int" and not isinstance(value, int):
        return Issue("not_whole", spec.path, f"{shown(value)} is not a whole number; {remedy}")
    if spec.maximum is not None and value > spec.maximum:
        return Issue(
            "above_maximum", spec.path, f"{shown(value)} is above the most of {spec.maximum:g}{unit}; {remedy}"
        )
    if spec.above_minimum:
        return Issue("below_minimum", spec.path, f"{shown(value)} is not above {spec.minimum:g}{unit}; {remedy}")
    return Issue("below_minimum", spec.path, f"{shown(value)} is below the least of {spec.minimum:g}{unit}; {remedy}")


def unknown_key_issue(path: str) -> Issue:
    """The issue of a key that no design file has, with the nearest one that it may have."""
    table, _, key = path.rpartition(".")

    def likeness(name: str) -> float:
        known_table, _, known_key = name.rpartition(".")
        return SequenceMatcher(None, key, known_key).ratio() + 0.3 * (table == known_table)

    near = max([*known_keys(), "format"], key=likeness)
    return Issue("unknown_key", shown_path(path), f"unknown key; the nearest known one is {near}")


def table_issue(path: str, value: object) -> Issue:
    """The issue of something that stands where a table should."""
    return Issue("not_a_table", path, f"{shown(value)} is not a table; write [{path}] and its keys below it")


def known_keys() -> tuple[str, ...]:
    """Dotted names of every table and field of a design file, without ``format``."""
    names: dict[str, None] = {}
    for path in all_field_specs():
        names.update(dict.fromkeys(_parents(path)))
        names[path] = None
    return tuple(names)


def shown_path(path: str) -> str:
    """A dotted key fit for a line of text."""
    clean = "".join(letter if letter.isprintable() else "\N{REPLACEMENT CHARACTER}" for letter in path)
    return clean if len(clean) <= 2 * _LONGEST_ECHO else clean[: 2 * _LONGEST_ECHO - 1] + "…"


def _parents(path: str) -> Iterable[str]:
    parts = path.split(".")
    return (".".join(parts[:count]) for count in range(1, len(parts)))
