"""The colour scale beside the views: shared, adjustable."""

from __future__ import annotations

import math

from PySide6.QtCore import QPoint, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QAction,
    QColor,
    QContextMenuEvent,
    QFont,
    QFontMetricsF,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QWheelEvent,
)
from PySide6.QtWidgets import QMenu, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from ui import colormap
from ui.views.factors import factor_text
from ui.views.quantities import DEVIATION, Quantity
from ui.views.range_editor import RangeEditor
from ui.views.scale_parts import POINT, paint_ends, paint_marker, picture
from ui.words import tr

BAR_WIDTH = 16
_TICK, _GAP, _PAD = 4, 5, 8


class ColorBar(QWidget):
    """Slim vertical colour bar with round ticks.

    The range follows the data (rounded up) until the user sets it: by dragging an end of the bar, by the wheel
    with Ctrl, or by typing after a double click. The button below returns to automatic. A pointed end says that there
    are values beyond it.

    Signals
    -------
    range_changed(float, float)
        From where to where the scale runs now [µm, 1/mm, ...].
    """

    range_changed = Signal(float, float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._range, self._data, self._extent, self._automatic = (-1.0, 1.0), (-1.0, 1.0), (0.0, 0.0), True
        self._quantity, self._unit = DEVIATION, "auto"
        self._marker: float | None = None
        self._factor = 1
        self._drag: tuple[float, tuple[float, float], bool] | None = None
        self._image = picture("balance", 0)

        self.setObjectName("color_bar")
        self.setAccessibleName(tr("Colour scale"))
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Expanding)
        self._auto = QToolButton(self, text=tr("Auto"), checkable=True, checked=True, autoRaise=True)
        self._auto.setToolTip(tr("Let the range follow the values shown"))
        self._auto.setAccessibleName(tr("Automatic range"))
        self._auto.toggled.connect(self.set_automatic)
        self._editor = RangeEditor(self)
        self._editor.typed.connect(self._on_typed)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 4)
        layout.addStretch(1)
        layout.addWidget(self._auto, 0, Qt.AlignmentFlag.AlignHCenter)
        self._tell()

    # ---- state ---------------------------------------------------------------------------------------

    @property
    def limit(self) -> float:
        """Where the scale ends."""
        return self._range[1]

    @property
    def range(self) -> tuple[float, float]:
        """From where to where the scale runs."""
        return self._range

    @property
    def automatic(self) -> bool:
        """Whether the range follows the data."""
        return self._automatic

    @property
    def quantity(self) -> Quantity:
        """What the scale is of."""
        return self._quantity

    def show_scale(self, quantity: Quantity, colors: str, steps: int, unit: str) -> None:
        """Be the scale of a quantity in some colours; another quantity begins with its own range."""
        self._image, self._unit = picture(colormap.suited(colors, quantity.symmetric), steps), unit
        if quantity != self._quantity:
            self._quantity = quantity
            self.set_automatic(True)
        self._tell()
        self.update()

    def show_exaggeration(self, factor: int) -> None:
        """Say how many times as large the deviation is drawn."""
        if factor != self._factor:
            self._factor = factor
            self._tell()
            self.update()

    def show_units(self) -> None:
        """Show curvatures in the unit of lengths that the user chose now."""
        self._tell()
        self.update()

    def show_like(self, other: ColorBar) -> None:
        """Be a copy of another scale, for a picture: its range stays, and the button is gone."""
        self._image, self._unit, self._quantity = other._image, other._unit, other._quantity
        self._extent, self._automatic = other._extent, other._automatic
        self._range, self._factor = other._range, other._factor
        self._auto.hide()

    def set_data_limit(self, largest_um: float) -> None:
        """Tell the largest absolute deviation shown [µm]."""
        limit = colormap.nice_limit(largest_um)
        self.set_data_range((-limit, limit), (-largest_um, largest_um))

    def set_data_range(self, suitable: tuple[float, float], extent: tuple[float, float]) -> None:
        """Tell the range that suits what is shown, and its least and greatest value."""
        self._data, self._extent = suitable, extent
        if self._automatic:
            self._apply(suitable)
        self.update()

    def set_limit(self, limit: float) -> None:
        """Fix a symmetric range; automatic is off from here on."""
        limit = min(max(limit, colormap.LIMIT_MIN_UM), colormap.LIMIT_MAX_UM)
        self.set_range(-limit, limit)

    def set_range(self, low: float, high: float) -> None:
        """Fix the range; automatic is off from here on."""
        self._automatic = False
        self._auto.setChecked(False)
        self._apply((low, high))

    def set_automatic(self, automatic: bool) -> None:
        """Let the range follow the data, or keep it where it is."""
        self._automatic = automatic
        self._auto.setChecked(automatic)
        if automatic:
            self._apply(self._data)

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

    def _apply(self, chosen: tuple[float, float]) -> None:
        if chosen != self._range:
            self._range = chosen
            self._tell()
            self.update()
            self.range_changed.emit(*chosen)

    def _tell(self) -> None:
        unit, _ = self._shown_unit()
        words = tr(
            "{title} [{unit}]\nDrag an end of the bar to change the range, double-click to type it. "
            "Grey: no value there",
            title=tr(self._quantity.title),
            unit=unit,
        )
        if self._factor != 1:
            factor = factor_text(self._factor)
            words += "\n" + tr("Flanks are drawn with their deviation {factor}", factor=factor)
        self.setToolTip(words)

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

    def _bar(self) -> QRectF:
        line = QFontMetricsF(self.font()).height()
        top = (1.9 if self._factor == 1 else 3.0) * line + POINT
        below = self._auto.geometry().top() if not self._auto.isHidden() else self.height() - line
        bottom = below - 0.9 * line - POINT / 2
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

    # ---- adjusting -----------------------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._drag = (event.position().y(), self._range, event.position().y() < self._bar().center().y())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._drag is None:
            return
        start, (low, high), upper = self._drag
        moved = (start - event.position().y()) / max(self._bar().height(), 1.0)
        if abs(start - event.position().y()) <= 3:
            return
        if self._quantity.symmetric:
            self.set_limit(float(f"{high * 10.0**moved:.2g}"))
            return
        end = (high if upper else low) + moved * (high - low)
        step = 10.0 ** math.floor(math.log10((high - low) / 50))
        end = round(end / step) * step
        if (low < end) if upper else (end < high):
            self.set_range(low if upper else end, end if upper else high)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._drag = None

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        unit, factor = self._shown_unit()
        low, high = (end * factor for end in self._range)
        self._editor.open_at(self.mapToGlobal(QPoint(0, 8)), low, high, unit, self._quantity.symmetric)

    def _on_typed(self, low: float, high: float) -> None:
        _, factor = self._shown_unit()
        self.set_range(low / factor, high / factor)

    def wheelEvent(self, event: QWheelEvent) -> None:
        step = event.angleDelta().y()
        wanted = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        if wanted and self._quantity.symmetric and abs(step) >= 60:
            self.set_limit(colormap.next_limit(self.limit, 1 if step > 0 else -1))
        event.accept()

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        menu = QMenu(self)
        automatic = QAction(tr("Automatic range"), menu, checkable=True, checked=self._automatic)
        automatic.toggled.connect(self.set_automatic)
        menu.addAction(automatic)
        if self._quantity.is_deviation:
            menu.addSeparator()
            for limit in (0.01, 0.05, 0.1, 0.5, 1.0, 5.0, 10.0, 50.0, 100.0):
                text = colormap.deviation_text(limit, signed=False, unit=self._unit)
                menu.addAction(f"±{text}", lambda value=limit: self.set_limit(value))
        menu.exec(event.globalPos())
        menu.deleteLater()
