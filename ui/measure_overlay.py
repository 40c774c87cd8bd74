"""The measured line over the view: two rings, a line and the distance, drawn by Qt."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from ui.theme import tokens


class MeasureOverlay(QWidget):
    """Lies over the whole view and lets the mouse through."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAttribute(Qt.WidgetAttribute.WA_NoSystemBackground)
        self._places: tuple[QPointF, ...] = ()
        self._text = ""
        self._hint: tuple[QPointF, str] | None = None
        self.hide()

    def show_points(self, places: tuple[QPointF, ...], text: str, hint: tuple[QPointF, str] | None = None) -> None:
        """Show one or two points and the text between them, and what a click would snap to; nothing hides it."""
        self._places, self._text, self._hint = places, text, hint
        shown = bool(places) or hint is not None
        self.setVisible(shown)
        if shown:
            self.setGeometry(self.parentWidget().rect())
            self.raise_()
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        colors = tokens()
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            halo, line = QColor(colors.surface), QColor(colors.accent)
            halo.setAlphaF(0.85)
            for color, width in ((halo, 4.5), (line, 2.0)):
                painter.setPen(QPen(color, width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
                if len(self._places) == 2:
                    painter.drawLine(*self._places)
            for place in self._places:
                painter.setPen(QPen(halo, 2.0))
                painter.setBrush(line)
                painter.drawEllipse(place, 4.5, 4.5)
            if self._hint is not None:
                self._paint_square(painter, self._hint[0], halo, line)
                self._paint_text(painter, self._hint[0] - QPointF(0, 14), self._hint[1], False)
            if len(self._places) == 2:
                self._paint_text(painter, (self._places[0] + self._places[1]) / 2, self._text, True)

    def _paint_square(self, painter: QPainter, place: QPointF, halo: QColor, line: QColor) -> None:
        square = QRectF(0, 0, 13, 13)
        square.moveCenter(place)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for color, width in ((halo, 4.5), (line, 2.0)):
            painter.setPen(QPen(color, width))
            painter.drawRect(square)

    def _paint_text(self, painter: QPainter, middle: QPointF, text: str, bold: bool) -> None:
        colors = tokens()
        font = QFont(self.font())
        font.setBold(bold)
        size = QFontMetricsF(font).size(0, text)
        plate = QRectF(0, 0, size.width() + 16, size.height() + 6)
        plate.moveCenter(middle - QPointF(0, size.height()))
        painter.setPen(QPen(QColor(colors.border), 1))
        painter.setBrush(QColor(colors.surface))
        painter.drawRoundedRect(plate, 6, 6)
        painter.setPen(QColor(colors.text))
        painter.setFont(font)
        painter.drawText(plate, Qt.AlignmentFlag.AlignCenter, text)
