"""The lower part of the window: the comparison table, and pages of analysis that are made when first shown."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QStackedWidget, QToolButton, QVBoxLayout, QWidget

from ui.method_bar import Segments
from ui.theme import set_icon
from ui.words import tr

if TYPE_CHECKING:
    from ui.analysis.page import Page

COMPARISON = "comparison"
TABS = (
    (COMPARISON, "Comparison", "All methods and variants in a table"),
    ("charts", "Charts", "Deviation along points, histogram"),
    ("contact", "Contact", "Contact pattern and transmission error, with misalignments"),
    ("datasheet", "Data sheet", "Geometry of both members; every value explains itself"),
    ("measurement", "Measurement", "Measured points against theory"),
)


class AnalysisArea(QWidget):
    """Tabs over a stack of pages; ``bar`` is the row of tabs, for the head of a dock.

    Signals
    -------
    tab_chosen(str)
        The user went to another page.
    page_made(object)
        A page that must be connected and filled.
    expanded(bool)
        Whether the pages shall have the room of the views.
    """

    tab_chosen = Signal(str)
    page_made = Signal(object)
    expanded = Signal(bool)

    def __init__(self, table: QWidget, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.tab = COMPARISON
        self.pages: dict[str, Page] = {}
        self._factories: Mapping[str, Callable[[], QWidget]] = {}
        self.tabs = Segments(TABS, tr("Analysis"))
        self.tabs.set_choice(COMPARISON)
        self.tabs.chosen.connect(self.show_tab)
        self.expand = _expand_button()
        self.expand.toggled.connect(self.expanded)
        self.bar = QWidget()
        row = QHBoxLayout(self.bar)
        row.setContentsMargins(4, 4, 8, 4)
        row.addWidget(self.tabs)
        row.addStretch(1)
        row.addWidget(self.expand)
        self._stack = QStackedWidget()
        self._waiting = QLabel(tr("Preparing the analysis…"), alignment=Qt.AlignmentFlag.AlignCenter)
        self._waiting.setProperty("role", "muted")
        self._card = QFrame()
        self._card.setProperty("role", "card")
        inside = QVBoxLayout(self._card)
        inside.setContentsMargins(1, 1, 1, 1)
        inside.addWidget(self._waiting)
        page = QWidget()
        outside = QVBoxLayout(page)
        outside.setContentsMargins(4, 0, 8, 6)
        outside.addWidget(self._card)
        self._table = QWidget()
        top = QVBoxLayout(self._table)
        top.setContentsMargins(0, 0, 0, 0)
        top.addWidget(table, 0, Qt.AlignmentFlag.AlignTop)
        self._stack.addWidget(self._table)
        self._stack.addWidget(page)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._stack)

    @property
    def page(self) -> Page | None:
        """The page in sight; None for the table, and while the charts are being loaded."""
        return self.pages.get(self.tab)

    def use_factories(self, factories: Mapping[str, Callable[[], QWidget]]) -> None:
        """What the pages are made with is loaded; those in sight are made at once."""
        self._factories = factories
        self.show_tab(self.tab)

    def show_failure(self, text: str) -> None:
        """The pages could not be loaded."""
        self._waiting.setText(text)

    def show_tab(self, tab: str) -> None:
        """Go to a page, made if it was never shown."""
        changed, self.tab = tab != self.tab, tab
        self.tabs.set_choice(tab)
        made = self._make(tab)
        for name, page in self.pages.items():
            page.setVisible(name == tab)  # type: ignore[attr-defined]
        self._waiting.setVisible(tab not in self.pages)
        self._stack.setCurrentIndex(0 if tab == COMPARISON else 1)
        if made is not None:
            self.page_made.emit(made)
        if changed:
            self.tab_chosen.emit(tab)

    def refresh_theme(self) -> None:
        """Take the colours of the theme in use."""
        for page in self.pages.values():
            page.refresh_theme()

    def close_pages(self) -> None:
        """End what runs in the background."""
        for page in self.pages.values():
            page.close_page()

    def _make(self, tab: str) -> Page | None:
        if tab in self.pages or tab not in self._factories:
            return None
        page = self._factories[tab]()
        self.pages[tab] = page  # type: ignore[assignment]
        self._card.layout().addWidget(page)
        return self.pages[tab]


def _expand_button() -> QToolButton:
    button = QToolButton()
    button.setCheckable(True)
    button.setAutoRaise(True)
    button.setIconSize(QSize(16, 16))
    set_icon(button, "expand")
    button.setToolTip(tr("Give the analysis the room of the 3D views"))
    button.setAccessibleName(tr("Expand the analysis"))
    return button
