"""The colour scale beside the views: shared, adjustable."""

from __future__ import annotations

import math

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtGui import QAction, QContextMenuEvent, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QMenu, QToolButton, QVBoxLayout, QWidget

from ui import colormap
from ui.views.color_scale import ColorScale
from ui.views.factors import factor_text
from ui.views.quantities import Quantity
from ui.views.range_editor import RangeEditor
from ui.words import tr


class ColorBar(ColorScale):
    """A colour scale whose range follows the data until the user sets it.

    The range that follows is rounded up. The user sets it by dragging an end of the bar, by the wheel with Ctrl, or by
    typing after a double click. The button below returns to automatic.

    Signals
    -------
    range_changed(float, float)
        From where to where the scale runs now [µm, 1/mm, ...].
    """

    range_changed = Signal(float, float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._data = self._range
        self._drag: tuple[float, tuple[float, float], bool] | None = None
        self.setObjectName("color_bar")
        self.setAccessibleName(tr("Colour scale"))
        self._auto = QToolButton(self, text=tr("Auto"), checkable=True, checked=True, autoRaise=True)
        self._auto.setToolTip(tr("Let the range follow the values shown"))
        self._auto.setAccessibleName(tr("Automatic range"))
        self._auto.setObjectName("automatic")
        self._auto.toggled.connect(self._on_automatic)
        self._editor = RangeEditor(self)
        self._editor.typed.connect(self._on_typed)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 4)
        layout.addStretch(1)
        layout.addWidget(self._auto, 0, Qt.AlignmentFlag.AlignHCenter)
        self._refresh()

    @property
    def limit(self) -> float:
        """Where the scale ends."""
        return self._range[1]

    @property
    def automatic(self) -> bool:
        """Whether the range follows the data."""
        return self._auto.isChecked()

    def show_scale(self, quantity: Quantity, colors: str, steps: int, unit: str) -> None:
        """Be the scale of a quantity in some colours; another quantity begins with its own range."""
        another = quantity != self._quantity
        super().show_scale(quantity, colors, steps, unit)
        if another:
            self.set_automatic(True)

    def set_data_limit(self, largest_um: float) -> None:
        """Tell the largest absolute deviation shown [µm]."""
        limit = colormap.nice_limit(largest_um)
        self.set_data_range((-limit, limit), (-largest_um, largest_um))

    def set_data_range(self, suitable: tuple[float, float], extent: tuple[float, float]) -> None:
        """Tell the range that suits what is shown, and its least and greatest value."""
        self._data, self._extent = suitable, extent
        if self.automatic:
            self._apply(suitable)
        self.update()

    def set_limit(self, limit: float) -> None:
        """Fix a symmetric range; automatic is off from here on."""
        limit = min(max(limit, colormap.LIMIT_MIN_UM), colormap.LIMIT_MAX_UM)
        self.set_range(-limit, limit)

    def set_range(self, low: float, high: float) -> None:
        """Fix the range; automatic is off from here on."""
        self.set_automatic(False)
        self._apply((low, high))

    def set_automatic(self, automatic: bool) -> None:
        """Let the range follow the data, or keep it where it is."""
        self._auto.setChecked(automatic)

    def _on_automatic(self, automatic: bool) -> None:
        if automatic:
            self._apply(self._data)

    def _apply(self, chosen: tuple[float, float]) -> None:
        if chosen != self._range:
            self._range = chosen
            self._refresh()
            self.range_changed.emit(*chosen)

    def _refresh(self) -> None:
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
        super()._refresh()

    def _foot(self) -> float:
        return self._auto.geometry().top()

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
        self._type_range()

    def _type_range(self) -> None:
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
        menu = self.make_menu()
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.popup(event.globalPos())

    def make_menu(self) -> QMenu:
        """Where the scale ends."""
        menu = QMenu(self)
        automatic = QAction(tr("Automatic range"), menu, checkable=True, checked=self.automatic)
        automatic.toggled.connect(self.set_automatic)
        menu.addAction(automatic)
        menu.addAction(tr("Type the range…"), self._type_range)
        if self._quantity.is_deviation:
            menu.addSeparator()
            for limit in (0.01, 0.05, 0.1, 0.5, 1.0, 5.0, 10.0, 50.0, 100.0):
                text = colormap.deviation_text(limit, signed=False, unit=self._unit)
                menu.addAction(f"±{text}", lambda value=limit: self.set_limit(value))
        return menu
