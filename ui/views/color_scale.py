"""A colour scale as it is seen: a slim upright bar with round ticks, its unit, and a mark at a value."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from ui import colormap
from ui.views.factors import factor_text
from ui.views.quantities import DEVIATION, Quantity
from ui.views.scale_parts import POINT, paint_ends, paint_marker, picture

BAR_WIDTH = 16
_TICK, _GAP, _PAD = 4, 5, 8


class ColorScale(QWidget):
    """Shows a range in colours. A pointed end says that there are values beyond it."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._range, self._extent = (-1.0, 1.0), (0.0, 0.0)
        self._quantity, self._unit = DEVIATION, "auto"
        self._marker: float | None = None
        self._factor = 1
        self._image = picture("balance", 0)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Expanding)

    @property
    def range(self) -> tuple[float, float]:
        """From where to where the scale runs."""
        return self._range

    @property
    def quantity(self) -> Quantity:
        """What the scale is of."""
        return self._quantity

    def show_scale(self, quantity: Quantity, colors: str, steps: int, unit: str) -> None:
        """Be the scale of a quantity in some colours."""
        self._image = picture(colormap.suited(colors, quantity.symmetric), steps)
        self._quantity, self._unit = quantity, unit
        self._refresh()

    def show_exaggeration(self, factor: int) -> None:
        """Say how many times as large the deviation is drawn."""
        if factor != self._factor:
            self._factor = factor
            self._refresh()

    def show_units(self) -> None:
        """Show curvatures in the unit of lengths that the user chose now."""
        self._refresh()

    def show_like(self, other: ColorScale) -> None:
        """Look like another scale, for a picture."""
        self._image, self._unit, self._quantity = other._image, other._unit, other._quantity
        self._range, self._extent, self._factor = other._range, other._extent, other._factor
        self._refresh()

    def set_marker(self, value: float | None) -> None:
        """Point at a value on the scale (that under the pointer), or at none."""
        if value != self._marker:
            self._marker = value
            self.update()

    def ticks(self) -> list[tuple[float, str]]:
        """Values that are marked, and the words at them."""
        low, high = self._range
        _, factor = self._shown_unit()
        room = self._bar().height() / (2.4 * QFontMetricsF(self._small_font()).height())
        places = colormap.ticks(low * factor, high * factor, min(int(room) + 1, 13))
        reach = max(abs(low), abs(high)) * factor
        return [(x / factor, colormap.tick_label(float(x), reach, self._quantity.symmetric)) for x in places]

    def levels(self) -> list[float]:
        """Values at which contours are drawn: where the ticks are."""
        return [value for value, _ in self.ticks()]

    def _shown_unit(self) -> tuple[str, float]:
        return self._quantity.shown(max(abs(x) for x in self._range), self._unit)

    def _refresh(self) -> None:
        """What is shown has changed."""
        self.update()

    # ---- painting ------------------------------------------------------------------------------------

    def sizeHint(self) -> QSize:
        return QSize(self._label_width() + BAR_WIDTH + _TICK + _GAP + 2 * _PAD, 220)

    def minimumSizeHint(self) -> QSize:
        return self.sizeHint()

    def _small_font(self) -> QFont:
        font = QFont(self.font())
        font.setPointSizeF(max(font.pointSizeF() * 0.92, 7.0))
        return font

    def _label_width(self) -> int:
        return int(QFontMetricsF(self._small_font()).horizontalAdvance("\N{MINUS SIGN}0000")) + 1

    def _foot(self) -> float:
        """Down to where the scale may reach."""
        return self.height() - QFontMetricsF(self.font()).height()

    def _bar(self) -> QRectF:
        line = QFontMetricsF(self.font()).height()
        top = (1.9 if self._factor == 1 else 3.0) * line + POINT
        bottom = self._foot() - 0.9 * line - POINT / 2
        return QRectF(_PAD, top, BAR_WIDTH, max(bottom - top, 20.0))

    def paintEvent(self, event: QPaintEvent) -> None:
        with QPainter(self) as painter:
            painter.setRenderHints(QPainter.RenderHint.Antialiasing | QPainter.RenderHint.SmoothPixmapTransform)
            bar = self._bar()
            text, line = self.palette().windowText().color(), QColor(self.palette().windowText().color())
            line.setAlphaF(0.35)
            painter.drawImage(bar, self._image, QRectF(0, 0.5, 1, self._image.height() - 1))
            painter.setPen(QPen(line, 1))
            painter.drawRect(bar.adjusted(-0.5, -0.5, 0.5, 0.5))
            paint_ends(painter, bar, self._image, self._beyond())
            painter.setFont(self._small_font())
            painter.setPen(text)
            painter.drawText(
                QRectF(0, 4, self.width(), 2.6 * QFontMetricsF(self.font()).height()),
                Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop,
                "\n".join([self._shown_unit()[0], *[factor_text(self._factor)] * (self._factor != 1)]),
            )
            self._paint_ticks(painter, bar, text, line)
            if self._marker is not None:
                paint_marker(painter, bar, self._y(bar, self._marker), text)

    def _y(self, bar: QRectF, value: float) -> float:
        low, high = self._range
        return bar.bottom() - min(max((value - low) / (high - low), 0.0), 1.0) * bar.height()

    def _beyond(self) -> tuple[bool, bool]:
        """Whether there are values above the upper end, and below the lower one."""
        play = 1e-6 * (self._range[1] - self._range[0])
        return self._extent[1] > self._range[1] + play, self._extent[0] < self._range[0] - play

    def _paint_ticks(self, painter: QPainter, bar: QRectF, text: QColor, line: QColor) -> None:
        metrics = QFontMetricsF(painter.font())
        for value, label in self.ticks():
            y = self._y(bar, value)
            painter.setPen(QPen(line, 1))
            painter.drawLine(QPointF(bar.right() + 1, y), QPointF(bar.right() + 1 + _TICK, y))
            painter.setPen(text)
            box = QRectF(bar.right() + _TICK + _GAP, y - metrics.height() / 2, self.width(), metrics.height())
            painter.drawText(box, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, label)
