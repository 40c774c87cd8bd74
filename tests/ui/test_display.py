"""The display of the views in a real window: what is chosen is seen, remembered and pictured."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPointF, QSettings, Qt
from PySide6.QtGui import QKeyEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDockWidget

from tests.ui.screen import NEEDS_SCREEN
from tests.ui.views_bench import AMOUNTS, bench_with_views, changed, flank_place, grid_of, pixels, show
from ui.main_window import MainWindow
from ui.session import Session
from ui.views.appearance import Appearance, LayerLook

pytestmark = NEEDS_SCREEN


@pytest.fixture
def bench(qtbot):
    yield from bench_with_views(qtbot)


class TestAppearance:
    def test_stripes_darken_flanks_and_move_with_the_camera(self, bench, qtbot):
        plain = show(qtbot, bench)
        striped = show(qtbot, bench, zebra=True)
        assert 0.003 < changed(plain, striped) < 0.3
        stripes = grid_of(bench).appearance.stripes
        assert changed(striped, show(qtbot, bench, stripes=replace(stripes, angle_deg=0.0))) > 0.003
        assert changed(plain, show(qtbot, bench, zebra=False)) < 0.001

    def test_ground_edges_and_layers_do_as_they_are_told(self, bench, qtbot):
        grid_of(bench).set_view("iso")
        plain = show(qtbot, bench)
        assert tuple(show(qtbot, bench, ground="black")[4, 4, :3]) == (0, 0, 0)
        assert changed(plain, show(qtbot, bench, ground="theme", edges=False)) > 0.0005
        red = show(qtbot, bench, looks={"tooth": LayerLook("#ff0000", None)})
        assert ((red[..., 0] > red[..., 2] + 80).mean()) > 0.002
        assert changed(plain, show(qtbot, bench, edges=True, looks={})) < 0.001

    def test_parallel_keeps_the_size_in_the_middle(self, bench, qtbot):
        look = grid_of(bench).viewport.look
        show(qtbot, bench, parallel=True)
        assert grid_of(bench).viewport.look.parallel
        assert grid_of(bench).viewport.look.half_height == look.half_height
        assert not grid_of(bench).overlays.scales[0].label.startswith("≈")
        grid_of(bench).set_view("iso")
        assert grid_of(bench).viewport.look.parallel

    def test_free_cameras_turn_alone_and_meet_again(self, bench, qtbot):
        grid = grid_of(bench)
        show(qtbot, bench, linked=False)
        before = list(grid.viewport.looks)
        QTest.mousePress(grid.viewport, Qt.MouseButton.LeftButton, pos=flank_place(grid, 1).toPoint())
        QTest.mouseMove(grid.viewport, (flank_place(grid, 1) + QPointF(30, 10)).toPoint())
        QTest.mouseRelease(grid.viewport, Qt.MouseButton.LeftButton)
        grid.viewport.active = 1
        grid.viewport._move(grid.viewport.look.turned(0.3, 0.1))
        assert grid.viewport.looks[0] is before[0] and grid.viewport.looks[1] is not before[1]
        show(qtbot, bench, linked=True)
        assert all(look is grid.viewport.looks[1] for look in grid.viewport.looks)

    def test_curvature_has_its_own_scale(self, bench, qtbot):
        bar = bench.window.area.color_bar
        before = bar.range
        show(qtbot, bench, quantity="mean")
        qtbot.waitUntil(lambda: bar.range != before, timeout=5000)
        assert bar.quantity.unit == "1/mm" and grid_of(bench).color_range == bar.range
        show(qtbot, bench, quantity="deviation")
        assert bar.range == before

    def test_contours_follow_the_marks_of_the_scale(self, bench, qtbot):
        show(qtbot, bench, contours=True)
        bar = bench.window.area.color_bar
        assert bar.levels()[0] >= bar.range[0] and bar.levels()[-1] <= bar.range[1]
        assert 0.0 in bar.levels()

    def test_the_panel_shows_and_announces(self, bench, qtbot):
        panel = bench.controller.display.panel
        bench.window.commands["display"].setChecked(True)
        assert panel.isVisible()
        with qtbot.waitSignal(panel.changed) as told:
            panel._boxes["zebra"].click()
        assert told.args[0].zebra and grid_of(bench).appearance.zebra
        choice = panel._choices["ground"]
        wheel = QWheelEvent(
            QPointF(5, 5), QPointF(5, 5), QPointF().toPoint(), QPointF(0, -120).toPoint(),
            Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase, False,
        )  # fmt: skip
        QApplication.sendEvent(choice, wheel)
        assert choice.currentData() == "theme"

    def test_an_opacity_from_the_layer_list_reaches_the_views(self, bench, qtbot):
        bench.window.layer_panel.swatch("tooth").choose(LayerLook(None, 0.3))
        assert grid_of(bench).appearance.looks["tooth"].opacity == 0.3
        actor = next(a for k, a in grid_of(bench).store._actors[0].items() if k.startswith("tooth/"))
        assert actor.GetProperty().GetOpacity() == pytest.approx(0.3)


class TestPicking:
    def test_a_click_stays_and_escape_takes_it_away(self, bench, qtbot):
        grid, card = grid_of(bench), bench.controller.display.picks.card
        QTest.mouseClick(grid.viewport, Qt.MouseButton.LeftButton, pos=flank_place(grid, 1).toPoint())
        qtbot.waitUntil(card.isVisible, timeout=5000)
        assert grid.pointing.pin.deviation_um == pytest.approx(-30.0)
        assert len(card.rows()) == 2 + len(AMOUNTS) and "ρ" in card.coordinates()[1]
        assert all(pin.isVisible() for pin in grid.overlays.pins)
        escape = QKeyEvent(QEvent.Type.KeyPress, Qt.Key.Key_Escape, Qt.KeyboardModifier.NoModifier)
        QApplication.sendEvent(grid.viewport, escape)
        assert not card.isVisible() and grid.pointing.pin is None
        assert not any(pin.isVisible() for pin in grid.overlays.pins)

    def test_the_marker_goes_along_when_deviations_are_drawn_larger(self, bench, qtbot):
        grid = grid_of(bench)
        QTest.mouseClick(grid.viewport, Qt.MouseButton.LeftButton, pos=flank_place(grid, 1).toPoint())
        pin, before = grid.pointing.pin, np.array(grid.pointing.pin_place)
        assert np.allclose(before, pin.xyz)
        show(qtbot, bench, exaggeration=50)
        assert grid.panels[1].subtitle.split(" · ")[1] == "deviation ×50"
        moved = np.array(grid.pointing.pin_place) - before
        assert np.linalg.norm(moved) == pytest.approx(49 * 0.030, rel=1e-3) and grid.pointing.pin is pin
        show(qtbot, bench, exaggeration=1)
        assert np.allclose(grid.pointing.pin_place, before)

    def test_a_point_goes_with_its_member_alone(self, bench, qtbot):
        grid, session = grid_of(bench), bench.session
        QTest.mouseClick(grid.viewport, Qt.MouseButton.LeftButton, pos=flank_place(grid, 1).toPoint())
        qtbot.waitUntil(bench.controller.display.picks.card.isVisible, timeout=5000)
        session.select(variant="optimised")
        assert grid.pointing.pin is not None
        session.select(member="pinion")
        assert grid.pointing.pin is None

    def test_a_click_beside_the_flanks_picks_nothing(self, bench, qtbot):
        grid = grid_of(bench)
        QTest.mouseClick(grid.viewport, Qt.MouseButton.LeftButton, pos=QPointF(4, grid.height() - 4).toPoint())
        assert grid.pointing.pin is None


def test_panels_that_stand_by_themselves_do_so_the_next_time(qtbot, tmp_path):
    settings = QSettings(str(tmp_path / "s.ini"), QSettings.Format.IniFormat)

    def window() -> MainWindow:
        made = MainWindow(Session(), settings)
        made.restore_layout()
        made.show()
        qtbot.waitExposed(made)
        return made

    first = window()
    dock = next(d for d in first.findChildren(QDockWidget) if d.objectName() == "Derived values")
    dock.setFloating(True)
    first.close()
    second = window()
    dock = next(d for d in second.findChildren(QDockWidget) if d.objectName() == "Derived values")
    assert dock.isFloating()
    second.close()


def test_a_default_appearance_changes_nothing(bench, qtbot):
    before = pixels(grid_of(bench).viewport.grabFramebuffer())
    assert grid_of(bench).appearance == Appearance()
    assert changed(before, show(qtbot, bench)) < 0.001
