"""Offers what a program that died had not saved, beside what the design's file holds."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QDialogButtonBox,
    QHeaderView,
    QLabel,
    QMessageBox,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from ui.keyboard import tab_as_read
from ui.mnemonics import separate
from ui.projects.autosave import Abandoned
from ui.projects.versions import Change, Version, changes, recovered_version, saved_version
from ui.words import tr

MOST_PROBLEMS = 4
ONE_LINE = 40
"""Letters of a verdict for which a line is enough."""


class RecoveryDialog(QDialog):
    """One line for each design; the user takes the recovered or the saved version, discards, or decides later.

    Signals
    -------
    recovered_chosen(object, object)
        The Abandoned and the Version of it to go on with.
    saved_chosen(object)
        The Abandoned whose design file is to be opened.
    """

    recovered_chosen = Signal(object, object)
    saved_chosen = Signal(object)

    def __init__(self, found: list[Abandoned], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Recover unsaved work"))
        self.resize(820, 500)
        self._left = list(found)
        self._versions: dict[str, tuple[Version, Version]] = {}
        head = QLabel(tr("GearStudio ended unexpectedly. Of these designs it kept edits that were not saved."))
        head.setWordWrap(True)
        self.list = QTreeWidget()
        self.list.setRootIsDecorated(False)
        self.list.setHeaderLabels([tr("Design"), tr("Saved version"), tr("Recovered version")])
        self.list.setAccessibleName(tr("Designs with unsaved work"))
        self.list.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.list.header().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        self.list.header().setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        self.list.setWordWrap(True)
        self.changes = _table_of_changes()
        self.details = QLabel()
        self.details.setWordWrap(True)
        self.details.setProperty("role", "muted")
        self.details.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        buttons = QDialogButtonBox()
        self.recover = _button(buttons, tr("Open &recovered"), tr("Go on with the edits that were not saved"))
        self.saved = _button(buttons, tr("Open &saved"), tr("Open the file as it was saved; the recovered edits stay"))
        self.discard = _button(buttons, tr("&Discard recovered"), tr("Forget the edits that were not saved"))
        self.later = buttons.addButton(tr("Decide &later"), QDialogButtonBox.ButtonRole.RejectRole)
        separate((self.recover, self.saved, self.discard, self.later))
        self.later.setToolTip(tr("Keep everything; File ▸ Recover unsaved work, or the next start, asks again"))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 16, 16, 12)
        layout.setSpacing(10)
        layout.addWidget(head)
        layout.addWidget(self.list, 1)
        layout.addWidget(self.changes, 1)
        layout.addWidget(self.details)
        layout.addWidget(buttons)
        self.recover.clicked.connect(self._on_recover)
        self.saved.clicked.connect(self._on_saved)
        self.discard.clicked.connect(self._on_discard)
        buttons.rejected.connect(self.reject)
        self.finished.connect(self._on_finished)
        self.list.currentItemChanged.connect(lambda *_: self._show_details())
        for one in self._left:
            self._add(one)
        self.list.setCurrentIndex(self.list.model().index(0, 0))
        self.recover.setDefault(True)
        self.list.setFocus()
        tab_as_read(self)

    def versions(self, one: Abandoned) -> tuple[Version, Version]:
        """The saved and the recovered version of a design."""
        return self._versions[one.file.name]

    def _add(self, one: Abandoned) -> None:
        saved, recovered = saved_version(one.snapshot.path), recovered_version(one.snapshot)
        self._versions[one.file.name] = saved, recovered
        texts = [one.snapshot.title, *(f"{version.date}\n{version.verdict}" for version in (saved, recovered))]
        item = QTreeWidgetItem(texts)
        item.setToolTip(0, str(one.snapshot.path or tr("never saved")))
        for column, version in ((1, saved), (2, recovered)):
            item.setToolTip(column, "\n".join(version.problems))
        lines = 3 if max(len(version.verdict) for version in (saved, recovered)) > ONE_LINE else 2
        item.setSizeHint(1, QSize(0, lines * self.list.fontMetrics().lineSpacing() + 10))
        self.list.addTopLevelItem(item)

    def _current(self) -> Abandoned | None:
        row = self.list.currentIndex().row()
        return self._left[row] if 0 <= row < len(self._left) else None

    def _show_details(self) -> None:
        one = self._current()
        for button in (self.recover, self.discard):
            button.setEnabled(one is not None)
        self.saved.setEnabled(one is not None and self._versions[one.file.name][0].draft is not None)
        if one is None:
            self._show_changes([])
            self.details.clear()
            return
        saved, recovered = self._versions[one.file.name]
        changed = [] if saved.draft is None else changes(saved.draft, recovered.draft)
        self._show_changes(changed)
        words = [] if changed else [tr("Both are the same.")]
        if saved.draft is None:
            words = [str(one.snapshot.path or tr("This design was never saved."))]
        self.details.setText("\n".join((*words, *recovered.problems[:MOST_PROBLEMS])))
        self.details.setVisible(bool(self.details.text()))

    def _show_changes(self, changed: list[Change]) -> None:
        self.changes.clear()
        for one in changed:
            item = QTreeWidgetItem([one.title, one.before, one.after])
            for column, text in enumerate((one.title, one.before, one.after)):
                item.setToolTip(column, text)
            self.changes.addTopLevelItem(item)
        self.changes.setVisible(bool(changed))

    def _on_recover(self) -> None:
        one = self._current()
        if one is not None:
            self._left.remove(one)
            self.recovered_chosen.emit(one, self._versions[one.file.name][1])
            self.accept()

    def _on_saved(self) -> None:
        one = self._current()
        if one is not None:
            self.saved_chosen.emit(one)
            self.accept()

    def _on_discard(self) -> None:
        one = self._current()
        if one is None or not self._sure(one):
            return
        row = self._left.index(one)
        self._left.remove(one)
        one.discard()
        self.list.takeTopLevelItem(row)
        self._show_details()
        if not self._left:
            self.accept()

    def _sure(self, one: Abandoned) -> bool:
        answers = QMessageBox.StandardButton
        box = QMessageBox(
            QMessageBox.Icon.Question,
            tr("Discard recovered"),
            tr("Forget the unsaved edits of “{name}” for good?", name=one.snapshot.title),
            answers.Discard | answers.Cancel,
            self,
        )
        box.setDefaultButton(answers.Cancel)
        return box.exec() == answers.Discard

    def _on_finished(self, _result: int) -> None:
        for one in self._left:
            one.leave()
        self._left.clear()


def _button(box: QDialogButtonBox, text: str, tip: str) -> QPushButton:
    button = box.addButton(text, QDialogButtonBox.ButtonRole.ActionRole)
    button.setToolTip(tip)
    return button


def _table_of_changes() -> QTreeWidget:
    table = QTreeWidget()
    table.setRootIsDecorated(False)
    table.setHeaderLabels([tr("Parameter"), tr("Saved"), tr("Recovered")])
    table.setAccessibleName(tr("Parameters that differ"))
    table.setToolTip(tr("The parameters that differ, as they were saved and as they were recovered"))
    table.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
    table.header().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
    table.header().setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
    return table
