"""The dialog of pictures: of the views or the whole window, at a chosen scale, into a file or the clipboard."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, QTimer
from PySide6.QtGui import QGuiApplication, QImage, QPainter
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from gearstudio.errors import FileError
from ui.views.picture_files import write_picture
from ui.views.pictures import PictureOptions, Steps, painted, stand_in
from ui.views.quiet import QuietChoice
from ui.words import told, tr

if TYPE_CHECKING:
    from ui.main_window import MainWindow
    from ui.view_grid import ViewGrid

MOST_SCALE = 4
FILTER = "PNG (*.png);;JPEG (*.jpg)"


class PictureDialog(QDialog):
    """Paints piece by piece, so that the window stays live; another choice begins anew."""

    def __init__(self, window: MainWindow, folder: str) -> None:
        super().__init__(window)
        self._window, self._folder = window, folder
        self._steps: Steps | None = None
        self._copy: ViewGrid | None = None
        self._target: Path | None = None
        self._timer = QTimer(self, interval=0)
        self._timer.timeout.connect(self._advance)
        self.setWindowTitle(tr("Picture"))
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
        self._bar = QProgressBar()
        self._bar.setRange(0, 1000)
        self._bar.setTextVisible(False)
        self._lay_out()
        for choice in (self.subject, self.scale):
            choice.currentIndexChanged.connect(self._show_size)
        self._show_size()

    def _lay_out(self) -> None:
        form = QFormLayout()
        form.addRow(tr("Picture of"), self.subject)
        form.addRow(tr("Scale"), self.scale)
        form.addRow("", self._size)
        form.addRow("", self.transparent)
        form.addRow("", self.labels)
        self._save = QPushButton(tr("Save…"))
        self._save.setDefault(True)
        self._save.setToolTip(tr("Save as .png or .jpg"))
        self._save.clicked.connect(self._on_save)
        self._clip = QPushButton(tr("Copy"))
        self._clip.setToolTip(tr("Copy the picture to the clipboard"))
        self._clip.clicked.connect(lambda: self._begin(None))
        close = QPushButton(tr("Close"))
        close.setToolTip(tr("Close; what is being painted is given up"))
        close.clicked.connect(self.reject)
        buttons = QHBoxLayout()
        buttons.addStretch(1)
        for button in (self._clip, self._save, close):
            buttons.addWidget(button)
        layout = QVBoxLayout(self)
        layout.addLayout(form)
        layout.addWidget(self._bar)
        layout.addLayout(buttons)

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
        start = str(Path(self._folder) / "gearstudio.png")
        name, _ = QFileDialog.getSaveFileName(self, tr("Save picture"), start, FILTER)
        if name:
            self._begin(Path(name) if Path(name).suffix else Path(name + ".png"))

    def _begin(self, target: Path | None) -> None:
        """Start painting, for a file or for the clipboard."""
        self._drop()
        grid, bar = self._window.area.grid, self._window.area.color_bar
        assert grid is not None
        self._target = target
        self._copy = stand_in(grid, grid.size())
        self._steps = painted(self._copy, bar, self.options)
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
            self._window.messages.show_message("error", tr("No picture: {why}", why=error), topic="file")

    def _take(self, views: QImage) -> None:
        picture = views if self.subject.currentData() != "window" else window_picture(self._window, views)
        self._bar.setValue(0)
        if self._target is None:
            QGuiApplication.clipboard().setImage(picture)
            self._window.messages.show_message("info", tr("The picture is on the clipboard"), topic="file")
            return
        try:
            write_picture(self._target, picture)
        except FileError as error:
            self._window.messages.show_message("error", told(error), topic="file")
            return
        self._window.messages.show_message("info", tr("Saved the picture as {path}", path=self._target), topic="file")
        self.accept()

    def _drop(self) -> None:
        self._timer.stop()
        self._steps = None
        if self._copy is not None:
            self._copy.close_views()
            self._copy.deleteLater()
            self._copy = None

    def done(self, result: int) -> None:
        """Give up what is being painted."""
        self._drop()
        super().done(result)


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
