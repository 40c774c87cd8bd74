"""Another window in the place of the present one, in another language: nothing is computed again, nothing is lost."""

from __future__ import annotations

import logging
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtWidgets import QDialog

from ui.collecting import tidy_memory
from ui.inheritance import inheritance_of
from ui.keepsakes import arrange, keepsakes, show_alike

if TYPE_CHECKING:
    from ui.app import Studio
    from ui.main_window import MainWindow

log = logging.getLogger(__name__)


def succeed(studio: Studio, language: str) -> None:
    """Give a studio a new window that speaks a language; session, undo, files, CAD process and solids go on.

    A window is made from words, and words are everywhere in it; to make it anew leaves none of the old ones. The new
    one is on the screen before the old one goes, so that the program does not end in between.
    """
    log.info("language: %s, before it %s", language, studio.language.spoken)
    old = studio.window
    kept, inheritance = keepsakes(studio), inheritance_of(studio)
    old.closing.disconnect(studio.end)
    studio.language.speak(language)
    studio.make_window(inheritance)
    studio.window.restore_layout()
    arrange(studio, kept)
    studio.loader.tell_again()
    studio.window.show()
    show_alike(studio, kept)
    _give_up(old)
    if studio.loader.has_finished:
        studio.habits.keys.entries()
        tidy_memory()


def _give_up(window: MainWindow) -> None:
    """Close a window without a question, and delete it at once with everything that belongs to it."""
    for dialog in window.findChildren(QDialog):
        dialog.close()
    window.may_close = lambda: True
    window.close()
    window.deleteLater()
    QCoreApplication.sendPostedEvents(window, QEvent.Type.DeferredDelete.value)
