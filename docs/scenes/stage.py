"""The window on a stage: it is driven from scene to scene, and somebody looks at each."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QSettings, Qt, QTimer
from PySide6.QtWidgets import QApplication, QMenu, QWidget

from gearstudio.design import Design
from gearstudio.presets import PRESETS_BY_KEY
from ui.app import Studio
from ui.layers import LAYER_SETS
from ui.theme import Theme
from ui.views.appearance import Appearance

PATIENCE_S = 180.0


def spin(seconds: float) -> None:
    """Run events for a while."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QApplication.processEvents()
        time.sleep(0.004)


def wait_for(condition: Callable[[], bool], patience: float = PATIENCE_S) -> None:
    """Run events until a condition holds."""
    start = time.monotonic()
    while not condition():
        if time.monotonic() - start > patience:
            raise TimeoutError("the window did not get ready")
        QApplication.processEvents()
        time.sleep(0.004)


class Stage:
    """A window with settings and designs of its own in ``folder``; ``look`` is called with the name of each scene.

    With ``built`` it has its CAD process; without, the scenes that need solids or reports are left out.
    """

    def __init__(
        self, theme: Theme, folder: Path, look: Callable[[str], None], *, built: bool = True, rest: float = 0.4
    ) -> None:
        settings = QSettings(str(folder / "settings.ini"), QSettings.Format.IniFormat)
        settings.setValue("help/tour_seen", True)
        self.folder, self.look, self.built, self.rest = folder, look, built, rest
        self.theme = theme
        self.studio = Studio(theme, settings, data=folder / "data")
        self.session, self.window, self.controller = self.studio.session, self.studio.window, self.studio.controller
        self.window.move(0, 0)

    @property
    def area(self) -> QWidget:
        """The part of the window with the views."""
        return self.window.area

    def open(self) -> None:
        """Show the window and wait until everything is there."""
        self.window.show()
        wait_for(lambda: self.window.area.grid is not None and bool(self.window.analysis._factories))
        self.settle()

    def resize(self, width: int, height: int) -> None:
        """Another size, with the panels of a new window of that size."""
        self.window.resize(width, height)
        spin(0.2)
        self.window.reset_layout()
        spin(self.rest)

    def choose_theme(self, dark: bool) -> None:
        """Light or dark."""
        self.theme.choose(Qt.ColorScheme.Dark if dark else Qt.ColorScheme.Light)
        spin(self.rest)

    def settle(self) -> None:
        """Wait until the flanks in sight are built and drawn."""
        self.session.settle()
        wait_for(lambda: self.session.pair is not None and not (self.built and self.session.missing_keys()))
        spin(self.rest)

    def show(self, name: str, rest: float = 0.0) -> None:
        """Let somebody look at the scene."""
        self._pause(rest)
        self.look(name)

    def page(self, tab: str, rest: float = 0.0) -> QWidget:
        """Another page of the analysis."""
        self.window.analysis.show_tab(tab)
        self._pause(rest)
        return self.window.analysis.page

    def preset(self, key: str) -> None:
        """Another design, nothing of it unsaved."""
        design = PRESETS_BY_KEY[key].design if key != "default" else Design()
        self.session.load(design, None, saved=True)
        self.studio.files.opened.emit()
        self.settle()

    def layers(self, name: str) -> None:
        """A ready-made set of layers."""
        self.window.layer_panel.set_chosen.emit(dict(LAYER_SETS)[name])

    def appear(self, **choices: object) -> None:
        """What the Display panel says; nothing for that of a new window."""
        self.controller.display.show_appearance(Appearance(**choices))

    def dock(self, name: str, shown: bool) -> None:
        """A panel, by the name of its dock."""
        self.window.findChild(QWidget, name).setVisible(shown)

    def dialog(self, name: str, act: Callable[[], object], rest: float = 0.0) -> None:
        """What opens when something is done; it is closed then."""
        before = set(_tops())
        act()
        self._pause(rest)
        self.look(name)
        self.close_all(before)

    def question(self, name: str, act: Callable[[], object]) -> None:
        """A question that is waited for: it is looked at and refused."""

        def answer() -> None:
            asked = QApplication.activeModalWidget()
            if asked is None:
                timer.start()
                return
            spin(self.rest)
            self.look(name)
            asked.close()

        timer = QTimer(singleShot=True, interval=50)
        timer.timeout.connect(answer)
        timer.start()
        act()
        spin(min(self.rest, 0.1))

    def menu(self, name: str, menu: QMenu, place: QWidget | None = None) -> None:
        """A menu below a part of the window."""
        below = place or self.window.menuBar()
        menu.popup(below.mapToGlobal(below.rect().bottomLeft()))
        spin(self.rest)
        self.look(name)
        menu.close()
        spin(min(self.rest, 0.1))

    def close_all(self, but: set[QWidget] | None = None) -> None:
        """Close every window but these, and the main one."""
        for top in _tops():
            if top is not self.window and top not in (but or set()):
                top.close()
        spin(min(self.rest, 0.15))

    def _pause(self, rest: float) -> None:
        """Let everything be drawn: as long as a scene needs it, where pictures are taken."""
        spin(max(rest, self.rest) if self.built else self.rest)

    def leave(self) -> None:
        """Close the window."""
        self.close_all()
        self.session.mark_saved(self.folder / "left.gear.toml", self.session.design)
        self.window.may_close = lambda: True
        self.window.close()


def _tops() -> list[QWidget]:
    return [top for top in QApplication.topLevelWidgets() if top.isVisible()]
