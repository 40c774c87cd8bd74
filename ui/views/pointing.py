"""The point of a flank under the pointer, and the one that was picked: rays in numpy, nothing is drawn again."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, QTimer, Signal
from PySide6.QtGui import QHelpEvent, QKeyEvent
from PySide6.QtWidgets import QToolTip

from ui.layers import Layer
from ui.picking import Hit, Hover, describe, first_hit
from ui.views.focus import CONTEXT_IDS

if TYPE_CHECKING:
    from ui.view_grid import ViewGrid

_FLANK_IDS = ("deviation", "cad_flank")
_MAP_KEYS = ("deviation/concave", "deviation/convex")


class Pointing(QObject):
    """Follows the pointer over a view grid, and keeps the picked point.

    Signals
    -------
    hovered(object)
        `picking.Hover`, or None when the pointer is on no flank.
    picked(object)
        `picking.Hover` of a click, or None when the marker went.
    """

    hovered = Signal(object)
    picked = Signal(object)
    pin: Hover | None = None
    hover_place = pin_place = (0.0, 0.0, 0.0)
    """Where the points are drawn in the view."""

    def __init__(self, grid: ViewGrid) -> None:
        super().__init__(grid)
        self._grid = grid
        self.hover: Hover | None = None
        self._pointer: QPointF | None = None
        self._timer = QTimer(self, singleShot=True, interval=0)
        self._timer.timeout.connect(self._update)
        viewport = grid.viewport
        viewport.pointer_moved.connect(self._on_moved)
        viewport.pointer_left.connect(self.clear)
        viewport.clicked.connect(self._on_clicked)
        viewport.installEventFilter(self)

    def stop(self) -> None:
        """Follow no more."""
        self._timer.stop()
        self._grid.viewport.removeEventFilter(self)

    def first(self, layers: tuple[Layer, ...], pane: int, x: float, y: float) -> Hit | None:
        """The nearest of some surfaces at a place of a pane."""
        return first_hit(layers, *self._grid.viewport.looks[pane].ray(x, y))

    def flanks(self, pane: int) -> tuple[Layer, ...]:
        """The flanks one can point at: the deviation is told also where the flank has one colour."""
        layers = self._grid.panels[pane].layers
        made = tuple(x for x in layers if x.key in _MAP_KEYS)
        if made and self._grid.visible_layers & set(_FLANK_IDS):
            return made
        return tuple(x for x in self._grid.shown(pane) if x.kind == "surface" and x.layer_id == "theory_flank")

    def clear(self, keep_pointer: bool = False) -> None:
        """No flank is under the pointer."""
        if not keep_pointer:
            self._pointer = None
        if self.hover is not None:
            self.hover = None
            for value in self._grid.overlays.values:
                value.hide()
            self._grid.place_markers()
            self.hovered.emit(None)

    def drop_pin(self) -> None:
        """Take the marker away."""
        if self.pin is not None:
            self.pin = None
            self._grid.place_markers()
            self.picked.emit(None)

    def put_pin(self, pin: Hover, place: ArrayLike | None = None) -> None:
        """Put the marker at a point, or where in the view that is if its gear stands elsewhere."""
        self.pin, self.pin_place = pin, _xyz(pin.xyz if place is None else place)
        self._grid.place_markers()
        self.picked.emit(pin)

    def carry_pin(self, place: ArrayLike) -> None:
        """The gear with the pinned point has moved."""
        if self.pin is not None and _xyz(place) != self.pin_place:
            self.pin_place = _xyz(place)
            self._grid.place_markers()

    def follow_layers(self) -> None:
        """The flanks may be drawn elsewhere now: the marker goes along with the point it was put on."""
        pin = self.pin
        if pin is None or pin.member:
            return
        drawn = [x for panel in self._grid.panels if panel.key == pin.panel_key for x in panel.layers]
        layer = next((x for x in drawn if x.key == f"deviation/{pin.flank}"), None)
        place = np.array(pin.xyz)
        if layer is not None and layer.true_points is not None:
            nearest = int(np.argmin(np.sum((layer.true_points - place) ** 2, axis=1)))
            place = place + layer.points[nearest] - layer.true_points[nearest]
        self.carry_pin(place)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Escape takes the marker away before it means anything else; a shortened title is told in full."""
        if event.type() == QEvent.Type.ToolTip and isinstance(event, QHelpEvent):
            self._tell_title(event)
        if self.pin is not None and isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape:
            if event.type() == QEvent.Type.ShortcutOverride:
                event.accept()
                return True
            if event.type() == QEvent.Type.KeyPress:
                self.drop_pin()
                return True
        return False

    def _tell_title(self, event: QHelpEvent) -> None:
        """Titles let the mouse through, so what lies below them has to tell."""
        for title in self._grid.overlays.titles:
            if title.isVisible() and title.shortened and title.geometry().contains(event.pos()):
                QToolTip.showText(event.globalPos(), title.whole, self._grid)

    def _on_moved(self, position: QPointF) -> None:
        self._pointer = position
        if not self._timer.isActive():
            self._timer.start()

    def _update(self) -> None:
        grid = self._grid
        if self._pointer is None or not grid.panels:
            return
        pane, x, y = grid.viewport.pane_at(self._pointer)
        if pane >= len(grid.panels):
            return
        hit = self._hit(pane, x, y)
        if hit is None:
            self.clear(keep_pointer=True)
            return
        self.hover, self.hover_place = describe(hit, grid.panels[pane].key), _xyz(hit.point)
        self._show_values(hit, pane)
        grid.place_markers()
        grid.place_overlays()
        self.hovered.emit(self.hover)

    def _show_values(self, hit: Hit, pane: int) -> None:
        """The value at the same place in every pane, seen as this pane sees it."""
        grid = self._grid
        start, direction = grid.viewport.looks[pane].eye, hit.point - grid.viewport.looks[pane].eye
        for other in range(len(grid.panels)):
            same = hit if other == pane else first_hit(self.flanks(other), start, direction)
            value = None if same is None else same.scalar
            grid.overlays.values[other].set_text("" if value is None else grid.value_text(value), "")

    def _hit(self, pane: int, x: float, y: float) -> Hit | None:
        """The flank at a place, unless something stands before it."""
        grid = self._grid
        hit = self.first(self.flanks(pane), pane, x, y)
        if hit is None:
            return None
        cover = tuple(x for x in grid.shown(pane) if x.kind == "surface" and x.layer_id in CONTEXT_IDS)
        before = self.first(cover, pane, x, y)
        hidden = before is not None and before.distance < hit.distance - 1e-3 * grid.viewport.bounds_radius
        return None if hidden else hit

    def _on_clicked(self, position: QPointF) -> None:
        grid = self._grid
        pane, x, y = grid.viewport.pane_at(position)
        hit = self._hit(pane, x, y) if pane < len(grid.panels) else None
        if hit is not None:
            self.put_pin(describe(hit, grid.panels[pane].key), hit.point)


def _xyz(point: ArrayLike) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in np.asarray(point))
    return x, y, z
