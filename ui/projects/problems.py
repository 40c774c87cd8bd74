"""What a user is told of a design file that could not be opened."""

from __future__ import annotations

from pathlib import Path

from gearstudio.errors import DesignError, FileError
from ui.words import told, tr


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


def _line(path: Path, problem: object) -> str:
    return tr("{name} was not opened: {problem}", name=path.name, problem=told(problem))
