"""Rays against triangles; numpy alone.

Triangles lie in runs of neighbours, each run in a sphere; a ray is tested against the spheres first and then
against the triangles of the few it meets.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
_RUN = 96


@dataclass(frozen=True, eq=False)
class Meeting:
    """Where a ray meets triangles: distance along it, the corners' indices and their weights there."""

    distance: float
    corners: NDArray[np.int64]
    weights: Floats


class PickMesh:
    """Triangles of a surface, ready for rays."""

    def __init__(self, points: Floats, cells: NDArray[np.int64]) -> None:
        self._cells = cells
        corners = points[cells]
        self._origin = corners[:, 0]
        self._edge_1 = corners[:, 1] - self._origin
        self._edge_2 = corners[:, 2] - self._origin
        starts = np.arange(0, len(corners), _RUN)
        low = np.minimum.reduceat(corners.min(axis=1), starts)
        high = np.maximum.reduceat(corners.max(axis=1), starts)
        self._centre, self._reach = (low + high) / 2, np.linalg.norm(high - low, axis=-1) / 2

    def cast(self, start: Floats, direction: Floats) -> Meeting | None:
        """The first meeting of a ray with the surface, from either side; None when it misses."""
        offset = self._centre - start
        along = offset @ direction
        beside = np.einsum("ij,ij->i", offset, offset) - along**2
        runs = np.flatnonzero((beside <= self._reach**2) & (along > -self._reach))
        if not len(runs):
            return None
        index = (runs[:, None] * _RUN + np.arange(_RUN)).ravel()
        index = index[index < len(self._origin)]
        return self._nearest(index, start, direction)

    def _nearest(self, index: NDArray[np.int64], start: Floats, direction: Floats) -> Meeting | None:
        edge_1, edge_2 = self._edge_1[index], self._edge_2[index]
        across = np.cross(direction, edge_2)
        volume = np.einsum("ij,ij->i", edge_1, across)
        with np.errstate(all="ignore"):  # a triangle seen edge-on has no volume
            offset = start - self._origin[index]
            weight_1 = np.einsum("ij,ij->i", offset, across) / volume
            turned = np.cross(offset, edge_1)
            weight_2 = turned @ direction / volume
            distance = np.einsum("ij,ij->i", edge_2, turned) / volume
            least = np.minimum(np.minimum(weight_1, weight_2), 1 - weight_1 - weight_2)
        inside = (least >= -1e-9) & (distance > 0)
        if not np.any(inside):
            return None
        best = int(np.flatnonzero(inside)[np.argmin(distance[inside])])
        w1, w2, t = float(weight_1[best]), float(weight_2[best]), float(distance[best])
        weights = np.array([1 - w1 - w2, w1, w2])
        return Meeting(t, self._cells[index[best]], weights)
