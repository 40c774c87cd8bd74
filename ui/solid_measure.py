"""Measuring by clicks in the views: two points, a line over the picture, numbers in the panel."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QPointF, Qt, QTimer

from ui.measure_overlay import MeasureOverlay
from ui.measuring import Picked, measure, pick
from ui.snapping import Sight, snap
from ui.solid_words import measured
from ui.units import with_unit
from ui.words import noted, tr

if TYPE_CHECKING:
    from ui.layers import Layer
    from ui.solid_view import SolidView


SNAP_PIXELS = 12.0
KINDS = {"corner": noted("corner"), "midpoint": noted("middle of an edge")}


class SolidMeasure(QObject):
    """Takes clicks while it is on.

    ``say`` is told the read-out, empty while there are fewer than two points. While ``snaps``, the pointer is drawn
    to corners and middles of edges, which a square with a word tells.
    """

    def __init__(self, view: SolidView, say: Callable[[str], None], parent: QObject) -> None:
        super().__init__(parent)
        self._view, self._say = view, say
        self._points: list[Picked] = []
        self._hint: tuple[Picked, str] | None = None
        self._position = QPointF()
        self._on = False
        self.snaps = True
        self._overlay = MeasureOverlay(view.grid)
        self._timer = QTimer(self, singleShot=True, interval=0)
        self._timer.timeout.connect(self._look_for_marks)
        viewport = view.grid.viewport
        viewport.clicked.connect(self._on_clicked)
        viewport.pointer_moved.connect(self._on_moved)
        viewport.pointer_left.connect(lambda: self._show_hint(None))
        viewport.drawing.connect(lambda _hurried: self._place())

    @property
    def points(self) -> tuple[Picked, ...]:
        """What was picked."""
        return tuple(self._points)

    @property
    def hint(self) -> tuple[Picked, str] | None:
        """What a click would snap to, and of what kind it is."""
        return self._hint

    def switch(self, on: bool) -> None:
        """Take clicks or not; what was measured goes."""
        self._on = on
        viewport = self._view.grid.viewport
        viewport.setCursor(Qt.CursorShape.CrossCursor) if on else viewport.unsetCursor()
        self.clear()

    def set_snapping(self, on: bool) -> None:
        """Draw the pointer to corners and middles of edges, or leave it where it is."""
        self.snaps = on
        self._show_hint(None)

    def clear(self) -> None:
        """Forget the points, as when the solid turns or becomes another one."""
        self._timer.stop()
        self._hint = None
        if self._points:
            self._points = []
            self._say("")
        self._place()

    def show_units(self) -> None:
        """Say what was measured, in the unit of lengths that is shown."""
        if self._points:
            both = len(self._points) == 2
            self._say(measured(measure(*self._points)) if both else tr("Click the second point."))
        self._place()

    def _on_clicked(self, position: QPointF) -> None:
        if not self._on:
            return
        found = self._snapped(position)
        picked = found[0] if found is not None else self._picked(position)
        if picked is None:
            return
        self._points = [picked] if len(self._points) == 2 else [*self._points, picked]
        self.show_units()

    def _on_moved(self, position: QPointF) -> None:
        if self._on and self.snaps:
            self._position = position
            if not self._timer.isActive():
                self._timer.start()

    def _look_for_marks(self) -> None:
        self._show_hint(self._snapped(self._position))

    def _show_hint(self, hint: tuple[Picked, str] | None) -> None:
        if hint is not None or self._hint is not None:
            self._hint = hint
            self._place()

    def _snapped(self, position: QPointF) -> tuple[Picked, str] | None:
        view = self._view
        if not self.snaps or not view.gears:
            return None
        viewport = view.grid.viewport
        _, x, y = viewport.pane_at(position)
        sight = Sight(view.gears, self._surfaces("coarse"), view.frames, viewport.look, view.plane)
        return snap(sight, x, y, SNAP_PIXELS / (max(viewport.height(), 1) / 2))

    def _picked(self, position: QPointF) -> Picked | None:
        view = self._view
        _, x, y = view.grid.viewport.pane_at(position)
        return pick(self._surfaces("fine"), view.frames, view.grid.viewport.look.ray(x, y), view.plane)

    def _surfaces(self, level: str) -> tuple[Layer, ...]:
        return tuple(layer for layer in self._view.layers if layer.body and layer.level in ("", level))

    def _place(self) -> None:
        viewport = self._view.grid.viewport

        def seen(picked: Picked) -> QPointF:
            x, y = viewport.look.project(picked.point)
            return viewport.place_of(0, float(x), float(y))

        text = with_unit(measure(*self._points).distance, "mm", 4) if len(self._points) == 2 else ""
        hint = None if self._hint is None else (seen(self._hint[0]), tr(KINDS[self._hint[1]]))
        self._overlay.show_points(tuple(seen(picked) for picked in self._points), text, hint)
