"""Measuring by clicks in the views: two points, a line over the picture, numbers in the panel."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QPointF, Qt

from ui.measure_overlay import MeasureOverlay
from ui.measuring import Picked, measure, pick
from ui.solid_words import measured
from ui.units import with_unit
from ui.words import tr

if TYPE_CHECKING:
    from ui.solid_view import SolidView


class SolidMeasure(QObject):
    """Takes clicks while it is on.

    ``say`` is told the read-out, empty while there are fewer than two points.
    """

    def __init__(self, view: SolidView, say: Callable[[str], None], parent: QObject) -> None:
        super().__init__(parent)
        self._view, self._say = view, say
        self._points: list[Picked] = []
        self._on = False
        self._overlay = MeasureOverlay(view.grid)
        view.grid.viewport.clicked.connect(self._on_clicked)
        view.grid.viewport.drawing.connect(lambda _hurried: self._place())

    @property
    def points(self) -> tuple[Picked, ...]:
        """What was picked."""
        return tuple(self._points)

    def switch(self, on: bool) -> None:
        """Take clicks or not; what was measured goes."""
        self._on = on
        viewport = self._view.grid.viewport
        viewport.setCursor(Qt.CursorShape.CrossCursor) if on else viewport.unsetCursor()
        self.clear()

    def clear(self) -> None:
        """Forget the points, as when the solid turns or becomes another one."""
        if self._points:
            self._points = []
            self._say("")
        self._place()

    def _on_clicked(self, position: QPointF) -> None:
        if not self._on:
            return
        view = self._view
        _, x, y = view.grid.viewport.pane_at(position)
        surfaces = tuple(layer for layer in view.layers if layer.body and layer.level != "coarse")
        found = pick(surfaces, view.frames, view.grid.viewport.look.ray(x, y), view.plane)
        if found is None:
            return
        self._points = [found] if len(self._points) == 2 else [*self._points, found]
        self.show_units()

    def show_units(self) -> None:
        """Say what was measured, in the unit of lengths that is shown."""
        if self._points:
            both = len(self._points) == 2
            self._say(measured(measure(*self._points)) if both else tr("Click the second point."))
        self._place()

    def _place(self) -> None:
        viewport = self._view.grid.viewport
        places = []
        for picked in self._points:
            x, y = viewport.look.project(picked.point)
            places.append(viewport.place_of(0, float(x), float(y)))
        text = with_unit(measure(*self._points).distance, "mm", 4) if len(self._points) == 2 else ""
        self._overlay.show_points(tuple(places), text)
