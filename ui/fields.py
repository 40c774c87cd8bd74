"""Editors of single values; they never change a value by themselves and never refuse what is typed."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence, QWheelEvent
from PySide6.QtWidgets import QComboBox, QLineEdit, QWidget

from gearstudio.design import FieldSpec
from ui.formatting import choice_title, number_text, parse_number


class _Line(QLineEdit):
    """A line that leaves Undo and Redo to the window, which knows all fields."""

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            keys = QKeySequence.StandardKey
            if event.matches(keys.Undo) or event.matches(keys.Redo):
                event.ignore()
                return False
        return super().event(event)


class NumberField(_Line):
    """A number typed as text; Up and Down step it, the wheel does not.

    Signals
    -------
    value_edited(object)
        int or float, the raw text when it is no number, None when an optional field was emptied.
    """

    value_edited = Signal(object)

    def __init__(self, spec: FieldSpec, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._spec = spec
        self.textEdited.connect(self._on_text_edited)

    def value(self) -> Any:
        """What stands in the field, as :attr:`value_edited` would give it."""
        text = self.text()
        return None if self._spec.optional and not text.strip() else parse_number(text)

    def set_value(self, value: Any) -> None:
        """Show a value without announcing it; text that already means the same stays as typed."""
        if value is not None and value == self.value():
            return
        self.setText("" if value is None else value if isinstance(value, str) else number_text(value))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Up, Down: one step; Page Up, Page Down: ten."""
        steps = {Qt.Key.Key_Up: 1, Qt.Key.Key_Down: -1, Qt.Key.Key_PageUp: 10, Qt.Key.Key_PageDown: -10}
        count = steps.get(Qt.Key(event.key()))
        if count is None:
            super().keyPressEvent(event)
        else:
            self._step_by(count)

    def _step_by(self, count: int) -> None:
        value = self.value()
        if value is None:
            value = parse_number(self.placeholderText().split(" ")[0])
        if isinstance(value, str):
            return
        step = self._spec.step or (1 if self._spec.kind == "int" else 0.1)
        stepped = value + count * step
        if self._spec.minimum is not None and count < 0 and value >= self._spec.minimum:
            stepped = max(stepped, self._spec.minimum)
        if self._spec.maximum is not None and count > 0 and value <= self._spec.maximum:
            stepped = min(stepped, self._spec.maximum)
        self.setText(number_text(int(stepped) if self._spec.kind == "int" else round(stepped, 9)))
        self.value_edited.emit(self.value())

    def _on_text_edited(self) -> None:
        self.value_edited.emit(self.value())


class ChoiceField(QComboBox):
    """One of a few words; the wheel scrolls the form instead of changing the choice.

    Signals
    -------
    value_edited(object)
        The chosen value, as the design file writes it.
    """

    value_edited = Signal(object)

    def __init__(self, spec: FieldSpec, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(6)
        for choice in spec.choices or ():
            self.addItem(choice_title(choice), choice)
        self.activated.connect(lambda _index: self.value_edited.emit(self.value()))

    def value(self) -> Any:
        """The chosen value."""
        return self.currentData()

    def set_value(self, value: Any) -> None:
        """Show a choice without announcing it."""
        self.setCurrentIndex(self.findData(value))

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Left to the form."""
        event.ignore()


class TextField(_Line):
    """Free text.

    Signals
    -------
    value_edited(object)
        The text.
    """

    value_edited = Signal(object)

    def __init__(self, spec: FieldSpec, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.textEdited.connect(self.value_edited.emit)

    def value(self) -> Any:
        """The text."""
        return self.text()

    def set_value(self, value: Any) -> None:
        """Show a text without announcing it."""
        if value != self.text():
            self.setText("" if value is None else str(value))


Field = NumberField | ChoiceField | TextField


def make_field(spec: FieldSpec, parent: QWidget | None = None) -> Field:
    """The editor that suits a field's kind."""
    kinds: dict[str, type[NumberField] | type[ChoiceField] | type[TextField]] = {
        "int": NumberField,
        "float": NumberField,
        "choice": ChoiceField,
        "text": TextField,
    }
    return kinds[spec.kind](spec, parent)


def set_severity(widget: QWidget, severity: str) -> None:
    """Mark a widget ``"error"``, ``"warning"``, ``"ok"`` or ``""`` for the style sheet."""
    if widget.property("severity") != severity:
        widget.setProperty("severity", severity)
        widget.style().unpolish(widget)
        widget.style().polish(widget)
