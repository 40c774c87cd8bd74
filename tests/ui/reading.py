"""Every text that a window shows or says of itself; what takes keys, and how it is called."""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import QAbstractListModel, QObject, Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QComboBox,
    QLineEdit,
    QPlainTextEdit,
    QScrollBar,
    QTabBar,
    QWidget,
)

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


def takes_keys(widget: QWidget) -> bool:
    """Whether the keyboard can be in it."""
    kinds = (QAbstractButton, QLineEdit, QComboBox, QAbstractSpinBox, QAbstractSlider, QAbstractItemView)
    if not isinstance(widget, kinds) or isinstance(widget, QScrollBar) or not widget.focusPolicy():
        return False
    inner = (
        isinstance(widget.parentWidget(), QComboBox | QAbstractSpinBox | QLineEdit | QTabBar)
        or "qt_" in widget.objectName()
    )
    return not inner and widget.metaObject().className() not in ("QComboBoxListView", "QHeaderView", "QTabBar")


def tip_of(widget: QWidget) -> str:
    """Its tooltip, or that of what it is part of."""
    part: QWidget | None = widget
    for _ in range(3):
        if part is None:
            break
        if part.toolTip():
            return part.toolTip()
        part = part.parentWidget()
    return ""


def where_is(widget: QWidget) -> str:
    """What it is, and in what."""
    names = [widget.metaObject().className(), widget.objectName()]
    parents, parent = [], widget.parentWidget()
    while parent is not None:
        parents.append(type(parent).__name__)
        parent = parent.parentWidget()
    text = widget.text() if isinstance(widget, QAbstractButton) else widget.accessibleName()
    return f"{' '.join(names)} {text!r} in {' in '.join(parents)}"
