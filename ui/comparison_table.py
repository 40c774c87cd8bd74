"""All methods in all variants, with their deviations, side by side in a table."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QAbstractTableModel, QEvent, QItemSelectionModel, QModelIndex, Qt, Signal
from PySide6.QtGui import QBrush, QColor, QFont, QFontMetrics, QResizeEvent
from PySide6.QtWidgets import QAbstractItemView, QFrame, QHeaderView, QLabel, QTableView, QVBoxLayout, QWidget

from gearstudio.catalogue import METHOD_IDS, VARIANTS
from ui.formatting import METHOD_TITLES, MINUS, VARIANT_TITLES, micrometres, seconds, settings_text, shortcoming, span
from ui.quiet_table import LEFT, RIGHT, quieten
from ui.session import Key, Session
from ui.tables import table_text
from ui.theme import tokens
from ui.words import told, tr

if TYPE_CHECKING:
    from gearstudio.results import VariantResult


@dataclass(frozen=True)
class Column:
    """A column: its heading, what it means, how it is read from a result, and the widest text in it."""

    title: str
    tip: str
    read: Callable[[VariantResult], str]
    widest: str


def _deviation(title: str, tip: str, name: str) -> Column:
    return Column(title, tip, lambda result: micrometres(getattr(result.statistics, name)), "0.0555 nm")


COLUMNS = (
    _deviation("Max", "Largest deviation from the exact flank, over both flanks", "max_um"),
    _deviation("Mean", "Mean of the absolute deviations", "mean_um"),
    _deviation("Rms", "Root of the mean square deviation", "rms_um"),
    Column(
        "Lowest … highest",
        "Signed extremes: most metal missing, most metal added",
        lambda r: span(r.statistics.lowest_um, r.statistics.highest_um),
        f"{MINUS}0.555 … +0.555 µm",
    ),
    Column("Poles", "Control points of the surface, u × v", lambda r: f"{r.poles[0]} × {r.poles[1]}", "55 × 55"),
    Column("Degree", "Degree of the surface, u × v", lambda r: f"{r.degree[0]} × {r.degree[1]}", "9 × 9"),
    Column("Time", "Building alone, both flanks", lambda r: seconds(r.seconds), "5.55 ms"),
    Column("Settings", "What the construction took", lambda r: settings_text(r.settings), ""),
)
METHOD, VARIANT, FIRST = 0, 1, 2
CELL_PADDING, MOST_SETTINGS = 17, 400
SETTINGS = FIRST + len(COLUMNS) - 1
_Index = QModelIndex | Any


class ComparisonModel(QAbstractTableModel):
    """Rows are method and variant; the values are those of the session's member."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self.rows = tuple((method, variant) for method in METHOD_IDS for variant in VARIANTS)

    def key(self, row: int) -> Key:
        """The result that a row shows."""
        return Key(self._session.member, *self.rows[row])

    def refresh(self) -> None:
        """Everything may have changed."""
        self.dataChanged.emit(self.index(0, 0), self.index(len(self.rows) - 1, SETTINGS))

    def shortcomings(self) -> list[str]:
        """A sentence for each method that models another flank than the one wanted."""
        results = ((key.method, self._session.results.get(key)) for key in map(self.key, range(len(self.rows))))
        found = (shortcoming(method, result.settings) for method, result in results if result is not None)
        return list(dict.fromkeys(filter(None, found)))

    def rowCount(self, parent: _Index = QModelIndex()) -> int:  # noqa: B008 - Qt's signature
        return 0 if parent.isValid() else len(self.rows)

    def columnCount(self, parent: _Index = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else FIRST + len(COLUMNS)

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if orientation is not Qt.Orientation.Horizontal:
            return None
        if role == Qt.ItemDataRole.DisplayRole:
            return (tr("Method"), tr("Variant"))[section] if section < FIRST else tr(COLUMNS[section - FIRST].title)
        if role == Qt.ItemDataRole.ToolTipRole and section >= FIRST:
            return tr(COLUMNS[section - FIRST].tip)
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return _alignment(section)
        return None

    def data(self, index: _Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        key = self.key(index.row())
        if role == Qt.ItemDataRole.DisplayRole:
            return self._text(key, index.column())
        if role == Qt.ItemDataRole.ToolTipRole:
            return self._tip(key, index.column())
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return _alignment(index.column())
        if role == Qt.ItemDataRole.ForegroundRole:
            return self._brush(key, index.column())
        if role == Qt.ItemDataRole.FontRole and key in self._session.visible_keys and index.column() <= FIRST:
            font = QFont()
            font.setBold(True)
            return font
        return None

    def _text(self, key: Key, column: int) -> str:
        if column == METHOD:
            return tr(METHOD_TITLES[key.method])
        if column == VARIANT:
            return tr(VARIANT_TITLES[key.variant])
        session = self._session
        if column == SETTINGS and key in session.failures:
            return told(session.failures[key].message)
        result = session.results.get(key)
        if column == SETTINGS and key not in session.current:
            return tr("building…") if key == session.building else tr("updating…") if result else tr("waiting…")
        return COLUMNS[column - FIRST].read(result) if result else "–"

    def _tip(self, key: Key, column: int) -> str | None:
        if key in self._session.failures:
            return f"{told(self._session.failures[key].message)}\n{tr('Click to see it in the view.')}"
        result = self._session.results.get(key)
        lines = [] if result is None else [shortcoming(key.method, result.settings)]
        return "\n".join(filter(None, [*lines, self._text(key, column) if column == SETTINGS else ""])) or None

    def _brush(self, key: Key, column: int) -> QBrush | None:
        if column < FIRST:
            return None
        failure = self._session.failures.get(key)
        if failure is not None and not failure.cancelled:
            return QBrush(QColor(tokens().error))
        if column == SETTINGS:
            return QBrush(QColor(tokens().muted))
        return None if key in self._session.current else QBrush(QColor(tokens().faint))


class ComparisonTable(QWidget):
    """The table; a click on a row asks for that method and variant, several rows can be chosen to copy them.

    Signals
    -------
    row_chosen(str, str)
        Method and variant.
    """

    row_chosen = Signal(str, str)

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.model = ComparisonModel(session)
        self.view = _make_view(self.model)
        self.view.clicked.connect(self._on_activated)
        self.view.activated.connect(self._on_activated)
        card = QFrame()
        card.setProperty("role", "card")
        inside = QVBoxLayout(card)
        inside.setContentsMargins(1, 1, 1, 1)
        inside.addWidget(self.view)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(4, 0, 8, 6)
        layout.addWidget(card)
        self.note = QLabel()
        self.note.setProperty("role", "muted")
        self.note.setContentsMargins(8, 0, 0, 0)
        self.note.hide()
        layout.addWidget(self.note)
        self._fit()

    def refresh(self) -> None:
        """Show the session's results again, and below them what a method could not follow."""
        self.model.refresh()
        self._fit_settings()
        text = "; ".join(self.model.shortcomings())
        if text != self.note.text():
            self.note.setText(text)
            self.note.setVisible(bool(text))
            self._fit()

    def mark(self, method: str, variant: str) -> None:
        """Highlight the row of a method and variant; none while all three are shown."""
        selection = self.view.selectionModel()
        if (method, variant) in self.model.rows:
            index = self.model.index(self.model.rows.index((method, variant)), 0)
            flags = QItemSelectionModel.SelectionFlag.ClearAndSelect | QItemSelectionModel.SelectionFlag.Rows
            selection.select(index, flags)
        else:
            selection.clearSelection()
        self.refresh()

    def text_table(self) -> str:
        """The whole table as tab-separated text."""
        return table_text(self.view)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange) and hasattr(self, "note"):
            self._fit()

    def _fit(self) -> None:
        """Make room for every row and for the widest texts."""
        heading = self.view.horizontalHeader().sizeHint().height()
        rows = self.model.rowCount() * self.view.verticalHeader().defaultSectionSize()
        note = self.note.sizeHint().height() + self.layout().spacing() if self.note.text() else 0
        self.setFixedHeight(heading + rows + 18 + note)
        font = self.view.font()
        font.setBold(True)
        metrics = QFontMetrics(font)
        widest = [
            map(tr, METHOD_TITLES.values()),
            map(tr, VARIANT_TITLES.values()),
            *((tr(column.widest), tr(column.title)) for column in COLUMNS[:-1]),
        ]
        for column, texts in enumerate(widest):
            width = max(metrics.horizontalAdvance(text) for text in texts)
            self.view.setColumnWidth(column, width + CELL_PADDING)
        self._fit_settings()

    def _fit_settings(self) -> None:
        """The rest of the width for the last column, or as much as its texts need."""
        others = sum(self.view.columnWidth(column) for column in range(SETTINGS))
        texts = [str(self.model.index(row, SETTINGS).data()) for row in range(self.model.rowCount())]
        texts.append(tr(COLUMNS[-1].title))
        needed = max(map(self.view.fontMetrics().horizontalAdvance, texts)) + CELL_PADDING
        rest = self.view.viewport().width() - others
        self.view.setColumnWidth(SETTINGS, max(rest, min(needed, MOST_SETTINGS)))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit_settings()

    def _on_activated(self, index: QModelIndex) -> None:
        if len(self.view.selectionModel().selectedRows()) <= 1:
            self.row_chosen.emit(*self.model.rows[index.row()])


def _make_view(model: ComparisonModel) -> QTableView:
    view = QTableView()
    view.setModel(model)
    quieten(view)
    view.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    view.setSelectionMode(QAbstractItemView.SelectionMode.ContiguousSelection)
    view.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    view.setAccessibleName(tr("Comparison of all methods and variants"))
    view.setToolTip(tr("A click shows this method and variant; Ctrl+C copies the rows chosen"))
    view.verticalHeader().setDefaultSectionSize(view.fontMetrics().height() + 9)
    header = view.horizontalHeader()
    header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
    header.setMinimumSectionSize(40)
    return view


def _alignment(column: int) -> Qt.AlignmentFlag:
    return LEFT if column < FIRST or column == SETTINGS else RIGHT
