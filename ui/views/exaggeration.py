"""Flanks drawn with their deviation so many times as large, along the normal; numpy alone."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from gearstudio.results import VariantResult
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.modified import flank_of
from ui.grids import grid_normals
from ui.layers import Layer
from ui.scene import border_of
from ui.views.factors import AUTOMATIC, OFF

Floats = NDArray[np.float64]

MOST = 10**8
SHARE = 0.12
"""Of the size of what is shown that the largest deviation takes by an automatic factor."""
_SURFACES = frozenset({"deviation", "cad_flank"})


def suitable(size: float, largest_um: float) -> int:
    """The round factor, 1, 2 or 5 times a power of ten, by which a deviation [µm] is a fair share of a size [mm]."""
    wanted = min(SHARE * size * 1e3 / max(largest_um, 1e-12), MOST)
    if wanted < 2:
        return OFF
    power = 10 ** math.floor(math.log10(wanted))
    return int(max(step for step in (1, 2, 5) if step * power <= wanted * (1 + 1e-9)) * power)


def factor_for(wanted: int, results: Iterable[VariantResult]) -> int:
    """The factor chosen, or the one that suits all of these together."""
    results = tuple(results)
    if wanted != AUTOMATIC or not results:
        return wanted or OFF
    grids = [flank.points for result in results for flank in result.flanks.values()]
    height = min(float(np.linalg.norm(grid[-1, grid.shape[1] // 2] - grid[0, grid.shape[1] // 2])) for grid in grids)
    return suitable(height, max(result.statistics.max_um for result in results))


def displaced(layers: Sequence[Layer], result: VariantResult, member: MemberGeometry, factor: int) -> tuple[Layer, ...]:
    """The layers of a result with its flanks, and their borders, displaced."""
    if factor == OFF:
        return tuple(layers)
    grids = {name: _grid(result, name, member, factor) for name in result.flanks}
    made = []
    for layer in layers:
        name = layer.part.removesuffix(" edge")
        if layer.layer_id not in _SURFACES or name not in grids:
            made.append(layer)
        elif layer.kind == "surface":
            normals = grid_normals(grids[name]).reshape(-1, 3)
            points = grids[name].reshape(-1, 3)
            made.append(replace(layer, points=points, normals=normals, true_points=layer.points))
        else:
            made.append(replace(layer, points=border_of(grids[name])))
    return tuple(made)


def _grid(result: VariantResult, name: str, member: MemberGeometry, factor: int) -> Floats:
    """The points of a flank (n_u, n_v, 3), moved out of the metal by what the deviation is to grow [mm]."""
    flank = result.flanks[name]
    normals = grid_normals(flank.points)
    outward = flank_of(member, "concave" if name == "concave" else "convex").normals(0.5, 0.5)
    if float(np.sum(normals.mean(axis=(0, 1)) * outward)) < 0:
        normals = -normals
    more = 1e-3 * (factor - 1) * np.asarray(flank.deviation_um, dtype=np.float64)
    return np.asarray(flank.points + more[..., None] * normals)


def stretched(layers: Sequence[Layer], factor: int) -> tuple[Layer, ...]:
    """Layers that know how far their points are off, with that so many times as large."""
    return tuple(
        layer
        if layer.offset is None or factor == OFF
        else replace(layer, points=layer.points + (factor - 1) * layer.offset, true_points=layer.points)
        for layer in layers
    )
