"""The report in the window: sections, preview, stop, save, and what goes wrong on the way."""

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QObject, QSize, Qt, Signal
from pytestqt.qtbot import QtBot

from gearstudio.analysis.measurement import MeasuredPoints
from gearstudio.report.job import Reported, ReportJob
from ui.analysis.measurement_data import Measurement, Source
from ui.main_window import MainWindow
from ui.reporting.dialog import ReportDialog
from ui.reporting.reporting import Reporting
from ui.session import Session
from ui.solid_mode import SolidMode
from ui.theme import Theme

pytestmark = pytest.mark.ui
PNG = bytes.fromhex(
    "89504e470d0a1a0a0000000d4948445200000001000000010802000000907753de0000000c4944415478da63f8ffff3f0005fe02fe"
    "0d0a2db40000000049454e44ae426082"
)
FOUND: Any = SimpleNamespace(member="pinion", fit=(True, False))
MADE = Reported(b"%PDF-1.7 made", (PNG, PNG, PNG))


class Runner(QObject):
    """Takes jobs and answers when the test says so."""

    job_progressed = Signal(object, str, float)
    job_done = Signal(object, object)
    job_failed = Signal(object, str, str)
    job_cancelled = Signal(object)
    worker_state_changed = Signal(str, str)

    def __init__(self) -> None:
        super().__init__()
        self.jobs: list[Any] = []

    def submit(self, jobs: tuple[Any, ...]) -> None:
        self.jobs += jobs

    def cancel(self) -> None:
        self.job_cancelled.emit(self.jobs[-1])


class Desk:
    """A reporting of a window of its own with its dialog open."""

    def __init__(self, qtbot: QtBot) -> None:
        self.session, self.runner = Session(), Runner()
        self.window = MainWindow(self.session)
        qtbot.addWidget(self.window)
        self.session.load(self.session.design)
        parent = QObject(self.window)
        solid_mode = SolidMode(self.session, self.window, None, parent)  # type: ignore[arg-type]
        self.reporting = Reporting(self.session, self.window, solid_mode, parent)
        self.reporting.use_runner(self.runner)  # type: ignore[arg-type]
        self.window.show()
        self.reporting.open()
        assert self.reporting.dialog is not None
        self.dialog: ReportDialog = self.reporting.dialog

    def make(self, qtbot: QtBot) -> ReportJob:
        """Press *Update preview* and wait until the work is handed on."""
        count = len(self.runner.jobs)
        qtbot.mouseClick(self.dialog.make, Qt.MouseButton.LeftButton)
        qtbot.waitUntil(lambda: len(self.runner.jobs) > count)
        job: ReportJob = self.runner.jobs[-1]
        return job


@pytest.fixture
def desk(qtbot: QtBot, theme: Theme) -> Desk:
    return Desk(qtbot)


def test_the_sections_ticked_are_made_of_the_design_as_it_is(qtbot: QtBot, desk: Desk) -> None:
    desk.dialog._boxes["convergence"].setChecked(False)
    desk.session.edit("pair.wheel_teeth", 43)
    job = desk.make(qtbot)
    assert "convergence" not in job.sections and "design" in job.sections
    assert job.design.pair.wheel_teeth == 43 and job.preview > 0
    assert job.missing, "without views the report must say which picture is missing"
    assert desk.dialog.stop.isEnabled() and not desk.dialog.make.isEnabled() and not desk.dialog.save.isEnabled()
    desk.runner.job_done.emit(job, MADE)
    assert desk.dialog.pages.page_count == 3 and desk.dialog.save.isEnabled()
    assert not desk.dialog.trouble.isVisible()


def test_pages_of_an_earlier_design_are_said_to_be_out_of_date(qtbot: QtBot, desk: Desk) -> None:
    desk.runner.job_done.emit(desk.make(qtbot), MADE)
    desk.session.edit("pair.wheel_teeth", 44)
    assert desk.dialog.trouble.isVisible() and "Out of date" in desk.dialog.trouble.text()
    job = desk.make(qtbot)
    assert not desk.dialog.trouble.isVisible()
    desk.session.edit("pair.wheel_teeth", 45)
    desk.runner.job_done.emit(job, MADE)
    assert "Out of date" in desk.dialog.trouble.text(), "the design was changed while the report was being made"


