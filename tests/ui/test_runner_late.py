"""A job thread that ends late, after its runner has been closed and deleted: it tells nobody, and nothing breaks."""

from __future__ import annotations

import threading

import pytest
import shiboken6

import ui.runner
from tests.worker import fake_jobs as fake
from ui.runner import JobRunner


@pytest.mark.parametrize("deleted", [True, False])
def test_a_thread_that_hangs_while_its_runner_goes_ends_quietly(qapp, qtbot, monkeypatch, deleted: bool) -> None:
    starting, go_on, broken = threading.Event(), threading.Event(), list[object]()

    def start_slowly(*_: object) -> None:
        starting.set()
        go_on.wait(10)
        raise OSError("no room for a process")

    monkeypatch.setattr(ui.runner, "start_worker", start_slowly)
    monkeypatch.setattr(ui.runner, "CLOSING_TIME", 0.05)
    monkeypatch.setattr(threading, "excepthook", broken.append)
    heard: list[object] = []
    runner = JobRunner()
    runner.worker_state_changed.connect(lambda *said: heard.append(said))
    runner.submit([fake.Echo(1)])
    assert starting.wait(10)
    runner.close()
    heard.clear()
    if deleted:
        shiboken6.delete(runner)
    thread = next(thread for thread in threading.enumerate() if thread.name == "jobs")
    go_on.set()
    thread.join(5)
    qtbot.wait(20)
    assert not thread.is_alive() and not broken and not heard
