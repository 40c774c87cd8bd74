"""What can be filmed: a turntable, two gears in mesh, the plane that rolls on the base cone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from gearstudio.theory.flank import FLANKS
from ui.camera import Camera
from ui.scene import SceneOptions, rolling_layers
from ui.solid_layers import motion
from ui.words import tr

if TYPE_CHECKING:
    from gearstudio.theory.cones import MemberGeometry, PairGeometry
    from ui.solid_view import SolidView
    from ui.view_grid import ViewGrid


@dataclass(frozen=True)
class Motion:
    """A film's subject.

    Attributes
    ----------
    id, title : str
    show : callable
        Puts a stand-in of the views, given the cameras it started with, to a place in [0, 1) of the film.
    loops : bool
        The end joins the beginning.
    """

    id: str
    title: str
    show: Callable[[ViewGrid, list[Camera], float], None]
    loops: bool


def turned_about_axis(look: Camera, angle: float) -> Camera:
    """The camera carried about the gear's axis through the middle of the view [rad]."""
    cos, sin = np.cos(angle), np.sin(angle)
    turn = np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])
    return replace(look, back=turn @ look.back, up=turn @ look.up)


def turntable() -> Motion:
    """The camera goes once about an axis parallel to the gear's, through what is in the middle."""

    def show(grid: ViewGrid, looks: list[Camera], place: float) -> None:
        grid.viewport.looks = [turned_about_axis(look, 2 * np.pi * place) for look in looks]
        grid.follow_cameras()

    return Motion("turntable", tr("Turntable"), show, True)


def meshing(pair: PairGeometry, view: SolidView) -> Motion:
    """The pair turns on by one tooth, which looks like the beginning again."""
    start, pitch = view.angle, 2 * np.pi / pair.pinion.teeth

    def show(grid: ViewGrid, looks: list[Camera], place: float) -> None:
        grid.pointing.pin = None  # it would stay behind
        grid.place_markers()
        grid.store.move({name: motion(pair, name, start + place * pitch) for name in ("pinion", "wheel")})

    return Motion("meshing", tr("Pair in mesh, on by one tooth"), show, True)


def rolling(member: MemberGeometry, flank: str) -> Motion:
    """The plane rolls over the base cone and its line sweeps out the flank."""
    options = SceneOptions(flank=next(name for name in FLANKS if name == flank))

    def show(grid: ViewGrid, looks: list[Camera], place: float) -> None:
        grid.update_layers(rolling_layers(member, place, options))

    return Motion("rolling", tr("Rolling of the tangent plane"), show, False)
