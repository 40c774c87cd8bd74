"""One window writes a design file; a second one is told so."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QLockFile, QSysInfo
from PySide6.QtWidgets import QMessageBox, QWidget

from ui.words import tr


@dataclass(frozen=True)
class Holder:
    """The process that has a design open."""

    process_id: int
    host: str

    def __str__(self) -> str:
        if self.host == QSysInfo.machineHostName():
            return tr("process {number}", number=self.process_id)
        return tr("process {number} on {host}", number=self.process_id, host=self.host)


class ProjectLock:
    """A hidden file beside the design, with the number of the process that has it open.

    One that a dead process left is taken over. Where no such file can be made (a folder that is only for reading)
    there is no lock, and none is needed to read.
    """

    def __init__(self) -> None:
        self._lock: QLockFile | None = None
        self._path: Path | None = None

    def take(self, path: Path) -> Holder | None:
        """Lock a design file in place of the one before; who has it instead, when that fails (then nothing changes)."""
        path = path.absolute()
        if path == self._path:
            return None
        lock = QLockFile(str(path.with_name(f".{path.name}.lock")))
        lock.setStaleLockTime(0)
        if not lock.tryLock(0) and lock.error() == QLockFile.LockError.LockFailedError:
            process_id, host, _ = lock.getLockInfo()
            return Holder(int(process_id), str(host))
        self.release()
        self._lock, self._path = lock, path
        return None

    def release(self) -> None:
        """Let others have the design."""
        if self._lock is not None:
            self._lock.unlock()
        self._lock = self._path = None


def ask_how_to_open(window: QWidget, path: Path, holder: Holder) -> str:
    """What to do with a design that is open elsewhere: ``"read_only"``, ``"copy"`` or, not at all, empty."""
    box = QMessageBox(window)
    box.setIcon(QMessageBox.Icon.Question)
    box.setWindowTitle(tr("Design in use"))
    box.setText(tr("“{name}” is open in another GearStudio window ({holder}).", name=path.name, holder=holder))
    box.setInformativeText(
        tr("Only one window can save it. Read-only, Save asks for another name; a copy starts as a new design.")
    )
    read_only = box.addButton(tr("Open &read-only"), QMessageBox.ButtonRole.AcceptRole)
    copy = box.addButton(tr("Open a &copy"), QMessageBox.ButtonRole.AcceptRole)
    box.addButton(QMessageBox.StandardButton.Cancel)
    box.setDefaultButton(read_only)
    box.exec()
    if box.clickedButton() is read_only:
        return "read_only"
    return "copy" if box.clickedButton() is copy else ""
