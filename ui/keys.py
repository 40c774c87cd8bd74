"""The keys of all commands: their defaults, the user's own, and what collides."""

from __future__ import annotations

from PySide6.QtCore import QObject, QSettings, Signal
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QMainWindow

from ui.actions import show_keys
from ui.command_list import Entry, commands_of

GROUP = "keys"
PORTABLE = QKeySequence.SequenceFormat.PortableText
NO_MATCH = QKeySequence.SequenceMatch.NoMatch


class Keys(QObject):
    """Gives commands their keys and remembers those that the user chose.

    Signals
    -------
    changed()
        Commands have other keys.
    """

    changed = Signal()

    def __init__(self, window: QMainWindow, settings: QSettings | None) -> None:
        super().__init__(window)
        self._window, self._settings = window, settings
        self._usual: dict[str, QKeySequence] = {}
        self.entries()

    def entries(self) -> list[Entry]:
        """All commands; those that came since the last time get the user's keys."""
        entries = commands_of(self._window)
        for entry in entries:
            if entry.id not in self._usual:
                self._usual[entry.id] = entry.action.shortcut()
                chosen = self._chosen(entry.id)
                if chosen is not None:
                    _give(entry, chosen)
        return entries

    def usual(self, entry: Entry) -> QKeySequence:
        """The key that the program gives a command."""
        return self._usual[entry.id]

    def is_own(self, entry: Entry) -> bool:
        """Whether the user gave the command another key."""
        return entry.action.shortcut() != self._usual[entry.id]

    def rivals(self, entry: Entry, keys: QKeySequence) -> list[Entry]:
        """Other commands that these keys would call, or that begin or go on with them."""
        if keys.isEmpty():
            return []
        others = [other for other in self.entries() if other.action is not entry.action]
        return [other for other in others if _collide(other.action.shortcut(), keys)]

    def assign(self, entry: Entry, keys: QKeySequence, *, take: bool = True) -> None:
        """Give a command other keys (none: empty), and with `take` take them from whoever has them."""
        for rival in self.rivals(entry, keys) if take else ():
            self._set(rival, QKeySequence())
        self._set(entry, keys)
        self.changed.emit()

    def reset(self, entry: Entry) -> None:
        """Give a command its usual keys back."""
        self.assign(entry, self._usual[entry.id])

    def reset_all(self) -> None:
        """Give every command its usual keys back."""
        for entry in self.entries():
            self._set(entry, self._usual[entry.id])
        self.changed.emit()

    def _set(self, entry: Entry, keys: QKeySequence) -> None:
        _give(entry, keys)
        if self._settings is None:
            return
        if keys == self._usual[entry.id]:
            self._settings.remove(_name(entry.id))
        else:
            self._settings.setValue(_name(entry.id), keys.toString(PORTABLE))

    def _chosen(self, identifier: str) -> QKeySequence | None:
        if self._settings is None or not self._settings.contains(_name(identifier)):
            return None
        return QKeySequence(str(self._settings.value(_name(identifier), "")), PORTABLE)


def _name(identifier: str) -> str:
    return f"{GROUP}/{identifier.replace('/', '_')}"


def _give(entry: Entry, keys: QKeySequence) -> None:
    entry.action.setShortcut(keys)
    show_keys(entry.action)


def _collide(one: QKeySequence, other: QKeySequence) -> bool:
    return not one.isEmpty() and (one.matches(other) != NO_MATCH or other.matches(one) != NO_MATCH)
