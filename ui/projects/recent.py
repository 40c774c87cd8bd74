"""The menu of the designs opened last."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, QSettings, Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu

from ui.words import tr

KEPT = 12
KEY = "files/recent"


class Recent(QObject):
    """Remembers design files, newest first, and fills a menu with them; those that are gone are marked.

    Signals
    -------
    chosen(object)
        The path of a design to open.
    """

    chosen = Signal(object)

    def __init__(self, menu: QMenu, settings: QSettings | None, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._menu, self._settings = menu, settings
        self._paths = _stored(settings)
        self._actions = [
            self._make_action(f"recent.{number}", "", lambda place=number - 1: self.chosen.emit(self._paths[place]))
            for number in range(1, KEPT + 1)
        ]
        menu.addSeparator()
        self._forget = self._make_action(
            "remove_missing", tr("Remove &missing ones"), lambda: self.remove(self._missing())
        )
        self._clear = self._make_action("clear_recent", tr("&Clear the list"), lambda: self._keep([]))
        menu.setToolTipsVisible(True)
        menu.aboutToShow.connect(self._fill)
        self._fill()

    @property
    def paths(self) -> tuple[Path, ...]:
        """The designs, the newest first."""
        return tuple(self._paths)

    def add(self, path: Path) -> None:
        """Put a design first. What other windows added meanwhile stays."""
        path = path.absolute()
        others = _stored(self._settings) if self._settings is not None else self._paths
        self._keep([path, *(other for other in others if other != path)][:KEPT])

    def remove(self, paths: tuple[Path, ...]) -> None:
        """Forget designs."""
        self._keep([path for path in self._paths if path not in paths])

    def _keep(self, paths: list[Path]) -> None:
        self._paths = paths
        if self._settings is not None:
            self._settings.setValue(KEY, [str(path) for path in paths])
        self._fill()

    def _fill(self) -> None:
        if self._settings is not None:
            self._paths = _stored(self._settings)
        missing = self._missing()
        for number, action in enumerate(self._actions, 1):
            path = self._paths[number - 1] if number <= len(self._paths) else None
            action.setVisible(path is not None)
            action.setEnabled(path is not None and path not in missing)
            words = tr("Recent design {number}", number=number) if path is None else path.name.replace("&", "&&")
            text = tr("{name} (missing)", name=words) if path in missing else words
            action.setText(f"&{number}  {text}" if number < 10 else f"{number}  {text}")
            action.setToolTip("" if path is None else str(path))
        self._forget.setEnabled(bool(missing))
        self._clear.setEnabled(bool(self._paths))

    def _missing(self) -> tuple[Path, ...]:
        return tuple(path for path in self._paths if not path.is_file())

    def _make_action(self, name: str, text: str, run: Callable[[], None]) -> QAction:
        action = self._menu.addAction(text)
        action.setObjectName(name)
        action.triggered.connect(lambda _checked=False: run())
        return action


def _stored(settings: QSettings | None) -> list[Path]:
    if settings is None:
        return []
    value = settings.value(KEY)
    names = [value] if isinstance(value, str) else value if isinstance(value, list) else []
    return [Path(name) for name in names if isinstance(name, str) and name and "\0" not in name][:KEPT]
