"""Triangle meshes of gears: joining, copying round the axis, stitching two loops; numpy alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.place import Place
from ui.grids import turned

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Mesh:
    """Points (n, 3), unit normals (n, 3) and triangles (m, 3) that turn as the normals say."""

    points: Floats
    normals: Floats
    cells: Indices

    @property
    def enclosed(self) -> float:
        """Volume by the divergence theorem; of a closed mesh what it encloses, of a part its share [mm^3]."""
        a, b, c = np.moveaxis(self.points[self.cells], 1, 0)
        return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


EMPTY = Mesh(np.empty((0, 3)), np.empty((0, 3)), np.empty((0, 3), dtype=np.int64))


def joined(meshes: Sequence[Mesh]) -> Mesh:
    """Several meshes as one."""
    if not meshes:
        return EMPTY
    starts = np.cumsum([0, *(len(mesh.points) for mesh in meshes[:-1])])
    return Mesh(
        np.concatenate([mesh.points for mesh in meshes]),
        np.concatenate([mesh.normals for mesh in meshes]),
        np.concatenate([mesh.cells + start for mesh, start in zip(meshes, starts, strict=True)]),
    )


def copies(mesh: Mesh, azimuths: Floats) -> Mesh:
    """A mesh turned about z by each azimuth, as one."""
    cells = copied_cells(mesh.cells, len(mesh.points), len(azimuths))
    points, normals = turned(mesh.points, azimuths), turned(mesh.normals, azimuths)
    return Mesh(points.reshape(-1, 3), normals.reshape(-1, 3), cells)


def copied_cells(cells: Indices, point_count: int, times: int) -> Indices:
    """Cells of so many copies of the points, one after another."""
    return np.asarray((cells[None] + point_count * np.arange(times)[:, None, None]).reshape(-1, cells.shape[1]))


def placed(mesh: Mesh, place: Place) -> Mesh:
    """A mesh moved to a place."""
    return Mesh(place.of(mesh.points), mesh.normals @ place.matrix.T, mesh.cells)


def turned_to(mesh: Mesh) -> Mesh:
    """The mesh with all triangles turned so that most agree with the normals; without those that have no area.

    Where a loop runs back on itself a few triangles lie over others the other way round, and belong so.
    """
    a, b, c = np.moveaxis(mesh.points[mesh.cells], 1, 0)
    areas = np.cross(b - a, c - a)
    size = np.linalg.norm(areas, axis=-1)
    good = size > 1e-14 * max(float(size.max(initial=0.0)), np.finfo(float).tiny)
    agreement = float(np.einsum("ij,ij->", areas, mesh.normals[mesh.cells[:, 0]]))
    cells = mesh.cells if agreement >= 0 else mesh.cells[:, ::-1]
    return Mesh(mesh.points, mesh.normals, np.ascontiguousarray(cells[good]))


def stitched(azimuths: Floats, others: Floats) -> Indices:
    """Triangles between two closed loops round the axis, numbered one loop after the other, shape (n + m, 3).

    Both lists grow over less than a full turn; the loops close by themselves.
    """
    n, m = len(azimuths), len(others)
    start = int(np.argmin(np.abs(np.angle(np.exp(1j * (others - azimuths[0]))))))
    there = np.unwrap(np.roll(others, -start))
    there = there + 2 * np.pi * np.round((azimuths[0] - there[0]) / (2 * np.pi))
    ends = np.maximum.accumulate(np.append(azimuths[1:], azimuths[0] + 2 * np.pi))
    other_ends = np.maximum.accumulate(np.append(there[1:], there[0] + 2 * np.pi))
    i, j = np.arange(n), np.arange(m)
    reached = np.searchsorted(other_ends, ends, side="right")
    reached_here = np.searchsorted(ends, other_ends, side="left")

    def other(index: Indices) -> Indices:
        return n + (index + start) % m

    one = np.stack([i, (i + 1) % n, other(reached)], axis=-1)
    two = np.stack([other(j), reached_here % n, other(j + 1)], axis=-1)
    return np.concatenate([one, two])
