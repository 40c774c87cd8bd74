"""Jobs that pages of the analysis have carried out in the CAD process."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, SignalInstance

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
        runner.job_progressed.connect(lambda job, *rest: self._pass(self.progressed, job, *rest))
        runner.job_done.connect(lambda job, *rest: self._pass(self.done, job, *rest))
        runner.job_failed.connect(lambda job, *rest: self._pass(self.failed, job, *rest))
        runner.job_cancelled.connect(lambda job: self._pass(self.cancelled, job))
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

    @staticmethod
    def _pass(signal: SignalInstance, job: Job, *rest: object) -> None:
        if job.purpose in PURPOSES:
            signal.emit(job, *rest)
