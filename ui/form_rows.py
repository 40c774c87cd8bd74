"""A row of the parameter form (label, editor, unit, message) and a section that folds."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QGridLayout, QLabel, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from gearstudio.design import FieldSpec
from gearstudio.errors import Issue
from ui.fields import ChoiceField, TextField, make_field, set_severity
from ui.formatting import choice_title, number_text, subscripts
from ui.theme import set_icon

LABEL_WIDTH = 124
UNIT_WIDTH = 26
UNITS = ("mm", "°", "µm")


class FieldRow(QWidget):
    """One parameter: label, editor, unit, and under them what is wrong with it."""

    def __init__(self, spec: FieldSpec, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.spec = spec
        self.field = make_field(spec, self)
        self.field.setAccessibleName(spec.title)
        self.field.setObjectName(spec.path)
        self._idle = ""
        self._label = QLabel(spec.title)
        self._label.setWordWrap(True)
        self._label.setFixedWidth(LABEL_WIDTH)
        self._label.setBuddy(self.field)
        self._message = _message_label()
        unit = QLabel(spec.unit if spec.unit in UNITS else "")
        unit.setProperty("role", "muted")
        unit.setFixedWidth(UNIT_WIDTH)
        layout = QGridLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setHorizontalSpacing(6)
        layout.setVerticalSpacing(2)
        layout.addWidget(self._label, 0, 0)
        wide = isinstance(self.field, ChoiceField | TextField)
        layout.addWidget(self.field, 0, 1, 1, 2 if wide else 1)
        if not wide:
            layout.addWidget(unit, 0, 2)
        layout.addWidget(self._message, 1, 0, 1, 3)
        layout.setColumnStretch(1, 1)
        self._refresh_tooltip()

    @property
    def message(self) -> str:
        """What stands under the field; empty when nothing is wrong."""
        return self._message.text()

    def frame(self, severity: str) -> None:
        """Frame the editor as ``"error"``, ``"warning"`` or ``""``."""
        set_severity(self.field, severity)

    def say(self, issues: Sequence[Issue]) -> None:
        """Write problems under the field, or take them away."""
        self._message.setText("\n".join(issue.message for issue in issues))
        set_severity(self._message, "error" if any(i.severity == "error" for i in issues) else "warning")
        self._message.setVisible(bool(issues))

    def set_hint(self, text: str) -> None:
        """Grey text shown while an optional field is empty."""
        if self.spec.optional and not isinstance(self.field, ChoiceField):
            self.field.setPlaceholderText(text)

    def set_idle(self, reason: str) -> None:
        """Disable the row for a reason, or enable it again (empty reason)."""
        if reason != self._idle:
            self._idle = reason
            self.field.setEnabled(not reason)
            self._label.setEnabled(not reason)
            self._refresh_tooltip()

    def _refresh_tooltip(self) -> None:
        text = tooltip(self.spec)
        if self._idle:
            text = f"<p><b>Not used now.</b> {escape(self._idle)}</p>{text}"
        self.setToolTip(text)


class Section(QWidget):
    """A titled group of rows; a click on the title folds it."""

    def __init__(self, title: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._title = QToolButton()
        self._title.setProperty("role", "section")
        self._title.setText(title)
        self._title.setCheckable(True)
        self._title.setChecked(True)
        self._title.setIconSize(QSize(16, 16))
        self._title.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self._title.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._title.toggled.connect(self.set_open)
        self._body = QWidget()
        self._rows = QVBoxLayout(self._body)
        self._rows.setContentsMargins(2, 0, 0, 6)
        self._rows.setSpacing(5)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(2)
        layout.addWidget(self._title)
        layout.addWidget(self._body)
        self.set_open(True)

    def add(self, row: FieldRow) -> None:
        """Append a row."""
        self._rows.addWidget(row)

    def place_on_top(self, widget: QWidget) -> None:
        """Put something above the rows."""
        self._rows.insertWidget(0, widget)

    def set_open(self, opened: bool) -> None:
        """Unfold or fold."""
        self._title.setChecked(opened)
        set_icon(self._title, "chevron-down" if opened else "chevron-right")
        self._body.setVisible(opened)


def tooltip(spec: FieldSpec) -> str:
    """What a parameter is, its symbol, where it enters the equations, its range."""
    head = f"<b>{escape(spec.title)}</b>" + (f" &nbsp;<i>{subscripts(spec.symbol)}</i>" if spec.symbol else "")
    lines = [f"<p>{head}</p>", f"<p>{escape(spec.description)}</p>"]
    if spec.equation:
        lines.append(f"<p>{subscripts(spec.equation)}</p>")
    if spec.choices:
        lines.append(f"<p>One of: {escape(', '.join(choice_title(choice) for choice in spec.choices))}.</p>")
    limits = limits_text(spec)
    if limits:
        lines.append(f"<p>Range: {escape(limits)}</p>")
    if spec.optional:
        lines.append("<p>Leave it empty to use the derived value shown in grey.</p>")
    return "".join(lines)


def limits_text(spec: FieldSpec) -> str:
    """The range of a number in words: ``5 to 200``, ``at least 0 mm``."""
    unit = spec.unit if spec.unit in ("", "°") else f" {spec.unit}"
    low, high = spec.minimum, spec.maximum
    if low is not None and high is not None:
        return f"{number_text(low)} to {number_text(high)}{unit}"
    if low is not None:
        return f"at least {number_text(low)}{unit}"
    return f"at most {number_text(high)}{unit}" if high is not None else ""


def _message_label() -> QLabel:
    label = QLabel()
    label.setWordWrap(True)
    label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    label.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Minimum)
    label.hide()
    return label
