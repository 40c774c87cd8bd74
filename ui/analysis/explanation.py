"""How a value of the data sheet came about: formula, where it stands, and the numbers put in."""

from __future__ import annotations

import re
from html import escape
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QLabel, QScrollArea, QWidget

from ui.analysis.sheet_table import lowered, shown_value
from ui.formatting import MEMBER_TITLES, MINUS, fixed, written
from ui.theme import tokens
from ui.units import factor, to_shown, unit_shown
from ui.words import tr

if TYPE_CHECKING:
    from gearstudio.analysis.datasheet import Quantity


class Explanation(QScrollArea):
    """Explains one line of the sheet.

    Signals
    -------
    equation_asked(str)
        Key of the quantity whose equation shall be shown.
    """

    equation_asked = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._line: tuple[Quantity, ...] = ()
        self._text = QLabel()
        self._text.setWordWrap(True)
        self._text.setProperty("role", "page")
        self._text.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self._text.setTextInteractionFlags(
            Qt.TextInteractionFlag.TextSelectableByMouse
            | Qt.TextInteractionFlag.LinksAccessibleByMouse
            | Qt.TextInteractionFlag.LinksAccessibleByKeyboard
        )
        self._text.linkActivated.connect(self.equation_asked)
        self._text.setContentsMargins(14, 8, 12, 8)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setWidget(self._text)
        self.setAccessibleName(tr("How the value came about"))

    def text(self) -> str:
        """What is shown, as rich text."""
        return self._text.text()

    def explain(self, line: tuple[Quantity, ...]) -> None:
        """Show a line of the sheet."""
        self._line = line
        self.refresh_theme()

    def show_units(self) -> None:
        """Show the same line in the unit that the user chose now."""
        self.refresh_theme()

    def refresh_theme(self) -> None:
        """Take the colours of the theme in use."""
        if self._line:
            self._text.setText(explanation(self._line))


def explanation(line: tuple[Quantity, ...]) -> str:
    """A line of the sheet as rich text."""
    from gearstudio.equations import equations_of_quantity

    first, muted = line[0], tokens().muted
    parts = [
        f'<p style="margin:0 0 4px 0"><b>{escape(tr(first.name))}</b></p>',
        f'<p style="margin:4px 0; font-size:large">{lowered(tr(first.formula))}</p>',
        f'<p style="margin:0 0 8px 0; color:{muted}">{where(first.equation)}</p>',
    ]
    if equations_of_quantity(first.key):
        parts.append(f'<p style="margin:0 0 8px 0"><a href="{escape(first.key)}">{tr("Show equation")}</a></p>')
    for quantity in line:
        head = "" if quantity.owner == "pair" else f"{tr(MEMBER_TITLES[quantity.owner])}: "
        result = f"<i>{lowered(quantity.symbol)}</i> = {_number(shown_value(quantity), quantity.unit)}"
        parts.append(f'<p style="margin:8px 0 2px 0"><b>{head}{result}</b></p>')
        parts.append(f'<table cellspacing="0" cellpadding="1">{_rows(quantity)}</table>')
    return "".join(parts)


def where(equation: str) -> str:
    """``2 [7]`` in words: the section of the theory and the paper's equation; standards by their name."""
    match = re.fullmatch(r"(\d\S*)(?:\s*\[(.+)\])?", equation)
    if match is None:
        return tr("Offset axes") if equation == "hypoid" else escape(equation)
    section, printed = match.groups()
    words = tr("Theory, section {section}", section=section)
    return words + tr("; equation {printed} of the paper", printed=printed) if printed else words


def _rows(quantity: Quantity) -> str:
    muted = tokens().muted
    return "".join(
        f'<tr><td style="color:{muted}"><i>{lowered(symbol)}</i>&nbsp;</td>'
        f"<td>= {_number(_input(value, unit), unit)}</td></tr>"
        for symbol, value, unit in quantity.inputs
    )


def _input(value: float, unit: str) -> str:
    """A number that was put in, with the digits of the sheet, in the unit shown."""
    from gearstudio.analysis.datasheet import number

    return written(number(value, unit)) if factor(unit) == 1 else fixed(to_shown(value, unit), 6)


def _number(text: str, unit: str) -> str:
    gap = "" if unit == "°" else "&nbsp;"
    return f"{text.replace('-', MINUS)}{gap}{unit_shown(unit)}"
