"""What the tests of the window share: one application set up as the program's own, and a look for leaks."""

from __future__ import annotations

import gc
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QSettings, QStandardPaths, Qt
from PySide6.QtWidgets import QApplication

from tests.ui.places import Place
from tests.ui.runner_watch import MakeWatch, Watch, workers
from tests.ui.stand_ins import Bench
from ui import units
from ui.app import Studio, prepare_qt
from ui.collecting import Collector
from ui.habits import Habits
from ui.language import Language
from ui.theme import Theme
from ui.units import Display


@pytest.fixture(scope="session")
def qapp_cls() -> type[QApplication]:
    """The application with the surface format and shared contexts of the program."""
    if QApplication.instance() is None:
        prepare_qt()
        QCoreApplication.setAttribute(Qt.ApplicationAttribute.AA_DontUseNativeDialogs)
    return QApplication


@pytest.fixture(scope="session")
def theme(qapp: QApplication) -> Theme:
    made = Theme(qapp)
    made.apply()
    return made


@pytest.fixture(scope="session")
def collector(qapp: QApplication) -> Collector:
    return Collector()


@pytest.fixture(autouse=True)
def _garbage_is_collected_as_in_the_program(collector: Collector) -> Iterator[None]:
    """Never in the threads of a window: what is left of earlier windows would end there."""
    gc.disable()
    yield
    collector.look()
    gc.enable()


@pytest.fixture(autouse=True)
def _own_settings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Neither read nor change the settings and the log of whoever runs the tests."""
    QStandardPaths.setTestModeEnabled(True)
    for kind in (QSettings.Format.NativeFormat, QSettings.Format.IniFormat):
        QSettings.setPath(kind, QSettings.Scope.UserScope, str(tmp_path))
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))


@pytest.fixture(autouse=True)
def _no_view_is_left_open() -> Iterator[None]:
    """Every interactor that a test made must be closed when the test ends."""
    yield
    module = sys.modules.get("ui.viewport")
    if module is None:
        return
    left = [thing for thing in gc.get_objects() if type(thing) is module.Viewport and not thing._closed]
    for thing in left:
        thing.close()
    assert not left, "a test left 3D views open"


@pytest.fixture
def settings(tmp_path: Path) -> QSettings:
    return QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat)


@pytest.fixture
def bench(qtbot, theme) -> Iterator[Bench]:
    """A window in sight without views, with a runner that does what the test says."""
    made = Bench()
    made.window.show()
    yield made
    made.close()


@pytest.fixture
def bench_with_habits(bench: Bench, settings: QSettings) -> Iterator[Bench]:
    """With what every desktop program has, as ``bench.habits``."""
    bench.window._settings = settings
    bench.habits = Habits(bench.controller)  # type: ignore[attr-defined]
    bench.window.resize(1280, 720)
    yield bench
    units.use(Display())


@pytest.fixture
def place(qtbot, theme, tmp_path: Path) -> Iterator[Place]:
    made = Place(tmp_path / "data")
    yield made
    made.bench.close()


@pytest.fixture
def make_watch(qtbot) -> Iterator[MakeWatch]:
    """Makes runners under test, and closes them."""
    watches: list[Watch] = []

    def make(**options: object) -> Watch:
        watches.append(Watch(qtbot, **options))
        return watches[-1]

    yield make
    for watch in watches:
        watch.runner.close()
    assert workers() == []


@pytest.fixture
def open_studio(qtbot, theme, settings: QSettings) -> Iterator[Callable[..., Studio]]:
    """Opens windows of the whole program; in the end nothing is left of them."""
    opened: list[Studio] = []

    def make(**options: object) -> Studio:
        studio = Studio(theme, settings, **options)
        opened.append(studio)
        studio.window.show()
        return studio

    yield make
    for studio in opened:
        studio.window.may_close = lambda: True
        studio.window.close()
        studio.window.deleteLater()
        studio.language.speak("en")
    assert workers() == []


@pytest.fixture
def grid(qtbot):
    """3D views of their own."""
    from ui.view_grid import ViewGrid

    made = ViewGrid()
    made.resize(900, 600)
    made.show()
    qtbot.waitExposed(made)
    yield made
    made.close_views()
    made.close()
    made.deleteLater()


@pytest.fixture
def view(grid):
    """The scene of solids in a view of its own."""
    from ui.solid_view import SolidView

    return SolidView(grid)


@pytest.fixture
def speak(qapp: QApplication) -> Iterator[Callable[[str], None]]:
    """Changes the language that the application speaks, for this test."""
    language = Language(qapp, "en")
    yield language.speak
    language.speak("en")


@pytest.fixture
def german(speak: Callable[[str], None]) -> None:
    speak("de")
