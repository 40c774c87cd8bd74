"""The mouse wheel scrolls; it never changes a value by accident."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication, QEvent, QObject
from PySide6.QtWidgets import QAbstractSlider, QAbstractSpinBox, QComboBox, QScrollBar, QTabBar

WHEEL = QEvent.Type.Wheel
VALUES = (QAbstractSpinBox, QComboBox, QAbstractSlider, QTabBar)
NAME = "wheel_guard"


class WheelGuard(QObject):
    """An event filter for the application: spin boxes, lists to choose from, sliders and tabs leave the wheel to
    what they stand in. Bars that scroll and opened lists keep it."""

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() != WHEEL or not isinstance(watched, VALUES) or isinstance(watched, QScrollBar):
            return False
        event.ignore()
        return True


def guard_wheel() -> None:
    """Guard all windows of the application, once."""
    application = QCoreApplication.instance()
    if application is not None and application.findChild(QObject, NAME) is None:
        guard = WheelGuard(application)
        guard.setObjectName(NAME)
        application.installEventFilter(guard)
