"""The convergence study of the charts page: its choices, and one small job after the other in the CAD process."""

from __future__ import annotations

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtWidgets import QComboBox, QProgressBar, QPushButton, QWidget

from gearstudio.analysis.convergence import DEFAULT_COUNTS, ConvergencePoint, ConvergenceStudy, studies_of
from gearstudio.catalogue import METHOD_IDS
from gearstudio.design import Design
from gearstudio.jobs import Job, StudyJob
from ui.analysis.cad_jobs import CadJobs
from ui.analysis.convergence_chart import EFFORTS, SIZES, convergence_chart, summary
from ui.charts.records import ChartData
from ui.session import Session
from ui.words import tr


class ConvergencePart(QObject):
    """Runs the study and says what its chart shows.

    One job is asked for at a time, so that builds after an edit never wait for a whole study, and Cancel need not
    end the CAD process.

    Signals
    -------
    changed()
        Another point, or another choice of axes.
    """

    changed = Signal()

    def __init__(self, jobs: CadJobs, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self._design: Design | None = None
        self._member = "wheel"
        self._left: list[StudyJob] = []
        self._running: StudyJob | None = None
        self.found: list[tuple[str, ConvergencePoint]] = []
        self.failures = 0
        self.effort, self.size = _choice(EFFORTS, tr("Effort")), _choice(SIZES, tr("Against the effort"))
        self.run = QPushButton(tr("Run"))
        self.run.setToolTip(tr("Build each method with growing effort; the design may be edited meanwhile"))
        self.bar = QProgressBar(maximum=len(METHOD_IDS) * len(DEFAULT_COUNTS), textVisible=False)
        self.bar.setFixedWidth(90)
        self.bar.setAccessibleName(tr("Progress of the study"))
        self.run.clicked.connect(self.toggle)
        for combo in (self.effort, self.size):
            combo.activated.connect(lambda _index: self.changed.emit())
        jobs.done.connect(self._on_done)
        jobs.failed.connect(lambda job, _text, _details: self._on_failed(job))
        jobs.cancelled.connect(lambda job: job == self._running and self.stop())
        self._show()

    @property
    def controls(self) -> tuple[QWidget, ...]:
        """For the head of the chart."""
        return self.size, self.effort, self.run, self.bar

    @property
    def running(self) -> bool:
        """Whether a study is being made."""
        return self._running is not None

    @property
    def studies(self) -> dict[str, ConvergenceStudy]:
        """What was found so far."""
        return studies_of(self.found)

    @property
    def chart(self) -> ChartData:
        """What the chart shows."""
        tolerance = self._design.methods.tolerance_um if self._design is not None else 1.0
        return convergence_chart(
            self.studies, self.effort.currentData(), self.size.currentData(), self._member, tolerance
        )

    @property
    def hint(self) -> str:
        """At which effort each method reaches the tolerance."""
        if self._design is None or self.running:
            return ""
        failed = tr("{count} constructions failed. ", count=self.failures) if self.failures else ""
        return failed + summary(self.studies, self._design.methods.tolerance_um)

    def show_session(self, session: Session) -> None:
        """Forget the study of another design or member."""
        if (session.design, session.member) != (self._design, self._member):
            self._design, self._member = session.design, session.member
            self.found, self.failures = [], 0
            self.stop()

    def keep_state(self) -> object:
        """The study as far as it is, for `take_state`."""
        return self._design, self._member, self.found, self.failures, self._left, self._running

    def take_state(self, state: object) -> None:
        """Go on with the study of another window."""
        if isinstance(state, tuple):
            self._design, self._member, self.found, self.failures, self._left, self._running = state
            self._show()

    def toggle(self) -> None:
        """Start the study, or end it."""
        if self.running:
            self.stop()
        else:
            self.start()

    def start(self) -> None:
        """Study the design anew, all methods from coarse to fine."""
        if self._design is None:
            return
        self.found, self.failures = [], 0
        self._left = [
            StudyJob(self._design, self._member, method, count) for count in DEFAULT_COUNTS for method in METHOD_IDS
        ]
        self._next()

    def stop(self) -> None:
        """Ask for no more."""
        self._left, self._running = [], None
        self._show()

    def _next(self) -> None:
        self._running = self._left.pop(0) if self._left else None
        if self._running is not None:
            self._jobs.submit(self._running)
        self._show()

    def _on_done(self, job: Job, point: ConvergencePoint) -> None:
        if self._running is not None and job == self._running:
            self.found.append((self._running.method, point))
            self._next()

    def _on_failed(self, job: Job) -> None:
        if self._running is not None and job == self._running:
            self.failures += 1
            self._next()

    def _show(self) -> None:
        self.run.setText(tr("Cancel") if self.running else tr("Run"))
        self.bar.setValue(len(self.found) + self.failures)
        self.bar.setEnabled(self.running)
        self.changed.emit()


def _choice(choices: tuple[tuple[str, str, str], ...], name: str) -> QComboBox:
    combo = QComboBox()
    for identifier, title, tip in choices:
        combo.addItem(tr(title), identifier)
        combo.setItemData(combo.count() - 1, tr(tip), Qt.ItemDataRole.ToolTipRole)
    combo.setToolTip(name)
    combo.setAccessibleName(name)
    return combo
