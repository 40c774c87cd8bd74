"""Choices and sliders with a name, a tip and one signal for what the user does."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QSignalBlocker, QSize, Qt, Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QSlider, QWidget

_SLACK = 6


class QuietChoice(QComboBox):
    """One of a few, by identifier.

    Signals
    -------
    chosen(object)
        Identifier of what the user chose.
    """

    chosen = Signal(object)

    def __init__(self, rows: Sequence[tuple[object, str]], name: str, tip: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        for identifier, text in rows:
            self.addItem(text, identifier)
        self.setAccessibleName(name)
        self.setToolTip(tip)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        self.activated.connect(lambda index: self.chosen.emit(self.itemData(index)))

    def sizeHint(self) -> QSize:
        """A little wider than Qt's: letters of another script than the font's own are measured too small."""
        return super().sizeHint() + QSize(_SLACK, 0)

    def minimumSizeHint(self) -> QSize:
        """The same: no word is cut."""
        return self.sizeHint()

    def show_choice(self, identifier: object) -> None:
        """Show a choice without announcing it."""
        with QSignalBlocker(self):
            self.setCurrentIndex(max(self.findData(identifier), 0))


class QuietSlider(QWidget):
    """A whole number on a slider, with its value beside it.

    Signals
    -------
    moved(int)
        By the user.
    """

    moved = Signal(int)

    def __init__(self, low: int, high: int, pattern: str, name: str, tip: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._pattern = pattern
        self.slider = QSlider(Qt.Orientation.Horizontal, self, minimum=low, maximum=high)
        self.slider.setAccessibleName(name)
        self.setToolTip(tip)
        self.slider.setToolTip(tip)
        self._label = QLabel(self)
        self._label.setProperty("role", "muted")
        self._label.setMinimumWidth(self._label.fontMetrics().horizontalAdvance(pattern.format(high)) + 2)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.slider, 1)
        layout.addWidget(self._label)
        self.slider.valueChanged.connect(self._on_changed)
        self.show_value(low)

    def show_value(self, value: int) -> None:
        """Show a value without announcing it."""
        with QSignalBlocker(self.slider):
            self.slider.setValue(value)
        self._label.setText(self._pattern.format(self.slider.value()))

    def _on_changed(self, value: int) -> None:
        self._label.setText(self._pattern.format(value))
        self.moved.emit(value)
