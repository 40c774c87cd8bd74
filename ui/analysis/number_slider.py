"""A number with a slider over the usual range, and a box for any other value."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QDoubleSpinBox, QGridLayout, QLabel, QSlider

STEPS = 200
BARE = (
    "QDoubleSpinBox::up-button, QDoubleSpinBox::down-button { width: 0; border: none; }"
    "QDoubleSpinBox::up-arrow, QDoubleSpinBox::down-arrow { image: none; width: 0; height: 0; }"
)
"""A box without arrows: the style's own way to leave them out leaves no room for the number."""


class NumberSlider:
    """Label, slider and box in one row of a grid."""

    def __init__(self, grid: QGridLayout, row: int, label: str, tip: str, unit: str, decimals: int) -> None:
        self._range = (-1.0, 1.0)
        self.label = QLabel(label)
        self.slider = QSlider(Qt.Orientation.Horizontal)
        self.slider.setRange(0, STEPS)
        self.box = QDoubleSpinBox()
        self.box.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.box.setDecimals(decimals)
        self.box.setSuffix(f" {unit}")
        self.box.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.box.setFixedWidth(88)
        self.box.setStyleSheet(BARE)
        self.box.setKeyboardTracking(False)
        for column, widget in enumerate((self.label, self.slider, self.box)):
            widget.setToolTip(tip)
            grid.addWidget(widget, row, column)
        self.slider.setAccessibleName(label)
        self.box.setAccessibleName(label)
        self.slider.valueChanged.connect(self._on_slid)
        self.box.valueChanged.connect(self._on_typed)
        self.changed = self.box.valueChanged

    @property
    def value(self) -> float:
        """The number."""
        return self.box.value()

    def set_range(self, low: float, high: float, *, most: float, least: float | None = None) -> None:
        """What the slider reaches, and what the box takes."""
        self._range = (low, high)
        with QSignalBlocker(self.box):
            self.box.setRange(-most if least is None else least, most)
            self.box.setSingleStep((high - low) / STEPS)
        self._show()

    def set_value(self, value: float) -> None:
        """Set the number; it is announced when it changes."""
        self.box.setValue(value)
        self._show()

    def _on_slid(self, step: int) -> None:
        low, high = self._range
        self.box.setValue(low + (high - low) * step / STEPS)

    def _on_typed(self, _value: float) -> None:
        self._show()

    def _show(self) -> None:
        low, high = self._range
        with QSignalBlocker(self.slider):
            self.slider.setValue(round((self.box.value() - low) / (high - low) * STEPS))
