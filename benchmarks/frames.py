"""Watches the frames of a window's 3D views from outside."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ui.app import Studio


def on_frame(studio: Studio, tell: Callable[[bool], None]) -> None:
    """Have ``tell`` called after each frame that shows panels; call this before the views are made.

    It is told whether the frame shows the results of all visible methods for the design of now.
    """
    from ui.viewport import Viewport

    draw = Viewport.paintGL

    def watched(viewport: Viewport) -> None:
        grid = studio.window.area.grid
        shown, complete = grid is not None and bool(grid.panels), is_complete(studio)
        draw(viewport)
        if shown:
            tell(complete)

    Viewport.paintGL = watched  # type: ignore[method-assign]


def is_complete(studio: Studio) -> bool:
    """Whether the views have been given the results of all visible methods for the design of now."""
    from ui.presenter import view_subtitle

    session, grid = studio.session, studio.window.area.grid
    if grid is None or not all(key in session.current for key in session.visible_keys):
        return False
    return [panel.subtitle for panel in grid.panels] == [view_subtitle(session, key) for key in session.visible_keys]
