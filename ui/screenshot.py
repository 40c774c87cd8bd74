"""A picture of the window as it is on the screen, the 3D views included."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint
from PySide6.QtGui import QImage, QPainter
from PySide6.QtWidgets import QWidget

if TYPE_CHECKING:
    from ui.main_window import MainWindow


def window_image(window: MainWindow) -> QImage:
    """The whole window; the views are drawn anew, so that what is not on the screen is not missing."""
    picture = window.grab().toImage()
    grid = window.area.grid
    if grid is not None and grid.isVisible():
        painter = QPainter(picture)
        painter.drawImage(grid.mapTo(window, QPoint(0, 0)), grid.screenshot())
        painter.end()
    return picture


def looks_blank(picture: QImage, widget: QWidget, window: QWidget) -> bool:
    """Whether the part of a picture of the window where a widget is shows hardly any colour."""
    ratio = picture.devicePixelRatio()
    corner = widget.mapTo(window, QPoint(0, 0)) * ratio
    width, height = round(widget.width() * ratio), round(widget.height() * ratio)
    part = picture.copy(corner.x(), corner.y(), width, height).scaled(64, 64)
    return len({part.pixel(x, y) & 0xF0F0F0 for x in range(64) for y in range(64)}) < 8
