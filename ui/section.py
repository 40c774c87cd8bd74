"""Where a plane cuts meshes: the outline it leaves and the filled face between the outlines; numpy alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ui.meshes import EMPTY, Mesh

Floats = NDArray[np.float64]
_ROWS_APART = 1e-9


@dataclass(frozen=True)
class Plane:
    """A cutting plane square to an axis: what lies beyond it is taken away.

    Attributes
    ----------
    axis : {0, 1, 2}
        x, y or z.
    place : float
        Coordinate of the plane [mm].
    sign : {+1, -1}
        Side that is taken away.
    """

    axis: int
    place: float
    sign: int = 1

    @property
    def normal(self) -> Floats:
        """Unit vector to the side that is taken away."""
        return self.sign * np.eye(3)[self.axis]

    @property
    def point(self) -> Floats:
        """A point of the plane [mm]."""
        return self.place * np.eye(3)[self.axis]

    def beyond(self, points: Floats) -> Floats:
        """Signed distance into the side that is taken away, shape (...)."""
        return self.sign * (points[..., self.axis] - self.place)


def outline(meshes: Sequence[Mesh], plane: Plane) -> Floats:
    """Segments in which a plane cuts triangles, shape (n, 2, 3)."""
    found = [_cut(mesh, plane) for mesh in meshes]
    return np.concatenate(found) if found else np.empty((0, 2, 3))


def _cut(mesh: Mesh, plane: Plane) -> Floats:
    distance = plane.beyond(mesh.points)
    distance[distance == 0] = 1e-12 * max(float(np.abs(distance).max(initial=0.0)), 1e-12)
    over = distance[mesh.cells] > 0
    count = over.sum(axis=1)
    cells = mesh.cells[(count == 1) | (count == 2)]
    if not len(cells):
        return np.empty((0, 2, 3))
    over = distance[cells] > 0
    lone = np.where(over.sum(axis=1) == 1, np.argmax(over, axis=1), np.argmin(over, axis=1))
    row = np.arange(len(cells))
    apex = cells[row, lone]
    ends = []
    for step in (1, 2):
        other = cells[row, (lone + step) % 3]
        share = distance[apex] / (distance[apex] - distance[other])
        ends.append(mesh.points[apex] + share[:, None] * (mesh.points[other] - mesh.points[apex]))
    return np.stack(ends, axis=1)


def filled(segments: Floats, plane: Plane) -> Mesh:
    """The metal in the plane: what lies between an odd and an even crossing of closed outlines.

    Trapezoids between the heights of neighbouring corners, so that the face is exact and no outline need be
    followed; a small gap in an outline costs one strip.
    """
    u, v = (i for i in range(3) if i != plane.axis)
    low, high = segments[:, 0][:, [u, v]], segments[:, 1][:, [u, v]]
    swap = low[:, 1] > high[:, 1]
    low, high = np.where(swap[:, None], high, low), np.where(swap[:, None], low, high)
    if not len(low):
        return EMPTY
    size = float(np.ptp(np.concatenate([low, high]), axis=0).max())
    heights = np.unique(np.round(np.concatenate([low[:, 1], high[:, 1]]) / (_ROWS_APART * size))) * _ROWS_APART * size
    first = np.searchsorted(heights, low[:, 1] - 0.5 * _ROWS_APART * size)
    last = np.searchsorted(heights, high[:, 1] - 0.5 * _ROWS_APART * size)
    spans = np.maximum(last - first, 0)
    index = np.repeat(np.arange(len(low)), spans)
    strip = first[index] + np.arange(len(index)) - np.repeat(np.cumsum(spans) - spans, spans)
    bottom, top = (_at_height(low[index], high[index], heights[strip + step]) for step in (0, 1))
    order = np.lexsort((bottom + top, strip))
    strip, bottom, top = strip[order], bottom[order], top[order]
    start = np.searchsorted(strip, strip)
    odd = (np.arange(len(strip)) - start) % 2 == 1
    right = np.flatnonzero(odd)
    corners = [
        (bottom[right - 1], heights[strip[right]]),
        (bottom[right], heights[strip[right]]),
        (top[right], heights[strip[right] + 1]),
        (top[right - 1], heights[strip[right] + 1]),
    ]
    return _quadrilaterals(corners, plane, (u, v))


def _at_height(low: Floats, high: Floats, height: Floats) -> Floats:
    rise = high[:, 1] - low[:, 1]
    share = np.clip((height - low[:, 1]) / np.where(rise > 0, rise, 1.0), 0.0, 1.0)
    return np.asarray(low[:, 0] + share * (high[:, 0] - low[:, 0]))


def _quadrilaterals(corners: list[tuple[Floats, Floats]], plane: Plane, axes: tuple[int, int]) -> Mesh:
    count = len(corners[0][0])
    points = np.full((count, 4, 3), plane.place)
    for place, (across, up) in enumerate(corners):
        points[:, place, axes[0]], points[:, place, axes[1]] = across, up
    first = 4 * np.arange(count)[:, None, None]
    cells = (first + np.array([[0, 1, 2], [0, 2, 3]])).reshape(-1, 3)
    points = points.reshape(-1, 3)
    return Mesh(points, np.broadcast_to(plane.normal, points.shape).copy(), cells)
