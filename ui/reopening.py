"""Dialogs that are open when another window takes the place of theirs: opened again, with what was chosen in them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QPoint, QSize, QTimer
from PySide6.QtWidgets import QDialog

from ui import widget_state

if TYPE_CHECKING:
    from ui.app import Studio


@dataclass(frozen=True)
class OpenDialog:
    """A dialog in sight.

    Attributes
    ----------
    state : object
        What it takes to open one like it.
    widgets : dict
        What was chosen in its widgets beside that.
    """

    kind: type[QDialog]
    place: QPoint
    size: QSize
    state: Any
    widgets: dict[widget_state.Path, Any]


@dataclass(frozen=True)
class _Way:
    """How to tell what a dialog shows (None: it stays closed), how to open one that shows the same, and what of its
    widgets is to be chosen again."""

    keep: Callable[[Studio, Any], Any]
    open: Callable[[Studio, Any], QDialog]
    with_widgets: bool = False


def open_dialogs(studio: Studio) -> tuple[OpenDialog, ...]:
    """Those of a studio's window that `open_again` can open; the others ask something that the new window asks anew."""
    ways, found = _ways(), []
    for dialog in studio.window.findChildren(QDialog):
        way = ways.get(type(dialog))
        state = way.keep(studio, dialog) if way is not None and dialog.isVisible() else None
        if way is not None and state is not None:
            widgets = widget_state.states(dialog) if way.with_widgets else {}
            found.append(OpenDialog(type(dialog), dialog.pos(), dialog.size(), state, widgets))
    return tuple(found)


def open_again(studio: Studio, kept: OpenDialog) -> None:
    """Open a dialog in a studio's window where and as another one was."""
    dialog = _ways()[kept.kind].open(studio, kept.state)
    dialog.resize(kept.size)
    dialog.move(kept.place)
    widget_state.choose_again(dialog, kept.widgets)
    QTimer.singleShot(0, dialog, lambda: widget_state.scroll_again(dialog, kept.widgets))


def _ways() -> dict[type[QDialog], _Way]:
    from ui.help.equations import EquationBrowser
    from ui.help.guide import GuideWindow
    from ui.preferences_dialog import PreferencesDialog
    from ui.projects.compare_dialog import CompareDialog
    from ui.reporting.dialog import ReportDialog

    return {
        PreferencesDialog: _Way(
            lambda _, dialog: dialog.tabs.currentIndex(), lambda studio, page: studio.habits.open_preferences(page)
        ),
        GuideWindow: _Way(
            lambda _, dialog: dialog.pages.currentData(),
            lambda studio, page: studio.controller.help.open_guide(page),
            with_widgets=True,
        ),
        EquationBrowser: _Way(
            lambda _, dialog: dialog.key,
            lambda studio, key: studio.controller.help.open_equations(key),
            with_widgets=True,
        ),
        ReportDialog: _Way(
            lambda studio, _: studio.controller.reporting.keep_state(),
            lambda studio, work: studio.controller.reporting.take_state(work),
        ),
        CompareDialog: _Way(lambda _, dialog: dialog.keep_state(), _compare),
    }


def _compare(studio: Studio, state: Any) -> QDialog:
    dialog = studio.desk.compare()
    dialog.take_state(state)
    return dialog
