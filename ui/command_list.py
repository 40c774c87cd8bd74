"""Every command of the window, whoever made it: what the menus hold, with a name that stays."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMainWindow, QMenu

from ui.actions import TIP
from ui.mnemonics import APART

ARROW = " ▸ "


@dataclass(frozen=True)
class Entry:
    """A command.

    Attributes
    ----------
    id : str
        Stays the same in every language and version, for settings.
    title, place : str
        Its words, and the menus above it: ``"Layers"``, ``"View ▸ Layers"``.
    action : QAction
    """

    id: str
    title: str
    place: str
    action: QAction

    @property
    def tip(self) -> str:
        """What the command does, when its title does not say all."""
        said = str(self.action.property(TIP) or "")
        return "" if said == self.title else said


def commands_of(window: QMainWindow) -> list[Entry]:
    """The commands in the menus of a window from left to right, each once, then those that have only a key."""
    found: dict[str, Entry] = {}
    for top in window.menuBar().actions():
        menu = top.menu()
        if isinstance(menu, QMenu):
            for entry in _walk(menu, plain(top.text())):
                found.setdefault(entry.id, entry)
    for action in window.actions():
        name = action.objectName()
        if name and name not in found:
            found[name] = Entry(name, plain(action.text()), "", action)
    return list(found.values())


def plain(text: str) -> str:
    """Words of a menu without the mark of the key and the dots: ``&Open design…`` is "Open design"."""
    return APART.sub("", text).replace("&&", "\0").replace("&", "").replace("\0", "&").removesuffix("…")


def _walk(menu: QMenu, place: str) -> Iterator[Entry]:
    for action in menu.actions():
        below = action.menu()
        if isinstance(below, QMenu):
            yield from _walk(below, f"{place}{ARROW}{plain(action.text())}")
        elif not action.isSeparator() and action.objectName():
            yield Entry(action.objectName(), plain(action.text()), place, action)
