"""Small stand-ins: a runner that does what a test says, results of chosen size, a window without views."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from PySide6.QtCore import QObject, Signal

from gearstudio.jobs import BuildJob, Job
from gearstudio.results import Statistics, VariantResult
from ui.controller import Controller
from ui.files import Files
from ui.main_window import MainWindow
from ui.session import Key, Session


class FakeRunner(QObject):
    """Takes jobs and leaves it to the test what becomes of them."""

    worker_state_changed = Signal(str, str)
    job_started = Signal(object)
    job_progressed = Signal(object, str, float)
    job_done = Signal(object, object)
    job_failed = Signal(object, str, str)
    job_cancelled = Signal(object)
    queue_changed = Signal(int)

    def __init__(self) -> None:
        super().__init__()
        self.requests: list[tuple[Job, ...]] = []
        self.calls: list[str] = []

    @property
    def jobs(self) -> tuple[Job, ...]:
        """The newest request."""
        return self.requests[-1] if self.requests else ()

    def submit(self, jobs: Sequence[Job], replace: bool = True) -> None:
        self.requests.append(tuple(jobs))

    def finish(self, job: BuildJob, max_um: float = 1.0) -> None:
        self.job_started.emit(job)
        self.job_done.emit(job, result(Key(job.member, job.method, job.variant), max_um))

    def finish_all(self, max_um: float = 1.0) -> None:
        for job in self.jobs:
            self.finish(job, max_um)
        self.queue_changed.emit(0)

    def start(self) -> None:
        self.calls.append("start")

    def cancel(self) -> None:
        self.calls.append("cancel")

    def restart(self) -> None:
        self.calls.append("restart")

    def close(self) -> None:
        self.calls.append("close")


def result(key: Key, max_um: float = 1.0) -> VariantResult:
    """A result without flanks."""
    statistics = Statistics(max_um, max_um / 4, max_um / 3, -max_um, max_um / 2)
    return VariantResult(*key, {}, statistics, (12, 14), (3, 5), 0.0123, {"grid": [12, 14], "spacing": "uniform"})


@dataclass
class Bench:
    """A window without 3D views, with its session, controller and a fake runner."""

    session: Session = field(default_factory=Session)
    runner: FakeRunner = field(default_factory=FakeRunner)

    def __post_init__(self) -> None:
        self.window = MainWindow(self.session)
        self.files = Files(self.session, self.window)
        self.controller = Controller(self.session, self.window, self.files)
        self.window.restore_layout()
        self.controller.begin()
        self.controller.use_runner(self.runner)  # type: ignore[arg-type]

    def type_into(self, path: str, text: str) -> None:
        """Type a text over what a number or text field holds."""
        field_ = self.window.form.rows[path].field
        field_.setFocus()
        field_.selectAll()
        field_.insert(text)
        field_.textEdited.emit(text)

    def close(self) -> None:
        self.window.may_close = lambda: True
        self.window.close()
        self.window.deleteLater()
