"""A way from the rows of a table to their equations: a button at the row, its menu, Enter and double click."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QSize, Qt, Signal
from PySide6.QtGui import QAction, QMouseEvent
from PySide6.QtWidgets import QTableWidget, QToolButton

from ui import tables
from ui.theme import set_icon
from ui.words import tr

_SIZE = 20


class RowEquations(QObject):
    """Offers the equations of the row under the pointer, or of the row with the cursor.

    Signals
    -------
    asked(object)
        Keys of equations, a tuple, the nearest first.
    """

    asked = Signal(object)

    def __init__(self, table: QTableWidget, keys_of: Callable[[int], tuple[str, ...]]) -> None:
        super().__init__(table)
        self._table, self._keys_of, self._row = table, keys_of, -1
        self.button = self._make_button()
        self.action = QAction(tr("Show equation"), self)
        self.action.triggered.connect(self.ask)
        table.addAction(self.action)
        if table.contextMenuPolicy() == Qt.ContextMenuPolicy.DefaultContextMenu:
            tables.offer_copy(table)
        table.viewport().setMouseTracking(True)
        table.viewport().installEventFilter(self)
        table.installEventFilter(self)
        table.cellActivated.connect(self._on_activated)
        table.currentCellChanged.connect(self._on_current_changed)
        table.verticalScrollBar().valueChanged.connect(self._on_scrolled)

    def ask(self) -> None:
        """Ask for the equations of the row with the cursor."""
        self._ask_for(self._table.currentRow())

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """The button follows the pointer; with the focus it stands at the row with the cursor."""
        kind = event.type()
        if kind == QEvent.Type.MouseMove and isinstance(event, QMouseEvent) and watched is self._table.viewport():
            self._offer(self._table.rowAt(event.position().toPoint().y()))
        elif kind in (QEvent.Type.Leave, QEvent.Type.FocusOut, QEvent.Type.FocusIn):
            self._offer(self._table.currentRow() if self._table.hasFocus() else -1)
        elif kind == QEvent.Type.Resize:
            self._offer(self._row)
        return False

    def _make_button(self) -> QToolButton:
        button = QToolButton(self._table.viewport())
        button.setProperty("role", "row")
        button.setFixedSize(_SIZE, _SIZE)
        button.setIconSize(QSize(14, 14))
        button.setCursor(Qt.CursorShape.PointingHandCursor)
        button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        button.setAccessibleName(tr("Show equation"))
        button.setToolTip(tr("Show the equation of this row with its numbers (Enter)"))
        set_icon(button, "equation")
        button.clicked.connect(lambda: self._ask_for(self._row))
        button.hide()
        return button

    def _offer(self, row: int) -> None:
        self._row = row
        place = self._table.visualRect(self._table.model().index(row, 0))
        self.button.setVisible(row >= 0 and bool(self._keys_of(row)) and place.isValid())
        self.button.move(self._table.viewport().width() - _SIZE - 2, place.center().y() + 1 - _SIZE // 2)

    def _ask_for(self, row: int) -> None:
        keys = self._keys_of(row) if row >= 0 else ()
        if keys:
            self.asked.emit(keys)

    def _on_activated(self, row: int, _column: int) -> None:
        self._ask_for(row)

    def _on_current_changed(self, row: int, *_: int) -> None:
        if self._table.hasFocus():
            self._offer(row)

    def _on_scrolled(self, _value: int) -> None:
        self._offer(-1)
