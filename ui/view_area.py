"""The middle of the window: the 3D views with their colour scale and roll slider, or what stands in for them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QRectF, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QLinearGradient, QPainter, QPaintEvent, QPen, QResizeEvent
from PySide6.QtWidgets import QFrame, QGridLayout, QStackedLayout, QVBoxLayout, QWidget

from ui.messages import MessageBar
from ui.theme import tokens
from ui.words import tr

if TYPE_CHECKING:
    from ui.color_bar import ColorBar
    from ui.mesh_bar import MeshBar
    from ui.roll_slider import RollSlider
    from ui.view_grid import ViewGrid


class Placeholder(QWidget):
    """A quiet picture with a line of text while the renderer loads."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._text = tr("Preparing 3D view…")
        self._angle = 0
        self._timer = QTimer(self, interval=40)
        self._timer.timeout.connect(self._turn)

    def set_text(self, text: str, *, waiting: bool) -> None:
        """Say what is going on; the ring turns while it is ``waiting``."""
        self._text = text
        self._timer.start() if waiting else self._timer.stop()
        self.update()

    def stop(self) -> None:
        """Stand still."""
        self._timer.stop()

    def paintEvent(self, event: QPaintEvent) -> None:
        colors = tokens()
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            ground = QLinearGradient(0, 0, 0, self.height())
            ground.setColorAt(0, QColor(colors.view_top))
            ground.setColorAt(1, QColor(colors.view_bottom))
            painter.fillRect(self.rect(), ground)
            centre = self.rect().center()
            ring = QRectF(centre.x() - 15, centre.y() - 34, 30, 30)
            painter.setPen(QPen(QColor(colors.border_strong), 3))
            painter.drawEllipse(ring)
            if self._timer.isActive():
                painter.setPen(QPen(QColor(colors.accent), 3, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
                painter.drawArc(ring, -self._angle * 16, 90 * 16)
            painter.setPen(QColor(colors.muted))
            below = QRectF(0, centre.y() + 14, self.width(), 60)
            painter.drawText(below, Qt.AlignmentFlag.AlignHCenter | Qt.TextFlag.TextWordWrap, self._text)

    def _turn(self) -> None:
        self._angle = (self._angle + 14) % 360
        self.update()


class ViewArea(QWidget):
    """Message bar, views, colour scale and roll slider; the views come later than the rest.

    Signals
    -------
    resized()
    """

    resized = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.messages = MessageBar()
        self.placeholder = Placeholder()
        self.placeholder.set_text(tr("Preparing 3D view…"), waiting=True)
        self.grid: ViewGrid | None = None
        self.color_bar: ColorBar | None = None
        self.roll_slider: RollSlider | None = None
        self.mesh_bar: MeshBar | None = None
        card = QFrame()
        card.setProperty("role", "card")
        self._stack = QStackedLayout()
        self._stack.addWidget(self.placeholder)
        self._inside = QGridLayout(card)
        self._inside.setContentsMargins(1, 1, 1, 1)
        self._inside.setSpacing(0)
        self._inside.addLayout(self._stack, 0, 0)
        self._inside.setColumnStretch(0, 1)
        self._inside.setRowStretch(0, 1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(4, 6, 6, 4)
        layout.setSpacing(6)
        layout.addWidget(self.messages)
        layout.addWidget(card, 1)
        self.setMinimumSize(420, 240)

    def adopt(self, grid: ViewGrid, color_bar: ColorBar, roll_slider: RollSlider, mesh_bar: MeshBar) -> None:
        """Take the views in place of the placeholder."""
        self.mesh_bar = mesh_bar
        self.grid, self.color_bar, self.roll_slider = grid, color_bar, roll_slider
        self._stack.addWidget(grid)
        self._stack.setCurrentWidget(grid)
        self.placeholder.stop()
        self._inside.addWidget(color_bar, 0, 1)
        self._inside.addWidget(roll_slider, 1, 0, 1, 3)
        self._inside.addWidget(mesh_bar, 2, 0, 1, 3)
        mesh_bar.hide()

    def add_panel(self, panel: QWidget) -> None:
        """Take a panel to the right of the colour scale."""
        self._inside.addWidget(panel, 0, 2)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.resized.emit()

    def close_views(self) -> None:
        """Let go of the renderer before the window goes; may be called twice."""
        self.placeholder.stop()
        if self.roll_slider is not None:
            self.roll_slider.pause()
        if self.mesh_bar is not None:
            self.mesh_bar.pause()
        if self.grid is not None:
            self.grid.close_views()
