"""Measured points brought to a net over the flank; numpy alone."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
CELLS = (7, 13)
"""Points that lie on no grid are drawn as means over so many cells along the profile and the face."""
MOST_LINES, LINE_GAP = 32, 0.02


def cell_means(values: Floats, face: Floats, profile: Floats) -> Floats:
    """Means over the nodes of the measured grid, or over cells where there is none; NaN where nothing is, (n, m)."""
    row, rows = _ranks(profile, CELLS[0])
    column, columns = _ranks(face, CELLS[1])
    cell, size = row * columns + column, rows * columns
    count = np.bincount(cell, minlength=size)
    with np.errstate(invalid="ignore"):
        return (np.bincount(cell, weights=values, minlength=size) / count).reshape(rows, columns)


def _ranks(places: Floats, cells: int) -> tuple[NDArray[np.int_], int]:
    """Which line of a measured grid each place is on, and how many there are; even cells where there are no lines."""
    if not places.size:
        return np.zeros(0, dtype=int), 1
    order = np.sort(places)
    ends = np.concatenate([[-np.inf], (order[:-1] + order[1:])[np.diff(order) > LINE_GAP] / 2])
    line = np.searchsorted(ends, places) - 1
    if len(ends) <= MOST_LINES and max(np.ptp(places[line == one]) for one in range(len(ends))) <= LINE_GAP:
        return line, len(ends)
    return np.clip(places * cells, 0, cells - 1).astype(int), cells
