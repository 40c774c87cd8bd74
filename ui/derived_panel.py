"""Live table of what follows from the parameters, for both members."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from html import escape
from typing import TYPE_CHECKING

from PySide6.QtCore import QModelIndex, Qt
from PySide6.QtWidgets import QFrame, QTableWidgetItem, QVBoxLayout, QWidget

from ui.formatting import MINUS, fixed, subscripts
from ui.quiet_table import LEFT, RIGHT, RichDelegate, quiet_table
from ui.units import unit_shown, value_text
from ui.words import tr

if TYPE_CHECKING:
    from gearstudio.theory.cones import MemberGeometry, PairGeometry
    from gearstudio.theory.flank import FlankName


FLANK_INDENT = "\N{NO-BREAK SPACE}" * 4
SYMBOL = Qt.ItemDataRole.UserRole


@dataclass(frozen=True)
class Quantity:
    """A row: title, symbol, unit of the design, and how it is read from a member.

    ``of_flank`` says that flanks of pairs with an offset have it each of their own; ``flank`` is then whose it is, in
    a row below one without values.
    """

    title: str
    symbol: str
    unit: str
    read: Callable[[MemberGeometry], float | str]
    of_flank: bool = False
    flank: FlankName | None = None

    @property
    def name(self) -> str:
        """Title in the user's language, with the flank."""
        title = tr(self.title)
        return title if self.flank is None else tr("{quantity}, {flank}", quantity=title, flank=tr(self.flank))

    @property
    def label(self) -> str:
        """What the row begins with: the title, or below it the flank."""
        if self.flank is None:
            return tr(self.title)
        return FLANK_INDENT + (tr("concave flank") if self.flank == "concave" else tr("convex flank"))

    def text(self, member: MemberGeometry) -> str:
        """The value of a member, in the unit shown."""
        if self.of_flank and self.flank is None and member.hypoid is not None:
            return ""
        value = self.read(member if self.flank is None else _as_flank(member, self.flank))
        return tr(value) if isinstance(value, str) else str(value) if not self.unit else value_text(value, self.unit)


def _angle(read: Callable[[MemberGeometry], float]) -> Callable[[MemberGeometry], float]:
    return lambda member: math.degrees(read(member))


def _spiral(read: Callable[[MemberGeometry], float]) -> Callable[[MemberGeometry], float]:
    return _angle(lambda member: abs(float(member.lengthwise.spiral_angle(read(member)))))


QUANTITIES = (
    Quantity("Teeth", "z", "", lambda member: member.teeth),
    Quantity("Hand of spiral", "", "", lambda member: "right" if member.hand > 0 else "left"),
    Quantity("Pitch angle", "δ", "°", _angle(lambda member: member.pitch_angle)),
    Quantity("Face angle", "δ_a", "°", _angle(lambda member: member.tip_angle)),
    Quantity("Root angle", "δ_f", "°", _angle(lambda member: member.root_angle)),
    Quantity("Base angle", "δ_b", "°", _angle(lambda member: member.base_angle), of_flank=True),
    Quantity("Pitch diameter, heel", "d", "mm", lambda member: member.module * member.teeth),
    Quantity("Addendum, heel", "h_a", "mm", lambda member: member.addendum),
    Quantity("Dedendum, heel", "h_f", "mm", lambda member: member.dedendum),
    Quantity("Outer cone distance", "R", "mm", lambda member: member.outer_cone_distance),
    Quantity("Mean cone distance", "R_m", "mm", lambda member: member.mean_cone_distance),
    Quantity("Face width", "B", "mm", lambda member: member.face_width),
    Quantity("Base radius, heel", "R_b", "mm", lambda member: member.base_radius, of_flank=True),
    Quantity(
        "Pressure angle, transv.", "α", "°", _angle(lambda member: member.transverse_pressure_angle), of_flank=True
    ),
    Quantity("Spiral angle, toe", "β", "°", _spiral(lambda member: member.inner_cone_distance)),
    Quantity("Spiral angle, mean", "β_m", "°", _spiral(lambda member: member.mean_cone_distance)),
    Quantity("Spiral angle, heel", "β", "°", _spiral(lambda member: member.outer_cone_distance)),
    Quantity("Pitch to base element", "γ", "°", _angle(lambda member: member.gamma), of_flank=True),
    Quantity("Fillet radius, heel", "R_f", "mm", lambda member: member.fillet_radius),
)


def quantities(pair: PairGeometry) -> tuple[Quantity, ...]:
    """The rows of a pair: with an offset both flanks of a tooth have base cone and pressure angle of their own."""
    if not pair.has_offset:
        return QUANTITIES
    rows = [
        [quantity, replace(quantity, flank="concave"), replace(quantity, flank="convex")]
        if quantity.of_flank
        else [quantity]
        for quantity in QUANTITIES
    ]
    return tuple(row for both in rows for row in both)


