"""When the CAD process stops by itself the user can read what happened and what was done, in their own time."""

from __future__ import annotations

import pytest

from gearstudio.jobs import GearJob
from tests.ui.stand_ins import Bench
from ui.job_thread import DIED

pytestmark = pytest.mark.ui
KILLED = "it was killed by SIGKILL"


def states(bench: Bench, *names: str) -> None:
    for name in names:
        bench.runner.worker_state_changed.emit(name, KILLED if name in ("replaced", "stopped") else "")


def text(bench: Bench) -> str:
    return bench.window.messages.text


def test_what_happened_to_an_idle_process_stays_in_sight(bench: Bench) -> None:
    states(bench, "ready", "replaced")
    assert text(bench).endswith("stopped unexpectedly and is being started again; nothing of the design is lost.")
    states(bench, "ready", "busy", "ready")
    bench.runner.finish_all()
    assert text(bench).endswith("stopped unexpectedly and was started again; nothing of the design is lost.")
    assert bench.window.messages.keep_state()[2] == KILLED


def test_the_job_that_is_tried_again_is_named_until_it_is_done(bench: Bench) -> None:
    job, other = bench.runner.jobs[:2]
    bench.runner.job_started.emit(job)
    states(bench, "busy", "replaced")
    assert "(Wheel, rotating line, optimised). It is being started again and then tries this once more" in text(bench)
    states(bench, "busy")
    assert "It was started again and tries this once more" in text(bench)
    bench.runner.finish(job)
    assert "It was started again and has done this now" in text(bench)
    bench.runner.finish(other)
    states(bench, "ready")
    assert "(Wheel, rotating line, optimised)" in text(bench)


def test_a_job_that_is_given_up_is_named(bench: Bench) -> None:
    job = GearJob(bench.session.design, "pinion", "point_cloud", "optimised")
    bench.runner.job_started.emit(job)
    states(bench, "busy", "replaced", "busy")
    bench.runner.job_started.emit(job)
    bench.runner.job_failed.emit(job, f"{DIED}: {KILLED}", "")
    states(bench, "replaced", "ready")
    assert "stopped twice at the same work (solid of the pinion), which was given up" in text(bench)


@pytest.mark.parametrize("end", ["cancelled", "superseded"])
def test_nothing_is_said_to_be_tried_that_is_not(bench: Bench, end: str) -> None:
    job, newer = bench.runner.jobs[:2]
    bench.runner.job_started.emit(job)
    states(bench, "replaced", "busy")
    if end == "cancelled":
        bench.runner.job_cancelled.emit(job)
    else:
        bench.runner.job_started.emit(newer)
    assert text(bench).endswith("was started again; nothing of the design is lost.") and "(" not in text(bench)


def test_what_was_dismissed_or_superseded_does_not_come_back(bench: Bench) -> None:
    states(bench, "ready", "replaced")
    bench.window.messages.clear()
    states(bench, "ready", "busy")
    assert text(bench) == ""
    states(bench, "replaced")
    bench.window.messages.show_message("info", "something newer", topic="file")
    states(bench, "ready", "busy")
    assert text(bench) == "something newer"


def test_a_process_that_can_be_started_after_all_takes_the_refusal_away(bench: Bench) -> None:
    states(bench, "replaced", "replaced", "stopped")
    assert "could not be started" in text(bench)
    states(bench, "starting", "ready")
    assert text(bench) == ""
