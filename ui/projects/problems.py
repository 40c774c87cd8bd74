"""What a user is told of designs and files with problems."""

from __future__ import annotations

from pathlib import Path

from gearstudio.design import all_field_specs
from gearstudio.errors import DesignError, FileError, Issue
from ui.explain import problem_text
from ui.words import retold, told, tr


def not_opened(path: Path, error: DesignError | FileError) -> tuple[str, str]:
    """One line that names the file once, and for Details where it is and everything that is wrong with it."""
    if isinstance(error, FileError):
        return _line(path, error.reason), f"{path}\n{told(error.reason)}"
    details = "\n".join((str(path), *map(told, error.issues)))
    if len(error.issues) == 1:
        return _line(path, error.issues[0]), details
    text = tr(
        "{name} was not opened: it has {count} problems, the first at {problem}",
        name=path.name,
        count=len(error.issues),
        problem=told(error.issues[0]),
    )
    return text, details


@retold
def field_title(field: str) -> str:
    """The name of a field as the form shows it, with the group it stands in."""
    spec = all_field_specs().get(field)
    if spec is None:
        return field
    return tr(spec.title) if spec.title == spec.group else f"{tr(spec.title)} ({tr(spec.group)})"


@retold
def problem_line(issue: Issue) -> str:
    """A problem of a draft, with its field as the form shows it; one of a file as a whole as it is."""
    spec = all_field_specs().get(issue.field)
    if spec is None:
        return str(told(issue))
    return f"{field_title(issue.field)}: {problem_text(issue.message, spec)}"


def _line(path: Path, problem: object) -> str:
    return tr("{name} was not opened: {problem}", name=path.name, problem=told(problem))
