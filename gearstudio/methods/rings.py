"""Points of a mesh by index, and the turned body of a gear as even circles zipped to its teeth."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.vectors import wrapped

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

SHARE = 0.4
"""Part of a tolerance that chords along one direction may take."""
TWIST_SHARE = 0.25
"""Part of it that a twisted cell's diagonal may take."""


class Points:
    """Collects points and hands out their indices."""

    def __init__(self) -> None:
        self._parts: list[Floats] = []
        self._count = 0

    def add(self, points: Floats) -> Ints:
        """Indices of new points (..., 3), shape (...)."""
        flat = points.reshape(-1, 3)
        indices = np.arange(self._count, self._count + len(flat), dtype=np.int64)
        self._parts.append(flat)
        self._count += len(flat)
        return indices.reshape(points.shape[:-1])

    def stacked(self) -> Floats:
        """All points so far, shape (n, 3)."""
        return np.concatenate(self._parts)


@dataclass
class Rings:
    """The turned body: even circles, zipped to the teeth at both ends."""

    member: MemberGeometry
    outline: Floats
    tolerance: float
    angle: float
    maker: Points
    ends: dict[int, Ints] = field(default_factory=dict)

    def circle(self, point: Floats) -> Ints:
        """Indices of an even circle through (radius, height); one index on the axis."""
        radius, height = point
        if radius < 1e-9:
            return self.maker.add(np.array([[0.0, 0.0, height]]))
        widest = float(self.outline[:, 0].max())
        count = max(int(np.ceil(2 * np.pi / self._step(widest))), 24)
        angles = 2 * np.pi * np.arange(count) / count
        x, y = radius * np.cos(angles), radius * np.sin(angles)
        return self.maker.add(np.stack([x, y, np.full_like(x, height)], axis=-1))

    def transition(self, loop: Ints, end: int) -> Ints:
        """From the lower side of the teeth at an end down to the body."""
        target = self.outline[0 if end else -1]
        points = self.maker.stacked()[loop]
        rows = [self.circle(point) for point in self._down(points[0], target)]
        self.ends[end] = rows[-1]
        made = [_zipped(self.maker.stacked(), loop, rows[0])]
        made += [_zipped(self.maker.stacked(), a, b) for a, b in pairwise(rows)]
        joined = np.concatenate(made)
        return joined if end else joined[:, ::-1]

    def _down(self, start: Floats, target: Floats) -> Floats:
        if self.member.ends != "sphere":
            return target[None, :]
        radius = float(np.hypot(*target))
        first, last = np.arctan2(np.hypot(start[0], start[1]), start[2]), np.arctan2(target[0], target[1])
        angles = np.linspace(first, last, max(int(np.ceil(abs(last - first) / self._step(radius))), 1) + 1)[1:]
        return np.stack([radius * np.sin(angles), radius * np.cos(angles)], axis=-1)

    def _step(self, radius: float) -> float:
        """Angle of a chord of a circle [rad]."""
        return min(2 * float(np.arccos(1 - min(SHARE * self.tolerance / radius, 0.5))), self.angle)

    def body(self) -> Ints:
        """Triangles of the turned body between the two ends."""
        rings = [self.ends[1], *(self.circle(point) for point in self.outline[1:-1]), self.ends[0]]
        points = self.maker.stacked()
        pairs = [pair for pair in pairwise(rings) if max(map(len, pair)) > 1]
        return np.concatenate([_zipped(points, a, b) for a, b in pairs])


def _zipped(points: Floats, upper: Ints, lower: Ints) -> Ints:
    """Triangles between two loops about the axis, both with growing azimuth, facing as e_delta x e_phi."""
    if len(upper) == 1 or len(lower) == 1:
        ring, apex, flip = (lower, upper[0], True) if len(upper) == 1 else (upper, lower[0], False)
        fan = np.stack([np.full_like(ring, apex), ring, np.roll(ring, -1)], axis=-1)
        return fan[:, ::-1] if flip else fan
    turns = []
    for loop in (upper, lower):
        azimuth = np.unwrap(np.arctan2(points[loop, 1], points[loop, 0]))
        turns.append(azimuth)
    shift = np.argmin(np.abs(wrapped(turns[1] - turns[0][0])))
    lower = np.roll(lower, -shift)
    turns[1] = np.unwrap(np.roll(turns[1], -shift))
    turns[1] += 2 * np.pi * np.round((turns[0][0] - turns[1][0]) / (2 * np.pi))
    n, m = len(upper), len(lower)
    a, b = np.r_[turns[0], turns[0][0] + 2 * np.pi], np.r_[turns[1], turns[1][0] + 2 * np.pi]
    middles = np.r_[(a[:-1] + a[1:]) / 2, (b[:-1] + b[1:]) / 2]
    on_lower = (np.arange(n + m) >= n)[np.argsort(middles, kind="stable")]
    i, j = np.r_[0, np.cumsum(~on_lower)][:-1], np.r_[0, np.cumsum(on_lower)][:-1]
    third = np.where(on_lower, lower[(j + 1) % m], upper[(i + 1) % n])
    return np.stack([lower[j % m], upper[i % n], third], axis=-1)
