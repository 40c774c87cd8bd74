"""The way that Tab takes through the window: as one reads it, wherever its parts were made."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QDialog, QDockWidget, QTabBar, QWidget

from ui.words import tr

if TYPE_CHECKING:
    from ui.main_window import MainWindow


def stops(part: QWidget) -> list[QWidget]:
    """What may take the keyboard in a part of a window as it is in sight now, row by row and from left to right."""
    return [one for one in _read(part) if one.focusPolicy() != Qt.FocusPolicy.NoFocus and one.focusProxy() is None]


def tab_in_order(parts: Iterable[QWidget]) -> None:
    """Let Tab go through parts of a window one after the other; one that holds another comes for the rest of it."""
    way = list(dict.fromkeys(one for part in parts if part.isVisible() for one in stops(part)))
    for before, after in pairwise(way):
        QWidget.setTabOrder(before, after)


class _AsRead(QObject):
    """Gives a dialog its order whenever it is shown, which the style has a say in."""

    def __init__(self, dialog: QDialog, parts: Sequence[QWidget]) -> None:
        super().__init__(dialog)
        self._parts = parts
        dialog.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Show:
            tab_in_order(self._parts)
        return False


def tab_as_read(dialog: QDialog, *parts: QWidget) -> None:
    """Let Tab go through a dialog, or parts of it, as one reads them; where buttons stand the style says."""
    _AsRead(dialog, parts or (dialog,))


def lay_way(window: MainWindow) -> None:
    """Toolbar, panels on the left, views, panels on the right, analysis, status; for what is in sight now."""
    area = window.area
    below = [bar for bar in (area.roll_slider, area.mesh_bar) if bar is not None]
    bars = [child for child in window.children() if isinstance(child, QTabBar)]
    for bar in bars:  # of panels that lie on one another; some are left over and nowhere
        bar.setFocusPolicy(Qt.FocusPolicy.TabFocus if bar.count() > 1 else Qt.FocusPolicy.NoFocus)
        bar.setAccessibleName(tr("Panels that share a place"))
    beside = [one for one in stops(area) if not any(one is bar or bar.isAncestorOf(one) for bar in below)]
    docks = [one for one in window.children() if isinstance(one, QDockWidget) and not one.isAncestorOf(window.analysis)]
    left, right = (window.form, window.derived), window.sharing.places
    analysis = (window.analysis.bar, window.analysis)
    tab_in_order((window.method_bar, *left, *beside, *below, *right, *analysis, *docks, *bars, window.status))


def _read(part: QWidget) -> Iterator[QWidget]:
    yield part
    children = [child for child in part.children() if isinstance(child, QWidget)]
    for row in _rows([child for child in children if child.isVisible() and not child.isWindow()]):
        for child in row:
            yield from _read(child)


def _rows(widgets: list[QWidget]) -> Iterator[list[QWidget]]:
    """Widgets beside one another, from the left; a row ends where the next one begins below its first one's middle."""
    row: list[QWidget] = []
    for widget in sorted(widgets, key=lambda one: (one.y(), one.x())):
        if row and widget.y() >= row[0].geometry().center().y():
            yield sorted(row, key=lambda one: one.x())
            row = []
        row.append(widget)
    yield sorted(row, key=lambda one: one.x())
