"""Turns the pair in mesh: play and pause, single steps, speed, and the pinion's angle on a slider."""

from __future__ import annotations

from PySide6.QtCore import QElapsedTimer, QEvent, QSignalBlocker, Qt, QTimer, Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QSlider, QToolButton, QWidget

from ui.formatting import MINUS, number
from ui.theme import refresh_icons, set_icon
from ui.words import tr

STEPS_PER_DEGREE = 10
TEETH_PER_SECOND = 1.0
STEPS_PER_TOOTH = 12
SPEEDS = (0.1, 0.25, 0.5, 1.0, 2.0, 5.0)
_LEAST_TICK_MS = 16


class MeshBar(QWidget):
    """The pinion's turn [degrees], one full turn on the slider; it goes round.

    Signals
    -------
    turned(float)
        Angle of the pinion [degrees], 0 to 360.
    """

    turned = Signal(float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._angle, self._teeth, self._ratio = 0.0, 17, 1.0
        self.frame_ms = 0.0
        self._play = self._button("play", tr("Turn the pair in mesh"), self._toggle)
        self._back = self._button("step-back", tr("Back by a twelfth of a tooth"), lambda: self.step(-1))
        self._on = self._button("step-on", tr("On by a twelfth of a tooth"), lambda: self.step(1))
        self._slider = QSlider(Qt.Orientation.Horizontal, self, maximum=360 * STEPS_PER_DEGREE, pageStep=100)
        self._slider.setAccessibleName(tr("Turn of the pinion"))
        self._slider.setMinimumWidth(90)
        self._slider.valueChanged.connect(lambda value: self._take(value / STEPS_PER_DEGREE))
        self._slider.sliderPressed.connect(self.pause)
        self._speed = QComboBox(self)
        self._speed.setToolTip(tr("Speed; at 1× one tooth passes each second"))
        self._speed.setAccessibleName(tr("Speed"))
        for speed in SPEEDS:
            self._speed.addItem(f"{number(speed, 'g')}×", speed)
        self._speed.setCurrentIndex(SPEEDS.index(0.5))
        self._label = QLabel(self)
        self._label.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(6, 2, 8, 2)
        layout.setSpacing(4)
        for widget in (self._play, self._back, self._on, self._slider, self._speed, self._label):
            layout.addWidget(widget, 1 if widget is self._slider else 0)
        self._clock = QElapsedTimer()
        self._timer = QTimer(self, singleShot=True)
        self._timer.timeout.connect(self._advance)
        self._show()

    @property
    def angle(self) -> float:
        """Turn of the pinion [degrees]."""
        return self._angle

    @property
    def playing(self) -> bool:
        """Whether it turns by itself."""
        return self._timer.isActive()

    def set_pair(self, pinion_teeth: int, wheel_teeth: int) -> None:
        """Tell the numbers of teeth."""
        self._teeth, self._ratio = pinion_teeth, pinion_teeth / wheel_teeth
        self._label.setMinimumWidth(self._label.fontMetrics().horizontalAdvance(self._text(355.55)) + 4)
        self._show()

    def play(self) -> None:
        """Start turning."""
        if not self.playing:
            self._clock.start()
            self._timer.start(0)
            set_icon(self._play, "pause")

    def pause(self) -> None:
        """Stop where it is."""
        if self.playing:
            self._timer.stop()
            set_icon(self._play, "play")

    def step(self, count: int) -> None:
        """Turn on by so many twelfths of a tooth."""
        self.pause()
        self._turn_to(self._angle + count * 360 / self._teeth / STEPS_PER_TOOTH)

    def _toggle(self) -> None:
        self.pause() if self.playing else self.play()

    def _advance(self) -> None:
        elapsed = min(self._clock.restart() / 1000, 0.25)
        self._turn_to(self._angle + elapsed * self._speed.currentData() * TEETH_PER_SECOND * 360 / self._teeth)
        self._timer.start(max(_LEAST_TICK_MS, round(1.2 * self.frame_ms)))

    def _turn_to(self, angle: float) -> None:
        self._take(angle % 360)
        with QSignalBlocker(self._slider):
            self._slider.setValue(round(self._angle * STEPS_PER_DEGREE))

    def _take(self, angle: float) -> None:
        self._angle = angle
        self._show()
        self.turned.emit(angle)

    def _text(self, angle: float) -> str:
        turned = [round(one, 1) + 0.0 for one in (angle, -angle * self._ratio)]
        return tr("Pinion {pinion:.1f}° · wheel {wheel:.1f}°", pinion=turned[0], wheel=turned[1]).replace("-", MINUS)

    def _show(self) -> None:
        self._label.setText(self._text(self._angle))

    def _button(self, icon_name: str, tip: str, action: object) -> QToolButton:
        button = QToolButton(self, autoRaise=True)
        button.setToolTip(tip)
        button.setAccessibleName(tip)
        set_icon(button, icon_name)
        button.clicked.connect(action)
        return button

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            refresh_icons(self)
