"""The dialog of films: what moves, how long, how large; a frame for each turn of the event loop."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QSize
from PySide6.QtGui import QImage
from PySide6.QtWidgets import (
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
)

from gearstudio.errors import FileError
from ui.analysis.background import Newest
from ui.views.film import Film
from ui.views.motions import Motion
from ui.views.painting_dialog import PaintingDialog
from ui.views.pictures import PictureOptions, painted
from ui.views.quiet import QuietChoice, QuietSlider
from ui.words import told, tr

if TYPE_CHECKING:
    from ui.camera import Camera
    from ui.main_window import MainWindow

SIZES = ((640, 480), (1280, 720), (1920, 1080), (1080, 1080))
RATES = (12, 25, 30, 50)
FILTER = "MP4 (*.mp4);;GIF (*.gif)"


class FilmDialog(PaintingDialog):
    """Films a stand-in of the views, so that one can go on working; Cancel leaves no file."""

    def __init__(self, window: MainWindow, folder: str, motions: Sequence[Motion]) -> None:
        super().__init__(window, folder, tr("Film"))
        self._motions = {motion.id: motion for motion in motions}
        self._film: Film | None = None
        self._looks: list[Camera] = []
        self._path = Path()
        self._frame = self._frames = 0
        self._closing = Newest("film", self)
        self._closing.done.connect(lambda path, _found: self._on_written(path))
        self._closing.failed.connect(lambda _path, text, _details: self._fail(text))
        rows = [(motion.id, motion.title) for motion in motions]
        self.motion = QuietChoice(rows, tr("Motion"), tr("What moves in the film"))
        self.motion.show_choice(rows[-1][0])
        self.seconds = QuietSlider(1, 30, "{} s", tr("Length"), tr("Length of the film"))
        self.seconds.show_value(6)
        self.rate = QuietChoice([(n, f"{n}/s") for n in RATES], tr("Frames"), tr("Frames in a second"))
        self.rate.show_choice(25)
        sizes = [((w, h), f"{w} × {h}") for w, h in SIZES]
        self.frame_size = QuietChoice(sizes, tr("Size"), tr("Size of the film in pixels"))
        self.frame_size.setCurrentIndex(1)
        self._state = QLabel()
        self._state.setProperty("role", "muted")
        self._lay_out(self._make_form(), self._make_buttons())

    def _make_form(self) -> QFormLayout:
        form = QFormLayout()
        for title, widget in (
            (tr("Motion"), self.motion),
            (tr("Length"), self.seconds),
            (tr("Frames"), self.rate),
            (tr("Size"), self.frame_size),
        ):
            form.addRow(title, widget)
        return form

    def _make_buttons(self) -> QHBoxLayout:
        self._save = QPushButton(tr("&Save…"))
        self._save.setToolTip(tr("Save as .mp4 or .gif"))
        self._save.setDefault(True)
        self._save.clicked.connect(self._on_save)
        cancel = QPushButton(tr("Cancel"))
        cancel.setToolTip(tr("Give the film up; no file is left"))
        cancel.clicked.connect(self.reject)
        buttons = QHBoxLayout()
        buttons.addWidget(self._state, 1)
        buttons.addWidget(self._save)
        buttons.addWidget(cancel)
        return buttons

    def _on_save(self) -> None:
        path = self._ask_for_file(tr("Save film"), f"{self.motion.currentData()}.mp4", FILTER)
        if path is not None:
            self.begin(path)

    def begin(self, path: Path) -> None:
        """Film into a file."""
        bar = self._window.area.color_bar
        assert bar is not None
        width, height = self.frame_size.currentData()
        try:
            self._film = Film(path, (width, height), self.rate.currentData())
        except FileError as error:
            self._fail(told(error))
            return
        self._path = path
        beside = bar.sizeHint().width() if bar.isVisible() else 0
        self._looks = list(self._stand_in(QSize(width - beside, height)).viewport.looks)
        self._frame, self._frames = 0, self.seconds.slider.value() * self.rate.currentData()
        self._bar.setRange(0, self._frames)
        for widget in (self._save, self.motion, self.seconds, self.rate, self.frame_size):
            widget.setEnabled(False)
        self._timer.start()

    def _advance(self) -> None:
        """A piece of a frame."""
        assert self._copy is not None and self._film is not None
        try:
            if self._steps is None:
                motion, bar = self._motions[self.motion.currentData()], self._window.area.color_bar
                last = self._frames if motion.loops else max(self._frames - 1, 1)
                motion.show(self._copy, self._looks, self._frame / last)
                shown = bar if bar is not None and bar.isVisible() else None
                self._steps = painted(self._copy, shown, PictureOptions())
            next(self._steps)
        except StopIteration as end:
            self._steps = None
            self._take(end.value)
        except RuntimeError as error:
            self._fail(told(error))

    def _take(self, frame: QImage) -> None:
        assert self._film is not None
        try:
            self._film.add(frame)
        except FileError as error:
            self._fail(told(error))
            return
        self._frame += 1
        self._bar.setValue(self._frame)
        self._state.setText(tr("frame {n} of {all}", n=self._frame, all=self._frames))
        if self._frame == self._frames:
            self._timer.stop()
            self._state.setText(tr("writing…"))
            self._closing.request(self._path, self._film.finish)
            self._film = None

    def _on_written(self, path: Path) -> None:
        self._say("info", tr("Saved the film as {path}", path=path))
        self.accept()

    def _fail(self, text: str) -> None:
        self._say("error", text)
        self.reject()

    def done(self, result: int) -> None:
        """Give up what is being filmed."""
        if self._film is not None:
            self._film.give_up()
            self._film = None
        self._closing.close()
        super().done(result)
