"""The design that is open beside another one: parameters and derived values, with their differences."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QComboBox,
    QDialog,
    QFileDialog,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from gearstudio.presets import PRESETS
from ui.analysis.background import Newest
from ui.projects.differences import Line, as_text, differences
from ui.session import Session
from ui.words import told, tr

RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
NOTHING, MOST_WIDTH = -1, 260


class CompareDialog(QDialog):
    """A window beside the main one that follows its design; the other design is a preset or a file."""

    def __init__(self, session: Session, recent: tuple[Path, ...], folder: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Compare designs"))
        self.resize(1000, 600)
        self._session, self._folder = session, folder
        self.lines: tuple[Line, ...] = ()
        self._work = Newest("comparison of designs", self)
        self.other = QComboBox()
        self.other.setToolTip(tr("The design to compare with"))
        self.other.setAccessibleName(tr("Other design"))
        for preset in PRESETS:
            self.other.addItem(tr(preset.title), preset.design)
        for path in recent:
            if path.is_file() and path != session.path:
                self.other.addItem(path.name, path)
                self.other.setItemData(self.other.count() - 1, str(path), Qt.ItemDataRole.ToolTipRole)
        self.other.setCurrentIndex(NOTHING)
        self.other.setPlaceholderText(tr("Choose a design"))
        self.browse = QPushButton(tr("&Open…"))
        self.browse.setToolTip(tr("Compare with the design of a file"))
        self.only = QCheckBox(tr("&Differences only"))
        self.only.setToolTip(tr("Leave out what both designs have in common"))
        self.only.setChecked(True)
        self.copy = QPushButton(tr("&Copy"))
        self.copy.setToolTip(tr("Copy the table for a spreadsheet"))
        self.words = QLabel(tr("Choose a design to compare with the one that is open."))
        self.words.setWordWrap(True)
        self.table = _table()
        self._arrange()
        self.other.activated.connect(lambda _index: self._request())
        self.browse.clicked.connect(self._ask)
        self.only.toggled.connect(lambda _on: self._fill())
        self.copy.clicked.connect(lambda: QGuiApplication.clipboard().setText(as_text(self._shown())))
        self._work.done.connect(self._on_done)
        self._work.failed.connect(self._on_failed)
        session.design_changed.connect(self._on_design_changed)
        self.finished.connect(self._on_finished)

    def compare_with(self, path: Path) -> None:
        """Show the differences to the design of a file."""
        self.other.addItem(path.name, path)
        self.other.setCurrentIndex(self.other.count() - 1)
        self._request()

    def keep_state(self) -> tuple[object, bool]:
        """The design or the path that is chosen (None at first), and whether differences alone are shown."""
        return self.other.currentData(), self.only.isChecked()

    def take_state(self, state: tuple[object, bool]) -> None:
        """Compare with the same."""
        chosen, only = state
        self.only.setChecked(only)
        known = (index for index in range(self.other.count()) if self.other.itemData(index) == chosen)
        index = next(known, NOTHING)
        if index == NOTHING and isinstance(chosen, Path):
            self.compare_with(chosen)
        elif index != NOTHING:
            self.other.setCurrentIndex(index)
            self._request()

    def _arrange(self) -> None:
        row = QHBoxLayout()
        row.addWidget(self.other, 1)
        for widget in (self.browse, self.only, self.copy):
            row.addWidget(widget)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 16, 16, 12)
        layout.setSpacing(10)
        layout.addLayout(row)
        layout.addWidget(self.words)
        layout.addWidget(self.table, 1)

    def _ask(self) -> None:
        from ui.files import FILTER

        name, _ = QFileDialog.getOpenFileName(self, tr("Compare with design"), self._folder, tr(FILTER))
        if name:
            self.compare_with(Path(name))

    def _on_design_changed(self, _design: object) -> None:
        self._request()

    def _request(self) -> None:
        first, chosen = self._session.design, self.other.currentData()
        if self.other.currentIndex() == NOTHING:
            return

        def work() -> tuple[Line, ...]:
            from gearstudio.project import load_design

            return differences(first, load_design(chosen) if isinstance(chosen, Path) else chosen)

        self._work.request((self.other.currentText(), first), work)

    def _on_done(self, label: object, lines: tuple[Line, ...]) -> None:
        self.lines = lines
        self._fill()

    def _on_failed(self, _label: object, text: str, _details: str) -> None:
        self.lines = ()
        self._fill()
        self.words.setText(tr("The designs cannot be compared: {reason}", reason=told(text.partition("\n")[0])))

    def _shown(self) -> tuple[Line, ...]:
        return tuple(line for line in self.lines if line.differs or not self.only.isChecked())

    def _fill(self) -> None:
        shown = self._shown()
        count = sum(line.differs for line in self.lines)
        self.words.setText(
            tr("{count} of {all} values differ; the difference is other minus this.", count=count, all=len(self.lines))
        )
        self.table.horizontalHeader().show()
        self.table.setHorizontalHeaderLabels(
            [tr("Quantity"), tr("Unit"), self._session.title, self.other.currentText(), tr("Difference"), tr("Group")]
        )
        self.table.setRowCount(len(shown))
        for row, line in enumerate(shown):
            texts = (line.name, line.unit, line.first, line.second, line.difference, line.group)
            for column, text in enumerate(texts):
                item = QTableWidgetItem(text)
                item.setTextAlignment(RIGHT if column in (2, 3, 4) else LEFT)
                item.setToolTip(text)
                self.table.setItem(row, column, item)
        for column in (2, 3):
            width = max(self.table.sizeHintForColumn(column), self.table.horizontalHeader().sectionSizeHint(column))
            self.table.setColumnWidth(column, min(width, MOST_WIDTH))

    def _on_finished(self, _result: int) -> None:
        self._session.design_changed.disconnect(self._on_design_changed)
        self._work.close()


def _table() -> QTableWidget:
    table = QTableWidget(0, 6)
    table.setAccessibleName(tr("Differences"))
    table.setToolTip(tr("Parameters and derived values of both designs"))
    table.verticalHeader().hide()
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    table.setWordWrap(False)
    head = table.horizontalHeader()
    head.hide()
    head.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
    for column, width in enumerate((230, 64, 130, 130, 100)):
        table.setColumnWidth(column, width)
    head.setStretchLastSection(True)
    return table
