"""When the CAD process is asked for what."""

from __future__ import annotations

import pytest

from gearstudio.design import Design
from gearstudio.jobs import ExportJob
from tests.ui.stand_ins import FakeRunner
from ui.builds import EDIT_PAUSE_MS, Builds
from ui.session import Key, Session

TEETH = "pair.pinion_teeth"


@pytest.fixture
def session(qapp) -> Session:
    made = Session()
    made.load(Design())
    return made


@pytest.fixture
def runner() -> FakeRunner:
    return FakeRunner()


@pytest.fixture
def builds(session: Session, runner: FakeRunner) -> Builds:
    made = Builds(session)
    made.use(runner)
    session.design_changed.connect(made.build_soon)
    session.selection_changed.connect(made.build_missing)
    return made


def keys(runner: FakeRunner) -> list[Key]:
    return [Key(job.member, job.method, job.variant) for job in runner.jobs]


def test_the_visible_ones_come_first_and_the_rest_follows(session, runner, builds) -> None:
    session.select(method="point_cloud", variant="published")
    assert keys(runner)[0] == Key("wheel", "point_cloud", "published")
    assert set(keys(runner)) == set(session.missing_keys()) and len(keys(runner)) == 6


def test_what_is_on_its_way_is_not_asked_for_again(session, runner, builds) -> None:
    builds.build_missing()
    runner.finish(runner.jobs[0])
    session.select(variant="published")
    session.select(method="rotating_line")
    builds.build_missing()
    assert len(runner.requests) == 1


def test_another_member_is_asked_for_at_once(session, runner, builds) -> None:
    builds.build_missing()
    session.select(member="pinion")
    assert len(runner.requests) == 2 and {key.member for key in keys(runner)} == {"pinion"}


def test_the_first_edit_builds_at_once_and_a_burst_when_it_has_ended(session, runner, builds, qtbot) -> None:
    builds.build_missing()
    runner.finish_all()
    session.edit(TEETH, 18)
    assert len(runner.requests) == 2 and runner.jobs[0].design == session.design
    for teeth in range(19, 29):
        session.edit(TEETH, teeth)
        qtbot.wait(1)
    assert len(runner.requests) == 2
    qtbot.waitUntil(lambda: len(runner.requests) == 3, timeout=5 * EDIT_PAUSE_MS)
    assert runner.jobs[0].design.pair.pinion_teeth == 28
    qtbot.wait(2 * EDIT_PAUSE_MS)
    assert len(runner.requests) == 3


def test_results_reach_the_session(session, runner, builds) -> None:
    told = []
    builds.work_changed.connect(lambda text, fraction: told.append((text, fraction)))
    builds.build_missing()
    runner.finish_all(0.5)
    assert session.missing_keys() == () and session.building is None
    assert told[0] == ("Building Rotating line, optimised (1 of 6)", 0.0)
    assert told[-2][0] == "Building Point cloud, published (6 of 6)" and told[-2][1] == pytest.approx(5 / 6)
    assert told[-1] == (None, 1.0)


def test_failures_and_cancelled_jobs_are_noted_and_not_repeated(session, runner, builds) -> None:
    builds.build_missing()
    first, second, *_ = runner.jobs
    runner.job_failed.emit(first, "the sections cross", "")
    runner.job_cancelled.emit(second)
    assert session.failures[keys(runner)[0]].message == "The sections cross"
    assert "Cancelled" in session.failures[keys(runner)[1]].message
    builds.build_missing()
    assert len(runner.requests) == 1


def test_rebuilding_asks_for_everything(session, runner, builds) -> None:
    builds.build_missing()
    runner.finish_all()
    builds.rebuild()
    assert len(runner.requests) == 2 and len(runner.jobs) == 6


def test_other_jobs_leave_the_results_alone(session, runner, builds, tmp_path) -> None:
    job = ExportJob(session.design, "wheel", "flanks", "point_cloud", "published", ("step",), tmp_path)
    builds.build_missing()
    runner.finish_all()
    before = dict(session.results), session.missing_keys()
    runner.job_done.emit(job, ())
    runner.job_failed.emit(job, "disk full", "")
    assert (session.results, session.missing_keys()) == before and not session.failures
