"""The program's window for a benchmark."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QApplication

from ui.app import Studio, make_application
from ui.collecting import Collector
from ui.theme import Theme


@contextmanager
def opened() -> Iterator[Studio]:
    """A window being loaded, with settings of its own, that collects garbage as the program does and asks nothing."""
    application = QApplication.instance() or make_application(["gearstudio"])
    with tempfile.TemporaryDirectory() as folder:
        settings = QSettings(str(Path(folder) / "settings.ini"), QSettings.Format.IniFormat)
        studio = Studio(Theme(application), settings, data=Path(folder))
        studio.loader.finished.connect(Collector(studio).begin)
        studio.window.may_close = lambda: True
        studio.window.show()
        yield studio
        studio.window.close()
