"""Corners and middles of edges near the pointer that can be seen: what a measurement snaps to; numpy alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from ui.camera import Camera
from ui.measuring import Frame, Picked, pick
from ui.section import Plane

if TYPE_CHECKING:
    from ui.layers import Layer
    from ui.solid_layers import PlacedGear

Floats = NDArray[np.float64]
Kind = Literal["corner", "midpoint"]

MOST_TRIED = 6
_BEHIND = 0.004
"""How far behind what is drawn a point still counts as seen, of the size of the gears; chords lie that deep."""


@dataclass(frozen=True, eq=False)
class Sight:
    """What is seen, and from where.

    Attributes
    ----------
    gears : sequence of PlacedGear
    layers : sequence of Layer
        Their surfaces.
    frames : mapping of member to Frame
    look : Camera
    plane : Plane or None
        What lies beyond is not there.
    """

    gears: Sequence[PlacedGear]
    layers: Sequence[Layer]
    frames: Mapping[str, Frame]
    look: Camera
    plane: Plane | None = None


def snap(sight: Sight, x: float, y: float, reach: float) -> tuple[Picked, Kind] | None:
    """The mark nearest to a place of the picture that is not hidden; None where none is near.

    Parameters
    ----------
    sight : Sight
    x, y : float
        Place, in half heights from the middle.
    reach : float
        How near a mark must be, in half heights.
    """
    near = [found for gear in sight.gears for found in _near(sight, gear, x, y, reach)]
    for _, kind, member, point in sorted(near, key=lambda one: one[0])[:MOST_TRIED]:
        if _is_seen(sight, point):
            frame = sight.frames[member]
            local = frame.turn.after(frame.base).back(point)
            return Picked(member, point, local, None), kind
    return None


def _near(sight: Sight, gear: PlacedGear, x: float, y: float, reach: float) -> list[tuple[float, Kind, str, Floats]]:
    found: list[tuple[float, Kind, str, Floats]] = []
    marks: tuple[tuple[Kind, Floats], ...] = (("corner", gear.fine.corners), ("midpoint", gear.fine.midpoints))
    for kind, points in marks:
        placed = sight.frames[gear.member].turn.of(points)
        places = sight.look.project(placed)
        with np.errstate(invalid="ignore"):
            apart = np.hypot(places[:, 0] - x, places[:, 1] - y)
            close = apart < reach
        if sight.plane is not None:
            close &= sight.plane.beyond(placed) <= 0
        found += [(float(apart[i]), kind, gear.member, placed[i]) for i in np.flatnonzero(close)]
    return found


def _is_seen(sight: Sight, point: Floats) -> bool:
    x, y = (float(value) for value in sight.look.project(point))
    start, direction = sight.look.ray(x, y)
    hit = pick(sight.layers, sight.frames, (start, direction), sight.plane)
    size = max(float(np.abs(gear.fine.corners).max()) for gear in sight.gears)
    return hit is None or float((hit.point - point) @ direction) > -_BEHIND * size
