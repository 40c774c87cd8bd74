"""Charts: what they show, how they are written, and the pages around them."""

from __future__ import annotations

import csv
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QGuiApplication, QImage

from gearstudio.analysis.curvature import theory_curvature
from gearstudio.design import Design
from gearstudio.nurbs import NurbsSurface
from gearstudio.theory.involute_flank import involute_flank
from tests.ui.made_up import member_of, result_of
from ui.analysis.curvature_view import power_of_ten
from ui.analysis.deviation_series import (
    LEAST_UM,
    PAPER_MEANS_UM,
    Choice,
    along,
    deviation_chart,
    histogram_chart,
)
from ui.charts.records import Axis, ChartData, Series, micrometre_tick, orders_apart
from ui.comparison_table import FIRST, ComparisonModel
from ui.session import Key, Session

pytestmark = pytest.mark.ui
CHOICE = Choice("wheel", "concave")


def results(sizes: dict[tuple[str, str], float]) -> dict:
    member = member_of("default")
    return {
        Key("wheel", *key): result_of(member, lambda u, v, size=size: size * (0.2 + u * v), method=key[0])
        for key, size in sizes.items()
    }


def test_paths_over_a_map() -> None:
    u, v = np.mgrid[0:1:29j, 0:1:29j]
    deviation = -(10 * u + v)
    places, sizes = along(deviation, "face")
    assert places[0] == 0 and places[-1] == 1
    np.testing.assert_allclose(sizes, 5 + places)
    np.testing.assert_allclose(along(deviation, "profile")[1], 0.5 + 10 * places)
    numbers, series = along(deviation, "grid")
    assert numbers[0] == 1 and numbers[-1] == 49
    first = series.reshape(7, 7)
    assert np.all(np.diff(first, axis=1) > 0) and np.all(np.diff(first, axis=0) > 0)
    assert series.min() > 0 and series.max() < 11


def test_methods_that_differ_by_orders_get_a_logarithmic_axis() -> None:
    near = deviation_chart(results({("point_cloud", "published"): 5.0, ("profile_sweep", "published"): 9.0}), CHOICE)
    assert not near.y.log and near.y.unit == "µm"
    far = deviation_chart(results({("point_cloud", "published"): 5.0, ("point_cloud", "optimised"): 5e-4}), CHOICE)
    assert far.y.log and [series.stroke for series in far.series] == ["dash", "solid"]
    exact = deviation_chart(results({("point_cloud", "published"): 5.0, ("point_cloud", "optimised"): 0.0}), CHOICE)
    assert not exact.y.log
    forced = deviation_chart(results({("point_cloud", "optimised"): 0.0}), Choice("wheel", "concave", log=True))
    assert np.all(forced.series[0].y == LEAST_UM)


def test_the_papers_figures_are_drawn_beside_the_results_when_wanted() -> None:
    found = results({("point_cloud", "published"): 5.0})
    chart = deviation_chart(found, CHOICE)
    assert {line.value for line in chart.references} == set(PAPER_MEANS_UM.values()) == {54.6, 60.3, 52.9}
    assert (chart.bands[0].low, chart.bands[0].high) == (43.4, 71.3)
    assert not deviation_chart(found, Choice("wheel", "concave", paper=False)).references
    empty = deviation_chart({}, CHOICE)
    assert empty.note and not empty.series and not empty.references


def test_a_histogram_counts_every_point() -> None:
    for sizes in (
        {("point_cloud", "published"): 5.0},
        {("point_cloud", v): s for v, s in (("published", 5.0), ("optimised", 1e-3))},
    ):
        chart = histogram_chart(results(sizes), CHOICE)
        for series in chart.series:
            assert len(series.x) == len(series.y) + 1
            assert series.y.sum() == pytest.approx(100)


def test_ticks_read_well() -> None:
    assert [micrometre_tick(value) for value in (0, 1e-5, 1e-3, 0.1, 10.0)] == ["0", "10 pm", "1 nm", "0.1 µm", "10 µm"]
    assert orders_apart([np.array([1.0]), np.array([100.0])]) and not orders_apart([np.array([0.0])])


def chart_data() -> ChartData:
    x = np.linspace(0, 1, 5)
    return ChartData("a-chart", Axis("Place"), Axis("Deviation", "µm"), (Series("one", x, x**2, "pinion"),))


