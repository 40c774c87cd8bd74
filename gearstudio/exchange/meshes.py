"""Triangles as files, STL, 3MF and GLB, and their reading back; numpy and the standard library alone."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from gearstudio.errors import FileError
from gearstudio.exchange import glb, stl, threemf
from gearstudio.results import FileCheck, Mesh

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class MeshPart:
    """A closed mesh to hand on: its name, and the rotation (3, 3) about the common apex that places it."""

    name: str
    mesh: Mesh
    placement: Floats


_WRITERS: dict[str, Callable[[Path, Sequence[MeshPart]], None]] = {
    "stl": lambda path, parts: stl.write(path, [placed_mesh(part) for part in parts]),
    "3mf": lambda path, parts: threemf.write(path, [(part.name, part.mesh, part.placement) for part in parts]),
    "glb": lambda path, parts: glb.write(path, [(part.name, part.mesh, part.placement) for part in parts]),
}
_READERS: dict[str, Callable[[Path], list[Mesh]]] = {"stl": stl.read, "3mf": threemf.read, "glb": glb.read}
MESH_FORMATS = tuple(_WRITERS)


def write_meshes(path: Path, parts: Sequence[MeshPart], format_: str) -> FileCheck:
    """Write meshes and read the file back.

    Raises
    ------
    FileError
        What is read is not what was written.
    OSError
        The file cannot be written.
    """
    _WRITERS[format_](path, parts)
    try:
        meshes = _READERS[format_](path)
    except (ValueError, KeyError, IndexError) as error:
        raise FileError(path, "the file is not complete after writing; the disk may be full") from error
    wanted = [placed_mesh(part) for part in parts]
    expected, volume = sum(mesh.volume for mesh in wanted), sum(mesh.volume for mesh in meshes)
    closed = bool(meshes) and all(mesh.is_closed for mesh in meshes)
    check = FileCheck(
        format=format_,
        valid=closed,
        closed=closed,
        solids=len(parts) if format_ == "stl" else len(meshes),
        faces=sum(len(mesh.triangles) for mesh in meshes),
        volume=volume,
        volume_error=abs(volume - expected) / expected,
        box_error=float(np.abs(_box(meshes) - _box(wanted)).max()) if meshes else np.inf,
    )
    check.require(path, len(parts))
    return check


def placed_mesh(part: MeshPart) -> Mesh:
    """The mesh where it stands."""
    return Mesh(part.mesh.points @ part.placement.T, part.mesh.groups)


def _box(meshes: Sequence[Mesh]) -> Floats:
    points = np.concatenate([mesh.points for mesh in meshes])
    return np.stack([points.min(axis=0), points.max(axis=0)])
