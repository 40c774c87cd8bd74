"""Another language in the open window: every text changes, nothing else does, and the old window is gone."""

from __future__ import annotations

import gc
import re
import weakref
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from pathlib import Path

import pytest
from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QApplication, QCheckBox, QDialog, QMenu, QWidget

from gearstudio.design import Design, with_field
from gearstudio.project import save_design
from tests.ui.reading import texts_of
from tests.ui.screen import NEEDS_SCREEN
from tests.ui.whole import PATIENCE_MS, TEETH, complete, edit
from tools import translations
from ui.app import Studio
from ui.language import Language
from ui.preferences_dialog import PreferencesDialog
from ui.session import Key

pytestmark = NEEDS_SCREEN
CHINESE = re.compile(r"[\u4e00-\u9fff]")
OWN_NAMES = {"English", "Deutsch", "中文"}


@pytest.fixture
def open_studio(open_studio, settings: QSettings, tmp_path: Path) -> Callable[[], Studio]:
    settings.setValue("language", "en")
    return partial(open_studio, data=tmp_path / "data")


@pytest.fixture
def studio(open_studio, qtbot) -> Studio:
    made = open_studio()
    qtbot.waitUntil(lambda: made.loader.has_finished and complete(made), timeout=PATIENCE_MS)
    return made


def choose(studio: Studio, qtbot, language: str) -> None:
    """As the user does: in the preferences."""
    studio.habits.preferences.set(language=language)
    qtbot.waitUntil(lambda: studio.language.spoken == language, timeout=20_000)
    qtbot.wait(200)


def left_over(studio: Studio, language: str) -> list[str]:
    """Texts of the window in another language than the present one."""
    places = {text: where for where, text in texts_of(studio.window) if text not in OWN_NAMES}
    shown = set(places)
    if language != "zh":
        assert not [text for text in shown if CHINESE.search(text)]
    other = {"en": "de", "de": "en", "zh": "de"}[language]
    foreign = _words(other) - _words(language)
    if language == "zh":
        foreign |= _words("en") - _words("zh")
    return sorted(f"{places[text]}: {text}" for text in shown & foreign)


def _words(language: str) -> set[str]:
    """What is said in a language, with the marks of keys and without."""
    known = translations.read_ts(translations.ts_path("de" if language == "en" else language))[translations.WORDS]
    said = set(known) if language == "en" else set(known.values())
    return (said | {text.replace("&", "") for text in said}) - {""}


def main_windows() -> set[QWidget]:
    return {widget for widget in QApplication.topLevelWidgets() if type(widget).__name__ == "MainWindow"}


def test_the_window_takes_another_language_and_keeps_everything_else(studio: Studio, qtbot) -> None:
    session, runner = studio.session, studio.controller.runner
    edit(studio, TEETH, 19)
    edit(studio, "name", "Something")
    qtbot.waitUntil(lambda: complete(studio), timeout=PATIENCE_MS)
    window, grid = studio.window, studio.window.area.grid
    window.resize(1400, 860)
    grid.set_view("front")
    look = grid.viewport.looks[0]
    grid.set_visible_layers(grid.visible_layers | {"base_cone"})
    window.area.color_bar.set_range(-0.5, 0.5)
    window.analysis.show_tab("charts")
    qtbot.wait(300)
    page = window.analysis.page
    page.kinds.button("histogram").click()
    page.paper.click()
    session.forget_results([Key("wheel", "point_cloud", "published")])
    studio.controller.builds.build_missing()
    qtbot.waitUntil(lambda: complete(studio), timeout=PATIENCE_MS)
    before = dict(session.results), dict(session.draft), runner.process_id, window.geometry()
    started: list[object] = []
    runner.job_started.connect(started.append)
    others = main_windows() - {window}

    for language, undo in (("de", "Name auf “Something” ändern"), ("zh", "Something"), ("en", "Change name to")):
        old = weakref.ref(studio.window), weakref.ref(studio.window.area.grid)
        choose(studio, qtbot, language)
        window, grid = studio.window, studio.window.area.grid
        assert not left_over(studio, language)
        assert undo in window.commands["undo"].text() or language == "de", window.commands["undo"].text()
        gc.collect()
        assert old[0]() is None and old[1]() is None, "the old window is still there"
        assert main_windows() - others == {window}
        assert window.isVisible() and window.geometry() == before[3]
        assert session.results == before[0] and session.draft == before[1] and session.unsaved
        assert window.isWindowModified()
        assert runner is studio.controller.runner and runner.process_id == before[2] and not started
        assert (grid.viewport.looks[0].eye == look.eye).all() and "base_cone" in grid.visible_layers
        assert window.area.color_bar.range == (-0.5, 0.5) and not window.area.color_bar.automatic
        assert window.analysis.tab == "charts" and window.analysis.page.kind == "histogram"
        assert not window.analysis.page.paper.isChecked()
        assert all(panel.subtitle for panel in grid.panels)

    studio.window.commands["undo"].trigger()
    studio.window.commands["undo"].trigger()
    assert session.draft[TEETH] == 17 and not session.unsaved and not studio.window.isWindowModified()
    choose(studio, qtbot, "de")
    assert "Wiederholen" in studio.window.commands["redo"].text()
    studio.window.commands["redo"].trigger()
    assert session.draft[TEETH] == 19
    qtbot.waitUntil(lambda: complete(studio), timeout=PATIENCE_MS)


