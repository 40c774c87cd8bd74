"""Switches of the layers that the views can show."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, QPointF, QRectF, QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPaintEvent, QPen
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QVBoxLayout, QWidget

from ui.card import ScrollCard
from ui.method_bar import Segments
from ui.theme import tokens
from ui.words import inline, tr

if TYPE_CHECKING:
    from ui.layers import LayerInfo
    from ui.views.appearance import LayerLook
    from ui.views.layer_swatch import LayerSwatch


class LayerPanel(QWidget):
    """An eye for each layer with its colour and opacity, and ready-made sets of layers.

    Signals
    -------
    layer_switched(str, bool)
    set_chosen(object)
        frozenset of the layers to show.
    look_changed(str, object)
        A layer's `LayerLook` by the user.
    """

    layer_switched = Signal(str, bool)
    set_chosen = Signal(object)
    look_changed = Signal(str, object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._boxes: dict[str, QCheckBox] = {}
        self._swatches: dict[str, LayerSwatch] = {}
        self._sets: dict[str, frozenset[str]] = {}
        self.sets = Segments((), tr("Set of layers"))
        card = ScrollCard((12, 8, 10, 8))
        self._rows = card.rows
        layout = QVBoxLayout(self)
        layout.setContentsMargins(2, 0, 8, 4)
        layout.setSpacing(6)
        layout.addWidget(self.sets)
        layout.addWidget(card, 1)

    def fill(self) -> None:
        """Make the rows, which needs the arrays' library: once, after the first paint."""
        from ui.layers import LAYER_SETS, LAYERS

        titles = {info.id: inline(info.title) for info in LAYERS}
        for name, ids in LAYER_SETS:
            words = ", ".join(title for layer_id, title in titles.items() if layer_id in ids)
            self.sets.add(name, name, tr("Show: {words}", words=words))
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

    def show_looks(self, looks: Mapping[str, LayerLook]) -> None:
        """Show the colours and opacities that the user chose."""
        for layer_id, swatch in self._swatches.items():
            swatch.show_look(looks.get(layer_id))

    def swatch(self, layer_id: str) -> LayerSwatch:
        """The colour button of a layer."""
        return self._swatches[layer_id]

    def _make_row(self, info: LayerInfo) -> QHBoxLayout:
        from ui.views.layer_swatch import LayerSwatch

        box = EyeBox(tr(info.title))
        box.setToolTip(tr(info.tooltip))
        box.toggled.connect(lambda on: self.layer_switched.emit(info.id, on))
        self._boxes[info.id] = box
        swatch = self._swatches[info.id] = LayerSwatch(info)
        swatch.look_changed.connect(self.look_changed)
        row = QHBoxLayout()
        row.setSpacing(8)
        row.addWidget(box, 1)
        row.addWidget(swatch)
        return row


class EyeBox(QCheckBox):
    """A check box whose mark is an eye, open or closed."""

    def paintEvent(self, event: QPaintEvent) -> None:
        colors = tokens()
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            middle, on = self.height() / 2, self.isChecked()
            ink = QColor(colors.text if on else colors.faint)
            if self.hasFocus() or self.underMouse():
                painter.setPen(Qt.PenStyle.NoPen)
                painter.setBrush(QColor(colors.hover))
                painter.drawRoundedRect(QRectF(0, 0, self.width(), self.height()), 4, 4)
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(QPen(ink, 1.5, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
            lids = QPainterPath(QPointF(2, middle))
            lids.quadTo(QPointF(9.5, middle + 8), QPointF(17, middle))
            if on:
                lids.quadTo(QPointF(9.5, middle - 8), QPointF(2, middle))
            painter.drawPath(lids)
            if on:
                painter.setBrush(ink)
                painter.drawEllipse(QPointF(9.5, middle), 2.0, 2.0)
            painter.setPen(QColor(colors.text))
            text = QRectF(24, 0, self.width() - 24, self.height())
            painter.drawText(text, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft, self.text())

    def sizeHint(self) -> QSize:
        return QSize(26 + self.fontMetrics().horizontalAdvance(self.text()), self.fontMetrics().height() + 4)

    def minimumSizeHint(self) -> QSize:
        return self.sizeHint()

    def hitButton(self, place: QPoint) -> bool:
        return self.rect().contains(place)
