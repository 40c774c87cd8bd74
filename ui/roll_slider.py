"""Rolls the tangent plane over the base cone: slider, play and pause, and the angle."""

from __future__ import annotations

from PySide6.QtCore import QElapsedTimer, QEvent, QSignalBlocker, Qt, QTimer, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSlider, QToolButton, QWidget

from ui.theme import icon
from ui.words import tr

STEPS = 1000
SECONDS_PER_SWEEP = 6.0
_TICK_MS = 33


class RollSlider(QWidget):
    """How far the tangent plane has rolled, from where the generating line enters the flank to where it leaves.

    Signals
    -------
    rolled(float)
        Place in [0, 1].
    """

    rolled = Signal(float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._span_deg = 0.0
        self._play = QToolButton(self, checkable=True, autoRaise=True)
        self._play.setToolTip(tr("Roll the plane and let the line sweep out the flank"))
        self._play.setAccessibleName(tr("Play"))
        self._play.toggled.connect(self._on_play_toggled)
        self._slider = QSlider(Qt.Orientation.Horizontal, self, maximum=STEPS, singleStep=5, pageStep=50, value=STEPS)
        self._slider.setAccessibleName(tr("Roll of the tangent plane"))
        self._slider.setMinimumWidth(120)
        self._slider.valueChanged.connect(self._on_slid)
        self._slider.sliderPressed.connect(self.pause)
        self._label = QLabel(self)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(6, 2, 8, 2)
        for widget, stretch in ((self._play, 0), (self._slider, 1), (self._label, 0)):
            layout.addWidget(widget, stretch)
        self._clock = QElapsedTimer()
        self._timer = QTimer(self, interval=_TICK_MS)
        self._timer.timeout.connect(self._advance)
        self._show_icon()
        self._show_angle()

    @property
    def roll(self) -> float:
        """Place in [0, 1]."""
        return self._slider.value() / STEPS

    @property
    def playing(self) -> bool:
        """Whether it rolls by itself."""
        return self._timer.isActive()

    def set_span(self, degrees: float) -> None:
        """Tell the roll angle of the whole flank, which the label counts up to."""
        self._span_deg = degrees
        reserve = self._label.fontMetrics().horizontalAdvance(self._text(degrees if degrees >= 100 else 88.8))
        self._label.setMinimumWidth(reserve)
        self._show_angle()

    def set_roll(self, roll: float) -> None:
        """Move the slider without a signal."""
        with QSignalBlocker(self._slider):
            self._slider.setValue(round(roll * STEPS))
        self._show_angle()

    def play(self) -> None:
        """Start rolling, from the beginning if at the end."""
        self._play.setChecked(True)

    def pause(self) -> None:
        """Stop where it is."""
        self._play.setChecked(False)

    def _on_play_toggled(self, on: bool) -> None:
        if on:
            if self._slider.value() >= STEPS:
                self._slider.setValue(0)
            self._clock.start()
            self._timer.start()
        else:
            self._timer.stop()
        self._show_icon()

    def _advance(self) -> None:
        value = self._slider.value() + max(1, round(self._clock.restart() / 1000 / SECONDS_PER_SWEEP * STEPS))
        self._slider.setValue(min(value, STEPS))
        if value >= STEPS:
            self.pause()

    def _on_slid(self, value: int) -> None:
        self._show_angle()
        self.rolled.emit(value / STEPS)

    def _text(self, degrees: float) -> str:
        return tr("Roll of the tangent plane: {degrees:.1f}°", degrees=degrees)

    def _show_angle(self) -> None:
        self._label.setText(self._text(self.roll * self._span_deg))

    def _show_icon(self) -> None:
        self._play.setIcon(icon("pause" if self._play.isChecked() else "play"))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and hasattr(self, "_play"):
            self._show_icon()
