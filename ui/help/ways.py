"""Ways into the equation browser and the glossary: from fields and their explanations, and from rows of values."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, Signal
from PySide6.QtGui import QWhatsThisClickedEvent
from PySide6.QtWidgets import QApplication, QTableWidget, QWhatsThis

from ui.derived_panel import SYMBOL
from ui.help.rows import RowEquations
from ui.words import tr

if TYPE_CHECKING:
    from ui.main_window import MainWindow
    from ui.session import Session

LINK, TERM = "equation:", "glossary:"
_OF_SYMBOLS = {
    "z": "z", "": "hand", "δ": "delta", "δ_a": "delta_a", "δ_f": "delta_f", "δ_b": "delta_b", "d": "d_e",
    "h_a": "h_ae", "h_f": "h_fe", "R": "R_e", "R_m": "R_m", "B": "b", "R_b": "R_b", "α": "alpha", "β": "beta_e",
    "β_m": "beta_m", "γ": "gamma", "R_f": "R_f", "u": "u", "m_n": "m_mn", "α_n": "alpha_n", "ε_α": "eps_alpha",
    "ε_β": "eps_beta", "ε_o": "eps_o",
}  # fmt: skip
"""Quantities of the data sheet by the symbols of the derived values."""


def keys_of_symbol(symbol: str) -> tuple[str, ...]:
    """Equations that give a derived value."""
    from gearstudio.equations import equations_of_field, equations_of_quantity

    quantity = _OF_SYMBOLS.get(symbol, "")
    return equations_of_field("pair.pinion_hand") if quantity == "hand" else equations_of_quantity(quantity)


class Ways(QObject):
    """Listens to all that may ask for an equation.

    Signals
    -------
    equation_asked(str)
        Key of the equation to show; empty shows the browser as it was left.
    term_asked(str)
        Entry of the glossary to show.
    """

    equation_asked = Signal(str)
    term_asked = Signal(str)

    def __init__(self, session: Session, window: MainWindow) -> None:
        super().__init__(window)
        self._session, self._window = session, window
        self.derived = RowEquations(window.derived.view, self._derived_keys)
        self.derived.asked.connect(self.show_one_of)
        self.sheet: RowEquations | None = None
        window.form.equation_asked.connect(self.show_field)
        window.commands["show_equation"].triggered.connect(self._show_focused)
        window.analysis.page_made.connect(self._on_page_made)
        window.installEventFilter(self)

    def show_one_of(self, keys: tuple[str, ...]) -> None:
        """Show the first of some equations that holds for the design."""
        from gearstudio.equations import equation_for

        self.equation_asked.emit(equation_for(keys, self._session.pair))

    def show_field(self, path: str) -> None:
        """Show the equation that a field enters, or say that there is none."""
        from gearstudio.equations import equations_of_field

        keys = equations_of_field(path)
        if keys:
            self.show_one_of(keys)
        else:
            self._window.status.showMessage(tr("This parameter enters no equation."), 4000)

    def show_quantity(self, key: str) -> None:
        """Show the equation of a quantity of the data sheet."""
        from gearstudio.equations import equations_of_quantity

        self.show_one_of(equations_of_quantity(key))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Follow the links of an explanation."""
        if isinstance(event, QWhatsThisClickedEvent):
            QWhatsThis.hideText()
            if event.href().startswith(LINK):
                self.show_field(event.href().removeprefix(LINK))
            else:
                self.term_asked.emit(event.href().removeprefix(TERM))
            return True
        return super().eventFilter(watched, event)

    def _show_focused(self) -> None:
        path, focused = self._window.form.focused_path(), QApplication.focusWidget()
        rows = next((ways for ways in (self.derived, self.sheet) if ways and ways.parent() is focused), None)
        if path:
            self.show_field(path)
        elif rows is not None:
            rows.ask()
        else:
            self.equation_asked.emit("")

    def _derived_keys(self, row: int) -> tuple[str, ...]:
        view: QTableWidget = self._window.derived.view
        item = view.item(row, 0)
        return keys_of_symbol(item.data(SYMBOL)) if item is not None else ()

    def _on_page_made(self, page: object) -> None:
        from ui.analysis.datasheet_page import DatasheetPage

        if isinstance(page, DatasheetPage):
            self.sheet = RowEquations(page.table.table, page.table.equations_at)
            self.sheet.asked.connect(self.show_one_of)
            page.explanation.equation_asked.connect(self.show_quantity)
