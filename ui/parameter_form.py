"""The form of all parameters, made from the design's own description of its fields."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from itertools import groupby
from typing import Any

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtWidgets import QApplication, QFrame, QLabel, QLineEdit, QPushButton, QVBoxLayout, QWidget

from gearstudio.design import FieldSpec, field_specs
from gearstudio.errors import Issue
from ui.card import UprightScroll
from ui.fields import NumberField, TextField, set_severity
from ui.form_rows import LABEL_WIDTH, FieldRow
from ui.form_section import Section
from ui.modification_table import MODIFICATIONS, ModificationTable, section_of
from ui.words import told, tr

MINIMUM_WIDTH = 330
MESSAGE_DELAY_MS = 250
"""A wrong value is framed at once; its message, which moves the rows below, waits for a pause in typing."""


class ParameterForm(QWidget):
    """Grouped editors with their problems; shows what it is told and announces what is typed.

    Signals
    -------
    field_edited(str, object)
        Dotted name and value as typed.
    field_finished()
        Typing in a field has come to an end.
    field_reset(str), group_reset(str)
        A field, or all fields of a group, shall have their defaults.
    field_asked(str)
        The user asks what a field is.
    equation_asked(str)
        The user asks for the equation that a field enters.
    folds_changed()
        Other groups are folded.
    """

    field_edited = Signal(str, object)
    field_finished = Signal()
    field_reset = Signal(str)
    group_reset = Signal(str)
    field_asked = Signal(str)
    equation_asked = Signal(str)
    folds_changed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._issues: dict[str, list[Issue]] = {}
        self._idle: Mapping[str, str] = {}
        self._changed: set[str] = set()
        self.rows: dict[str, FieldRow] = {}
        self._sections: dict[str, Section] = {}
        self.search = self._make_search()
        self._nothing = QLabel(tr("No parameter has these words"), alignment=Qt.AlignmentFlag.AlignCenter)
        self._nothing.setProperty("role", "muted")
        self._nothing.hide()
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
        top = QVBoxLayout()
        top.setContentsMargins(9, 2, 9, 2)
        top.addWidget(self.search)
        inside.addLayout(top)
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
            if field not in self._issues:
                row.say([])

    def set_idle(self, idle: Mapping[str, str]) -> None:
        """Disable fields without effect, each with its reason; one with an error stays open for repair."""
        self._idle = idle
        self._refresh_idle()

    def set_hints(self, hints: Mapping[str, str]) -> None:
        """Grey text for optional fields that are empty."""
        for field, text in hints.items():
            if field in self.rows:
                self.rows[field].set_hint(text)

    def show_changes(self, draft: Mapping[str, Any]) -> None:
        """Mark the fields that differ from their defaults, and the groups that hold such fields."""
        self._changed = {path for path, row in self.rows.items() if _differs(row.spec, draft.get(path))}
        for path, row in self.rows.items():
            row.show_changed(path in self._changed)
        self._mark_groups()

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
        self._mark_groups()
        self._summarise(issues)
        self._message_timer.start()

    def place_on_top(self, group: str, widget: QWidget) -> None:
        """Put something above the rows of a group."""
        self._sections[group].place_on_top(widget)

    def folded_groups(self) -> list[str]:
        """The groups that are folded."""
        return [group for group, section in self._sections.items() if not section.is_open]

    def fold(self, groups: Iterable[str]) -> None:
        """Fold these groups and unfold the others."""
        folded = set(groups)
        for group, section in self._sections.items():
            section.set_open(group not in folded)

    def filter(self, text: str) -> None:
        """Show only the fields that have all these words in title, symbol, description, key or group."""
        words = text.lower().split()
        hits: dict[str, int] = defaultdict(int)
        for row in self.rows.values():
            hit = all(word in row.words for word in words)
            row.set_found(hit)
            hits[section_of(row.spec)] += hit
        for group, section in self._sections.items():
            section.set_filter(bool(words), hits[group] > 0)
        self._nothing.setVisible(not any(hits.values()))

    def paths_of(self, group: str) -> list[str]:
        """The fields of a section, or of a group within it."""
        return [path for path, row in self.rows.items() if group in (row.spec.group, section_of(row.spec))]

    def focused_path(self) -> str:
        """The field that the cursor is in; empty when it is elsewhere."""
        focused = QApplication.focusWidget()
        return next((path for path, row in self.rows.items() if row.field is focused), "")

    def go_to(self, path: str) -> None:
        """Bring a field into sight and put the cursor there."""
        row = self.rows[path]
        if row.isHidden():
            self.search.clear()
        self._sections[section_of(row.spec)].set_open(True)
        self._scroll.ensureWidgetVisible(row, 0, 24)
        row.field.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def show_first_problem(self) -> None:
        """Go to the first field with a problem."""
        wrong = [f for f in self.rows if _worst(self._issues.get(f, [])) == "error"]
        for field in wrong or [f for f in self.rows if f in self._issues]:
            self.go_to(field)
            return

    def _make_search(self) -> QLineEdit:
        search = QLineEdit()
        search.setPlaceholderText(tr("Find a parameter"))
        search.setAccessibleName(tr("Find a parameter"))
        search.setToolTip(tr("Words of title, symbol, description or group"))
        search.setClearButtonEnabled(True)
        search.textChanged.connect(self.filter)
        return search

    def _make_scroll(self) -> UprightScroll:
        page = QWidget()
        page.setProperty("role", "page")
        layout = QVBoxLayout(page)
        layout.setContentsMargins(2, 2, 10, 8)
        layout.setSpacing(4)
        layout.addWidget(self._nothing)
        for group, specs in groupby(field_specs(), key=section_of):
            section = self._make_section(group)
            layout.addWidget(section)
            if group == MODIFICATIONS:
                table = ModificationTable(tuple(specs))
                for cell in table.cells:
                    self._take_row(cell)
                section.add(table)
                section.set_open(False)
                continue
            for spec in specs:
                row = FieldRow(spec)
                self._take_row(row)
                section.add(row)
        layout.addStretch(1)
        label_width = max(LABEL_WIDTH, *(row.longest_word for row in self.rows.values()))
        for row in self.rows.values():
            row.set_label_width(label_width)
        scroll = UprightScroll(page, MINIMUM_WIDTH)
        scroll.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        return scroll

    def _make_section(self, group: str) -> Section:
        section = self._sections[group] = Section(group)
        section.folded.connect(lambda _folded: self.folds_changed.emit())
        section.reset_requested.connect(lambda: self.group_reset.emit(group))
        section.fold_all_requested.connect(self._fold_all)
        return section

    def _take_row(self, row: FieldRow) -> None:
        spec = row.spec
        row.field.value_edited.connect(lambda value: self._on_edited(row, value))
        if isinstance(row.field, NumberField | TextField):
            row.field.editingFinished.connect(self.field_finished)
        row.reset_requested.connect(lambda: self.field_reset.emit(spec.path))
        row.group_reset_requested.connect(lambda: self.group_reset.emit(spec.group))
        row.explanation_requested.connect(lambda: self.field_asked.emit(spec.path))
        row.equation_requested.connect(lambda: self.equation_asked.emit(spec.path))
        self.rows[spec.path] = row

    def _on_edited(self, row: FieldRow, value: Any) -> None:
        self.field_edited.emit(row.spec.path, value)
        if row.spec.path not in self._issues:
            row.say([])

    def _fold_all(self, folded: bool) -> None:
        self.fold(self._sections if folded else ())
        self.folds_changed.emit()

    def _refresh_idle(self) -> None:
        for field, row in self.rows.items():
            wrong = _worst(self._issues.get(field, [])) == "error"
            row.set_idle("" if wrong else self._idle.get(field, ""))

    def _mark_groups(self) -> None:
        for group, section in self._sections.items():
            paths = [path for path, row in self.rows.items() if section_of(row.spec) == group]
            found = [issue for path in paths for issue in self._issues.get(path, [])]
            section.show_marks(sum(path in self._changed for path in paths), _worst(found), len(found))

    def _show_messages(self) -> None:
        for field, issues in self._issues.items():
            row = self.rows.get(field)
            if row is not None:
                self._sections[section_of(row.spec)].set_open(True)
                row.say(issues)

    def _summarise(self, issues: Sequence[Issue]) -> None:
        errors = sum(issue.severity == "error" for issue in issues)
        warnings = len(issues) - errors
        parts = []
        if errors:
            parts.append(tr("1 problem") if errors == 1 else tr("{count} problems", count=errors))
        if warnings:
            parts.append(tr("1 warning") if warnings == 1 else tr("{count} warnings", count=warnings))
        text = " · ".join(parts)
        if errors:
            text = tr("{count}: the last good model stays", count=text)
        self._summary.setText(text or tr("All parameters are good"))
        self._summary.setEnabled(bool(issues))
        self._summary.setToolTip(
            "\n\n".join(_told(issue) for issue in issues) or tr("What is wrong with the parameters")
        )
        set_severity(self._summary, "error" if errors else "warning" if warnings else "ok")


def _told(issue: Issue) -> str:
    return f"{issue.field}: {told(issue.message)}" if issue.field else told(issue.message)


def _worst(issues: Sequence[Issue]) -> str:
    severities = {issue.severity for issue in issues}
    return "error" if "error" in severities else "warning" if severities else ""


def _differs(spec: FieldSpec, value: Any) -> bool:
    return spec.kind != "text" and bool(value != spec.default)
