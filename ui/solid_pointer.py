"""The point of a solid under the pointer, and the one that was clicked: markers over the picture."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, QPointF, QTimer

from ui.measure_overlay import MeasureOverlay
from ui.picking import Hover
from ui.solid_spots import SolidSpots

if TYPE_CHECKING:
    from ui.solid_view import SolidView
    from ui.solids import Built

Floats = NDArray[np.float64]


class SolidPointer(QObject):
    """Follows the pointer while it is on; ``say`` is told a `picking.Hover`, or None off the solids.

    A click pins the point, unless clicks mean something else (``pins``); the marker stays on its gear when that turns.
    """

    def __init__(self, view: SolidView, say: Callable[[Hover | None], None], parent: QObject) -> None:
        super().__init__(parent)
        self._view, self._say = view, say
        self.spots = SolidSpots(view)
        self.pins = True
        self._on = False
        self._position: QPointF | None = None
        self._point: Floats | None = None
        self._overlay = MeasureOverlay(view.grid)
        self._timer = QTimer(self, singleShot=True, interval=0)
        self._timer.timeout.connect(self._update)
        viewport = view.grid.viewport
        viewport.pointer_moved.connect(self._on_moved)
        viewport.pointer_left.connect(self.clear)
        viewport.clicked.connect(self._on_clicked)
        viewport.drawing.connect(lambda _hurried: self._place())

    def show_solids(self, built: dict[str, Built]) -> None:
        """The solids in sight, by member; none switches it off. A pin on a solid that is gone goes with it."""
        before, self.spots.built, self._on = self.spots.built, built, bool(built)
        pin = self._pin
        if pin is not None and (
            pin.member not in built or before.get(pin.member, built[pin.member]) is not built[pin.member]
        ):
            self._view.grid.pointing.drop_pin()
        if not self._on:
            self.clear()

    def clear(self) -> None:
        """Nothing is under the pointer."""
        self._timer.stop()
        self._position = None
        self._tell(None, None)

    # ---- parts -----------------------------------------------------------------------------------------

    @property
    def _pin(self) -> Hover | None:
        """The pinned point, if it is one of a solid."""
        pin = self._view.grid.pointing.pin
        return pin if pin is not None and pin.member else None

    def _on_moved(self, position: QPointF) -> None:
        if self._on:
            self._position = position
            if not self._timer.isActive():
                self._timer.start()

    def _update(self) -> None:
        if self._position is None or not self._on:
            return
        found = self.spots.at(self._position)
        self._tell(*(found or (None, None)))

    def _on_clicked(self, position: QPointF) -> None:
        found = self.spots.at(position) if self._on and self.pins else None
        if found is not None:
            self._view.grid.pointing.put_pin(*found)

    def _tell(self, hover: Hover | None, point: Floats | None) -> None:
        if hover is not None or self._point is not None:
            self._point = point
            self._say(hover)
            self._place()

    def _place(self) -> None:
        pin, viewport = self._pin, self._view.grid.viewport
        if pin is not None and (place := self.spots.place(pin)) is not None:
            self._view.grid.pointing.carry_pin(place)
        if self._point is None:
            self._overlay.show_points((), "")
            return
        x, y = viewport.look.project(self._point)
        self._overlay.show_points((viewport.place_of(0, float(x), float(y)),), "")
