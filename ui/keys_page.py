"""The page of preferences that lists the keys of all commands and changes them."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QHeaderView,
    QKeySequenceEdit,
    QLabel,
    QLineEdit,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from ui.command_list import Entry
from ui.fields import set_severity
from ui.fuzzy import fit
from ui.keys import Keys
from ui.words import tr

NATIVE = QKeySequence.SequenceFormat.NativeText
ENTRY = Qt.ItemDataRole.UserRole


class KeysPage(QWidget):
    """Commands with their keys; the row chosen takes new keys below the list, unless another command has them."""

    def __init__(self, keys: Keys, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._keys = keys
        self.search = QLineEdit()
        self.search.setPlaceholderText(tr("Find a command or a key"))
        self.search.setAccessibleName(tr("Find a command or a key"))
        self.search.setToolTip(tr("Letters of a command, or a key such as Ctrl+S"))
        self.search.setClearButtonEnabled(True)
        self.search.textChanged.connect(lambda _text: self._filter())
        self.list = self._make_list()
        self.edit = QKeySequenceEdit()
        self.edit.setMaximumSequenceLength(2)
        self.edit.setClearButtonEnabled(True)
        self.edit.setAccessibleName(tr("New key"))
        self.edit.setToolTip(tr("Press the new keys here"))
        self.edit.keySequenceChanged.connect(lambda _keys: self._refresh())
        self.assign = _button(tr("Assign"), tr("Give the command these keys"), self._assign)
        self.reset = _button(tr("Reset"), tr("Give the command its usual keys"), self._reset)
        self.reset_all = _button(tr("Reset all keys"), tr("Give every command its usual keys"), keys.reset_all)
        self.note = QLabel()
        self.note.setWordWrap(True)
        self.note.setMinimumHeight(2 * self.note.fontMetrics().height())
        row = QHBoxLayout()
        row.addWidget(self.edit, 1)
        for button in (self.assign, self.reset, self.reset_all):
            row.addWidget(button)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(4, 12, 4, 0)
        layout.setSpacing(8)
        layout.addWidget(self.search)
        layout.addWidget(self.list, 1)
        layout.addLayout(row)
        layout.addWidget(self.note)
        keys.changed.connect(self._fill)
        self._fill()

    @property
    def chosen(self) -> Entry | None:
        """The command of the chosen row."""
        item = self.list.currentItem()
        return item.data(0, ENTRY) if item is not None else None

    def choose(self, identifier: str) -> None:
        """Go to a command."""
        for item in self._items():
            if item.data(0, ENTRY).id == identifier:
                self.list.setCurrentItem(item)

    def _make_list(self) -> QTreeWidget:
        made = QTreeWidget()
        made.setColumnCount(3)
        made.setHeaderLabels([tr("Command"), tr("Menu"), tr("Keys")])
        made.setRootIsDecorated(False)
        made.setAlternatingRowColors(True)
        made.setUniformRowHeights(True)
        made.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        made.setAccessibleName(tr("Commands and their keys"))
        made.setToolTip(tr("Choose a command to change its keys"))
        made.header().setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        made.header().setSectionResizeMode(1, QHeaderView.ResizeMode.ResizeToContents)
        made.header().setSectionResizeMode(2, QHeaderView.ResizeMode.ResizeToContents)
        made.header().setStretchLastSection(False)
        made.currentItemChanged.connect(lambda *_: self._show_chosen())
        return made

    def _items(self) -> list[QTreeWidgetItem]:
        return [self.list.topLevelItem(row) for row in range(self.list.topLevelItemCount())]

    def _fill(self) -> None:
        current = self.chosen.id if self.chosen else ""
        self.list.clear()
        for entry in self._keys.entries():
            keys = entry.action.shortcut().toString(NATIVE)
            item = QTreeWidgetItem([entry.title, entry.place, keys])
            item.setData(0, ENTRY, entry)
            item.setToolTip(0, entry.tip or entry.title)
            if self._keys.is_own(entry):
                font = item.font(2)
                font.setBold(True)
                item.setFont(2, font)
            self.list.addTopLevelItem(item)
        self._filter()
        if self.list.topLevelItemCount():
            self.list.setCurrentItem(self.list.topLevelItem(0))
        self.choose(current)
        self._show_chosen()

    def _filter(self) -> None:
        typed = self.search.text()
        for item in self._items():
            found = fit(typed, f"{item.text(0)} {item.text(1)}") or typed.lower() in item.text(2).lower()
            item.setHidden(bool(typed) and not found)

    def _show_chosen(self) -> None:
        entry = self.chosen
        self.edit.setKeySequence(entry.action.shortcut() if entry else QKeySequence())
        self._refresh()

    def _refresh(self) -> None:
        entry, keys = self.chosen, self.edit.keySequence()
        self.edit.setEnabled(entry is not None)
        if entry is None:
            self.assign.setEnabled(False)
            self.reset.setEnabled(False)
            return
        rivals = self._keys.rivals(entry, keys)
        self.assign.setEnabled(keys != entry.action.shortcut())
        self.assign.setText(tr("Take over") if rivals else tr("Assign"))
        self.reset.setEnabled(self._keys.is_own(entry))
        usual = self._keys.usual(entry).toString(NATIVE) or tr("none")
        if rivals:
            text = tr("{keys} belongs to “{command}”, which would lose it.", keys=keys.toString(NATIVE),
                      command="”, “".join(rival.title for rival in rivals))  # fmt: skip
        else:
            text = tr("“{command}”: usual keys {keys}", command=entry.title, keys=usual)
        self.note.setText(text)
        set_severity(self.note, "warning" if rivals else "")

    def _assign(self) -> None:
        if self.chosen is not None:
            self._keys.assign(self.chosen, self.edit.keySequence())

    def _reset(self) -> None:
        if self.chosen is not None:
            self._keys.reset(self.chosen)


def _button(text: str, tip: str, run: object) -> QPushButton:
    button = QPushButton(text)
    button.setToolTip(tip)
    button.setAutoDefault(False)
    button.clicked.connect(lambda _checked=False: run())  # type: ignore[operator]
    return button
