"""Files that are dropped on the window: designs are opened, points are measured."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QMimeData, QObject

from ui.projects.windows import open_window

if TYPE_CHECKING:
    from ui.analysis.area import AnalysisArea

DESIGN = ".toml"
POINTS = (".csv", ".dat", ".txt", ".asc", ".ibl")
PAGE = "measurement"


def dropped_files(data: QMimeData) -> tuple[Path | None, tuple[Path, ...]]:
    """The first design of a drop, and what else of it can be used."""
    paths = [Path(url.toLocalFile()) for url in data.urls() if url.isLocalFile()]
    design = next((path for path in paths if path.suffix.lower() == DESIGN), None)
    others = tuple(path for path in paths if path != design and path.suffix.lower() in (DESIGN, *POINTS))
    return design, others


class Drops(QObject):
    """Takes points to the measurement page, now or when it can be made, and further designs to windows of their own."""

    def __init__(self, analysis: AnalysisArea, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._analysis = analysis
        self._waiting: Path | None = None
        analysis.page_made.connect(lambda _page: self._measure())

    def take(self, paths: tuple[Path, ...]) -> None:
        """Put files where they belong; of several point files the first is measured."""
        for path in paths:
            if path.suffix.lower() == DESIGN:
                open_window(str(path))
            elif self._waiting is None:
                self._waiting = path
        if self._waiting is not None:
            self._analysis.show_tab(PAGE)
            self._measure()

    def _measure(self) -> None:
        page = self._analysis.pages.get(PAGE)
        if page is not None and self._waiting is not None:
            path, self._waiting = self._waiting, None
            page.open_path(path)  # type: ignore[attr-defined]
