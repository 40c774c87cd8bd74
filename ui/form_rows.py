"""A row of the parameter form: reset button, label, editor, unit, message."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import Any

from PySide6.QtCore import QPoint, QSize, Qt, Signal
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QLineEdit, QMenu, QSizePolicy, QToolButton, QWidget

from gearstudio.design import FieldSpec
from gearstudio.errors import Issue
from ui.explain import field_value_text, has_equation, problem_text, tooltip
from ui.fields import ChoiceField, NumberField, TextField, make_field, set_severity
from ui.theme import set_icon
from ui.units import unit_shown
from ui.words import tr

GUTTER, LABEL_WIDTH, UNIT_WIDTH = 18, 124, 24
UNITS = ("mm", "°", "µm")


class FieldRow(QWidget):
    """One parameter: label, editor, unit, a button that resets it, and under them what is wrong with it.

    Signals
    -------
    reset_requested()
    group_reset_requested()
    explanation_requested()
        "What is this?" was asked.
    equation_requested()
        The equation that the field enters shall be shown.
    """

    reset_requested = Signal()
    group_reset_requested = Signal()
    explanation_requested = Signal()
    equation_requested = Signal()

    def __init__(self, spec: FieldSpec, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.spec = spec
        self.field = make_field(spec, self)
        self.field.setAccessibleName(tr(spec.title))
        self.field.setAccessibleDescription(tr(spec.description))
        self.field.setObjectName(spec.path)
        self.field.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.field.customContextMenuRequested.connect(lambda place: self._show_menu(self.field.mapToGlobal(place)))
        self._idle, self._changed = "", False
        self._issues: Sequence[Issue] = ()
        self.reset = self._make_reset()
        self._label = QLabel(tr(spec.title))
        self._label.setWordWrap(True)
        self._label.setBuddy(self.field)
        self._message = _message_label()
        self._unit = QLabel()
        self._unit.setProperty("role", "muted")
        self._unit.setFixedWidth(UNIT_WIDTH)
        self._arrange()
        if isinstance(self.field, NumberField):
            self.field.editingFinished.connect(lambda: self.say(self._issues))
        self.show_units()

    @property
    def longest_word(self) -> int:
        """Width of the label's longest word [pixels]."""
        return max(map(self._label.fontMetrics().horizontalAdvance, self._label.text().split()))

    def set_label_width(self, width: int) -> None:
        """Keep room for the label [pixels]; longer titles break between words."""
        self._label.setFixedWidth(width)

    @property
    def message(self) -> str:
        """What stands under the field; empty when nothing is wrong."""
        return self._message.text() if self._issues else ""

    @property
    def idle(self) -> str:
        """Why the field has no effect now; empty when it has."""
        return self._idle

    @property
    def words(self) -> str:
        """All that a search may look for, in small letters."""
        spec = self.spec
        texts = (spec.title, spec.symbol, spec.path, spec.description, spec.group)
        return " ".join(f"{text} {tr(text)}" for text in texts if text).lower()

    def frame(self, severity: str) -> None:
        """Frame the editor as ``"error"``, ``"warning"`` or ``""``."""
        set_severity(self.field, severity)

    def say(self, issues: Sequence[Issue]) -> None:
        """Write problems under the field; without any, the value of a sum while it is typed."""
        self._issues = issues
        problem = self.field.problem if isinstance(self.field, NumberField) else ""
        result = self.field.result_text if isinstance(self.field, NumberField) else ""
        lines = [problem] if problem else [problem_text(issue.message, self.spec) for issue in issues] or [result]
        self._message.setText("\n".join(filter(None, lines)))
        error = any(issue.severity == "error" for issue in issues)
        set_severity(self._message, ("error" if error else "warning") if issues else "")
        self._message.setVisible(bool(self._message.text()))

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

    def show_changed(self, changed: bool) -> None:
        """Offer to reset the field while it differs from its default."""
        self._changed = changed
        self.reset.setVisible(changed)

    def set_found(self, found: bool) -> None:
        """Show the row while fields are searched for, if it is one of them."""
        self.setVisible(found)

    def show_units(self) -> None:
        """Show value, unit and limits in the unit that the user chose."""
        self._unit.setText(unit_shown(self.spec.unit) if self.spec.unit in UNITS else "")
        if isinstance(self.field, NumberField):
            self.field.show_units()
        self.say(self._issues)
        self.reset.setToolTip(tr("Reset to {value}", value=field_value_text(self.spec, self.spec.default)))
        self._refresh_tooltip()

    def make_menu(self) -> QMenu:
        """What can be done with the field: editing, resetting, explaining."""
        menu = QMenu(self)
        if isinstance(self.field, QLineEdit):
            for text, run, possible in self._edits(self.field):
                action = menu.addAction(text)
                action.triggered.connect(run)
                action.setEnabled(possible)
            menu.addSeparator()
        value: Any = self.spec.default
        reset = menu.addAction(tr("Reset to {value}", value=field_value_text(self.spec, value)))
        reset.setEnabled(self._changed)
        reset.triggered.connect(self.reset_requested)
        group = menu.addAction(tr("Reset group {group}", group=tr(self.spec.group)))
        group.triggered.connect(self.group_reset_requested)
        menu.addSeparator()
        menu.addAction(tr("What is this?")).triggered.connect(self.explanation_requested)
        if has_equation(self.spec):
            menu.addAction(tr("Show equation")).triggered.connect(self.equation_requested)
        return menu

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        self._show_menu(event.globalPos())
        event.accept()

    def _arrange(self) -> None:
        layout = QGridLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setHorizontalSpacing(6)
        layout.setVerticalSpacing(2)
        layout.addWidget(self.reset, 0, 0)
        layout.addWidget(self._label, 0, 1)
        wide = isinstance(self.field, ChoiceField | TextField)
        layout.addWidget(self.field, 0, 2, 1, 2 if wide else 1)
        if not wide:
            layout.addWidget(self._unit, 0, 3)
        layout.addWidget(self._message, 1, 1, 1, 3)
        layout.setColumnStretch(2, 1)

    def _edits(self, line: QLineEdit) -> tuple[tuple[str, Any, bool], ...]:
        chosen, writable = line.hasSelectedText(), line.isEnabled() and not line.isReadOnly()
        return (
            (tr("Cut"), line.cut, chosen and writable),
            (tr("Copy"), line.copy, chosen),
            (tr("Paste"), line.paste, writable),
            (tr("Select all"), line.selectAll, bool(line.text())),
        )

    def _show_menu(self, place: QPoint) -> None:
        menu = self.make_menu()
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.popup(place)

    def _make_reset(self) -> QToolButton:
        button = QToolButton(self)
        button.setAutoRaise(True)
        button.setProperty("role", "gutter")
        button.setFixedSize(GUTTER, GUTTER)
        policy = button.sizePolicy()
        policy.setRetainSizeWhenHidden(True)
        button.setSizePolicy(policy)
        button.setIconSize(QSize(12, 12))
        button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        button.setAccessibleName(tr("Reset {field}", field=tr(self.spec.title)))
        set_icon(button, "reset")
        button.clicked.connect(self.reset_requested)
        button.hide()
        return button

    def _refresh_tooltip(self) -> None:
        text = tooltip(self.spec)
        if self._idle:
            text = f"<p><b>{tr('Not used now.')}</b> {escape(self._idle)}</p>{text}"
        self.setToolTip(text)


def _message_label() -> QLabel:
    label = QLabel()
    label.setWordWrap(True)
    label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    label.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Minimum)
    label.hide()
    return label
