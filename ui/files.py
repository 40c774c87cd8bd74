"""Design files and exports: the dialogs around them, and what can go wrong."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QDir, QObject, QStandardPaths, Signal
from PySide6.QtWidgets import QFileDialog, QMessageBox

from gearstudio.design import Design
from gearstudio.errors import FileError
from ui.export_dialog import ExportDialog
from ui.projects.lock import ProjectLock, ask_how_to_open
from ui.projects.problems import not_opened, problem_line
from ui.reading import Found, Reading, Take, read
from ui.session import Session
from ui.words import noted, told, tr

if TYPE_CHECKING:
    from gearstudio.presets import Preset
    from ui.inheritance import Inheritance
    from ui.main_window import MainWindow

SUFFIX = ".gear.toml"
FILTER = noted("Gear designs (*.gear.toml);;All files (*)")
Answer = QMessageBox.StandardButton


class Files(QObject):
    """Opens and saves designs for a window; nothing unsaved is dropped without a question.

    With ``reading`` a file is opened a little later, when it has been read; the one asked for last.

    Signals
    -------
    opened()
        Another design is in the session.
    file_used(object)
        Path of a design file that was opened or saved.
    saved(object)
        Path of a design file that was just written.
    export_requested(object)
        An ExportJob.
    """

    opened = Signal()
    file_used = Signal(object)
    saved = Signal(object)
    export_requested = Signal(object)

    def __init__(
        self,
        session: Session,
        window: MainWindow,
        inheritance: Inheritance | None = None,
        reading: Reading | None = None,
    ) -> None:
        super().__init__(window)
        self._session = session
        self._window = window
        self._reading = reading
        if reading is not None:
            window.closing.connect(reading.close)
        self.lock = inheritance.lock if inheritance else ProjectLock()
        window.closing.connect(self.lock.release)
        documents = QStandardPaths.StandardLocation.DocumentsLocation
        self._folder = QStandardPaths.writableLocation(documents) or QDir.homePath()
        if inheritance is not None:
            self._folder = inheritance.folder

    @property
    def folder(self) -> str:
        """Where dialogs begin."""
        return self._folder

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
        name, _ = QFileDialog.getOpenFileName(self._window, tr("Open design"), self._folder, tr(FILTER))
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
            self._window.messages.show_message("error", told(error), topic="file")

    def open_path(self, path: Path) -> None:
        """Open a design file; when it cannot be used, say why and keep what there is."""
        self._read(path, lambda found: self._open_found(found, path))

    def reopen(self, path: Path | None, then: Callable[[bool], object]) -> None:
        """Open what a recovered draft belongs to, and tell whether the user agreed.

        That is its design file, or the default design where there is none now. A file that cannot be read is spared:
        to save asks for a name.
        """
        if path is None:
            self.new()
            then(not self._session.unsaved)
            return

        def take(found: Found) -> None:
            if isinstance(found, Design):
                then(self._open_as(found, path))
            else:
                then(self._open_as(Design(), path, saved=False, spared=path.exists()))

        self._read(path, take)

    def _read(self, path: Path, take: Take) -> None:
        if self._reading is None:
            take(read(path))
        else:
            self._reading.read(path, take)

    def _open_found(self, found: Found, path: Path) -> None:
        if isinstance(found, Design):
            self._open_as(found, path)
            return
        text, details = not_opened(path, found)
        self._window.messages.show_message("error", text, details, topic="file")

    def _open_as(self, design: Design, path: Path, saved: bool = True, spared: bool = False) -> bool:
        if not self.may_discard():
            return False
        holder = self.lock.take(path)
        way = ask_how_to_open(self._window, path, holder) if holder else "read_only" if spared else "write"
        if not way:
            return False
        self._folder = str(path.parent)
        self._take(design, None if way == "copy" else path, way, saved)
        return True

    def save(self) -> bool:
        """Save under the same name, or ask for one; False when nothing was saved."""
        path = None if self._session.read_only else self._session.path
        return self._write(path) if path is not None else self.save_as()

    def save_as(self, folder: Path | None = None) -> bool:
        """Ask for a name (in a folder) and save; False when nothing was saved."""
        self._session.settle()
        known = self._session.path
        name = known.name if known else f"{_file_name(self._session.design.name)}{SUFFIX}"
        start = (folder or (known.parent if known else Path(self._folder))) / name
        name, _ = QFileDialog.getSaveFileName(self._window, tr("Save design"), str(start), tr(FILTER))
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
            tr("Unsaved changes"),
            tr("Save the changes to “{name}”?", name=self._session.title),
            Answer.Save | Answer.Discard | Answer.Cancel,
            self._window,
        )
        box.setInformativeText(tr("They are lost if you do not save them."))
        box.setDefaultButton(Answer.Save)
        answer = box.exec()
        return answer == Answer.Discard or (answer == Answer.Save and self.save())

    def export(self) -> None:
        """Ask what goes where, and request it."""
        mode = self._window.commands.modes.checkedAction().data()
        self._session.settle()
        dialog = ExportDialog(self._session, self._folder, self._window, self._window.settings, mode)
        if dialog.exec():
            job = dialog.job()
            self._folder = str(job.directory)
            self.export_requested.emit(job)

    def _take(self, design: Design, path: Path | None, way: str = "write", saved: bool = True) -> None:
        if self._reading is not None:
            self._reading.forget()
        self._window.messages.clear("file")
        if path is None or way != "write":
            self.lock.release()
        self._session.load(design, path, saved=saved and way != "copy", read_only=way == "read_only")
        self.opened.emit()
        if path is not None:
            self.file_used.emit(path)

    def _write(self, path: Path) -> bool:
        from gearstudio.project import save_design

        self._session.settle()
        wrong = [issue for issue in self._session.issues if issue.severity == "error"]
        if path == self._session.path and not path.parent.is_dir():
            return self._ask_for_another_folder(path)
        holder = self.lock.take(path)
        if holder is not None:
            text = tr(
                "{name} was not saved: it is open in another GearStudio window ({holder})",
                name=path.name,
                holder=holder,
            )
            self._window.messages.show_message("error", text, topic="file")
            return False
        try:
            save_design(path, self._session.design)
        except FileError as error:
            if self._session.path is not None and not self._session.read_only:
                self.lock.take(self._session.path)
            text = tr("{name} was not saved: {problem}", name=path.name, problem=told(error.reason))
            self._window.messages.show_message("error", text, str(path), topic="file")
            return False
        self._folder = str(path.parent)
        self._session.mark_saved(path, self._session.design)
        self.file_used.emit(path)
        self.saved.emit(path)
        if wrong:
            text = tr(
                "Saved the last good design; {count} field(s) with problems are not in {name}",
                count=len(wrong),
                name=path.name,
            )
            self._window.messages.show_message("warning", text, "\n".join(map(problem_line, wrong)), topic="file")
            return False
        self._window.messages.clear("file")
        return True

    def _ask_for_another_folder(self, path: Path) -> bool:
        """The folder of the design has vanished; whether it was saved elsewhere."""
        box = QMessageBox(
            QMessageBox.Icon.Warning,
            tr("Folder not found"),
            tr("The folder of “{name}” is no longer there:\n{folder}", name=path.name, folder=path.parent),
            Answer.Save | Answer.Cancel,
            self._window,
        )
        box.setInformativeText(tr("Nothing is lost: save the design in another folder."))
        if box.exec() != Answer.Save:
            return False
        documents = QStandardPaths.writableLocation(QStandardPaths.StandardLocation.DocumentsLocation)
        return self.save_as(Path(documents or QDir.homePath()))


def _file_name(title: str) -> str:
    """A design's name as a file name."""
    kept = "".join(letter if letter.isalnum() or letter in "-_" else "-" for letter in title.strip().lower())
    return "-".join(filter(None, kept.split("-"))) or "design"
