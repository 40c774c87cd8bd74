"""Nothing typed is lost: autosave, what is left of it, and what the next window offers."""

from __future__ import annotations

from datetime import datetime

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QMessageBox

from gearstudio.design import Design
from gearstudio.errors import FileError
from gearstudio.presets import PRESETS
from gearstudio.project import load_design, save_design
from tests.ui.places import Place, left_behind
from tests.ui.stand_ins import Bench
from ui.projects import autosave
from ui.projects.autosave import Autosave, abandoned
from ui.projects.snapshot import Snapshot, read_snapshot, write_snapshot
from ui.projects.versions import Change, changed_fields, recovered_version, saved_version
from ui.session import flatten

pytestmark = pytest.mark.ui
TEETH = "pair.wheel_teeth"
ANGLE = "lengthwise.spiral_angle_deg"


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(autosave, "PAUSE_MS", 30)


def test_a_draft_comes_back_as_it_was_typed(tmp_path) -> None:
    draft = {**flatten(Design()), TEETH: "fifty", "pair.face_width": None, "name": "Zahnrad – ½ “a”"}
    written = Snapshot("Titel", tmp_path / "ä.gear.toml", datetime.now().astimezone(), draft)
    write_snapshot(tmp_path / "a.json", written)
    assert read_snapshot(tmp_path / "a.json") == written


@pytest.mark.parametrize(
    "content",
    [b"", b"{", b"[]", b"null", b'{"format": 2}', b'{"format": 1}', b"\xff\xfe\x00", b'{"format": 1, "title":'],
)
def test_a_damaged_snapshot_is_put_aside_and_disturbs_nobody(tmp_path, content: bytes) -> None:
    bad = tmp_path / "bad.json"
    bad.write_bytes(content)
    with pytest.raises(FileError):
        read_snapshot(bad)
    good = left_behind(tmp_path, None).replace(tmp_path / "good.json")
    assert [one.file for one in abandoned(tmp_path)] == [good]
    assert not bad.exists() and bad.with_suffix(".damaged").read_bytes() == content


def test_an_unsaved_draft_is_kept_and_goes_when_it_is_saved(quick, place: Place, qtbot, tmp_path, monkeypatch) -> None:
    assert not place.snapshots()
    place.edit(TEETH, 43)
    qtbot.waitUntil(lambda: len(place.snapshots()) == 1, timeout=3000)
    assert read_snapshot(place.snapshots()[0]).draft[TEETH] == 43
    place.bench.session.path = tmp_path / "a.gear.toml"
    assert place.bench.files.save()
    qtbot.waitUntil(lambda: not place.snapshots(), timeout=3000)
    place.edit(TEETH, 44)
    qtbot.waitUntil(lambda: len(place.snapshots()) == 1, timeout=3000)
    place.bench.close()
    assert not place.snapshots() and not list((place.folder / "recovery").iterdir())


def test_unceasing_edits_are_written_all_the_same(quick, place: Place, qtbot) -> None:
    for number in range(60):
        place.edit(ANGLE, 20.0 + number / 10)
        qtbot.wait(5)
    assert place.snapshots(), "edits that never rest must not put autosave off"


def test_a_folder_that_cannot_be_written_is_told_once(quick, place: Place, qtbot) -> None:
    place.folder.mkdir()
    (place.folder / "recovery").write_text("in the way")
    said: list[str] = []
    place.desk.autosave.failed.connect(said.append)
    for number in range(5):
        place.edit(TEETH, 50 + number)
        qtbot.wait(60)
    assert len(said) == 1 and "recovery" in place.bench.window.messages.text


def test_a_window_that_runs_is_not_offered_to_others(quick, place: Place, qtbot) -> None:
    place.edit(TEETH, 43)
    qtbot.waitUntil(lambda: len(place.snapshots()) == 1, timeout=3000)
    assert abandoned(place.folder / "recovery") == []


def test_both_versions_are_offered_with_dates_and_validity(place: Place, tmp_path) -> None:
    path = tmp_path / "axle.gear.toml"
    save_design(path, Design())
    left_behind(place.folder, path, "good", **{TEETH: 47})
    left_behind(place.folder, path, "bad", **{TEETH: 1, "pair.outer_module": "wide"})
    left_behind(place.folder, None, "new", **{TEETH: 48})
    left_behind(place.folder, tmp_path / "gone.gear.toml", "gone", **{TEETH: 49})
    dialog = place.desk.offer_recovery()
    rows = {dialog.list.topLevelItem(row).text(0): dialog.list.topLevelItem(row) for row in range(4)}
    assert rows["good"].text(1).endswith("valid") and rows["good"].text(2).endswith("\nvalid")
    assert "2 problems" in rows["bad"].text(2)
    assert 'Outer module (Pair): "wide" is not a number' in rows["bad"].toolTip(2)
    assert "never saved" in rows["new"].text(1) and "gone" in rows["gone"].text(1)
    assert str(datetime.now().year) in rows["good"].text(2)
    assert abandoned(place.folder / "recovery") == [], "what is offered here is not offered elsewhere"
    dialog.reject()
    assert len(place.snapshots()) == 4
    assert len(abandoned(place.folder / "recovery")) == 4, "later means later"


def choose(dialog, title: str) -> None:
    item = next(dialog.list.topLevelItem(row) for row in range(4) if dialog.list.topLevelItem(row).text(0) == title)
    dialog.list.setCurrentItem(item)


def shown_changes(dialog) -> list[Change]:
    rows = [dialog.changes.topLevelItem(row) for row in range(dialog.changes.topLevelItemCount())]
    return [Change(*(row.text(column) for column in range(3))) for row in rows]


