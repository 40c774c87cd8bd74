"""The controller thread: owns the CAD process and the queue, and waits for both ends at once. No Qt."""

from __future__ import annotations

import logging
import threading
import time
import traceback
from collections.abc import Callable, Sequence
from multiprocessing import Pipe
from multiprocessing.connection import Connection, wait

from gearstudio import wire, worker
from gearstudio.jobs import Job
from gearstudio.words import noted
from ui.job_events import (
    Event,
    JobCancelled,
    JobDone,
    JobFailed,
    JobProgressed,
    JobStarted,
    QueueChanged,
    State,
    StateChanged,
)
from ui.job_queue import JobQueue, Ticket
from ui.worker_process import PATIENCE, WorkerProcess

log = logging.getLogger(__name__)

START_ATTEMPTS = 3
START_DELAY = 0.5
LAST_PATIENCE = 1.0
DIED = noted("the CAD process died each time it tried")
"""What is said of a job that was given up."""


class JobThread(threading.Thread):
    """Carries out requests in a process that it starts, watches and replaces.

    Parameters
    ----------
    post : callable
        Takes each event, in order, in this thread.
    start_worker : callable
        Starts a process; OSError when it cannot.
    grace : float
        Seconds that a superseded job may still run; after that its process is replaced.

    The public methods are for other threads and return at once.
    """

    def __init__(self, post: Callable[[Event], None], start_worker: Callable[[], WorkerProcess], grace: float) -> None:
        super().__init__(name="jobs", daemon=True)
        self._post = post
        self._start_worker = start_worker
        self._grace = grace
        self._queue = JobQueue()
        self._worker: WorkerProcess | None = None
        self._number = 0
        self._failed_starts = 0
        self._start_at: float | None = None
        self._grace_ends: float | None = None
        self._told_state: State | None = None
        self._told_count = 0
        self._closing = False
        self._lock = threading.Lock()
        self._commands: list[Callable[[], None]] = []
        self._wake_reader, self._wake_writer = Pipe(duplex=False)

    @property
    def process_id(self) -> int:
        """Number of the running process; 0 when there is none."""
        return process.process_id if (process := self._worker) is not None else 0

    def submit(self, jobs: Sequence[Job], request: int, replace: bool) -> None:
        """Queue the jobs of a request; with ``replace``, in place of older ones of the same purpose."""
        self._command(lambda: self._submit(jobs, request, replace))

    def cancel(self) -> None:
        """End the running job and forget those that wait."""
        self._command(self._cancel)

    def give_up(self, text: str) -> None:
        """Let the running job fail with this text and replace the process; the others are carried out."""
        self._command(lambda: self._give_up(text))

    def restart(self) -> None:
        """Replace the process, also after it was given up; no job is lost."""
        self._command(self._restart)

    def close(self) -> None:
        """End the process and this thread."""
        self._command(self._close)

    def kill(self) -> None:
        """Last resort, when the thread hangs in talking to a process that does not listen."""
        if (hung := self._worker) is not None:
            hung.kill()

    def run(self) -> None:
        try:
            self._start_soon("starting", "")
            while not self._closing:
                self._wait()
                self._keep_deadlines()
                self._send_next()
                self._tell_count()
        except Exception as error:
            log.exception("the controller thread failed")
            self._tell("stopped", f"internal error: {error}")
        finally:
            self._end_worker(self._queue.running, LAST_PATIENCE)

    # Commands of other threads

    def _command(self, command: Callable[[], None]) -> None:
        with self._lock:
            self._commands.append(command)
            if len(self._commands) == 1:
                self._wake_writer.send_bytes(b"!")

    def _obey(self) -> None:
        with self._lock:
            self._wake_reader.recv_bytes()
            commands, self._commands = self._commands, []
        for command in commands:
            command()

    def _submit(self, jobs: Sequence[Job], request: int, replace: bool) -> None:
        self._queue.submit(jobs, request, replace)
        running = self._queue.running
        if running is not None and running.superseded and self._grace_ends is None:
            self._grace_ends = time.monotonic() + self._grace

    def _cancel(self) -> None:
        running = self._queue.running
        for ticket in self._queue.clear():
            self._post(JobCancelled(ticket))
        self._tell_count()
        if running is not None:
            self._replace("cancelled", running)

    def _give_up(self, text: str) -> None:
        running = self._queue.running
        if running is None:
            return
        self._failed(text, "")
        self._replace("given up", running)

    def _restart(self) -> None:
        running = self._queue.running
        self._queue.put_back()
        self._failed_starts = 0
        self._replace("restarted", running)

    def _close(self) -> None:
        self._closing = True

    # Waiting for commands, messages, deaths and deadlines

    def _wait(self) -> None:
        process = self._worker
        waits_for: list[Connection | int] = [self._wake_reader]
        if process is not None:
            waits_for += [process.connection, process.sentinel]
        ready = wait(waits_for, self._timeout())
        if self._wake_reader in ready:
            self._obey()
        if process is None or process is not self._worker:
            return
        if process.connection in ready:
            self._receive(process)
        elif process.sentinel in ready and not process.has_message():
            self._lost(process)

    def _timeout(self) -> float | None:
        deadlines = [at for at in (self._start_at, self._grace_ends) if at is not None]
        return max(0.0, min(deadlines) - time.monotonic()) if deadlines else None

    def _keep_deadlines(self) -> None:
        now = time.monotonic()
        if self._grace_ends is not None and now >= self._grace_ends:
            running = self._queue.running
            self._queue.finish()
            self._replace("superseded", running)
        if self._start_at is not None and now >= self._start_at:
            self._start_at = None
            self._start()

    # Messages

    def _receive(self, process: WorkerProcess) -> None:
        try:
            message = process.receive()
        except (EOFError, OSError):
            self._lost(process)
        except wire.UnreadableMessageError as error:
            self._failed(f"its result could not be read: {error}", traceback.format_exc())
        else:
            self._act_on(process, message)

    def _act_on(self, process: WorkerProcess, message: object) -> None:
        running = self._queue.running
        awaited = running if running is not None and not running.superseded else None
        match message:
            case worker.Ready():
                process.ready = True
                self._failed_starts = 0
            case worker.NotStarted(text, details):
                process.problem = text
                log.error("the CAD process could not start: %s\n%s", text, details)
            case worker.Started() if awaited:
                self._post(JobStarted(awaited))
            case worker.Progress(_, stage, fraction) if awaited:
                self._post(JobProgressed(awaited, stage, fraction))
            case worker.Done(_, result):
                self._grace_ends = None
                if ticket := self._queue.finish():
                    self._post(JobDone(ticket, result))
            case worker.Failed(_, text, _, True):
                self._failed(text, "")
            case worker.Failed(_, text, details):
                log.error("a job failed unexpectedly: %s\n%s", text, details)
                self._failed(f"unexpected error: {text}", details)

    def _failed(self, text: str, details: str) -> None:
        self._grace_ends = None
        if ticket := self._queue.finish():
            self._post(JobFailed(ticket, text, details))

    def _send_next(self) -> None:
        while self._worker is not None and self._worker.ready and self._queue.running is None:
            ticket = self._queue.take()
            if ticket is None:
                if self._told_state != "ready":
                    self._tell("ready", "")
                return
            self._send(self._worker, ticket)

    def _send(self, process: WorkerProcess, ticket: Ticket) -> None:
        self._number += 1
        try:
            process.send(self._number, ticket.job)
        except OSError:
            self._lost(process)
        except Exception as error:
            self._failed(f"the job could not be sent: {type(error).__name__}: {error}", traceback.format_exc())
        else:
            if self._told_state != "busy":
                self._tell("busy", "")

    # The life of the process

    def _start_soon(self, state: State, reason: str, delay: float = 0.0) -> None:
        self._start_at = time.monotonic() + delay
        self._tell(state, reason)

    def _start(self) -> None:
        try:
            self._worker = self._start_worker()
        except OSError as error:
            self._start_failed(str(error))

    def _start_failed(self, reason: str) -> None:
        self._failed_starts += 1
        if self._failed_starts >= START_ATTEMPTS:
            self._tell("stopped", f"it failed to start {START_ATTEMPTS} times; {reason}")
        else:
            self._start_soon("replaced", reason, START_DELAY * (self._failed_starts - 1))

    def _lost(self, process: WorkerProcess) -> None:
        """The process died by itself: find out why, replace it, and look after its job."""
        self._worker = None
        self._grace_ends = None
        death = process.death()
        reason = process.problem or death
        log.warning("lost the CAD process: %s", reason)
        self._clear_up(self._queue.running, process)
        if given_up := self._queue.retry():
            self._post(JobFailed(given_up, f"{DIED}: {reason}"))
        if process.ready:
            self._start_soon("replaced", reason)
        else:
            self._start_failed(reason)

    def _replace(self, reason: str, running: Ticket | None) -> None:
        """End the process on purpose and start another."""
        self._start_soon("starting", reason)
        self._end_worker(running, PATIENCE)

    def _end_worker(self, running: Ticket | None, patience: float) -> None:
        self._grace_ends = None
        process = self._worker
        if process is not None:
            process.stop(patience)
            self._worker = None
            self._clear_up(running, process)

    def _clear_up(self, ticket: Ticket | None, process: WorkerProcess) -> None:
        if ticket is None:
            return
        try:
            ticket.job.clear_up(process.process_id)
        except Exception:
            log.exception("could not clear up after %s", ticket.job.label)

    # Events

    def _tell(self, state: State, reason: str) -> None:
        self._told_state = state
        self._post(StateChanged(state, reason))

    def _tell_count(self) -> None:
        if self._queue.wanted != self._told_count:
            self._told_count = self._queue.wanted
            self._post(QueueChanged(self._told_count))
