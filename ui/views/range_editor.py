"""A small window in which the ends of the colour scale are typed."""

from __future__ import annotations

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtWidgets import QFormLayout, QFrame, QLabel, QLineEdit, QWidget

from ui.formatting import parse_number, typed
from ui.words import tr


class RangeEditor(QFrame):
    """From where to where; for a symmetric scale only how far.

    Signals
    -------
    typed(float, float)
        Low and high, in the unit shown.
    """

    typed = Signal(float, float)

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent, Qt.WindowType.Popup)
        self.setProperty("role", "card")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose, False)
        self._symmetric = True
        self._words = [QLabel(), QLabel()]
        self._fields = [QLineEdit(), QLineEdit()]
        layout = QFormLayout(self)
        layout.setContentsMargins(10, 8, 10, 8)
        for label, field in zip(self._words, self._fields, strict=True):
            field.setFixedWidth(90)
            field.setAccessibleName(tr("End of the scale"))
            field.returnPressed.connect(self._on_return)
            layout.addRow(label, field)

    def open_at(self, place: QPoint, low: float, high: float, unit: str, symmetric: bool) -> None:
        """Show the ends for editing, the upper right corner at a place of the screen."""
        self._symmetric = symmetric
        self._words[0].setText(tr("Up to ± [{unit}]", unit=unit) if symmetric else tr("To [{unit}]", unit=unit))
        self._words[1].setText(tr("From [{unit}]", unit=unit))
        for field, value, name in zip(
            self._fields, (high, low), (tr("Upper end of the scale"), tr("Lower end of the scale")), strict=True
        ):
            field.setText(typed(value, 6))
            field.setAccessibleName(name)
            field.setToolTip(name)
        for widget in (self._words[1], self._fields[1]):
            widget.setVisible(not symmetric)
        self.adjustSize()
        self.move(place - QPoint(self.width(), 0))
        self.show()
        self._fields[0].setFocus()
        self._fields[0].selectAll()

    def _on_return(self) -> None:
        high, low = (parse_number(field.text()) for field in self._fields)
        if isinstance(high, str) or isinstance(low, str) or high is None or low is None:
            return
        if self._symmetric:
            low = -high
        if low < high:
            self.hide()
            self.typed.emit(float(low), float(high))
