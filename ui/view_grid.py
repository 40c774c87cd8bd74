"""One view, or three side by side with a common camera.

The grid composes a `Viewport` (one OpenGL widget, up to three renderers) with Qt overlays for everything that is
text. It shows `Panel` records; layers that are the same objects as before cost nothing. Pointing at a flank never
redraws the scene: the ray is cast in numpy and the markers are small Qt widgets above the picture.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QSize, QTimer, Signal
from PySide6.QtGui import QImage, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from ui import colormap
from ui.actors import ActorStore
from ui.camera import VIEWS, Camera, Focus, view
from ui.layers import DEFAULT_VISIBLE, Layer, Panel, drawn
from ui.picking import Hover, Picker, describe
from ui.theme import DARK, LIGHT
from ui.view_overlay import MARGIN, Axes, Divider, Marker, PaneTitle
from ui.viewport import PANES, Viewport

_FLANK_IDS = ("deviation", "cad_flank")
_MAP_KEYS = ("deviation/concave", "deviation/convex")
_CONTEXT_IDS = ("tooth", "gear")
_ENOUGH_TO_AIM = 20_000


class ViewGrid(QWidget):
    """The 3D views.

    Signals
    -------
    hovered(object)
        `picking.Hover`, or None when the pointer is on no flank.
    view_changed(str)
        A named view was set.
    """

    hovered = Signal(object)
    view_changed = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._panels: tuple[Panel, ...] = ()
        self._visible = set(DEFAULT_VISIBLE)
        self._focus: Focus | None = None
        self._view, self._dark, self._closed = "tooth", False, False
        self._hover: Hover | None = None
        self._pointer: QPointF | None = None
        self._picker = Picker()

        self.viewport = Viewport(self)
        self.store = ActorStore(self.viewport.renderers)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.viewport)
        self._titles = [PaneTitle(self) for _ in range(PANES)]
        self._values = [PaneTitle(self) for _ in range(PANES)]
        self._markers = [Marker(self) for _ in range(PANES)]
        self._dividers = [Divider(self) for _ in range(PANES - 1)]
        self._axes = Axes(self)

        self._hover_timer = QTimer(self, singleShot=True, interval=0)
        self._hover_timer.timeout.connect(self._update_hover)
        self.viewport.camera_changed.connect(self._on_camera_changed)
        self.viewport.pointer_moved.connect(self._on_pointer_moved)
        self.viewport.pointer_left.connect(self._clear_hover)
        self.viewport.double_clicked.connect(self._on_double_clicked)
        self.viewport.drawing.connect(self.store.set_coarse)
        self.set_theme(False)

    # ---- what is shown -------------------------------------------------------------------------------

    @property
    def panels(self) -> tuple[Panel, ...]:
        """What the views show."""
        return self._panels

    def set_panels(self, panels: Sequence[Panel]) -> None:
        """Show one or three panels (any number up to three); the camera stays unless the gear became another one."""
        count = len(self._panels)
        self._panels = tuple(panels)[:PANES]
        if len(self._panels) != count:
            self.viewport.set_pane_count(max(len(self._panels), 1))
        self._clear_hover()
        self._refresh()
        self._follow(forced=count == 0)
        self._place_overlays()

    def update_layers(self, layers: Sequence[Layer]) -> None:
        """Replace layers of the same key in every panel, as when the plane rolls on."""
        fresh = {layer.key: layer for layer in layers}

        def swapped(panel: Panel) -> Panel:
            return replace(panel, layers=tuple(fresh.get(layer.key, layer) for layer in panel.layers))

        self._panels = tuple(swapped(panel) for panel in self._panels)
        if any(layer.layer_id in self._visible for layer in layers):
            self.viewport.set_moving()
            self._refresh()

    def set_titles(self, titles: Mapping[str, tuple[str, str]]) -> None:
        """New (title, subtitle) of panels, by key; the scene is not drawn again for them."""
        self._panels = tuple(
            replace(panel, title=titles[panel.key][0], subtitle=titles[panel.key][1]) if panel.key in titles else panel
            for panel in self._panels
        )
        self._place_overlays()

    def set_color_range(self, limit_um: float) -> None:
        """Colours run from -limit to +limit [µm] in every view."""
        self.store.set_limit(limit_um)
        self.viewport.update()

    def set_layer_visible(self, layer_id: str, visible: bool) -> None:
        """Switch a row of `LAYERS`."""
        if visible == (layer_id in self._visible):
            return
        self.set_visible_layers(self._visible | {layer_id} if visible else self._visible - {layer_id})

    def set_visible_layers(self, layer_ids: Collection[str]) -> None:
        """Switch on exactly these rows of `LAYERS`."""
        self._visible = set(layer_ids)
        self._clear_hover()
        self._refresh()

    @property
    def visible_layers(self) -> frozenset[str]:
        """The rows of `LAYERS` that are switched on."""
        return frozenset(self._visible)

    def set_theme(self, dark: bool) -> None:
        """Light or dark."""
        self._dark = dark
        colors = DARK if dark else LIGHT
        self.viewport.set_ground(colors.view_top, colors.view_bottom)
        self.store.restyle(dark, self.devicePixelRatioF())
        for overlay in (*self._titles, *self._values, *self._markers, *self._dividers, self._axes):
            if not isinstance(overlay, Marker):
                overlay.set_theme(dark)

    def _refresh(self) -> None:
        shown = tuple(drawn(panel.layers, self._visible) for panel in self._panels)
        self.store.set_layers(shown)
        everything = tuple({id(layer): layer for pane in shown for layer in pane}.values())
        self._picker.keep(tuple(x for panel in self._panels for x in panel.layers))
        self.viewport.set_scene_bounds(*_sphere(everything))
        self.viewport.update()

    # ---- camera --------------------------------------------------------------------------------------

    def set_view(self, name: str) -> None:
        """Look from a named place (`camera.VIEWS`); ``fit`` keeps the direction and shows all of it.

        Raises
        ------
        ValueError
            No such view.
        """
        if name not in VIEWS:
            raise ValueError(f"no view is called {name!r}; there are {', '.join(VIEWS)}")
        if name != "fit":
            self._view = name
        if self._focus is not None:
            focus = self._focus
            seen = [x.points for pane in range(len(self._panels)) for x in self._shown(pane)]
            if name == "fit" and seen:
                focus = replace(focus, points=np.concatenate(seen))
            self.viewport.set_camera(view(name, focus, self.viewport.aspect, self.viewport.look))
            self._on_camera_changed()
        self.view_changed.emit(name)

    def keep_view(self) -> tuple[Camera, str]:
        """Where one looks from now, for `restore_view`."""
        return self.viewport.look, self._view

    def restore_view(self, kept: tuple[Camera, str]) -> None:
        """Look from there again."""
        look, self._view = kept
        self.viewport.set_camera(look)
        self._on_camera_changed()

    def set_parallel_projection(self, parallel: bool) -> None:
        """Without perspective, or with."""
        self.viewport.set_camera(replace(self.viewport.look, parallel=parallel))
        self._on_camera_changed()

    def _follow(self, forced: bool) -> None:
        """Aim the camera again when there is another gear to look at."""
        focus = focus_of(self._panels)
        before, self._focus = self._focus, focus or self._focus
        if focus is not None and (forced or before is None or not focus.resembles(before)):
            self.set_view(self._view)

    def _on_camera_changed(self) -> None:
        self._axes.set_camera(self.viewport.look)
        self._place_markers()

    def _on_double_clicked(self, position: QPointF) -> None:
        pane, x, y = self.viewport.pane_at(position)
        if pane < len(self._panels):
            surfaces = tuple(layer for layer in self._shown(pane) if layer.kind == "surface")
            hit = self._picker.first(surfaces, *self.viewport.look.ray(x, y))
            if hit is not None:
                self.viewport.set_camera(self.viewport.look.centred(hit.point))
                self._on_camera_changed()

    # ---- pointing ------------------------------------------------------------------------------------

    def _shown(self, pane: int, ids: tuple[str, ...] | None = None) -> tuple[Layer, ...]:
        layers = drawn(self._panels[pane].layers, self._visible)
        return layers if ids is None else tuple(x for x in layers if x.kind == "surface" and x.layer_id in ids)

    def _flanks(self, pane: int) -> tuple[Layer, ...]:
        """The flanks one can point at: the deviation is told also where the flank has one colour."""
        layers = self._panels[pane].layers
        made = tuple(x for x in layers if x.key in _MAP_KEYS)
        if made and self._visible & set(_FLANK_IDS):
            return made
        return self._shown(pane, ("theory_flank",))

    def _on_pointer_moved(self, position: QPointF) -> None:
        self._pointer = position
        if not self._hover_timer.isActive():
            self._hover_timer.start()

    def _update_hover(self) -> None:
        if self._pointer is None or not self._panels:
            return
        pane, x, y = self.viewport.pane_at(self._pointer)
        if pane < len(self._panels):
            self._set_hover(pane, x, y)

    def _set_hover(self, pane: int, x: float, y: float) -> None:
        ray = self.viewport.look.ray(x, y)
        hit = self._picker.first(self._flanks(pane), *ray)
        if hit is not None:
            cover = self._picker.first(self._shown(pane, _CONTEXT_IDS), *ray)
            if cover is not None and cover.distance < hit.distance - 1e-3 * self.viewport.bounds_radius:
                hit = None
        if hit is None:
            self._clear_hover(keep_pointer=True)
            return
        self._hover = describe(hit, self._panels[pane].key)
        for other in range(len(self._panels)):
            same = hit if other == pane else self._picker.first(self._flanks(other), *ray)
            value = None if same is None else same.scalar
            self._values[other].set_text("" if value is None else colormap.deviation_text(value), "")
        self._place_markers()
        self._place_overlays()
        self.hovered.emit(self._hover)

    def _clear_hover(self, keep_pointer: bool = False) -> None:
        if not keep_pointer:
            self._pointer = None
        if self._hover is not None:
            self._hover = None
            for overlay in (*self._markers, *self._values):
                overlay.hide()
            self.hovered.emit(None)

    def _place_markers(self) -> None:
        if self._hover is None:
            return
        x, y = self.viewport.look.project(self._hover.xyz)
        for pane, marker in enumerate(self._markers):
            if pane < len(self._panels):
                marker.place(self.viewport.place_of(pane, float(x), float(y)))
            else:
                marker.hide()

    # ---- overlays ------------------------------------------------------------------------------------

    def _place_overlays(self) -> None:
        count = max(len(self._panels), 1)
        width = self.width() / count
        for pane in range(PANES):
            title, value = self._titles[pane], self._values[pane]
            shown = pane < len(self._panels)
            if shown:
                title.set_text(self._panels[pane].title, self._panels[pane].subtitle)
                title.fit(max(round(width) - 2 * MARGIN, 60))
                title.move(round(pane * width) + MARGIN, MARGIN)
                value.move(round((pane + 1) * width) - value.width() - MARGIN, self.height() - value.height() - MARGIN)
            title.setVisible(shown and not title.empty)
            value.setVisible(shown and not value.empty and self._hover is not None)
        for index, divider in enumerate(self._dividers):
            divider.setGeometry(round((index + 1) * width), 0, 1, self.height())
            divider.setVisible(index + 1 < len(self._panels))
        self._axes.move(MARGIN // 2, self.height() - self._axes.height() - MARGIN // 2)
        self._axes.setVisible(bool(self._panels))

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.store.restyle(self._dark, self.devicePixelRatioF())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place_overlays()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.DevicePixelRatioChange and hasattr(self, "store"):
            self.store.restyle(self._dark, self.devicePixelRatioF())

    def sizeHint(self) -> QSize:
        return QSize(900, 600)

    # ---- life ----------------------------------------------------------------------------------------

    def screenshot(self) -> QImage:
        """The views with their titles, as they are on the screen."""
        return self.grab().toImage()

    def close_views(self) -> None:
        """Let go of everything VTK, before the window goes; may be called twice."""
        if not self._closed:
            self._closed = True
            self._hover_timer.stop()
            self.store.clear()
            self.viewport.close()


def focus_of(panels: Sequence[Panel]) -> Focus | None:
    """What the panels let one look at; None when they show nothing."""
    layers = tuple({id(x): x for panel in panels for x in panel.layers if len(x.points)}.values())
    whole = tuple(x for x in layers if x.layer_id in _CONTEXT_IDS) or layers
    if not whole:
        return None
    around = np.concatenate([x.points for x in whole])
    around = around[:: 1 + len(around) // _ENOUGH_TO_AIM]
    flanks = {x.part: x for x in layers if x.layer_id in _FLANK_IDS and x.normals is not None}
    flanks |= {x.part: x for x in layers if x.layer_id == "theory_flank" and x.normals is not None}
    centre, radius = _sphere(whole)
    if not flanks:
        return Focus(centre, radius, around, centre, radius, around, {})
    tooth_centre, tooth_radius = _sphere(tuple(flanks.values()))
    normals = {name: x.normals.mean(axis=0) for name, x in flanks.items() if x.normals is not None}
    points = np.concatenate([x.points for x in flanks.values()])
    return Focus(centre, radius, around, tooth_centre, tooth_radius, points, normals)


def _sphere(layers: Sequence[Layer]) -> tuple[np.ndarray, float]:
    """Centre of the box around layers, and the distance from it to the box's corner."""
    boxes = [layer.bounds for layer in layers if len(layer.points)]
    if not boxes:
        return np.zeros(3), 1.0
    low, high = np.min([b[0] for b in boxes], axis=0), np.max([b[1] for b in boxes], axis=0)
    return (low + high) / 2, max(float(np.linalg.norm(high - low)) / 2, 1e-9)
