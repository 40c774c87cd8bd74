"""The geometry data sheet as a table: grouped rows, both members side by side."""

from __future__ import annotations

import math
import re
from html import escape
from typing import TYPE_CHECKING

from PySide6.QtCore import QModelIndex, Qt, Signal
from PySide6.QtWidgets import QVBoxLayout, QWidget

from ui.formatting import MINUS, written
from ui.quiet_table import LEFT, RIGHT, RichDelegate, add_heading, cell, quiet_table
from ui.units import unit_shown, value_text
from ui.words import tr

if TYPE_CHECKING:
    from gearstudio.analysis.datasheet import DataSheet, Quantity

DECIMALS = {"mm": 4, "°": 5}
HEADS = ("Quantity", "Symbol", "Pinion", "Wheel", "Unit")


def lowered(symbol: str) -> str:
    """A symbol or formula as rich text: all that follows an underscore is an index."""
    numbered = re.sub(r"(?<!\w)([^\W\d_])([12])(?!\w)", r"\1<sub>\2</sub>", escape(symbol))
    return re.sub(r"_(\w+)", r"<sub>\1</sub>", numbered)


def shown_value(quantity: Quantity) -> str:
    """A value in the unit shown; with as many digits as the sheet has, unless the user chose."""
    if quantity.unit in DECIMALS and math.isfinite(quantity.value):
        return value_text(quantity.value, quantity.unit, DECIMALS[quantity.unit])
    return written(quantity.text).replace("-", MINUS)


class IndexDelegate(RichDelegate):
    """Paints a symbol with its index below the line."""

    def rich(self, index: QModelIndex) -> str:
        return f"<i>{lowered(index.data() or '')}</i>"


class SheetTable(QWidget):
    """The table; a change of the design changes its numbers and leaves the chosen row.

    Signals
    -------
    line_chosen(object)
        tuple of Quantity: of the pair, or of pinion and wheel.
    """

    line_chosen = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.table = quiet_table(HEADS, (74, 92, 92, 54), tr("Geometry data sheet"))
        for column in (2, 3):
            self.table.horizontalHeaderItem(column).setTextAlignment(RIGHT)
        for column in (1, 4):
            self.table.horizontalHeaderItem(column).setTextAlignment(LEFT)
        self.table.setItemDelegateForColumn(1, IndexDelegate(self.table))
        self.table.currentCellChanged.connect(lambda row, *_: self._tell(row))
        self._lines: dict[int, tuple[Quantity, ...]] = {}
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.table)

    def show_sheet(self, sheet: DataSheet) -> None:
        """Fill in the values."""
        lines = sheet.lines()
        if [line[0].key for line in lines] != [line[0].key for line in self._lines.values()]:
            self._arrange(lines)
        for row, line in zip(self._lines, lines, strict=True):
            self._lines[row] = line
        self.show_units()
        if self.table.currentRow() in self._lines:
            self._tell(self.table.currentRow())
        else:
            self.table.selectRow(next(iter(self._lines)))

    def show_units(self) -> None:
        """Show the same values in the unit that the user chose now."""
        for row, line in self._lines.items():
            for column, quantity in enumerate(line, start=2):
                self.table.item(row, column).setText(shown_value(quantity))
            self.table.item(row, 4).setText(unit_shown(line[0].unit))

    def choose(self, key: str) -> None:
        """Go to the row of a quantity."""
        for row, line in self._lines.items():
            if line[0].key == key:
                self.table.selectRow(row)
                self.table.scrollToItem(self.table.item(row, 0))

    def equations_at(self, row: int) -> tuple[str, ...]:
        """Keys of the equations that give the quantity of a row."""
        from gearstudio.equations import equations_of_quantity

        return equations_of_quantity(self._lines[row][0].key) if row in self._lines else ()

    def _arrange(self, lines: tuple[tuple[Quantity, ...], ...]) -> None:
        self.table.clearSpans()
        self._lines, row, group = {}, 0, ""
        self.table.setRowCount(len(lines) + len({line[0].group for line in lines}))
        for line in lines:
            first = line[0]
            if first.group != group:
                group = first.group
                add_heading(self.table, row, tr(group))
                row += 1
            texts = (tr(first.name), first.symbol, "", "", first.unit)
            for column, text in enumerate(texts):
                self.table.setItem(row, column, cell(text, RIGHT if column in (2, 3) else LEFT))
            self.table.item(row, 0).setToolTip(tr(first.name))
            if len(line) == 1:
                self.table.setSpan(row, 2, 1, 2)
                self.table.item(row, 2).setTextAlignment(Qt.AlignmentFlag.AlignCenter)
            self._lines[row] = line
            row += 1

    def _tell(self, row: int) -> None:
        if row in self._lines:
            self.line_chosen.emit(self._lines[row])
