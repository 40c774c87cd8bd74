"""Habits of a desktop program: names of steps, resetting, preferences, palette, keys, copying."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QGuiApplication, QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
)

from gearstudio.design import field_specs
from gearstudio.presets import PRESETS
from tests.ui.stand_ins import Bench
from ui.effects import effect_lines
from ui.fuzzy import fit
from ui.keys import Keys
from ui.palette import Palette
from ui.preferences import NAMES, Choices, Preferences, read
from ui.tables import copy_text, table_text

pytestmark = pytest.mark.ui
TEETH, MODULE = "pair.wheel_teeth", "pair.outer_module"


@pytest.fixture
def bench(bench_with_habits: Bench) -> Bench:
    return bench_with_habits


def labels(bench: Bench) -> tuple[str, str]:
    history = bench.controller.edits.history
    return history.undo_label, history.redo_label


def test_steps_are_named_in_the_menu_and_when_taken_back(bench: Bench) -> None:
    for text in ("4", "41"):
        bench.type_into(TEETH, text)
    commands = bench.window.commands
    assert commands["undo"].text() == "&Undo Change wheel teeth to 41"
    commands["undo"].trigger()
    assert bench.session.draft[TEETH] == 40
    assert bench.window.status.currentMessage() == "Undone: Change wheel teeth to 41"
    assert commands["redo"].text() == "&Redo Change wheel teeth to 41" and not commands["undo"].isEnabled()


def test_leaving_a_field_ends_the_step(bench: Bench) -> None:
    bench.type_into(TEETH, "41")
    bench.window.form.rows[TEETH].field.editingFinished.emit()
    bench.type_into(TEETH, "42")
    bench.window.commands["undo"].trigger()
    assert bench.session.draft[TEETH] == 41


def test_undo_brings_back_every_kind_of_value(bench: Bench) -> None:
    """Text, choice, number, derived and wrong values, a preset, a group: back to the start and forth again."""
    edits, start = bench.controller.edits, dict(bench.session.draft)
    for path, value in (
        ("pair.face_width", 20.0), ("pair.face_width", None), (MODULE, "abc"), (MODULE, 3),
        ("lengthwise.curve", "archimedean"), ("name", "x"), ("blank.pinion.bore_diameter", 10.0),
    ):  # fmt: skip
        edits.change(path, value)
        edits.history.seal()
    edits.take_preset(PRESETS[1])
    edits.reset_group("Tooth")
    end = dict(bench.session.draft)
    while labels(bench)[0]:
        edits.undo()
    assert bench.session.draft == start
    while labels(bench)[1]:
        edits.redo()
    assert bench.session.draft == end
    for path, row in bench.window.form.rows.items():
        assert row.field.value() == end[path], path


def test_a_changed_field_offers_its_default(bench: Bench) -> None:
    row = bench.window.form.rows[TEETH]
    assert row.reset.isHidden()
    bench.type_into(TEETH, "41")
    assert not row.reset.isHidden() and bench.window.form._sections["Pair"].marks == "1 changed"
    row.reset.click()
    assert bench.session.draft[TEETH] == 40 and row.reset.isHidden() and row.field.text() == "40"
    assert labels(bench)[0] == "Reset wheel teeth"


def test_groups_and_all_are_reset_in_one_step(bench: Bench) -> None:
    bench.type_into(TEETH, "41")
    bench.type_into(MODULE, "5")
    bench.type_into("tooth.backlash", "0.1")
    bench.window.form._sections["Pair"].reset_requested.emit()
    assert (bench.session.draft[TEETH], bench.session.draft[MODULE]) == (40, 4.0)
    assert bench.session.draft["tooth.backlash"] == 0.1
    bench.window.commands["undo"].trigger()
    assert bench.session.draft[TEETH] == 41
    bench.window.commands["reset_all"].trigger()
    assert {spec.path: bench.session.draft[spec.path] for spec in field_specs()} == {
        spec.path: spec.default for spec in field_specs()
    }


def test_a_search_shows_the_fields_and_nothing_else(bench: Bench) -> None:
    form = bench.window.form
    form.search.setText("cutter rad")
    shown = [path for path, row in form.rows.items() if row.isVisible()]
    assert shown == ["lengthwise.cutter_radius"]
    form.search.setText("no such thing")
    assert form._nothing.isVisible()
    form.search.clear()
    assert form.rows[TEETH].isVisible() and not form._nothing.isVisible()


def test_folded_groups_are_remembered(bench: Bench, settings: QSettings) -> None:
    section = bench.window.form._sections["Tooth"]
    section._title.click()
    assert not section.is_open and "Tooth" in settings.value("form/folded")


def test_inches_are_shown_everywhere_and_the_design_stays(bench: Bench) -> None:
    before = dict(bench.session.draft)
    form = bench.window.form
    bench.habits.preferences.set(length="in")  # type: ignore[attr-defined]
    assert form.rows[MODULE].field.text() == "0.15748031" and form.rows[MODULE]._unit.text() == "in"
    assert form.rows[MODULE].field.value() == 4.0 and bench.session.draft == before
    assert "\tin" in bench.window.derived.text_table() and "\tmm" not in bench.window.derived.text_table()
    bench.type_into(MODULE, "0.25")
    assert bench.session.design.pair.outer_module == 6.35
    bench.habits.preferences.set(length="mm")  # type: ignore[attr-defined]
    assert form.rows[MODULE].field.text() == "6.35"


def test_preferences_survive_and_nonsense_is_put_right(settings: QSettings) -> None:
    preferences = Preferences(settings)
    preferences.set(length="in", decimals=4, theme="dark", language="de", memory_limit_mb=2000, autosave_seconds=30)
    assert read(settings) == preferences.choices
    preferences.take(Choices())
    assert not settings.allKeys()
    for name in NAMES.values():
        settings.setValue(name, "nonsense")
    assert read(settings) == Choices()
    settings.setValue(NAMES["memory_limit_mb"], 5)
    assert read(settings).memory_limit_mb == 1000


def test_keys_are_changed_taken_over_and_reset(bench: Bench, settings: QSettings) -> None:
    keys: Keys = bench.habits.keys  # type: ignore[attr-defined]
    entries = {entry.id: entry for entry in keys.entries()}
    assert len(entries) > 40 and len({e.action for e in entries.values()}) == len(entries)
    save, save_as = entries["save"], entries["save_as"]
    wanted = QKeySequence("Ctrl+S")
    assert [rival.id for rival in keys.rivals(save_as, wanted)] == ["save"]
    keys.assign(save_as, wanted)
    assert save.action.shortcut().isEmpty() and save_as.action.shortcut() == wanted
    assert "Ctrl+S" in save_as.action.toolTip() and "Ctrl+S" not in save.action.toolTip()
    save_as.action.setShortcut(QKeySequence("Ctrl+Shift+S"))
    save.action.setShortcut(wanted)
    again = Keys(bench.window, settings)
    assert save_as.action.shortcut() == wanted and save.action.shortcut().isEmpty()
    again.reset_all()
    keys.reset_all()
    assert not [key for key in settings.allKeys() if key.startswith("keys/")]


def test_no_two_commands_have_the_same_keys(bench: Bench) -> None:
    keys: Keys = bench.habits.keys  # type: ignore[attr-defined]
    for entry in keys.entries():
        assert not keys.rivals(entry, entry.action.shortcut()), entry.id


def test_the_palette_finds_by_letters_and_puts_the_last_first(bench: Bench, settings: QSettings) -> None:
    palette = Palette(bench.habits.offers(), settings, bench.window)  # type: ignore[attr-defined]
    palette.line.setText("comp pal")
    assert not palette.titles or palette.titles[0] != "Quit"
    palette.line.setText("cutter r")
    assert palette.titles[0] == "Cutter radius"
    QTest.keyClick(palette.line, Qt.Key.Key_Return)
    assert settings.value("palette/recent") in ("field.lengthwise.cutter_radius", ["field.lengthwise.cutter_radius"])
    again = Palette(bench.habits.offers(), settings, bench.window)  # type: ignore[attr-defined]
    assert again.titles[0] == "Cutter radius"
    off = next(row for row in range(again.list.count()) if again.list.item(row).text() == "Cancel")
    assert not again.list.item(off).flags() & Qt.ItemFlag.ItemIsEnabled


def test_letters_at_the_start_of_words_fit_best() -> None:
    assert fit("xyz", "Save") is None and fit("", "Save") == (0, ())
    assert fit("bp", "Build pair")[0] > fit("bp", "About a map")[0]  # type: ignore[index]
    assert fit("sav", "Save as")[1] == (0, 1, 2)  # type: ignore[index]


def test_cells_go_to_a_spreadsheet(bench: Bench) -> None:
    view = bench.window.derived.view
    view.setFocus()
    view.setRangeSelected(_range(view, 2, 1, 3, 2), True)
    assert [len(line.split("\t")) for line in copy_text(view).split("\n")] == [2, 2]
    assert "−" not in table_text(view)
    bench.habits.copy(whole=True) if QApplication.focusWidget() is view else None  # type: ignore[attr-defined]
    table = bench.window.table.view
    table.selectRow(1)
    assert copy_text(table).split("\t")[:2] == ["Rotating line", "Optimised"]
    bench.window.commands["copy_table"].trigger()
    assert isinstance(QGuiApplication.clipboard().text(), str)


def test_every_field_tells_what_its_next_value_changes(bench: Bench) -> None:
    for spec in field_specs():
        lines = effect_lines(bench.session.design, spec)
        assert all(isinstance(line, str) and line for line in lines)
    teeth = next(spec for spec in field_specs() if spec.path == TEETH)
    lines = effect_lines(bench.session.design, teeth)
    assert lines[0] == "With 41:" and any("Pitch angle" in line for line in lines)


def _range(view: object, top: int, left: int, bottom: int, right: int) -> object:
    from PySide6.QtWidgets import QTableWidgetSelectionRange

    return QTableWidgetSelectionRange(top, left, bottom, right)
