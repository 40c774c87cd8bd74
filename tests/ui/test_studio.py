"""The whole program on a real screen with the real CAD process."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path
from time import monotonic

import pytest
from PySide6.QtCore import QPointF, Qt, QTimer
from PySide6.QtGui import QImage, QMouseEvent
from PySide6.QtWidgets import QApplication

from tests.ui.runner_watch import worker_process, workers
from tests.ui.screen import NEEDS_SCREEN
from tests.ui.stand_ins import result
from tests.ui.whole import PATIENCE_MS, TEETH, complete, edit
from ui.app import Studio
from ui.presenter import view_subtitle, view_title
from ui.screenshot import looks_blank, window_image
from ui.session import Failure, Key

ROOT = Path(__file__).resolve().parents[2]
pytestmark = NEEDS_SCREEN


@pytest.fixture
def studio(open_studio, qtbot) -> Studio:
    made = open_studio()
    qtbot.waitUntil(lambda: complete(made), timeout=PATIENCE_MS)
    return made


def test_it_opens_builds_and_draws_everything(studio: Studio, qtbot) -> None:
    session, grid = studio.session, studio.window.area.grid
    assert len(session.current) == 6 and not session.failures
    qtbot.wait(300)
    assert [panel.key for panel in grid.panels] == ["rotating_line", "profile_sweep", "point_cloud"]
    assert all("max" in panel.subtitle and "mean" in panel.subtitle for panel in grid.panels)
    assert not looks_blank(window_image(studio.window), grid, studio.window)
    session.select(method="point_cloud", variant="published")
    qtbot.wait(300)
    assert [panel.title for panel in grid.panels] == ["Point cloud · published"]
    session.select(member="pinion", method="all")
    qtbot.waitUntil(lambda: complete(studio), timeout=PATIENCE_MS)
    assert {key.member for key in session.current} == {"wheel", "pinion"}


def test_the_colour_scale_is_shared_and_follows_what_is_shown(studio: Studio, qtbot) -> None:
    bar, session = studio.window.area.color_bar, studio.session
    largest = max(session.results[key].statistics.max_um for key in session.visible_keys)
    qtbot.waitUntil(lambda: largest <= bar.limit <= 10 * largest, timeout=3000)
    session.select(variant="published")
    largest = max(session.results[key].statistics.max_um for key in session.visible_keys)
    qtbot.waitUntil(lambda: largest <= bar.limit <= 10 * largest, timeout=3000)
    bar.set_limit(123.0)
    session.select(variant="optimised")
    qtbot.wait(100)
    assert bar.limit == 123.0


def test_layers_are_switched_by_panel_menu_and_sets(studio: Studio) -> None:
    grid, panel, menu = studio.window.area.grid, studio.window.layer_panel, studio.window.commands.layers
    panel.box("base_cone").click()
    assert "base_cone" in grid.visible_layers
    action = next(action for action in menu.actions() if action.data() == "base_cone")
    assert action.isChecked()
    action.trigger()
    assert "base_cone" not in grid.visible_layers and not panel.box("base_cone").isChecked()
    panel.sets.button("Generation").click()
    assert "tangent_plane" in grid.visible_layers and "deviation" not in grid.visible_layers
    studio.window.area.roll_slider._slider.setValue(300)
    assert studio.controller.presenter._roll == pytest.approx(0.3)
    next(action for action in studio.window.commands.flanks.actions() if action.data() == "convex").trigger()
    assert studio.controller.presenter.flank == "convex"


def test_pointing_at_a_flank_reads_it_out(studio: Studio, qtbot) -> None:
    grid = studio.window.area.grid
    qtbot.wait(300)
    layer = next(x for x in grid.panels[1].layers if x.key == "deviation/concave")
    x, y = grid.viewport.look.project(layer.points[len(layer.points) // 2])
    place = QPointF(grid.viewport.place_of(1, float(x), float(y)))
    none = Qt.MouseButton.NoButton
    event = QMouseEvent(
        QMouseEvent.Type.MouseMove, place, grid.viewport.mapToGlobal(place), none, none, Qt.KeyboardModifier.NoModifier
    )
    QApplication.sendEvent(grid.viewport, event)
    qtbot.waitUntil(lambda: "deviation" in studio.window.status.point.text(), timeout=3000)
    text = studio.window.status.point.text()
    assert text.startswith("concave") and "ρ" in text and "δ" in text and "x " in text


def test_ten_edits_a_second_leave_the_window_alive_and_end_right(studio: Studio, qtbot) -> None:
    beats: list[float] = []
    pulse = QTimer(interval=20)
    pulse.timeout.connect(lambda: beats.append(monotonic()))
    pulse.start()
    for number in range(40):
        edit(studio, "lengthwise.spiral_angle_deg", 25.0 + number % 10 + number / 100)
        qtbot.wait(100)
    qtbot.waitUntil(lambda: complete(studio), timeout=PATIENCE_MS)
    pulse.stop()
    assert len(beats) > 20
    grid = studio.window.area.grid
    qtbot.waitUntil(lambda: all("updating" not in panel.subtitle for panel in grid.panels), timeout=5000)
    assert all(key in studio.session.current for key in studio.session.visible_keys)
    assert studio.session.design.lengthwise.spiral_angle_deg == pytest.approx(34.39)


def test_a_killed_cad_process_is_replaced_and_told(studio: Studio, qtbot) -> None:
    said: list[str] = []
    studio.controller.runner.worker_state_changed.connect(lambda state, _reason: said.append(state))
    worker_process().send_signal(signal.SIGKILL)
    qtbot.waitUntil(lambda: "replaced" in said, timeout=10_000)
    edit(studio, TEETH, 19)
    qtbot.waitUntil(lambda: complete(studio), timeout=PATIENCE_MS)
    assert studio.session.design.pair.pinion_teeth == 19


@pytest.mark.parametrize("moment", ["painted", "loading", "core", "worker", "views", "building"])
def test_the_window_may_close_at_any_moment(open_studio, qtbot, moment: str) -> None:
    studio = open_studio()
    if moment == "painted":
        qtbot.waitSignal(studio.window.first_painted, timeout=10_000).wait()
    elif moment == "building":
        changed, building = studio.session.results_changed, lambda _: studio.session.building is not None
        qtbot.waitSignal(changed, timeout=PATIENCE_MS, check_params_cb=building).wait()
    elif moment != "loading":
        qtbot.waitSignal(studio.loader.loaded, timeout=PATIENCE_MS, check_params_cb=lambda s: s == moment).wait()
    started = monotonic()
    assert studio.window.close()
    assert monotonic() - started < 5
    qtbot.wait(50)
    assert workers() == []


def test_a_design_given_at_the_start_is_opened(open_studio, qtbot) -> None:
    studio = open_studio(design="preset:fine")
    qtbot.waitUntil(lambda: studio.session.design.pair.outer_module == 0.5, timeout=10_000)
    assert studio.session.pair is not None
    other = open_studio(design="no-such-file.gear.toml")
    qtbot.waitUntil(lambda: bool(other.window.messages.text), timeout=10_000)
    assert "no-such-file" in other.window.messages.text


def test_an_unexpected_error_is_reported_once_and_the_window_goes_on(studio: Studio, qtbot) -> None:
    studio.report_crash("Traceback: boom")
    studio.report_crash("Traceback: boom again")
    assert len(studio._dialogs) == 1 and "boom" in studio._dialogs[0].report
    studio._dialogs[0].reject()
    assert not studio._dialogs
    edit(studio, TEETH, 20)
    qtbot.waitUntil(lambda: studio.session.design.pair.pinion_teeth == 20, timeout=PATIENCE_MS)


def test_titles_tell_how_a_result_stands(studio: Studio) -> None:
    session, key = studio.session, Key("wheel", "point_cloud", "published")
    session.put_result(session.design, result(key, 54.63))
    assert view_title(key) == "Point cloud · published"
    assert view_subtitle(session, key) == "max 54.6 µm · mean 13.7 µm"
    session.current.discard(key)
    assert view_subtitle(session, key) == "updating… (max was 54.6 µm)"
    session.put_failure(session.design, key, Failure("the sections cross", ""))
    assert view_subtitle(session, key) == "the sections cross"


def test_the_demonstration_leaves_a_picture(tmp_path: Path) -> None:
    own = {"XDG_CONFIG_HOME": str(tmp_path), "XDG_DATA_HOME": str(tmp_path), "PYTHONFAULTHANDLER": "1"}
    environment = os.environ | own
    command = [sys.executable, "main.py", "--demo", str(tmp_path)]
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, timeout=200, check=False)
    assert done.returncode == 0, done.stderr
    picture = QImage(str(tmp_path / "gearstudio.png"))
    assert picture.width() >= 1200 and picture.height() >= 700
