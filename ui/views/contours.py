"""Lines of equal value on a coloured surface, straight within each triangle; numpy alone."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ui import layers as look
from ui.grids import path_segments
from ui.layers import Layer, Style

Floats = NDArray[np.float64]
_FLAT = 0.02
"""A surface whose values run over less of the step between two levels has no contours but noise."""
_LINE = Style(look.INK, width=1.1, lift=3)


def contour_layer(layer: Layer, levels: Sequence[float]) -> Layer:
    """The contours of a surface layer's scalars at some levels, switched with the surface."""
    segments = contour_segments(layer, levels)
    cells = path_segments((2,) * len(segments)) if len(segments) else np.empty((0, 2), dtype=np.int64)
    return Layer(layer.layer_id, f"{layer.part} contours", "lines", segments.reshape(-1, 3), _LINE, cells)


def contour_segments(layer: Layer, levels: Sequence[float]) -> Floats:
    """Ends of straight pieces, shape (n, 2, 3); where the scalars are NaN there are none."""
    if layer.scalars is None:
        return np.empty((0, 2, 3))
    values, corners = layer.scalars[layer.cells], layer.points[layer.cells]
    low, high = values.min(axis=1), values.max(axis=1)
    if len(levels) > 1 and np.nanmax(high, initial=-np.inf) - np.nanmin(low, initial=np.inf) < _FLAT * np.ptp(
        levels[:2]
    ):
        return np.empty((0, 2, 3))
    pieces = []
    for level in levels:
        crossed = (low < level) & (high >= level)  # NaN compares as False
        if np.any(crossed):
            pieces.append(_cut(values[crossed], corners[crossed], level))
    return np.concatenate(pieces) if pieces else np.empty((0, 2, 3))


def _cut(values: Floats, corners: Floats, level: float) -> Floats:
    """Where the level crosses triangles: two of the three edges of each, shape (n, 2, 3)."""
    after = np.roll(values, -1, axis=1)
    crossing = (values < level) != (after < level)
    with np.errstate(all="ignore"):
        share = (level - values) / (after - values)
        places = corners + share[..., None] * (np.roll(corners, -1, axis=1) - corners)
    return np.asarray(places[crossing].reshape(-1, 2, 3))
