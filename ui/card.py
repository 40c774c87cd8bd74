"""A card with rows that scroll when there is no room for all of them."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QScrollArea, QVBoxLayout, QWidget


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
        scroll = QScrollArea()
        scroll.setWidgetResizable(True)
        scroll.setFrameShape(QFrame.Shape.NoFrame)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setWidget(page)
        inside = QVBoxLayout(self)
        inside.setContentsMargins(1, 2, 1, 2)
        inside.addWidget(scroll)
