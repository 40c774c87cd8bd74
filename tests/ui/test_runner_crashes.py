"""The CAD process dies in every phase of its life; the runner replaces it, says so and loses nothing."""

from __future__ import annotations

import os
import signal
from pathlib import Path

import pytest

from tests.ui.runner_watch import MakeWatch, Watch, worker_process, workers
from tests.worker import fake_jobs as fake
from tests.worker.fake_jobs import Fuse

pytestmark = pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="no such signals")

SIGNALS = [signal.SIGKILL, signal.SIGSEGV]


def reasons(watch: Watch) -> list[object]:
    return [reason for state, reason in watch.of("worker_state_changed") if state == "replaced"]


@pytest.mark.parametrize("how", SIGNALS)
@pytest.mark.parametrize("phase", [fake.CrashingStart, fake.CrashingWarmUp])
def test_a_crash_before_it_is_ready(make_watch: MakeWatch, tmp_path: Path, phase: type, how: int) -> None:
    watch = make_watch(warm_up=phase(Fuse(tmp_path, how)))
    watch.runner.submit([fake.Echo("done")])
    watch.wait(lambda: watch.results)
    assert reasons(watch) == [f"it was killed by {signal.Signals(how).name}"]
    assert watch.results == ["done"]


@pytest.mark.parametrize("how", SIGNALS)
def test_a_crash_while_it_has_nothing_to_do(make_watch: MakeWatch, how: int) -> None:
    watch = make_watch()
    watch.runner.start()
    watch.wait_state("ready")
    os.kill(worker_process().pid, how)
    watch.wait(lambda: reasons(watch))
    assert reasons(watch) == [f"it was killed by {signal.Signals(how).name}"]
    watch.runner.submit([fake.Echo("done")])
    watch.wait(lambda: watch.results)


@pytest.mark.parametrize("how", SIGNALS)
@pytest.mark.parametrize("phase", [fake.CrashOnArrival, fake.CrashWhileBusy])
def test_a_job_during_which_it_crashes_once_is_tried_again(
    make_watch: MakeWatch, tmp_path: Path, phase: type, how: int
) -> None:
    watch = make_watch()
    job = phase(Fuse(tmp_path, how))
    watch.runner.submit([job, fake.Echo("next")])
    watch.wait_empty()
    assert reasons(watch) == [f"it was killed by {signal.Signals(how).name}"]
    assert [done[0] for done in watch.of("job_done")] == [job, fake.Echo("next")]
    assert not watch.of("job_failed")


@pytest.mark.parametrize("how", SIGNALS)
def test_a_crash_in_the_middle_of_a_large_result(make_watch: MakeWatch, tmp_path: Path, how: int) -> None:
    watch = make_watch(warm_up=fake.CrashingSend(Fuse(tmp_path, how)))
    watch.runner.submit([fake.Arrays(4)])
    watch.wait(lambda: watch.results)
    assert reasons(watch) == [f"it was killed by {signal.Signals(how).name}"]
    assert len(watch.results) == 1 and not watch.of("job_failed")


def test_an_exit_is_a_crash_too(make_watch: MakeWatch, tmp_path: Path) -> None:
    watch = make_watch()
    watch.runner.submit([fake.CrashWhileBusy(Fuse(tmp_path, how=-3))])
    watch.wait_empty()
    assert reasons(watch) == ["it ended with exit status 3"]
    assert watch.results == ["survived"]


def test_a_job_that_crashes_it_twice_fails_and_the_next_one_runs(make_watch: MakeWatch, tmp_path: Path) -> None:
    watch = make_watch()
    killer = fake.CrashWhileBusy(Fuse(tmp_path, signal.SIGSEGV, times=5))
    watch.runner.submit([killer, fake.Echo("next")])
    watch.wait_empty()
    text = "the CAD process died each time it tried: it was killed by SIGSEGV"
    assert watch.of("job_failed") == [(killer, text, "")]
    assert watch.results == ["next"]
    assert len(reasons(watch)) == 2


def test_a_superseded_job_that_crashes_it_is_forgotten(make_watch: MakeWatch, tmp_path: Path) -> None:
    watch = make_watch(grace_s=60.0)
    old = fake.Sleep(3600)
    watch.runner.submit([old])
    watch.wait_started(old)
    watch.runner.submit([fake.Echo("new")])
    os.kill(worker_process().pid, signal.SIGKILL)
    watch.wait(lambda: watch.results)
    assert watch.results == ["new"]
    assert not watch.of("job_failed")


def test_it_is_given_up_after_three_bad_starts_and_can_be_restarted(make_watch: MakeWatch, tmp_path: Path) -> None:
    watch = make_watch(warm_up=fake.CrashingWarmUp(Fuse(tmp_path, signal.SIGKILL, times=3)))
    watch.runner.submit([fake.Echo("kept")])
    watch.wait_state("stopped")
    assert watch.states == ["starting", "replaced", "replaced", "stopped"]
    assert watch.of("worker_state_changed")[-1][1] == "it failed to start 3 times; it was killed by SIGKILL"
    assert workers() == []
    watch.runner.restart()
    watch.wait(lambda: watch.results)
    assert watch.results == ["kept"]


def test_a_warm_up_that_fails_names_its_reason(make_watch: MakeWatch) -> None:
    watch = make_watch(warm_up=fake.failing_warm_up)
    watch.runner.start()
    watch.wait_state("stopped")
    assert "ImportError: libGL.so.1" in str(watch.of("worker_state_changed")[-1][1])
    job = fake.Echo("never")
    watch.runner.submit([job])
    watch.runner.cancel()
    watch.wait(lambda: watch.of("job_cancelled"))
    assert watch.of("job_cancelled") == [(job,)]


def test_restarting_in_the_middle_begins_the_job_again(make_watch: MakeWatch) -> None:
    watch = make_watch()
    job = fake.Sleep(1.0, "rested")
    watch.runner.submit([job])
    watch.wait_started(job)
    watch.runner.restart()
    watch.wait(lambda: watch.results)
    assert watch.results == ["rested"]
    assert watch.of("job_started") == [(job,), (job,)]


def test_an_export_in_a_process_that_dies_leaves_nothing_half_made(make_watch: MakeWatch, tmp_path: Path) -> None:
    watch = make_watch()
    export = fake.Export(1.0, "exported", litter=tmp_path)
    watch.runner.submit([export])
    watch.wait(lambda: list(tmp_path.iterdir()))
    (litter,) = tmp_path.iterdir()
    os.kill(worker_process().pid, signal.SIGKILL)
    watch.wait(lambda: reasons(watch))
    assert not litter.exists()
    watch.wait(lambda: watch.results == ["exported"])
