"""One to three panes side by side in one render window: how it is divided, lit, and looked into.

A mixin for the widget on the screen and for the one that draws pictures without a screen, so that both show the same.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from PySide6.QtCore import QPointF
from vtkmodules.vtkRenderingCore import vtkLight

from ui.camera import Camera

PANES = 3
_LIGHTS = (((-0.5, 0.7, 0.9), 0.46), ((0.9, 0.2, 0.7), 0.24), ((-0.6, -0.7, 0.7), 0.14), ((0.0, 0.0, 1.0), 0.40))


@dataclass(frozen=True)
class Tile:
    """A piece of a larger picture: column and row, from the lower left, of ``scale`` x ``scale``."""

    scale: int = 1
    column: int = 0
    row: int = 0

    @property
    def centre(self) -> tuple[float, float]:
        """Of the picture seen from this piece, in half sizes of the piece."""
        return 2.0 * self.column + 1 - self.scale, 2.0 * self.row + 1 - self.scale


WHOLE = Tile()


class Panes:
    """Division, lights, ground and cameras of the renderers.

    Attributes
    ----------
    looks : list of Camera
        One for each pane; all alike while ``linked``.
    active : int
        The pane that was used last.
    """

    renderers: Any
    looks: list[Camera]
    linked: bool
    active: int
    pane_count: int
    bounds_centre: np.ndarray
    bounds_radius: float

    if TYPE_CHECKING:  # what the widget brings along

        def width(self) -> int: ...

        def height(self) -> int: ...

        def update(self) -> None: ...

    def begin_panes(self, renderers: Sequence[Any]) -> None:
        """Take the renderers, once; one pane is shown."""
        start = Camera(np.zeros(3), np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, -1.0]), 1.0)
        self.looks, self.linked, self.active = [start] * PANES, True, 0
        self.bounds_centre, self.bounds_radius = np.zeros(3), 1.0
        for renderer in renderers:
            renderer.RemoveAllLights()
            renderer.SetAutomaticLightCreation(False)
            for place, strength in _LIGHTS:
                renderer.AddLight(_camera_light(place, strength))
            renderer.SetMaximumNumberOfPeels(4)
            renderer.SetOcclusionRatio(0.02)
        self.set_pane_count(1)

    def set_pane_count(self, count: int) -> None:
        """Divide the widget into so many panes."""
        self.pane_count, self.active = count, min(self.active, count - 1)
        for index, renderer in enumerate(self.renderers):
            shown = index < count
            renderer.SetDraw(shown)
            left = index / count if shown else 0.0
            renderer.SetViewport(left, 0.0, (index + 1) / count if shown else 1.0, 1.0)
        self.update()

    def set_ground(self, top: str, bottom: str) -> None:
        """A calm gradient, ``#rrggbb`` each; equal ones give a plain ground."""
        for renderer in self.renderers:
            renderer.SetGradientBackground(top != bottom)
            renderer.SetBackground(*_rgb(bottom))
            renderer.SetBackground2(*_rgb(top))
        self.update()

    def set_scene_bounds(self, centre: np.ndarray, radius: float) -> None:
        """Sphere around everything drawn."""
        self.bounds_centre, self.bounds_radius = centre, radius

    # ---- cameras -------------------------------------------------------------------------------------

    @property
    def look(self) -> Camera:
        """Camera of the pane used last, and of all while they are linked."""
        return self.looks[self.active]

    def set_camera(self, camera: Camera, pane: int | None = None) -> None:
        """Look from elsewhere: in every pane, or in one of them if they are free."""
        if pane is None or self.linked:
            self.looks = [camera] * PANES
        else:
            self.looks[pane] = camera
        self.update()

    def set_linked(self, linked: bool) -> None:
        """One camera for all panes, that of the pane used last; or one for each."""
        self.linked = linked
        if linked:
            self.set_camera(self.look)

    @property
    def aspect(self) -> float:
        """Width over height of one pane."""
        return max(self.width() / self.pane_count, 1.0) / max(self.height(), 1)

    def pane_at(self, position: QPointF) -> tuple[int, float, float]:
        """Pane under a place in the widget, and the place in half heights from that pane's middle."""
        width, height = max(self.width(), 1) / self.pane_count, max(self.height(), 1)
        pane = min(max(int(position.x() // width), 0), self.pane_count - 1)
        x = (position.x() - (pane + 0.5) * width) / (height / 2)
        return pane, x, 1 - 2 * position.y() / height

    def place_of(self, pane: int, x: float, y: float) -> QPointF:
        """The inverse of `pane_at`."""
        width, height = self.width() / self.pane_count, self.height()
        return QPointF((pane + 0.5) * width + x * height / 2, (1 - y) * height / 2)

    def hand_over_cameras(self, tile: Tile = WHOLE) -> None:
        """Set VTK's cameras, just before a frame; of a tile only the part of the picture that it shows."""
        for look, renderer in zip(self.looks, self.renderers, strict=True):
            camera = renderer.GetActiveCamera()
            half = look.half_height / tile.scale
            camera.SetViewAngle(float(np.degrees(2 * np.arctan(half / look.distance))))
            camera.SetParallelProjection(look.parallel)
            camera.SetParallelScale(half)
            camera.SetWindowCenter(*tile.centre)
            camera.SetFocalPoint(*look.focal)
            camera.SetPosition(*look.eye)
            camera.SetViewUp(*look.up)
            camera.SetClippingRange(*look.clipping(self.bounds_centre, self.bounds_radius))

    def set_finish(self, smoothed: bool, peeled: bool) -> None:
        """Smooth edges by a filter; sort glass by depth."""
        for renderer in self.renderers:
            renderer.SetUseFXAA(smoothed)
            renderer.SetUseDepthPeeling(peeled)


def _camera_light(place: tuple[float, float, float], strength: float) -> vtkLight:
    light = vtkLight()
    light.SetLightTypeToCameraLight()
    light.SetPosition(*place)
    light.SetFocalPoint(0.0, 0.0, 0.0)
    light.SetIntensity(strength)
    return light


def _rgb(color: str) -> tuple[float, float, float]:
    return (int(color[1:3], 16) / 255, int(color[3:5], 16) / 255, int(color[5:7], 16) / 255)
