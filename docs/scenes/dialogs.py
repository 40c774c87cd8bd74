"""Scenes of the dialogs, questions, help and menus."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QComboBox, QMenu

from docs.scenes.stage import Stage, spin, wait_for
from gearstudio.design import Design
from gearstudio.presets import PRESETS_BY_KEY
from gearstudio.project import save_design
from ui.export_dialog import ExportDialog
from ui.projects.compare_dialog import CompareDialog
from ui.projects.lock import Holder, ask_how_to_open
from ui.projects.snapshot import Snapshot, write_snapshot
from ui.session import flatten

REPORT = "Traceback (most recent call last):\n" + "\n".join(
    f'  File "gearstudio/theory/part_{number}.py", line {number}, in step' for number in range(1, 20)
)


def saved(stage: Stage) -> Path:
    """A design that was saved more than once."""
    path = stage.folder / "rear-axle.gear.toml"
    save_design(path, Design())
    stage.studio.files.open_path(path)
    wait_for(lambda: stage.session.path == path)
    stage.studio.files.save()
    stage.controller.edits.change("pair.pinion_teeth", 18)
    stage.studio.files.save()
    return path


def exports(stage: Stage) -> None:
    """Every part with all its kinds of file."""
    for mode, part in (("flanks", "flanks"), ("flanks", "tooth"), ("gear", "gear"), ("pair", "gear")):
        dialog = ExportDialog(stage.session, str(stage.folder), stage.window, None, mode)
        parts = next(combo for combo in dialog.findChildren(QComboBox) if combo.findData("tooth") >= 0)
        parts.setCurrentIndex(parts.findData(part))
        for box in dialog._formats.values():
            box.setChecked(True)
        stage.dialog(f"export-{mode}-{part}", dialog.open)
        dialog.deleteLater()


def outputs(stage: Stage) -> None:
    """Report, picture and film."""
    commands, reporting = stage.window.commands, stage.controller.reporting
    stage.dialog("report-empty", commands["report"].trigger)
    if stage.built:
        commands["report"].trigger()
        reporting.dialog.make.click()
        stage.show("report-working", 1.0)
        wait_for(lambda: reporting.dialog.make.isEnabled())
        stage.show("report")
        stage.close_all()
    stage.dialog("picture", commands["screenshot"].trigger)
    stage.dialog("film", commands["film"].trigger)


def preferences(stage: Stage) -> None:
    """Its pages, the palette, and what the program says of itself."""
    habits = stage.studio.habits
    for number, name in enumerate(("display", "work", "keys")):
        stage.dialog(f"preferences-{name}", lambda page=number: habits.open_preferences(page))
    stage.dialog("palette", habits.open_palette)
    stage.dialog("about", stage.window.commands["about"].trigger)
    stage.dialog("crash", lambda: stage.studio.report_crash(REPORT))


def projects(stage: Stage) -> None:
    """Backups, recovery and comparison of designs."""
    path, desk = saved(stage), stage.studio.desk
    stage.dialog("backups", desk.show_backups)
    other = stage.folder / "other.gear.toml"
    save_design(other, PRESETS_BY_KEY["automotive"].design)
    stage.dialog("compare-empty", desk.compare)
    desk.compare()
    spin(0.2)
    dialog = next(top for top in QApplication.topLevelWidgets() if isinstance(top, CompareDialog) and top.isVisible())
    dialog.compare_with(other)
    stage.show("compare", 0.8)
    stage.close_all()
    for name, where in (("rear-axle", path), ("gearbox", None)):
        draft = {**flatten(Design()), "pair.wheel_teeth": "fifty", "pair.pinion_teeth": 19, "tooth.profile_shift": 0.2}
        file = stage.folder / "data" / "recovery" / f"{name}.json"
        file.parent.mkdir(parents=True, exist_ok=True)
        write_snapshot(file, Snapshot(name, where, datetime.now().astimezone(), draft))
    stage.dialog("recovery", desk.offer_recovery)
    recovery = desk.offer_recovery()
    stage.question("recovery-discard", recovery.discard.click)
    for file in (stage.folder / "data" / "recovery").glob("*.json"):
        file.unlink()
    stage.close_all()


def questions(stage: Stage) -> None:
    """What is asked before something is lost."""
    files, window, session = stage.studio.files, stage.window, stage.session
    path = saved(stage)
    stage.question("reset-settings", stage.studio.upkeep.reset_settings)
    stage.question("lock", lambda: ask_how_to_open(window, path, Holder(4711, "another-computer")))
    stage.dialog("file-changed", lambda: stage.studio.desk.watch._ask(path))
    stage.question("folder-gone", lambda: files._ask_for_another_folder(stage.folder / "gone" / "x.gear.toml"))
    stage.question("open-file", files.open)
    stage.controller.edits.change("pair.pinion_teeth", 20)
    stage.question("save-changes", files.may_discard)
    session.mark_saved(path, session.design)


def helping(stage: Stage) -> None:
    """Guide, glossary, equations, tour and the answer to "What is this?"."""
    commands, desk = stage.window.commands, stage.controller.help
    stage.dialog("guide", commands["guide"].trigger, 0.8)
    stage.dialog("glossary", commands["glossary"].trigger, 0.8)
    stage.dialog("equations", lambda: desk.open_equations("base_angle"), 1.0)
    desk.tour.start()
    for step in range(len(desk.tour._steps)):
        stage.show(f"tour-{step + 1}")
        desk.tour.card.next.click()
    spin(0.1)


def menus(stage: Stage) -> None:
    """Every menu of the bar with its submenus."""
    bar = stage.window.menuBar()
    for number, action in enumerate(bar.actions()):
        menu = action.menu()
        stage.menu(f"menu-{number + 1}", menu)
        for inner, entry in enumerate(menu.actions()):
            if entry.menu() is not None and entry.menu().actions():
                stage.menu(f"menu-{number + 1}-{inner + 1}", entry.menu())
    field = stage.window.form.rows["pair.pinion_teeth"].field
    _popup(stage, "menu-field", lambda: field.customContextMenuRequested.emit(field.rect().center()))


def _popup(stage: Stage, name: str, act: Callable[[], None]) -> None:
    """A menu that is waited for."""

    def look() -> None:
        spin(stage.rest)
        stage.look(name)
        menu = QApplication.activePopupWidget()
        if isinstance(menu, QMenu):
            menu.close()

    QTimer.singleShot(300, look)
    act()
    spin(0.5 + stage.rest)


DIALOGS = (exports, outputs, preferences, projects, questions, helping, menus)
