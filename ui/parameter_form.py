"""The form of all parameters, made from the design's own description of its fields."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from itertools import groupby
from typing import Any

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtWidgets import QFrame, QPushButton, QScrollArea, QVBoxLayout, QWidget

from gearstudio.design import FieldSpec, field_specs
from gearstudio.errors import Issue
from ui.fields import set_severity
from ui.form_rows import FieldRow, Section

MINIMUM_WIDTH = 330
MESSAGE_DELAY_MS = 250
"""A wrong value is framed at once; its message, which moves the rows below, waits for a pause in typing."""


class ParameterForm(QWidget):
    """Grouped editors with their problems; shows what it is told and announces what is typed.

    Signals
    -------
    field_edited(str, object)
        Dotted name and value as typed.
    """

    field_edited = Signal(str, object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._issues: dict[str, list[Issue]] = {}
        self._idle: Mapping[str, str] = {}
        self.rows: dict[str, FieldRow] = {}
        self._sections: dict[str, Section] = {}
        self._scroll = self._make_scroll()
        self._summary = QPushButton()
        self._summary.setProperty("role", "flat")
        self._summary.setCursor(Qt.CursorShape.PointingHandCursor)
        self._summary.clicked.connect(self.show_first_problem)
        card = QFrame()
        card.setProperty("role", "card")
        inside = QVBoxLayout(card)
        inside.setContentsMargins(1, 6, 1, 4)
        inside.setSpacing(2)
        inside.addWidget(self._scroll, 1)
        inside.addWidget(self._summary)
        outside = QVBoxLayout(self)
        outside.setContentsMargins(8, 0, 0, 4)
        outside.addWidget(card)
        self._message_timer = QTimer(self, singleShot=True, interval=MESSAGE_DELAY_MS)
        self._message_timer.timeout.connect(self._show_messages)
        self.show_issues(())

    def set_values(self, draft: Mapping[str, Any]) -> None:
        """Show a draft."""
        for field, row in self.rows.items():
            row.field.set_value(draft.get(field))

    def set_idle(self, idle: Mapping[str, str]) -> None:
        """Disable fields without effect, each with its reason; one with an error stays open for repair."""
        self._idle = idle
        self._refresh_idle()

    def set_hints(self, hints: Mapping[str, str]) -> None:
        """Grey text for optional fields that are empty."""
        for field, text in hints.items():
            if field in self.rows:
                self.rows[field].set_hint(text)

    def show_issues(self, issues: Sequence[Issue]) -> None:
        """Frame the fields with problems; messages follow when the typing pauses."""
        found: dict[str, list[Issue]] = defaultdict(list)
        for issue in issues:
            found[issue.field].append(issue)
        self._issues = dict(found)
        for field, row in self.rows.items():
            row.frame(_worst(self._issues.get(field, [])))
            if field not in self._issues:
                row.say([])
        self._refresh_idle()
        self._summarise(issues)
        self._message_timer.start()

    def place_on_top(self, group: str, widget: QWidget) -> None:
        """Put something above the rows of a group."""
        self._sections[group].place_on_top(widget)

    def show_first_problem(self) -> None:
        """Scroll to the first field with a problem and put the cursor there."""
        wrong = [f for f in self.rows if _worst(self._issues.get(f, [])) == "error"]
        for field in wrong or [f for f in self.rows if f in self._issues]:
            self._sections[self.rows[field].spec.group].set_open(True)
            self._scroll.ensureWidgetVisible(self.rows[field], 0, 24)
            self.rows[field].field.setFocus()
            return

    def _make_scroll(self) -> QScrollArea:
        page = QWidget()
        page.setProperty("role", "page")
        layout = QVBoxLayout(page)
        layout.setContentsMargins(12, 2, 10, 8)
        layout.setSpacing(4)
        for group, specs in groupby(field_specs(), key=lambda spec: spec.group):
            section = self._sections.setdefault(group, Section(group))
            layout.addWidget(section)
            for spec in specs:
                section.add(self._make_row(spec))
        layout.addStretch(1)
        scroll = QScrollArea()
        scroll.setWidgetResizable(True)
        scroll.setFrameShape(QFrame.Shape.NoFrame)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setWidget(page)
        scroll.setMinimumWidth(MINIMUM_WIDTH)
        return scroll

    def _make_row(self, spec: FieldSpec) -> FieldRow:
        row = FieldRow(spec)
        row.field.value_edited.connect(lambda value: self.field_edited.emit(spec.path, value))
        self.rows[spec.path] = row
        return row

    def _refresh_idle(self) -> None:
        for field, row in self.rows.items():
            wrong = _worst(self._issues.get(field, [])) == "error"
            row.set_idle("" if wrong else self._idle.get(field, ""))

    def _show_messages(self) -> None:
        for field, issues in self._issues.items():
            row = self.rows.get(field)
            if row is not None:
                self._sections[row.spec.group].set_open(True)
                row.say(issues)

    def _summarise(self, issues: Sequence[Issue]) -> None:
        errors = sum(issue.severity == "error" for issue in issues)
        warnings = len(issues) - errors
        counts = ((errors, "problem"), (warnings, "warning"))
        parts = [f"{count} {word}{'s' * (count > 1)}" for count, word in counts if count]
        text = " · ".join(parts) + (": the last good model stays" if errors else "")
        self._summary.setText(text or "All parameters are good")
        self._summary.setEnabled(bool(issues))
        self._summary.setToolTip("\n\n".join(str(issue) for issue in issues))
        set_severity(self._summary, "error" if errors else "warning" if warnings else "ok")


def _worst(issues: Sequence[Issue]) -> str:
    severities = {issue.severity for issue in issues}
    return "error" if "error" in severities else "warning" if severities else ""
