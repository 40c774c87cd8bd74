"""Work with arrays in one thread: of the requests that wait, only the newest is carried out."""

from __future__ import annotations

import logging
import sys
import threading
import traceback
from collections import deque
from collections.abc import Callable
from typing import Any, NamedTuple

from PySide6.QtCore import QObject, Qt, Signal, Slot

from gearstudio.errors import GearStudioError

Work = Callable[[], Any]
PATIENCE_S = 1.0
SWITCH_S = 0.0005
"""How long a thread may keep the interpreter while another waits; the window answers at once also while this works."""
log = logging.getLogger(__name__)


class StoppedError(GearStudioError):
    """The user has ended the work."""


class Request(NamedTuple):
    """Work, and what its outcome is called."""

    label: object
    work: Work


class News(NamedTuple):
    """A signal to be emitted. It brings the request back, to be dropped where it was made."""

    signal: str
    values: tuple[object, ...] = ()
    request: Request | None = None


class Newest(QObject):
    """Runs requests one at a time; a new one replaces the one that waits.

    The thread starts with the first request. Results arrive in the thread of this object, and what a request holds
    is dropped there: it may be objects of Qt. No signal comes after `close`.

    Signals
    -------
    done(object, object)
        The request's label and its result.
    failed(object, str, str)
        Label, a line for the user, and the traceback (empty for what was to be expected).
    stopped(object)
        Label of a request that `cancel` ended.
    idle()
        Nothing is left to do.
    """

    done = Signal(object, object)
    failed = Signal(object, str, str)
    stopped = Signal(object)
    idle = Signal()
    _rang = Signal()

    def __init__(self, name: str, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._bench = _Bench(name, self._rang.emit)
        self._thread: threading.Thread | None = None
        self._rang.connect(self._deliver, Qt.ConnectionType.QueuedConnection)
        self.destroyed.connect(self._bench.close)

    @property
    def busy(self) -> bool:
        """Whether anything waits or is being done."""
        bench = self._bench
        with bench.changed:
            return bench.doing is not None or bench.waiting is not None

    def request(self, label: object, work: Work) -> None:
        """Ask for work; what still waits is forgotten."""
        bench = self._bench
        with bench.changed:
            if bench.closed:
                return
            bench.waiting = Request(label, work)
            bench.changed.notify()
        if self._thread is None:
            sys.setswitchinterval(SWITCH_S)
            self._thread = threading.Thread(target=bench.run, name=bench.name, daemon=True)
            self._thread.start()

    def cancel(self) -> None:
        """Forget what waits, and end what is being done when it next asks `go_on`."""
        bench = self._bench
        with bench.changed:
            bench.waiting, bench.unwanted = None, bench.doing is not None

    def go_on(self) -> None:
        """For the work to ask now and then: raises StoppedError once it is not wanted any more."""
        if self._bench.unwanted or self._bench.closed:
            raise StoppedError("cancelled")

    def close(self) -> None:
        """Take no more, and wait for what is being done, but not for long: it can do no more harm."""
        self._bench.close()
        if self._thread is not None:
            self._thread.join(PATIENCE_S)

    @Slot()
    def _deliver(self) -> None:
        news = self._bench.news.popleft()
        if not self._bench.closed:
            getattr(self, news.signal).emit(*news.values)


class _Bench:
    """What the thread works at: nothing of Qt, for it may outlive the object that it works for.

    ``doing`` and ``news`` hold what came with a request, the thread's own frames never alone.
    """

    def __init__(self, name: str, ring: Callable[[], object]) -> None:
        self.name = name
        self.changed = threading.Condition()
        self.waiting: Request | None = None
        self.doing: Request | None = None
        self.news: deque[News] = deque()
        self.closed = self.unwanted = False
        self._ring = ring

    def close(self) -> None:
        """Take and tell no more; what is being told is told first."""
        with self.changed:
            self.closed, self.waiting = True, None
            self.changed.notify()

    def run(self) -> None:
        """Carry out what comes until it is closed."""
        while self._begin():
            self.news.append(self._outcome())
            self._end()

    def _begin(self) -> bool:
        with self.changed:
            self.changed.wait_for(lambda: self.closed or self.waiting is not None)
            self.doing, self.waiting, self.unwanted = self.waiting, None, False
            return self.doing is not None

    def _end(self) -> None:
        with self.changed:
            self.doing = None
            self._tell()
            if self.waiting is None:
                self.news.append(News("idle"))
                self._tell()

    def _tell(self) -> None:
        if not self.closed:
            self._ring()

    def _outcome(self) -> News:
        request = self.doing
        assert request is not None
        try:
            return News("done", (request.label, request.work()), request)
        except StoppedError:
            return News("stopped", (request.label,), request)
        except GearStudioError as error:
            return News("failed", (request.label, str(error), ""), request)
        except Exception as error:
            log.exception("%s failed", self.name)
            words = f"{type(error).__name__}: {error}"
            return News("failed", (request.label, words, traceback.format_exc()), request)
