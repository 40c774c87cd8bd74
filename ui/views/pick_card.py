"""The card of a picked point: where it is, and what every method and theory are like there."""

from __future__ import annotations

import math
from html import escape
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, QPoint, Qt, Signal
from PySide6.QtGui import QFont, QGuiApplication, QMouseEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QToolButton, QVBoxLayout, QWidget

from gearstudio.catalogue import METHOD_IDS, VARIANTS
from ui import colormap, units
from ui.formatting import MEMBER_TITLES, METHOD_TITLES, VARIANT_TITLES, fixed, number
from ui.session import Key
from ui.theme import set_icon
from ui.view_overlay import PaneTitle
from ui.views.quantities import CURVATURES, Quantity
from ui.words import inline, tr

if TYPE_CHECKING:
    from gearstudio.analysis.probe import Curvature, Probe
    from ui.picking import Hover
    from ui.views.picks import PickedValues

MARGIN = 10
_SYMBOLS = {"gaussian": "K", "mean": "H", "largest": "κ₁", "smallest": "κ₂"}


class PickCard(QFrame):
    """Lies in the lower right corner of the views.

    Signals
    -------
    close_wanted()
    """

    close_wanted = Signal()

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setProperty("role", "card")
        self.setAccessibleName(tr("Values at the picked point"))
        self._unit = "auto"
        self._shown: tuple[Hover, PickedValues] | None = None
        self._marker_y = 0.0
        self._grip: QPoint | None = None
        self._moved_to: QPoint | None = None
        self.setToolTip(tr("Drag the card to where it hides nothing"))
        self._title, self._place_text, self._table = QLabel(), QLabel(), QLabel()
        self._title.setTextFormat(Qt.TextFormat.RichText)
        self._place_text.setTextFormat(Qt.TextFormat.PlainText)
        self._table.setTextFormat(Qt.TextFormat.RichText)
        font = QFont(self.font())
        font.setPointSizeF(max(font.pointSizeF() * 0.9, 7.0))
        for label in (self._title, self._place_text, self._table):
            label.setFont(font)
        copy = self._button("copy", tr("Copy the values as a table"), self._copy)
        close = self._button("close", tr("Take the marker away (Esc)"), self.close_wanted.emit)
        head = QHBoxLayout()
        head.setSpacing(2)
        head.addWidget(self._title, 1)
        head.addWidget(copy)
        head.addWidget(close)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(10, 5, 6, 7)
        layout.setSpacing(3)
        layout.addLayout(head)
        layout.addWidget(self._place_text)
        layout.addWidget(self._table)
        parent.installEventFilter(self)
        self.hide()

    def set_unit(self, unit: str) -> None:
        """Show deviations in another unit."""
        if unit != self._unit:
            self._unit = unit
            self._fill()

    def show_units(self) -> None:
        """Show lengths in the unit chosen."""
        self._fill()

    def show_values(self, pin: Hover, values: PickedValues, marker_y: float) -> None:
        """Show what was found at a point, whose marker is so far down in the views."""
        self._shown, self._marker_y = (pin, values), marker_y
        self._fill()
        self.show()
        self.raise_()

    def rows(self) -> list[list[str]]:
        """The table: a heading, the solid if it is one, a row for each method and variant, then theory."""
        if self._shown is None or not self._shown[0].side:
            return []
        pin, values = self._shown
        scales = [_scale(values, name) for name, _, _ in CURVATURES]
        heading = [tr("Method"), tr("Deviation"), *(f"{_SYMBOLS[name]} [{unit}]" for name, unit, _ in scales)]
        solid = [self._row(tr("This solid"), values.solid, scales)] if pin.member else []
        made = [heading, *solid]
        for key in sorted(values.found, key=_order):
            name = f"{tr(METHOD_TITLES[key.method])}, {inline(VARIANT_TITLES[key.variant])}"
            made.append(self._row(name, values.found[key], scales))
        return [*made, [tr("Theory"), "0", *_numbers(values.theory, scales)]]

    def _row(self, name: str, one: Probe | None, scales: list[tuple[str, str, float]]) -> list[str]:
        if one is None:
            return [name, *["–"] * (1 + len(scales))]
        return [name, colormap.deviation_text(one.deviation_um, unit=self._unit), *_numbers(one.curvature, scales)]

    def where(self) -> str:
        """The place in words."""
        if self._shown is None:
            return ""
        pin, _ = self._shown
        if not pin.member:
            words = f"{pin.flank} flank"
            return tr(words)
        member = tr(MEMBER_TITLES[pin.member])
        if pin.tooth is None:
            return f"{member}, {tr(pin.face)}" if pin.face else member
        return tr("{member}, {face}, tooth {number}", member=member, face=tr(pin.face), number=pin.tooth)

    def coordinates(self) -> list[str]:
        """Cartesian and spherical coordinates in the gear's own frame, a line each."""
        if self._shown is None:
            return []
        pin, values = self._shown
        x, y, z = (units.value_text(value, "mm") for value in pin.xyz)
        radius = units.with_unit(math.hypot(*pin.xyz[:2]), "mm", 4)
        return [
            f"x {x}   y {y}   z {z}{units.spaced('mm')}   r {radius}",
            f"ρ {units.with_unit(pin.rho, 'mm', 4)}   δ {fixed(pin.delta_deg, 4)}°   φ {fixed(values.azimuth_deg, 4)}°",
        ]

    def _fill(self) -> None:
        self._title.setText(f"<b>{escape(self.where())}</b>")
        self._place_text.setText("\n".join(self.coordinates()))
        self._table.setVisible(bool(self.rows()))
        lines = []
        for index, row in enumerate(self.rows()):
            cell = "th" if index == 0 else "td"
            first, *others = (escape(text) for text in row)
            numbers = "".join(f"<{cell} align='right' style='padding-left:10px'>{text}</{cell}>" for text in others)
            lines.append(f"<tr><{cell} align='left'>{first}</{cell}>{numbers}</tr>")
        self._table.setText(f"<table cellspacing='0' cellpadding='1'>{''.join(lines)}</table>")
        self._place()

    def _place(self) -> None:
        """Below the marker's half of the views or above it, beside no title, until the user moves the card."""
        self.layout().activate()
        self.adjustSize()
        parent = self.parentWidget()
        if self._moved_to is None:
            place = QPoint(parent.width() - self.width() - MARGIN, parent.height() - self.height() - MARGIN)
            if self._marker_y >= parent.height() / 2:
                place.setY(MARGIN)
                titles = [title.geometry() for title in parent.findChildren(PaneTitle) if title.isVisible()]
                lowest = max(
                    (box.bottom() for box in titles if box.right() > place.x() and box.top() <= MARGIN), default=0
                )
                place.setY(max(MARGIN, lowest + MARGIN // 2))
        else:
            place = self._moved_to
        right, bottom = max(parent.width() - self.width(), 0), max(parent.height() - self.height(), 0)
        self.move(min(max(place.x(), 0), right), min(max(place.y(), 0), bottom))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._grip = event.position().toPoint()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._grip is not None:
            self._moved_to = self.mapToParent(event.position().toPoint()) - self._grip
            self._place()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._grip = None

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Stay in the corner."""
        if event.type() == QEvent.Type.Resize and self._shown is not None:
            self._place()
        return False

    def _copy(self) -> None:
        lines = [self.where(), *self.coordinates(), *("\t".join(row) for row in self.rows())]
        QGuiApplication.clipboard().setText("\n".join(lines))

    def _button(self, name: str, words: str, act: object) -> QToolButton:
        button = QToolButton()
        button.setProperty("role", "gutter")
        button.setToolTip(words)
        button.setAccessibleName(words)
        set_icon(button, name)
        button.clicked.connect(act)
        return button


def _order(key: Key) -> tuple[int, int]:
    return METHOD_IDS.index(key.method), VARIANTS.index(key.variant)  # type: ignore[arg-type]


def _scale(values: PickedValues, name: str) -> tuple[str, str, float]:
    """A curvature's name, unit and factor that suit all values of it."""
    every = [values.theory, *(one.curvature for one in values.found.values() if one is not None)]
    largest = max((abs(getattr(one, name)) for one in every if one is not None), default=0.0)
    unit = next(unit for quantity, _, unit in CURVATURES if quantity == name)
    return (name, *Quantity(name, "", unit, False).shown(largest))


def _numbers(one: Curvature | None, scales: list[tuple[str, str, float]]) -> list[str]:
    if one is None:
        return ["∞" for _ in scales]
    return [number(getattr(one, name) * factor, ".5g") for name, _, factor in scales]
