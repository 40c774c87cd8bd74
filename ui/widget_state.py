"""What the user has chosen in the widgets of a window, to be chosen again in another one that is made alike."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from typing import Any

from PySide6.QtCore import QModelIndex
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QComboBox,
    QDoubleSpinBox,
    QLineEdit,
    QScrollBar,
    QSpinBox,
    QSplitter,
    QTabWidget,
    QToolButton,
    QWidget,
)

Path = tuple[tuple[str, int], ...]
"""Class, and number among the siblings of this class, from the window down."""
PARTS_OWN = (QComboBox, QAbstractSpinBox)
"""Widgets that look after their parts themselves."""


def widgets(root: QWidget, without: Collection[QWidget] = (), path: Path = ()) -> Iterator[tuple[Path, QWidget]]:
    """All widgets below one, each with its place; those in ``without`` are left out with all that is in them."""
    counts: Counter[str] = Counter()
    for child in root.children():
        if not isinstance(child, QWidget):
            continue
        name = type(child).__name__
        place = (*path, (name, counts[name]))
        counts[name] += 1
        if child in without or child.isWindow():
            continue
        yield place, child
        if not isinstance(child, PARTS_OWN):
            yield from widgets(child, without, place)


def states(root: QWidget, without: Collection[QWidget] = ()) -> dict[Path, Any]:
    """What is chosen; a widget with a method ``keep_state`` says itself what that is, beside what its parts say."""
    found = {}
    for path, widget in widgets(root, without):
        keep = getattr(widget, "keep_state", None)
        state = _state(widget) if keep is None else keep()
        if state is not None:
            found[path] = state
    return found


def choose_again(root: QWidget, known: Mapping[Path, Any], without: Collection[QWidget] = ()) -> None:
    """Choose the same, as the user would: switches first, then numbers, then what ``take_state`` does."""
    mine = [(widget, known[path]) for path, widget in widgets(root, without) if path in known]
    for kinds in ((QAbstractButton, QComboBox, QTabWidget, QSplitter), (QAbstractSlider,), (QAbstractSpinBox,)):
        for widget, state in mine:
            if isinstance(widget, kinds) and not isinstance(widget, QScrollBar):
                _choose(widget, state)
    for widget, state in mine:
        if isinstance(widget, QAbstractItemView | QLineEdit):
            _choose(widget, state)
        take = getattr(widget, "take_state", None)
        if take is not None:
            take(state)


def scroll_again(root: QWidget, known: Mapping[Path, Any], without: Collection[QWidget] = ()) -> None:
    """Scroll to the same places, once the widgets have their sizes."""
    for path, widget in widgets(root, without):
        if isinstance(widget, QScrollBar) and path in known:
            widget.setValue(known[path])


def _state(widget: QWidget) -> Any:
    match widget:
        case QAbstractButton() if widget.isCheckable() and not _has_action(widget):
            return widget.isChecked()
        case QComboBox():
            return widget.currentIndex()
        case QTabWidget():
            return widget.currentIndex()
        case QAbstractSlider() | QSpinBox() | QDoubleSpinBox():
            return widget.value()
        case QSplitter():
            return widget.saveState()
        case QLineEdit() if type(widget) is QLineEdit and not widget.isReadOnly():
            return widget.text()
        case QAbstractItemView():
            return _rows(widget.currentIndex()) or None
    return None


def _choose(widget: QWidget, state: Any) -> None:
    if state == _state(widget):
        return
    match widget:
        case QAbstractButton():
            if state or widget.group() is None or not widget.group().exclusive():
                widget.click()
        case QComboBox() if 0 <= state < widget.count():
            widget.setCurrentIndex(state)
            widget.activated.emit(state)
        case QTabWidget():
            widget.setCurrentIndex(state)
        case QAbstractSlider() | QSpinBox() | QDoubleSpinBox():
            widget.setValue(state)
        case QSplitter():
            widget.restoreState(state)
        case QLineEdit():
            widget.setText(state)
        case QAbstractItemView():
            index = QModelIndex()
            for row, column in state:
                index = widget.model().index(row, column, index)
            if index.isValid():
                widget.setCurrentIndex(index)


def _has_action(button: QAbstractButton) -> bool:
    return isinstance(button, QToolButton) and button.defaultAction() is not None


def _rows(index: QModelIndex) -> tuple[tuple[int, int], ...]:
    return (*_rows(index.parent()), (index.row(), index.column())) if index.isValid() else ()
