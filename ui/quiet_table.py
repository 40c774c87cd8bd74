"""Tables to be read: without grid, without editing, with rich text where a symbol has an index."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QModelIndex, Qt
from PySide6.QtGui import QFont, QPainter, QStaticText
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
    QTableWidget,
    QTableWidgetItem,
)

from ui.words import tr

LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
ROW_HEIGHT = 24
_INDENT = 8
_NARROWEST = 0.8
"""Words that are too wide for their column are drawn as narrow as this before they are cut."""


def quieten(table: QTableView) -> None:
    """Rows without numbers, grid and editing, a little darker in turn; Tab leaves the table."""
    table.verticalHeader().hide()
    table.verticalHeader().setDefaultSectionSize(ROW_HEIGHT)
    table.horizontalHeader().setHighlightSections(False)
    table.setShowGrid(False)
    table.setAlternatingRowColors(True)
    table.setWordWrap(False)
    table.setTabKeyNavigation(False)
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)


def quiet_table(heads: Sequence[str], widths: Sequence[int], name: str) -> QTableWidget:
    """A table to be read; the first column takes what room is left by the others."""
    table = QTableWidget(0, len(heads))
    quieten(table)
    table.setHorizontalHeaderLabels([tr(head) for head in heads])
    table.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    table.setAccessibleName(name)
    header = table.horizontalHeader()
    header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
    table.horizontalHeaderItem(0).setTextAlignment(LEFT)
    for column, width in enumerate(widths, start=1):
        header.setSectionResizeMode(column, QHeaderView.ResizeMode.Fixed)
        table.setColumnWidth(column, width)
    return table


def cell(text: str, alignment: Qt.AlignmentFlag = LEFT, *, bold: bool = False) -> QTableWidgetItem:
    """A cell of such a table."""
    item = QTableWidgetItem(text)
    item.setTextAlignment(alignment)
    if bold:
        font = QFont()
        font.setBold(True)
        item.setFont(font)
    return item


def add_heading(table: QTableWidget, row: int, text: str) -> None:
    """A row that names the group of the rows below it; it cannot be chosen."""
    item = cell(text, bold=True)
    item.setFlags(Qt.ItemFlag.ItemIsEnabled)
    table.setItem(row, 0, item)
    table.setSpan(row, 0, 1, table.columnCount())


class RichDelegate(QStyledItemDelegate):
    """Paints a column in rich text, which items of a table do not know."""

    def rich(self, index: QModelIndex) -> str:
        """What a cell shows, as rich text."""
        raise NotImplementedError

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: QModelIndex) -> None:
        self.initStyleOption(option, index)
        option.text = ""
        option.widget.style().drawControl(QStyle.ControlElement.CE_ItemViewItem, option, painter, option.widget)
        text = QStaticText(self.rich(index))
        text.setTextFormat(Qt.TextFormat.RichText)
        text.prepare(font=option.font)
        painter.save()
        painter.setPen(option.palette.text().color())
        painter.setFont(option.font)
        painter.setClipRect(option.rect)
        top = round(option.rect.center().y() + 1 - option.fontMetrics.height() / 2)
        painter.translate(option.rect.left() + _INDENT, top)
        painter.scale(min(max((option.rect.width() - _INDENT) / text.size().width(), _NARROWEST), 1.0), 1.0)
        painter.drawStaticText(0, 0, text)
        painter.restore()
