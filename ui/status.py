"""The status bar: the point under the pointer, the work in progress with its cancel button, the CAD process."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QProgressBar, QPushButton, QSizePolicy, QStatusBar, QWidget

from ui.formatting import micrometres
from ui.progress import set_progress
from ui.theme import tokens
from ui.units import spaced, value_text, with_unit
from ui.words import told, tr

if TYPE_CHECKING:
    from ui.picking import Hover

WORKER_STATES = {
    "starting": ("CAD kernel starting…", "warning"),
    "ready": ("CAD kernel ready", "ok"),
    "busy": ("CAD kernel busy", "accent"),
    "replaced": ("CAD kernel restarting…", "warning"),
    "stopped": ("CAD kernel stopped", "error"),
}


class Status(QStatusBar):
    """Shows what it is told.

    Signals
    -------
    cancel_requested()
    """

    cancel_requested = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizeGripEnabled(False)
        self.setContentsMargins(8, 0, 8, 0)
        self.point = QLabel()
        self.point.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.point.setToolTip(tr("The point of the flank under the pointer"))
        self._stage = QLabel()
        self._stage.setProperty("role", "muted")
        self._bar = QProgressBar()
        self._bar.setTextVisible(False)
        self._bar.setFixedWidth(130)
        self._bar.setRange(0, 1000)
        self._cancel = QPushButton(tr("Cancel"))
        self._cancel.setProperty("role", "flat")
        self._cancel.setToolTip(tr("Stop the work in progress (Esc)"))
        self._cancel.clicked.connect(self.cancel_requested)
        self._dot = Dot()
        self._worker = QLabel()
        words = (tr(text) for text, _ in WORKER_STATES.values())
        self._worker.setMinimumWidth(max(map(self._worker.fontMetrics().horizontalAdvance, words)))
        self._worker.setToolTip(tr("The process that builds flanks and solids"))
        self.addWidget(self.point, 1)
        self._work = _row(self._stage, self._bar, self._cancel)
        self.addPermanentWidget(self._work)
        self.addPermanentWidget(_row(self._dot, self._worker))
        self.show_worker("starting")
        self.show_work(None)
        self.setFixedHeight(max(self.sizeHint().height(), self._cancel.sizeHint().height() + 8))

    def show_worker(self, state: str) -> None:
        """State of the CAD process, one of `WORKER_STATES`."""
        text, color = WORKER_STATES[state]
        self._worker.setText(tr(text))
        self._dot.set_color(color)

    def show_work(self, text: str | None, fraction: float = 0.0) -> None:
        """What is being done and how far it is; None when nothing is."""
        self._work.setVisible(text is not None)
        if text is not None:
            self._stage.setText(text)
            set_progress(self._bar, fraction)

    def show_hover(self, hover: Hover | None) -> None:
        """The read-out of the point under the pointer."""
        self.point.setText("" if hover is None else hover_text(hover))

    def show_units(self) -> None:
        """The read-out waits for the next point."""
        self.show_hover(None)


class Dot(QWidget):
    """A small round lamp."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._color = "muted"
        self.setFixedSize(10, 10)

    def set_color(self, token: str) -> None:
        """Light up in a colour of the theme."""
        self._color = token
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(QColor(0, 0, 0, 0))
            painter.setBrush(QColor(getattr(tokens(), self._color)))
            painter.drawEllipse(1, 1, 8, 8)


def hover_text(hover: Hover) -> str:
    """The read-out of a point: flank, coordinates, cone distance, polar angle, deviation."""
    x, y, z = (value_text(value, "mm") for value in hover.xyz)
    rho, delta = with_unit(hover.rho, "mm"), with_unit(hover.delta_deg, "°")
    parts = [told(hover.flank), f"x {x}  y {y}  z {z}{spaced('mm')}", f"ρ {rho}", f"δ {delta}"]
    if hover.deviation_um is not None:
        parts.append(tr("deviation {value}", value=micrometres(hover.deviation_um)))
    return "    ".join(parts)


def _row(*widgets: QWidget) -> QWidget:
    box = QWidget()
    layout = QHBoxLayout(box)
    layout.setContentsMargins(8, 0, 4, 0)
    layout.setSpacing(7)
    for widget in widgets:
        layout.addWidget(widget)
    return box
