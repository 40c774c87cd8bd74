"""The dialog of pictures: of the views or the whole window, at a chosen scale, into a file or the clipboard."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint
from PySide6.QtGui import QGuiApplication, QImage, QPainter
from PySide6.QtWidgets import (
    QCheckBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QWidget,
)

from gearstudio.errors import FileError
from ui.mnemonics import separate
from ui.views.painting_dialog import PaintingDialog
from ui.views.picture_files import write_picture
from ui.views.pictures import PictureOptions, painted
from ui.views.quiet import QuietChoice
from ui.words import told, tr

if TYPE_CHECKING:
    from ui.main_window import MainWindow

MOST_SCALE = 4
FILTER = "PNG (*.png);;JPEG (*.jpg)"


class PictureDialog(PaintingDialog):
    """Paints piece by piece, so that the window stays live; another choice begins anew."""

    def __init__(self, window: MainWindow, folder: str) -> None:
        super().__init__(window, folder, tr("Picture"))
        self._target: Path | None = None
        rows = [("views", tr("The views")), ("window", tr("The whole window"))]
        self.subject = QuietChoice(rows, tr("Picture of"), tr("What is in the picture"))
        sizes = [(scale, f"{scale}×") for scale in range(1, MOST_SCALE + 1)]
        self.scale = QuietChoice(sizes, tr("Scale"), tr("Pixels of the picture for one on the screen"))
        self.scale.show_choice(2)
        self.transparent = QCheckBox(tr("Transparent background"))
        self.transparent.setToolTip(tr("Clear where nothing is; for slides and papers"))
        self.labels = QCheckBox(tr("Titles, axes and scale bar"), checked=True)  # type: ignore[call-arg]
        self.labels.setToolTip(tr("What is written over the views"))
        self._size = QLabel()
        self._size.setProperty("role", "muted")
        self._bar.setRange(0, 1000)
        self._lay_out(self._make_form(), self._make_buttons())
        for choice in (self.subject, self.scale):
            choice.currentIndexChanged.connect(self._show_size)
        self._show_size()

    def _make_form(self) -> QFormLayout:
        form = QFormLayout()
        form.addRow(tr("Picture of"), self.subject)
        form.addRow(tr("Scale"), self.scale)
        form.addRow("", self._size)
        form.addRow("", self.transparent)
        form.addRow("", self.labels)
        return form

    def _make_buttons(self) -> QHBoxLayout:
        self._save = QPushButton(tr("&Save…"))
        self._save.setDefault(True)
        self._save.setToolTip(tr("Save as .png or .jpg"))
        self._save.clicked.connect(self._on_save)
        self._clip = QPushButton(tr("&Copy"))
        self._clip.setToolTip(tr("Copy the picture to the clipboard"))
        self._clip.clicked.connect(lambda: self._begin(None))
        separate((self._save, self._clip))
        close = QPushButton(tr("Close"))
        close.setToolTip(tr("Close; what is being painted is given up"))
        close.clicked.connect(self.reject)
        buttons = QHBoxLayout()
        buttons.addStretch(1)
        for button in (self._clip, self._save, close):
            buttons.addWidget(button)
        return buttons

    @property
    def options(self) -> PictureOptions:
        """What is chosen."""
        whole = self.subject.currentData() == "window"
        scale, bar = self.scale.currentData(), self._window.area.color_bar
        scaled = not whole and bar is not None and bar.isVisible() and self.labels.isChecked()
        clear = not whole and self.transparent.isChecked()
        return PictureOptions(scale, clear, whole or self.labels.isChecked(), scaled)

    def _show_size(self) -> None:
        whole = self.subject.currentData() == "window"
        for box in (self.transparent, self.labels):
            box.setEnabled(not whole)
        grid, bar = self._window.area.grid, self._window.area.color_bar
        assert grid is not None and bar is not None
        size = self._window.size() if whole else grid.size()
        beside = bar.sizeHint().width() if self.options.scale_bar else 0
        scale = self.options.scale
        text = tr("{w} × {h} pixels", w=(size.width() + beside) * scale, h=size.height() * scale)
        self._size.setText(text)

    def _on_save(self) -> None:
        path = self._ask_for_file(tr("Save picture"), "gearstudio.png", FILTER)
        if path is not None:
            self._begin(path)

    def _begin(self, target: Path | None) -> None:
        """Start painting, for a file or for the clipboard."""
        self._drop()
        grid, bar = self._window.area.grid, self._window.area.color_bar
        assert grid is not None
        self._target = target
        self._steps = painted(self._stand_in(grid.size()), bar, self.options)
        self._timer.start()

    def _advance(self) -> None:
        assert self._steps is not None
        try:
            self._bar.setValue(round(1000 * next(self._steps)))
        except StopIteration as end:
            self._drop()
            self._take(end.value)
        except RuntimeError as error:
            self._drop()
            self._say("error", tr("No picture: {why}", why=error))

    def _take(self, views: QImage) -> None:
        picture = views if self.subject.currentData() != "window" else window_picture(self._window, views)
        self._bar.setValue(0)
        if self._target is None:
            QGuiApplication.clipboard().setImage(picture)
            self._say("info", tr("The picture is on the clipboard"))
            return
        try:
            write_picture(self._target, picture)
        except FileError as error:
            self._say("error", told(error))
            return
        self._say("info", tr("Saved the picture as {path}", path=self._target))
        self.accept()


def window_picture(window: MainWindow, views: QImage) -> QImage:
    """The whole window around a finished picture of its views, at the same scale."""
    grid = window.area.grid
    assert grid is not None
    scale = views.height() / grid.height()
    size = window.size() * scale
    picture = QImage(size, QImage.Format.Format_RGB32)
    painter = QPainter(picture)
    painter.scale(scale, scale)
    flags = QWidget.RenderFlag.DrawWindowBackground | QWidget.RenderFlag.DrawChildren
    window.render(painter, QPoint(0, 0), renderFlags=flags)
    if grid.isVisible():
        painter.resetTransform()
        painter.drawImage(grid.mapTo(window, QPoint(0, 0)) * scale, views)
    painter.end()
    return picture
