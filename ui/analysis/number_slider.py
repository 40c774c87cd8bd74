"""A number with a slider over the usual range, and a box for any other value."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtGui import QValidator
from PySide6.QtWidgets import QDoubleSpinBox, QGridLayout, QLabel, QSlider

from ui.formatting import fixed, parse_number
from ui.units import INCH_EXTRA, factor, from_shown, to_shown, unit_shown

STEPS = 200
BARE = (
    "QDoubleSpinBox::up-button, QDoubleSpinBox::down-button { width: 0; border: none; }"
    "QDoubleSpinBox::up-arrow, QDoubleSpinBox::down-arrow { image: none; width: 0; height: 0; }"
)
"""A box without arrows: the style's own way to leave them out leaves no room for the number."""


class NumberBox(QDoubleSpinBox):
    """A box that writes numbers in the window's language and, as every field, reads point and comma."""

    def textFromValue(self, value: float) -> str:
        return fixed(value, self.decimals())

    def valueFromText(self, text: str) -> float:
        value = self._read(text)
        return self.value() if value is None else round(value, self.decimals())

    def validate(self, text: str, place: int) -> tuple[QValidator.State, str, int]:
        value = self._read(text)
        if value is None and any(letter.isalpha() for letter in text.removesuffix(self.suffix())):
            return QValidator.State.Invalid, text, place
        good = value is not None and self.minimum() <= value <= self.maximum()
        return QValidator.State.Acceptable if good else QValidator.State.Intermediate, text, place

    def _read(self, text: str) -> float | None:
        value = parse_number(text.removesuffix(self.suffix()))
        return None if isinstance(value, str) else float(value)


class NumberSlider:
    """Label, slider and box in one row of a grid."""

    def __init__(self, grid: QGridLayout, row: int, label: str, tip: str, unit: str, decimals: int) -> None:
        self._unit, self._decimals, self._value = unit, decimals, 0.0
        self._range, self._limits = (-1.0, 1.0), (-1.0, 1.0)
        self.label = QLabel(label)
        self.slider = QSlider(Qt.Orientation.Horizontal)
        self.slider.setRange(0, STEPS)
        self.box = NumberBox()
        self.box.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
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
        self.show_units()

    @property
    def value(self) -> float:
        """The number, in the unit of the design."""
        return self._value

    def set_range(self, low: float, high: float, *, most: float, least: float | None = None) -> None:
        """What the slider reaches, and what the box takes."""
        self._range, self._limits = (low, high), (-most if least is None else least, most)
        self._value = min(max(self._value, self._limits[0]), most)
        self.show_units()

    def show_units(self) -> None:
        """Show the number in the unit of lengths that the user chose now; it stays the same."""
        low, high = self._range
        with QSignalBlocker(self.box):
            self.box.setDecimals(self._decimals + (INCH_EXTRA if factor(self._unit) != 1 else 0))
            self.box.setSuffix(f" {unit_shown(self._unit)}")
            self.box.setRange(*(to_shown(limit, self._unit) for limit in self._limits))
            self.box.setSingleStep(to_shown((high - low) / STEPS, self._unit))
            self.box.setValue(to_shown(self._value, self._unit))
        self._show()

    def set_value(self, value: float) -> None:
        """Set the number; it is announced when it changes."""
        self.box.setValue(to_shown(value, self._unit))
        self._show()

    def _on_slid(self, step: int) -> None:
        low, high = self._range
        self.box.setValue(to_shown(low + (high - low) * step / STEPS, self._unit))

    def _on_typed(self, shown: float) -> None:
        self._value = from_shown(shown, self._unit)
        self._show()

    def _show(self) -> None:
        low, high = self._range
        with QSignalBlocker(self.slider):
            self.slider.setValue(round((self._value - low) / (high - low) * STEPS))
