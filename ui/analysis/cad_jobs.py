"""Jobs that pages of the analysis have carried out in the CAD process."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

if TYPE_CHECKING:
    from gearstudio.jobs import Job
    from ui.runner import JobRunner

PURPOSES = ("sample", "study")


class CadJobs(QObject):
    """A page's door to the runner; jobs wait until there is one.

    Signals
    -------
    progressed(object, str, float)
        Job, stage, and the part of the job done.
    done(object, object)
        Job and result.
    failed(object, str, str)
        Job, a line for the user, and the traceback (empty for what was to be expected).
    cancelled(object)
    """

    progressed = Signal(object, str, float)
    done = Signal(object, object)
    failed = Signal(object, str, str)
    cancelled = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._runner: JobRunner | None = None
        self._waiting: dict[str, Job] = {}

    def use_runner(self, runner: JobRunner) -> None:
        """The CAD process can be started."""
        self._runner = runner
        runner.job_progressed.connect(self._on_progressed)
        runner.job_done.connect(self._on_done)
        runner.job_failed.connect(self._on_failed)
        runner.job_cancelled.connect(self._on_cancelled)
        waiting, self._waiting = self._waiting, {}
        for job in waiting.values():
            runner.submit((job,))

    def submit(self, job: Job) -> None:
        """Have a job carried out in place of an older one of its purpose."""
        if self._runner is None:
            self._waiting[job.purpose] = job
        else:
            self._runner.submit((job,))

    def cancel(self) -> None:
        """End the job that runs at once, whatever it is."""
        self._waiting.clear()
        if self._runner is not None:
            self._runner.cancel()

    def _on_progressed(self, job: Job, stage: str, fraction: float) -> None:
        if job.purpose in PURPOSES:
            self.progressed.emit(job, stage, fraction)

    def _on_done(self, job: Job, result: object) -> None:
        if job.purpose in PURPOSES:
            self.done.emit(job, result)

    def _on_failed(self, job: Job, text: str, details: str) -> None:
        if job.purpose in PURPOSES:
            self.failed.emit(job, text, details)

    def _on_cancelled(self, job: Job) -> None:
        if job.purpose in PURPOSES:
            self.cancelled.emit(job)
