"""Design files are read in a thread: to judge what one holds can take seconds."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject

from gearstudio.design import Design
from gearstudio.errors import DesignError, FileError
from ui.analysis.background import Newest

Found = Design | DesignError | FileError
"""The design of a file, or why there is none."""
Take = Callable[[Found], object]


def read(path: Path) -> Found:
    """Read a design file."""
    from gearstudio.project import load_design

    try:
        return load_design(path)
    except (DesignError, FileError) as error:
        return error


class Reading(QObject):
    """Reads the file asked for last; who asked before is not answered any more."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._asked: tuple[Path, Take] | None = None
        self._newest = Newest("open", self)
        self._newest.done.connect(self._on_done)
        self._newest.failed.connect(lambda asked, *_: self._on_done(asked, read(asked[0])))  # it fails here too

    def read(self, path: Path, take: Take) -> None:
        """Read a design file and hand over what was found."""
        self._asked = path, take
        self._newest.request(self._asked, lambda: read(path))

    def forget(self) -> None:
        """Hand over nothing of what was asked for."""
        self._asked = None
        self._newest.cancel()

    def close(self) -> None:
        """Read no more."""
        self._newest.close()

    def _on_done(self, asked: tuple[Path, Take], found: Found) -> None:
        if asked is self._asked:
            self._asked = None
            asked[1](found)
