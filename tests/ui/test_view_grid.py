"""The views on a real screen: pixels, pointer, panes and memory."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QApplication

from tests.ui.made_up import member_of, result_of, scene_layers
from tests.ui.screen import NEEDS_SCREEN
from ui.layers import DEFAULT_VISIBLE, Panel
from ui.scene import rolling_layers

pytestmark = NEEDS_SCREEN
AMOUNTS = (30.0, -30.0, 0.0)


def panels(count: int, member: str = "wheel", amounts=AMOUNTS) -> list[Panel]:
    geometry = member_of("default", member)
    results = [result_of(geometry, lambda u, v, a=amount: a + 0 * u) for amount in amounts[:count]]
    return [Panel(f"m{i}", f"Method {i}", "max 1 µm", scene_layers(geometry, r)) for i, r in enumerate(results)]


@pytest.fixture
def grid(grid):
    grid.set_color_range(40.0)
    return grid


def settled(qtbot, grid) -> None:
    grid.viewport.update()
    qtbot.wait(250)


def flank_place(grid, pane: int, flank: str = "concave") -> QPointF:
    layer = next(x for x in grid.panels[pane].layers if x.key == f"deviation/{flank}")
    x, y = grid.viewport.look.project(layer.points[len(layer.points) // 2])
    return grid.viewport.place_of(pane, float(x), float(y))


def pixel(grid, place: QPointF) -> QColor:
    picture = grid.viewport.grabFramebuffer()
    ratio = picture.width() / grid.viewport.width()
    return picture.pixelColor(round(place.x() * ratio), round(place.y() * ratio))


def move_to(grid, place: QPointF, buttons=Qt.MouseButton.NoButton) -> None:
    where = grid.viewport.mapToGlobal(place)
    event = QMouseEvent(
        QEvent.Type.MouseMove, place, where, Qt.MouseButton.NoButton, buttons, Qt.KeyboardModifier.NoModifier
    )
    QApplication.sendEvent(grid.viewport, event)


def press(grid, place: QPointF, kind=QEvent.Type.MouseButtonPress) -> None:
    left, where = Qt.MouseButton.LeftButton, grid.viewport.mapToGlobal(place)
    QApplication.sendEvent(grid.viewport, QMouseEvent(kind, place, where, left, left, Qt.KeyboardModifier.NoModifier))


class TestPicture:
    def test_shows_metal_added_warm_and_missing_cold(self, grid, qtbot):
        grid.set_panels(panels(3))
        grid.set_view("concave")
        settled(qtbot, grid)
        warm, cold, exact = (pixel(grid, flank_place(grid, pane)) for pane in range(3))
        assert warm.red() > warm.blue() + 60
        assert cold.blue() > cold.red() + 60
        assert max(exact.getRgb()[:3]) - min(exact.getRgb()[:3]) < 25

    def test_follows_the_colour_range(self, grid, qtbot):
        grid.set_panels(panels(1))
        grid.set_view("concave")
        settled(qtbot, grid)
        strong = pixel(grid, flank_place(grid, 0))
        grid.set_color_range(4000.0)
        settled(qtbot, grid)
        weak = pixel(grid, flank_place(grid, 0))
        assert strong.red() - strong.blue() > weak.red() - weak.blue() + 60

    def test_layers_switch(self, grid, qtbot):
        grid.set_panels(panels(1))
        grid.set_view("concave")
        grid.set_layer_visible("deviation", False)
        settled(qtbot, grid)
        grey = pixel(grid, flank_place(grid, 0))
        assert max(grey.getRgb()[:3]) - min(grey.getRgb()[:3]) < 25
        assert "deviation" not in grid.visible_layers

    def test_background_follows_the_theme(self, grid, qtbot):
        grid.set_panels(panels(1))
        grid.set_view("iso")
        for dark, low, high in ((True, 0, 110), (False, 180, 255)):
            grid.set_theme(dark)
            settled(qtbot, grid)
            assert low <= pixel(grid, QPointF(5, 5)).lightness() <= high

    def test_rolling_shows_the_swept_flank(self, grid, qtbot):
        grid.set_panels(panels(1))
        grid.set_visible_layers({"generating_line", "tooth"})
        grid.set_view("concave")
        grid.update_layers(rolling_layers(member_of("default"), 1.0))
        settled(qtbot, grid)
        swept = pixel(grid, flank_place(grid, 0))
        grid.update_layers(rolling_layers(member_of("default"), 0.0))
        settled(qtbot, grid)
        bare = pixel(grid, flank_place(grid, 0))
        assert swept.green() > swept.red() + 40
        assert abs(bare.green() - bare.red()) < 25


class TestPanes:
    def test_one_and_three_panes_come_and_go_without_a_trace(self, grid, qtbot):
        three, one = panels(3), panels(1)
        grid.set_panels(three)
        settled(qtbot, grid)
        before, look = grid.store.counts, grid.viewport.look
        for _ in range(10):
            grid.set_panels(one)
            assert grid.store.counts[1:] == (0, 0)
            grid.viewport.repaint()
            grid.set_panels(three)
            grid.viewport.repaint()
        assert grid.store.counts == before
        assert grid.viewport.look is look
        actors = [renderer.GetActors().GetNumberOfItems() for renderer in grid.viewport.renderers]
        assert actors == list(before)

    def test_an_update_costs_one_frame(self, grid, qtbot):
        grid.set_panels(panels(3))
        settled(qtbot, grid)
        frames = grid.viewport.frames
        grid.set_panels(panels(3))
        grid.set_color_range(20.0)
        qtbot.wait(300)
        assert grid.viewport.frames == frames + 1

    def test_nothing_is_drawn_while_nothing_happens(self, grid, qtbot):
        grid.set_panels(panels(1))
        settled(qtbot, grid)
        frames = grid.viewport.frames
        qtbot.wait(400)
        assert grid.viewport.frames == frames

    def test_camera_stays_for_an_edit_and_follows_another_member(self, grid, qtbot):
        grid.set_panels(panels(1))
        grid.viewport.set_camera(grid.viewport.look.turned(0.3, 0.1))
        look = grid.viewport.look
        grid.set_panels(panels(1, amounts=(5.0,)))
        assert grid.viewport.look is look
        grid.set_panels(panels(1, member="pinion"))
        assert grid.viewport.look is not look

    def test_titles_come_back_after_a_single_view(self, grid, qtbot):
        for count in (3, 1, 3):
            grid.set_panels(panels(count))
            assert [title.isVisible() for title in grid.overlays.titles] == [index < count for index in range(3)]

    def test_refuses_an_unknown_view(self, grid):
        with pytest.raises(ValueError, match="nowhere"):
            grid.set_view("nowhere")


class TestPointer:
    def test_tells_the_point_under_it(self, grid, qtbot):
        grid.set_panels(panels(3))
        grid.set_view("concave")
        with qtbot.waitSignal(grid.hovered) as told:
            move_to(grid, flank_place(grid, 1))
        hover = told.args[0]
        assert hover.panel_key == "m1" and hover.flank == "concave"
        assert hover.deviation_um == pytest.approx(-30.0)
        assert hover.rho == pytest.approx(np.linalg.norm(hover.xyz))
        assert all(marker.isVisible() for marker in grid.overlays.markers)
        with qtbot.waitSignal(grid.hovered) as told:
            move_to(grid, QPointF(2, 598))
        assert told.args[0] is None
        assert not any(marker.isVisible() for marker in grid.overlays.markers)

    def test_does_not_draw_the_scene_again(self, grid, qtbot):
        grid.set_panels(panels(3))
        grid.set_view("concave")
        settled(qtbot, grid)
        qtbot.wait(200)
        frames = grid.viewport.frames
        move_to(grid, flank_place(grid, 1))
        qtbot.wait(100)
        assert grid.viewport.frames == frames

    def test_a_drag_turns_and_a_wheel_zooms(self, grid, qtbot):
        grid.set_panels(panels(3))
        look = grid.viewport.look
        press(grid, QPointF(200, 200))
        move_to(grid, QPointF(240, 210), Qt.MouseButton.LeftButton)
        press(grid, QPointF(240, 210), QEvent.Type.MouseButtonRelease)
        turned = grid.viewport.look
        assert not np.allclose(turned.back, look.back) and np.allclose(turned.focal, look.focal)
        wheel = QWheelEvent(
            QPointF(150, 250),
            QPointF(150, 250),
            QPoint(0, 0),
            QPoint(0, 30),
            Qt.MouseButton.NoButton,
            Qt.KeyboardModifier.NoModifier,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        QApplication.sendEvent(grid.viewport, wheel)
        assert grid.viewport.look.half_height < turned.half_height

    def test_a_double_click_centres(self, grid, qtbot):
        grid.set_panels(panels(1))
        grid.set_view("concave")
        target = flank_place(grid, 0) + QPointF(20, 4)
        press(grid, target, QEvent.Type.MouseButtonDblClick)
        assert grid.viewport.look.half_height > 0
        x, y = grid.viewport.look.project(grid.viewport.look.focal)
        assert (x, y) == pytest.approx((0.0, 0.0), abs=1e-9)

    @pytest.mark.parametrize("key", "wsqpc3r")
    def test_keys_do_nothing_to_the_picture(self, grid, qtbot, key):
        grid.set_panels(panels(1))
        settled(qtbot, grid)
        before = grid.viewport.grabFramebuffer()
        event = QKeyEvent(QEvent.Type.KeyPress, ord(key.upper()), Qt.KeyboardModifier.NoModifier, key)
        QApplication.sendEvent(grid.viewport, event)
        settled(qtbot, grid)
        assert grid.viewport.grabFramebuffer() == before

    def test_takes_no_dropped_files(self, grid):
        assert not grid.viewport.acceptDrops()


def test_default_layers_are_on_and_views_close_twice(grid):
    assert grid.visible_layers == DEFAULT_VISIBLE
    grid.close_views()
    grid.close_views()


class TestColorBar:
    @pytest.fixture
    def bar(self, qtbot):
        from ui.color_bar import ColorBar

        made = ColorBar()
        qtbot.addWidget(made)
        made.resize(made.sizeHint().expandedTo(made.minimumSize()).width(), 400)
        made.show()
        return made

    def test_follows_the_data_until_it_is_set(self, bar, qtbot):
        with qtbot.waitSignal(bar.range_changed) as told:
            bar.set_data_limit(52.8)
        assert told.args == pytest.approx([-60.0, 60.0])
        bar.set_limit(5.0)
        bar.set_data_limit(80.0)
        assert bar.limit == 5.0 and not bar.automatic
        bar.set_automatic(True)
        assert bar.limit == pytest.approx(80.0)

    def test_is_painted_from_warm_to_cold(self, bar, qtbot):
        bar.set_data_limit(1.0)
        picture = bar.grab().toImage()
        ratio = picture.devicePixelRatio()
        column = [picture.pixelColor(int(14 * ratio), int(y * ratio)) for y in (60, 330)]
        assert column[0].red() > column[0].blue() + 40 and column[1].blue() > column[1].red() + 40


class TestRollSlider:
    @pytest.fixture
    def slider(self, qtbot):
        from ui.roll_slider import RollSlider

        made = RollSlider()
        qtbot.addWidget(made)
        return made

    def test_plays_from_the_start_and_pauses(self, slider, qtbot):
        slider.set_span(30.0)
        with qtbot.waitSignal(slider.rolled) as told:
            slider.play()
        assert told.args[0] < 0.5 and slider.playing
        slider.pause()
        assert not slider.playing

    def test_moves_silently_when_told(self, slider, qtbot):
        with qtbot.assertNotEmitted(slider.rolled):
            slider.set_roll(0.25)
        assert slider.roll == pytest.approx(0.25)
