"""The CAD process, talked to directly: what it says, what it survives, when it ends."""

from __future__ import annotations

import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from multiprocessing.context import SpawnProcess
from pathlib import Path

import numpy as np
import psutil
import pytest

from gearstudio import wire, worker
from gearstudio.jobs import Job
from tests.worker import fake_jobs as fake

HANG = 30.0
ROOT = Path(__file__).resolve().parents[2]


class Peer:
    """A started CAD process and our end of its pipe."""

    def __init__(self, warm_up: Callable[[], None] = fake.no_warm_up, log: str | None = None) -> None:
        context = multiprocessing.get_context("spawn")
        self.connection, theirs = context.Pipe()
        self.process: SpawnProcess = context.Process(target=worker.main, args=(theirs, warm_up, log), daemon=True)
        self.process.start()
        theirs.close()
        self._receiver = wire.Receiver(self.connection)
        self._number = 0

    def receive(self) -> object:
        assert self.connection.poll(HANG), "the process says nothing"
        return self._receiver.receive()

    def answer(self, job: Job) -> list[object]:
        """Everything said about a job, the last is Done or Failed."""
        self._number += 1
        wire.send(self.connection, worker.Request(self._number, pickle.dumps(job)))
        said = [self.receive()]
        while not isinstance(said[-1], worker.Done | worker.Failed):
            said.append(self.receive())
        assert all(message.number == self._number for message in said)
        return said

    def end(self) -> None:
        self.connection.close()
        self.process.kill()
        self.process.join()


@pytest.fixture
def peer() -> Iterator[Peer]:
    made = Peer()
    assert made.receive() == worker.Alive()
    assert made.receive() == worker.Ready()
    yield made
    made.end()


def test_a_job_is_started_reported_and_done(peer: Peer) -> None:
    assert peer.answer(fake.Sleep(0.02, "rested")) == [
        worker.Started(1),
        worker.Progress(1, "sleeping", 0.0),
        worker.Progress(1, "sleeping on", 0.5),
        worker.Done(1, "rested"),
    ]
    assert peer.answer(fake.Echo(5))[-1] == worker.Done(2, 5)


def test_frequent_progress_is_thinned(peer: Peer) -> None:
    said = peer.answer(fake.Chatter(20_000))
    assert said[-1] == worker.Done(1, 20_000)
    assert len(said) < 1000


def test_large_results_arrive(peer: Peer) -> None:
    done = peer.answer(fake.Arrays(20))[-1]
    assert isinstance(done, worker.Done) and isinstance(done.result, dict)
    np.testing.assert_array_equal(done.result["points"], np.arange(20 * 125_000))


def test_an_expected_error_is_told_from_a_bug(peer: Peer) -> None:
    expected = peer.answer(fake.Expected())[-1]
    assert isinstance(expected, worker.Failed) and expected.expected
    assert expected.text == "point_cloud: interpolation failed: the points coincide"
    bug = peer.answer(fake.Bug())[-1]
    assert isinstance(bug, worker.Failed) and not bug.expected
    assert bug.text.startswith("ZeroDivisionError") and "Traceback" in bug.details


@pytest.mark.parametrize("job", [fake.Unpicklable(), fake.Unloadable()])
def test_what_cannot_travel_fails_alone(peer: Peer, job: Job) -> None:
    failed = peer.answer(job)[-1]
    assert isinstance(failed, worker.Failed) and not failed.expected
    assert peer.answer(fake.Echo("next"))[-1] == worker.Done(2, "next")


def test_an_interrupt_is_ignored(peer: Peer) -> None:
    os.kill(peer.process.pid or 0, signal.SIGINT)
    assert peer.answer(fake.Echo(1))[-1] == worker.Done(1, 1)


def test_it_ends_when_the_pipe_closes(peer: Peer) -> None:
    peer.connection.close()
    peer.process.join(HANG)
    assert peer.process.exitcode == 0


def test_a_warm_up_that_fails_says_why() -> None:
    peer = Peer(fake.failing_warm_up)
    assert peer.receive() == worker.Alive()
    problem = peer.receive()
    assert isinstance(problem, worker.NotStarted) and problem.text.startswith("ImportError: libGL")
    peer.process.join(HANG)
    assert peer.process.exitcode == 0
    peer.end()


def test_the_kernels_printing_and_a_crash_go_to_the_log(tmp_path: Path) -> None:
    log = tmp_path / "worker.log"
    peer = Peer(fake.loud_warm_up, str(log))
    peer.receive()
    peer.receive()
    os.kill(peer.process.pid or 0, signal.SIGSEGV)
    peer.process.join(HANG)
    peer.end()
    written = log.read_text()
    assert "printed by Python" in written and "printed past Python" in written
    assert "Segmentation fault" in written


def test_a_log_that_cannot_be_written_is_no_obstacle(tmp_path: Path) -> None:
    peer = Peer(log=str(tmp_path / "missing" / "worker.log"))
    assert peer.receive() == worker.Alive()
    peer.end()


PARENT = """
import sys, time
from tests.worker import fake_jobs as fake
from tests.worker.test_worker import Peer
import pickle
from gearstudio import wire, worker
if __name__ == "__main__":
    peer = Peer()
    peer.receive(), peer.receive()
    wire.send(peer.connection, worker.Request(1, pickle.dumps(fake.{job})))
    peer.receive()
    print(peer.process.pid, flush=True)
    time.sleep(60)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGKILL")
@pytest.mark.parametrize("job", ["Echo(1)", "HoldsTheLock(60)"])
def test_it_does_not_outlive_a_killed_parent(job: str, tmp_path: Path) -> None:
    if job.startswith("Holds") and sys.platform != "linux":
        pytest.skip("only Linux ends a process that holds Python's lock")
    script = tmp_path / "parent.py"
    script.write_text(PARENT.format(job=job))
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    with subprocess.Popen([sys.executable, str(script)], stdout=subprocess.PIPE, env=environment) as parent:
        assert parent.stdout is not None
        child = psutil.Process(int(parent.stdout.readline()))
        parent.kill()
    deadline = time.monotonic() + HANG
    while child.is_running() and child.status() != psutil.STATUS_ZOMBIE:
        assert time.monotonic() < deadline, "the process outlived its parent"
        time.sleep(0.02)
