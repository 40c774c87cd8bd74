"""From numbers to the colours of a map; NaN is left clear."""

from __future__ import annotations

import numpy as np
import pyqtgraph as pg
from numpy.typing import NDArray

from ui import colormap

Floats = NDArray[np.float64]
Bytes = NDArray[np.uint8]


def sequential(values: Floats, low: float, high: float) -> Bytes:
    """From dark blue (low) to yellow (high), RGBA, shape (..., 4)."""
    return _looked_up(pg.colormap.get("viridis").getLookupTable(nPts=256), (values - low) / (high - low or 1.0))


def diverging(values: Floats, limit: float) -> Bytes:
    """The colours of deviations, from blue (-limit) over grey to vermillion, RGBA, shape (..., 4)."""
    return _looked_up(colormap.table(), 0.5 + values / (2 * limit or 1.0))


def _looked_up(table: Bytes, places: Floats) -> Bytes:
    clear = np.isnan(places)
    index = np.rint(np.clip(np.where(clear, 0.0, places), 0, 1) * (len(table) - 1)).astype(int)
    return np.concatenate([table[index][..., :3], np.where(clear, 0, 255)[..., None]], axis=-1).astype(np.uint8)
