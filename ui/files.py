"""Design files, exports and screenshots: the dialogs around them, and what can go wrong."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QDir, QObject, QStandardPaths, Signal
from PySide6.QtWidgets import QFileDialog, QMessageBox

from gearstudio.design import Design
from gearstudio.errors import DesignError, FileError
from ui.export_dialog import ExportDialog
from ui.session import Session

if TYPE_CHECKING:
    from gearstudio.presets import Preset
    from ui.main_window import MainWindow

SUFFIX = ".gear.toml"
FILTER = f"Gear designs (*{SUFFIX});;All files (*)"
Answer = QMessageBox.StandardButton


class Files(QObject):
    """Opens and saves designs for a window; nothing unsaved is dropped without a question.

    Signals
    -------
    opened()
        Another design is in the session.
    export_requested(object)
        An ExportJob.
    """

    opened = Signal()
    export_requested = Signal(object)

    def __init__(self, session: Session, window: MainWindow) -> None:
        super().__init__(window)
        self._session = session
        self._window = window
        documents = QStandardPaths.StandardLocation.DocumentsLocation
        self._folder = QStandardPaths.writableLocation(documents) or QDir.homePath()

    def new(self) -> None:
        """Start from the default design."""
        if self.may_discard():
            self._take(Design(), None)

    def open_preset(self, preset: Preset) -> None:
        """Start from a preset."""
        if self.may_discard():
            self._take(preset.design, None)

    def open(self) -> None:
        """Ask for a file and open it."""
        name, _ = QFileDialog.getOpenFileName(self._window, "Open design", self._folder, FILTER)
        if name:
            self.open_path(Path(name))

    def open_named(self, name: str) -> None:
        """Open a design file, or a preset as ``preset:KEY``."""
        from gearstudio.project import PRESET_PREFIX, open_design

        if not name.startswith(PRESET_PREFIX):
            self.open_path(Path(name))
            return
        try:
            self._take(open_design(name), None)
        except FileError as error:
            self._window.messages.show_message("error", str(error), topic="file")

    def open_path(self, path: Path) -> bool:
        """Open a design file; when it cannot be used, say why and keep what there is."""
        from gearstudio.project import load_design

        try:
            design = load_design(path)
        except DesignError as error:
            count = len(error.issues)
            text = (
                f"{path.name} was not opened: {error.issues[0]}"
                if count == 1
                else (f"{path.name} was not opened: it has {count} problems, the first at {error.issues[0]}")
            )
            self._window.messages.show_message("error", text, "\n".join(map(str, error.issues)), topic="file")
            return False
        except FileError as error:
            self._window.messages.show_message(
                "error", f"{path.name} was not opened: {error.reason}", str(error), topic="file"
            )
            return False
        if not self.may_discard():
            return False
        self._folder = str(path.parent)
        self._take(design, path)
        return True

    def save(self) -> bool:
        """Save under the same name, or ask for one; False when nothing was saved."""
        return self._write(self._session.path) if self._session.path else self.save_as()

    def save_as(self) -> bool:
        """Ask for a name and save; False when nothing was saved."""
        start = self._session.path or Path(self._folder) / f"{_file_name(self._session.design.name)}{SUFFIX}"
        name, _ = QFileDialog.getSaveFileName(self._window, "Save design", str(start), FILTER)
        if not name:
            return False
        path = Path(name)
        return self._write(path if path.suffix else path.with_name(path.name + SUFFIX))

    def may_discard(self) -> bool:
        """Whether the draft may go: it is saved, or the user said so after a question."""
        if not self._session.unsaved:
            return True
        box = QMessageBox(
            QMessageBox.Icon.Question,
            "Unsaved changes",
            f"Save the changes to “{self._session.title}”?",
            Answer.Save | Answer.Discard | Answer.Cancel,
            self._window,
        )
        box.setInformativeText("They are lost if you do not save them.")
        box.setDefaultButton(Answer.Save)
        answer = box.exec()
        return answer == Answer.Discard or (answer == Answer.Save and self.save())

    def export(self) -> None:
        """Ask what goes where, and request it."""
        mode = self._window.commands.modes.checkedAction().data()
        dialog = ExportDialog(self._session, self._folder, self._window, self._window.settings, mode)
        if dialog.exec():
            job = dialog.job()
            self._folder = str(job.directory)
            self.export_requested.emit(job)

    def screenshot(self) -> None:
        """Save a picture of the window."""
        from ui.screenshot import window_image

        picture = window_image(self._window)
        start = str(Path(self._folder) / "gearstudio.png")
        name, _ = QFileDialog.getSaveFileName(self._window, "Save screenshot", start, "Pictures (*.png *.jpg)")
        if not name:
            return
        path = Path(name) if Path(name).suffix else Path(name + ".png")
        if picture.save(str(path)):
            self._window.messages.show_message("info", f"Saved the picture as {path}", topic="file")
        else:
            self._window.messages.show_message("error", f"The picture could not be written to {path}", topic="file")

    def _take(self, design: Design, path: Path | None) -> None:
        self._window.messages.clear("file")
        self._session.load(design, path)
        self.opened.emit()

    def _write(self, path: Path) -> bool:
        from gearstudio.project import save_design

        wrong = [issue for issue in self._session.issues if issue.severity == "error"]
        try:
            save_design(path, self._session.design)
        except FileError as error:
            self._window.messages.show_message(
                "error", f"{path.name} was not saved: {error.reason}", str(error), topic="file"
            )
            return False
        self._folder = str(path.parent)
        self._session.mark_saved(path, self._session.design)
        if wrong:
            text = f"Saved the last good design; {len(wrong)} field(s) with problems are not in {path.name}"
            self._window.messages.show_message("warning", text, "\n".join(map(str, wrong)), topic="file")
            return False
        self._window.messages.clear("file")
        return True


def _file_name(title: str) -> str:
    """A design's name as a file name."""
    kept = "".join(letter if letter.isalnum() or letter in "-_" else "-" for letter in title.strip().lower())
    return "-".join(filter(None, kept.split("-"))) or "design"
