"""What is this? by a click: a parameter is explained, anything else says its tooltip."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject
from PySide6.QtGui import QHelpEvent
from PySide6.QtWidgets import QApplication, QWhatsThis, QWidget

if TYPE_CHECKING:
    from ui.main_window import MainWindow


class Clicked(QObject):
    """Answers for all widgets of a window, which have tooltips but no longer texts of their own."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        window.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Events of help that no widget took come up to the window."""
        if event.type() == QEvent.Type.QueryWhatsThis:
            event.accept()
            return True
        if event.type() == QEvent.Type.WhatsThis and isinstance(event, QHelpEvent):
            self._explain(event)
            event.accept()
            return True
        return super().eventFilter(watched, event)

    def _explain(self, event: QHelpEvent) -> None:
        widget = QApplication.widgetAt(event.globalPos())
        path = self._path_of(widget)
        text = said(widget)
        if path:
            self._window.form.field_asked.emit(path)
        elif text:
            QWhatsThis.showText(event.globalPos(), text, self._window)

    def _path_of(self, widget: QWidget | None) -> str:
        """The parameter that a widget belongs to; empty for none."""
        rows = {row: path for path, row in self._window.form.rows.items()}
        while widget is not None and widget not in rows:
            widget = widget.parentWidget()
        return rows[widget] if widget is not None else ""


def said(widget: QWidget | None) -> str:
    """What a widget, or what it stands in, says of itself; empty when nothing."""
    while widget is not None and not widget.isWindow():
        if widget.whatsThis() or widget.toolTip():
            return widget.whatsThis() or widget.toolTip()
        widget = widget.parentWidget()
    return ""
