"""When the interpreter looks for garbage: in the window's thread only, and never among what stays until the end.

By itself it looks in whichever thread happens to need memory. An object of Qt that ends in another thread than its own
leaves timers and events behind that find it gone, and the program ends with it.
"""

from __future__ import annotations

import gc

from PySide6.QtCore import QObject, QTimer

_PAUSE_MS = 500


class Collector(QObject):
    """Takes the place of the automatic collector as long as it lives; to be made in the window's thread."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        gc.disable()
        self._timer = QTimer(self, interval=_PAUSE_MS)
        self._timer.timeout.connect(self.look)

    def begin(self) -> None:
        """Look now and then, but never again through the modules that are loaded.

        They are 280 000 objects; to look through them holds up the window for more than a tenth of a second.
        """
        gc.freeze()
        self._timer.start()

    def look(self) -> None:
        """Collect the oldest generation that has had its share of objects or of looks."""
        shares = zip(gc.get_count(), gc.get_threshold(), strict=True)
        due = [generation for generation, (count, limit) in enumerate(shares) if count > limit]
        if due:
            gc.collect(due[-1])


def tidy_memory() -> None:
    """Free what a window has left, also where the collector does not look any more."""
    frozen = gc.get_freeze_count() > 0
    gc.unfreeze()
    gc.collect()
    if frozen:
        gc.freeze()
