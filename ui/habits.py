"""What a user expects of any desktop program: preferences, palette, keys, copying, "What is this?"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QPoint, Qt
from PySide6.QtWidgets import QAbstractItemView, QApplication, QLineEdit, QPlainTextEdit, QWhatsThis, QWidget

from gearstudio.design import all_field_specs, field_specs
from ui import tables, units
from ui.actions import check
from ui.applicability import derived_hints
from ui.help.clicked import said
from ui.keys import Keys
from ui.modification_table import MODIFICATIONS
from ui.palette import Offer, Palette, keys_text
from ui.preferences import Choices, Preferences
from ui.words import tr

if TYPE_CHECKING:
    from ui.controller import Controller
    from ui.preferences_dialog import PreferencesDialog
    from ui.theme import Theme

FOLDED = "form/folded"
SCHEMES = {"system": Qt.ColorScheme.Unknown, "light": Qt.ColorScheme.Light, "dark": Qt.ColorScheme.Dark}


class Habits(QObject):
    """Connects a window to the preferences and to the commands that every part of it shares."""

    def __init__(
        self, controller: Controller, theme: Theme | None = None, preferences: Preferences | None = None
    ) -> None:
        super().__init__(controller)
        self._controller, self._theme = controller, theme
        self._session, self._window = controller.session, controller.window
        settings = self._window.settings
        self.preferences = preferences or Preferences(settings)
        self.preferences.setParent(self)
        self.preferences.changed.connect(self._on_preferences)
        self.keys = Keys(self._window, settings)
        self._connect_commands()
        self._connect_form()
        choices = self.preferences.choices
        check(self._window.commands.schemes, choices.theme)
        if choices.theme != "system" and theme is not None:
            theme.choose(SCHEMES[choices.theme])
        self._use_units(choices)

    def open_preferences(self, page: int = 0) -> PreferencesDialog:
        """Show the dialog of preferences."""
        from ui.preferences_dialog import PreferencesDialog

        dialog = PreferencesDialog(self.preferences, self.keys, self._window)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.tabs.setCurrentIndex(page)
        dialog.open()
        return dialog

    def open_palette(self) -> None:
        """Show the command palette."""
        palette = Palette(self.offers(), self._window.settings, self._window)
        palette.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        palette.open_over(self._window)

    def offers(self) -> list[Offer]:
        """Everything that the palette can do: all commands, and going to every parameter."""
        made = []
        for entry in self.keys.entries():
            action = entry.action
            if entry.id != "palette" and action.isVisible():
                made.append(
                    Offer(
                        entry.id, entry.title, entry.place, keys_text(action.shortcut()), entry.tip,
                        action.isEnabled(), action.trigger,
                    )
                )  # fmt: skip
        form = self._window.form
        for spec in field_specs():
            place = f"{tr('Parameter')} ▸ {tr(spec.group)}"
            path = spec.path
            made.append(
                Offer(
                    f"field.{path}", tr(spec.title), place, "", tr(spec.description), True, lambda p=path: form.go_to(p)
                )
            )
        return made

    def explain(self, path: str) -> None:
        """Say what a parameter is, beside its field."""
        from ui.effects import effect_lines
        from ui.explain import explanation

        spec, row = all_field_specs()[path], self._window.form.rows[path]
        text = explanation(spec, row.field.value(), row.idle, effect_lines(self._session.design, spec))
        QWhatsThis.showText(row.field.mapToGlobal(QPoint(0, row.field.height())), text, self._window)

    def copy(self, *, whole: bool = False) -> None:
        """Copy what is chosen in the table or text with the focus, or the whole table."""
        focused = QApplication.focusWidget()
        if isinstance(focused, QAbstractItemView):
            tables.copy(focused, whole=whole)
            self._window.status.showMessage(tr("Copied; paste it into a spreadsheet"), 3000)
        elif isinstance(focused, QLineEdit | QPlainTextEdit) and not whole:
            focused.copy()
        else:
            self._window.status.showMessage(tr("Click into a table first"), 3000)

    def _connect_commands(self) -> None:
        commands = self._window.commands
        handlers = {
            "palette": self.open_palette,
            "preferences": self.open_preferences,
            "keys": lambda: self.open_preferences(2),
            "what_is_this": self._explain_focused,
            "find_field": self._find_field,
            "copy": self.copy,
            "copy_any_table": lambda: self.copy(whole=True),
        }
        for name, handler in handlers.items():
            commands[name].triggered.connect(lambda _checked=False, run=handler: run())
        commands.schemes.triggered.connect(lambda action: self.preferences.set(theme=action.data()))
        for view in (self._window.table.view, self._window.derived.view):
            tables.offer_copy(view)

    def _connect_form(self) -> None:
        form, settings = self._window.form, self._window.settings
        form.field_asked.connect(self.explain)
        if settings is not None:
            folded = settings.value(FOLDED, [MODIFICATIONS])
            form.fold([folded] if isinstance(folded, str) else folded if isinstance(folded, list) else [])
            form.folds_changed.connect(lambda: settings.setValue(FOLDED, form.folded_groups()))

    def _find_field(self) -> None:
        search = self._window.form.search
        search.setFocus(Qt.FocusReason.ShortcutFocusReason)
        search.selectAll()

    def _explain_focused(self) -> None:
        path = self._window.form.focused_path()
        if path:
            self.explain(path)
            return
        focused = QApplication.focusWidget()
        text = said(focused)
        if focused is not None and text:
            QWhatsThis.showText(focused.mapToGlobal(focused.rect().bottomLeft()), text, focused)
        else:
            QWhatsThis.enterWhatsThisMode()

    def _on_preferences(self, before: Choices, now: Choices) -> None:
        if now.theme != before.theme:
            check(self._window.commands.schemes, now.theme)
            if self._theme is not None:
                self._theme.choose(SCHEMES[now.theme])
        if (now.length, now.decimals) != (before.length, before.decimals):
            self._use_units(now)

    def _use_units(self, choices: Choices) -> None:
        """Show lengths in the unit chosen: every widget that has some has a method `show_units`."""
        length: units.LengthUnit = "in" if choices.length == "in" else "mm"
        units.use(units.Display(length, choices.decimals))
        for widget in self._window.findChildren(QWidget):
            show_units = getattr(widget, "show_units", None)
            if show_units is not None:
                show_units()
        session, window = self._session, self._window
        window.form.show_issues(session.issues)
        window.messages.take_state(window.messages.keep_state())
        self._controller.edits.show_history()
        self._controller.blanks.refresh()
        if session.pair is not None:
            self._window.form.set_hints(derived_hints(session.design, session.pair))
