"""The geometry data sheet, and the published values that the program checks itself with."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QSplitter,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from gearstudio.analysis.datasheet import DataSheet, data_sheet, sheet_text
from gearstudio.design import Design
from gearstudio.errors import FileError, GeometryError
from gearstudio.files import write_text
from ui.analysis.explanation import Explanation
from ui.analysis.published_table import PublishedTable
from ui.analysis.sheet_table import SheetTable
from ui.charts.buttons import menu_button
from ui.charts.frame import documents
from ui.formatting import written
from ui.method_bar import Segments
from ui.session import Session
from ui.words import told, tr

VIEWS = (
    ("sheet", "Both members", "Every value of the pair; a row explains itself"),
    ("published", "Published values", "What others printed, computed again"),
)
FORMATS = (("text", "Text", ".txt"), ("csv", "CSV", ".csv"), ("latex", "LaTeX", ".tex"))
TITLES = {name: title for name, title, _ in FORMATS}


class DatasheetPage(QWidget):
    """Sheet with explanations, or the published values.

    Signals
    -------
    said(str, str)
    """

    said = Signal(str, str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._sheet: DataSheet | None = None
        self._design: Design | None = None
        self._name = "design"
        self.table, self.explanation = SheetTable(), Explanation()
        self.published: PublishedTable | None = None
        self.views = Segments(VIEWS, tr("Data sheet or published values"))
        self.views.set_choice("sheet")
        self.views.chosen.connect(self.show_view)
        self.trouble = QLabel()
        self.trouble.setProperty("severity", "warning")
        self.trouble.setWordWrap(True)
        self.trouble.setContentsMargins(10, 0, 10, 4)
        self.trouble.hide()
        split = QSplitter(Qt.Orientation.Horizontal)
        split.addWidget(self.table)
        split.addWidget(self.explanation)
        split.setSizes([700, 320])
        split.setChildrenCollapsible(False)
        self._stack = QStackedWidget()
        self._stack.addWidget(split)
        head = QHBoxLayout()
        head.setContentsMargins(8, 4, 6, 4)
        head.addWidget(self.views)
        head.addStretch(1)
        choices = [(name, tr("As {format}", format=tr(title))) for name, title, _ in FORMATS]
        head.addWidget(menu_button("copy", tr("Copy the sheet"), choices, self.copy))
        head.addWidget(menu_button("save", tr("Save the sheet"), choices, self.ask_and_save))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addLayout(head)
        layout.addWidget(self.trouble)
        layout.addWidget(self._stack, 1)
        self.table.line_chosen.connect(self.explanation.explain)

    def show_session(self, session: Session) -> None:
        """Compute the sheet of the session's design, when it is another one."""
        if session.design == self._design:
            return
        self._design, self._name = session.design, session.title.removesuffix(".gear.toml")
        trouble = ""
        try:
            self._sheet = data_sheet(session.design)
        except GeometryError as error:
            trouble = tr(
                "These are the values of an earlier design; of this one there are none: {error}", error=told(error)
            )
        else:
            self.table.show_sheet(self._sheet)
        self.trouble.setText(trouble)
        self.trouble.setVisible(bool(trouble))

    def refresh_theme(self) -> None:
        """Take the colours of the theme in use."""
        self.explanation.refresh_theme()
        if self.published is not None:
            self.published.refresh_theme()

    def close_page(self) -> None:
        """Nothing runs here."""

    def show_view(self, view: str) -> None:
        """The sheet, or the published values."""
        if view == "published" and self.published is None:
            self.published = PublishedTable()
            self._stack.addWidget(self.published)
        self.views.set_choice(view)
        self._stack.setCurrentIndex(0 if view == "sheet" else 1)

    def text(self, format_: str) -> str:
        """What is in sight, in a format; the published values are text in every format."""
        if self._stack.currentIndex() == 1 and self.published is not None:
            return self.published.text_table()
        return sheet_text(self._sheet, format_) if self._sheet is not None else ""  # type: ignore[arg-type]

    def copy(self, format_: str) -> None:
        """Put the sheet on the clipboard: text as it is shown, other formats as in a file."""
        text = self.text(format_)
        published = self._stack.currentIndex() == 1
        QGuiApplication.clipboard().setText(written(text) if published or format_ == "text" else text)
        self.said.emit("info", tr("Copied the data sheet as {format}", format=tr(TITLES[format_])))

    def ask_and_save(self, format_: str) -> None:
        """Ask for a name and save."""
        suffix = next(suffix for name, _, suffix in FORMATS if name == format_)
        start = f"{documents()}/{self._name} data sheet{suffix}"
        name, _ = QFileDialog.getSaveFileName(self, tr("Save data sheet"), start, f"*{suffix}")
        if name:
            self.save(Path(name), format_)

    def save(self, path: Path, format_: str) -> None:
        """Write the sheet."""
        try:
            write_text(path, self.text(format_))
        except FileError as error:
            self.said.emit("error", tr("The data sheet was not saved: {error}", error=told(error)))
        else:
            self.said.emit("info", tr("Saved the data sheet as {path}", path=path))