@pytest.fixture
def frame(qtbot, theme):
    from ui.charts.chart import Chart
    from ui.charts.frame import ChartFrame

    chart = Chart()
    made = ChartFrame(chart)
    qtbot.addWidget(made)
    made.resize(640, 360)
    chart.show_data(chart_data())
    made.show()
    qtbot.waitExposed(made)
    return made


def test_a_chart_is_saved_as_picture_drawing_and_table(frame, tmp_path: Path) -> None:
    said: list[tuple[str, str]] = []
    frame.said.connect(lambda *words: said.append(words))
    for name in ("a.png", "b.svg", "c.csv", "d"):
        frame.save(tmp_path / name)
    assert [kind for kind, _ in said] == ["info"] * 4
    picture = QImage(str(tmp_path / "a.png"))
    assert picture.width() == 2 * frame.chart.width()
    colors = {picture.pixel(x, y) for x in range(0, picture.width(), 7) for y in range(0, picture.height(), 7)}
    assert len(colors) > 3
    drawing = (tmp_path / "b.svg").read_text(encoding="utf-8")
    assert "<svg" in drawing and "Deviation [µm]" in drawing
    assert drawing.count("<text") > 8 and "<image" not in drawing, "letters and lines, no pictures of them"
    rows = list(csv.reader((tmp_path / "c.csv").open(encoding="utf-8")))
    assert rows[0] == ["Place", "one [µm]"] and float(rows[-1][1]) == 1.0 and len(rows) == 6
    assert (tmp_path / "d.png").exists()
    frame.save(tmp_path / "e.xyz")
    frame.save(tmp_path / "missing" / "f.png")
    assert [kind for kind, _ in said[4:]] == ["error", "error"]


def test_a_chart_is_copied_as_picture_and_numbers(frame) -> None:
    frame.copy()
    data = QGuiApplication.clipboard().mimeData()
    assert data.hasImage() and data.text().splitlines()[0] == "Place\tone [µm]"


def test_pointing_at_a_curve_reads_it_out(frame) -> None:
    chart = frame.chart
    box = chart.plot.vb
    chart._on_moved(box.mapViewToScene(QPointF(0.5, 0.25)))
    assert "Place 0.5" in chart._readout.toPlainText() and "0.25 µm" in chart._readout.toPlainText()
    chart._on_moved(QPointF(-50, -50))
    assert chart._readout.toPlainText() == ""


@pytest.fixture
def page(qtbot, theme):
    from ui.analysis.charts_page import ChartsPage

    made = ChartsPage()
    qtbot.addWidget(made)
    made.resize(920, 300)
    made.show()
    session = Session()
    session.load(Design())
    made.session = session
    return made


def test_the_page_shows_results_as_they_come_and_its_choices_change_the_chart(page) -> None:
    session = page.session
    page.show_session(session)
    assert page.chart.data.note and not page.chart.data.series
    member = session.pair.wheel
    for method, size in (("rotating_line", 1.0), ("profile_sweep", 40.0)):
        session.put_result(session.design, result_of(member, lambda u, v, size=size: size * (0.2 + u * v), 29, method))
    page.show_session(session)
    assert [series.name for series in page.chart.data.series] == [
        "Rotating line, published",
        "Profile sweep, published",
    ]
    page.flanks.button("convex").click()
    assert "convex" in page.chart.name
    page.paper.setChecked(False)
    assert not page.chart.data.references
    page.show_kind("histogram")
    assert page.chart.name.startswith("histogram") and not page.paths.isVisible()
    session.select(member="pinion")
    page.show_session(session)
    assert not page.chart.data.series


def test_curvature_of_the_models_is_drawn_and_compared_with_theory(page) -> None:
    session = page.session
    session.select(variant="published")
    page.show_session(session)
    page.show_kind("curvature")
    assert not page.map.data.maps and "being built" in page.frame.hint.text()
    member = session.pair.wheel
    exact = result_of(member, lambda u, v: 0 * u, 29)
    flanks = {name: replace(flank, surface=surface_through(member, name)) for name, flank in exact.flanks.items()}
    session.put_result(session.design, replace(exact, flanks=flanks))
    page.show_session(session)
    assert [one.title.split(":")[0] for one in page.map.data.maps] == ["Point cloud"]
    true = theory_curvature(involute_flank(member, "concave"), np.linspace(0.02, 1, 33)[:, None], np.linspace(0, 1, 61))
    scale = page.map.data.scale
    assert true.gaussian.min() < scale.low < scale.high < true.gaussian.max()
    page.against.setCurrentIndex(1)
    page.against.activated.emit(1)
    assert page.map.data.scale.high < 0.02 * abs(scale.low) and "less theory" in page.map.data.scale.title
    assert len(page.map.table.rows) == 33 * 61
    page.refresh_theme()


