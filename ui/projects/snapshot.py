"""A draft as it was typed, in a file: what autosave writes and recovery reads. Plain data, no window."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

from gearstudio.errors import FileError
from gearstudio.files import read_bytes, write_text

FORMAT = 1
SUFFIX = ".json"


@dataclass(frozen=True)
class Snapshot:
    """A draft, good or not, with the name it goes by, the design file it belongs to (or None) and when it was taken."""

    title: str
    path: Path | None
    written: datetime
    draft: Mapping[str, Any]


def write_snapshot(file: Path, snapshot: Snapshot) -> None:
    """Write it whole.

    Raises
    ------
    FileError
        It cannot be written there.
    """
    data = {
        "format": FORMAT,
        "title": snapshot.title,
        "path": str(snapshot.path) if snapshot.path else None,
        "written": snapshot.written.isoformat(),
        "draft": dict(snapshot.draft),
    }
    write_text(file, json.dumps(data, ensure_ascii=False, indent=1))


def read_snapshot(file: Path) -> Snapshot:
    """Read what `write_snapshot` wrote.

    Raises
    ------
    FileError
        It is missing, damaged, or of another format.
    """
    content = read_bytes(file)
    try:
        data = json.loads(content)
        if data["format"] != FORMAT:
            raise FileError(file, f"recovery format {data['format']} is not the {FORMAT} that this program reads")
        path = Path(data["path"]) if data["path"] else None
        draft = {str(field): value for field, value in data["draft"].items()}
        return Snapshot(str(data["title"]), path, datetime.fromisoformat(data["written"]), draft)
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise FileError(file, f"this is no recovery file of GearStudio ({type(error).__name__})") from error
