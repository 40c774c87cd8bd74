"""The tour: a few cards that point at the parts of the window, at the first start or on request."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QApplication, QFrame, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from ui.theme import tokens
from ui.words import noted, tr

if TYPE_CHECKING:
    from ui.main_window import MainWindow

SEEN = "help/tour_seen"
_WIDTH, _GAP = 330, 12


@dataclass(frozen=True)
class Step:
    """A card: its title, its text, and the part of the window that it points at."""

    title: str
    text: str
    part: Callable[[MainWindow], QWidget]


STEPS = (
    Step(
        noted("The design"),
        noted("Every value of the pair; an offset makes it hypoid. Change one and everything follows, or its problem "
              "is told at its field. Shift+F1 explains a field, Ctrl+F1 shows its equation."),
        lambda window: window.form,
    ),
    Step(
        noted("Three methods, two variants"),
        noted("Which method and which variant is shown: as the paper has it, or refined until it meets the tolerance."),
        lambda window: window.method_bar,
    ),
    Step(
        noted("The views"),
        noted("Drag turns, the wheel zooms, a double click centres. Point at a flank to read its deviation there."),
        lambda window: window.area,
    ),
    Step(
        noted("Layers"),
        noted("What is drawn: deviation, exact flank, sections and points, and how the flank comes about."),
        lambda window: window.layer_panel,
    ),
    Step(
        noted("Analysis"),
        noted("The methods side by side, charts, tooth contact, the data sheet, and measured points."),
        lambda window: window.analysis,
    ),
    Step(
        noted("Files and help"),
        noted("Samples, export and the report are under File; the guide, the equations and this tour under Help."),
        lambda window: window.menuBar(),
    ),
)  # fmt: skip


class Ring(QWidget):
    """A frame around a part of the window that lets the mouse through."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the frame."""
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(QPen(QColor(tokens().accent), 3))
            painter.drawRoundedRect(self.rect().adjusted(2, 2, -2, -2), 7, 7)


class Card(QFrame):
    """Title and text of a step with the buttons to go on, back or away."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setProperty("role", "card")
        self.setAccessibleName(tr("Tour"))
        self.setFixedWidth(_WIDTH)
        self.title, self.text, self.count = QLabel(), QLabel(), QLabel()
        self.title.setProperty("role", "heading")
        self.text.setWordWrap(True)
        self.count.setProperty("role", "muted")
        self.skip, self.back, self.next = QPushButton(tr("S&kip")), QPushButton(tr("&Back")), QPushButton()
        self.skip.setToolTip(tr("Leave the tour; Help ▸ Tour starts it again"))
        self.back.setToolTip(tr("The step before"))
        self.next.setToolTip(tr("Go on"))
        row = QHBoxLayout()
        row.addWidget(self.count)
        row.addStretch(1)
        for button in (self.skip, self.back, self.next):
            row.addWidget(button)
        column = QVBoxLayout(self)
        column.setContentsMargins(14, 10, 14, 10)
        for label in (self.title, self.text):
            column.addWidget(label)
        column.addLayout(row)


class Tour(QObject):
    """Leads through the window, step by step; parts that are not in sight are left out.

    Signals
    -------
    ended()
    """

    ended = Signal()

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._steps: list[Step] = []
        self._at = 0
        self.card: Card | None = None
        self.ring: Ring | None = None

    @property
    def running(self) -> bool:
        """Whether a card is in sight."""
        return self.card is not None

    def offer(self) -> None:
        """Start at the first start of the program, and only then; a question that is open has the next one wait."""
        settings = self._window.settings
        if settings is not None and not settings.value(SEEN) and QApplication.activeModalWidget() is None:
            self.start()

    def start(self) -> None:
        """Begin with the first step."""
        self.end()
        self._steps = [step for step in STEPS if step.part(self._window).isVisible()]
        if not self._steps:
            return
        self._at = 0
        self.ring, self.card = Ring(self._window), Card(self._window)
        self.card.next.clicked.connect(lambda: self._go(1))
        self.card.back.clicked.connect(lambda: self._go(-1))
        self.card.skip.clicked.connect(self.end)
        self._window.installEventFilter(self)
        self._show()

    def end(self) -> None:
        """Leave, and remember that the tour was seen."""
        if self.card is None or self.ring is None:
            return
        self._window.removeEventFilter(self)
        for widget in (self.card, self.ring):
            widget.hide()
            widget.deleteLater()
        self.card = self.ring = None
        if self._window.settings is not None:
            self._window.settings.setValue(SEEN, True)
        self.ended.emit()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Follow the window's size."""
        if event.type() in (QEvent.Type.Resize, QEvent.Type.LayoutRequest):
            self._place()
        return super().eventFilter(watched, event)

    def _go(self, by: int) -> None:
        self._at += by
        if self._at >= len(self._steps):
            self.end()
        else:
            self._show()

    def _show(self) -> None:
        assert self.card is not None
        step, last = self._steps[self._at], self._at == len(self._steps) - 1
        self.card.title.setText(tr(step.title))
        self.card.text.setText(tr(step.text))
        self.card.count.setText(tr("{number} of {count}", number=self._at + 1, count=len(self._steps)))
        self.card.back.setEnabled(self._at > 0)
        self.card.next.setText(tr("&Done") if last else tr("&Next"))
        self._place()

    def _place(self) -> None:
        if self.card is None or self.ring is None:
            return
        part = self._steps[self._at].part(self._window)
        around = QRect(part.mapTo(self._window, QPoint(0, 0)), part.size()).adjusted(-3, -3, 3, 3)
        inside = self._window.rect().adjusted(4, 4, -4, -4)
        self.ring.setGeometry(around & inside)
        self.card.adjustSize()
        self.card.move(card_place(around, self.card.rect(), inside))
        for widget in (self.ring, self.card):
            widget.show()
            widget.raise_()


def card_place(part: QRect, card: QRect, inside: QRect) -> QPoint:
    """Where a card stands beside a part of the window: to its right, left, below or above, else in its middle."""
    width, height = card.width(), card.height()
    top = max(inside.top(), min(part.top() + _GAP, inside.bottom() - height))
    left = max(inside.left(), min(part.left() + _GAP, inside.right() - width))
    for place in (
        QPoint(part.right() + _GAP, top),
        QPoint(part.left() - _GAP - width, top),
        QPoint(left, part.bottom() + _GAP),
        QPoint(left, part.top() - _GAP - height),
    ):
        if inside.contains(QRect(place, card.size())):
            return place
    return part.center() - QPoint(width // 2, height // 2)
