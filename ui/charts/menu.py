"""The menu of a chart under the right mouse button, in the window's language in place of the library's own."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pyqtgraph as pg
from PySide6.QtCore import Qt
from PySide6.QtGui import QContextMenuEvent, QGuiApplication
from PySide6.QtWidgets import QMenu, QWidget

from ui.words import tr


class QuietView(pg.GraphicsLayoutWidget):
    """A ground for charts; a click of the right button, but no drag, asks the parents for their menu."""

    def __init__(self) -> None:
        super().__init__()
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.PreventContextMenu)
        for action in self.scene().contextMenu:
            action.setParent(None)
        self.scene().contextMenu = []
        self.scene().sigMouseClicked.connect(self._on_clicked)

    def _on_clicked(self, event: Any) -> None:
        if event.button() == Qt.MouseButton.RightButton and self.parentWidget() is not None:
            place = event.screenPos().toPoint()
            asked = QContextMenuEvent(QContextMenuEvent.Reason.Other, self.mapFromGlobal(place), place)
            QGuiApplication.sendEvent(self.parentWidget(), asked)


def chart_menu(
    parent: QWidget, view_all: Callable[[], None] | None, copy: Callable[[str], None], save: Callable[[], None]
) -> QMenu:
    """View all (where there is a scale), copy picture, numbers or both, and save."""
    menu = QMenu(parent)
    menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    if view_all is not None:
        menu.addAction(tr("&View all")).triggered.connect(lambda: view_all())
        menu.addSeparator()
    menu.addAction(tr("&Copy picture and numbers")).triggered.connect(lambda: copy("both"))
    menu.addAction(tr("Copy &picture")).triggered.connect(lambda: copy("picture"))
    menu.addAction(tr("Copy &numbers")).triggered.connect(lambda: copy("numbers"))
    menu.addSeparator()
    menu.addAction(tr("&Save…")).triggered.connect(lambda: save())
    return menu
