"""Parts of the colour scale's picture: its colours, its pointed ends, the mark of a value."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPen

from ui import colormap

POINT = 9
"""Height of a pointed end."""


def picture(colors: str, steps: int) -> QImage:
    """A column of the colours, the highest above."""
    rgb = np.ascontiguousarray(colormap.table(colors, steps)[::-1, None, :])
    return QImage(rgb.data, 1, len(rgb), 3, QImage.Format.Format_RGB888).copy()


def paint_ends(painter: QPainter, bar: QRectF, image: QImage, beyond: tuple[bool, bool]) -> None:
    """A point beyond each end, the upper and the lower one, that does not show all there is."""
    painter.setPen(Qt.PenStyle.NoPen)
    for pointed, y, tip, row in (
        (beyond[0], bar.top(), -POINT, 0),
        (beyond[1], bar.bottom(), POINT, image.height() - 1),
    ):
        if pointed:
            painter.setBrush(image.pixelColor(0, row))
            painter.drawPolygon([QPointF(bar.left(), y), QPointF(bar.right(), y), QPointF(bar.center().x(), y + tip)])


def paint_marker(painter: QPainter, bar: QRectF, y: float, color: QColor) -> None:
    """A line across the bar, with a triangle at its left."""
    painter.setPen(QPen(color, 1.5))
    painter.drawLine(QPointF(bar.left() - 3, y), QPointF(bar.right() + 3, y))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(color)
    painter.drawPolygon([QPointF(bar.left() - 2, y), QPointF(bar.left() - 7, y - 4), QPointF(bar.left() - 7, y + 4)])
