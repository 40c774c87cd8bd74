"""What keeps the window in order: log panel, memory of the CAD process, displays, settings."""

from __future__ import annotations

import logging
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QMessageBox

from ui.log_panel import LogDock
from ui.memory import MemoryGuard, memory_limit
from ui.screens import ScreenWatch
from ui.settings_file import put_aside
from ui.words import tr

if TYPE_CHECKING:
    from ui.main_window import MainWindow
    from ui.runner import JobRunner

log = logging.getLogger(__name__)
Answer = QMessageBox.StandardButton


class Upkeep(QObject):
    """Adds these to a window, before its layout is restored; ``memory`` takes another limit when it is preferred."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self.log = LogDock(window)
        window.add_low_dock(self.log)
        self.log.toggleViewAction().toggled.connect(lambda on: self.log.raise_() if on else None)
        window.commands.panels.addAction(self.log.toggleViewAction())
        self.memory = MemoryGuard(memory_limit(window.settings), self)
        self.memory.replaced.connect(self._on_replaced)
        self.screens = ScreenWatch(window)
        window.commands["reset_settings"].triggered.connect(lambda _checked=False: self.reset_settings())
        window.closing.connect(self._on_closing)

    def use_runner(self, runner: JobRunner) -> None:
        """Watch the memory of its process."""
        self.memory.use(runner)

    def reset_settings(self) -> bool:
        """Forget every setting after a question; whether that was done."""
        settings = self._window.settings
        if settings is None:
            return False
        box = QMessageBox(
            QMessageBox.Icon.Question,
            tr("Reset settings"),
            tr("Forget the layout, the list of recent files and all preferences?"),
            Answer.Reset | Answer.Cancel,
            self._window,
        )
        box.setInformativeText(tr("Designs, backups and unsaved work stay. The old settings are kept as a .bak file."))
        if box.exec() != Answer.Reset:
            return False
        settings.sync()
        kept = put_aside(Path(settings.fileName()))
        settings.clear()
        settings.sync()
        self._window.reset_layout()
        log.info("settings reset; the old ones are %s", kept or "not kept")
        words = tr("The settings are reset; some take effect when GearStudio starts again.")
        self._window.messages.show_message("info", words, str(kept or ""), topic="settings")
        return True

    def _on_replaced(self, megabytes: float) -> None:
        words = tr(
            "The CAD process had grown to {size} MB and was started anew; nothing is lost.", size=round(megabytes)
        )
        self._window.messages.show_message("info", words, topic="memory")

    def _on_closing(self) -> None:
        self.memory.stop()
        self.log.stop()
