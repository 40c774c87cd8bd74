"""The contact page: sliders, pattern, transmission error, warnings; and the thread behind it."""

from __future__ import annotations

import threading

import numpy as np
import pytest

from gearstudio.analysis.contact_placing import Misalignment
from gearstudio.design import Design
from gearstudio.errors import GeometryError
from gearstudio.theory.cones import pair_geometry
from ui.analysis.background import Newest
from ui.analysis.contact_view import NO_MATE, error_chart, facts, pattern_table
from ui.analysis.contact_work import Case, analyse
from ui.analysis.ease_off_view import ease_off_heights
from ui.charts.contours import contour_pairs, round_step
from ui.charts.raster import frame, inside, outline, raster
from ui.session import Session

pytestmark = pytest.mark.ui


def test_a_raster_brings_values_on_a_curved_grid_to_an_even_one() -> None:
    u, v = np.mgrid[0:1:21j, 0:1:41j]
    x, y = 10 + 5 * v + 0.3 * u, (1 + v) * (u - 0.4)
    for turn in (slice(None), slice(None, None, -1)):
        edge = outline(x, y)
        extent = frame(edge)
        image = raster(x[turn], y[turn], (2 * x + 3 * y)[turn], (60, 90), extent)
        rows, columns = np.nonzero(np.isfinite(image))
        at_x = extent[0] + (columns + 0.5) / 90 * extent[2]
        at_y = extent[1] + (rows + 0.5) / 60 * extent[3]
        np.testing.assert_allclose(image[rows, columns], 2 * at_x + 3 * at_y, rtol=2e-3)
        within = inside(edge, (60, 90), extent)
        assert np.mean(within == np.isfinite(image)) > 0.98
        assert 0.4 < within.mean() < 0.95


def test_the_perfect_pair_marks_the_whole_flank_and_has_a_flat_curve() -> None:
    view = analyse(Case(pair_geometry(Design()), Misalignment(), 6.35))
    pinion, wheel = view.patterns
    assert pinion.title == "Pinion, concave flank" and wheel.title == "Wheel, convex flank"
    assert np.mean(pinion.image[np.isfinite(pinion.image)] < 6.35) > 0.85
    assert np.any(wheel.image == NO_MATE)
    chart = error_chart(view.result.drive)
    assert np.ptp(chart.series[0].y) < 1e-6 and np.ptp(chart.span_y) == pytest.approx(0.01)
    assert np.ptp(chart.series[0].x) == pytest.approx(3 * 360 / 17, rel=0.02)
    assert dict(facts(view.result, "drive"))["Peak to peak"] == "<\u202f10⁻⁴″"
    assert len(pattern_table(view.result.coast).rows) == view.result.coast.pinion.rho.size * 2


def test_contours_lie_on_their_level() -> None:
    x, y = np.meshgrid(np.linspace(0, 3, 31), np.linspace(-1, 1, 21))
    pairs = contour_pairs(x, y, 2 * x - y, np.array([1.0, 2.5]))
    levels = 2 * pairs[:, 0] - pairs[:, 1]
    assert np.allclose(np.minimum(np.abs(levels - 1), np.abs(levels - 2.5)), 0, atol=1e-12)
    for level in (1.0, 2.5):
        strokes = pairs[np.abs(levels - level) < 1e-9].reshape(-1, 2, 2)
        assert np.linalg.norm(np.diff(strokes, axis=1), axis=-1).sum() == pytest.approx(np.hypot(1, 2))
    holed = np.where(x < 1.5, np.nan, 2 * x - y)
    assert contour_pairs(x, y, holed, np.array([4.0]))[:, 0].min() >= 1.5
    assert len(contour_pairs(x, y, 0 * x, np.array([0.0]))) == 0
    assert [round_step(span) for span in (8, 7.9, 0.3, 100, 0)] == [1, 1, 0.05, 20, 0]


