"""What the dialogs of pictures and films share: a stand-in of the views, painted while the window stays live."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QSize, QTimer
from PySide6.QtWidgets import QDialog, QFileDialog, QFormLayout, QHBoxLayout, QProgressBar, QVBoxLayout

from ui.views.pictures import Steps, stand_in

if TYPE_CHECKING:
    from ui.main_window import MainWindow
    from ui.view_grid import ViewGrid


class PaintingDialog(QDialog):
    """Paints a piece with each turn of the event loop; closed, it gives up what it paints."""

    def __init__(self, window: MainWindow, folder: str, title: str) -> None:
        super().__init__(window)
        self._window, self._folder = window, folder
        self._copy: ViewGrid | None = None
        self._steps: Steps | None = None
        self._timer = QTimer(self, interval=0)
        self._timer.timeout.connect(self._advance)
        self._bar = QProgressBar()
        self._bar.setTextVisible(False)
        self.setWindowTitle(title)

    def done(self, result: int) -> None:
        """Give up what is being painted."""
        self._drop()
        super().done(result)

    def _advance(self) -> None:
        """Paint the next piece."""
        raise NotImplementedError

    def _lay_out(self, form: QFormLayout, buttons: QHBoxLayout) -> None:
        layout = QVBoxLayout(self)
        layout.addLayout(form)
        layout.addWidget(self._bar)
        layout.addLayout(buttons)

    def _ask_for_file(self, title: str, name: str, kinds: str) -> Path | None:
        """A path with an ending, that of ``name`` where the user gave none; None when there is to be no file."""
        start = Path(self._folder) / name
        chosen, _ = QFileDialog.getSaveFileName(self, title, str(start), kinds)
        if not chosen:
            return None
        return Path(chosen) if Path(chosen).suffix else Path(chosen + start.suffix)

    def _stand_in(self, size: QSize) -> ViewGrid:
        """The views in another size, until `_drop`."""
        grid = self._window.area.grid
        assert grid is not None
        self._copy = stand_in(grid, size)
        return self._copy

    def _drop(self) -> None:
        self._timer.stop()
        self._steps = None
        if self._copy is not None:
            self._copy.close_views()
            self._copy.deleteLater()
            self._copy = None

    def _say(self, severity: str, text: str) -> None:
        self._window.messages.show_message(severity, text, topic="file")
