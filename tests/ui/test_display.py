"""The display of the views in a real window: what is chosen is seen, remembered and pictured."""

from __future__ import annotations

import os
import sys
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPointF, QSettings, Qt
from PySide6.QtGui import QImage, QKeyEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDockWidget

from tests.ui.made_up import result_of
from tests.ui.stand_ins import Bench
from ui.main_window import MainWindow
from ui.session import Session
from ui.views.appearance import Appearance, LayerLook

pytestmark = [
    pytest.mark.ui,
    pytest.mark.gl,
    pytest.mark.skipif(
        os.environ.get("QT_QPA_PLATFORM") == "offscreen"
        or (sys.platform.startswith("linux") and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))),
        reason="needs a screen with OpenGL",
    ),
]
AMOUNTS = {"rotating_line": 30.0, "profile_sweep": -30.0, "point_cloud": 0.0}


@pytest.fixture
def bench(qtbot):
    from ui.color_bar import ColorBar
    from ui.mesh_bar import MeshBar
    from ui.roll_slider import RollSlider
    from ui.view_grid import ViewGrid

    made = Bench()
    made.window.resize(1280, 800)
    made.window.show()
    made.window.area.adopt(ViewGrid(), ColorBar(), RollSlider(), MeshBar())
    made.controller.views_ready()
    session = made.session
    session.select(variant="published")
    for method, amount in AMOUNTS.items():
        result = result_of(session.pair.member("wheel"), lambda u, v, a=amount: a + 0 * u, method=method)
        session.put_result(session.design, result)
    made.controller.presenter.redraw()
    made.window.area.grid.set_view("concave")
    qtbot.wait(300)
    yield made
    made.close()


def grid_of(bench):
    return bench.window.area.grid


def show(qtbot, bench, **changes) -> np.ndarray:
    grid = grid_of(bench)
    bench.controller.display.show_appearance(replace(grid.appearance, **changes))
    qtbot.wait(400)
    return pixels(grid.viewport.grabFramebuffer())


def pixels(image: QImage) -> np.ndarray:
    image = image.convertToFormat(QImage.Format.Format_RGBA8888)
    return np.array(image.constBits()).reshape(image.height(), image.width(), 4).astype(int)


def flank_place(grid, pane: int) -> QPointF:
    layer = next(x for x in grid.panels[pane].layers if x.key == "deviation/concave")
    x, y = grid.viewport.looks[pane].project(layer.points[len(layer.points) // 2])
    return grid.viewport.place_of(pane, float(x), float(y))


def changed(one: np.ndarray, other: np.ndarray) -> float:
    return float((np.abs(one - other).max(axis=2) > 24).mean())


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

    def test_a_click_beside_the_flanks_picks_nothing(self, bench, qtbot):
        grid = grid_of(bench)
        QTest.mouseClick(grid.viewport, Qt.MouseButton.LeftButton, pos=QPointF(4, grid.height() - 4).toPoint())
        assert grid.pointing.pin is None


class TestPictures:
    def test_shows_what_the_screen_shows_at_any_scale(self, bench, qtbot):
        from ui.views.pictures import PictureOptions, at_once, painted, stand_in

        grid = grid_of(bench)
        screen = pixels(grid.viewport.grabFramebuffer())
        copy = stand_in(grid, grid.size())
        try:
            for scale in (1, 3):
                picture = at_once(painted(copy, None, PictureOptions(scale, labels=False)))
                assert picture.size() == grid.size() * scale
                small = pixels(picture.scaled(grid.size(), mode=Qt.TransformationMode.SmoothTransformation))
                assert changed(small, screen) < 0.06
                for pane in range(3):
                    place = flank_place(grid, pane).toPoint()
                    here, there = small[place.y(), place.x()], screen[place.y(), place.x()]
                    assert np.abs(here - there).max() < 24
            copy.set_view("iso")
            clear = pixels(at_once(painted(copy, None, PictureOptions(1, transparent=True, labels=False))))
            assert clear[3, 3, 3] == 0 and clear[..., 3].max() == 255
        finally:
            copy.close_views()
        assert changed(pixels(grid.viewport.grabFramebuffer()), screen) < 0.001

    def test_the_colour_scale_stands_beside_it(self, bench, qtbot):
        from ui.views.pictures import PictureOptions, at_once, painted, stand_in

        grid, bar = grid_of(bench), bench.window.area.color_bar
        copy = stand_in(grid, grid.size())
        picture = pixels(at_once(painted(copy, bar, PictureOptions(2))))
        copy.close_views()
        beside = picture[:, 2 * grid.width() :]
        warm, cold = beside[..., 0] - beside[..., 2] > 60, beside[..., 2] - beside[..., 0] > 60
        assert warm.any() and cold.any() and np.argwhere(warm)[:, 0].mean() < np.argwhere(cold)[:, 0].mean()

    def test_the_dialog_saves_whole_files(self, bench, qtbot, tmp_path):
        from ui.views.picture_dialog import PictureDialog

        dialog, height = PictureDialog(bench.window, str(tmp_path)), grid_of(bench).height()
        dialog.open()
        dialog._begin(tmp_path / "views.png")
        qtbot.waitUntil(lambda: not dialog.isVisible(), timeout=20000)
        assert QImage(str(tmp_path / "views.png")).height() == 2 * height
        dialog.open()
        dialog.subject.show_choice("window")
        dialog._begin(tmp_path / "window.jpg")
        qtbot.waitUntil(lambda: not dialog.isVisible(), timeout=20000)
        assert QImage(str(tmp_path / "window.jpg")).size() == bench.window.size() * 2


class TestFilms:
    def film(self, bench, path: Path, motion: str):
        from ui.views.film_dialog import FilmDialog

        dialog = FilmDialog(bench.window, str(path.parent), bench.controller.display._motions())
        dialog.motion.show_choice(motion)
        dialog.seconds.slider.setValue(1)
        dialog.rate.show_choice(12)
        dialog.frame_size.setCurrentIndex(0)
        dialog.open()
        dialog.begin(path)
        return dialog

    @pytest.mark.parametrize(("motion", "suffix"), [("turntable", "mp4"), ("rolling", "gif")])
    def test_has_all_frames_and_they_move(self, bench, qtbot, tmp_path, motion, suffix):
        import imageio_ffmpeg

        grid_of(bench).set_visible_layers({"generating_line", "tangent_plane", "tooth"})
        path = tmp_path / f"film.{suffix}"
        dialog = self.film(bench, path, motion)
        qtbot.waitUntil(lambda: not dialog.isVisible(), timeout=60000)
        reader = imageio_ffmpeg.read_frames(str(path))
        assert next(reader)["size"] == (640, 480)
        frames = [np.frombuffer(frame, np.uint8).astype(int) for frame in reader]
        assert len(frames) == 12
        assert all(np.abs(a - b).mean() > 0.2 for a, b in pairwise(frames))
        assert [p.name for p in tmp_path.iterdir()] == [path.name]

    def test_cancel_leaves_nothing(self, bench, qtbot, tmp_path):
        dialog = self.film(bench, tmp_path / "film.mp4", "turntable")
        qtbot.waitUntil(lambda: dialog._frame >= 2, timeout=20000)
        dialog.reject()
        assert list(tmp_path.iterdir()) == []

    def test_an_unknown_kind_is_refused(self, bench, tmp_path):
        dialog = self.film(bench, tmp_path / "film.xyz", "turntable")
        assert not dialog.isVisible() and list(tmp_path.iterdir()) == []


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
