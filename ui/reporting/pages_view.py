"""The pages of a report, one below the other."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QImage, QPixmap
from PySide6.QtWidgets import QFrame, QLabel, QScrollArea, QVBoxLayout, QWidget

from ui.words import tr

_GAP = 12


class PagesView(QScrollArea):
    """Shows pictures of pages, or a sentence while there are none."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(tr("Preview of the report"))
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setWidgetResizable(True)
        self.setAlignment(Qt.AlignmentFlag.AlignHCenter)
        self._pages = 0

    @property
    def page_count(self) -> int:
        """Number of pages shown."""
        return self._pages

    def say(self, text: str) -> None:
        """Show a sentence instead of pages."""
        label = QLabel(text)
        label.setProperty("role", "muted")
        label.setAlignment(Qt.AlignmentFlag.AlignCenter)
        label.setWordWrap(True)
        label.setMargin(24)
        self._pages = 0
        self.setWidget(label)

    def show_pages(self, pages: Sequence[bytes]) -> None:
        """Show pages, given as PNG pictures."""
        place = self.verticalScrollBar().value()
        sheet = QWidget()
        column = QVBoxLayout(sheet)
        column.setSpacing(_GAP)
        for number, data in enumerate(pages, 1):
            page = QLabel()
            page.setPixmap(QPixmap.fromImage(QImage.fromData(data, "PNG")))
            page.setAccessibleName(tr("Page {number} of {count}", number=number, count=len(pages)))
            page.setFrameShape(QFrame.Shape.Box)
            column.addWidget(page, 0, Qt.AlignmentFlag.AlignHCenter)
        column.addStretch(1)
        self._pages = len(pages)
        self.setWidget(sheet)
        self.verticalScrollBar().setValue(place)

    def scroll_to(self, place: int) -> None:
        """Scroll down so many pixels, once the pages have their sizes."""
        QTimer.singleShot(0, self, lambda: self.verticalScrollBar().setValue(place))
