"""All problems of a design at once: of its fields, and of the gear that they would make."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pydantic import ValidationError

from gearstudio.design import FORMAT, Design, all_field_specs
from gearstudio.errors import Issue
from gearstudio.validation.messages import field_issue, known_keys, shown, table_issue, unknown_key_issue
from gearstudio.validation.patience import within
from gearstudio.validation.rules import broken_rules

__all__ = ["check", "format_issue", "read_design"]

PATIENCE_S = 5.0
"""Longest search for remedies where nobody says otherwise [s]."""


def check(design: Design, patience_s: float = PATIENCE_S) -> tuple[Issue, ...]:
    """Every problem of the gear that a design would make, errors first; empty when all is well.

    Looking for remedies ends after the patience; what was not found by then is said in general words.
    """
    with within(patience_s):
        return _errors_first(broken_rules(design, frozenset()))


def read_design(data: Mapping[str, Any], patience_s: float = PATIENCE_S) -> tuple[Design | None, tuple[Issue, ...]]:
    """Read a design from nested tables, as a file or a form holds them, and find every problem at once.

    Parameters
    ----------
    data : mapping
        Tables and keys of the design file; what is missing takes its default. ``format`` may be missing.
    patience_s : float
        As of `check`.

    Returns
    -------
    design : Design or None
        None when any issue is an error.
    issues : tuple of Issue
        Of single fields, and of every geometry rule whose fields are fine; errors first.
    """
    foreign = format_issue(data)
    if foreign is not None and foreign.code == "other_format":
        return None, (foreign,)
    design, issues = _read_fields(data)
    if foreign is not None:
        issues.insert(0, foreign)
    bad = frozenset(issue.field for issue in issues)
    with within(patience_s):
        found = _errors_first([*issues, *broken_rules(design, bad)])
    return (None if any(issue.severity == "error" for issue in found) else design), found


def format_issue(data: object) -> Issue | None:
    """What is wrong with the format number of a design file, if it has one."""
    if not isinstance(data, Mapping) or "format" not in data:
        return None
    value = data["format"]
    if isinstance(value, bool) or not isinstance(value, int):
        return Issue("not_a_format", "format", f"{shown(value)} is not a format number; write format = {FORMAT}")
    if value > FORMAT:
        return Issue(
            "other_format",
            "format",
            f"{shown(value)} is newer than format {FORMAT}, which this GearStudio reads; update GearStudio to open the "
            "file, in which nothing was changed",
        )
    if value < FORMAT:
        return Issue("other_format", "format", f"{shown(value)} is unknown; this GearStudio reads format {FORMAT}")
    return None


def _errors_first(issues: list[Issue]) -> tuple[Issue, ...]:
    return tuple(sorted(issues, key=lambda issue: issue.severity != "error"))


def _read_fields(data: object) -> tuple[Design, list[Issue]]:
    """A design with the defaults in place of every unusable value, and an issue for each of those."""
    if not isinstance(data, Mapping):
        return Design(), [Issue("not_a_table", "", f"{shown(data)} is not a design; a design is a table of keys")]
    issues: list[Issue] = []
    tables = _plain(data, "", issues)
    try:
        return Design.model_validate(tables), issues
    except ValidationError as error:
        places = {tuple(str(key) for key in problem["loc"]) for problem in error.errors(include_url=False)}
    specs = all_field_specs()
    for place in sorted(places, key=lambda place: _file_order(".".join(place))):
        path = ".".join(place)
        value = _taken_out(tables, place)
        issues.append(field_issue(specs[path], value) if path in specs else table_issue(path, value))
    return Design.model_validate(tables), issues


def _plain(table: Mapping[Any, Any], prefix: str, issues: list[Issue]) -> dict[str, Any]:
    """A copy with known keys only; `format` aside, every other key becomes an issue."""
    known = known_keys()
    plain: dict[str, Any] = {}
    for key, value in table.items():
        path = f"{prefix}{key}" if isinstance(key, str) else f"{prefix}{shown(key)}"
        if path == "format":
            continue
        if not isinstance(key, str) or "." in key or path not in known:
            issues.append(unknown_key_issue(path))
        else:
            is_table = isinstance(value, Mapping) and path not in all_field_specs()
            plain[key] = _plain(value, f"{path}.", issues) if is_table else value
    return plain


def _taken_out(tables: dict[str, Any], place: tuple[str, ...]) -> object:
    for key in place[:-1]:
        tables = tables[key]
    return tables.pop(place[-1])


def _file_order(path: str) -> int:
    return known_keys().index(path)
