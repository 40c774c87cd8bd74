"""Switches of the layers that the views can show."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QCheckBox, QFrame, QHBoxLayout, QScrollArea, QVBoxLayout, QWidget

from ui.method_bar import Segments
from ui.theme import is_dark

if TYPE_CHECKING:
    from ui.layers import LayerInfo


class LayerPanel(QWidget):
    """A check box for each layer with a sample of its colour, and ready-made sets of layers.

    Signals
    -------
    layer_switched(str, bool)
    set_chosen(object)
        frozenset of the layers to show.
    """

    layer_switched = Signal(str, bool)
    set_chosen = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._boxes: dict[str, QCheckBox] = {}
        self._sets: dict[str, frozenset[str]] = {}
        self.sets = Segments((), "Set of layers")
        page = QWidget()
        page.setProperty("role", "page")
        self._rows = QVBoxLayout(page)
        self._rows.setContentsMargins(12, 8, 10, 8)
        self._rows.setSpacing(7)
        scroll = QScrollArea()
        scroll.setWidgetResizable(True)
        scroll.setFrameShape(QFrame.Shape.NoFrame)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setWidget(page)
        card = QFrame()
        card.setProperty("role", "card")
        inside = QVBoxLayout(card)
        inside.setContentsMargins(1, 2, 1, 2)
        inside.addWidget(scroll)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(2, 0, 8, 4)
        layout.setSpacing(6)
        layout.addWidget(self.sets)
        layout.addWidget(card, 1)

    def fill(self) -> None:
        """Make the rows, which needs the arrays' library: once, after the first paint."""
        from ui.layers import LAYER_SETS, LAYERS

        titles = {info.id: info.title.lower() for info in LAYERS}
        for name, ids in LAYER_SETS:
            words = ", ".join(title for layer_id, title in titles.items() if layer_id in ids)
            self.sets.add(name, name, f"Show: {words}")
        self._sets = dict(LAYER_SETS)
        self.sets.chosen.connect(lambda name: self.set_chosen.emit(self._sets[name]))
        for info in LAYERS:
            self._rows.addLayout(self._make_row(info))
        self._rows.addStretch(1)

    def box(self, layer_id: str) -> QCheckBox:
        """The check box of a layer."""
        return self._boxes[layer_id]

    def show_visible(self, layer_ids: Collection[str]) -> None:
        """Show which layers are on without announcing it."""
        for layer_id, box in self._boxes.items():
            with QSignalBlocker(box):
                box.setChecked(layer_id in layer_ids)
        for name, ids in self._sets.items():
            if ids == frozenset(layer_ids):
                self.sets.set_choice(name)
                return
        self.sets.clear_choice()

    def _make_row(self, info: LayerInfo) -> QHBoxLayout:
        box = QCheckBox(info.title)
        box.setToolTip(info.tooltip)
        box.toggled.connect(lambda on: self.layer_switched.emit(info.id, on))
        self._boxes[info.id] = box
        row = QHBoxLayout()
        row.setSpacing(8)
        row.addWidget(box, 1)
        row.addWidget(Swatch(info))
        return row


class Swatch(QWidget):
    """A sample of a layer's colour."""

    def __init__(self, info: LayerInfo, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._ink = info.ink
        self.setFixedSize(16, 12)
        self.setToolTip(info.tooltip)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(self._ink.dark if is_dark() else self._ink.light))
        painter.drawRoundedRect(self.rect(), 3, 3)
