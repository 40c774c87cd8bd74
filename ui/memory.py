"""How much memory processes take, and a CAD process that is replaced when it takes too much."""

from __future__ import annotations

import logging
import subprocess
import sys
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QSettings, QTimer, Signal

from ui.words import tr

if TYPE_CHECKING:
    from ui.runner import JobRunner

LIMIT_KEY = "worker/memory_limit_mb"
DEFAULT_LIMIT_MB = 4000
LEAST_LIMIT_MB = 1000
LOOK_EVERY_MS = 5000
LOOK_OFTEN_MS = 500
"""While it works it may grow fast."""
log = logging.getLogger(__name__)


def resident_megabytes(process_id: int) -> float:
    """Memory that a process has in use; 0 where that cannot be told."""
    try:
        if sys.platform == "linux":
            with open(f"/proc/{process_id}/status", encoding="ascii") as status:
                line = next((line for line in status if line.startswith("VmRSS:")), "VmRSS: 0")
            return int(line.split()[1]) / 1024
        if sys.platform == "darwin":
            said = subprocess.run(
                ["ps", "-o", "rss=", "-p", str(process_id)], capture_output=True, text=True, timeout=2, check=True
            )
            return int(said.stdout) / 1024
    except (OSError, ValueError, subprocess.SubprocessError):
        pass
    return 0.0


def memory_limit(settings: QSettings | None) -> int:
    """The chosen limit of the CAD process in MB; 0 for none."""
    value = settings.value(LIMIT_KEY, DEFAULT_LIMIT_MB) if settings is not None else DEFAULT_LIMIT_MB
    try:
        chosen = int(value)  # type: ignore[call-overload]
    except (TypeError, ValueError):
        chosen = DEFAULT_LIMIT_MB
    return max(chosen, LEAST_LIMIT_MB) if chosen > 0 else 0


class MemoryGuard(QObject):
    """Replaces the CAD process when it is above the limit; its job begins again in a fresh one.

    A job that goes beyond the limit in a process of its own fails: it would do so again.

    Signals
    -------
    replaced(float)
        The megabytes that it had; nothing is lost.
    """

    replaced = Signal(float)

    def __init__(self, limit_mb: int = DEFAULT_LIMIT_MB, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._limit_mb = limit_mb
        self._runner: JobRunner | None = None
        self._waiting = 0
        self._begun = (0, 0)
        self._timer = QTimer(self, interval=LOOK_EVERY_MS)
        self._timer.timeout.connect(self.look)

    def use(self, runner: JobRunner) -> None:
        """Watch the process of this runner."""
        self._runner = runner
        runner.queue_changed.connect(self._on_queue_changed)
        runner.job_started.connect(self._on_job_started)
        self._timer.start()

    def set_limit(self, limit_mb: int) -> None:
        """Take another limit, 0 for none, at once."""
        self._limit_mb = limit_mb
        self.look()

    def look(self) -> None:
        """Measure, and act on it."""
        runner = self._runner
        if runner is None or not self._limit_mb or not runner.process_id:
            return
        megabytes = resident_megabytes(runner.process_id)
        if megabytes <= self._limit_mb:
            return
        log.warning("the CAD process has %.0f MB, more than %d MB, and is replaced", megabytes, self._limit_mb)
        if self._waiting and self._begun == (runner.process_id, 1):
            runner.give_up(
                tr(
                    "this takes more memory than the {limit} MB that the CAD kernel may have; ask for less, or raise "
                    "the limit in the preferences",
                    limit=self._limit_mb,
                )
            )
        else:
            runner.restart()
            self.replaced.emit(megabytes)

    def stop(self) -> None:
        """Watch no more."""
        self._timer.stop()
        self._runner = None

    def _on_queue_changed(self, count: int) -> None:
        self._waiting = count
        self._timer.setInterval(LOOK_OFTEN_MS if count else LOOK_EVERY_MS)

    def _on_job_started(self) -> None:
        """Count the jobs that a process has begun."""
        number = self._runner.process_id if self._runner is not None else 0
        self._begun = (number, self._begun[1] + 1 if self._begun[0] == number else 1)
