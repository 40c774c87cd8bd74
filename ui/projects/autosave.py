"""Keeps the unsaved draft on the disk, so that a killed program loses a few seconds of edits at most."""

from __future__ import annotations

import contextlib
import logging
import os
import threading
import time
import uuid
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QLockFile, QObject, QTimer, Signal

from gearstudio.errors import FileError
from gearstudio.files import named_errors
from ui.analysis.background import Newest
from ui.projects.snapshot import SUFFIX, Snapshot, read_snapshot, write_snapshot
from ui.session import Session

PAUSE_MS = 2000
OLD_S = 3600.0
log = logging.getLogger(__name__)


class Autosave(QObject):
    """Writes the draft into the recovery folder a pause after its first unsaved change, and again while it changes.

    The file goes when the draft is saved or given up. A lock beside it tells other windows that it is in use;
    the operating system's record of processes tells them when its owner died.

    Signals
    -------
    failed(str)
        The recovery file could not be written: a line for the user, once until it works again.
    """

    failed = Signal(str)

    def __init__(self, session: Session, folder: Path, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        name = f"{os.getpid()}-{uuid.uuid4().hex[:8]}"
        self.file = folder / f"{name}{SUFFIX}"
        self._lock = QLockFile(str(self.file.with_suffix(".lock")))
        self._lock.setStaleLockTime(0)
        self._writing = threading.Lock()
        self._working = True
        self._timer = QTimer(self, singleShot=True, interval=PAUSE_MS)
        self._timer.timeout.connect(self.save)
        self._writer = Newest("autosave", self)
        self._writer.done.connect(lambda *_: setattr(self, "_working", True))
        self._writer.failed.connect(self._on_failed)
        session.document_changed.connect(self._on_document_changed)

    def set_pause(self, seconds: float) -> None:
        """Wait so long after a change; what is already waiting keeps its time."""
        self._timer.setInterval(round(1000 * seconds))

    def save(self) -> None:
        """Write the draft now."""
        session = self._session
        snapshot = Snapshot(session.title, session.path, datetime.now().astimezone(), dict(session.draft))
        self._writer.request("write", lambda: self._write(snapshot))

    def save_and_wait(self) -> None:
        """Write the draft and return when it is on the disk.

        Raises
        ------
        FileError
            It cannot be written.
        """
        session = self._session
        self._write(Snapshot(session.title, session.path, datetime.now().astimezone(), dict(session.draft)))

    def close(self) -> None:
        """The window closes in good order: nothing is left to recover."""
        self._timer.stop()
        self._session.document_changed.disconnect(self._on_document_changed)
        self._writer.close()
        self._remove()
        self._lock.unlock()

    def _write(self, snapshot: Snapshot) -> None:
        with self._writing, named_errors(self.file):
            self.file.parent.mkdir(parents=True, exist_ok=True)
            if not self._lock.isLocked():
                self._lock.tryLock(0)
            write_snapshot(self.file, snapshot)

    def _remove(self) -> None:
        try:
            self.file.unlink(missing_ok=True)
        except OSError as error:
            log.warning("the recovery file stays: %s", error)

    def _on_document_changed(self) -> None:
        if not self._session.unsaved:
            self._timer.stop()
            self._writer.request("remove", self._remove)
        elif not self._timer.isActive():
            self._timer.start()

    def _on_failed(self, _label: object, text: str, _details: str) -> None:
        log.warning("autosave: %s", text)
        if self._working:
            self._working = False
            self.failed.emit(text)


@dataclass
class Abandoned:
    """A snapshot whose program died. The lock is held, so that no other window offers it too."""

    file: Path
    snapshot: Snapshot
    lock: QLockFile

    def discard(self) -> None:
        """Remove it for good."""
        self.file.unlink(missing_ok=True)
        self.lock.unlock()

    def leave(self) -> None:
        """Leave it for the next start."""
        self.lock.unlock()


def abandoned(folder: Path) -> list[Abandoned]:
    """What programs that died left in the recovery folder, the newest first; damaged files are put aside."""
    found = []
    _tidy(folder)
    for file in sorted(folder.glob(f"*{SUFFIX}")):
        lock = QLockFile(str(file.with_suffix(".lock")))
        lock.setStaleLockTime(0)
        if not lock.tryLock(0):
            continue
        try:
            found.append(Abandoned(file, read_snapshot(file), lock))
        except FileError as error:
            log.warning("not recovered: %s", error)
            file.replace(file.with_suffix(".damaged"))
            lock.unlock()
    return sorted(found, key=lambda one: one.snapshot.written, reverse=True)


def _tidy(folder: Path) -> None:
    """Remove what programs that were killed while they wrote left half-written, once it is old."""
    for part in folder.glob(".*.part"):
        with contextlib.suppress(OSError):
            if time.time() - part.stat().st_mtime > OLD_S:
                part.unlink()
