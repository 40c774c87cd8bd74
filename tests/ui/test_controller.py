"""A whole window without 3D views: what the user does, and what is shown of it."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest

from gearstudio.checks import FileCheck
from gearstudio.jobs import ExportedFile, ExportJob
from tests.ui.stand_ins import Bench
from ui.session import Key

pytestmark = pytest.mark.ui
TEETH = "pair.pinion_teeth"


def cells(bench: Bench, column: int) -> list[str]:
    model = bench.window.table.model
    return [model.data(model.index(row, column)) for row in range(model.rowCount())]


def derived(bench: Bench) -> str:
    return bench.window.derived.text_table()


def test_it_starts_by_asking_for_the_wheel(bench: Bench) -> None:
    assert bench.runner.calls == ["start"]
    assert {job.member for job in bench.runner.jobs} == {"wheel"} and len(bench.runner.jobs) == 6
    assert cells(bench, 2) == ["–"] * 6


def test_the_table_fills_and_goes_grey_when_the_design_changes(bench: Bench, qtbot) -> None:
    bench.runner.finish_all(0.0123)
    assert cells(bench, 2) == ["12.3 nm"] * 6
    assert cells(bench, 9)[0] == "grid 12 × 14, spacing uniform"
    bench.type_into(TEETH, "18")
    assert cells(bench, 2) == ["12.3 nm"] * 6 and set(cells(bench, 9)) == {"updating…"}
    qtbot.waitUntil(lambda: bench.runner.jobs[0].design == bench.session.design, timeout=2000)
    bench.runner.finish_all(0.5)
    assert cells(bench, 2) == ["0.500 µm"] * 6


def test_derived_values_are_live_and_stay_when_the_draft_is_bad(bench: Bench) -> None:
    assert "86.925" in derived(bench)
    bench.type_into("pair.outer_module", "5")
    assert "108.65" in derived(bench)
    bench.type_into("pair.outer_module", "abc")
    assert "108.65" in derived(bench)


def test_clicking_a_row_selects_its_method_and_variant(bench: Bench) -> None:
    table = bench.window.table
    place = table.view.visualRect(table.model.index(4, 3)).center()
    QTest.mouseClick(table.view.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert (bench.session.method, bench.session.variant) == ("point_cloud", "published")
    assert bench.window.method_bar.methods.button("point_cloud").isChecked()
    assert bench.window.method_bar.variants.button("published").isChecked()


def test_the_bars_and_menus_agree(bench: Bench) -> None:
    bench.window.method_bar.members.button("pinion").click()
    assert bench.session.member == "pinion"
    assert {job.member for job in bench.runner.jobs} == {"pinion"}
    next(a for a in bench.window.commands.methods.actions() if a.data() == "profile_sweep").trigger()
    assert bench.window.method_bar.methods.button("profile_sweep").isChecked()


def test_undo_and_redo_of_edits(bench: Bench) -> None:
    commands = bench.window.commands
    assert not commands["undo"].isEnabled()
    bench.type_into(TEETH, "2")
    bench.type_into(TEETH, "21")
    bench.type_into("pair.outer_module", "abc")
    commands["undo"].trigger()
    assert bench.window.form.rows["pair.outer_module"].field.text() == "4" and bench.session.issues == ()
    commands["undo"].trigger()
    assert bench.session.design.pair.pinion_teeth == 17 and not bench.session.unsaved
    commands["redo"].trigger()
    assert bench.window.form.rows[TEETH].field.text() == "21" and commands["redo"].isEnabled()


def test_the_title_names_the_design_and_marks_unsaved_changes(bench: Bench) -> None:
    assert bench.window.windowTitle() == "Default spiral bevel pair[*] – GearStudio"
    assert not bench.window.isWindowModified()
    bench.type_into("name", "Axle")
    assert bench.window.windowTitle().startswith("Axle") and bench.window.isWindowModified()


def test_a_failed_variant_says_why(bench: Bench) -> None:
    job = bench.runner.jobs[0]
    bench.runner.job_failed.emit(job, "profile_sweep: guide failed: it crosses itself", "Traceback …")
    assert "it crosses itself" in bench.window.messages.text
    assert "it crosses itself" in cells(bench, 9)[1]
    bench.window.messages._more.click()
    assert bench.window.messages._details.isVisible()
    bench.window.messages._copy.click()
    assert "Traceback" in QGuiApplication.clipboard().text()
    bench.type_into(TEETH, "18")
    bench.runner.finish_all()
    assert bench.window.messages.text == ""


def test_progress_and_cancel(bench: Bench) -> None:
    status, cancel = bench.window.status, bench.window.commands["cancel"]
    assert not cancel.isEnabled() and not status._work.isVisible()
    bench.runner.job_started.emit(bench.runner.jobs[0])
    bench.runner.job_progressed.emit(bench.runner.jobs[0], "skin", 0.5)
    assert cancel.isEnabled() and status._work.isVisible() and status._bar.value() == round(1000 * 0.5 / 6)
    status._cancel.click()
    assert bench.runner.calls[-1] == "cancel"
    for job in bench.runner.jobs:
        bench.runner.job_cancelled.emit(job)
    bench.runner.queue_changed.emit(0)
    assert not status._work.isVisible() and "Cancelled" in cells(bench, 9)[0]
    bench.window.commands["rebuild"].trigger()
    assert len(bench.runner.requests) == 2


def test_the_state_of_the_cad_process_is_shown(bench: Bench) -> None:
    status, runner = bench.window.status, bench.runner
    for state in ("starting", "ready", "busy"):
        runner.worker_state_changed.emit(state, "")
        assert status._worker.text().startswith("CAD kernel")
    runner.worker_state_changed.emit("replaced", "it was killed (SIGKILL)")
    assert "is being started again" in bench.window.messages.text
    runner.worker_state_changed.emit("stopped", "three times")
    assert "could not be started" in bench.window.messages.text
    bench.window.commands["restart"].trigger()
    assert runner.calls[-1] == "restart"
    runner.worker_state_changed.emit("ready", "")
    assert bench.window.messages.text == ""


def test_exports_report_what_was_written(bench: Bench, tmp_path: Path) -> None:
    job = ExportJob(bench.session.design, "wheel", "flanks", "point_cloud", "optimised", ("step",), tmp_path)
    check = FileCheck("step", True, False, 0, 2, 0.0, 0.0, 0.0, wanted_solids=0)
    bench.files.export_requested.emit(job)
    assert bench.runner.jobs == (job,)
    bench.runner.job_done.emit(job, (ExportedFile(tmp_path / "wheel-flanks.step", "step", 123_400, check),))
    assert "wheel-flanks.step (123 kB)" in bench.window.messages.text
    bench.runner.job_failed.emit(job, "the disk is full", "")
    assert "the disk is full" in bench.window.messages.text


def test_ten_edits_a_second_end_with_the_last(bench: Bench, qtbot) -> None:
    for number in range(30):
        bench.type_into("lengthwise.spiral_angle_deg", str(20 + number % 15))
        qtbot.wait(100)
    qtbot.waitUntil(lambda: bench.runner.jobs[0].design == bench.session.design, timeout=3000)
    assert bench.session.design.lengthwise.spiral_angle_deg == 34
    assert len(bench.runner.requests) <= 4


def test_the_comparison_can_be_copied(bench: Bench) -> None:
    bench.runner.finish_all(2.0)
    lines = bench.window.table.text_table().splitlines()
    assert len(lines) == 7 and lines[1].split("\t")[:3] == ["Rotating line", "Published", "2.00 µm"]


def test_both_themes_can_be_drawn(bench: Bench, theme) -> None:
    bench.runner.job_failed.emit(bench.runner.jobs[0], "no", "details")
    for scheme in (Qt.ColorScheme.Dark, Qt.ColorScheme.Light, Qt.ColorScheme.Unknown):
        theme.choose(scheme)
        bench.controller.refresh_theme(scheme == Qt.ColorScheme.Dark)
        ground = bench.window.grab().toImage().pixelColor(3, bench.window.height() // 2)
        assert (ground.lightness() < 100) == (scheme == Qt.ColorScheme.Dark)


def test_layout_can_be_reset(bench: Bench) -> None:
    docks = list(bench.window._docks)
    docks[0].hide()
    docks[1].setFloating(True)
    bench.window.commands["reset_layout"].trigger()
    assert docks[0].isVisible() and not docks[1].isFloating()


def test_closing_ends_the_runner_once(bench: Bench) -> None:
    bench.window.close()
    bench.window.close()
    assert bench.runner.calls.count("close") == 1


def test_shown_keys_are_bold_in_the_table(bench: Bench) -> None:
    model = bench.window.table.model
    fonts = [model.data(model.index(row, 0), Qt.ItemDataRole.FontRole) for row in range(6)]
    assert [font is not None for font in fonts] == [False, True] * 3
    assert bench.session.visible_keys[0] == Key("wheel", "rotating_line", "optimised")
