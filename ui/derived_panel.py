"""Live table of what follows from the parameters, for both members."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING

from PySide6.QtCore import QModelIndex, Qt
from PySide6.QtGui import QPainter, QStaticText
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFrame,
    QHeaderView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from ui.formatting import fixed, subscripts

if TYPE_CHECKING:
    from gearstudio.theory.cones import MemberGeometry, PairGeometry


INDENT = 8
SYMBOL = Qt.ItemDataRole.UserRole


@dataclass(frozen=True)
class Quantity:
    """A row: title, symbol, unit, and how it is read from a member."""

    title: str
    symbol: str
    unit: str
    read: Callable[[MemberGeometry], str]


def _angle(read: Callable[[MemberGeometry], float]) -> Callable[[MemberGeometry], str]:
    return lambda member: fixed(math.degrees(read(member)), 3)


def _length(read: Callable[[MemberGeometry], float]) -> Callable[[MemberGeometry], str]:
    return lambda member: fixed(read(member), 3)


def _spiral(read: Callable[[MemberGeometry], float]) -> Callable[[MemberGeometry], str]:
    return _angle(lambda member: abs(float(member.lengthwise.spiral_angle(read(member)))))


QUANTITIES = (
    Quantity("Teeth", "z", "", lambda member: str(member.teeth)),
    Quantity("Hand of spiral", "", "", lambda member: "right" if member.hand > 0 else "left"),
    Quantity("Pitch angle", "δ", "°", _angle(lambda member: member.pitch_angle)),
    Quantity("Face angle", "δ_a", "°", _angle(lambda member: member.tip_angle)),
    Quantity("Root angle", "δ_f", "°", _angle(lambda member: member.root_angle)),
    Quantity("Base angle", "δ_b", "°", _angle(lambda member: member.base_angle)),
    Quantity("Pitch diameter, heel", "d", "mm", _length(lambda member: member.module * member.teeth)),
    Quantity("Addendum, heel", "h_a", "mm", _length(lambda member: member.addendum)),
    Quantity("Dedendum, heel", "h_f", "mm", _length(lambda member: member.dedendum)),
    Quantity("Outer cone distance", "R", "mm", _length(lambda member: member.outer_cone_distance)),
    Quantity("Mean cone distance", "R_m", "mm", _length(lambda member: member.mean_cone_distance)),
    Quantity("Face width", "B", "mm", _length(lambda member: member.face_width)),
    Quantity("Base radius, heel", "R_b", "mm", _length(lambda member: member.base_radius)),
    Quantity("Pressure angle, transv.", "α", "°", _angle(lambda member: member.transverse_pressure_angle)),
    Quantity("Spiral angle, toe", "β", "°", _spiral(lambda member: member.inner_cone_distance)),
    Quantity("Spiral angle, mean", "β_m", "°", _spiral(lambda member: member.mean_cone_distance)),
    Quantity("Spiral angle, heel", "β", "°", _spiral(lambda member: member.outer_cone_distance)),
    Quantity("Pitch to base element", "γ", "°", _angle(lambda member: member.gamma)),
    Quantity("Fillet radius, heel", "R_f", "mm", _length(lambda member: member.fillet_radius)),
)


def pair_rows(pair: PairGeometry) -> tuple[tuple[str, str, str, str], ...]:
    """Quantities of the pair as a whole: title, symbol, value, unit."""
    from gearstudio.theory.pair import overlap_ratio, transverse_contact_ratio

    across, along = transverse_contact_ratio(pair), overlap_ratio(pair)
    return (
        ("Gear ratio", "u", fixed(pair.wheel.teeth / pair.pinion.teeth, 4), ""),
        ("Mean normal module", "m_n", fixed(pair.mean_normal_module, 3), "mm"),
        ("Pressure angle, normal", "α_n", fixed(math.degrees(pair.normal_pressure_angle), 3), "°"),
        ("Transverse contact ratio", "ε_α", fixed(across, 3), ""),
        ("Overlap ratio", "ε_β", fixed(along, 3), ""),
        ("Modified contact ratio", "ε_o", fixed(math.hypot(across, along), 3), ""),
    )


class SymbolDelegate(QStyledItemDelegate):
    """Paints a title and its symbol, with the index below the line."""

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: QModelIndex) -> None:
        self.initStyleOption(option, index)
        title, symbol = option.text, index.data(SYMBOL)
        option.text = ""
        option.widget.style().drawControl(QStyle.ControlElement.CE_ItemViewItem, option, painter, option.widget)
        words = escape(title).replace(" ", "&nbsp;")
        text = QStaticText(f"{words}&nbsp;<i>{subscripts(symbol)}</i>" if symbol else words)
        text.setTextFormat(Qt.TextFormat.RichText)
        text.prepare(font=option.font)
        painter.setPen(option.palette.text().color())
        painter.setFont(option.font)
        place = option.rect.adjusted(INDENT, 0, 0, 0)
        painter.drawStaticText(place.left(), round(place.center().y() + 1 - option.fontMetrics.height() / 2), text)


class DerivedPanel(QWidget):
    """Read-only table with a column for each member."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._table = QTableWidget(0, 4)
        self._table.setHorizontalHeaderLabels(["", "Pinion", "Wheel", ""])
        self._table.verticalHeader().hide()
        self._table.verticalHeader().setDefaultSectionSize(24)
        self._table.setShowGrid(False)
        self._table.setAlternatingRowColors(True)
        self._table.setWordWrap(False)
        self._table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self._table.setSelectionMode(QAbstractItemView.SelectionMode.ContiguousSelection)
        header = self._table.horizontalHeader()
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        for column, width in ((1, 68), (2, 68), (3, 42)):
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.Fixed)
            self._table.setColumnWidth(column, width)
            self._table.horizontalHeaderItem(column).setTextAlignment(_RIGHT)
        self._table.setItemDelegateForColumn(0, SymbolDelegate(self._table))
        self._table.setAccessibleName("Derived values of both members")
        card = QFrame()
        card.setProperty("role", "card")
        inside = QVBoxLayout(card)
        inside.setContentsMargins(1, 1, 1, 4)
        inside.addWidget(self._table)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 0, 0, 4)
        layout.addWidget(card)

    def show_pair(self, pair: PairGeometry) -> None:
        """Fill in the values of a pair."""
        members = (pair.pinion, pair.wheel)
        rows = [(quantity, tuple(quantity.read(member) for member in members)) for quantity in QUANTITIES]
        shared = pair_rows(pair)
        self._table.setRowCount(len(rows) + len(shared))
        for row, (quantity, values) in enumerate(rows):
            self._put(row, 0, quantity.title, symbol=quantity.symbol)
            for column, value in enumerate(values, start=1):
                self._put(row, column, value, right=True)
            self._put(row, 3, quantity.unit)
        for row, (title, symbol, value, unit) in enumerate(shared, start=len(rows)):
            self._put(row, 0, title, symbol=symbol)
            self._put(row, 1, value, right=True)
            self._put(row, 3, unit)
            if self._table.columnSpan(row, 1) != 2:
                self._table.setSpan(row, 1, 1, 2)

    def text_table(self) -> str:
        """All values as tab-separated text."""
        cells = [[self._table.item(row, column) for column in range(4)] for row in range(self._table.rowCount())]
        return "\n".join("\t".join(map(_plain, row)) for row in cells)

    def _put(self, row: int, column: int, text: str, *, right: bool = False, symbol: str = "") -> None:
        item = self._table.item(row, column)
        if item is None:
            item = QTableWidgetItem()
            item.setTextAlignment(_RIGHT if right else Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft)
            item.setData(SYMBOL, symbol)
            self._table.setItem(row, column, item)
        if item.text() != text:
            item.setText(text)
            item.setToolTip(text)


_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


def _plain(item: QTableWidgetItem | None) -> str:
    return " ".join(filter(None, (item.text(), item.data(SYMBOL)))) if item else ""
