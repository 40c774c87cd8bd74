"""Notices when another program changes the design file that is open, and offers to take its version."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QFileSystemWatcher, QObject, QTimer
from PySide6.QtWidgets import QMessageBox

from ui.projects.versions import saved_version
from ui.words import told, tr

if TYPE_CHECKING:
    from ui.edits import Edits
    from ui.files import Files
    from ui.main_window import MainWindow
    from ui.session import Session

PAUSE_MS = 300
"""A program may write a file in several goes, or replace it by another."""


class FileWatch(QObject):
    """Compares the file with what was last read or written here; taking the other version is one step of Undo."""

    def __init__(self, session: Session, window: MainWindow, files: Files, edits: Edits, parent: QObject) -> None:
        super().__init__(parent)
        self._session, self._window, self._edits = session, window, edits
        self._path: Path | None = None
        self._known: bytes | None = None
        self.question: QMessageBox | None = None
        self._watcher = QFileSystemWatcher(self)
        self._timer = QTimer(self, singleShot=True, interval=PAUSE_MS)
        self._timer.timeout.connect(self.look)
        self._watcher.fileChanged.connect(lambda _path: self._timer.start())
        files.opened.connect(self._follow)
        files.saved.connect(lambda _path: self._follow())
        window.closing.connect(self._timer.stop)
        self._follow()

    def look(self) -> None:
        """Compare now, and ask when the file is another one; a file that is gone is told."""
        path = self._path
        if path is None:
            return
        now = _content(path)
        self._watch(path)
        if now == self._known or self.question is not None:
            return
        self._known = now
        if now is None:
            words = tr("{name} is no longer on the disk; Save writes it again.", name=path.name)
            self._window.messages.show_message("warning", words, str(path), topic="file")
            return
        self._ask(path)

    def _follow(self) -> None:
        path = self._session.path
        if self.question is not None:
            self.question.reject()
        for old in self._watcher.files():
            self._watcher.removePath(old)
        self._path, self._known = path, _content(path) if path is not None else None
        if path is not None:
            self._watch(path)

    def _watch(self, path: Path) -> None:
        if str(path) not in self._watcher.files() and path.is_file():
            self._watcher.addPath(str(path))

    def _ask(self, path: Path) -> None:
        box = self.question = QMessageBox(self._window)
        box.setIcon(QMessageBox.Icon.Question)
        box.setWindowTitle(tr("File changed"))
        box.setText(tr("“{name}” was changed by another program.", name=path.name))
        box.setInformativeText(tr("Its version can be taken, and Undo brings this one back; or keep this one."))
        take = box.addButton(tr("&Take the file"), QMessageBox.ButtonRole.AcceptRole)
        keep = box.addButton(tr("&Keep this one"), QMessageBox.ButtonRole.RejectRole)
        box.setDefaultButton(take)
        box.setEscapeButton(keep)
        box.finished.connect(lambda _result: self._answer(path, box.clickedButton() is take))
        box.open()

    def _answer(self, path: Path, taken: bool) -> None:
        box, self.question = self.question, None
        if box is not None:
            box.deleteLater()
        if not taken or path != self._session.path:
            return
        version = saved_version(path)
        if version.draft is None:
            why = told(version.problems[0]) if version.problems else version.verdict
            words = tr("{name} was not opened: {problem}", name=path.name, problem=why)
            self._window.messages.show_message("error", words, topic="file")
            return
        self._edits.change_many(version.draft, tr("Take the changed file"))
        self._session.settle()
        if not self._session.read_only:
            self._session.mark_saved(path, self._session.design)


def _content(path: Path) -> bytes | None:
    """What the file holds; None when it cannot be read."""
    try:
        return path.read_bytes()
    except OSError:
        return None
