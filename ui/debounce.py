"""Waits until a value has come to rest."""

from __future__ import annotations

from PySide6.QtCore import QObject, QTimer, Signal, Slot


class Debounce(QObject):
    """Passes on the newest of the values pushed, once none has come for a while.

    Signals:
        settled(object): the newest value.
    """

    settled = Signal(object)

    def __init__(self, interval_ms: int = 200, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._value: object = None
        self._timer = QTimer(self, singleShot=True, interval=interval_ms)
        self._timer.timeout.connect(self._settle)

    def push(self, value: object = None) -> None:
        """Take a value in place of the one that waits, and wait anew."""
        self._value = value
        self._timer.start()

    @Slot()
    def flush(self) -> None:
        """Pass the waiting value on now, if there is one."""
        if self._timer.isActive():
            self._timer.stop()
            self._settle()

    @Slot()
    def cancel(self) -> None:
        """Forget the waiting value."""
        self._timer.stop()
        self._value = None

    def _settle(self) -> None:
        value, self._value = self._value, None
        self.settled.emit(value)