def _as_flank(member: MemberGeometry, flank: FlankName) -> MemberGeometry:
    from gearstudio.theory.flank import side_of
    from gearstudio.theory.modified import flank_member

    return flank_member(member, side_of(member.hand, flank))


def pair_rows(pair: PairGeometry) -> tuple[tuple[str, str, str, str], ...]:
    """Quantities of the pair as a whole: title, symbol, value, unit."""
    from gearstudio.theory.pair import overlap_ratio, transverse_contact_ratio

    across, along = transverse_contact_ratio(pair), overlap_ratio(pair)
    return (
        (tr("Gear ratio"), "u", fixed(pair.wheel.teeth / pair.pinion.teeth, 4), ""),
        (tr("Mean normal module"), "m_n", value_text(pair.mean_normal_module, "mm"), unit_shown("mm")),
        (tr("Pressure angle, normal"), "α_n", value_text(math.degrees(pair.normal_pressure_angle), "°"), "°"),
        (tr("Transverse contact ratio"), "ε_α", fixed(across, 3), ""),
        (tr("Overlap ratio"), "ε_β", fixed(along, 3), ""),
        (tr("Modified contact ratio"), "ε_o", fixed(math.hypot(across, along), 3), ""),
    )


class SymbolDelegate(RichDelegate):
    """Paints a title and its symbol, with the index below the line."""

    def rich(self, index: QModelIndex) -> str:
        title, symbol = escape(index.data() or "").replace(" ", "&nbsp;"), index.data(SYMBOL)
        return f"{title}&nbsp;<i>{subscripts(symbol)}</i>" if symbol else title


class DerivedPanel(QWidget):
    """Read-only table with a column for each member."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._pair: PairGeometry | None = None
        self.view = quiet_table(("", "Pinion", "Wheel", ""), (68, 68, 42), tr("Derived values of both members"))
        for column in (1, 2, 3):
            self.view.horizontalHeaderItem(column).setTextAlignment(RIGHT)
        self.view.setItemDelegateForColumn(0, SymbolDelegate(self.view))
        self.view.setToolTip(tr("What follows from the parameters"))
        card = QFrame()
        card.setProperty("role", "card")
        inside = QVBoxLayout(card)
        inside.setContentsMargins(1, 1, 1, 4)
        inside.addWidget(self.view)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 0, 0, 4)
        layout.addWidget(card)

    def show_pair(self, pair: PairGeometry) -> None:
        """Fill in the values of a pair."""
        self._pair = pair
        members = (pair.pinion, pair.wheel)
        rows = [(quantity, tuple(quantity.text(member) for member in members)) for quantity in quantities(pair)]
        shared = pair_rows(pair)
        if self.view.rowCount() != len(rows) + len(shared):
            self.view.clearSpans()
            self.view.setRowCount(0)
            self.view.setRowCount(len(rows) + len(shared))
        for row, (quantity, values) in enumerate(rows):
            self._put(row, 0, quantity.label, symbol=quantity.symbol)
            for column, value in enumerate(values, start=1):
                self._put(row, column, value, right=True)
            self._put(row, 3, unit_shown(quantity.unit) if values[0] else "")
        for row, (title, symbol, value, unit) in enumerate(shared, start=len(rows)):
            self._put(row, 0, tr(title), symbol=symbol)
            self._put(row, 1, value, right=True)
            self._put(row, 3, unit)
            if self.view.columnSpan(row, 1) != 2:
                self.view.setSpan(row, 1, 1, 2)

    def show_units(self) -> None:
        """Show the same values in the unit that the user chose now."""
        if self._pair is not None:
            self.show_pair(self._pair)

    def text_table(self) -> str:
        """All values as tab-separated text."""
        cells = [[self.view.item(row, column) for column in range(4)] for row in range(self.view.rowCount())]
        head = (tr("Quantity"), tr("Pinion"), tr("Wheel"), tr("Unit"))
        return "\n".join("\t".join(row) for row in [head, *(map(_plain, row) for row in cells)])

    def _put(self, row: int, column: int, text: str, *, right: bool = False, symbol: str = "") -> None:
        item = self.view.item(row, column)
        if item is None:
            item = QTableWidgetItem()
            item.setTextAlignment(RIGHT if right else LEFT)
            item.setData(SYMBOL, symbol)
            self.view.setItem(row, column, item)
        if item.text() != text:
            item.setText(text)
            item.setToolTip(text)


def _plain(item: QTableWidgetItem | None) -> str:
    return " ".join(filter(None, (item.text(), item.data(SYMBOL)))).replace(MINUS, "-") if item else ""
