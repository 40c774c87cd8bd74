"""The memory of the CAD process: measured, limited, and given back."""

from __future__ import annotations

import os

import psutil
import pytest
from PySide6.QtCore import QObject, QSettings, Signal

from tests.ui.runner_watch import Watch
from tests.worker import fake_jobs as fake
from ui.memory import DEFAULT_LIMIT_MB, LIMIT_KEY, MemoryGuard, memory_limit, resident_megabytes
from ui.runner import JobRunner

pytestmark = pytest.mark.ui


class FakeRunner(QObject):
    queue_changed = Signal(int)
    job_started = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self.process_id = os.getpid()
        self.restarts = 0
        self.given_up: list[str] = []

    def restart(self) -> None:
        self.restarts += 1

    def give_up(self, text: str) -> None:
        self.given_up.append(text)


def test_memory_is_measured_as_the_system_does() -> None:
    assert resident_megabytes(os.getpid()) == pytest.approx(psutil.Process().memory_info().rss / 2**20, rel=0.05)
    assert resident_megabytes(2**22 + 1) == 0.0


def test_a_process_above_the_limit_is_replaced_when_it_is_at_rest() -> None:
    runner, guard = FakeRunner(), MemoryGuard(10)
    guard.use(runner)
    guard.look()
    assert runner.restarts == 1
    guard.set_limit(100_000)
    guard.set_limit(0)
    assert runner.restarts == 1
    guard.set_limit(10)
    assert runner.restarts == 2
    guard.stop()
    guard.look()
    assert runner.restarts == 2


def test_a_job_begins_again_in_a_fresh_process_before_it_is_given_up() -> None:
    runner, guard = FakeRunner(), MemoryGuard(10)
    guard.use(runner)
    for _ in range(2):
        runner.job_started.emit(object())
    runner.queue_changed.emit(1)
    guard.look()
    assert runner.restarts == 1 and not runner.given_up
    runner.process_id = os.getppid()
    guard.set_limit(1)
    assert runner.restarts == 2 and not runner.given_up  # no job has begun in this one
    runner.job_started.emit(object())
    guard.look()
    assert runner.restarts == 2 and "1 MB" in runner.given_up[0]


def test_a_job_that_takes_too_much_fails_alone_and_the_next_is_carried_out(qtbot) -> None:
    guard, watch = MemoryGuard(0), Watch(qtbot)
    guard.use(watch.runner)
    greedy, modest = fake.Hoard(600), fake.Echo("modest")
    watch.runner.submit((modest,))
    watch.wait(lambda: watch.results == ["modest"])
    try:
        guard.set_limit(400)
        watch.runner.submit((greedy, fake.Echo("after")))
        watch.wait(lambda: watch.results == ["modest", "after"])
        assert [job for job, *_ in watch.of("job_failed")] == [greedy]
        assert "400 MB" in watch.of("job_failed")[0][1]
        assert [job for (job,) in watch.of("job_started")].count(greedy) == 2
    finally:
        guard.stop()
        watch.runner.close()


def test_a_real_process_is_replaced_by_another(qtbot) -> None:
    runner, guard = JobRunner(warm_up=fake.no_warm_up), MemoryGuard(0)
    states: list[str] = []
    runner.worker_state_changed.connect(lambda state, _reason: states.append(state))
    guard.use(runner)
    runner.start()
    try:
        qtbot.waitUntil(lambda: "ready" in states, timeout=60_000)
        before = runner.process_id
        with qtbot.waitSignal(guard.replaced, timeout=5000) as said:
            guard.set_limit(1)
        guard.set_limit(0)
        assert said.args[0] > 1
        qtbot.waitUntil(lambda: states.count("ready") == 2, timeout=60_000)
        assert runner.process_id not in (0, before) and not psutil.pid_exists(before)
    finally:
        guard.stop()
        runner.close()


@pytest.mark.parametrize(
    ("stored", "limit"),
    [(None, DEFAULT_LIMIT_MB), ("2500", 2500), (10, 1000), (0, 0), (-5, 0), ("much", DEFAULT_LIMIT_MB)],
)
def test_the_limit_is_read_from_the_settings(tmp_path, stored: object, limit: int) -> None:
    settings = QSettings(str(tmp_path / "a.ini"), QSettings.Format.IniFormat)
    if stored is not None:
        settings.setValue(LIMIT_KEY, stored)
    assert memory_limit(settings) == limit