def surface_through(member, name):
    """A cubic surface through many points of a theoretical flank."""
    from scipy.interpolate import make_interp_spline

    places = np.linspace(0, 1, 40)
    points = involute_flank(member, name).points(places[:, None], places)
    along_u = make_interp_spline(places, points, 5)
    along_v = make_interp_spline(places, np.moveaxis(along_u.c, 1, 0), 5)
    return NurbsSurface(np.moveaxis(along_v.c, 0, 1), along_u.t, along_v.t, 5, 5)


def test_small_numbers_are_written_as_people_do() -> None:
    assert [power_of_ten(value) for value in (0.0, -1.47e-4, 2.5e-12)] == ["0", "−1.47·10⁻⁴", "2.50·10⁻¹²"]


def test_a_study_is_made_job_by_job_and_drawn(qtbot, theme) -> None:
    from gearstudio.analysis.convergence import DEFAULT_COUNTS, ConvergencePoint
    from gearstudio.design import Design, with_field
    from tests.ui.stand_ins import FakeRunner
    from ui.analysis.cad_jobs import CadJobs
    from ui.analysis.charts_page import ChartsPage

    runner, jobs, session = FakeRunner(), CadJobs(), Session()
    jobs.use_runner(runner)
    page = ChartsPage(jobs)
    qtbot.addWidget(page)
    page.show()
    session.load(Design())
    page.show_session(session)
    page.show_kind("convergence")
    part = page.convergence
    assert part.run.isVisible() and not page.flanks.isVisible() and page.chart.data.note

    def answer() -> None:
        (job,) = runner.jobs
        error = 1e3 / job.count**5 if job.method != "point_cloud" else 1.0
        runner.job_done.emit(job, ConvergencePoint(job.count, job.count**2, 0.01, error, error, error))

    part.run.click()
    assert part.running and len(runner.requests) == 1
    answer()
    assert len(runner.requests) == 2 and len(page.chart.data.series) == 1
    (job,) = runner.jobs
    runner.job_failed.emit(job, "the kernel could not", "")
    for _ in range(3 * len(DEFAULT_COUNTS) - 2):
        answer()
    assert not part.running and part.failures == 1 and len(runner.requests) == 3 * len(DEFAULT_COUNTS)
    data = page.chart.data
    assert data.x.log and data.y.log and len(data.series) == 3 and data.references[0].value == 0.05
    assert "Point cloud: –" in page.frame.hint.text() or "–" in page.frame.hint.text()
    part.effort.setCurrentIndex(1)
    part.effort.activated.emit(1)
    assert page.chart.data.series[0].x[-1] == DEFAULT_COUNTS[-1] ** 2
    part.size.setCurrentIndex(3)
    part.size.activated.emit(3)
    assert not page.chart.data.references and page.chart.table.head[0] == "method"
    part.run.click()
    part.run.click()
    assert not part.running
    answer()
    assert not part.found, "a point of a study that was ended is dropped"
    part.run.click()
    session.load(with_field(Design(), "pair.wheel_teeth", 41))
    page.show_session(session)
    assert not part.running and not page.chart.data.series
    page.close_page()


def test_a_method_that_leaves_modifications_out_says_so_in_the_legend_and_the_table() -> None:
    found = results({("rotating_line", "published"): 30.0, ("point_cloud", "published"): 5.0})
    key = Key("wheel", "rotating_line", "published")
    found[key] = replace(found[key], settings={"modifications": "left out", "positions": 5})
    for chart in (deviation_chart(found, CHOICE), histogram_chart(found, CHOICE)):
        texts = [entry.text for entry in chart.legend]
        assert "Rotating line: modifications left out" in texts and "Point cloud" in texts
    session = Session()
    session.results.update(found)
    model = ComparisonModel(session)
    row = next(row for row in range(model.rowCount()) if model.key(row) == key)
    assert model.shortcomings() == ["Rotating line: modifications left out"]
    tip = model.data(model.index(row, FIRST), Qt.ItemDataRole.ToolTipRole)
    assert tip == "Rotating line: modifications left out"
