"""The solid mode without views: what is asked of the CAD process, when, and how it is told."""

from __future__ import annotations

import pytest

from gearstudio.design import Design
from gearstudio.jobs import ExportJob, GearJob
from tests.ui.made_up_solid import solid_of
from tests.ui.stand_ins import Bench
from ui.session import Key
from ui.solid_mode import SolidMode
from ui.solids import REST_MS
from ui.tables import table_text

pytestmark = pytest.mark.ui
TEETH = "pair.pinion_teeth"
PATIENCE_MS = 10_000


@pytest.fixture
def mode(bench: Bench) -> SolidMode:
    return bench.controller.solid_mode


def requested(bench: Bench) -> tuple[GearJob, ...]:
    """The newest request for solids."""
    return next((jobs for jobs in reversed(bench.runner.requests) if jobs and jobs[0].purpose == "solid"), ())


def count(bench: Bench) -> int:
    return sum(bool(jobs) and jobs[0].purpose == "solid" for jobs in bench.runner.requests)


def finish(bench: Bench, qtbot, mode: SolidMode) -> None:
    for job in requested(bench):
        bench.runner.job_started.emit(job)
        bench.runner.job_progressed.emit(job, "checking", 0.5)
        result = solid_of(job.design, job.member, job.method, job.variant)
        bench.runner.job_done.emit(job, result)
    bench.runner.queue_changed.emit(0)
    qtbot.waitUntil(lambda: all(mode.solids.progress(key) is None for key in mode.keys), timeout=PATIENCE_MS)


def state(bench: Bench) -> str:
    return bench.window.solid_panel._state.text()


def settle(mode: SolidMode) -> None:
    mode.redraw()


def test_a_gear_is_asked_for_when_it_comes_into_sight(bench: Bench, mode: SolidMode, qtbot) -> None:
    assert count(bench) == 0
    bench.window.commands.modes.actions()[1].trigger()
    assert mode.mode == "gear"
    assert [(job.member, job.method, job.variant) for job in requested(bench)] == [
        ("wheel", "rotating_line", "optimised")
    ]
    settle(mode)
    assert "waiting" in state(bench)
    finish(bench, qtbot, mode)
    settle(mode)
    assert state(bench) == "Up to date"
    assert "Wheel" in table_text(bench.window.solid_panel.properties.table)


def test_the_pair_asks_for_what_is_missing_of_it(bench: Bench, mode: SolidMode, qtbot) -> None:
    mode.set_mode("gear")
    finish(bench, qtbot, mode)
    bench.window.commands["build_pair"].trigger()
    assert [job.member for job in requested(bench)] == ["pinion"]
    finish(bench, qtbot, mode)
    settle(mode)
    assert state(bench) == "Up to date" and count(bench) == 2
    mode.set_mode("flanks")
    mode.set_mode("pair")
    assert count(bench) == 2


def test_one_method_is_shown_and_all_three_come_back(bench: Bench, mode: SolidMode) -> None:
    buttons = bench.window.method_bar.methods
    mode.set_mode("gear")
    assert buttons.button("rotating_line").isChecked() and not buttons.button("all").isEnabled()
    bench.session.select(member="pinion")
    assert buttons.button("rotating_line").isChecked() and mode.keys[0].member == "pinion"
    bench.session.select(method="point_cloud")
    assert mode.keys == (Key("pinion", "point_cloud", "optimised"),)
    bench.session.select(method="all")
    mode.set_mode("flanks")
    assert buttons.button("all").isChecked() and buttons.button("all").isEnabled()


def test_an_edit_makes_it_stale_and_a_rest_builds_it_again(bench: Bench, mode: SolidMode, qtbot) -> None:
    mode.set_mode("gear")
    finish(bench, qtbot, mode)
    for teeth in (18, 19, 20):
        bench.session.edit(TEETH, teeth)
    settle(mode)
    assert state(bench).startswith("Out of date") and count(bench) == 1
    qtbot.waitUntil(lambda: count(bench) == 2, timeout=10 * REST_MS)
    assert requested(bench)[0].design.pair.pinion_teeth == 20
    bench.session.edit("name", "Another name")
    finish(bench, qtbot, mode)
    settle(mode)
    assert state(bench) == "Up to date"


def test_without_rebuilding_it_waits_for_the_button(bench: Bench, mode: SolidMode, qtbot) -> None:
    mode.set_mode("gear")
    finish(bench, qtbot, mode)
    bench.window.solid_panel.automatic.setChecked(False)
    bench.session.edit(TEETH, 21)
    qtbot.wait(2 * REST_MS)
    assert count(bench) == 1
    bench.window.solid_panel._build.click()
    assert count(bench) == 2 and requested(bench)[0].design.pair.pinion_teeth == 21


def test_results_of_an_older_design_are_shown_but_not_current(bench: Bench, mode: SolidMode, qtbot) -> None:
    mode.set_mode("gear")
    (job,) = requested(bench)
    bench.session.edit(TEETH, 22)
    bench.runner.job_done.emit(job, solid_of(job.design, job.member))
    qtbot.waitUntil(lambda: mode.keys[0] in mode.solids.built, timeout=PATIENCE_MS)
    assert not mode.solids.is_current(mode.keys[0])


def test_failures_and_cancelling_are_told_and_not_tried_again_by_themselves(bench: Bench, mode: SolidMode) -> None:
    mode.set_mode("gear")
    (job,) = requested(bench)
    bench.runner.job_failed.emit(job, "rotating_line: the shell does not close", "Traceback")
    settle(mode)
    assert state(bench) == "The shell does not close" and count(bench) == 1
    bench.window.commands["build_gear"].trigger()
    assert count(bench) == 2
    bench.runner.job_cancelled.emit(requested(bench)[0])
    settle(mode)
    assert state(bench).startswith("Cancelled") and count(bench) == 2
    mode.set_mode("flanks")
    mode.set_mode("gear")
    assert count(bench) == 2


def test_another_construction_is_another_solid(bench: Bench, mode: SolidMode, qtbot) -> None:
    mode.set_mode("gear")
    finish(bench, qtbot, mode)
    bench.window.solid_panel.construction.setCurrentIndex(1)
    assert requested(bench)[0].construction == "cut"


def test_solids_are_no_exports_and_no_flanks(bench: Bench, mode: SolidMode, qtbot, tmp_path) -> None:
    mode.set_mode("gear")
    finish(bench, qtbot, mode)
    assert "Wrote" not in bench.window.messages.text
    before = dict(mode.solids.built)
    bench.runner.job_done.emit(
        ExportJob(Design(), "wheel", "flanks", "point_cloud", "published", ("step",), tmp_path), ()
    )
    assert mode.solids.built == before


def test_the_panels_of_the_modes_take_turns(bench: Bench, mode: SolidMode) -> None:
    window = bench.window
    layers = list(window._docks)[2]
    layers.show()
    mode.set_mode("pair")
    assert layers.isHidden() and not window._solid_dock.isHidden()
    assert not window.method_bar.members.isEnabled()
    mode.set_mode("flanks")
    assert not layers.isHidden() and window._solid_dock.isHidden()
    assert window.method_bar.members.isEnabled()
