"""A row of widgets that goes on in another line where there is no room for all of them.

No layout of Qt's: a `QLayout` made in Python deals in items that Qt deletes behind the bindings' back, and what then
gets such an item's address is taken for it.
"""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, QSize, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QSizePolicy, QWidget


class FlowRow(QWidget):
    """Widgets from left to right, each as large as it wants to be, in as many lines as that takes."""

    def __init__(self, spacing: int = 8) -> None:
        super().__init__()
        self._spacing = spacing
        self._widgets: list[QWidget] = []
        policy = QSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)

    def add(self, widget: QWidget) -> None:
        """Append a widget."""
        hidden = widget.isHidden() and widget.testAttribute(Qt.WidgetAttribute.WA_WState_ExplicitShowHide)
        widget.setParent(self)
        widget.setVisible(not hidden)
        widget.installEventFilter(self)
        self._widgets.append(widget)
        self._arrange()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Close ranks when a widget comes or goes."""
        if event.type() in (QEvent.Type.ShowToParent, QEvent.Type.HideToParent):
            self._arrange()
        return super().eventFilter(watched, event)

    def event(self, event: QEvent) -> bool:
        """A widget wants another size."""
        if event.type() == QEvent.Type.LayoutRequest:
            self._arrange()
        return super().event(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._place(self.rect(), move=True)

    def heightForWidth(self, width: int) -> int:
        return self._place(QRect(0, 0, width, 0), move=False)

    def sizeHint(self) -> QSize:
        """All in one line."""
        sizes = [size for _, size in self._sizes()]
        width = sum(size.width() for size in sizes) + self._spacing * max(len(sizes) - 1, 0)
        return QSize(width, max((size.height() for size in sizes), default=0))

    def minimumSizeHint(self) -> QSize:
        """The widest of them alone."""
        sizes = [size for _, size in self._sizes()]
        width = max((size.width() for size in sizes), default=0)
        return QSize(width, max((size.height() for size in sizes), default=0))

    def _sizes(self) -> list[tuple[QWidget, QSize]]:
        shown = [widget for widget in self._widgets if not widget.isHidden()]
        return [(widget, _size(widget)) for widget in shown]

    def _arrange(self) -> None:
        self.setMaximumWidth(max(self.sizeHint().width(), 1))  # what stands beside it has the room that is left
        self.updateGeometry()
        self._place(self.rect(), move=True)

    def _place(self, room: QRect, *, move: bool) -> int:
        """Put the widgets into lines, centred in the height of their line and all lines in the room; their height."""
        lines = list[list[tuple[QWidget, QSize]]]()
        used = 0
        for widget, size in self._sizes():
            if not lines or used + size.width() > room.width():
                lines.append([])
                used = 0
            lines[-1].append((widget, size))
            used += size.width() + self._spacing
        heights = [max(size.height() for _, size in line) for line in lines]
        whole = sum(heights) + self._spacing // 2 * max(len(lines) - 1, 0)
        if move:
            top = max((room.height() - whole) // 2, 0)
            for line, height in zip(lines, heights, strict=True):
                _settle(line, QPoint(room.left(), room.top() + top), height, self._spacing)
                top += height + self._spacing // 2
        return whole


def _size(widget: QWidget) -> QSize:
    return (
        widget.sizeHint()
        .expandedTo(widget.minimumSizeHint())
        .expandedTo(widget.minimumSize())
        .boundedTo(widget.maximumSize())
    )


def _settle(line: list[tuple[QWidget, QSize]], corner: QPoint, height: int, spacing: int) -> None:
    x = corner.x()
    for widget, size in line:
        widget.setGeometry(QRect(QPoint(x, corner.y() + (height - size.height()) // 2), size))
        x += size.width() + spacing
