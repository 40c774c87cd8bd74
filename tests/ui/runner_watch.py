"""What a JobRunner said, in order, and which processes it has."""

from __future__ import annotations

from collections.abc import Callable

import psutil
from pytestqt.qtbot import QtBot

from gearstudio.jobs import Job
from tests.worker import fake_jobs as fake
from ui.runner import JobRunner

HANG_MS = 60_000


class Watch:
    """A runner under test with everything it emits, as tuples that start with the signal's name."""

    def __init__(self, qtbot: QtBot, warm_up: Callable[[], None] = fake.no_warm_up, grace_s: float = 0.5) -> None:
        self.qtbot = qtbot
        self.runner = JobRunner(warm_up=warm_up, grace_s=grace_s)
        self.said: list[tuple[object, ...]] = []
        for name in ("worker_state_changed", "job_started", "job_done", "job_failed", "job_cancelled", "queue_changed"):
            getattr(self.runner, name).connect(lambda *values, name=name: self.said.append((name, *values)))
        self.runner.job_progressed.connect(lambda *values: self.said.append(("job_progressed", *values)))

    def of(self, name: str) -> list[tuple[object, ...]]:
        return [what[1:] for what in self.said if what[0] == name]

    def wait(self, condition: Callable[[], object]) -> None:
        self.qtbot.waitUntil(lambda: bool(condition()), timeout=HANG_MS)

    def wait_state(self, *states: str) -> None:
        self.wait(lambda: self.states and self.states[-1] in states)

    def wait_started(self, job: Job) -> None:
        self.wait(lambda: any(started[0] is job for started in self.of("job_started")))

    def wait_empty(self) -> None:
        self.wait(lambda: self.of("queue_changed") and self.of("queue_changed")[-1] == (0,))

    @property
    def states(self) -> list[object]:
        return [state for state, _ in self.of("worker_state_changed")]

    @property
    def results(self) -> list[object]:
        return [result for _, result in self.of("job_done")]


MakeWatch = Callable[..., Watch]


def workers() -> list[psutil.Process]:
    """Running children that are CAD processes, and dead ones of any kind that were not waited for."""
    found = []
    for child in psutil.Process().children():
        try:
            dead = child.status() == psutil.STATUS_ZOMBIE
            if dead or any("spawn_main" in word for word in child.cmdline()):
                found.append(child)
        except psutil.NoSuchProcess:
            continue
    return found


def worker_process() -> psutil.Process:
    (process,) = workers()
    return process
