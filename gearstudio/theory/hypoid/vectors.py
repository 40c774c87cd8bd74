"""Small tools for arrays of vectors, shape (..., 3)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def cross(a: Floats, b: Floats) -> Floats:
    """a x b; several times faster on long arrays than numpy's own."""
    ax, ay, az = a[..., 0], a[..., 1], a[..., 2]
    bx, by, bz = b[..., 0], b[..., 1], b[..., 2]
    return np.stack([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx], axis=-1)


def dot(a: Floats, b: Floats) -> Floats:
    """a . b, shape (...)."""
    return np.asarray(a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1] + a[..., 2] * b[..., 2])


def turned(vectors: Floats, angle: Floats) -> Floats:
    """Vectors turned about z by an angle each."""
    c, s = np.cos(angle), np.sin(angle)
    x, y = vectors[..., 0], vectors[..., 1]
    return np.stack([c * x - s * y, s * x + c * y, np.broadcast_to(vectors[..., 2], (c * x).shape)], axis=-1)


def quarter(vectors: Floats) -> Floats:
    """z x vectors."""
    return np.stack([-vectors[..., 1], vectors[..., 0], np.zeros_like(vectors[..., 0])], axis=-1)


def unit(vectors: Floats) -> Floats:
    """Vectors of length one."""
    return np.asarray(vectors / np.sqrt(dot(vectors, vectors))[..., None])
