"""Measured points as layers of a 3D view: nets coloured by deviation, and the points themselves; no widget."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.measurement_fit import Assignment, normals_at
from gearstudio.analysis.nets import cell_means
from ui import layers as look
from ui.analysis.measurement_data import ALL_TEETH, Measurement
from ui.grids import grid_triangles
from ui.layers import SOLID, Indices, Layer, Style

Floats = NDArray[np.float64]
MOST_POINTS = 40_000
"""More are thinned out evenly; the nets are made of all."""
_NET = Style(look.GREY, gloss=0.06, lift=1)
_POINTS = Style(look.INK, width=4.0, flat=True, lift=3)


def measured_layers(measurement: Measurement, tooth: int = ALL_TEETH) -> tuple[Layer, ...]:
    """The points of one tooth or all in the gear's own frame, coloured by deviation [µm]."""
    result = measurement.result
    chosen = np.flatnonzero((result.tooth == tooth) | (tooth == ALL_TEETH))
    own = result.pose.undo(result.points[chosen])
    error = result.deviation_um[chosen]
    every = max(1, len(chosen) // MOST_POINTS)
    few = chosen[::every]
    assigned = Assignment(result.side[few], result.tooth[few])
    outward = normals_at(measurement.member, own[::every], assigned)
    offset = 1e-3 * error[::every, None] * outward
    points = Layer(SOLID, "measured points", "points", own[::every], _POINTS, scalars=error[::every], offset=offset)
    return (*_net_layer(measurement, chosen, own, error), points)


def _net_layer(measurement: Measurement, chosen: NDArray[np.intp], own: Floats, error: Floats) -> tuple[Layer, ...]:
    """One surface of the nets of all flanks; none where the points of no flank make a net."""
    result = measurement.result
    group = 2 * result.tooth[chosen] + (result.side[chosen] > 0)
    order = np.argsort(group, kind="stable")
    starts = np.flatnonzero(np.diff(group[order], prepend=-1))
    parts = [_net(measurement, part, chosen[part], own, error) for part in np.split(order, starts[1:])]
    parts = [part for part in parts if len(part[1])]
    if not parts:
        return ()
    firsts = np.cumsum([0, *(len(part[0]) for part in parts)])
    cells = np.concatenate([part[1] + first for part, first in zip(parts, firsts, strict=False)])
    points, normals, scalars = (np.concatenate([part[k] for part in parts]) for k in (0, 2, 3))
    offset = 1e-3 * scalars[:, None] * normals
    return (Layer(SOLID, "measured nets", "surface", points, _NET, cells, normals, scalars, offset=offset),)


def _net(
    measurement: Measurement, part: NDArray[np.intp], index: NDArray[np.intp], own: Floats, error: Floats
) -> tuple[Floats, Indices, Floats, Floats]:
    """Nodes (n, 3), triangles (m, 3), normals (n, 3) and deviations (n,) of one flank of one tooth."""
    result = measurement.result
    face, profile = result.face_place[index], result.profile_place[index]
    columns = (*own[part].T, error[part])
    *places, mean = (cell_means(values, face, profile) for values in columns)
    nodes = np.stack(places, axis=-1)
    if min(mean.shape) < 2:
        return np.empty((0, 3)), np.empty((0, 3), dtype=np.int64), np.empty((0, 3)), np.empty(0)
    triangles, filled = grid_triangles(*mean.shape), np.isfinite(mean).ravel()
    nodes = np.where(filled[:, None], nodes.reshape(-1, 3), own[part[0]])
    assigned = Assignment(*(np.full(len(nodes), values[index[0]]) for values in (result.side, result.tooth)))
    normals = normals_at(measurement.member, nodes, assigned)
    return nodes, triangles[np.all(filled[triangles], axis=1)], normals, np.nan_to_num(mean.ravel())
