"""The family of errors a user may meet, and the record of one problem in a design."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

Severity = Literal["error", "warning"]


@dataclass(frozen=True)
class Issue:
    """One problem of a design, tied to the field that a user can change.

    Attributes
    ----------
    code : str
        Stable short name, for tests and translations (``"below_minimum"``).
    field : str
        Dotted name of the design file's key (``"pair.pinion_teeth"``); empty for the file as a whole.
    message : str
        What is wrong, with the value and the limit, and what to do about it.
    severity : {"error", "warning"}
    """

    code: str
    field: str
    message: str
    severity: Severity = "error"

    def __str__(self) -> str:
        return f"{self.field}: {self.message}" if self.field else self.message


class GearStudioError(Exception):
    """Anything that is expected to go wrong; its text is fit for a user."""


class DesignError(GearStudioError):
    """A design that cannot be used; carries every problem found, and the path of its file where it has one."""

    def __init__(self, issues: Sequence[Issue], path: object = "") -> None:
        self.issues, self.path = tuple(issues), str(path)
        super().__init__("\n".join(str(issue) for issue in self.issues))

    def __reduce__(self) -> tuple[type, tuple[tuple[Issue, ...], str]]:
        return type(self), (self.issues, self.path)


class GeometryError(GearStudioError):
    """An argument outside the range in which the geometry exists."""


class FieldError(GeometryError):
    """A geometry that cannot be made; ``field`` is the name of the entry to change."""

    def __init__(self, field: str, message: str) -> None:
        self.field, self.reason = field, message
        super().__init__(message)

    def __reduce__(self) -> tuple[type, tuple[str, str]]:
        return type(self), (self.field, self.reason)


class ModellingError(GearStudioError):
    """A construction that the CAD kernel could not make."""

    def __init__(self, method: str, stage: str, reason: str) -> None:
        self.method, self.stage, self.reason = method, stage, reason
        super().__init__(f"{method}: {stage} failed: {reason}")

    def __reduce__(self) -> tuple[type, tuple[str, str, str]]:
        return type(self), (self.method, self.stage, self.reason)


class FileError(GearStudioError):
    """A file that could not be read or written."""

    def __init__(self, path: object, reason: str) -> None:
        self.path, self.reason = str(path), reason
        super().__init__(f"{self.path}: {reason}")

    def __reduce__(self) -> tuple[type, tuple[str, str]]:
        return type(self), (self.path, self.reason)
