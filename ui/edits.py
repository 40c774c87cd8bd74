"""Every change that the user makes to the design goes through here, so that it has a name and can be taken back."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, QSignalBlocker

from gearstudio.design import all_field_specs, field_specs
from ui.applicability import idle_fields
from ui.explain import field_value_text, full_title
from ui.session import Session, flatten
from ui.undo import History
from ui.words import told, tr

if TYPE_CHECKING:
    from gearstudio.presets import Preset
    from ui.main_window import MainWindow

SHOWN_MS = 5000


class Edits(QObject):
    """Takes edits from the form and the menus to the session, and back and forth again."""

    def __init__(self, session: Session, window: MainWindow, parent: QObject, history: History | None = None) -> None:
        super().__init__(parent)
        self._session, self._window = session, window
        self.history = history or History()
        form = window.form
        form.field_edited.connect(self.change)
        form.field_finished.connect(self.history.seal)
        form.field_reset.connect(lambda path: self.reset((path,)))
        form.group_reset.connect(self.reset_group)
        session.draft_replaced.connect(self._show_draft)
        session.design_changed.connect(self._show_changes)
        commands = window.commands
        commands["undo"].triggered.connect(self.undo)
        commands["redo"].triggered.connect(self.redo)
        commands["reset_field"].triggered.connect(self._reset_focused)
        commands["reset_all"].triggered.connect(self._reset_all)
        self._show_draft()
        self.show_history()

    def change(self, path: str, value: Any) -> None:
        """Take the value of a field as typed."""
        spec = all_field_specs()[path]
        label = tr("Change {field} to {value}", field=full_title(spec), value=field_value_text(spec, value))
        self._apply({path: value}, label, path if spec.kind in ("int", "float", "text") else "")

    def change_many(self, values: Mapping[str, Any], label: str) -> None:
        """Set several fields in one step with a name: a group, a preset, a table pasted."""
        self._apply(values, label, "")

    def reset(self, paths: Iterable[str], label: str = "") -> None:
        """Give fields their defaults back."""
        specs = [all_field_specs()[path] for path in paths]
        if specs:
            label = label or tr("Reset {field}", field=full_title(specs[0]))
            self.change_many({spec.path: spec.default for spec in specs}, label)

    def reset_group(self, group: str) -> None:
        """Give all fields of a group of the form their defaults back."""
        self.reset(self._window.form.paths_of(group), tr("Reset group {group}", group=tr(group)))

    def take_preset(self, preset: Preset) -> None:
        """All values of a preset, in the same document."""
        self.change_many(flatten(preset.design), tr("Reset to {preset}", preset=tr(preset.title)))

    def undo(self) -> None:
        """Take the last step back and say which."""
        label = self.history.undo_label
        self._restore(self.history.undo(), tr("Undone: {step}", step=told(label)))

    def redo(self) -> None:
        """Do the step undone last again and say which."""
        label = self.history.redo_label
        self._restore(self.history.redo(), tr("Done again: {step}", step=told(label)))

    def clear(self) -> None:
        """Forget all steps, as for another file."""
        self.history.clear()
        self.show_history()

    def show_history(self) -> None:
        """Name the steps in the menu and in the tooltips of the toolbar."""
        commands = self._window.commands
        for name, label in (("undo", self.history.undo_label), ("redo", self.history.redo_label)):
            commands.name_step(name, told(label) if label else "")

    def _apply(self, values: Mapping[str, Any], label: str, thread: str) -> None:
        session, form = self._session, self._window.form
        before = dict(session.draft)
        if len(values) == 1:
            session.edit(*next(iter(values.items())))
            form.set_values(session.draft)
        else:
            session.restore({**session.draft, **values})
        self.history.record(label, before, session.draft, thread)
        form.set_idle(idle_fields(session.draft))
        form.show_changes(session.draft)
        self.show_history()

    def _restore(self, draft: Mapping[str, Any] | None, words: str) -> None:
        if draft is None:
            return
        self._session.restore(draft)
        self.history.seal()
        self.show_history()
        self._window.status.showMessage(words, SHOWN_MS)

    def _show_draft(self) -> None:
        form, draft = self._window.form, self._session.draft
        with QSignalBlocker(form):
            form.set_values(draft)
        form.set_idle(idle_fields(draft))
        self._show_changes()

    def _show_changes(self) -> None:
        self._window.form.show_changes(self._session.draft)

    def _reset_focused(self) -> None:
        path = self._window.form.focused_path()
        if path:
            self.reset((path,))
        else:
            self._window.status.showMessage(tr("Put the cursor into a parameter first"), SHOWN_MS)

    def _reset_all(self) -> None:
        self.reset([spec.path for spec in field_specs()], tr("Reset all parameters"))
