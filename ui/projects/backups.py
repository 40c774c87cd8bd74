"""Copies of the last saves of every design, away from the design's own folder. Plain files, no window."""

from __future__ import annotations

import contextlib
import hashlib
import os
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from gearstudio.errors import FileError
from gearstudio.files import named_errors, read_bytes, write_bytes, write_text

KEPT = 10
SUFFIX = ".gear.toml"
ORIGIN = "origin.txt"
STAMP = "%Y-%m-%dT%H-%M-%S-%f"


@dataclass(frozen=True)
class Backup:
    """A copy, and when it was saved."""

    file: Path
    when: datetime


class Backups:
    """The backups in a folder: one folder in it for each design file, with the newest `kept` different saves."""

    def __init__(self, folder: Path, kept: int = KEPT) -> None:
        self._folder, self._kept = folder, kept

    def keep(self, path: Path) -> None:
        """Copy what a design file holds now; nothing is done when the newest copy is the same.

        Raises
        ------
        FileError
            It cannot be read, or not be copied.
        """
        content = read_bytes(path)
        known = self.of(path)
        if known and _content(known[0].file) == content:
            return
        place = self._place(path)
        with named_errors(place):
            place.mkdir(parents=True, exist_ok=True)
        write_text(place / ORIGIN, _key(path))
        write_bytes(place / f"{datetime.now(UTC).strftime(STAMP)}{SUFFIX}", content)
        for old in self.of(path)[self._kept :]:
            with contextlib.suppress(OSError):
                old.file.unlink()

    def of(self, path: Path) -> list[Backup]:
        """The copies of a design file, the newest first."""
        return _listed(self._place(path))

    def designs(self) -> list[Path]:
        """The design files that have copies, whether they still exist or not; the last saved first."""
        found: list[tuple[datetime, Path]] = []
        for origin in self._folder.glob(f"*/{ORIGIN}"):
            with contextlib.suppress(OSError, UnicodeDecodeError):
                copies = _listed(origin.parent)
                if copies:
                    found.append((copies[0].when, Path(origin.read_text(encoding="utf-8"))))
        return [path for _, path in sorted(found, reverse=True)]

    def _place(self, path: Path) -> Path:
        digest = hashlib.sha256(_key(path).encode("utf-8", "surrogateescape")).hexdigest()[:12]
        return self._folder / f"{path.name.removesuffix(SUFFIX)[:60]}-{digest}"


def _listed(place: Path) -> list[Backup]:
    copies = []
    for file in place.glob(f"*{SUFFIX}"):
        with contextlib.suppress(ValueError):
            moment = datetime.strptime(file.name.removesuffix(SUFFIX), STAMP).replace(tzinfo=UTC)
            copies.append(Backup(file, moment.astimezone()))
    return sorted(copies, key=lambda copy: copy.when, reverse=True)


def _content(file: Path) -> bytes | None:
    try:
        return read_bytes(file)
    except FileError:
        return None


def _key(path: Path) -> str:
    return os.path.realpath(path)