def test_what_differs_is_shown_as_the_form_calls_it_with_units(place: Place, tmp_path) -> None:
    path = tmp_path / "axle.gear.toml"
    save_design(path, Design())
    values = {"pair.face_width": 30.5, ANGLE: 30.0, "lengthwise.curve": "logarithmic", "pair.outer_module": ""}
    left_behind(place.folder, path, "some", **values)
    left_behind(place.folder, path, "none")
    dialog = place.desk.offer_recovery()
    dialog.list.setCurrentItem(dialog.list.findItems("some", Qt.MatchFlag.MatchExactly)[0])
    assert {one.title: (one.before, one.after) for one in shown_changes(dialog)} == {
        "Outer module (Pair)": ("4 mm", "empty"),
        "Face width (Pair)": ("derived", "30.5 mm"),
        "Spiral angle (Lengthwise curve)": ("35°", "30°"),
        "Lengthwise curve": ("Circular arc (milled)", "Logarithmic spiral"),
    }
    dialog.list.setCurrentItem(dialog.list.findItems("none", Qt.MatchFlag.MatchExactly)[0])
    assert not dialog.changes.isVisible() and "the same" in dialog.details.text()


def test_the_recovered_version_is_opened_and_undo_gives_the_saved_one(place: Place, tmp_path, qtbot) -> None:
    path = tmp_path / "axle.gear.toml"
    save_design(path, PRESETS[4].design)
    draft = flatten(PRESETS[4].design)
    file = left_behind(place.folder, path, "axle", **{**draft, TEETH: 47, "pair.outer_module": "wide"})
    dialog = place.desk.offer_recovery()
    assert [str(one) for one in shown_changes(dialog)] == [
        "Wheel teeth (Pair): 41 → 47",
        "Outer module (Pair): 4.6 mm → “wide”",
    ]
    assert "pair." not in dialog.details.text()
    dialog.recover.click()
    session = place.bench.session
    assert (session.path, session.draft[TEETH], session.draft["pair.outer_module"]) == (path, 47, "wide")
    assert session.unsaved and not file.exists()
    assert [read_snapshot(one).draft[TEETH] for one in place.snapshots()] == [47], "it is kept again, under a new name"
    place.bench.controller.edits.undo()
    assert session.draft == draft and not session.unsaved


def test_the_saved_version_is_opened_and_the_recovered_one_stays(place: Place, tmp_path) -> None:
    path = tmp_path / "axle.gear.toml"
    save_design(path, PRESETS[4].design)
    file = left_behind(place.folder, path)
    place.desk.offer_recovery().saved.click()
    assert place.bench.session.design == PRESETS[4].design and file.exists()


def test_a_recovered_version_is_discarded_after_a_question(place: Place, monkeypatch) -> None:
    file = left_behind(place.folder, None)
    dialog = place.desk.offer_recovery()
    monkeypatch.setattr(QMessageBox, "exec", lambda _box: QMessageBox.StandardButton.Cancel)
    dialog.discard.click()
    assert file.exists() and dialog.isVisible()
    monkeypatch.setattr(QMessageBox, "exec", lambda _box: QMessageBox.StandardButton.Discard)
    dialog.discard.click()
    assert not file.exists() and not list(file.parent.iterdir())


def test_a_design_whose_folder_vanished_is_recovered(place: Place, tmp_path, monkeypatch) -> None:
    path = tmp_path / "none" / "axle.gear.toml"
    left_behind(place.folder, path, "axle", **{TEETH: 47})
    place.desk.offer_recovery().recover.click()
    assert place.bench.session.draft[TEETH] == 47 and place.bench.session.unsaved
    asked: list[str] = []
    monkeypatch.setattr(QMessageBox, "exec", lambda box: asked.append(box.text()) or QMessageBox.StandardButton.Cancel)
    assert not place.bench.files.save()
    assert len(asked) == 1 and str(path.parent) in asked[0]


@pytest.mark.parametrize("content", ["format = 99\n[pair]\nwheel_teeth = 41\n", "\x00 spoiled"])
def test_what_belongs_to_a_file_that_cannot_be_read_is_saved_elsewhere(
    place: Place, tmp_path, monkeypatch, content: str
) -> None:
    path, other = tmp_path / "axle.gear.toml", tmp_path / "other.gear.toml"
    path.write_text(content)
    left_behind(place.folder, path, "axle", **{TEETH: 47})
    place.desk.offer_recovery().recover.click()
    assert place.bench.session.draft[TEETH] == 47 and place.bench.session.unsaved
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(other), ""))
    assert place.bench.files.save()
    assert path.read_text() == content and load_design(other).pair.wheel_teeth == 47


def test_an_older_programs_draft_is_completed() -> None:
    snapshot = Snapshot("a", None, datetime.now().astimezone(), {TEETH: 41, "pair.no_such_field": 3})
    version = recovered_version(snapshot)
    assert version.valid and version.draft[TEETH] == 41 and "pair.no_such_field" not in version.draft


def test_versions_say_what_differs(tmp_path) -> None:
    save_design(tmp_path / "a.gear.toml", Design())
    saved = saved_version(tmp_path / "a.gear.toml")
    assert saved.valid and changed_fields(saved.draft, {**saved.draft, TEETH: 3}) == [TEETH]
    (tmp_path / "b.gear.toml").write_text("format = 99")
    assert not saved_version(tmp_path / "b.gear.toml").valid


def test_a_closed_autosave_leaves_nothing(quick, tmp_path, qtbot) -> None:
    bench = Bench()
    keeper = Autosave(bench.session, tmp_path)
    bench.session.edit(TEETH, 50)
    keeper.save_and_wait()
    assert keeper.file.exists()
    keeper.close()
    assert not list(tmp_path.iterdir())
    bench.close()
