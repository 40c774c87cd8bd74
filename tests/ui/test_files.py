"""Opening, saving and leaving: nothing a user made is lost, and damage is told in words."""

from __future__ import annotations

import errno
from pathlib import Path

import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QApplication, QFileDialog, QMessageBox

from gearstudio.presets import PRESETS
from gearstudio.project import load_design, save_design
from tests.ui.stand_ins import Bench
from ui.export_dialog import ExportDialog
from ui.files import _file_name

pytestmark = pytest.mark.ui
TEETH = "pair.pinion_teeth"
Answer = QMessageBox.StandardButton


@pytest.fixture
def answer(monkeypatch: pytest.MonkeyPatch):
    """Answer the question about unsaved changes; counts how often it came."""

    class Asked(list[QMessageBox]):
        reply = Answer.Cancel

    asked = Asked()

    def reply(box: QMessageBox) -> int:
        asked.append(box)
        return asked.reply

    monkeypatch.setattr(QMessageBox, "exec", reply)
    return asked


def choose_file(monkeypatch: pytest.MonkeyPatch, path: Path | str) -> None:
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(path), ""))


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("not-toml", b"format = = 1"),
        ("unknown-key", b"format = 1\n[pair]\npinion_teth = 17\n"),
        ("wrong-type", b'format = 1\n[pair]\npinion_teeth = "many"\n'),
        ("other-format", b"format = 99\n"),
        ("not-utf8", b"format = 1\nname = '\xff\xfe'\n"),
        ("empty", b""),
        ("impossible", b"format = 1\n[pair]\npinion_teeth = 3\nouter_module = -1\n"),
        ("commas", b"format = 1\n[pair]\nouter_module = 3,5\nshaft_angle_deg = 90,0\n"),
        ("picture", b"\x89PNG\r\n\x1a\n\x00\x00"),
        ("no-value", b'format = 1\n[pair]\nouter_module = ""\n'),
    ],
)
def test_a_damaged_file_is_refused_in_words_and_changes_nothing(bench: Bench, tmp_path, name, content) -> None:
    path = tmp_path / f"{name}.gear.toml"
    path.write_bytes(content)
    before = dict(bench.session.draft)
    bench.files.open_path(path)
    text = bench.window.messages.text
    assert text.count(path.name) == 1 and "Traceback" not in text and "Error" not in text
    assert str(path.parent) not in text and "TOML" not in text
    assert str(path) in bench.window.messages.keep_state()[2]
    assert bench.session.draft == before and bench.session.path is None


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (
            b"format = 1\n[pair]\nouter_module = 3,5\nshaft_angle_deg = 90,0\n",
            "2 problems, the first at line 3, “",
        ),
        (b"format = 99\n", "update GearStudio"),
        (b'format = 1\n[pair]\nouter_module = ""\n', "pair.outer_module: the value is empty"),
        (b"", "the file is empty"),
    ],
)
def test_a_damaged_file_is_refused_with_what_to_do(bench: Bench, tmp_path, content: bytes, said: str) -> None:
    path = tmp_path / "a.gear.toml"
    path.write_bytes(content)
    bench.files.open_path(path)
    assert bench.window.messages.text.startswith("a.gear.toml was not opened: ") and said in bench.window.messages.text
    assert path.read_bytes() == content


def test_a_folder_and_a_missing_file_are_refused(bench: Bench, tmp_path) -> None:
    for path, said in ((tmp_path, "this is a folder"), (tmp_path / "none.gear.toml", "there is no such file")):
        bench.files.open_path(path)
        assert f"{path.name} was not opened: {said}" in bench.window.messages.text
        assert str(path.parent) not in bench.window.messages.text


def test_a_file_without_permission_is_refused(bench: Bench, tmp_path, monkeypatch) -> None:
    def refuse(path: Path) -> bytes:
        raise PermissionError(errno.EACCES, "Permission denied", str(path))

    monkeypatch.setattr(Path, "read_bytes", refuse)
    bench.files.open_path(tmp_path / "a.gear.toml")
    assert bench.window.messages.text == "a.gear.toml was not opened: no permission; ask who owns it to let you read it"


