"""What is under the pointer: rays against the triangles that are drawn; numpy alone.

The renderer is not asked. Triangles lie in runs of neighbours, each run in a sphere; a ray is tested against the
spheres first and then against the triangles of the few it meets.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ui.layers import Layer

Floats = NDArray[np.float64]
_RUN = 96


@dataclass(frozen=True)
class Hover:
    """A point of a flank under the pointer, in what a person reads: mm, degrees, µm; ``value`` is what colours it."""

    panel_key: str
    flank: str
    xyz: tuple[float, float, float]
    rho: float
    delta_deg: float
    deviation_um: float | None
    value: float | None = None


@dataclass(frozen=True, eq=False)
class Hit:
    """Where a ray meets a surface: distance along it, the corners' indices and their weights there."""

    layer: Layer
    distance: float
    point: Floats
    corners: NDArray[np.int64]
    weights: Floats

    @property
    def scalar(self) -> float | None:
        """The layer's scalar there, linear over the triangle; None where there is none."""
        return self._at(self.layer.scalars)

    @property
    def deviation(self) -> float | None:
        """The deviation there [µm], whatever the colours show."""
        return self.scalar if self.layer.deviation is None else self._at(self.layer.deviation)

    def _at(self, values: Floats | None) -> float | None:
        if values is None:
            return None
        value = float(self.weights @ values[self.corners])
        return value if np.isfinite(value) else None


class PickMesh:
    """Triangles of one surface layer, ready for rays."""

    def __init__(self, layer: Layer) -> None:
        self.layer = layer
        corners = layer.points[layer.cells]
        self._origin = corners[:, 0]
        self._edge_1 = corners[:, 1] - self._origin
        self._edge_2 = corners[:, 2] - self._origin
        starts = np.arange(0, len(corners), _RUN)
        low = np.minimum.reduceat(corners.min(axis=1), starts)
        high = np.maximum.reduceat(corners.max(axis=1), starts)
        self._centre, self._reach = (low + high) / 2, np.linalg.norm(high - low, axis=-1) / 2

    def cast(self, start: Floats, direction: Floats) -> Hit | None:
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

    def _nearest(self, index: NDArray[np.int64], start: Floats, direction: Floats) -> Hit | None:
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
        return Hit(self.layer, t, start + t * direction, self.layer.cells[index[best]], weights)


class Picker:
    """Rays against a changing set of layers; what was prepared for a layer is kept as long as it is shown."""

    def __init__(self) -> None:
        self._meshes: dict[int, PickMesh] = {}

    def keep(self, layers: tuple[Layer, ...]) -> None:
        """Forget every layer but these."""
        alive = {id(layer) for layer in layers}
        self._meshes = {key: mesh for key, mesh in self._meshes.items() if key in alive}

    def first(self, layers: tuple[Layer, ...], start: Floats, direction: Floats) -> Hit | None:
        """The nearest meeting of a ray with any of the surfaces."""
        hits = (self._mesh(layer).cast(start, direction) for layer in layers)
        return min((hit for hit in hits if hit is not None), key=lambda hit: hit.distance, default=None)

    def _mesh(self, layer: Layer) -> PickMesh:
        if id(layer) not in self._meshes:
            self._meshes[id(layer)] = PickMesh(layer)
        return self._meshes[id(layer)]


def describe(hit: Hit, panel_key: str) -> Hover:
    """What a hit tells the user."""
    x, y, z = (float(c) for c in hit.point)
    rho, delta = float(np.linalg.norm(hit.point)), float(np.degrees(np.arctan2(np.hypot(x, y), z)))
    return Hover(panel_key, hit.layer.part, (x, y, z), rho, delta, hit.deviation, hit.scalar)
