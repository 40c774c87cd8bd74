"""Progress bars that do not make the window draw itself."""

from __future__ import annotations

from PySide6.QtWidgets import QProgressBar


def set_progress(bar: QProgressBar, fraction: float) -> None:
    """Show a fraction (0 to 1) with the next frame.

    Qt's own `setValue` repaints at once, and with the bar the whole window, the 3D views too.
    """
    bar.setUpdatesEnabled(False)
    bar.setValue(round(bar.maximum() * min(max(fraction, 0.0), 1.0)))
    bar.setUpdatesEnabled(True)
