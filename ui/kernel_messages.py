"""What the user is told when the CAD process stops by itself; it stays until it is dismissed or something is newer."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from ui.formatting import MEMBER_TITLES, METHOD_TITLES, VARIANT_TITLES
from ui.job_thread import DIED
from ui.words import inline, retold, told, tr

if TYPE_CHECKING:
    from gearstudio.jobs import Job
    from ui.messages import MessageBar
    from ui.runner import JobRunner

TOPIC = "worker"


class KernelMessages(QObject):
    """Follows the CAD process and its jobs, and brings its message up to date while that is in sight."""

    def __init__(self, messages: MessageBar, parent: QObject) -> None:
        super().__init__(parent)
        self._messages = messages
        self._running: Job | None = None
        self._again: Job | None = None
        self._given_up: Job | None = None
        self._refused, self._reason = False, ""

    def use(self, runner: JobRunner) -> None:
        """Follow the jobs of this runner."""
        runner.job_started.connect(self._on_started)
        runner.job_done.connect(self._on_done)
        runner.job_failed.connect(self._on_failed)
        runner.job_cancelled.connect(self._on_cancelled)

    def show_state(self, state: str, reason: str) -> None:
        """The CAD process is in another state, one of `ui.status.WORKER_STATES`."""
        if state == "replaced":
            self._again, self._running = self._running or self._again, None
            self._reason = reason
            self._say("warning", self._being_started())
        elif state == "stopped" and reason:
            self._refused, self._reason = True, reason
            self._say("error", tr("The CAD kernel could not be started. Model ▸ Restart CAD kernel tries again."))
        elif state in ("ready", "busy"):
            if self._refused:
                self._refused, self._reason = False, ""
                self._messages.clear(TOPIC)
            elif self._reason:
                self._renew("warning", self._started())

    def _being_started(self) -> str:
        if self._given_up is not None:
            return tr(
                "The CAD kernel stopped twice at the same work ({work}), which was given up. It is started again for "
                "everything else; change something before you try this again.",
                work=work_title(self._given_up),
            )
        if self._again is not None:
            return tr(
                "The CAD kernel stopped unexpectedly ({work}). It is being started again and then tries this once "
                "more; nothing of the design is lost.",
                work=work_title(self._again),
            )
        return tr("The CAD kernel stopped unexpectedly and is being started again; nothing of the design is lost.")

    def _started(self) -> str:
        if self._given_up is not None:
            return self._being_started()
        if self._again is not None:
            return tr(
                "The CAD kernel stopped unexpectedly ({work}). It was started again and tries this once more; nothing "
                "of the design is lost.",
                work=work_title(self._again),
            )
        return tr("The CAD kernel stopped unexpectedly and was started again; nothing of the design is lost.")

    def _on_started(self, job: Job) -> None:
        again = self._again
        if again is not None and again is not job and again.purpose == job.purpose:
            self._ended(again)  # a newer request took its place
        self._running = job

    def _on_done(self, job: Job, _result: object) -> None:
        if job is self._again:
            self._again = None
            text = tr(
                "The CAD kernel stopped unexpectedly ({work}). It was started again and has done this now; nothing is "
                "lost.",
                work=work_title(job),
            )
            self._renew("info", text)
        self._running, self._given_up, self._reason = None, None, self._reason if self._again else ""

    def _on_failed(self, job: Job, text: str, _details: str) -> None:
        self._given_up = job if text.startswith(DIED) else None
        self._ended(job)

    def _on_cancelled(self, job: Job) -> None:
        self._ended(job)

    def _ended(self, job: Job) -> None:
        """A job comes to nothing; if it was to be tried again, that is no longer said."""
        self._running = None
        if job is self._again:
            self._again = None
            self._renew("warning", self._started())

    def _renew(self, severity: str, text: str) -> None:
        """Say something newer in place of what was said, unless that was dismissed or something else is in sight."""
        if self._messages.text and self._messages.topic == TOPIC and self._messages.text != text:
            self._say(severity, text)

    def _say(self, severity: str, text: str) -> None:
        self._messages.show_message(severity, text, told(self._reason), topic=TOPIC)


@retold
def work_title(job: Job) -> str:
    """What a job makes, in a few words."""
    member, method, variant = (getattr(job, name, "") for name in ("member", "method", "variant"))
    if job.purpose == "build":
        parts = (MEMBER_TITLES[member], METHOD_TITLES[method], VARIANT_TITLES[variant])
        return ", ".join((tr(parts[0]), *map(inline, parts[1:])))
    if job.purpose == "solid":
        return tr("solid of the {member}", member=inline(MEMBER_TITLES[member]))
    if job.purpose == "export":
        return tr("export of {label}", label=told(job.label))
    return str(told(job.label))
