"""A chart with a row of controls over it, and the means to copy and save it."""

from __future__ import annotations

from pathlib import Path
from typing import Protocol

from PySide6.QtCore import QDir, QSize, QStandardPaths, Qt, Signal
from PySide6.QtGui import QContextMenuEvent, QGuiApplication, QPainter, QPaintEvent
from PySide6.QtWidgets import QFileDialog, QHBoxLayout, QLabel, QSizePolicy, QVBoxLayout, QWidget

from gearstudio.errors import FileError
from ui.charts.buttons import tool_button
from ui.charts.export import FILTERS, Paint, clipboard_data, save
from ui.charts.flow import FlowRow
from ui.charts.menu import chart_menu
from ui.charts.records import Table
from ui.words import noted, told, tr

LEAST_LETTERS = 8
COPIED = {
    "both": noted("Copied the chart: picture and numbers"),
    "picture": noted("Copied the picture of the chart"),
    "numbers": noted("Copied the numbers of the chart; paste them into a spreadsheet"),
}


def documents() -> str:
    """The folder in which a dialog for files begins."""
    return QStandardPaths.writableLocation(QStandardPaths.StandardLocation.DocumentsLocation) or QDir.homePath()


class Drawable(Protocol):
    """A widget that shows a chart."""

    @property
    def paint(self) -> Paint: ...
    @property
    def table(self) -> Table: ...
    @property
    def name(self) -> str: ...
    def size(self) -> QSize: ...


class _Hint(QLabel):
    """Words in a line, or in two; they end in an ellipsis where that is too little, and are left out where hardly
    any of them can be shown."""

    def paintEvent(self, event: QPaintEvent) -> None:
        metrics, text = self.fontMetrics(), self.text()
        if self.width() < metrics.averageCharWidth() * LEAST_LETTERS:
            return
        flags = Qt.AlignmentFlag.AlignVCenter | Qt.TextFlag.TextWordWrap
        wrapped = metrics.boundingRect(self.rect(), flags, text)
        if wrapped.height() > self.height() or wrapped.width() > self.width():
            text = metrics.elidedText(text, Qt.TextElideMode.ElideRight, self.width())
        with QPainter(self) as painter:
            self.style().drawItemText(painter, self.rect(), flags, self.palette(), True, text, self.foregroundRole())


class ChartFrame(QWidget):
    """A chart under a title or controls, with Copy and Save at the right end.

    Signals
    -------
    said(str, str)
        Severity and a line for the user: what was saved, or why not.
    """

    said = Signal(str, str)

    def __init__(self, chart: QWidget, title: str = "", parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.chart: Drawable = chart  # type: ignore[assignment]
        self.head = QHBoxLayout()
        self.head.setContentsMargins(8, 4, 6, 0)
        self.head.setSpacing(8)
        self.title = QLabel(title)
        self.title.setProperty("role", "section")
        self._controls = FlowRow()
        self._controls.add(self.title)
        self.title.setVisible(bool(title))
        self.head.addWidget(self._controls, 1000)
        self.hint = _Hint()
        self.hint.setProperty("role", "muted")
        self.hint.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.head.addWidget(self.hint, 1)
        self.head.addWidget(tool_button("copy", tr("Copy the picture and the numbers"), self.copy))
        self.head.addWidget(tool_button("save", tr("Save as PNG, SVG or CSV…"), self.ask_and_save))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addLayout(self.head)
        layout.addWidget(chart, 1)

    def add_control(self, widget: QWidget) -> None:
        """Put a control in the row, before the hint."""
        self._controls.add(widget)

    def set_hint(self, text: str) -> None:
        """A line beside the controls; cut off where there is no room, whole in its tip."""
        self.hint.setText(text)
        self.hint.setToolTip(text)

    def copy(self, what: str = "both") -> None:
        """Put the picture, the numbers or both on the clipboard."""
        chart = self.chart
        data = clipboard_data(chart.size(), chart.paint, chart.table.shown().text("\t"), what)
        QGuiApplication.clipboard().setMimeData(data)
        self.said.emit("info", tr(COPIED[what]))

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        view_all = getattr(self.chart, "view_all", None)
        chart_menu(self, view_all, self.copy, self.ask_and_save).popup(event.globalPos())

    def ask_and_save(self) -> None:
        """Ask for a name and save."""
        start = f"{documents()}/{self.chart.name}.png"
        name, _ = QFileDialog.getSaveFileName(self, tr("Save chart"), start, tr(FILTERS))
        if name:
            self.save(Path(name))

    def save(self, path: Path) -> None:
        """Save as the name's ending says."""
        chart = self.chart
        try:
            written = save(path, chart.size(), chart.paint, chart.table.text(), chart.name)
        except FileError as error:
            self.said.emit("error", tr("The chart was not saved: {error}", error=told(error)))
        else:
            self.said.emit("info", tr("Saved the chart as {written}", written=written))
