"""What an export was made of and what was found in it, kept beside it as ``NAME.EXT.check.json``."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

from gearstudio import __version__
from gearstudio.catalogue import METHOD_IDS, VARIANTS
from gearstudio.checks import FileCheck
from gearstudio.design import FORMAT, Design
from gearstudio.errors import FileError
from gearstudio.files import read_bytes, write_text
from gearstudio.formats import FORMATS, USUAL, ExportOptions
from gearstudio.validation import read_design

SUFFIX = ".check.json"
RECORD_FORMAT = 1
_LARGEST = 20_000_000


@dataclass(frozen=True)
class Subject:
    """What a file was made of, besides the design."""

    member: str
    part: str
    method: str
    variant: str
    construction: str = "assemble"
    options: ExportOptions = USUAL


@dataclass(frozen=True)
class ExportRecord:
    """A record as it was read: the file it is about, its checksum when it was written, what it was made of."""

    path: Path
    format: str
    checksum: str
    design: Design
    subject: Subject


def record_path(path: Path) -> Path:
    """Where the record of an exported file is kept."""
    return path.with_name(path.name + SUFFIX)


def checksum(path: Path) -> str:
    """SHA-256 of a file; FileError when it cannot be read."""
    return hashlib.sha256(read_bytes(path)).hexdigest()


def write_record(path: Path, format_: str, design: Design, subject: Subject, check: FileCheck) -> Path:
    """Keep what was found in an exported file beside it; the record's path. FileError when it cannot be written."""
    target = record_path(path)
    data = {
        "format": RECORD_FORMAT,
        "program": f"GearStudio {__version__}",
        "written": datetime.now().astimezone().isoformat(timespec="seconds"),
        "file": path.name,
        "file_format": format_,
        "size": path.stat().st_size,
        "sha256": checksum(path),
        "member": subject.member,
        "part": subject.part,
        "method": subject.method,
        "variant": subject.variant,
        "construction": subject.construction,
        "options": subject.options.record(),
        "design": {"format": FORMAT, **design.model_dump(mode="json", exclude_none=True)},
        "check": check.record(),
    }
    write_text(target, json.dumps(data, indent=1, ensure_ascii=False) + "\n")
    return target


def read_record(path: Path) -> ExportRecord:
    """Read a record; FileError when it is none, or was damaged."""
    content = read_bytes(path)
    try:
        if len(content) > _LARGEST:
            raise ValueError("too large")
        return _parsed(path, json.loads(content))
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise FileError(path, "this is no record of an export, or a damaged one; export again") from error


def _parsed(path: Path, data: Mapping[str, Any]) -> ExportRecord:
    if data["format"] != RECORD_FORMAT:
        raise ValueError("of another version")
    design, _ = read_design(dict(data["design"]))
    subject = Subject(
        data["member"],
        data["part"],
        data["method"],
        data["variant"],
        data["construction"],
        ExportOptions.from_record(data["options"]),
    )
    known = subject.method in METHOD_IDS and subject.variant in VARIANTS
    if design is None or not known or data["file_format"] not in FORMATS[subject.part]:
        raise ValueError("of what this program does not know")
    name = str(data["file"])
    if Path(name).name != name:
        raise ValueError("not beside the file")
    return ExportRecord(path.with_name(name), data["file_format"], str(data["sha256"]), design, subject)
