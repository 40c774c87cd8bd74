"""The measurement page: points in, errors and charts out; what cannot be used is told."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from gearstudio.design import Design, with_field
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.involute_flank import involute_flank
from ui.analysis.measured_scene import measured_layers
from ui.analysis.measurement_data import Source, measured
from ui.analysis.measurement_view import pitch_chart, points_table, topography
from ui.session import Session

pytestmark = pytest.mark.ui
PAIR = pair_geometry(Design())


def points(teeth: int, crown_um: float = 6.0, flanks=FLANKS) -> np.ndarray:
    """Of a turned wheel with crowned flanks, on a grid of 5 by 9."""
    member, found = PAIR.wheel, []
    u, v = np.meshgrid(np.linspace(0.06, 0.94, 5), np.linspace(0.06, 0.94, 9), indexing="ij")
    for name in flanks:
        flank = involute_flank(member, name)
        error = -crown_um * 1e-3 * (2 * v - 1) ** 2
        one = (flank.points(u, v) + error[..., None] * flank.normals(u, v)).reshape(-1, 3)
        for tooth in range(teeth):
            c, s = np.cos(tooth * member.pitch + 0.002), np.sin(tooth * member.pitch + 0.002)
            found.append(one @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]))
    return np.concatenate(found)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "wheel.csv"
    np.savetxt(path, points(4), delimiter=",", header="x,y,z", comments="")
    return path


@pytest.fixture
def page(qtbot, theme):
    from ui.analysis.measurement_page import MeasurementPage

    made = MeasurementPage()
    qtbot.addWidget(made)
    made.resize(1000, 330)
    made.show()
    session = Session()
    session.load(Design())
    made.session = session
    made.show_session(session)
    yield made
    made.close_page()


def settle(page, qtbot) -> None:
    qtbot.waitUntil(lambda: not page.work.busy, timeout=30_000)
    qtbot.wait(50)


def cells(page) -> dict[str, list[str]]:
    table = page.panel.table.table
    rows = [[table.item(r, c).text() if table.item(r, c) else "" for c in range(3)] for r in range(table.rowCount())]
    return {name: values for name, *values in rows}


def test_a_file_is_measured_and_its_errors_are_named(page, qtbot, file: Path) -> None:
    page.open_path(file)
    settle(page, qtbot)
    shown = cells(page)
    assert shown["Points"][0] == "360" and shown["Teeth"][0] == "4 of 40"
    assert [float(text) for text in shown["Lengthwise crown"]] == pytest.approx([6.0, 6.0], abs=0.1)
    assert page.teeth.count() == 5 and page.teeth.isVisible()
    assert "Longest" in page.frame.hint.text() and len(page.bars.data.maps) == 2
    page.show_view("pitch")
    assert not page.teeth.isVisible() and len(page.pitch.data.series) == 4
    assert page.frame.chart is page.pitch
    page.refresh_theme()


def test_the_best_fit_can_be_switched_off(page, qtbot, file: Path) -> None:
    page.open_path(file)
    settle(page, qtbot)
    assert float(np.degrees(page.measurement.result.pose.turn)) == pytest.approx(np.degrees(0.002), abs=5e-3)
    page.panel.turn.setChecked(False)
    settle(page, qtbot)
    assert page.measurement.result.pose.turn == 0
    assert page.measurement.result.statistics.max_um > 50


def test_points_that_another_cutter_explains_are_measured_with_a_warning(page, qtbot, file: Path) -> None:
    page.session.load(with_field(Design(), "lengthwise.cutter_radius", 72.0))
    page.show_session(page.session)
    page.open_path(file)
    settle(page, qtbot)
    assert "with a cutter radius of" in page.panel.file.text() and "instead of" in page.panel.file.text()
    assert page.panel.file.property("severity") == "warning"
    assert page.measurement.result.warnings[0].field == "lengthwise.cutter_radius"
    page.session.load(Design())
    page.show_session(page.session)
    settle(page, qtbot)
    assert "instead of" not in page.panel.file.text() and page.panel.file.property("severity") == ""


def test_points_that_cannot_be_used_are_told_with_the_reason(page, qtbot, tmp_path: Path) -> None:
    cases = {
        "inch.csv": (points(2) / 25.4, "inches"),
        "nan.csv": (np.full((5, 3), np.nan), "not a finite number"),
        "columns.csv": (np.ones((5, 4)), "4 columns"),
        "elsewhere.csv": (np.random.default_rng(1).uniform(-50, 50, (300, 3)), "%"),
    }
    for name, (table, words) in cases.items():
        np.savetxt(tmp_path / name, table, delimiter=",")
        page.open_path(tmp_path / name)
        settle(page, qtbot)
        assert words in page.panel.file.text(), name
        assert page.measurement is None and page.panel.table.isHidden() and not page.bars.data.maps
    page.open_path(tmp_path / "missing.csv")
    settle(page, qtbot)
    assert "missing.csv" in page.panel.file.text()


def test_another_member_is_measured_anew(page, qtbot, file: Path) -> None:
    page.open_path(file)
    settle(page, qtbot)
    page.session.select(member="pinion")
    page.show_session(page.session)
    settle(page, qtbot)
    assert "they fit the wheel" in page.panel.file.text()
    page.session.select(member="wheel")
    page.show_session(page.session)
    settle(page, qtbot)
    assert cells(page)["Points"][0] == "360"


def test_the_nominal_grid_reads_back(page, qtbot, tmp_path: Path) -> None:
    page.save_nominal(tmp_path / "nominal.csv")
    page.open_path(tmp_path / "nominal.csv")
    settle(page, qtbot)
    assert page.measurement.result.statistics.max_um < 1e-6
    assert "no pitch" in page.pitch.data.note


def test_bars_stand_on_the_measured_grid(file: Path) -> None:
    done = measured(Design(), PAIR, "wheel", Source(file), (True, True), lambda stage, part: None)
    assert done.teeth == (0, 1, 2, 3)
    data, largest = topography(done, 1)
    assert 1.0 < largest <= 6.0
    net, tips, added, missing = data.maps[0].lines
    assert len(net.points) == 2 * (5 * 8 + 4 * 9) == len(tips.points)
    assert len(added.points) + len(missing.points) == 2 * 45
    lengths = np.abs(np.diff(np.concatenate([added.points, missing.points]).reshape(-1, 2, 2)[..., 1], axis=1))
    assert lengths.max() == pytest.approx(data.maps[0].reach, rel=0.2)
    assert len(points_table(done.result).rows) == 360 == len(data.table().rows)
    assert len(pitch_chart(done).series) == 4
    nets, dots = measured_layers(done, 1)
    assert len(dots.points) == 90 and np.abs(dots.scalars).max() == pytest.approx(largest)
    assert len(nets.points) == 90 and len(nets.cells) == 2 * 2 * 4 * 8
    radial = np.hypot(nets.points[:, 0], nets.points[:, 1])
    assert radial.min() > 0 and np.allclose(np.linalg.norm(nets.normals, axis=1), 1)
    assert len(measured_layers(done)[1].points) == 360


def test_measured_deviations_are_drawn_as_many_times_as_large_as_wanted(file: Path) -> None:
    from gearstudio.theory.modified import flank_on
    from ui.views.exaggeration import stretched

    done = measured(Design(), pair_geometry(Design()), "wheel", Source(file), (True, True), lambda _s, _f: None)
    layers = measured_layers(done, 1)
    flanks = [flank_on(done.member, side) for side in (1, -1)]
    for before, after in zip(layers, stretched(layers, 40), strict=True):
        assert before.offset is not None and np.allclose(after.true_points, before.points)
        angle = -done.member.pitch
        c, s = np.cos(angle), np.sin(angle)
        first = after.points @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
        off = np.stack([1e3 * flank.deviation(first) for flank in flanks])
        nearest = off[np.abs(off).argmin(axis=0), np.arange(len(first))]
        assert np.abs(nearest - 40 * before.scalars).max() < 0.1 * 40 * np.abs(before.scalars).max()


def test_scattered_points_and_one_flank_are_drawn_too(tmp_path: Path) -> None:
    flank, random = involute_flank(PAIR.wheel, "convex"), np.random.default_rng(2)
    np.savetxt(tmp_path / "s.dat", flank.points(*random.uniform(0.02, 0.98, (2, 2000))))
    done = measured(Design(), PAIR, "wheel", Source(tmp_path / "s.dat"), (True, True), lambda stage, part: None)
    data, _ = topography(done)
    concave, convex = data.maps
    assert concave.title.endswith("not measured") and len(convex.lines[0].points) > 100


def test_a_measurement_can_be_cancelled(page, qtbot, tmp_path: Path) -> None:
    table = np.tile(points(4), (200, 1))
    np.savetxt(tmp_path / "many.csv", table, delimiter=",", fmt="%.6f")
    page.open_path(tmp_path / "many.csv")
    qtbot.waitUntil(lambda: page.panel.progress.value() > 0, timeout=20_000)
    assert page.panel.stop.isVisible()
    page.panel.stop.click()
    settle(page, qtbot)
    assert "cancelled" in page.panel.file.text() and page.measurement is None
    assert not page.panel.progress.isVisible() and not page.panel.stop.isVisible()
    page.open_path(tmp_path / "many.csv")
    settle(page, qtbot)
    assert cells(page)["Points"][0] == str(len(table))


def test_points_of_a_model_are_taken_by_the_cad_process(qtbot, theme, tmp_path: Path) -> None:
    from gearstudio.analysis.measurement import MeasuredPoints
    from gearstudio.exchange.measured import MODEL_SUFFIXES
    from tests.ui.stand_ins import FakeRunner
    from ui.analysis.cad_jobs import CadJobs
    from ui.analysis.measurement_page import MeasurementPage

    class Model:
        points, shift, flank_faces, faces = MeasuredPoints(points(3) + np.array([0, 0, 30.0])), 30.0, 6, 20

    runner, jobs = FakeRunner(), CadJobs()
    page, session = MeasurementPage(jobs), Session()
    qtbot.addWidget(page)
    page.show()
    session.load(Design())
    page.show_session(session)
    page.open_path(tmp_path / f"wheel{MODEL_SUFFIXES[0]}")
    assert not runner.requests, "there is no CAD process yet"
    jobs.use_runner(runner)
    (job,) = runner.jobs
    assert job.purpose == "sample" and job.member == "wheel"
    assert page.panel.density.isVisible() and page.panel.stop.isVisible()
    runner.job_progressed.emit(job, "reading", 0.5)
    assert 0 < page.panel.progress.value() < 500
    runner.job_done.emit(job, Model)
    settle(page, qtbot)
    assert cells(page)["Points"][0] == "270" and "6 flank faces of 20" in page.panel.file.text()
    assert page.measurement.result.pose.shift == pytest.approx(30.0, abs=0.01)
    page.panel.density.setCurrentIndex(2)
    page.panel.density.activated.emit(2)
    assert runner.jobs[0].spacing < job.spacing
    runner.job_failed.emit(runner.jobs[0], "none of the 20 faces is a flank of this wheel", "")
    assert "none of the 20" in page.panel.file.text() and not page.busy
    page.open_path(tmp_path / "a.step")
    page.panel.stop.click()
    assert runner.calls == ["cancel"]
    runner.job_cancelled.emit(runner.jobs[0])
    assert "cancelled" in page.panel.file.text() and not page.busy
    page.close_page()
