"""How a window is arranged and what it shows, to be shown alike by the one that takes its place."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QByteArray, QRect, QTimer
from PySide6.QtWidgets import QWidget

from ui import widget_state
from ui.actions import check
from ui.form_section import Section
from ui.reopening import OpenDialog, open_again, open_dialogs

if TYPE_CHECKING:
    from ui.app import Studio
    from ui.camera import Camera
    from ui.picking import Hover
    from ui.views.appearance import Appearance


@dataclass(frozen=True)
class Sight:
    """What the 3D views show, and from where.

    Attributes
    ----------
    color_range : (float, float) or None
        As the user set it; None where it follows the data.
    """

    appearance: Appearance
    visible: frozenset[str]
    looks: tuple[Camera, ...]
    kept: tuple[Camera, str]
    pin: Hover | None
    flank: str
    color_range: tuple[float, float] | None


@dataclass(frozen=True)
class Keepsakes:
    """Of a window.

    Attributes
    ----------
    sight : Sight, optional
        None where there are no views yet.
    tabs : tuple of str
        Pages of the analysis that were opened, the one in sight last.
    """

    geometry: QByteArray
    place: QRect
    layout: QByteArray
    solid: Any
    sight: Sight | None
    tabs: tuple[str, ...]
    actions: dict[str, bool]
    folds: list[str]
    widgets: dict[widget_state.Path, Any]
    dialogs: tuple[OpenDialog, ...]
    focus: widget_state.Path | None


def keepsakes(studio: Studio) -> Keepsakes:
    """Of a window that is about to go."""
    window, controller = studio.window, studio.controller
    solid = controller.solid_mode.keep_state()
    focus = window.focusWidget()
    return Keepsakes(
        window.saveGeometry(),
        window.geometry(),
        window.layout_state(),
        solid,
        _sight(studio),
        (*window.analysis.pages, window.analysis.tab),
        {name: action.isChecked() for name, action in window.commands.by_name.items() if action.isCheckable()},
        window.form.folded_groups(),
        widget_state.states(window, _told_otherwise(studio)),
        open_dialogs(studio),
        next((path for path, widget in widget_state.widgets(window) if widget is focus), None),
    )


def arrange(studio: Studio, kept: Keepsakes) -> None:
    """Give a new window size, place and panels of another one, before it is shown."""
    window = studio.window
    window.restoreGeometry(kept.geometry)
    if not window.isMaximized() and not window.isFullScreen():
        window.setGeometry(kept.place)  # to the pixel, where the frame is not known yet
    window.restore_panels(kept.layout)
    window.form.fold(kept.folds)


def show_alike(studio: Studio, kept: Keepsakes) -> None:
    """Show in a new window what another one showed; its heavy parts are there."""
    window, controller = studio.window, studio.controller
    if kept.sight is not None:
        _look(studio, kept.sight)
    controller.solid_mode.take_state(kept.solid)
    for tab in kept.tabs:
        window.analysis.show_tab(tab)
    for name, on in kept.actions.items():
        window.commands[name].setChecked(on)
    widget_state.choose_again(window, kept.widgets, _told_otherwise(studio))
    bar, sight = window.area.color_bar, kept.sight
    if bar is not None and sight is not None and sight.color_range is not None:
        bar.set_range(*sight.color_range)
    for dialog in kept.dialogs:
        open_again(studio, dialog)
    for path, widget in widget_state.widgets(window):
        if path == kept.focus:
            widget.setFocus()
    QTimer.singleShot(0, window, lambda: widget_state.scroll_again(window, kept.widgets))


def _told_otherwise(studio: Studio) -> list[QWidget]:
    """Parts of the window that follow the session, the layers or the actions."""
    window = studio.window
    return [window.method_bar, window.layer_panel, *window.form.findChildren(Section)]


def _sight(studio: Studio) -> Sight | None:
    area, presenter = studio.window.area, studio.controller.presenter
    grid, bar = area.grid, area.color_bar
    if grid is None or bar is None:
        return None
    return Sight(
        grid.appearance,
        grid.visible_layers,
        tuple(grid.viewport.looks),
        grid.keep_view(),
        grid.pointing.pin,
        presenter.flank,
        None if bar.automatic else bar.range,
    )


def _look(studio: Studio, sight: Sight) -> None:
    grid, controller = studio.window.area.grid, studio.controller
    if grid is None:
        return
    controller.display.show_appearance(sight.appearance)
    grid.set_visible_layers(sight.visible)
    check(studio.window.commands.flanks, sight.flank)
    controller.presenter.set_flank(sight.flank)
    grid.restore_view(sight.kept)
    grid.viewport.looks = [replace(look) for look in sight.looks]
    grid.follow_cameras()
    if sight.pin is not None:
        grid.pointing.put_pin(sight.pin)
