"""The versions of a design that a user can choose from, each with its date and whether it is valid."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

from PySide6.QtCore import QDateTime, QLocale, Qt

from gearstudio.design import Design, all_field_specs
from gearstudio.errors import DesignError, FileError, GeometryError
from ui.explain import field_value_text
from ui.projects.problems import field_title, problem_line
from ui.projects.snapshot import Snapshot
from ui.session import flatten, nest
from ui.words import told, tr

NO_PATIENCE = 0.0
"""What is wrong is enough to choose by; remedies are looked for when it is opened [s]."""


@dataclass(frozen=True)
class Version:
    """One version: when it was written, its draft (None when it cannot be read) and what is wrong with it."""

    when: datetime | None
    draft: Mapping[str, Any] | None
    problems: tuple[str, ...] = ()

    @property
    def valid(self) -> bool:
        """Whether it can be built."""
        return self.draft is not None and not self.problems

    @property
    def verdict(self) -> str:
        """That in words."""
        if self.valid:
            return tr("valid")
        if self.draft is None:
            return self.problems[0] if self.problems else tr("never saved")
        if len(self.problems) == 1:
            return tr("not valid: {problem}", problem=self.problems[0])
        return tr("not valid: {count} problems", count=len(self.problems))

    @property
    def date(self) -> str:
        """When, as this user writes dates."""
        return short_date(self.when) if self.when else "–"


@dataclass(frozen=True)
class Change:
    """A field as the form calls it, and its value in two drafts, with units."""

    title: str
    before: str
    after: str

    def __str__(self) -> str:
        return f"{self.title}: {self.before} → {self.after}"


def saved_version(path: Path | None) -> Version:
    """What the design file holds."""
    from gearstudio.project import load_design

    if path is None:
        return Version(None, None)
    try:
        when = datetime.fromtimestamp(path.stat().st_mtime).astimezone()
    except OSError:
        return Version(None, None, (tr("the file is gone"),))
    try:
        design = load_design(path, NO_PATIENCE)
    except DesignError as error:
        return Version(when, None, tuple(map(problem_line, error.issues)))
    except FileError as error:
        return Version(when, None, (told(error.reason),))
    return Version(when, flatten(design), _geometry_problems(design))


def recovered_version(snapshot: Snapshot) -> Version:
    """What autosave kept; fields that this program does not know are left out, missing ones take their default."""
    from gearstudio.validation import read_design

    default = flatten(Design())
    known = {field: value for field, value in snapshot.draft.items() if field in default}
    draft = {**default, **known}
    design, issues = read_design(nest(draft), NO_PATIENCE)
    problems = tuple(problem_line(issue) for issue in issues if issue.severity == "error")
    return Version(snapshot.written, draft, problems or _geometry_problems(design or Design()))


def _geometry_problems(design: Design) -> tuple[str, ...]:
    from gearstudio.theory.cones import pair_geometry

    try:
        pair_geometry(design)
    except GeometryError as error:
        return (told(error),)
    return ()


def changed_fields(one: Mapping[str, Any] | None, other: Mapping[str, Any] | None) -> list[str]:
    """The fields in which two drafts differ, in the order of the form."""
    one, other = one or {}, other or {}
    return [field for field in {**one, **other} if one.get(field) != other.get(field)]


def changes(one: Mapping[str, Any] | None, other: Mapping[str, Any] | None) -> list[Change]:
    """What became of the fields in which two drafts differ, in the order of the form."""
    return [
        Change(field_title(field), *(_value_text(field, (draft or {}).get(field)) for draft in (one, other)))
        for field in changed_fields(one, other)
    ]


def _value_text(field: str, value: object) -> str:
    spec = all_field_specs().get(field)
    if spec is None:
        return str(value)
    return tr("empty") if value == "" else str(field_value_text(spec, value))


def short_date(when: datetime) -> str:
    """A moment as this user writes it, to the second; the year first where nobody said how."""
    moment = QDateTime.fromSecsSinceEpoch(int(when.timestamp()))
    locale, date = QLocale(), moment.date()
    nobody = locale.language() == QLocale.Language.C
    day = date.toString(Qt.DateFormat.ISODate) if nobody else locale.toString(date, QLocale.FormatType.ShortFormat)
    return f"{day} {moment.time().toString('HH:mm:ss')}"
