"""What the CAD process is asked to build, and when: after the last edit, what is seen first."""

from __future__ import annotations

import logging
from typing import TYPE_CHECKING

from PySide6.QtCore import QElapsedTimer, QObject, Signal, Slot

from ui.debounce import Debounce
from ui.formatting import METHOD_TITLES, VARIANT_TITLES
from ui.session import Failure, Key, Session
from ui.words import inline, told, tr

if TYPE_CHECKING:
    from gearstudio.jobs import BuildJob, Job
    from gearstudio.results import VariantResult
    from ui.runner import JobRunner

EDIT_PAUSE_MS = 200
log = logging.getLogger(__name__)


class Builds(QObject):
    """Keeps the session's results up to date with its design, through a runner.

    Signals
    -------
    work_changed(object, float)
        What is being done, as text, or None; and the fraction of the whole request that is done.
    """

    work_changed = Signal(object, float)

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._runner: JobRunner | None = None
        self._awaited: dict[Key, BuildJob] = {}
        self._requested = 0
        self._at: tuple[Job, float] | None = None
        self._last_edit = QElapsedTimer()
        self.pause = Debounce(EDIT_PAUSE_MS, self)
        self.pause.settled.connect(self.build_missing)

    def use(self, runner: JobRunner) -> None:
        """Work through this runner from now on."""
        if runner is self._runner:
            return
        self._runner = runner
        runner.job_started.connect(self._on_started)
        runner.job_progressed.connect(self._on_progressed)
        runner.job_done.connect(self._on_done)
        runner.job_failed.connect(self._on_failed)
        runner.job_cancelled.connect(self._on_cancelled)
        runner.queue_changed.connect(self._on_queue_changed)

    @Slot()
    def build_soon(self) -> None:
        """The design has changed: build at once after a time of rest, else when the edits come to rest."""
        if not self._awaited and self._last_edit.hasExpired(EDIT_PAUSE_MS):
            self.build_missing()
        self._last_edit.start()
        self.pause.push()

    @Slot()
    def build_missing(self) -> None:
        """Ask for everything that the chosen member lacks, unless it is on its way already."""
        if self._runner is None or self._session.pair is None:
            return
        from gearstudio.jobs import BuildJob

        design = self._session.design
        missing = self._session.missing_keys()
        if not missing or all(key in self._awaited and self._awaited[key].design == design for key in missing):
            return
        jobs = {key: BuildJob(design, *key) for key in missing}
        self._awaited, self._requested = jobs, len(jobs)
        self._session.put_building(None)
        self._runner.submit(tuple(jobs.values()))

    @Slot()
    def rebuild(self) -> None:
        """Build everything again, as if nothing had been built."""
        self._awaited.clear()
        self._session.forget_results()
        self.build_missing()

    def announce(self) -> None:
        """Say once more what is being done, for a window that has just been made."""
        if self._at is not None:
            self._announce(*self._at)

    def _on_started(self, job: Job) -> None:
        self._session.put_building(self._key(job))
        self._announce(job, 0.0)

    def _on_progressed(self, job: Job, stage: str, fraction: float) -> None:
        self._announce(job, fraction)

    def _on_done(self, job: Job, result: VariantResult) -> None:
        key = self._key(job)
        if key is not None:
            self._awaited.pop(key, None)
            self._session.put_result(job.design, result)

    def _on_failed(self, job: Job, text: str, details: str) -> None:
        if details:
            log.error("%s failed: %s\n%s", job.label, text, details)
        key = self._key(job)
        if key is not None:
            self._awaited.pop(key, None)
            words = _capital(text.removeprefix(f"{key.method}: "))
            self._session.put_failure(job.design, key, Failure(words, details))

    def _on_cancelled(self, job: Job) -> None:
        key = self._key(job)
        if key is not None:
            self._awaited.pop(key, None)
            self._session.put_cancelled(job.design, key)

    def _on_queue_changed(self, count: int) -> None:
        if count == 0:
            self._at = None
            self.work_changed.emit(None, 1.0)

    def _announce(self, job: Job, fraction: float) -> None:
        self._at = (job, fraction)
        key = self._key(job)
        if key is None:
            solid = tr("Building the {member} as a solid", member=tr(getattr(job, "member", "gear")))
            text = {"solid": solid, "export": tr("Exporting {label}", label=told(job.label))}.get(
                job.purpose, _capital(told(job.label))
            )
            self.work_changed.emit(text, fraction)
            return
        done = self._requested - len(self._awaited)
        text = tr(
            "Building {method}, {variant}",
            method=tr(METHOD_TITLES[key.method]),
            variant=inline(VARIANT_TITLES[key.variant]),
        )
        self.work_changed.emit(
            tr("{text} ({done} of {all})", text=text, done=done + 1, all=self._requested),
            (done + fraction) / max(self._requested, 1),
        )

    def _key(self, job: Job) -> Key | None:
        """The result that a job makes; None for a job that is no build."""
        if job.purpose != "build":
            return None
        return Key(job.member, job.method, job.variant)


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]
