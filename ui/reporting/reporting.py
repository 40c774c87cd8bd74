"""Makes reports for the window: opens the dialog, has the CAD process do the work, writes the file."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from PySide6.QtCore import QObject

from gearstudio.errors import FileError
from gearstudio.words import ENGLISH
from ui.reporting.dialog import ReportDialog, ReportState
from ui.reporting.pictures import ReportPictures
from ui.words import told, tr

if TYPE_CHECKING:
    from gearstudio.catalogue import MemberName
    from gearstudio.jobs import Job
    from gearstudio.report.job import ReportJob
    from gearstudio.report.measuring import MeasuredFile
    from ui.analysis.measurement_data import Measurement
    from ui.main_window import MainWindow
    from ui.runner import JobRunner
    from ui.session import Session
    from ui.solid_mode import SolidMode

_PREVIEW_DPI = 80


@dataclass(frozen=True)
class ReportWork:
    """Of a dialog that is open.

    Attributes
    ----------
    job : ReportJob, optional
        That the CAD process is at or will be.
    wanted : tuple, optional
        Sections, member and language of a report whose pictures are still being taken.
    """

    state: ReportState
    job: ReportJob | None
    wanted: tuple[tuple[str, ...], Any, str] | None


class Reporting(QObject):
    """The report of a session's design."""

    def __init__(self, session: Session, window: MainWindow, solid_mode: SolidMode, parent: QObject) -> None:
        super().__init__(parent)
        self._session, self._window = session, window
        self._pictures = ReportPictures(session, window, solid_mode, self)
        self._pictures.taken.connect(self._submit)
        self._wanted: tuple[tuple[str, ...], Any] = ((), "wheel")
        self._language = ENGLISH
        session.design_changed.connect(self._on_design_changed)
        window.analysis.page_made.connect(self._on_page_made)
        self._runner: JobRunner | None = None
        self._job: ReportJob | None = None
        self.dialog: ReportDialog | None = None

    def use_runner(self, runner: JobRunner) -> None:
        """Work through this runner from now on."""
        self._runner = runner
        runner.job_progressed.connect(self._on_progressed)
        runner.job_done.connect(self._on_done)
        runner.job_failed.connect(self._on_failed)
        runner.job_cancelled.connect(self._on_cancelled)
        runner.worker_state_changed.connect(self._on_worker_state_changed)

    def open(self) -> None:
        """Show the dialog."""
        if self.dialog is None:
            folder = str(self._session.path.parent) if self._session.path is not None else str(Path.home())
            self.dialog = ReportDialog(
                self._session.design.name or "report", self._session.member, folder, self._window
            )
            self.dialog.wanted.connect(self.make)
            self.dialog.cancelled.connect(self._cancel)
            self.dialog.saved.connect(self._save)
            self.dialog.finished.connect(self._on_closed)
        self._show_measured()
        self.dialog.show()
        self.dialog.raise_()

    def keep_state(self) -> ReportWork | None:
        """What another window needs to go on with the report; None while there is no dialog."""
        if self.dialog is None or not self.dialog.isVisible():
            return None
        painting = (*self._wanted, self._language) if self._pictures.at_work else None
        return ReportWork(self.dialog.keep_state(), self._job, painting)

    def let_go(self) -> None:
        """Another window goes on with the report: closing the dialog stops nothing any more."""
        self._pictures.stop()
        self._job = None
        if self.dialog is not None:
            self.dialog.cancelled.disconnect(self._cancel)

    def take_state(self, work: ReportWork) -> ReportDialog:
        """Go on where another window was; pictures are taken of this one."""
        self.open()
        assert self.dialog is not None
        self.dialog.take_state(work.state)
        self._job = work.job
        if work.wanted is not None:
            self.make(*work.wanted)
        return self.dialog

    def make(self, sections: tuple[str, ...], member: Any, language: str) -> None:
        """Have the report of the design as it is now made."""
        self._session.settle()
        if self._runner is None or self.dialog is None:
            return
        self._wanted, self._language = (sections, member), language
        if "pictures" in sections:
            self.dialog.show_progress(tr("taking pictures of the views"), 0.0)
            self._pictures.take(language)
        else:
            self._submit((), ())

    def close(self) -> None:
        """Give up what is being made."""
        self._pictures.stop()

    def _submit(self, pictures: tuple[tuple[str, bytes], ...], missing: tuple[str, ...]) -> None:
        if self._runner is None or self.dialog is None:
            return
        from gearstudio.report.job import ReportJob

        design, path = self._session.design, self._session.path
        folder = None if path is None else path.parent
        self._job = ReportJob(
            design, *self._wanted, pictures, _PREVIEW_DPI, folder, missing, self._language, self._measured()
        )
        self.dialog.show_progress(tr("waiting for the CAD process"), 0.0)
        self._runner.submit((self._job,))

    def _measured(self) -> MeasuredFile | None:
        """The points on the page of measured points, as they were read."""
        from gearstudio.report.measuring import MeasuredFile

        page: Any = self._window.analysis.pages.get("measurement")
        found: Measurement | None = None if page is None else page.measurement
        if found is None:
            return None
        source, member = found.source, cast("MemberName", found.result.member)
        return MeasuredFile(source.path.name, member, source.chunks or (), page.panel.fit, source.shift, source.faces)

    def _show_measured(self) -> None:
        if self.dialog is not None:
            measured = self._measured()
            self.dialog.show_measured(measured.name if measured is not None else "")

    def _on_page_made(self, page: Any) -> None:
        if hasattr(page, "measurement"):
            page.work.measured.connect(lambda *_: self._show_measured())
            page.work.refused.connect(lambda _text: self._show_measured())

    def _cancel(self) -> None:
        self._pictures.stop()
        if self._runner is not None and self._job is not None:
            self._runner.cancel()
        elif self.dialog is not None:
            self.dialog.show_failure(tr("Stopped"))

    def _save(self, path: Path, pdf: bytes) -> None:
        from gearstudio.files import write_bytes

        messages = self._window.messages
        try:
            write_bytes(path, pdf)
        except FileError as error:
            if self.dialog is not None:
                self.dialog.show_failure(told(error))
            return
        messages.show_message(
            "info", tr("Wrote {name} to {folder}", name=path.name, folder=path.parent), topic="report"
        )
        if self.dialog is not None:
            self.dialog.stage.setText(tr("Saved {path}", path=path))

    def _on_progressed(self, job: Job, stage: str, fraction: float) -> None:
        if job is self._job and self.dialog is not None:
            self.dialog.show_progress(stage, fraction)

    def _on_done(self, job: Job, result: Any) -> None:
        if job is self._job and self._job is not None and self.dialog is not None:
            made, self._job = self._job.design, None
            self.dialog.show_report(result)
            if made != self._session.design:
                self.dialog.show_stale()

    def _on_failed(self, job: Job, text: str, _details: str) -> None:
        if job is self._job and self.dialog is not None:
            self._job = None
            self.dialog.show_failure(tr("The report could not be made: {reason}", reason=told(text)))

    def _on_cancelled(self, job: Job) -> None:
        if job is self._job and self.dialog is not None:
            self._job = None
            self.dialog.show_failure(tr("Stopped"))

    def _on_worker_state_changed(self, state: str, reason: str) -> None:
        if state == "stopped" and self._job is not None and self.dialog is not None:
            self._job = None
            self.dialog.show_failure(
                tr("The report could not be made: the CAD kernel stopped. {reason}", reason=reason)
            )

    def _on_design_changed(self, _design: object) -> None:
        if self.dialog is not None:
            self.dialog.show_stale()

    def _on_closed(self) -> None:
        self._pictures.stop()
        if self.dialog is not None:
            self.dialog.deleteLater()
        self.dialog = None
