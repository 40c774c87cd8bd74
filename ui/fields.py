"""Editors of single values; they never change a value by themselves and never refuse what is typed."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import QComboBox, QLineEdit, QWidget

from gearstudio.design import FieldSpec
from ui.formatting import NUMBER, choice_title, parse_number
from ui.units import factor, from_shown, shown_text, spaced, to_shown
from ui.words import tr


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
    """A number or a sum typed as text; Up and Down step it. Lengths are shown and typed in the user's unit.

    Signals
    -------
    value_edited(object)
        int or float in the design's unit, the raw text when it is no number, None when an optional field was emptied.
    """

    value_edited = Signal(object)

    def __init__(self, spec: FieldSpec, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._spec = spec
        self._shown: tuple[str, Any] = ("", None)
        self.textEdited.connect(self._on_text_edited)
        self.editingFinished.connect(self._work_out)

    def value(self) -> Any:
        """What stands in the field, as :attr:`value_edited` would give it."""
        return self._shown[1] if self.text() == self._shown[0] else read_number(self.text(), self._spec)[0]

    @property
    def problem(self) -> str:
        """Why a sum has no value; empty when it has, or when no sum was typed."""
        return read_number(self.text(), self._spec)[1] if isinstance(self.value(), str) else ""

    @property
    def result_text(self) -> str:
        """The value of a sum with its unit; empty when a plain number stands in the field."""
        value = self.value()
        if isinstance(value, str | None) or not isinstance(parse_number(self.text()), str):
            return ""
        return f"= {shown_text(value, self._spec.unit)}{spaced(self._spec.unit)}"

    def set_value(self, value: Any) -> None:
        """Show a value without announcing it; text that already means the same stays as typed."""
        if value != self.value():
            self._put(value)

    def show_units(self) -> None:
        """Show the same value in the unit that the user chose now."""
        value = self._shown[1]
        if not isinstance(value, str | None):
            self._put(value)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Up, Down: one step; Page Up, Page Down: ten."""
        steps = {Qt.Key.Key_Up: 1, Qt.Key.Key_Down: -1, Qt.Key.Key_PageUp: 10, Qt.Key.Key_PageDown: -10}
        count = steps.get(Qt.Key(event.key()))
        if count is None:
            super().keyPressEvent(event)
        else:
            self._step_by(count)

    def _put(self, value: Any) -> None:
        plain = "" if value is None else value if isinstance(value, str) else shown_text(value, self._spec.unit)
        self._shown = (plain, value)
        self.setText(plain)

    def _step_by(self, count: int) -> None:
        value = self.value()
        if value is None:
            value = read_number(self.placeholderText().split(" ")[0], self._spec)[0]
        if isinstance(value, str | None):
            return
        spec, unit = self._spec, self._spec.unit
        step = spec.step or (1 if spec.kind == "int" else 0.1)
        if factor(unit) != 1:
            step = float(f"{step / factor(unit):.0e}")
        stepped = from_shown(round(to_shown(value, unit) + count * step, 9), unit)
        if spec.minimum is not None and count < 0 and value >= spec.minimum:
            stepped = max(stepped, spec.minimum)
        if spec.maximum is not None and count > 0 and value <= spec.maximum:
            stepped = min(stepped, spec.maximum)
        self._put(int(stepped) if spec.kind == "int" else stepped)
        self.value_edited.emit(self.value())

    def _on_text_edited(self) -> None:
        value = self.value()
        self._shown = (self.text(), value)
        self.value_edited.emit(value)

    def _work_out(self) -> None:
        """Replace a sum by its value once it is typed to the end, and what a paste brought along with a number."""
        pasted = self.text() != self.text().strip() and not isinstance(self.value(), str)
        if self.result_text or pasted:
            self._put(self.value())


class ChoiceField(QComboBox):
    """One of a few words.

    Signals
    -------
    value_edited(object)
        The chosen value, as the design file writes it.
    """

    value_edited = Signal(object)

    def __init__(self, spec: FieldSpec, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        for choice in spec.choices or ():
            self.addItem(tr(choice_title(choice)), choice)
        self.activated.connect(lambda _index: self.value_edited.emit(self.value()))

    def value(self) -> Any:
        """The chosen value."""
        return self.currentData()

    def set_value(self, value: Any) -> None:
        """Show a choice without announcing it."""
        self.setCurrentIndex(self.findData(value))


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


def read_number(text: str, spec: FieldSpec) -> tuple[int | float | str | None, str]:
    """Value of a text typed into a field, in the design's unit, and why a sum in it has none.

    The value is the text itself when it is no number, None when an optional field is empty.
    """
    if not text.strip() and spec.optional:
        return None, ""
    plain = parse_number(text)
    if not isinstance(plain, str):
        return _whole(plain if factor(spec.unit) == 1 else from_shown(plain, spec.unit), spec), ""
    if NUMBER.fullmatch(text.strip()) or not any(letter.isdigit() for letter in text):
        return text, ""
    from ui.expressions import ExpressionError, evaluate

    try:
        value = evaluate(text, spec.unit)
    except ExpressionError as error:
        return text, str(error)
    return _whole(value, spec), ""


def _whole(value: float, spec: FieldSpec) -> int | float:
    whole = spec.kind == "int" and abs(value) < 1e15 and float(value).is_integer()
    return int(value) if whole else value


def set_severity(widget: QWidget, severity: str) -> None:
    """Mark a widget ``"error"``, ``"warning"``, ``"ok"`` or ``""`` for the style sheet."""
    if widget.property("severity") != severity:
        widget.setProperty("severity", severity)
        widget.style().unpolish(widget)
        widget.style().polish(widget)