def test_work_in_progress_goes_on_and_messages_follow(studio: Studio, qtbot) -> None:
    studio.window.messages.show_message("info", "", topic="file")
    studio.desk.recover()
    assert studio.window.messages.text == "There is no unsaved work to recover."
    runner, asked, begun = studio.controller.runner, [], []
    studio.session.results_changed.connect(lambda _: begun.append(studio.session.building))
    edit(studio, TEETH, 23)
    qtbot.waitUntil(lambda: any(begun), timeout=PATIENCE_MS)
    submit = runner.submit
    runner.submit = lambda jobs, replace=True: (asked.append(jobs), submit(jobs, replace))
    choose(studio, qtbot, "de")
    assert "wiederherzustellen" in studio.window.messages.text
    qtbot.waitUntil(lambda: complete(studio), timeout=PATIENCE_MS)
    assert not asked, "what was on its way was asked for again"
    assert studio.session.design.pair.pinion_teeth == 23
    qtbot.waitUntil(lambda: "…" not in "".join(p.subtitle for p in studio.window.area.grid.panels), timeout=5000)
    assert studio.desk.autosave is not None
    qtbot.waitUntil(studio.desk.autosave.file.exists, timeout=5000)


def test_the_dialog_stands_open_in_the_new_language_and_solids_stay(studio: Studio, qtbot) -> None:
    studio.controller.solid_mode.build("gear")
    solids = studio.controller.solid_mode.solids
    qtbot.waitUntil(lambda: bool(solids.built) and not solids._awaited, timeout=PATIENCE_MS)
    built = dict(solids.built)
    qtbot.waitUntil(lambda: [p.key for p in studio.window.area.grid.panels] == ["solid"], timeout=10_000)
    qtbot.wait(300)
    grid = studio.window.area.grid
    grid.viewport.set_camera(grid.viewport.look.turned(0.4, 0.2))
    eye = grid.viewport.look.eye
    studio.window.solid_panel.section.box.click()
    studio.habits.open_preferences(0)
    dialog = studio.window.findChild(PreferencesDialog)
    combo = dialog.editors["language"]
    combo.setCurrentIndex(combo.findData("zh"))
    combo.activated.emit(combo.currentIndex())
    qtbot.waitUntil(lambda: studio.language.spoken == "zh", timeout=20_000)
    dialogs = [d for d in studio.window.findChildren(QDialog) if d.isVisible()]
    assert [d.windowTitle() for d in dialogs] == ["首选项"]
    assert dialogs[0].editors["language"].currentData() == "zh"
    assert dialogs[0].findChild(QWidget, options=Qt.FindChildOption.FindDirectChildrenOnly) is not None
    dialogs[0].close()
    assert studio.controller.solid_mode.solids is solids and solids.built == built
    assert studio.controller.solid_mode.mode == "gear" and studio.window.solid_panel.section.plane is not None
    qtbot.waitUntil(lambda: [p.key for p in studio.window.area.grid.panels] == ["solid"], timeout=10_000)
    qtbot.wait(100)
    assert studio.window.area.grid.viewport.look.eye == pytest.approx(eye)
    studio.controller.solid_mode.set_mode("flanks")
    qtbot.waitUntil(lambda: len(studio.window.area.grid.panels) == 3, timeout=10_000)


