"""Exported files held against their designs again, long after they were written."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from gearstudio.catalogue import METHOD_IDS
from gearstudio.checks import FileCheck
from gearstudio.design import Design
from gearstudio.errors import FileError, GearStudioError
from gearstudio.exchange.flanks import FlankProduct
from gearstudio.exchange.record import SUFFIX, ExportRecord, Subject, checksum, read_record, record_path
from gearstudio.exchange.solids import Product
from gearstudio.formats import FORMATS
from gearstudio.kernel.cutting import Report
from gearstudio.methods.gear import ignore

MEMBERS = ("pinion", "wheel", "pair")
_OTHER_BOX = 1e-3


@dataclass(frozen=True)
class Verified:
    """A file and what is to be said of it.

    Attributes
    ----------
    path : Path
    subject : Subject or None
        What it was held against.
    check : FileCheck or None
        None where it could not be read.
    problems : tuple of str
        Empty when it is what it should be.
    """

    path: Path
    subject: Subject | None
    check: FileCheck | None
    problems: tuple[str, ...]

    def record(self) -> dict[str, Any]:
        """As a table of plain values."""
        return {
            "file": str(self.path),
            "good": not self.problems,
            "problems": list(self.problems),
            "check": None if self.check is None else self.check.record(),
        }


def product(design: Design, subject: Subject) -> Product | FlankProduct:
    """What a file should hold, able to write and to check it."""
    if subject.part == "flanks":
        return FlankProduct(design, subject.member, subject.method, subject.variant, subject.options)  # type: ignore[arg-type]
    return Product(
        design, subject.member, subject.part, subject.method, subject.variant, subject.construction, subject.options  # type: ignore[arg-type]
    )  # fmt: skip


def format_of(path: Path) -> str:
    """The format that a file's name tells; FileError when it is none that is written here."""
    word = path.suffix.lower().lstrip(".")
    known = {"stp": "step", "igs": "iges"}.get(word, word)
    if known not in FORMATS["gear"]:
        raise FileError(path, f"no known format; use {', '.join('.' + name for name in FORMATS['gear'])}")
    return known


def verify_file(path: Path, format_: str, design: Design, subject: Subject) -> Verified:
    """Hold a file against a design."""
    try:
        check = product(design, subject).check(path, format_)
    except GearStudioError as error:
        reason = error.reason if isinstance(error, FileError) else str(error)
        return Verified(path, subject, None, (reason,))
    return Verified(path, subject, check, (*_other_gear(check, subject), *check.problems()))


def verify_record(record: ExportRecord, design: Design | None = None) -> Verified:
    """Hold the file of a record against the record's design, and that against the project's if there is one."""
    if not record.path.is_file():
        return Verified(record.path, record.subject, None, ("the file is gone; its record is still there",))
    found = verify_file(record.path, record.format, record.design, record.subject)
    problems = list(found.problems)
    if checksum(record.path) != record.checksum:
        problems.insert(0, "the file is not as it was written: its checksum is another")
    if design is not None and (fields := different_fields(record.design, design)):
        problems.insert(0, f"it was made of another state of the design: {', '.join(fields)} changed since")
    return Verified(found.path, found.subject, found.check, tuple(problems))


def verify_project(folder: Path, design: Design, report: Report = ignore) -> list[Verified]:
    """Every export in a folder: those with a record by it, those that are merely named as exports by the design."""
    named = list(_named_exports(folder))
    records = sorted(folder.glob(f"*{SUFFIX}"))
    found = []
    for index, path in enumerate(records):
        report(path.name, index / (len(records) + len(named)))
        try:
            found.append(verify_record(read_record(path), design))
        except FileError as error:
            found.append(Verified(path, None, None, (error.reason,)))
    for index, (path, subject) in enumerate(named, start=len(records)):
        report(path.name, index / (len(records) + len(named)))
        found.append(verify_file(path, format_of(path), design, subject))
    return found


def different_fields(one: Design, other: Design) -> tuple[str, ...]:
    """Dotted names of the fields in which two designs differ; the design's name is none of them."""
    return tuple(_different("", one.model_dump(mode="json"), other.model_dump(mode="json")))


def _different(head: str, one: dict[str, Any], other: dict[str, Any]) -> Iterator[str]:
    for key in one:
        name = f"{head}.{key}" if head else key
        if isinstance(one[key], dict) and isinstance(other.get(key), dict):
            yield from _different(name, one[key], other[key])
        elif one[key] != other.get(key) and name != "name":
            yield name


def _named_exports(folder: Path) -> Iterator[tuple[Path, Subject]]:
    """Files called ``MEMBER-PART.EXT`` without a record."""
    for member in MEMBERS:
        for part, formats in FORMATS.items():
            for format_ in formats:
                path = folder / f"{member}-{part}.{format_}"
                if path.is_file() and not record_path(path).exists():
                    yield path, Subject(member, part, METHOD_IDS[0], "optimised")


def _other_gear(check: FileCheck, subject: Subject) -> Iterator[str]:
    """Said first where a file is so different that it must be of another gear."""
    low, high = check.box
    size = [b - a for a, b in zip(low, high, strict=True)]
    if check.box_error > _OTHER_BOX * max(*size, 1e-9):
        shown = " × ".join(f"{length:.5g}" for length in size)
        yield f"this is not the {subject.member} {subject.part} of this design: what is in it fills {shown} mm"
