"""Keeps the window in sight when a display is taken away or changes its size."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QObject, QRect, QTimer
from PySide6.QtGui import QGuiApplication, QScreen
from PySide6.QtWidgets import QWidget

GRIP = 80
"""So many pixels of the window's head must be on a screen, or nobody could move it back."""
SETTLING_MS = 300


def fitted(window: QRect, screens: Sequence[QRect]) -> QRect:
    """Where a window should be: as it is when its head can be grasped on a screen, else inside the first one."""
    head = QRect(window.left(), window.top(), window.width(), GRIP)
    for screen in screens:
        seen = head.intersected(screen)
        if seen.width() >= GRIP and seen.height() >= GRIP // 2 and window.top() >= screen.top() - GRIP // 2:
            return window
    if not screens:
        return window
    room = screens[0]
    size = window.size().boundedTo(room.size())
    placed = QRect(room.topLeft(), size)
    placed.moveCenter(room.center())
    return placed


class ScreenWatch(QObject):
    """Moves a window back when the displays change."""

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window
        self._timer = QTimer(self, singleShot=True, interval=SETTLING_MS)
        self._timer.timeout.connect(self.bring_back)
        application = QGuiApplication.instance()
        assert isinstance(application, QGuiApplication)
        application.screenAdded.connect(self._on_screen_added)
        application.screenRemoved.connect(self._on_changed)
        application.primaryScreenChanged.connect(self._on_changed)
        for screen in QGuiApplication.screens():
            screen.availableGeometryChanged.connect(self._on_changed)

    def bring_back(self) -> None:
        """Move the window, and the panels that float, onto a screen if they are off all of them."""
        screens = [screen.availableGeometry() for screen in QGuiApplication.screens()]
        for widget in (self._window, *self._window.findChildren(QWidget)):
            if widget.isWindow() and widget.isVisible() and not widget.isFullScreen():
                before, after = widget.geometry(), fitted(widget.geometry(), screens)
                if after != before:
                    widget.setGeometry(after)

    def _on_screen_added(self, screen: QScreen) -> None:
        screen.availableGeometryChanged.connect(self._on_changed)
        self._timer.start()

    def _on_changed(self, _what: object) -> None:
        self._timer.start()
