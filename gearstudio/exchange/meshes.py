"""Triangles as files, STL, 3MF and GLB, and their reading back; numpy and the standard library alone."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from gearstudio.errors import FileError
from gearstudio.exchange import glb, stl, threemf
from gearstudio.formats import ExportOptions
from gearstudio.results import Mesh
from gearstudio.theory.place import Place

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class MeshPart:
    """A closed mesh to hand on: its name, and where it stands."""

    name: str
    mesh: Mesh
    place: Place

    @property
    def placed(self) -> Mesh:
        """The mesh where it stands."""
        return Mesh(self.place.of(self.mesh.points), self.mesh.groups)


Writer = Callable[[Path, Sequence[MeshPart], ExportOptions], None]
_WRITERS: dict[str, Writer] = {
    "stl": lambda path, parts, options: stl.write(path, [part.placed for part in parts], options.stl_encoding),
    "3mf": lambda path, parts, options: threemf.write(path, [(p.name, p.mesh, p.place) for p in parts], options),
    "glb": lambda path, parts, options: glb.write(path, [(p.name, p.mesh, p.place) for p in parts], options),
}
_READERS: dict[str, Callable[[Path], list[Mesh]]] = {"stl": stl.read, "3mf": threemf.read, "glb": glb.read}


def write_meshes(path: Path, parts: Sequence[MeshPart], format_: str, options: ExportOptions) -> None:
    """Write meshes in place; OSError when the file cannot be written."""
    _WRITERS[format_](path, parts, options)


def read_meshes(path: Path, format_: str, counts: Sequence[int] = ()) -> list[Mesh]:
    """The placed meshes of a file [mm].

    Parameters
    ----------
    path : Path
    format_ : {"stl", "3mf", "glb"}
    counts : sequence of int
        Triangles of each part; STL does not say where one ends, and is divided there when the sum is right.

    Raises
    ------
    FileError
        It is cut off, damaged, or of another format.
    """
    try:
        meshes = _READERS[format_](path)
    except (ValueError, KeyError, IndexError, TypeError) as error:
        raise FileError(path, f"this is no complete {format_.upper()} file; it may be cut off or damaged") from error
    if len(meshes) == 1 and len(counts) > 1 and sum(counts) == len(meshes[0].triangles):
        ends = np.cumsum(counts)[:-1]
        return [_without_loose_points(meshes[0].points, part) for part in np.split(meshes[0].triangles, ends)]
    return meshes


def mesh_box(meshes: Sequence[Mesh]) -> Floats:
    """Least and greatest coordinates [mm], shape (2, 3)."""
    points = np.concatenate([mesh.points for mesh in meshes])
    return np.stack([points.min(axis=0), points.max(axis=0)])


def _without_loose_points(points: Floats, triangles: NDArray[np.int64]) -> Mesh:
    used, index = np.unique(triangles, return_inverse=True)
    return Mesh(points[used], {"all": index.reshape(-1, 3)})
