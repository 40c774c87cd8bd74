"""The path of contact over both flanks, and the edges on which it runs (theory 8)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.contact_grid import PinionGrid
from gearstudio.analysis.contact_roll import Roll
from gearstudio.analysis.ease_off import EaseOff

Floats = NDArray[np.float64]

_LOADED = 1e-9
_PLATEAU_UM = 0.005
_EDGE_GAIN_UM = 0.02
_EDGE_SHARE = 0.002
_EDGE_NAMES = ("the tip of the wheel", "the root of the wheel", "the toe", "the heel")
_PINION_NAMES = ("the root of the pinion", "the tip of the pinion")


@dataclass(frozen=True)
class ContactPath:
    """Where the flanks touch at each turn at which a pair of teeth carries the load.

    Attributes
    ----------
    turn_deg : ndarray, shape (n,)
    u, v : ndarray, shape (n,)
        On the pinion's flank; where they touch along a line, its middle.
    pinion_points, wheel_points : ndarray, shape (n, 3)
        Each in its member's frame, of the tooth at azimuth 0 [mm].
    edges : tuple of str
        The edges that touch instead of the flank's inside, in words.
    """

    turn_deg: Floats
    u: Floats
    v: Floats
    pinion_points: Floats
    wheel_points: Floats
    edges: tuple[str, ...]


def contact_path(grid: PinionGrid, roll: Roll, eased: EaseOff) -> ContactPath:
    """The path of contact of a pair of teeth with its neighbours in mesh."""
    mesh = grid.mesh
    steps = (roll.first + np.arange(len(roll.turn))) % roll.per_pitch
    loaded = np.isfinite(roll.lag) & (roll.lag - roll.shared_lag()[steps] < _LOADED)
    turn, u, v = roll.turn[loaded], roll.u[loaded].copy(), roll.v[loaded].copy()
    line_u, line_v, line_lag = _inside(grid, eased, turn)
    lever = float(mesh.lever(mesh.pair.wheel.mean_cone_distance)) * 1e3
    inside = (line_lag - roll.lag[loaded]) * lever < _EDGE_GAIN_UM
    u[inside], v[inside] = line_u[inside], line_v[inside]
    points = grid.points(u, v)
    met = mesh.meet(points, turn)
    names = _edges(grid, u, v, turn, steps[loaded])
    return ContactPath(np.degrees(turn), u, v, points, mesh.on_wheel(met), names)


def _inside(grid: PinionGrid, eased: EaseOff, turn: Floats) -> tuple[Floats, Floats, Floats]:
    """The middle of the lowest stretch along the line of contact of each turn: u, v, lag (n,)."""
    columns = []
    for column, place in enumerate(grid.v):
        reached, facing = eased.turn[:, column], eased.facing[:, column]
        order = np.argsort(reached)
        reached, lag = reached[order], np.where(facing, eased.lag[:, column], np.inf)[order]
        within = (turn >= reached[0]) & (turn <= reached[-1])
        at = np.interp(turn, reached, np.arange(len(order)))
        low = np.minimum(np.floor(at).astype(int), len(order) - 2)
        share = at - low
        with np.errstate(invalid="ignore"):
            between = lag[low] * (1 - share) + lag[low + 1] * share
        u = grid.u[order, column]
        columns.append(
            (
                u[low] * (1 - share) + u[low + 1] * share,
                np.full_like(turn, place),
                np.where(within & np.isfinite(between), between, np.inf),
            )
        )
    u, v, lag = (np.array(part) for part in zip(*columns, strict=True))
    lever = float(grid.mesh.lever(grid.mesh.pair.wheel.mean_cone_distance)) * 1e3
    with np.errstate(invalid="ignore"):
        lowest = (lag - lag.min(axis=0)) * lever <= _PLATEAU_UM
    lowest &= np.isfinite(lag)
    rank = np.cumsum(lowest, axis=0)
    middle = np.argmax(rank >= (rank[-1] + 1) // 2, axis=0)
    each = np.arange(len(turn))
    return u[middle, each], v[middle, each], lag[middle, each]


def _edges(grid: PinionGrid, u: Floats, v: Floats, turn: Floats, step: NDArray[np.int_]) -> tuple[str, ...]:
    """Names of the edges that touch at steps of the pitch at which no pair of teeth touches inside."""
    mesh, wheel = grid.mesh, grid.mesh.pair.wheel
    depth = float(np.ptp(np.stack(mesh.wheel_flank.limits([0.5])))) * wheel.mean_cone_distance
    size = np.array([depth, depth, wheel.face_width, wheel.face_width])
    margins = np.stack(mesh.margins(mesh.meet(grid.points(u, v), turn))) / size[:, None]
    on_edge = np.concatenate([margins, [u, 1 - u, v, 1 - v]]) < _EDGE_SHARE
    inside = np.isin(step, step[~on_edge.any(axis=0)])
    names = [*_EDGE_NAMES, *_PINION_NAMES, *_EDGE_NAMES[2:]]
    return tuple(dict.fromkeys(name for name, at in zip(names, on_edge & ~inside, strict=True) if np.any(at)))
