"""A card with rows that scroll when there is no room for all of them."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QFrame, QScrollArea, QVBoxLayout, QWidget


class UprightScroll(QScrollArea):
    """Scrolls a page up and down only: it is never narrower than the page needs, nor than ``least`` pixels."""

    def __init__(self, page: QWidget, least: int = 0, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._least = least
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # it follows what has the keyboard in it
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setWidget(page)

    def minimumSizeHint(self) -> QSize:
        """The page's least width beside the scroll bar."""
        bar = self.verticalScrollBar().sizeHint().width()
        width = max(self._least, self.widget().minimumSizeHint().width() + bar)
        return QSize(width, super().minimumSizeHint().height())

    def sizeHint(self) -> QSize:
        return super().sizeHint().expandedTo(self.minimumSizeHint())


class ScrollCard(QFrame):
    """A framed page; ``rows`` is its layout. It scrolls up and down only."""

    def __init__(self, margins: tuple[int, int, int, int], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "card")
        page = QWidget()
        page.setProperty("role", "page")
        self.rows = QVBoxLayout(page)
        self.rows.setContentsMargins(*margins)
        self.rows.setSpacing(7)
        inside = QVBoxLayout(self)
        inside.setContentsMargins(1, 2, 1, 2)
        inside.addWidget(UprightScroll(page))
