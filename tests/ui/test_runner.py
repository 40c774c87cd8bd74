"""The runner with a real CAD process: requests, cancelling, closing."""

from __future__ import annotations

import os
import signal
import sys
import time
from pathlib import Path

import numpy as np
import psutil
import pytest
from PySide6.QtCore import QThread, QTimer

from gearstudio.jobs import Job
from tests.ui.runner_watch import MakeWatch, Watch, worker_process, workers
from tests.worker import fake_jobs as fake


@pytest.fixture
def watch(make_watch: MakeWatch) -> Watch:
    return make_watch()


def test_a_request_is_carried_out_in_order_and_told_in_order(watch: Watch) -> None:
    first, second = fake.Sleep(0.02, "first"), fake.Echo("second")
    watch.runner.submit([first, second])
    watch.wait_state("ready")
    assert watch.said == [
        ("worker_state_changed", "starting", ""),
        ("queue_changed", 2),
        ("worker_state_changed", "busy", ""),
        ("job_started", first),
        ("job_progressed", first, "sleeping", 0.0),
        ("job_progressed", first, "sleeping on", 0.5),
        ("job_done", first, "first"),
        ("queue_changed", 1),
        ("job_started", second),
        ("job_done", second, "second"),
        ("worker_state_changed", "ready", ""),
        ("queue_changed", 0),
    ]


def test_signals_come_on_the_thread_of_the_runner(watch: Watch) -> None:
    threads: list[bool] = []
    watch.runner.job_done.connect(lambda *_: threads.append(QThread.currentThread() is watch.runner.thread()))
    watch.runner.submit([fake.Echo(1)])
    watch.wait(lambda: threads)
    assert threads == [True]


def test_nothing_starts_before_it_is_asked_to(make_watch: MakeWatch) -> None:
    make_watch()
    assert workers() == []


def test_starting_ahead_of_the_first_job_warms_up(watch: Watch) -> None:
    watch.runner.start()
    watch.runner.start()
    watch.wait_state("ready")
    assert watch.states == ["starting", "ready"]
    assert len(workers()) == 1


def test_a_newer_request_drops_results_already_on_their_way(watch: Watch) -> None:
    watch.runner.submit([fake.Echo("old")])
    watch.wait(lambda: watch.states[-1:] == ["busy"] or watch.results)
    watch.said.clear()
    time.sleep(0.3)  # the old result has reached this thread, which has not looked yet
    watch.runner.submit([fake.Echo("new")])
    watch.wait(lambda: watch.results)
    assert watch.results == ["new"]


def test_a_superseded_job_that_is_nearly_done_keeps_its_process(make_watch: MakeWatch) -> None:
    watch = make_watch(grace_s=30.0)
    old, new = fake.Sleep(0.4, "old"), fake.Echo("new")
    watch.runner.submit([old, fake.Echo("waiting")])
    watch.wait_started(old)
    process = worker_process()
    watch.runner.submit([new])
    watch.wait(lambda: watch.results)
    assert watch.results == ["new"]
    assert worker_process() == process


def test_a_superseded_job_that_takes_long_is_ended(watch: Watch) -> None:
    old, new = fake.Sleep(3600, "old"), fake.Echo("new")
    watch.runner.submit([old])
    watch.wait_started(old)
    watch.runner.submit([new])
    watch.wait(lambda: watch.results)
    assert watch.results == ["new"]
    assert ("worker_state_changed", "starting", "superseded") in watch.said
    assert len(workers()) == 1


def test_newest_wins_under_ten_requests_a_second(watch: Watch) -> None:
    submitted: list[int] = []
    timer = QTimer(interval=100)

    def edit() -> None:
        number = len(submitted)
        submitted.append(number)
        watch.runner.submit([fake.Sleep(0.02, (number, part)) for part in range(6)])
        if number == 29:
            timer.stop()

    newest_when_done: list[tuple[int, int]] = []
    watch.runner.job_done.connect(lambda _, result: newest_when_done.append((result[0], submitted[-1])))
    timer.timeout.connect(edit)
    timer.start()
    watch.wait(lambda: len(submitted) == 30)
    watch.wait_empty()
    assert watch.results[-6:] == [(29, part) for part in range(6)]
    assert all(number == newest for number, newest in newest_when_done)
    assert not watch.of("job_failed")
    assert "replaced" not in watch.states


def test_exports_and_builds_wait_for_each_other(watch: Watch) -> None:
    export = fake.Export(0.3, "export")
    watch.runner.submit([export])
    watch.wait_started(export)
    for number in range(3):
        watch.runner.submit([fake.Echo(number)])
    watch.runner.submit([fake.Export(0.0, "second export")])
    watch.runner.submit([fake.Echo("newest")])
    watch.wait_empty()
    assert watch.results == ["export", "second export", "newest"]


def test_requests_that_do_not_replace_are_all_carried_out(watch: Watch) -> None:
    for number in range(3):
        watch.runner.submit([fake.Echo(number)], replace=False)
    watch.wait_empty()
    assert watch.results == [0, 1, 2]


