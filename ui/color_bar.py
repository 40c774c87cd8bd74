"""The colour scale beside the views: shared, symmetric, adjustable."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QAction,
    QColor,
    QContextMenuEvent,
    QFont,
    QFontMetricsF,
    QImage,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QWheelEvent,
)
from PySide6.QtWidgets import QDoubleSpinBox, QMenu, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from ui import colormap

BAR_WIDTH = 16
_TICK, _GAP, _PAD = 4, 5, 8


class ColorBar(QWidget):
    """Slim vertical colour bar with round ticks.

    The range follows the data (rounded up) until the user sets it: by dragging along the bar, by
    the wheel, or by typing after a double click. The button below returns to automatic.

    Signals
    -------
    limit_changed(float)
        The scale now runs from -limit to +limit [µm].
    """

    limit_changed = Signal(float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._limit, self._data_limit, self._automatic = 1.0, 1.0, True
        self._marker: float | None = None
        self._drag: tuple[float, float] | None = None
        rgb = np.ascontiguousarray(colormap.table()[::-1, None, :])
        self._image = QImage(rgb.data, 1, len(rgb), 3, QImage.Format.Format_RGB888).copy()

        self.setObjectName("color_bar")
        self.setAccessibleName("Colour scale of the deviation")
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Expanding)
        self._auto = QToolButton(self, text="Auto", checkable=True, checked=True, autoRaise=True)
        self._auto.setToolTip("Let the range follow the largest deviation shown")
        self._auto.toggled.connect(self.set_automatic)
        self._spin = QDoubleSpinBox(self, decimals=4, minimum=1e-4, maximum=colormap.LIMIT_MAX_UM, suffix=" µm")
        self._spin.setStepType(QDoubleSpinBox.StepType.AdaptiveDecimalStepType)
        self._spin.setKeyboardTracking(False)
        self._spin.editingFinished.connect(self._on_typed)
        self._spin.hide()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 4)
        layout.addStretch(1)
        layout.addWidget(self._auto, 0, Qt.AlignmentFlag.AlignHCenter)
        self.setToolTip("Drag or scroll to change the range, double-click to type it")

    # ---- state ---------------------------------------------------------------------------------------

    @property
    def limit(self) -> float:
        """The scale runs from -limit to +limit [µm]."""
        return self._limit

    @property
    def automatic(self) -> bool:
        """Whether the range follows the data."""
        return self._automatic

    def set_data_limit(self, largest_um: float) -> None:
        """Tell the largest absolute deviation shown [µm]."""
        self._data_limit = largest_um
        if self._automatic:
            self._apply(colormap.nice_limit(largest_um))

    def set_limit(self, limit_um: float) -> None:
        """Fix the range; automatic is off from here on."""
        self._automatic = False
        self._auto.setChecked(False)
        self._apply(min(max(limit_um, colormap.LIMIT_MIN_UM), colormap.LIMIT_MAX_UM))

    def set_automatic(self, automatic: bool) -> None:
        """Let the range follow the data, or keep it where it is."""
        self._automatic = automatic
        self._auto.setChecked(automatic)
        if automatic:
            self._apply(colormap.nice_limit(self._data_limit))

    def set_marker(self, deviation_um: float | None) -> None:
        """Point at a value on the scale (that under the pointer), or at none."""
        if deviation_um != self._marker:
            self._marker = deviation_um
            self.update()

    def _apply(self, limit: float) -> None:
        if limit != self._limit:
            self._limit = limit
            self.update()
            self.limit_changed.emit(limit)

    # ---- painting ------------------------------------------------------------------------------------

    def sizeHint(self) -> QSize:
        return QSize(self._label_width() + BAR_WIDTH + _TICK + _GAP + 2 * _PAD, 260)

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
        top = 1.9 * line
        bottom = self._auto.geometry().top() - 0.9 * line
        return QRectF(_PAD, top, BAR_WIDTH, max(bottom - top, 20.0))

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHints(QPainter.RenderHint.Antialiasing | QPainter.RenderHint.SmoothPixmapTransform)
        bar = self._bar()
        text, line = self.palette().windowText().color(), QColor(self.palette().windowText().color())
        line.setAlphaF(0.35)
        painter.drawImage(bar, self._image, QRectF(0, 0.5, 1, self._image.height() - 1))
        painter.setPen(QPen(line, 1))
        painter.drawRect(bar.adjusted(-0.5, -0.5, 0.5, 0.5))
        unit, factor = colormap.unit_of(self._limit)
        painter.setPen(text)
        painter.drawText(
            QRectF(0, 4, self.width(), 1.4 * QFontMetricsF(self.font()).height()),
            Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop,
            unit,
        )
        self._paint_ticks(painter, bar, factor, text, line)
        if self._marker is not None:
            self._paint_marker(painter, bar, text)

    def _paint_ticks(self, painter: QPainter, bar: QRectF, factor: float, text: QColor, line: QColor) -> None:
        font = self._small_font()
        metrics = QFontMetricsF(font)
        painter.setFont(font)
        shown = self._limit * factor
        for value in colormap.ticks(shown, min(int(bar.height() / (2.4 * metrics.height())) + 1, 13)):
            y = bar.center().y() - value / shown * bar.height() / 2
            painter.setPen(QPen(line, 1))
            painter.drawLine(QPointF(bar.right() + 1, y), QPointF(bar.right() + 1 + _TICK, y))
            painter.setPen(text)
            box = QRectF(bar.right() + _TICK + _GAP, y - metrics.height() / 2, self.width(), metrics.height())
            painter.drawText(
                box,
                Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter,
                colormap.tick_label(float(value), shown),
            )

    def _paint_marker(self, painter: QPainter, bar: QRectF, color: QColor) -> None:
        place = min(max((self._marker or 0.0) / self._limit, -1.0), 1.0)
        y = bar.center().y() - place * bar.height() / 2
        painter.setPen(QPen(color, 1.5))
        painter.drawLine(QPointF(bar.left() - 3, y), QPointF(bar.right() + 3, y))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(color)
        painter.drawPolygon(
            [QPointF(bar.left() - 2, y), QPointF(bar.left() - 7, y - 4), QPointF(bar.left() - 7, y + 4)]
        )

    # ---- adjusting -----------------------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._drag = (event.position().y(), self._limit)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._drag is None:
            return
        start, limit = self._drag
        if abs(start - event.position().y()) > 3:
            scaled = limit * 10.0 ** ((start - event.position().y()) / max(self._bar().height(), 1.0))
            self.set_limit(float(f"{scaled:.2g}"))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._drag = None

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        self._spin.setValue(self._limit)
        self._spin.resize(self._spin.sizeHint().expandedTo(QSize(self.width() - 4, 0)))
        self._spin.setFixedWidth(self.width() - 4)
        self._spin.move(2, 2)
        self._spin.show()
        self._spin.raise_()
        self._spin.setFocus()
        self._spin.selectAll()

    def _on_typed(self) -> None:
        if self._spin.isVisible():
            self._spin.hide()
            if abs(self._spin.value() - self._limit) > 5e-5:
                self.set_limit(self._spin.value())

    def wheelEvent(self, event: QWheelEvent) -> None:
        step = event.angleDelta().y()
        if abs(step) >= 60:
            self.set_limit(colormap.next_limit(self._limit, 1 if step > 0 else -1))
        event.accept()

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        menu = QMenu(self)
        automatic = QAction("Automatic range", menu, checkable=True, checked=self._automatic)
        automatic.toggled.connect(self.set_automatic)
        menu.addAction(automatic)
        menu.addSeparator()
        for limit in (0.01, 0.05, 0.1, 0.5, 1.0, 5.0, 10.0, 50.0, 100.0):
            unit, factor = colormap.unit_of(limit)
            menu.addAction(f"±{limit * factor:g} {unit}", lambda value=limit: self.set_limit(value))
        menu.exec(event.globalPos())
        menu.deleteLater()
