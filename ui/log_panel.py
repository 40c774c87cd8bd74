"""What the program notes while it works, in a panel: filtered by level, to be copied."""

from __future__ import annotations

import logging
from collections import deque
from typing import NamedTuple

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QFontDatabase, QGuiApplication
from PySide6.QtWidgets import (
    QComboBox,
    QDockWidget,
    QHBoxLayout,
    QLabel,
    QPlainTextEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from ui.words import tr

KEPT = 2000
LEVELS = ((logging.INFO, "Everything"), (logging.WARNING, "Warnings and errors"), (logging.ERROR, "Errors"))


class Entry(NamedTuple):
    """A line of the log with its level."""

    level: int
    text: str


class LogSource(QObject):
    """Takes log records of any thread into the window's.

    Signals
    -------
    noted(int, str)
    """

    noted = Signal(int, str)


class Listener(logging.Handler):
    """Hands log records on to a source, formatted."""

    def __init__(self, source: LogSource) -> None:
        super().__init__(logging.INFO)
        self._source = source
        self.setFormatter(logging.Formatter("%(asctime)s  %(levelname)-8s %(name)s: %(message)s", "%H:%M:%S"))

    def emit(self, record: logging.LogRecord) -> None:
        try:
            self._source.noted.emit(record.levelno, self.format(record))
        except RuntimeError:  # the window has gone
            logging.getLogger().removeHandler(self)


class LogPanel(QWidget):
    """The newest entries, the last one at the bottom."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._entries: deque[Entry] = deque(maxlen=KEPT)
        self.level = QComboBox()
        self.level.setToolTip(tr("Which entries are shown"))
        self.level.setAccessibleName(tr("Level"))
        for level, title in LEVELS:
            self.level.addItem(tr(title), level)
        self.count = QLabel()
        self.count.setProperty("role", "muted")
        self.copy = QPushButton(tr("Copy"))
        self.copy.setToolTip(tr("Copy the entries that are shown"))
        self.clear = QPushButton(tr("Clear"))
        self.clear.setToolTip(tr("Empty the panel; the log file stays"))
        self.text = QPlainTextEdit()
        self.text.setReadOnly(True)
        self.text.setMaximumBlockCount(KEPT)
        self.text.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        self.text.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.text.setAccessibleName(tr("Log"))
        self.text.setToolTip(tr("What the program noted, the newest last"))
        row = QHBoxLayout()
        row.addWidget(self.level)
        row.addWidget(self.count, 1)
        row.addWidget(self.copy)
        row.addWidget(self.clear)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 4, 8, 6)
        layout.addLayout(row)
        layout.addWidget(self.text, 1)
        self.level.currentIndexChanged.connect(lambda _index: self._fill())
        self.copy.clicked.connect(lambda: QGuiApplication.clipboard().setText(self.text.toPlainText()))
        self.clear.clicked.connect(self._on_clear)

    def add(self, level: int, text: str) -> None:
        """Append an entry."""
        self._entries.append(Entry(level, text))
        if level >= self.level.currentData():
            self.text.appendPlainText(text)
            self.text.horizontalScrollBar().setValue(0)
        self._show_count()

    def keep_state(self) -> object:
        """The entries, for `take_state`."""
        return tuple(self._entries)

    def take_state(self, state: object) -> None:
        """Begin with the entries of another panel."""
        if isinstance(state, tuple):
            self._entries.extendleft(reversed(state))
            self._fill()
            self._show_count()

    def _fill(self) -> None:
        least = self.level.currentData()
        self.text.setPlainText("\n".join(entry.text for entry in self._entries if entry.level >= least))
        bar = self.text.verticalScrollBar()
        bar.setValue(bar.maximum())

    def _on_clear(self) -> None:
        self._entries.clear()
        self.text.clear()
        self._show_count()

    def _show_count(self) -> None:
        bad = sum(entry.level >= logging.WARNING for entry in self._entries)
        self.count.setText(tr("{count} entries, {bad} warnings or errors", count=len(self._entries), bad=bad))


class LogDock(QDockWidget):
    """The panel in a dock, hidden until it is wanted; it listens from the start."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(tr("Log"), parent)
        self.setObjectName("Log")
        self.toggleViewAction().setObjectName("panels.Log")
        self.panel = LogPanel()
        self.setWidget(self.panel)
        self._source = LogSource(self)
        self._source.noted.connect(self.panel.add, Qt.ConnectionType.QueuedConnection)
        self._listener = Listener(self._source)
        logging.getLogger().addHandler(self._listener)

    def stop(self) -> None:
        """Listen no more."""
        logging.getLogger().removeHandler(self._listener)