def test_cancelling_ends_the_running_job_and_forgets_the_rest(watch: Watch) -> None:
    running, waiting, export = fake.Sleep(3600), fake.Echo("waiting"), fake.Export(0.0)
    watch.runner.submit([running, waiting])
    watch.runner.submit([export])
    watch.wait_started(running)
    process = worker_process()
    watch.runner.cancel()
    watch.wait(lambda: len(watch.of("job_cancelled")) == 3)
    assert watch.of("job_cancelled") == [(running,), (waiting,), (export,)]
    watch.runner.submit([fake.Echo("after")])
    watch.wait(lambda: watch.results)
    assert watch.results == ["after"]
    assert not process.is_running()
    assert not watch.of("job_failed") and "replaced" not in watch.states


def test_cancelling_while_the_process_warms_up_keeps_it(make_watch: MakeWatch) -> None:
    watch = make_watch(warm_up=fake.SlowWarmUp(0.5))
    job = fake.Echo("cancelled")
    watch.runner.submit([job])
    watch.wait(lambda: watch.of("queue_changed"))
    watch.runner.cancel()
    watch.wait(lambda: watch.of("job_cancelled"))
    watch.wait_state("ready")
    assert watch.states == ["starting", "ready"]


def test_cancelling_nothing_does_nothing(watch: Watch) -> None:
    watch.runner.cancel()
    watch.runner.submit([fake.Echo(1)])
    watch.wait(lambda: watch.results)
    watch.runner.cancel()
    watch.runner.submit([fake.Echo(2)])
    watch.wait(lambda: len(watch.results) == 2)
    assert watch.of("job_cancelled") == []


def test_an_export_that_is_cancelled_leaves_nothing_half_made(watch: Watch, tmp_path: Path) -> None:
    export = fake.Export(3600, litter=tmp_path)
    watch.runner.submit([export])
    watch.wait(lambda: list(tmp_path.iterdir()))
    watch.runner.cancel()
    watch.wait(lambda: watch.of("job_cancelled"))
    watch.wait(lambda: not list(tmp_path.iterdir()))


def test_an_expected_error_has_a_text_and_a_bug_has_its_traceback(watch: Watch) -> None:
    watch.runner.submit([fake.Expected(), fake.Bug(), fake.Echo("next")])
    watch.wait_empty()
    expected, bug = watch.of("job_failed")
    assert expected[1:] == ("point_cloud: interpolation failed: the points coincide", "")
    assert str(bug[1]).startswith("unexpected error: ZeroDivisionError") and "Traceback" in str(bug[2])
    assert watch.results == ["next"]


@pytest.mark.parametrize("job", [fake.Unpicklable(), fake.Unreadable(), fake.Unsendable(), fake.Unloadable()])
def test_what_cannot_travel_fails_alone(watch: Watch, job: Job) -> None:
    watch.runner.submit([job, fake.Echo("next")])
    watch.wait_empty()
    ((failed, text, details),) = watch.of("job_failed")
    assert failed is job and text and "Traceback" in str(details)
    assert watch.results == ["next"]
    assert "replaced" not in watch.states


def test_a_large_result_arrives_whole_while_the_window_goes_on(watch: Watch) -> None:
    watch.runner.start()
    watch.wait_state("ready")
    ticks: list[float] = []
    timer = QTimer(interval=5)
    timer.timeout.connect(lambda: ticks.append(time.perf_counter()))
    timer.start()
    watch.runner.submit([fake.Arrays(50)])
    watch.wait(lambda: watch.results)
    result = watch.results[0]
    assert isinstance(result, dict)
    np.testing.assert_array_equal(result["points"], np.arange(50 * 125_000))
    print(f"longest gap {max(np.diff(ticks)) * 1e3:.0f} ms")
    assert len(ticks) > 3


@pytest.mark.parametrize("moment", ["starting", "warming up", "idle", "busy", "sending", "cancelling"])
def test_closing_at_any_moment_leaves_no_process(make_watch: MakeWatch, moment: str) -> None:
    watch = make_watch(warm_up=fake.SlowWarmUp(3600) if moment == "warming up" else fake.no_warm_up)
    job = fake.Arrays(100) if moment == "sending" else fake.Sleep(3600)
    if moment == "idle":
        watch.runner.start()
        watch.wait_state("ready")
    else:
        watch.runner.submit([job])
    if moment in ("busy", "sending", "cancelling"):
        watch.wait_started(job)
    if moment == "warming up":
        watch.qtbot.wait(1000)
    if moment == "cancelling":
        watch.runner.cancel()
    said = len(watch.said)
    watch.runner.close()
    assert workers() == []
    watch.runner.close()
    watch.runner.submit([fake.Echo("too late")])
    watch.runner.cancel()
    watch.qtbot.wait(50)
    assert len(watch.said) == said


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGSTOP")
def test_a_process_that_does_not_listen_is_ended_all_the_same(watch: Watch) -> None:
    job = fake.Sleep(3600)
    watch.runner.submit([job])
    watch.wait_started(job)
    os.kill(worker_process().pid, signal.SIGSTOP)
    began = time.monotonic()
    watch.runner.close()
    assert workers() == []
    assert time.monotonic() - began < 20


@pytest.mark.skipif(sys.platform == "win32", reason="counts file descriptors")
def test_replacing_the_process_loses_no_file_descriptor(watch: Watch) -> None:
    counts = []
    for _ in range(3):
        job = fake.Sleep(3600)
        watch.runner.submit([job])
        watch.wait_started(job)
        counts.append(psutil.Process().num_fds())
        watch.runner.cancel()
        watch.wait_state("ready")
        watch.said.clear()
    assert counts[0] == counts[1] == counts[2]