def test_a_failure_stays_in_sight_and_the_last_pages_too(qtbot: QtBot, desk: Desk) -> None:
    desk.runner.job_done.emit(desk.make(qtbot), MADE)
    desk.runner.job_failed.emit(desk.make(qtbot), "no room for the teeth", "")
    assert "no room for the teeth" in desk.dialog.trouble.text() and desk.dialog.trouble.isVisible()
    assert desk.dialog.pages.page_count == 3 and desk.dialog.make.isEnabled()


def test_the_language_chosen_goes_with_the_job_and_warnings_are_told(qtbot: QtBot, desk: Desk) -> None:
    assert desk.dialog.language.currentData() == "en", "the window's own at first"
    desk.dialog.language.setCurrentIndex(desk.dialog.language.findData("zh"))
    job = desk.make(qtbot)
    assert job.language == "zh"
    desk.runner.job_done.emit(job, replace(MADE, warnings=("no font was found",)))
    assert desk.dialog.trouble.isVisible() and "no font" in desk.dialog.trouble.text()
    assert desk.dialog.save.isEnabled()


def test_measured_points_go_in_when_there_are_some(qtbot: QtBot, desk: Desk) -> None:
    box = desk.dialog._boxes["measurement"]
    assert not box.isEnabled() and "measurement" not in desk.make(qtbot).sections
    desk.dialog.stop.click()
    page = QObject()
    page.measurement = Measurement(  # type: ignore[attr-defined]
        Source(Path("/tmp/points.csv"), (MeasuredPoints(np.ones((3, 3))),), 1.5),
        None,
        FOUND,
        (0,),  # type: ignore[arg-type]
    )
    page.panel = FOUND  # type: ignore[attr-defined]
    desk.window.analysis.pages["measurement"] = page  # type: ignore[assignment]
    desk.reporting.open()
    assert box.isEnabled() and "points.csv" in box.toolTip()
    job = desk.make(qtbot)
    assert "measurement" in job.sections and job.measured is not None
    assert (job.measured.member, job.measured.fit, job.measured.shift) == ("pinion", (True, False), 1.5)
    del desk.window.analysis.pages["measurement"]


def test_stopping_and_closing_end_the_work(qtbot: QtBot, desk: Desk) -> None:
    job = desk.make(qtbot)
    with qtbot.waitSignal(desk.runner.job_cancelled):
        qtbot.mouseClick(desk.dialog.stop, Qt.MouseButton.LeftButton)
    assert desk.dialog.trouble.text() == "Stopped"
    desk.runner.job_done.emit(job, MADE)
    assert desk.dialog.pages.page_count == 0, "an answer that comes too late is not shown"
    desk.make(qtbot)
    with qtbot.waitSignal(desk.runner.job_cancelled):
        desk.dialog.reject()
    assert desk.reporting.dialog is None


def test_a_kernel_that_does_not_start_is_told(qtbot: QtBot, desk: Desk) -> None:
    desk.make(qtbot)
    desk.runner.worker_state_changed.emit("stopped", "it failed to start 3 times")
    assert "failed to start" in desk.dialog.trouble.text() and desk.dialog.make.isEnabled()


def test_stopping_while_pictures_are_taken_hands_nothing_on(qtbot: QtBot, desk: Desk) -> None:
    desk.dialog.make.click()
    desk.dialog.stop.click()
    qtbot.wait(20)
    assert not desk.runner.jobs and desk.dialog.make.isEnabled()


