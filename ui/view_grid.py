"""One view, or three side by side with a common camera or one each.

The grid composes a `Viewport` (one OpenGL widget, up to three renderers) with Qt overlays for everything that is
text. It shows `Panel` records; layers that are the same objects as before cost nothing. Pointing at a flank never
redraws the scene: the ray is cast in numpy and the markers are small Qt widgets above the picture.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace

from PySide6.QtCore import QEvent, QPointF, QSize, Signal
from PySide6.QtGui import QImage, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from ui import colormap
from ui.actors import ActorStore
from ui.camera import VIEWS, Camera
from ui.layers import DEFAULT_VISIBLE, Layer, Panel, drawn
from ui.theme import DARK, LIGHT
from ui.viewport import Viewport
from ui.views.aim import Aim
from ui.views.appearance import GROUNDS, Appearance
from ui.views.focus import sphere_around
from ui.views.overlays import Overlays
from ui.views.panes import PANES
from ui.views.pointing import Pointing
from ui.views.quantities import quantity_of
from ui.views.still import StillViewport

EDGE = " edge"
"""How the parts are called that border a surface."""


class ViewGrid(QWidget):
    """The 3D views.

    ``make_viewport`` makes what they are drawn in: on the screen, or a `StillViewport` for pictures.

    Signals
    -------
    hovered(object)
        `picking.Hover`, or None when the pointer is on no flank.
    picked(object)
        `picking.Hover` of a click on a flank, or None when its marker was taken away.
    visible_changed()
        Layers were switched on or off.
    """

    hovered = Signal(object)
    picked = Signal(object)
    visible_changed = Signal()

    def __init__(
        self,
        parent: QWidget | None = None,
        make_viewport: Callable[[QWidget], Viewport | StillViewport] = Viewport,
    ) -> None:
        super().__init__(parent)
        self._panels: tuple[Panel, ...] = ()
        self._visible = set(DEFAULT_VISIBLE)
        self._dark, self._closed = False, False
        self._range = (-1.0, 1.0)
        self.appearance = Appearance()
        self.viewport = make_viewport(self)
        self.aim = Aim(self.viewport)
        self.store = ActorStore(self.viewport.renderers)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.viewport)
        self.overlays = Overlays(self)
        self.pointing = Pointing(self)
        self.pointing.hovered.connect(self.hovered)
        self.pointing.picked.connect(self.picked)
        self.viewport.camera_changed.connect(self.follow_cameras)
        self.viewport.double_clicked.connect(self._on_double_clicked)
        self.viewport.drawing.connect(self._on_drawing)
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
        self.pointing.clear()
        self._refresh()
        self.aim.follow(self._panels, self._above, forced=count == 0)
        self.pointing.follow_layers()
        self.follow_cameras()
        self.place_overlays()

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
        self.place_overlays()

    def set_color_range(self, high: float, low: float | None = None) -> None:
        """Colours run from low (-high if none is given) to high in every view."""
        self._range = (-high if low is None else low, high)
        self.store.set_range(*self._range)
        self.viewport.update()

    @property
    def color_range(self) -> tuple[float, float]:
        """From where to where the colours run."""
        return self._range

    def set_layer_visible(self, layer_id: str, visible: bool) -> None:
        """Switch a row of `LAYERS`."""
        if visible == (layer_id in self._visible):
            return
        self.set_visible_layers(self._visible | {layer_id} if visible else self._visible - {layer_id})

    def set_visible_layers(self, layer_ids: Collection[str]) -> None:
        """Switch on exactly these rows of `LAYERS`."""
        self._visible = set(layer_ids)
        self.pointing.clear()
        self._refresh()
        self.visible_changed.emit()

    @property
    def visible_layers(self) -> frozenset[str]:
        """The rows of `LAYERS` that are switched on."""
        return frozenset(self._visible)

    def shown(self, pane: int) -> tuple[Layer, ...]:
        """The layers that are drawn in a pane."""
        layers = drawn(self._panels[pane].layers, self._visible)
        return layers if self.appearance.edges else tuple(x for x in layers if not x.part.endswith(EDGE))

    def show_appearance(self, appearance: Appearance) -> None:
        """Take colours, projection, ground and everything else of a record."""
        before, self.appearance = self.appearance, appearance
        symmetric = quantity_of(appearance).symmetric
        self.store.set_colors(colormap.suited(appearance.colors, symmetric), appearance.steps)
        self.store.set_looks(appearance.looks)
        self.store.set_stripes(appearance.stripes if appearance.zebra else None)
        self.viewport.set_linked(appearance.linked)
        if any(look.parallel != appearance.parallel for look in self.viewport.looks):
            self.viewport.looks = [replace(look, parallel=appearance.parallel) for look in self.viewport.looks]
        self.overlays.axes_wanted, self.overlays.scales_wanted = appearance.axes, appearance.scale_bar
        if before.ground != appearance.ground:
            self.set_theme(self._dark)
        if before.edges != appearance.edges:
            self._refresh()
        self.follow_cameras()
        self.place_overlays()
        self.viewport.update()

    def value_text(self, value: float) -> str:
        """A value of what colours the flanks, with its unit."""
        return quantity_of(self.appearance).text(value, self.appearance.unit)

    def set_theme(self, dark: bool) -> None:
        """Light or dark; on a ground of its own colour what is drawn suits that."""
        self._dark = dark
        _, on_dark = GROUNDS.get(self.appearance.ground, ("", dark))
        self.viewport.set_ground(*self.ground)
        self.store.restyle(on_dark, self.devicePixelRatioF())
        self.overlays.set_theme(on_dark)

    @property
    def ground(self) -> tuple[str, str]:
        """Colours of the background, above and below."""
        colors = DARK if self._dark else LIGHT
        plain, _ = GROUNDS.get(self.appearance.ground, ("", False))
        return plain or colors.view_top, plain or colors.view_bottom

    @property
    def dark(self) -> bool:
        """Whether the window is dark."""
        return self._dark

    def _refresh(self) -> None:
        shown = tuple(self.shown(pane) for pane in range(len(self._panels)))
        self.store.set_layers(shown)
        everything = tuple({id(layer): layer for pane in shown for layer in pane}.values())
        self.viewport.set_scene_bounds(*sphere_around(everything))
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
        self.aim.look_from(name, (x for pane in range(len(self._panels)) for x in self.shown(pane)), self._above)
        self.follow_cameras()

    def keep_view(self) -> tuple[Camera, str]:
        """Where one looks from now, for `restore_view`."""
        return self.aim.keep()

    def restore_view(self, kept: tuple[Camera, str]) -> None:
        """Look from there again."""
        self.aim.restore(kept)
        self.follow_cameras()

    @property
    def _above(self) -> float:
        """Share of the height that titles take."""
        return self.overlays.title_height / max(self.height(), 1)

    def _on_drawing(self, hurried: bool) -> None:
        self.store.set_coarse(hurried)
        self.store.aim_stripes(self.viewport.looks)

    def follow_cameras(self) -> None:
        """Let axes, scales and markers follow the cameras."""
        self.overlays.follow(self.viewport, max(len(self._panels), 1))
        self.place_markers()

    def _on_double_clicked(self, position: QPointF) -> None:
        pane, x, y = self.viewport.pane_at(position)
        if pane < len(self._panels):
            surfaces = tuple(layer for layer in self.shown(pane) if layer.kind == "surface")
            hit = self.pointing.first(surfaces, pane, x, y)
            if hit is not None:
                self.viewport.set_camera(self.viewport.looks[pane].centred(hit.point), pane)
                self.follow_cameras()

    # ---- overlays ------------------------------------------------------------------------------------

    def place_markers(self) -> None:
        """Put the markers where their points are seen now."""
        pointing = self.pointing
        hover = None if pointing.hover is None else pointing.hover_place
        pin = None if pointing.pin is None else pointing.pin_place
        self.overlays.point(self.viewport, len(self._panels), hover, pin)

    def place_overlays(self) -> None:
        """Put titles, values and bars where they belong."""
        self.overlays.place(self._panels, self.pointing.hover is not None, self.viewport.linked)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.set_theme(self._dark)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.place_overlays()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.DevicePixelRatioChange and hasattr(self, "overlays"):
            self.set_theme(self._dark)

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
            self.pointing.stop()
            self.store.clear()
            self.viewport.close()
