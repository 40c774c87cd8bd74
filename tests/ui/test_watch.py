"""A design file that another program changes while it is open."""

from __future__ import annotations

from pathlib import Path

import pytest

from gearstudio.design import Design, with_field
from gearstudio.project import save_design
from tests.ui.places import Place

pytestmark = pytest.mark.ui
TEETH = "pair.wheel_teeth"


@pytest.fixture
def path(place: Place, tmp_path: Path) -> Path:
    made = tmp_path / "axle.gear.toml"
    save_design(made, Design())
    place.bench.files.open_path(made)
    return made


def answer(place: Place, role: str) -> None:
    box = place.desk.watch.question
    next(button for button in box.buttons() if button.text().replace("&", "").startswith(role)).click()


def test_the_file_of_another_program_is_taken_as_one_step(place: Place, path: Path, qtbot) -> None:
    save_design(path, with_field(Design(), TEETH, 51))
    qtbot.waitUntil(lambda: place.desk.watch.question is not None, timeout=5000)
    answer(place, "Take")
    session = place.bench.session
    assert session.draft[TEETH] == 51 and not session.unsaved
    place.bench.controller.edits.undo()
    assert session.draft[TEETH] == 40 and session.unsaved


def test_the_own_version_is_kept_and_asked_about_once(place: Place, path: Path, qtbot) -> None:
    path.write_text("nonsense", encoding="utf-8")
    qtbot.waitUntil(lambda: place.desk.watch.question is not None, timeout=5000)
    answer(place, "Keep")
    place.desk.watch.look()
    assert place.desk.watch.question is None and place.bench.session.draft[TEETH] == 40


def test_a_damaged_file_is_refused_and_a_lost_one_told(place: Place, path: Path, qtbot) -> None:
    messages = place.bench.window.messages
    path.write_text("nonsense", encoding="utf-8")
    qtbot.waitUntil(lambda: place.desk.watch.question is not None, timeout=5000)
    answer(place, "Take")
    assert "was not opened" in messages.text and place.bench.session.draft[TEETH] == 40
    path.unlink()
    place.desk.watch.look()
    assert "no longer on the disk" in messages.text


def test_its_own_saving_is_no_change(place: Place, path: Path, qtbot) -> None:
    place.edit(TEETH, 43)
    assert place.bench.files.save()
    qtbot.wait(700)
    assert place.desk.watch.question is None