def test_the_pdf_is_saved_or_the_reason_is_told(qtbot: QtBot, desk: Desk, tmp_path: Path) -> None:
    desk.runner.job_done.emit(desk.make(qtbot), MADE)
    desk.dialog.saved.emit(tmp_path / "report.pdf", MADE.pdf)
    assert (tmp_path / "report.pdf").read_bytes() == MADE.pdf
    (tmp_path / "taken.pdf").mkdir()
    desk.dialog.saved.emit(tmp_path / "taken.pdf", MADE.pdf)
    assert desk.dialog.trouble.isVisible() and "taken.pdf" in desk.dialog.trouble.text()
    assert desk.dialog.save.isEnabled(), "the report is still there to be saved elsewhere"


def test_nothing_ticked_nothing_to_make_and_choices_are_kept(qtbot: QtBot, desk: Desk) -> None:
    for box in desk.dialog._boxes.values():
        box.setChecked(False)
    assert not desk.dialog.make.isEnabled()
    desk.dialog._boxes["sheet"].setChecked(True)
    desk.dialog.reject()
    desk.reporting.open()
    assert desk.reporting.dialog is not None and desk.reporting.dialog.sections == ("sheet",)


def test_the_dialog_fits_a_small_screen(desk: Desk) -> None:
    assert desk.dialog.minimumSizeHint().width() <= QSize(1280, 680).width()
    assert desk.dialog.minimumSizeHint().height() <= QSize(1280, 680).height()


def test_another_window_goes_on_with_the_report_and_the_old_one_stops_nothing(qtbot: QtBot, desk: Desk) -> None:
    desk.dialog._boxes["convergence"].setChecked(False)
    desk.dialog.member.setCurrentIndex(0)
    desk.dialog.language.setCurrentIndex(desk.dialog.language.findData("zh"))
    desk.runner.job_done.emit(desk.make(qtbot), replace(MADE, warnings=("no font was found",)))
    told = desk.dialog.trouble.text()
    job = desk.make(qtbot)
    desk.runner.job_progressed.emit(job, "theory", 0.4)
    work = desk.reporting.keep_state()
    assert work is not None and work.wanted is None and work.job is job

    next_one = Desk(qtbot)
    next_one.runner.jobs.append(job)
    desk.reporting.let_go()
    with qtbot.assertNotEmitted(desk.runner.job_cancelled):
        desk.dialog.reject()
    dialog = next_one.reporting.take_state(work)
    assert dialog.pages.page_count == 3 and dialog.member.currentData() == "pinion"
    assert (
        dialog.language.currentData() == "zh" and "convergence" not in dialog.sections and "design" in dialog.sections
    )
    assert dialog.stop.isEnabled() and not dialog.make.isEnabled() and dialog.progress.value() == 40
    next_one.runner.job_done.emit(job, replace(MADE, warnings=("no font was found",)))
    assert dialog.trouble.text() == told and dialog.save.isEnabled() and not dialog.stop.isEnabled()
    at_rest = next_one.reporting.keep_state()
    assert at_rest is not None and at_rest.state.stage is None and at_rest.job is None
    dialog.reject()
    assert next_one.reporting.keep_state() is None


def test_a_report_whose_pictures_are_being_taken_begins_anew_in_the_next_window(qtbot: QtBot, desk: Desk) -> None:
    qtbot.mouseClick(desk.dialog.make, Qt.MouseButton.LeftButton)
    work = desk.reporting.keep_state()
    assert work is not None and work.job is None and work.wanted is not None and not desk.runner.jobs
    desk.reporting.let_go()
    next_one = Desk(qtbot)
    next_one.reporting.take_state(work)
    qtbot.waitUntil(lambda: len(next_one.runner.jobs) == 1)
    assert next_one.runner.jobs[0].sections == work.wanted[0] and not desk.runner.jobs


def test_what_went_wrong_is_told_in_the_next_window_too(qtbot: QtBot, desk: Desk) -> None:
    desk.runner.job_failed.emit(desk.make(qtbot), "no room for the teeth", "")
    work = desk.reporting.keep_state()
    assert work is not None
    dialog = Desk(qtbot).reporting.take_state(work)
    assert "no room for the teeth" in dialog.trouble.text() and dialog.trouble.isVisible() and dialog.make.isEnabled()
