"""Tables go into a spreadsheet: the cells chosen, or all, as text with tabs."""

from __future__ import annotations

from PySide6.QtCore import QAbstractItemModel, QModelIndex, QPoint, Qt
from PySide6.QtGui import QGuiApplication, QKeySequence
from PySide6.QtWidgets import QAbstractItemView, QMenu, QTableView, QTreeView

from ui.formatting import MINUS
from ui.words import tr


def copy_text(view: QAbstractItemView) -> str:
    """The chosen cells of a table, row by row, with tabs; the whole table with its headings when none is chosen.

    A true minus sign becomes the one that a spreadsheet reads.
    """
    indexes = view.selectionModel().selectedIndexes() if view.selectionModel() is not None else []
    shown = [index for index in indexes if not _hidden(view, index)]
    if not shown:
        return table_text(view)
    rows, columns = sorted({i.row() for i in shown}), sorted({i.column() for i in shown})
    texts = {(i.row(), i.column()): _text(i) for i in shown}
    return "\n".join("\t".join(texts.get((row, column), "") for column in columns) for row in rows)


def table_text(view: QAbstractItemView) -> str:
    """A whole table with its headings."""
    model = view.model()
    columns = [c for c in range(model.columnCount()) if not _column_hidden(view, c)]
    head = [_clean(model.headerData(column, Qt.Orientation.Horizontal)) for column in columns]
    body = [[_text(model.index(row, column)) for column in columns] for row in _rows(view, model)]
    return "\n".join("\t".join(cells) for cells in [head, *body])


def copy(view: QAbstractItemView, *, whole: bool = False) -> None:
    """Put the chosen cells, or the whole table, on the clipboard."""
    QGuiApplication.clipboard().setText(table_text(view) if whole else copy_text(view))


def offer_copy(view: QAbstractItemView) -> None:
    """Give a table a context menu with Copy and Copy table."""
    view.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
    view.customContextMenuRequested.connect(lambda place: _show_menu(view, place))


def copy_menu(view: QAbstractItemView) -> QMenu:
    """Copy and Copy table, and what else the table offers."""
    menu = QMenu(view)
    chosen = menu.addAction(tr("Copy"))
    chosen.setShortcut(QKeySequence(QKeySequence.StandardKey.Copy))
    chosen.triggered.connect(lambda: copy(view))
    menu.addAction(tr("Copy table")).triggered.connect(lambda: copy(view, whole=True))
    menu.addActions(view.actions())
    return menu


def _show_menu(view: QAbstractItemView, place: QPoint) -> None:
    menu = copy_menu(view)
    menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    menu.popup(view.viewport().mapToGlobal(place))


def _rows(view: QAbstractItemView, model: QAbstractItemModel) -> list[int]:
    hidden = view.isRowHidden if isinstance(view, QTableView) else None
    return [row for row in range(model.rowCount()) if hidden is None or not hidden(row)]


def _hidden(view: QAbstractItemView, index: QModelIndex) -> bool:
    return _column_hidden(view, index.column()) or (isinstance(view, QTableView) and view.isRowHidden(index.row()))


def _column_hidden(view: QAbstractItemView, column: int) -> bool:
    return isinstance(view, QTableView | QTreeView) and view.isColumnHidden(column)


def _text(index: QModelIndex) -> str:
    return _clean(index.data(Qt.ItemDataRole.DisplayRole))


def _clean(value: object) -> str:
    return "" if value is None else str(value).replace(MINUS, "-").replace("\t", " ").replace("\n", " ")
