"""The menu of the designs opened last."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject, QSettings, Signal
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
        self._menu.clear()
        missing = tuple(path for path in self._paths if not path.is_file())
        for number, path in enumerate(self._paths, 1):
            words = path.name.replace("&", "&&")
            text = tr("{name} (missing)", name=words) if path in missing else words
            action = self._menu.addAction(f"&{number}  {text}" if number < 10 else f"{number}  {text}")
            action.setToolTip(str(path))
            action.setEnabled(path not in missing)
            action.triggered.connect(lambda _checked=False, chosen=path: self.chosen.emit(chosen))
        self._menu.addSeparator()
        forget = self._menu.addAction(tr("Remove &missing ones"))
        forget.setEnabled(bool(missing))
        forget.triggered.connect(lambda _checked=False: self.remove(missing))
        clear = self._menu.addAction(tr("&Clear the list"))
        clear.setEnabled(bool(self._paths))
        clear.triggered.connect(lambda _checked=False: self._keep([]))


def _stored(settings: QSettings | None) -> list[Path]:
    if settings is None:
        return []
    value = settings.value(KEY)
    names = [value] if isinstance(value, str) else value if isinstance(value, list) else []
    return [Path(name) for name in names if isinstance(name, str) and name and "\0" not in name][:KEPT]
