"""The window's end of the CAD process: start it, talk to it, find out how it died, never leave it behind."""

from __future__ import annotations

import contextlib
import multiprocessing
import pickle
import signal
from collections.abc import Callable
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess

from gearstudio import wire, worker
from gearstudio.jobs import Job

PATIENCE = 2.0
"""Seconds that a process gets to end by itself before it is killed."""


class WorkerProcess:
    """A running CAD process; all but `kill` is for one thread only.

    ``ready`` and ``problem`` (why it could not start) are for its owner to keep.
    """

    def __init__(self, process: BaseProcess, connection: Connection) -> None:
        self.process_id = process.pid or 0
        self.sentinel = process.sentinel
        self.connection = connection
        self.ready = False
        self.problem = ""
        self._process = process
        self._receiver = wire.Receiver(connection)

    def send(self, number: int, job: Job) -> None:
        """Send a job; OSError if the process has gone, anything else if the job cannot be pickled."""
        try:
            frames = wire.pack(worker.Request(number, pickle.dumps(job, protocol=5)))
        except OSError as error:
            raise pickle.PicklingError(str(error)) from error
        wire.send_frames(self.connection, frames)

    def receive(self) -> object | None:
        """Take what is there of the next message; see `gearstudio.wire.Receiver.step`."""
        return self._receiver.step()

    def has_message(self) -> bool:
        """Whether something it sent before its end still waits to be received."""
        try:
            return self.connection.poll()
        except OSError:
            return False

    def death(self) -> str:
        """How the process died, in words; ends it if it only closed its end of the pipe."""
        self._process.join(PATIENCE)
        code = self._process.exitcode
        self.stop()
        if code is None:
            return "it stopped answering"
        if code >= 0:
            return f"it ended with exit status {code}"
        with contextlib.suppress(ValueError):
            return f"it was killed by {signal.Signals(-code).name}"
        return f"it was killed by signal {-code}"

    def stop(self, patience: float = PATIENCE) -> None:
        """End the process whatever it is doing."""
        self.connection.close()
        self._process.terminate()
        self._process.join(patience)
        if self._process.exitcode is None:
            self._process.kill()
            self._process.join(patience)
        with contextlib.suppress(ValueError):  # not even a kill ends a process in a hung disk operation
            self._process.close()

    def kill(self) -> None:
        """Kill the process and wait for nothing; any thread may."""
        with contextlib.suppress(ValueError):
            self._process.kill()


def start_worker(warm_up: Callable[[], None], log: str | None) -> WorkerProcess:
    """Spawn a CAD process; returns before it is ready. OSError if the system has no room for one."""
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe(duplex=True)
    process = context.Process(target=worker.main, args=(theirs, warm_up, log), name="gearstudio-worker", daemon=True)
    try:
        process.start()
    except BaseException:
        ours.close()
        raise
    finally:
        theirs.close()
    return WorkerProcess(process, ours)