def test_a_design_goes_to_a_file_and_comes_back(bench: Bench, tmp_path, monkeypatch) -> None:
    choose_file(monkeypatch, tmp_path / "axle")
    bench.type_into(TEETH, "19")
    bench.window.commands["save"].trigger()
    path = tmp_path / "axle.gear.toml"
    assert load_design(path).pair.pinion_teeth == 19
    assert not bench.session.unsaved and bench.window.windowTitle().startswith("axle.gear.toml")
    bench.type_into(TEETH, "23")
    bench.window.commands["save"].trigger()
    assert load_design(path).pair.pinion_teeth == 23


def test_saving_with_problems_says_what_is_missing_and_stays_unsaved(bench: Bench, tmp_path, monkeypatch) -> None:
    choose_file(monkeypatch, tmp_path / "a.gear.toml")
    bench.type_into(TEETH, "abc")
    assert not bench.files.save()
    assert load_design(tmp_path / "a.gear.toml").pair.pinion_teeth == 17
    assert bench.session.unsaved and "1 field(s) with problems" in bench.window.messages.text


def test_a_place_that_cannot_be_written_is_told(bench: Bench, tmp_path, monkeypatch) -> None:
    choose_file(monkeypatch, tmp_path / "none" / "a.gear.toml")
    (tmp_path / "none").write_text("a file")
    assert not bench.files.save_as()
    assert bench.window.messages.text == (
        "a.gear.toml was not saved: a part of the path is a file, not a folder; choose another folder"
    )


@pytest.mark.parametrize("way", ["close", "new", "preset", "open", "drop"])
@pytest.mark.parametrize("reply", [Answer.Cancel, Answer.Discard, Answer.Save])
def test_unsaved_changes_are_asked_about(bench: Bench, answer, tmp_path, monkeypatch, way: str, reply: Answer) -> None:
    other = tmp_path / "other.gear.toml"
    save_design(other, PRESETS[2].design)
    saved = tmp_path / "saved.gear.toml"
    choose_file(monkeypatch, saved)
    bench.type_into(TEETH, "19")
    answer.reply = reply
    if way == "close":
        assert bench.window.close() == (reply != Answer.Cancel)
    elif way == "new":
        bench.files.new()
    elif way == "preset":
        bench.files.open_preset(PRESETS[2])
    elif way == "open":
        bench.files.open_path(other)
    else:
        bench.window.design_dropped.emit(other)
    assert len(answer) == 1
    assert saved.exists() == (reply == Answer.Save)
    assert (bench.session.draft[TEETH] == 19) == (way == "close" or reply == Answer.Cancel)


def test_nothing_is_asked_when_nothing_is_unsaved(bench: Bench, answer) -> None:
    bench.files.open_preset(PRESETS[4])
    bench.files.new()
    bench.window.close()
    assert not answer


def test_a_design_is_dropped_on_the_window(bench: Bench, tmp_path, qtbot) -> None:
    path = tmp_path / "a.gear.toml"
    save_design(path, PRESETS[3].design)
    drop(bench, tmp_path / "picture.png")
    drop(bench, path)
    qtbot.waitUntil(lambda: bench.session.path == path, timeout=2000)
    assert bench.session.design == PRESETS[3].design


def drop(bench: Bench, path: Path) -> None:
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path))])
    keys = (Qt.DropAction.CopyAction, data, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier)
    enter = QDragEnterEvent(QPoint(5, 5), *keys)
    QApplication.sendEvent(bench.window, enter)
    if enter.isAccepted() and path.suffix == ".toml":
        QApplication.sendEvent(bench.window, QDropEvent(QPointF(5, 5), *keys))


def test_presets_open_by_name(bench: Bench) -> None:
    bench.files.open_named("preset:automotive")
    assert bench.session.design.pair.wheel_teeth == 41
    bench.files.open_named("preset:automotiv")
    assert "automotive" in bench.window.messages.text


def test_the_export_dialog_starts_with_what_is_shown(bench: Bench, tmp_path) -> None:
    bench.session.select(method="profile_sweep", variant="published", member="pinion")
    dialog = ExportDialog(bench.session, str(tmp_path), bench.window)
    job = dialog.job()
    assert (job.member, job.method, job.variant, job.directory) == ("pinion", "profile_sweep", "published", tmp_path)
    assert job.design == bench.session.design and tuple(job.formats) == ("step",)


def test_file_names_are_plain() -> None:
    assert _file_name("Axle 9/41 – new!") == "axle-9-41-new"
    assert _file_name("…") == "design"
