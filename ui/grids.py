"""Triangles, normals and segments of point grids: the small geometry behind the layers; numpy alone."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]


@lru_cache(maxsize=64)
def grid_triangles(rows: int, cols: int, flipped: bool = False) -> Indices:
    """Triangles of a (rows, cols) grid numbered row by row, shape (2 (rows-1) (cols-1), 3); read-only.

    They turn from u to v, as the normals of `grid_normals` do, or the other way when flipped.
    """
    first = (np.arange(rows - 1)[:, None] * cols + np.arange(cols - 1)).ravel()
    lower = np.stack([first, first + cols, first + 1], axis=-1)
    upper = np.stack([first + 1, first + cols, first + cols + 1], axis=-1)
    made = np.stack([lower, upper], axis=1).reshape(-1, 3)
    return _sealed(made[:, ::-1].copy() if flipped else made)


def facing(grid: Floats, normals: Floats) -> Indices:
    """Triangles of a grid, turning as its given normals say."""
    agree = np.sum(grid_normals(grid) * normals)
    return grid_triangles(*grid.shape[:2], bool(agree < 0))


@lru_cache(maxsize=64)
def path_segments(lengths: tuple[int, ...]) -> Indices:
    """Segments of several polylines stored one after another, shape (sum(n - 1), 2); read-only."""
    starts = np.cumsum((0, *lengths[:-1]))
    parts = [np.arange(n - 1) + start for n, start in zip(lengths, starts, strict=True)]
    first = np.concatenate(parts) if parts else np.empty(0, dtype=np.int64)
    return _sealed(np.stack([first, first + 1], axis=-1).astype(np.int64))


@lru_cache(maxsize=64)
def grid_segments(rows: int, cols: int, every_row: int, every_col: int) -> Indices:
    """Segments along every n-th row and column of a grid, the last ones included, shape (m, 2); read-only."""
    index = np.arange(rows * cols).reshape(rows, cols)
    along_rows = index[_stride(rows, every_row)]
    along_cols = index[:, _stride(cols, every_col)]
    return _sealed(
        np.concatenate(
            [
                np.stack([along_rows[:, :-1].ravel(), along_rows[:, 1:].ravel()], axis=-1),
                np.stack([along_cols[:-1].ravel(), along_cols[1:].ravel()], axis=-1),
            ]
        )
    )


def grid_normals(grid: Floats) -> Floats:
    """Unit normals of a grid by differences, shape (n_u, n_v, 3); where it degenerates, those of a neighbour.

    They are smooth over the grid and one-sided at its edges, so that neighbouring patches meet in a crisp edge.
    """
    along_u, along_v = np.gradient(grid, axis=0), np.gradient(grid, axis=1)
    normals = np.cross(along_u, along_v)
    length = np.linalg.norm(normals, axis=-1, keepdims=True)
    size = np.linalg.norm(along_u, axis=-1, keepdims=True) * np.linalg.norm(along_v, axis=-1, keepdims=True)
    good = length > 1e-9 * np.maximum(size, np.finfo(float).tiny)
    unit = np.divide(normals, length, out=np.zeros_like(normals), where=good)
    if not np.all(good):
        fallback = unit.sum(axis=(0, 1))
        norm = np.linalg.norm(fallback)
        unit = np.where(good, unit, fallback / norm if norm > 0 else np.array([0.0, 0.0, 1.0]))
    return np.asarray(unit)


def turned(vectors: Floats, azimuths: Floats) -> Floats:
    """Copies of vectors (n, 3) turned about z by each azimuth, shape (len(azimuths), n, 3)."""
    cos, sin = np.cos(azimuths)[:, None], np.sin(azimuths)[:, None]
    x, y, z = vectors[:, 0], vectors[:, 1], vectors[:, 2]
    out = np.empty((len(azimuths), len(vectors), 3))
    out[..., 0], out[..., 1], out[..., 2] = cos * x - sin * y, sin * x + cos * y, z
    return out


def _stride(count: int, every: int) -> Indices:
    return np.unique(np.append(np.arange(0, count, every), count - 1))


def _sealed(array: Indices) -> Indices:
    array.setflags(write=False)
    return array
