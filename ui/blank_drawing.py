"""The section drawing of a blank in the form, with its dimensions; a double click shows it large."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QBrush, QColor, QFont, QFontMetricsF, QMouseEvent, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QDialog, QSizePolicy, QVBoxLayout, QWidget

from ui.formatting import MEMBER_TITLES
from ui.theme import tokens
from ui.words import tr

if TYPE_CHECKING:
    from ui.blank_shape import BlankShape, Dimension

LEAST_HEIGHT = 232
LARGE = QSize(900, 640)
_ARROW = 5.0


class BlankDrawing(QWidget):
    """Half of an axial section: hatched body, tooth, pitch cone, axis, dimensions."""

    def __init__(self, member: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.member = member
        self._shape: BlankShape | None = None
        self._note = ""
        self._large: BlankDrawing | None = None
        self.setMinimumHeight(LEAST_HEIGHT)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setToolTip(tr("Axial section of the blank; double-click to enlarge"))
        self.setAccessibleName(tr("Section of the {member}'s blank", member=tr(member)))

    @property
    def shape(self) -> BlankShape | None:
        """What is drawn."""
        return self._shape

    def show_shape(self, shape: BlankShape | None, note: str = "") -> None:
        """Draw a section; a note says why it is not the one that the fields ask for."""
        self._shape, self._note = shape, note
        self.update()
        if self._large is not None:
            self._large.show_shape(shape, note)

    def sizeHint(self) -> QSize:
        return QSize(300, LEAST_HEIGHT)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        event.accept()
        if self._large is None and self.window() is not None and not isinstance(self.window(), QDialog):
            self._enlarge()

    def _enlarge(self) -> None:
        dialog = QDialog(self.window())
        dialog.setWindowTitle(tr("Blank of the {member}", member=tr(self.member)))
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.resize(LARGE)
        self._large = BlankDrawing(self.member)
        self._large.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self._large.setToolTip("")
        self._large.show_shape(self._shape, self._note)
        QVBoxLayout(dialog).addWidget(self._large)
        dialog.finished.connect(self._on_closed)
        dialog.show()

    def _on_closed(self) -> None:
        self._large = None

    def paintEvent(self, event: QPaintEvent) -> None:
        colors = tokens()
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            frame = QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5)
            painter.setPen(QPen(QColor(colors.border), 1))
            painter.setBrush(QColor(colors.sunken))
            painter.drawRoundedRect(frame, 6, 6)
            if self._shape is not None:
                if self._note:
                    painter.setOpacity(0.35)
                _Sheet(painter, self._shape, frame.adjusted(8, 8, -8, -8), self.font()).draw()
                painter.setOpacity(1.0)
            if self._note or self._shape is None:
                painter.setPen(QColor(colors.error if self._note else colors.muted))
                words = self._note or tr("{member}: no blank yet", member=tr(MEMBER_TITLES[self.member]))
                painter.drawText(frame.adjusted(14, 10, -14, -10), _CENTRED, words)


_CENTRED = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap


class _Sheet:
    """One drawing in a rectangle of pixels."""

    def __init__(self, painter: QPainter, shape: BlankShape, place: QRectF, font: QFont) -> None:
        self.painter, self.shape, self.colors = painter, shape, tokens()
        font = QFont(font)
        font.setPointSizeF(max(font.pointSizeF() * (0.88 if place.height() < 300 else 1.0), 7.0))
        painter.setFont(font)
        self.size = font.pointSizeF()
        self.metrics = QFontMetricsF(font)
        self.line = self.metrics.height() + 3
        self.columns = [d for d in shape.dimensions if d.kind == "diameter"]
        self.rows = 1 + max(d.row for d in shape.dimensions if d.kind == "along")
        below = self.rows * self.line + 8
        right = len(self.columns) * self.line + 6
        top = 2.1 * self.line
        area = place.adjusted(4, top, -right, -below)
        (z0, r0), (z1, r1) = shape.extent
        self.scale = min(area.width() / (z1 - z0), area.height() / (r1 - r0))
        spare = max(area.width() - self.scale * (z1 - z0), 0.0)
        self.origin = QPointF(area.left() + spare / 2 - self.scale * z0, area.bottom())
        self.bottom, self.right = area.bottom(), self.origin.x() + self.scale * z1
        self.place = place

    def at(self, point: tuple[float, float]) -> QPointF:
        """Pixels of a place (height, radius)."""
        return QPointF(self.origin.x() + self.scale * point[0], self.origin.y() - self.scale * point[1])

    def draw(self) -> None:
        painter, colors = self.painter, self.colors
        ink = QPen(QColor(colors.text), 1.5)
        ink.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
        hatch = QColor(colors.muted)
        hatch.setAlphaF(0.55)
        body, tooth = (QPolygonF([self.at((x, y)) for x, y in ring]) for ring in (self.shape.body, self.shape.tooth))
        painter.setPen(ink)
        for brush in (QBrush(QColor(colors.surface)), QBrush(hatch, Qt.BrushStyle.BDiagPattern)):
            painter.setBrush(brush)
            painter.drawPolygon(body)
        painter.setBrush(QColor(colors.accent_soft))
        painter.drawPolygon(tooth)
        self._draw_axes()
        for dimension in self.shape.dimensions:
            {"along": self._along, "diameter": self._diameter, "aligned": self._aligned}[dimension.kind](dimension)
        painter.setPen(QColor(colors.muted))
        self._symbols(
            QPointF(self.place.left(), self.place.top() + self.metrics.ascent()), "    ".join(self.shape.notes)
        )

    def _draw_axes(self) -> None:
        pen = QPen(QColor(self.colors.accent), 1.0)
        pen.setDashPattern([9, 3, 2, 3])
        self.painter.setPen(pen)
        self.painter.drawLine(self.at((0.0, 0.0)) - QPointF(6, 0), QPointF(self.right + 6, self.origin.y()))
        self.painter.drawLine(self.at(tuple(self.shape.pitch[0])), self.at(tuple(self.shape.pitch[1])))

    def _along(self, d: Dimension) -> None:
        y = self.bottom + 8 + (d.row + 0.5) * self.line
        start, end = self.at(d.start).x(), self.at(d.end).x()
        for x in (start, end):
            self._thin(QPointF(x, self.bottom + 3), QPointF(x, y + 3))
        self._measure(QPointF(start, y), QPointF(end, y), d.text, 0.0)

    def _diameter(self, d: Dimension) -> None:
        x = self.right + 6 + (d.row + 0.5) * self.line
        y = self.at(d.end).y()
        self._thin(self.at(d.end) + QPointF(3, 0), QPointF(x + 3, y))
        self._measure(QPointF(x, self.origin.y()), QPointF(x, y), d.text, -90.0)

    def _aligned(self, d: Dimension) -> None:
        start, end = self.at(d.start), self.at(d.end)
        across = QPointF(end.y() - start.y(), start.x() - end.x())
        across /= max(math.hypot(across.x(), across.y()), 1e-9)
        angle = math.degrees(math.atan2(end.y() - start.y(), end.x() - start.x()))
        if d.row < 0:  # along the line itself: text alone
            middle = start + 0.36 * (end - start)
            self._text(middle + 0.55 * self.line * across, d.text, angle)
            return
        shift = (0.75 * self.line) * across
        for point in (start, end):
            self._thin(point + 2 * across, point + shift + 3 * across)
        self._measure(start + shift, end + shift, d.text, angle)

    def _measure(self, start: QPointF, end: QPointF, text: str, angle: float) -> None:
        """A line with arrows and its text in a gap, or beside it where there is no room."""
        way = end - start
        length = math.hypot(way.x(), way.y())
        wide = self._width(text) + 6
        self._thin(start, end)
        if length > 1:
            for tip, sign in ((start, 1.0), (end, -1.0)):
                self._arrow(tip, sign * way / length)
        if length >= wide + 4 * _ARROW:
            self._text((start + end) / 2, text, angle, plate=True)
        else:
            reach = way / max(length, 1e-9) * (wide / 2 + 5)
            if angle == -90.0:
                self._text(end + reach, text, angle, plate=True)
            elif angle == 0.0:
                room = (start - reach).x() - wide / 2 > self.place.left()
                self._text(start - reach if room else end + reach, text, angle, plate=True)
            else:
                self._text((start + end) / 2 + 0.6 * self.line * QPointF(way.y(), -way.x()) / length, text, angle)

    def _arrow(self, tip: QPointF, way: QPointF) -> None:
        side = QPointF(-way.y(), way.x())
        self.painter.setPen(Qt.PenStyle.NoPen)
        self.painter.setBrush(QColor(self.colors.muted))
        foot = tip + _ARROW * way
        self.painter.drawPolygon(QPolygonF([tip, foot + 0.34 * _ARROW * side, foot - 0.34 * _ARROW * side]))

    def _thin(self, start: QPointF, end: QPointF) -> None:
        self.painter.setPen(QPen(QColor(self.colors.muted), 0.8))
        self.painter.drawLine(start, end)

    def _text(self, middle: QPointF, text: str, angle: float, plate: bool = False) -> None:
        painter = self.painter
        painter.save()
        painter.translate(middle)
        painter.rotate(angle if angle <= 90 else angle - 180)
        wide = self._width(text) + 6
        box = QRectF(-wide / 2, -self.line / 2, wide, self.line)
        if plate:
            painter.fillRect(box, QColor(self.colors.sunken))
        painter.setPen(QColor(self.colors.text))
        self._symbols(QPointF(box.left() + 3, self.metrics.ascent() - self.metrics.height() / 2), text)
        painter.restore()

    def _width(self, text: str) -> float:
        return sum(self._small(index).horizontalAdvance(part) for part, index in _pieces(text))

    def _small(self, index: bool) -> QFontMetricsF:
        return QFontMetricsF(self._font(index))

    def _font(self, index: bool) -> QFont:
        font = QFont(self.painter.font())
        font.setPointSizeF(self.size * (0.76 if index else 1.0))
        return font

    def _symbols(self, place: QPointF, text: str) -> None:
        """Draw text from its base line's start, letters after an underscore as indices."""
        painter = self.painter
        painter.save()
        for part, index in _pieces(text):
            painter.setFont(self._font(index))
            painter.drawText(place + QPointF(0, 0.22 * self.metrics.ascent() if index else 0), part)
            place = place + QPointF(self._small(index).horizontalAdvance(part), 0)
        painter.restore()


def _pieces(text: str) -> list[tuple[str, bool]]:
    """A text in pieces, each with whether it is an index."""
    return [(part.lstrip("_"), part.startswith("_")) for part in re.split(r"(_\w)", text) if part]
