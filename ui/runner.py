"""The window's door to the CAD process: requests in, signals out, nothing that blocks."""

from __future__ import annotations

import functools
import itertools
import threading
from collections import deque
from collections.abc import Callable, Sequence

from PySide6.QtCore import QObject, Qt, Signal, Slot

from gearstudio import jobs
from gearstudio.jobs import Job
from ui.job_events import (
    Event,
    JobCancelled,
    JobDone,
    JobFailed,
    JobProgressed,
    JobStarted,
    QueueChanged,
    StateChanged,
)
from ui.job_thread import JobThread
from ui.worker_process import start_worker

CLOSING_TIME = 2.2
LAST_MOMENT = 0.2


class JobRunner(QObject):
    """Has jobs carried out in the CAD process, which it starts, watches and replaces.

    A request that replaces (the default) drops what older requests of the same purpose still wait for,
    and their results; exports are never dropped. A job whose process dies under it is tried once more.
    A process that dies three times in a row while starting is given up; the jobs wait for `restart`.

    All methods are for the thread this object lives in, and so are the signals; they arrive in order.

    Signals:
        worker_state_changed(str, str): "starting", "ready", "busy", "replaced" (it died: another one is
            starting) or "stopped", and the reason, which may be empty.
        job_started(object): the job, now running. Comes again if the job is tried once more.
        job_progressed(object, str, float): the job, the stage that begins, the fraction done.
        job_done(object, object): the job and its result.
        job_failed(object, str, str): the job, a text fit for the user, details (a traceback; empty for
            what is expected to go wrong).
        job_cancelled(object): the job, running or waiting, that `cancel` ended.
        queue_changed(int): number of jobs whose result is still to come.
    """

    worker_state_changed = Signal(str, str)
    job_started = Signal(object)
    job_progressed = Signal(object, str, float)
    job_done = Signal(object, object)
    job_failed = Signal(object, str, str)
    job_cancelled = Signal(object)
    queue_changed = Signal(int)
    _event_waits = Signal()

    def __init__(
        self,
        parent: QObject | None = None,
        *,
        warm_up: Callable[[], None] = jobs.warm_up,
        log: str | None = None,
        grace_s: float = 0.5,
    ) -> None:
        """Make a runner without a process; `start` or the first `submit` gives it one.

        Parameters
        ----------
        parent : QObject, optional
        warm_up : callable
            A picklable function that a new process calls before its first job.
        log : str, optional
            File for what the CAD process prints.
        grace_s : float
            How much longer a superseded job may run before its process is replaced.
        """
        super().__init__(parent)
        self._thread = JobThread(self._post, functools.partial(start_worker, warm_up, log), grace_s)
        self._events: deque[Event] = deque()
        self._requests = itertools.count(1)
        self._oldest_wanted: dict[str, int] = {}
        self._closed = False
        self._posting = threading.Lock()
        self._event_waits.connect(self._deliver, Qt.ConnectionType.QueuedConnection)

    @property
    def process_id(self) -> int:
        """Number of the running process; 0 when there is none."""
        return self._thread.process_id

    @Slot()
    def start(self) -> None:
        """Start the process, once."""
        if not self._closed and self._thread.ident is None:
            self._thread.start()

    def submit(self, requested: Sequence[Job], replace: bool = True) -> None:
        """Have the jobs carried out one after the other; with ``replace`` instead of older requests' jobs."""
        if self._closed:
            return
        request = next(self._requests)
        if replace:
            self._oldest_wanted.update({job.purpose: request for job in requested if job.purpose != "export"})
        self._thread.submit(tuple(requested), request, replace)
        self.start()

    @Slot()
    def cancel(self) -> None:
        """End the running job at once and forget those that wait, exports included."""
        self._thread.cancel()

    def give_up(self, text: str) -> None:
        """Let the running job fail with a text fit for the user, and start a new process for those that wait."""
        self._thread.give_up(text)

    @Slot()
    def restart(self) -> None:
        """Start a new process, after the old one was given up or hangs; its job begins again."""
        self._thread.restart()

    @Slot()
    def close(self) -> None:
        """End the process and wait for that, 2.4 s at most; no signal comes afterwards."""
        if self._closed:
            return
        with self._posting:
            self._closed = True
            self._events.clear()
        if self._thread.ident is None:
            return
        self._thread.close()
        self._thread.join(CLOSING_TIME)
        if self._thread.is_alive():
            self._thread.kill()
            self._thread.join(LAST_MOMENT)

    def _post(self, event: Event) -> None:
        """Hand an event over to the thread this object lives in; that may have gone when the job thread ends late."""
        with self._posting:
            if not self._closed:
                self._events.append(event)
                self._event_waits.emit()

    @Slot()
    def _deliver(self) -> None:
        if self._closed or not self._events:
            return
        match self._events.popleft():
            case StateChanged(state, reason):
                self.worker_state_changed.emit(state, reason)
            case QueueChanged(count):
                self.queue_changed.emit(count)
            case event if event.ticket.request < self._oldest_wanted.get(event.ticket.job.purpose, 0):
                pass  # superseded while this event was on its way
            case JobStarted(ticket):
                self.job_started.emit(ticket.job)
            case JobProgressed(ticket, stage, fraction):
                self.job_progressed.emit(ticket.job, stage, fraction)
            case JobDone(ticket, result):
                self.job_done.emit(ticket.job, result)
            case JobFailed(ticket, text, details):
                self.job_failed.emit(ticket.job, text, details)
            case JobCancelled(ticket):
                self.job_cancelled.emit(ticket.job)
