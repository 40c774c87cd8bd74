"""A row of widgets that goes on in another line where there is no room for all of them."""

from __future__ import annotations

from PySide6.QtCore import QPoint, QRect, QSize, Qt
from PySide6.QtWidgets import QLayout, QLayoutItem, QWidget


class FlowRow(QLayout):
    """Widgets from left to right, each as large as it wants to be, in as many lines as that takes."""

    def __init__(self, spacing: int = 8) -> None:
        super().__init__()
        self._items: list[QLayoutItem] = []
        self.setContentsMargins(0, 0, 0, 0)
        self.setSpacing(spacing)

    def add(self, widget: QWidget) -> None:
        """Append a widget."""
        self.addWidget(widget)

    def addItem(self, item: QLayoutItem) -> None:
        self._items.append(item)
        self.invalidate()

    def count(self) -> int:
        return len(self._items)

    def itemAt(self, index: int) -> QLayoutItem | None:
        return self._items[index] if 0 <= index < len(self._items) else None

    def takeAt(self, index: int) -> QLayoutItem | None:
        return self._items.pop(index) if 0 <= index < len(self._items) else None

    def expandingDirections(self) -> Qt.Orientation:
        return Qt.Orientation(0)

    def hasHeightForWidth(self) -> bool:
        return True

    def heightForWidth(self, width: int) -> int:
        return self._place(QRect(0, 0, width, 0), move=False)

    def setGeometry(self, rect: QRect) -> None:
        super().setGeometry(rect)
        beyond = max(rect.height() - self.heightForWidth(rect.width()), 0)
        self._place(rect.adjusted(0, beyond // 2, 0, 0), move=True)

    def sizeHint(self) -> QSize:
        """All in one line."""
        sizes = [item.sizeHint() for item in self._items if not item.isEmpty()]
        width = sum(size.width() for size in sizes) + self.spacing() * max(len(sizes) - 1, 0)
        return QSize(width, max((size.height() for size in sizes), default=0))

    def minimumSize(self) -> QSize:
        """The widest of them alone."""
        sizes = [item.sizeHint() for item in self._items if not item.isEmpty()]
        width = max((size.width() for size in sizes), default=0)
        return QSize(width, max((size.height() for size in sizes), default=0))

    def maximumSize(self) -> QSize:
        """What stands beside it has the room that is left."""
        return QSize(self.sizeHint().width(), super().maximumSize().height())

    def _place(self, room: QRect, *, move: bool) -> int:
        """Put the items into lines, centred in the height of their line; the height of all lines."""
        top, line = 0, list[tuple[QLayoutItem, QSize]]()
        for item in (*self._items, None):
            size = QSize() if item is None or item.isEmpty() else item.sizeHint()
            used = sum(one.width() + self.spacing() for _, one in line)
            if line and (item is None or (size.isValid() and used + size.width() > room.width())):
                height = max(one.height() for _, one in line)
                if move:
                    _settle(line, room.topLeft() + QPoint(0, top), height, self.spacing())
                top, line = top + height + self.spacing() // 2, []
            if item is not None and not item.isEmpty():
                line.append((item, size))
        return max(top - self.spacing() // 2, 0)


def _settle(line: list[tuple[QLayoutItem, QSize]], corner: QPoint, height: int, spacing: int) -> None:
    x = corner.x()
    for item, size in line:
        item.setGeometry(QRect(QPoint(x, corner.y() + (height - size.height()) // 2), size))
        x += size.width() + spacing
