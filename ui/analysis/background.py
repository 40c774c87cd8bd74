"""Work with arrays in one thread: of the requests that wait, only the newest is carried out."""

from __future__ import annotations

import logging
import sys
import threading
import traceback
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, Signal

from gearstudio.errors import GearStudioError

Work = Callable[[], Any]
PATIENCE_S = 1.0
SWITCH_S = 0.0005
"""How long a thread may keep the interpreter while another waits; the window answers at once also while this works."""
log = logging.getLogger(__name__)


class StoppedError(GearStudioError):
    """The user has ended the work."""


class Newest(QObject):
    """Runs requests one at a time; a new one replaces the one that waits.

    The thread starts with the first request. Results arrive in the thread of this object.

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

    def __init__(self, name: str, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._name = name
        self._changed = threading.Condition()
        self._waiting: tuple[object, Work] | None = None
        self._thread: threading.Thread | None = None
        self._closed = self._running = self._unwanted = False

    @property
    def busy(self) -> bool:
        """Whether anything waits or is being done."""
        with self._changed:
            return self._running or self._waiting is not None

    def request(self, label: object, work: Work) -> None:
        """Ask for work; what still waits is forgotten."""
        with self._changed:
            if self._closed:
                return
            self._waiting = (label, work)
            if self._thread is None:
                sys.setswitchinterval(SWITCH_S)
                self._thread = threading.Thread(target=self._run, name=self._name, daemon=True)
                self._thread.start()
            self._changed.notify()

    def cancel(self) -> None:
        """Forget what waits, and end what is being done when it next asks `go_on`."""
        with self._changed:
            self._waiting, self._unwanted = None, self._running

    def go_on(self) -> None:
        """For the work to ask now and then: raises StoppedError once it is not wanted any more."""
        if self._unwanted or self._closed:
            raise StoppedError("cancelled")

    def close(self) -> None:
        """Take no more, and wait for what is being done, but not for long: it can do no more harm."""
        with self._changed:
            self._closed, self._waiting = True, None
            self._changed.notify()
        if self._thread is not None:
            self._thread.join(PATIENCE_S)

    def _run(self) -> None:
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._closed or self._waiting is not None)
                if self._waiting is None:
                    return
                (label, work), self._waiting, self._running = self._waiting, None, True
                self._unwanted = False
            self._do(label, work)
            with self._changed:
                self._running = False
                if self._closed:
                    return
                if self._waiting is None:
                    self.idle.emit()

    def _do(self, label: object, work: Work) -> None:
        try:
            result = work()
        except StoppedError:
            self._tell(self.stopped, label)
        except GearStudioError as error:
            self._tell(self.failed, label, str(error), "")
        except Exception as error:
            log.exception("%s failed", self._name)
            self._tell(self.failed, label, f"{type(error).__name__}: {error}", traceback.format_exc())
        else:
            self._tell(self.done, label, result)

    def _tell(self, signal: Any, *values: object) -> None:
        if not self._closed:
            signal.emit(*values)
