"""The last saves of a design, to go back to one of them."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QHeaderView,
    QLabel,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from ui.keyboard import tab_as_read
from ui.projects.backups import Backup, Backups
from ui.projects.versions import Version, changes, saved_version, short_date
from ui.words import tr

DATE_WIDTH, STATE_WIDTH = 170, 230
MOST_CHANGES = 30


class BackupsDialog(QDialog):
    """A design of those that have backups, its copies with date and validity, and how each differs from the draft.

    Signals
    -------
    chosen(object, object)
        The Version to go back to, and the Path of the design it is a copy of.
    """

    chosen = Signal(object, object)

    def __init__(
        self, backups: Backups, path: Path | None, draft: Mapping[str, Any], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Backups"))
        self.resize(820, 420)
        self._backups, self._draft = backups, draft
        self._versions: list[Version] = []
        self.designs = QComboBox()
        self.designs.setToolTip(tr("Designs that were saved on this computer"))
        self.designs.setAccessibleName(tr("Design"))
        known = backups.designs()
        for one in known:
            self.designs.addItem(str(one) if one.exists() else tr("{name} (missing)", name=one), one)
        if path is not None and path.resolve() in known:
            self.designs.setCurrentIndex(known.index(path.resolve()))
        self.list = QTreeWidget()
        self.list.setRootIsDecorated(False)
        self.list.setHeaderLabels([tr("Saved"), tr("State"), tr("Differs from what is open in")])
        self.list.setAccessibleName(tr("Backups"))
        self.list.setToolTip(tr("Copies of the last saves, with what was different"))
        self.list.header().setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        self.list.header().setStretchLastSection(True)
        for column, width in enumerate((DATE_WIDTH, STATE_WIDTH)):
            self.list.setColumnWidth(column, width)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.button(QDialogButtonBox.StandardButton.Close).setToolTip(tr("Close; nothing changes"))
        self.restore = buttons.addButton(tr("&Go back to this one"), QDialogButtonBox.ButtonRole.AcceptRole)
        self.restore.setToolTip(tr("Put it in place of what is open; Undo takes that back. No file is changed."))
        self.restore.setDefault(True)
        words = QLabel(tr("Each save leaves a copy. Going back changes no file until you save, and can be undone."))
        words.setWordWrap(True)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 16, 16, 12)
        layout.setSpacing(10)
        for widget in (words, self.designs):
            layout.addWidget(widget)
        layout.addWidget(self.list, 1)
        layout.addWidget(buttons)
        self.designs.currentIndexChanged.connect(lambda _index: self._fill())
        self.list.currentItemChanged.connect(lambda *_: self._on_current_changed())
        buttons.accepted.connect(self._on_restore)
        buttons.rejected.connect(self.reject)
        self.list.setFocus()
        tab_as_read(self)
        self._fill()

    def _fill(self) -> None:
        self.list.clear()
        path = self.designs.currentData()
        copies: list[Backup] = self._backups.of(path) if path is not None else []
        self._versions = [saved_version(copy.file) for copy in copies]
        for copy, version in zip(copies, self._versions, strict=True):
            changed = changes(self._draft, version.draft)
            difference = "; ".join(map(str, changed)) or tr("nothing")
            item = QTreeWidgetItem([short_date(copy.when), version.verdict, difference if version.draft else ""])
            item.setToolTip(1, "\n".join(version.problems))
            item.setToolTip(2, "\n".join(map(str, changed[:MOST_CHANGES])))
            self.list.addTopLevelItem(item)
        self.list.setCurrentIndex(self.list.model().index(0, 0))
        self._on_current_changed()

    def _current(self) -> Version | None:
        row = self.list.currentIndex().row()
        return self._versions[row] if 0 <= row < len(self._versions) else None

    def _on_current_changed(self) -> None:
        version = self._current()
        self.restore.setEnabled(version is not None and version.draft is not None)

    def _on_restore(self) -> None:
        version = self._current()
        if version is not None and version.draft is not None:
            self.chosen.emit(version, self.designs.currentData())
            self.accept()