def test_report_comparison_and_help_stay_open_with_what_was_chosen(studio: Studio, qtbot, tmp_path: Path) -> None:
    other = tmp_path / "other.gear.toml"
    save_design(other, with_field(Design(), TEETH, 21))
    controller, runner = studio.controller, studio.controller.runner
    controller.reporting.open()
    report = controller.reporting.dialog
    for box in report.findChildren(QCheckBox):
        box.setChecked(box is report._boxes["design"])
    report.move(60, 40)
    report.make.click()
    qtbot.waitUntil(report.save.isEnabled, timeout=PATIENCE_MS)
    pages = report.pages.page_count
    report._boxes["equations"].setChecked(True)
    chosen = report.sections
    report.make.click()
    qtbot.waitUntil(lambda: controller.reporting.keep_state().job is not None, timeout=10_000)
    studio.desk.compare().compare_with(other)
    guide = controller.help.open_guide("glossary")
    guide.search.setText("cone")
    cancelled: list[object] = []
    runner.job_cancelled.connect(cancelled.append)

    choose(studio, qtbot, "de")
    shown = {type(one): one for one in studio.window.findChildren(QDialog) if one.isVisible()}
    assert {kind.__name__ for kind in shown} == {"ReportDialog", "CompareDialog", "GuideWindow"}
    again = studio.controller.reporting.dialog
    assert again is not report and again.windowTitle() == "Bericht" and again.sections == chosen
    assert again.pages.page_count >= pages and (again.x(), again.y()) == (60, 40)
    compare = next(one for kind, one in shown.items() if kind.__name__ == "CompareDialog")
    qtbot.waitUntil(lambda: bool(compare.lines), timeout=10_000)
    assert compare.other.currentData() == other
    guide = next(one for kind, one in shown.items() if kind.__name__ == "GuideWindow")
    assert guide.pages.currentData() == "glossary" and guide.search.text() == "cone"
    qtbot.waitUntil(lambda: again.save.isEnabled(), timeout=PATIENCE_MS)
    assert not cancelled and not again.trouble.isVisible() and again.pages.page_count > pages


def test_every_command_has_a_name_of_its_own_and_keeps_its_key_in_every_language(studio: Studio, qtbot) -> None:
    bound = {"export": "Ctrl+F5", "layers.base_cone": "Ctrl+F6", "undock.Log": "Ctrl+F7", "panels.Log": "Ctrl+F9",
             "presets.fine": "Ctrl+F10", "recent.1": "Ctrl+F11", "views.iso": ""}  # fmt: skip
    keys = studio.habits.keys
    entries = {entry.id: entry for entry in keys.entries()}
    for name, chosen in bound.items():
        keys.assign(entries[name], QKeySequence(chosen))
    for language in ("de", "zh", "en"):
        choose(studio, qtbot, language)
        now = {entry.id: entry for entry in studio.habits.keys.entries()}
        assert now.keys() == entries.keys()
        assert {name: now[name].action.shortcut().toString() for name in bound} == bound
        actions = {id(action): action for action in _commands(studio.window.menuBar().actions())}
        names = [action.objectName() for action in actions.values()]
        assert all(names), [action.text() for action in actions.values() if not action.objectName()]
        assert len(names) == len(set(names)) and set(names) <= now.keys()
        for name, entry in now.items():
            assert entry.title and not studio.habits.keys.rivals(entry, entry.action.shortcut()), name


def _commands(actions: Iterable[QAction]) -> Iterator[QAction]:
    for action in actions:
        if isinstance(action.menu(), QMenu):
            yield from _commands(action.menu().actions())
        elif not action.isSeparator():
            yield action


def test_a_window_asked_for_in_another_language_than_the_preferences_keeps_it(qtbot, theme, tmp_path: Path) -> None:
    settings = QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat)
    settings.setValue("language", "de")
    studio = Studio(theme, settings, language=Language(QApplication.instance(), "zh"))
    window = studio.window
    try:
        window.show()
        qtbot.waitUntil(lambda: studio.loader.has_finished, timeout=PATIENCE_MS)
        assert studio.window is window and studio.language.spoken == "zh"
    finally:
        window.close()
        studio.language.speak("en")


def test_a_language_chosen_while_the_parts_are_loaded(open_studio, qtbot) -> None:
    studio = open_studio()
    qtbot.waitSignal(studio.loader.loaded, timeout=PATIENCE_MS, check_params_cb=lambda s: s == "worker").wait()
    choose(studio, qtbot, "de")
    qtbot.waitUntil(lambda: studio.loader.has_finished and complete(studio), timeout=PATIENCE_MS)
    assert studio.window.area.grid is not None
    qtbot.wait(300)
    assert not left_over(studio, "de")
