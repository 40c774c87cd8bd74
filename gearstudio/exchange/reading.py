"""What is found in a file of solids or triangles, beside what should be there."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from gearstudio.checks import Box, FaceCheck, FileCheck
from gearstudio.exchange.meshes import MeshPart, mesh_box
from gearstudio.exchange.proof import FACE_POINTS, Wanted, check_faces, check_mesh
from gearstudio.kernel.boxes import corner_box
from gearstudio.kernel.cutting import compound
from gearstudio.kernel.document import Part, located
from gearstudio.kernel.exchange import Shape, faces_of, kernel_version, solids_of, verdict
from gearstudio.kernel.sampling import face_points
from gearstudio.results import Mesh

Floats = NDArray[np.float64]


def check_shape(shape: Shape, format_: str, made: Sequence[Part], wanted: Sequence[Wanted]) -> FileCheck:
    """Hold what a CAD file holds against the parts that were written to it, and its faces against theory."""
    solids = solids_of(shape)
    valid, closed, volume = verdict(shape)
    expected = sum(part.volume for part in made)
    boxes = [corner_box(located(part)) for part in made]
    found: list[FaceCheck] = []
    for solid in solids:
        own = corner_box(solid)
        part = wanted[int(np.argmin([np.abs(own - box).max() for box in boxes]))]
        found += check_faces([face_points(face, FACE_POINTS) for face in faces_of(solid)], part)
    box = corner_box(compound(solids)) if solids else np.zeros((2, 3))
    whole = corner_box(compound([located(part) for part in made]))
    return FileCheck(
        format=format_,
        valid=valid,
        closed=closed,
        solids=len(solids),
        faces=len(faces_of(shape)),
        volume=volume,
        volume_error=abs(volume - expected) / expected,
        box_error=float(np.abs(box - whole).max()) if solids else np.inf,
        wanted_solids=len(made),
        box=_corners(box),
        deviations=tuple(found),
        kernel=kernel_version(),
    )


def check_meshes(
    meshes: Sequence[Mesh], format_: str, made: Sequence[MeshPart], wanted: Sequence[Wanted], chord: float
) -> FileCheck:
    """Hold the meshes of a file against those that were written to it, and their corners against theory.

    Parameters
    ----------
    meshes : sequence of Mesh
    format_ : str
    made : sequence of MeshPart
    wanted : sequence of Wanted
    chord : float
        Farthest that triangles may lie from the surfaces [mm].
    """
    parts = [part.placed for part in made]
    expected, volume = sum(mesh.volume for mesh in parts), sum(mesh.volume for mesh in meshes)
    closed = bool(meshes) and all(mesh.is_closed for mesh in meshes)
    found: list[FaceCheck] = []
    far = [0.0]
    for mesh in meshes:
        own = mesh_box([mesh])
        part = wanted[int(np.argmin([np.abs(own - mesh_box([one])).max() for one in parts]))]
        faces, chord_um = check_mesh(mesh, part)
        found += faces
        far.append(chord_um)
    box = mesh_box(meshes) if meshes else np.zeros((2, 3))
    return FileCheck(
        format=format_,
        valid=closed,
        closed=closed,
        solids=len(meshes),
        faces=sum(len(mesh.triangles) for mesh in meshes),
        volume=volume,
        volume_error=abs(volume - expected) / expected,
        box_error=float(np.abs(box - mesh_box(parts)).max()) if meshes else np.inf,
        wanted_solids=len(made),
        box=_corners(box),
        deviations=tuple(found),
        chord_um=max(far),
        chord_limit_um=1e3 * chord + max(max(part.limits_um.values()) for part in wanted),
        kernel="GearStudio",
    )


def _corners(box: Floats) -> Box:
    (a, b, c), (d, e, f) = box.tolist()
    return (a, b, c), (d, e, f)
