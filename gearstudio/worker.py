"""The CAD process: receives jobs over a pipe, sends progress and results back.

It is started by spawning, says ``Alive`` before it imports anything heavy, warms up, says ``Ready`` and
then does one job after the other. It ends when its parent ends, however that happens.
"""

from __future__ import annotations

import contextlib
import faulthandler
import multiprocessing
import os
import pickle
import signal
import sys
import threading
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from multiprocessing.connection import Connection

from gearstudio import jobs, wire
from gearstudio.errors import GearStudioError

LARGEST_LOG = 1_000_000
PROGRESS_INTERVAL = 0.03


@dataclass(frozen=True)
class Request:
    """A numbered job; pickled by itself, so that one that cannot be read fails alone."""

    number: int
    job: bytes


@dataclass(frozen=True)
class Alive:
    """The process runs; nothing heavy is imported yet."""


@dataclass(frozen=True)
class Ready:
    """Warmed up; waits for a job."""


@dataclass(frozen=True)
class NotStarted:
    """Warming up failed; the process ends."""

    text: str
    details: str


@dataclass(frozen=True)
class Started:
    """A job has arrived and begins."""

    number: int


@dataclass(frozen=True)
class Progress:
    """A job has come to a stage; ``fraction`` of it is done, 0 to 1."""

    number: int
    stage: str
    fraction: float


@dataclass(frozen=True)
class Done:
    """A job's result."""

    number: int
    result: object


@dataclass(frozen=True)
class Failed:
    """``expected``: the text is fit for a user; otherwise it is a bug and ``details`` has the traceback."""

    number: int
    text: str
    details: str
    expected: bool


def main(connection: Connection, warm_up: Callable[[], None] = jobs.warm_up, log: str | None = None) -> None:
    """Serve jobs until the other end of the connection closes.

    Parameters
    ----------
    connection : Connection
        One end of a duplex pipe.
    warm_up : callable
        Imports what the jobs need; called once, after ``Alive``.
    log : str, optional
        File that takes what the kernel prints and the traceback of a crash; nothing is kept without it.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    _end_with_parent()
    _redirect_output(log)
    with contextlib.suppress(EOFError, ConnectionError):
        wire.send(connection, Alive())
        try:
            warm_up()
        except Exception as error:
            wire.send(connection, NotStarted(_describe(error), traceback.format_exc()))
            return
        wire.send(connection, Ready())
        receiver = wire.Receiver(connection)
        while True:
            request = receiver.receive()
            if isinstance(request, Request):
                wire.send_frames(connection, _answer(connection, request))


def _answer(connection: Connection, request: Request) -> list[bytes | memoryview]:
    """Carry a job out; the frames of its result or of its failure."""
    number = request.number
    wire.send(connection, Started(number))
    try:
        job = pickle.loads(request.job)
        return wire.pack(Done(number, job.run(_Reporter(connection, number))))
    except GearStudioError as error:
        return wire.pack(Failed(number, str(error), traceback.format_exc(), expected=True))
    except Exception as error:
        return wire.pack(Failed(number, _describe(error), traceback.format_exc(), expected=False))


def _describe(error: Exception) -> str:
    return f"{type(error).__name__}: {error}"


class _Reporter:
    """Sends a job's progress: each new stage, and within a stage not too often."""

    def __init__(self, connection: Connection, number: int) -> None:
        self._connection = connection
        self._number = number
        self._stage: str | None = None
        self._sent_at = 0.0

    def __call__(self, stage: str, fraction: float) -> None:
        now = time.monotonic()
        if stage == self._stage and now - self._sent_at < PROGRESS_INTERVAL:
            return
        self._stage, self._sent_at = stage, now
        wire.send(self._connection, Progress(self._number, stage, fraction))


def _end_with_parent() -> None:
    """Make sure that this process does not outlive the one that started it.

    The thread is enough anywhere while Python runs; but the CAD kernel keeps Python's lock during its
    calls, so where the operating system can do it, it is asked to.
    """
    if sys.platform == "linux":
        import ctypes

        set_parent_death_signal = 1
        with contextlib.suppress(OSError, AttributeError):
            ctypes.CDLL(None).prctl(set_parent_death_signal, signal.SIGKILL)
    threading.Thread(target=_watch_parent, name="parent-watch", daemon=True).start()


def _watch_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def _redirect_output(log: str | None) -> None:
    """Send this process's output, the kernel's own printing included, to a file or nowhere."""
    try:
        too_long = log is not None and os.path.exists(log) and os.path.getsize(log) > LARGEST_LOG
        target = open(log or os.devnull, "w" if too_long else "a", encoding="utf-8", errors="backslashreplace")  # noqa: SIM115
    except OSError:
        target = open(os.devnull, "a", encoding="utf-8")  # noqa: SIM115
    target.reconfigure(line_buffering=True)
    for descriptor in (1, 2):
        os.dup2(target.fileno(), descriptor)
    sys.stdout = sys.stderr = target
    faulthandler.enable(target)
