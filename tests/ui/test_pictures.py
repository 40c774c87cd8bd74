"""Pictures and films of the views: into files, onto the clipboard, at any scale, with every frame."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication

from tests.ui.made_up_solid import solid_of
from tests.ui.screen import NEEDS_SCREEN
from tests.ui.views_bench import bench_with_views, changed, flank_place, grid_of, pixels
from ui.solids import meshed

pytestmark = NEEDS_SCREEN


@pytest.fixture
def bench(qtbot):
    yield from bench_with_views(qtbot)


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


class TestClipboard:
    def copied(self, bench, qtbot, **boxes) -> QImage:
        from ui.views.picture_dialog import PictureDialog

        clipboard = QApplication.clipboard()
        clipboard.clear()
        dialog = PictureDialog(bench.window, "")
        dialog.scale.show_choice(1)
        for name, on in boxes.items():
            getattr(dialog, name).setChecked(on)
        dialog.open()
        dialog._clip.click()
        qtbot.waitUntil(lambda: not clipboard.image().isNull(), timeout=20000)
        assert "clipboard" in bench.window.messages._full
        dialog.reject()
        return clipboard.image()

    def test_a_copied_picture_is_what_is_seen(self, bench, qtbot):
        grid, bar = grid_of(bench), bench.window.area.color_bar
        size, screen = QSize(grid.width() + bar.sizeHint().width(), grid.height()), pixels(grid.screenshot())
        image = self.copied(bench, qtbot)
        assert image.size() == size
        assert changed(pixels(image)[:, : screen.shape[1]], screen) < 0.12
        assert image.pixelColor(grid.width() // 6, 4).alpha() == 255

    def test_with_a_transparent_background_it_is_clear_where_nothing_is(self, bench, qtbot):
        grid = grid_of(bench)
        grid.set_visible_layers({"deviation"})
        grid.set_view("fit")
        size = grid.size()
        image = self.copied(bench, qtbot, transparent=True, labels=False)
        assert image.size() == size and image.hasAlphaChannel()
        clear = image.convertToFormat(QImage.Format.Format_Alpha8)
        raw = np.frombuffer(clear.constBits(), np.uint8).reshape(clear.height(), clear.bytesPerLine())
        alpha = raw[:, : clear.width()]
        assert (alpha == 0).mean() > 0.2 and (alpha == 255).mean() > 0.02
        assert alpha[3, 3] == 0


def frames_of(path: Path) -> list[np.ndarray]:
    """The pictures of a film, as it is played."""
    import imageio_ffmpeg

    reader = imageio_ffmpeg.read_frames(str(path))
    assert next(reader)["size"] == (640, 480)
    return [np.frombuffer(frame, np.uint8).astype(int) for frame in reader]


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
        grid_of(bench).set_visible_layers({"generating_line", "tangent_plane", "tooth"})
        path = tmp_path / f"film.{suffix}"
        dialog = self.film(bench, path, motion)
        qtbot.waitUntil(lambda: not dialog.isVisible(), timeout=60000)
        frames = frames_of(path)
        assert len(frames) == 12
        assert all(np.abs(a - b).mean() > 0.2 for a, b in pairwise(frames))
        assert [p.name for p in tmp_path.iterdir()] == [path.name]

    @staticmethod
    def show_pair(bench, qtbot):
        mode = bench.controller.solid_mode
        mode.set_mode("pair")
        design = bench.session.design
        for key in mode.keys:
            mode.solids.built[key] = meshed(design, solid_of(design, key.member))
        mode.redraw()
        qtbot.waitUntil(lambda: len(mode.sight.view.gears) == 2, timeout=20000)
        return mode

    @pytest.mark.parametrize("suffix", ["mp4", "gif"])
    def test_the_pair_meshes_on_by_one_tooth_and_joins_its_beginning(self, bench, qtbot, tmp_path, suffix):
        import imageio_ffmpeg

        self.show_pair(bench, qtbot)
        path = tmp_path / f"meshing.{suffix}"
        dialog = self.film(bench, path, "meshing")
        qtbot.waitUntil(lambda: not dialog.isVisible(), timeout=90000)
        frames = frames_of(path)
        assert len(frames) == 12
        assert imageio_ffmpeg.count_frames_and_secs(str(path))[1] == pytest.approx(1.0, abs=0.1)
        steps = [np.abs(a - b).mean() for a, b in pairwise(frames)]
        assert min(steps) > 0.3
        assert np.abs(frames[-1] - frames[0]).mean() < 1.5 * max(steps)
        assert np.abs(frames[6] - frames[0]).mean() > 1.3 * min(steps)

    def test_one_pitch_on_looks_like_the_beginning(self, bench, qtbot):
        from ui.views.motions import meshing
        from ui.views.pictures import PictureOptions, at_once, painted, stand_in

        mode = self.show_pair(bench, qtbot)
        motion = meshing(bench.session.pair, mode.sight.view)
        copy = stand_in(grid_of(bench), QSize(640, 480))
        looks = list(copy.viewport.looks)
        shown = []
        for place in (0.0, 0.5, 1.0):
            motion.show(copy, looks, place)
            shown.append(pixels(at_once(painted(copy, None, PictureOptions(labels=False)))))
        copy.close_views()
        assert changed(shown[0], shown[2]) < 0.01 < 0.03 < changed(shown[0], shown[1])

    def test_cancel_leaves_nothing(self, bench, qtbot, tmp_path):
        dialog = self.film(bench, tmp_path / "film.mp4", "turntable")
        qtbot.waitUntil(lambda: dialog._frame >= 2, timeout=20000)
        dialog.reject()
        assert list(tmp_path.iterdir()) == []

    def test_an_unknown_kind_is_refused(self, bench, tmp_path):
        dialog = self.film(bench, tmp_path / "film.xyz", "turntable")
        assert not dialog.isVisible() and list(tmp_path.iterdir()) == []
