"""Every text that a window shows or says of itself."""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import QAbstractListModel, QObject, Qt
from PySide6.QtWidgets import QAbstractItemView, QComboBox, QLineEdit, QPlainTextEdit

PLACES = ("text", "toolTip", "accessibleName", "windowTitle", "placeholderText", "statusTip", "title")


def texts_of(root: QObject) -> Iterator[tuple[str, str]]:
    """Where a text stands, and the text; what the user has typed is left out."""
    for thing in (root, *root.findChildren(QObject)):
        if thing.objectName().startswith("qt_"):
            continue
        name = f"{type(thing).__name__} {thing.objectName()}"
        for read in PLACES:
            written = read == "text" and isinstance(thing, QLineEdit | QPlainTextEdit)
            said = thing.property(read)
            if isinstance(said, str) and not written:
                yield f"{name} {read}", said
        if isinstance(thing, QComboBox):
            yield from ((name, thing.itemText(index)) for index in range(thing.count()))
        if isinstance(thing, QAbstractItemView) and thing.model() is not None:
            yield from ((name, text) for text in _cells(thing))


def _cells(view: QAbstractItemView) -> Iterator[str]:
    model = view.model()
    columns = 1 if isinstance(model, QAbstractListModel) else model.columnCount()
    for column in range(columns):
        texts = [model.headerData(column, Qt.Orientation.Horizontal)]
        texts += [model.index(row, column).data() for row in range(model.rowCount())]
        yield from (text for text in texts if isinstance(text, str))