def test_the_ease_off_is_what_was_taken_off() -> None:
    from tests.analysis.test_contact import crowned

    pair, crown = pair_geometry(Design()), 20.0
    taken = analyse(Case(crowned(crown), Misalignment(), 6.35)).result.drive
    heights = ease_off_heights(taken)
    facing = np.isfinite(heights)
    v = np.broadcast_to(np.linspace(0, 1, heights.shape[1]), heights.shape)
    middle = heights[:, heights.shape[1] // 2]
    assert np.abs(middle[np.isfinite(middle)]).max() < 0.2
    assert np.abs(heights - crown * (2 * v - 1) ** 2)[facing].max() < 0.05 * crown
    assert np.nanmax(heights) == pytest.approx(crown, rel=0.05)
    flat = analyse(Case(pair, Misalignment(), 6.35), "coast", "ease_off")
    assert flat.ease_off.step_um == 0 and flat.patterns is None
    tilted = analyse(Case(pair, Misalignment(offset=0.05), 6.35), "drive", "ease_off", flat).ease_off
    assert tilted.step_um > 0 and len(tilted.maps[0].lines[0].points) > 50 < len(tilted.maps[1].lines[0].points)
    image = tilted.maps[0].image
    assert np.nanmax(np.abs(image)) <= tilted.limit_um * 1.001 and np.nanmax(np.abs(image)) > 0.8 * tilted.limit_um


def test_the_newest_request_wins_and_failures_are_told(qtbot) -> None:
    work, gate = Newest("test"), threading.Event()
    done: list[tuple[object, object]] = []
    failed: list[tuple[object, str, str]] = []
    work.done.connect(lambda *values: done.append(values))
    work.failed.connect(lambda *values: failed.append(values))
    work.request("first", lambda: gate.wait(5))
    qtbot.wait(50)
    for number in range(20):
        work.request(number, lambda number=number: number**2)
    gate.set()
    qtbot.waitUntil(lambda: len(done) == 2)
    assert done == [("first", True), (19, 361)]

    def refuse() -> None:
        raise GeometryError("no contact")

    work.request("bad", refuse)
    qtbot.waitUntil(lambda: len(failed) == 1)
    work.request("worse", lambda: 1 / 0)
    qtbot.waitUntil(lambda: len(failed) == 2)
    assert failed[0] == ("bad", "no contact", "")
    assert failed[1][1].startswith("ZeroDivisionError") and "Traceback" in failed[1][2]
    work.close()
    work.request("late", lambda: 1)
    qtbot.wait(50)
    assert len(done) == 2


@pytest.fixture
def page(qtbot, theme):
    from ui.analysis.contact_page import ContactPage

    made = ContactPage()
    qtbot.addWidget(made)
    made.resize(1000, 330)
    made.show()
    session = Session()
    session.load(Design())
    made.show_session(session)
    made.session = session
    qtbot.waitUntil(lambda: made.view is not None, timeout=20_000)
    yield made
    made.close_page()


def settle(page, qtbot) -> None:
    qtbot.waitUntil(lambda: not page.work.busy, timeout=30_000)
    qtbot.wait(50)


def test_a_slider_recomputes_and_warns_of_edge_contact(page, qtbot) -> None:
    assert "Peak to peak" in page.facts.text() and not page.warning.text()
    slider = page.controls.rows["offset"].slider
    for step in range(110, 160, 5):
        slider.setValue(step)
    settle(page, qtbot)
    assert page.controls.misalignment.offset == pytest.approx(page.controls.rows["offset"].value)
    assert page.view.result.misalignment == page.controls.misalignment
    assert "edge contact" in page.warning.text() and page.warning.text().startswith("drive")
    page.controls.sides.button("coast").click()
    settle(page, qtbot)
    assert page.maps.name == "contact-pattern-coast" and "Pinion, convex" in page.maps.data.maps[0].title
    page.controls.reset()
    settle(page, qtbot)
    assert page.view.result.misalignment == Misalignment() and not page.warning.text()
    assert slider.value() == 100


def test_while_a_slider_moves_only_what_is_looked_at_is_analysed(page, qtbot) -> None:
    before, slider = page.view.result, page.controls.rows["offset"].slider
    slider.setSliderDown(True)
    slider.setValue(150)
    settle(page, qtbot)
    during = page.view.result
    assert during.coast is before.coast and during.drive is not before.drive
    assert "…" in page.facts.text() and "edge contact" in page.warning.text()
    slider.setSliderDown(False)
    settle(page, qtbot)
    after = page.view.result
    assert after.coast is not before.coast and np.isfinite(after.play_mm) and "…" not in page.facts.text()
    assert after.drive.peak_to_peak_arcsec == during.drive.peak_to_peak_arcsec


def test_a_thicker_compound_marks_more(page, qtbot) -> None:
    page.controls.rows["offset"].set_value(0.05)
    settle(page, qtbot)
    thin = page.view.result.drive.pattern_share
    page.controls.thickness.set_value(25.0)
    settle(page, qtbot)
    assert page.view.result.drive.pattern_share > thin


def test_misalignment_beyond_any_contact_is_told(page, qtbot) -> None:
    page.controls.rows["pinion_axial"].set_value(35.0)
    settle(page, qtbot)
    assert page.view is None and "no contact" in page.warning.text()
    page.controls.reset()
    settle(page, qtbot)
    assert page.view is not None


def test_another_design_is_analysed_anew(page, qtbot) -> None:
    before = page.view
    page.session.edit("pair.wheel_teeth", 43)
    page.show_session(page.session)
    qtbot.waitUntil(lambda: page.view is not before, timeout=20_000)
    page.refresh_theme()
    assert page.maps.data.maps


def test_the_ease_off_follows_the_sliders(page, qtbot) -> None:
    page.shown.button("ease_off").click()
    settle(page, qtbot)
    assert page.maps.name == "ease-off-drive" and "conjugate" in page.pattern_frame.hint.text()
    page.controls.rows["wheel_axial"].set_value(0.08)
    settle(page, qtbot)
    assert "Contours every" in page.pattern_frame.hint.text() and "edge contact" in page.warning.text()
    assert len(page.maps.data.maps) == 2 and page.maps.table.head[-1] == "ease-off [µm]"
    assert np.isfinite(np.array([row[-1] for row in page.maps.table.rows], dtype=float)).mean() > 0.5
    page.refresh_theme()
    page.show_map("pattern")
    settle(page, qtbot)
    assert page.maps.name == "contact-pattern-drive"
