"""Where a body stands: a rotation and a shift."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Place:
    """Takes a body's own points to the world.

    Attributes
    ----------
    matrix : ndarray, shape (3, 3)
        Rotation.
    shift : ndarray, shape (3,)
        Where the body's origin stands [mm].
    """

    matrix: Floats = field(default_factory=lambda: np.eye(3))
    shift: Floats = field(default_factory=lambda: np.zeros(3))

    def of(self, points: Floats) -> Floats:
        """Own points (..., 3) in the world."""
        return np.asarray(points @ self.matrix.T + self.shift)

    def back(self, points: Floats) -> Floats:
        """Points (..., 3) of the world in the body's own frame."""
        return np.asarray((points - self.shift) @ self.matrix)

    def after(self, first: Place) -> Place:
        """The place that comes of ``first`` and then this one."""
        return Place(self.matrix @ first.matrix, self.of(first.shift))

    @property
    def inverse(self) -> Place:
        """Takes points of the world back."""
        return Place(self.matrix.T, -self.matrix.T @ self.shift)
