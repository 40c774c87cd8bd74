"""Connects a window to what happens to designs outside it."""

from __future__ import annotations

import logging
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, QStandardPaths

from gearstudio.errors import FileError
from ui.projects.autosave import Abandoned, Autosave, abandoned
from ui.projects.backups import Backups
from ui.projects.backups_dialog import BackupsDialog
from ui.projects.drops import Drops
from ui.projects.recent import Recent
from ui.projects.recovery_dialog import RecoveryDialog
from ui.projects.versions import Version, short_date
from ui.projects.watch import FileWatch
from ui.projects.windows import open_window
from ui.session import Session
from ui.words import told, tr

if TYPE_CHECKING:
    from ui.edits import Edits
    from ui.files import Files
    from ui.main_window import MainWindow
    from ui.projects.compare_dialog import CompareDialog

log = logging.getLogger(__name__)


def data_folder() -> Path:
    """Where this user's recovery files and backups are."""
    return Path(QStandardPaths.writableLocation(QStandardPaths.StandardLocation.AppLocalDataLocation))


class Desk(QObject):
    """Recent files, new windows, drops, comparison; with a ``data`` folder also autosave, recovery and backups."""

    def __init__(
        self,
        session: Session,
        window: MainWindow,
        files: Files,
        edits: Edits,
        data: Path | None,
        parent: QObject,
        autosave: Autosave | None = None,
    ) -> None:
        super().__init__(parent)
        self._session, self._window, self._files, self._edits = session, window, files, edits
        self.recent = Recent(window.commands.recent, window.settings, self)
        self.drops = Drops(window.analysis, self)
        self.backups = Backups(data / "backups") if data else None
        self._recovery_folder = data / "recovery" if data else None
        self.autosave = autosave or (Autosave(session, data / "recovery") if data else None)
        self.watch = FileWatch(session, window, files, edits, self)
        self.recent.chosen.connect(files.open_path)
        files.file_used.connect(self.recent.add)
        files.saved.connect(self._on_saved)
        window.others_dropped.connect(self.drops.take)
        if self.autosave is not None:
            self.autosave.setParent(self)
            self.autosave.failed.connect(self._on_autosave_failed)
            window.closing.connect(self.autosave.close)
        handlers: dict[str, Any] = {
            "new_window": self._open_window,
            "backups": self.show_backups,
            "recover": self.recover,
            "compare_design": self.compare,
        }
        for name, handler in handlers.items():
            window.commands[name].triggered.connect(lambda _checked=False, run=handler: run())
        for name in ("backups", "recover"):
            window.commands[name].setEnabled(data is not None)

    def offer_recovery(self) -> RecoveryDialog | None:
        """Ask about what programs that died had not saved, if there is any."""
        found = abandoned(self._recovery_folder) if self._recovery_folder else []
        if not found:
            return None
        dialog = RecoveryDialog(found, self._window)
        dialog.recovered_chosen.connect(self._on_recovered_chosen)
        dialog.saved_chosen.connect(self._on_saved_chosen)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()
        return dialog

    def recover(self) -> None:
        """The same when the user asks for it."""
        if self.offer_recovery() is None:
            self._say("info", tr("There is no unsaved work to recover."))

    def show_backups(self) -> BackupsDialog | None:
        """Offer the copies of the last saves."""
        if self.backups is None:
            return None
        if not self.backups.designs():
            self._say("info", tr("There are no backups yet; each save of a design makes one."))
            return None
        dialog = BackupsDialog(self.backups, self._session.path, dict(self._session.draft), self._window)
        dialog.chosen.connect(self._on_backup_chosen)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()
        return dialog

    def compare(self) -> CompareDialog:
        """A window that shows how another design differs."""
        from ui.projects.compare_dialog import CompareDialog

        dialog = CompareDialog(self._session, self.recent.paths, self._files.folder, self._window)
        dialog.finished.connect(dialog.deleteLater)
        self._window.closing.connect(dialog.close)
        dialog.show()
        return dialog

    def _open_window(self) -> None:
        if not open_window():
            self._say("error", tr("The system refused to start another window."))

    def _on_saved(self, path: Path) -> None:
        if self.backups is None:
            return
        try:
            self.backups.keep(path)
        except FileError as error:
            log.warning("no backup: %s", error)
            self._say("warning", tr("Saved, but no backup could be kept: {reason}", reason=told(error.reason)))

    def _on_recovered_chosen(self, one: Abandoned, version: Version) -> None:
        draft = version.draft
        if draft is None:
            one.leave()
            return
        self._files.reopen(one.snapshot.path, lambda opened: self._recover(one, draft) if opened else one.leave())

    def _recover(self, one: Abandoned, draft: Mapping[str, Any]) -> None:
        self._edits.change_many(draft, tr("Recover unsaved edits"))
        try:
            if self.autosave is not None:
                self.autosave.save_and_wait()
        except FileError as error:
            log.warning("the old recovery file stays: %s", error)
            one.leave()
        else:
            one.discard()

    def _on_saved_chosen(self, one: Abandoned) -> None:
        if one.snapshot.path is not None:
            self._files.open_path(one.snapshot.path)

    def _on_backup_chosen(self, version: Version, path: Path) -> None:
        draft, when = version.draft, version.when
        if draft is None or when is None:
            return

        def go_back(opened: bool) -> None:
            if opened:
                self._edits.change_many(draft, tr("Go back to the save of {date}", date=short_date(when)))

        if self._session.path is not None and self._session.path.resolve() == path:
            go_back(True)
        else:
            self._files.reopen(path, go_back)

    def _on_autosave_failed(self, text: str) -> None:
        self._say("warning", tr("Unsaved edits cannot be kept for recovery: {reason}", reason=told(text)))

    def _say(self, severity: str, text: str) -> None:
        self._window.messages.show_message(severity, text, topic="file")
