"""The colour of a layer as a button, and the small window behind it: colour and opacity."""

from __future__ import annotations

from PySide6.QtCore import QPoint, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QColorDialog, QFormLayout, QFrame, QPushButton, QToolButton, QWidget

from ui.layers import LayerInfo
from ui.theme import is_dark, tokens
from ui.views.appearance import LayerLook
from ui.views.quiet import QuietSlider
from ui.words import tr

COLORED = "deviation"
"""The layer whose colour says something: only its opacity is the user's."""


class LayerSwatch(QToolButton):
    """A sample of a layer's colour; a click opens `LookEditor`.

    Signals
    -------
    look_changed(str, object)
        The layer's id and its `LayerLook` by the user.
    """

    look_changed = Signal(str, object)

    def __init__(self, info: LayerInfo, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._info, self._look = info, LayerLook()
        self.setFixedSize(24, 18)
        name = tr("Colour and opacity of {layer}", layer=tr(info.title))
        self.setAccessibleName(name)
        self.setToolTip(name)
        self.clicked.connect(self._open)

    @property
    def look(self) -> LayerLook:
        """What the user chose."""
        return self._look

    @property
    def color(self) -> QColor:
        """What the layer is drawn in."""
        return QColor(self._look.color or (self._info.ink.dark if is_dark() else self._info.ink.light))

    def show_look(self, look: LayerLook | None) -> None:
        """Show what was chosen, without announcing it."""
        self._look = look or LayerLook()
        self.update()

    def choose(self, look: LayerLook) -> None:
        """Show and announce another choice."""
        self.show_look(look)
        self.look_changed.emit(self._info.id, look)

    def _open(self) -> None:
        editor = LookEditor(self, self._info.id != COLORED)
        editor.move(self.mapToGlobal(QPoint(self.width() - editor.sizeHint().width(), self.height() + 2)))
        editor.show()

    def paintEvent(self, event: QPaintEvent) -> None:
        color = self.color
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            frame = QRectF(4, 3, 16, 12)
            painter.setPen(
                QPen(QColor(tokens().accent if self.hasFocus() or self.underMouse() else tokens().border), 1)
            )
            color.setAlphaF(1.0 if self._look.opacity is None else max(self._look.opacity, 0.08))
            painter.setBrush(color)
            painter.drawRoundedRect(frame, 3, 3)


class LookEditor(QFrame):
    """Colour, opacity and the way back."""

    def __init__(self, swatch: LayerSwatch, has_color: bool) -> None:
        super().__init__(swatch, Qt.WindowType.Popup)
        self.setProperty("role", "card")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._swatch = swatch
        layout = QFormLayout(self)
        layout.setContentsMargins(10, 8, 10, 8)
        tip = tr("How much of the layer one sees; as made, some layers are glass")
        self.opacity = QuietSlider(0, 100, "{} %", tr("Opacity"), tip)
        self.opacity.setMinimumWidth(150)
        self.opacity.show_value(100 if swatch.look.opacity is None else round(100 * swatch.look.opacity))
        self.opacity.moved.connect(self._on_opacity)
        layout.addRow(tr("Opacity"), self.opacity)
        if has_color:
            color = QPushButton(tr("Colour…"))
            color.setToolTip(tr("Choose another colour for this layer"))
            color.clicked.connect(self._choose_color)
            layout.addRow(color)
        reset = QPushButton(tr("As made"))
        reset.setProperty("role", "flat")
        reset.setToolTip(tr("Take colour and opacity back"))
        reset.clicked.connect(self._reset)
        layout.addRow(reset)

    def _on_opacity(self, percent: int) -> None:
        self._swatch.choose(LayerLook(self._swatch.look.color, percent / 100))

    def _choose_color(self) -> None:
        swatch = self._swatch
        self.close()
        chosen = QColorDialog.getColor(swatch.color, swatch.window(), tr("Colour of the layer"))
        if chosen.isValid():
            swatch.choose(LayerLook(chosen.name(), swatch.look.opacity))

    def _reset(self) -> None:
        self._swatch.choose(LayerLook())
        self.close()
