"""Where the cameras of the views look: from a named place, at what there is to see."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ui.camera import Camera, Focus, view
from ui.layers import Layer, Panel
from ui.views.focus import focus_of, thinned

if TYPE_CHECKING:
    from ui.views.panes import Panes

_MOST_ABOVE = 0.3


class Aim:
    """Aims the cameras of some panes, and aims them again when there is another gear to look at."""

    def __init__(self, panes: Panes) -> None:
        self._panes = panes
        self._view = "tooth"
        self._focus: Focus | None = None

    def look_from(self, name: str, seen: Iterable[Layer], above: float) -> None:
        """Look from a named place (`camera.VIEWS`) in the pane used last.

        Parameters
        ----------
        name : str
            ``fit`` keeps the direction.
        seen : iterable of Layer
            What ``fit`` shows all of.
        above : float
            Share of the height that titles take.
        """
        focus = self._focus
        if name != "fit":
            self._view = name
        elif focus is not None and (points := [thinned(layer.points) for layer in seen]):
            focus = replace(focus, points=np.concatenate(points))
        if focus is not None:
            self._turn(name, focus, above, self._panes.active)

    def follow(self, panels: Sequence[Panel], above: float, forced: bool) -> None:
        """Look from the same named place in every pane if the panels show another gear, or if it is asked for."""
        panes, focus = self._panes, focus_of(panels)
        before, self._focus = self._focus, focus or self._focus
        if focus is not None and (forced or before is None or not focus.resembles(before)):
            panes.set_camera(panes.look)
            panes.active = 0
            for pane in range(1 if panes.linked else len(panes.looks)):
                self._turn(self._view, focus, above, pane)

    def _turn(self, name: str, focus: Focus, above: float, pane: int) -> None:
        panes = self._panes
        panes.set_camera(view(name, focus, panes.aspect, panes.looks[pane], min(above, _MOST_ABOVE)), pane)

    def keep(self) -> tuple[Camera, str]:
        """Where one looks from now, for `restore`."""
        return self._panes.look, self._view

    def restore(self, kept: tuple[Camera, str]) -> None:
        """Look from there again, in the projection of now."""
        look, self._view = kept
        self._panes.set_camera(replace(look, parallel=self._panes.look.parallel))
