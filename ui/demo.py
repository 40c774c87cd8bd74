"""Opens the window on a virtual screen, waits for all results, leaves a picture."""

from __future__ import annotations

import sys
from pathlib import Path

from PySide6.QtCore import QEventLoop, Qt, QTimer
from PySide6.QtWidgets import QApplication

from ui.app import Studio
from ui.screenshot import looks_blank, window_image
from ui.theme import Theme

PICTURE = "gearstudio.png"
PATIENCE_S = 180
SIZE = (1600, 960)


def run_and_leave(directory: Path, theme: Theme, design: str | None = None) -> int:
    """Save ``gearstudio.png`` of the window with all six variants built; 0, or 1 with a line on stderr."""
    directory.mkdir(parents=True, exist_ok=True)
    theme.choose(Qt.ColorScheme.Light)
    studio = Studio(theme, design=design)
    window = studio.window
    window.resize(*SIZE)
    window.reset_layout()
    window.show()
    complaint = "" if _wait_for_everything(studio) else f"not all variants were built within {PATIENCE_S} s"
    picture = window_image(window)
    grid = window.area.grid
    if not complaint and (grid is None or looks_blank(picture, grid, window)):
        complaint = "the 3D views are blank: OpenGL does not draw here"
    if not picture.save(str(directory / PICTURE)):
        complaint = f"{directory / PICTURE} could not be written"
    studio.session.mark_saved(directory, studio.session.design)
    window.close()
    print(complaint or directory / PICTURE, file=sys.stderr if complaint else sys.stdout)
    return 1 if complaint else 0


def _wait_for_everything(studio: Studio) -> bool:
    """Run events until nothing remains to be built and the views have been drawn; False when that takes too long."""
    loop = QEventLoop()
    poll = QTimer(interval=100)
    poll.timeout.connect(lambda: loop.quit() if _complete(studio) else None)
    poll.start()
    QTimer.singleShot(PATIENCE_S * 1000, loop.quit)
    loop.exec()
    poll.stop()
    for _ in range(10):
        QApplication.processEvents(QEventLoop.ProcessEventsFlag.AllEvents, 50)
    return _complete(studio)


def _complete(studio: Studio) -> bool:
    session = studio.session
    return studio.window.area.grid is not None and session.pair is not None and not session.missing_keys()
