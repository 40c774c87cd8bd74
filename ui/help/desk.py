"""Opens what the Help menu offers, one window of each."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QDialog, QDockWidget

from ui.help.clicked import Clicked
from ui.help.equations import EquationBrowser
from ui.help.guide import GuideWindow
from ui.help.tour import Tour
from ui.help.ways import Ways

if TYPE_CHECKING:
    from ui.main_window import MainWindow
    from ui.session import Session


class HelpDesk(QObject):
    """The windows of the Help menu."""

    def __init__(self, session: Session, window: MainWindow) -> None:
        super().__init__(window)
        self._session, self._window = session, window
        self._guide: GuideWindow | None = None
        self._equations: EquationBrowser | None = None
        self.tour = Tour(window)
        self.clicked = Clicked(window)
        self.ways = Ways(session, window)
        self.ways.equation_asked.connect(self.open_equations)
        self.ways.term_asked.connect(self.open_term)
        commands = window.commands
        commands["tour"].triggered.connect(lambda: self.tour.start())
        commands["guide"].triggered.connect(lambda: self.open_guide())
        commands["glossary"].triggered.connect(lambda: self.open_guide("glossary"))
        commands["equations"].triggered.connect(lambda: self.open_equations())

    def open_guide(self, page: str = "guide") -> GuideWindow:
        """Show a page of the guide."""
        if self._guide is None:
            self._guide = GuideWindow(self._window, page)
            self._guide.finished.connect(self._forget_guide)
        self._guide.show_page(page)
        _to_front(self._guide)
        return self._guide

    def open_term(self, term: str) -> None:
        """Show what a word means."""
        self.open_guide("glossary").show_term(term)

    def open_equations(self, key: str = "") -> EquationBrowser:
        """Show the equation browser, at an equation."""
        if self._equations is None:
            self._equations = EquationBrowser(self._session, self._window)
            self._equations.finished.connect(self._forget_equations)
            self._equations.field_asked.connect(self.go_to_field)
        _to_front(self._equations)
        if key:
            self._equations.choose(key)
        return self._equations

    def go_to_field(self, path: str) -> None:
        """Bring a parameter into sight, in front of the equation that uses it."""
        window = self._window
        dock = window.form.parentWidget()
        while dock is not None and not isinstance(dock, QDockWidget):
            dock = dock.parentWidget()
        if dock is not None:
            dock.show()
            dock.raise_()
        window.activateWindow()
        window.form.go_to(path)

    def _forget_guide(self) -> None:
        if self._guide is not None:
            self._guide.deleteLater()
        self._guide = None

    def _forget_equations(self) -> None:
        self._equations = None


def _to_front(window: QDialog) -> None:
    window.show()
    window.raise_()
    window.activateWindow()
