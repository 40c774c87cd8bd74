"""Two windows with one design, backups, and two designs side by side."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtWidgets import QMessageBox

from gearstudio.design import with_field
from gearstudio.presets import PRESETS
from gearstudio.project import load_design, save_design
from tests.ui.stand_ins import Bench
from ui.projects.backups import Backups
from ui.projects.compare_dialog import CompareDialog
from ui.projects.desk import Desk
from ui.projects.differences import as_text, differences
from ui.projects.lock import ProjectLock

ROOT = Path(__file__).resolve().parents[2]
pytestmark = pytest.mark.ui
TEETH = "pair.wheel_teeth"


@pytest.fixture
def desk(bench: Bench, tmp_path) -> Desk:
    data = tmp_path / "data"
    return Desk(bench.session, bench.window, bench.files, bench.controller.edits, data, bench.files)


@pytest.fixture
def design(tmp_path) -> Path:
    path = tmp_path / "axle.gear.toml"
    save_design(path, PRESETS[4].design)
    return path


def test_opening_and_saving_fill_the_menu(bench: Bench, desk: Desk, design: Path, tmp_path) -> None:
    bench.files.open_path(design)
    bench.session.path = tmp_path / "other.gear.toml"
    bench.files.save()
    assert desk.recent.paths == (tmp_path / "other.gear.toml", design)
    bench.window.commands.recent.actions()[1].trigger()
    assert bench.session.path == design


# --- one design, two windows


def test_the_second_to_lock_hears_of_the_first(design: Path) -> None:
    first, second = ProjectLock(), ProjectLock()
    assert first.take(design) is None and first.take(design) is None
    holder = second.take(design)
    assert holder is not None and holder.process_id == os.getpid() and str(os.getpid()) in str(holder)
    first.release()
    assert second.take(design) is None
    second.release()
    assert [path.name for path in design.parent.iterdir()] == [design.name]


HOLD = "import sys; from pathlib import Path; from ui.projects.lock import ProjectLock; lock = ProjectLock();"
HOLD += "print(lock.take(Path(sys.argv[1])), flush=True); sys.stdin.read()"


def test_a_lock_dies_with_its_process(design: Path) -> None:
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}
    other = subprocess.Popen([sys.executable, "-c", HOLD, str(design)], cwd=ROOT, **pipes)
    assert other.stdout is not None and other.stdout.readline().strip() == "None"
    holder = ProjectLock().take(design)
    assert holder is not None and holder.process_id == other.pid
    other.send_signal(signal.SIGKILL)
    other.wait(10)
    lock = ProjectLock()
    assert lock.take(design) is None
    lock.release()


@pytest.mark.parametrize("answer", ["read-only", "copy", ""])
def test_a_design_in_use_is_opened_read_only_as_a_copy_or_not(
    bench: Bench, design: Path, monkeypatch, tmp_path, answer: str
) -> None:
    other = ProjectLock()
    other.take(design)
    clicked: list[object] = []

    def reply(box: QMessageBox) -> int:
        assert str(os.getpid()) in box.text() and design.name in box.text()
        clicked[:] = [button for button in box.buttons() if answer and answer in button.text().replace("&", "")]
        return 0

    monkeypatch.setattr(QMessageBox, "exec", reply)
    monkeypatch.setattr(QMessageBox, "clickedButton", lambda _box: clicked[0] if clicked else None)
    session, content = bench.session, design.read_bytes()
    bench.files.open_path(design)
    assert (session.design == PRESETS[4].design) == bool(answer)
    if answer == "read-only":
        assert "read-only" in bench.window.windowTitle() and not session.unsaved
        elsewhere = tmp_path / "mine.gear.toml"
        monkeypatch.setattr("ui.files.QFileDialog.getSaveFileName", lambda *_: (str(design), ""))
        bench.controller.edits.change(TEETH, 43)
        assert not bench.files.save() and "not saved" in bench.window.messages.text
        monkeypatch.setattr("ui.files.QFileDialog.getSaveFileName", lambda *_: (str(elsewhere), ""))
        assert bench.files.save() and not session.read_only and load_design(elsewhere).pair.wheel_teeth == 43
    elif answer == "copy":
        assert session.path is None and session.unsaved
    assert design.read_bytes() == content
    other.release()


def test_opening_another_design_gives_the_first_one_back(bench: Bench, design: Path, tmp_path) -> None:
    other = tmp_path / "other.gear.toml"
    save_design(other, PRESETS[1].design)
    bench.files.open_path(design)
    assert ProjectLock().take(design) is not None
    bench.files.open_path(other)
    assert ProjectLock().take(design) is None and ProjectLock().take(other) is not None
    bench.files.new()
    assert ProjectLock().take(other) is None


def test_a_failed_save_elsewhere_keeps_the_lock(bench: Bench, design: Path, tmp_path, monkeypatch) -> None:
    bench.files.open_path(design)
    monkeypatch.setattr("ui.files.QFileDialog.getSaveFileName", lambda *_: (str(tmp_path / "no" / "b.gear.toml"), ""))
    assert not bench.files.save_as() and bench.session.path == design
    assert ProjectLock().take(design) is not None


# --- backups


def test_backups_rotate_and_hold_what_was_saved(tmp_path, design: Path) -> None:
    backups = Backups(tmp_path / "kept", 3)
    for teeth in (38, 39, 40, 40, 41, 43):
        save_design(design, with_field(PRESETS[4].design, TEETH, teeth))
        backups.keep(design)
    copies = backups.of(design)
    assert [load_design(copy.file).pair.wheel_teeth for copy in copies] == [43, 41, 40]
    assert [copy.when for copy in copies] == sorted((copy.when for copy in copies), reverse=True)
    other = tmp_path / "other" / design.name
    assert backups.of(other) == [] and backups.designs() == [design.resolve()]


def test_going_back_is_an_edit_that_undo_takes_back(bench: Bench, desk: Desk, design: Path) -> None:
    bench.files.open_path(design)
    for teeth in (38, 39, 43):
        bench.controller.edits.change(TEETH, teeth)
        assert bench.files.save()
    dialog = desk.show_backups()
    assert dialog.list.topLevelItemCount() == 3
    assert dialog.list.topLevelItem(0).text(2) == "nothing" and "Wheel teeth" in dialog.list.topLevelItem(2).text(2)
    dialog.list.setCurrentItem(dialog.list.topLevelItem(2))
    dialog.restore.click()
    assert bench.session.draft[TEETH] == 38 and bench.session.unsaved and bench.session.path == design
    assert load_design(design).pair.wheel_teeth == 43
    bench.controller.edits.undo()
    assert bench.session.draft[TEETH] == 43 and not bench.session.unsaved


def test_a_design_that_is_gone_comes_back_from_its_backups(bench: Bench, desk: Desk, design: Path) -> None:
    bench.files.open_path(design)
    assert bench.files.save()
    bench.files.new()
    design.unlink()
    dialog = desk.show_backups()
    assert "missing" in dialog.designs.currentText()
    dialog.restore.click()
    assert bench.session.design == PRESETS[4].design and bench.session.path == design and bench.session.unsaved
    assert bench.files.save() and load_design(design) == PRESETS[4].design


def test_a_damaged_backup_is_shown_as_such_and_cannot_be_taken(bench: Bench, desk: Desk, design: Path) -> None:
    bench.files.open_path(design)
    bench.files.save()
    desk.backups.of(design)[0].file.write_text("format = = 1")
    dialog = desk.show_backups()
    assert dialog.list.topLevelItem(0).text(1) != "valid" and not dialog.restore.isEnabled()
    dialog.reject()


def test_without_backups_that_is_said(bench: Bench, desk: Desk) -> None:
    assert desk.show_backups() is None and "no backups" in bench.window.messages.text
    desk.recover()
    assert "no unsaved work" in bench.window.messages.text


# --- two designs side by side


def test_differences_are_the_second_less_the_first() -> None:
    first = PRESETS[0].design
    lines = differences(first, with_field(first, "pair.outer_module", 8.0))
    by_name = {(line.group.partition(":")[0], line.name): line for line in lines}
    assert by_name["Parameters", "Outer module"].difference == "+4"
    assert not by_name["Parameters", "Wheel teeth"].differs
    distance = by_name["Pair", "Outer cone distance"]
    assert float(distance.second) == pytest.approx(2 * float(distance.first), abs=2e-4)
    assert not any(line.differs for line in differences(first, first))
    assert as_text(lines).count("\n") == len(lines) + 1


def test_the_comparison_follows_the_design_and_survives_a_bad_file(bench: Bench, design: Path, tmp_path, qtbot) -> None:
    dialog = CompareDialog(bench.session, (design,), str(tmp_path), bench.window)
    dialog.show()
    dialog.compare_with(design)
    qtbot.waitUntil(lambda: dialog.table.rowCount() > 0, timeout=10_000)
    count = sum(line.differs for line in dialog.lines)
    assert dialog.table.rowCount() == count
    dialog.only.setChecked(False)
    assert dialog.table.rowCount() == len(dialog.lines) > count
    bench.session.load(PRESETS[4].design)
    qtbot.waitUntil(lambda: not any(line.differs for line in dialog.lines), timeout=10_000)
    design.write_text("format = 99")
    dialog.compare_with(design)
    qtbot.waitUntil(lambda: "cannot be compared" in dialog.words.text(), timeout=10_000)
    dialog.close()
    bench.session.load(PRESETS[0].design)
