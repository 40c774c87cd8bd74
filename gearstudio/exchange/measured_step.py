"""Points to measure from a STEP file that any program wrote."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from gearstudio.analysis.measurement import MeasuredPoints
from gearstudio.analysis.measurement_faces import choose_faces, outward
from gearstudio.errors import FileError, GeometryError
from gearstudio.kernel.sampling import counts_for, read_faces, sample_face
from gearstudio.theory.cones import PairGeometry

_COARSE = (6, 6)
_POINTS_PER_FACE_WIDTH = 20
_FINEST_SPACING = 1e-3
_READ, _CHOSEN = 0.35, 0.6


@dataclass(frozen=True)
class SampledModel:
    """Points of a model's flanks.

    Attributes
    ----------
    points : MeasuredPoints
        With normals out of the metal.
    shift : float
        About where the apex lies on the axis [mm].
    flank_faces, faces : int
        Faces that were taken, and all of them.
    """

    points: MeasuredPoints
    shift: float
    flank_faces: int
    faces: int


def sample_step(
    path: Path,
    pair: PairGeometry,
    member_name: str,
    spacing: float | None = None,
    report: Callable[[str, float], None] | None = None,
) -> SampledModel:
    """Read a STEP file, choose the faces that are a member's flanks, and take points of them.

    Parameters
    ----------
    path : Path
    pair : PairGeometry
    member_name : {"pinion", "wheel"}
    spacing : float, optional
        About how far apart the points are [mm]; by default a twentieth of the face width.
    report : callable, optional
        Told the stage and the part done.

    Raises
    ------
    FileError
        Not a STEP file, one without faces, or none of them a flank of this member, with the reason.
    """
    told = report or (lambda stage, fraction: None)
    member = pair.member(member_name)
    apart = spacing or member.face_width / _POINTS_PER_FACE_WIDTH
    if apart < _FINEST_SPACING * member.face_width:
        raise GeometryError(
            f"points {apart:.3g} mm apart are too many; use {_FINEST_SPACING * member.face_width:.3g} mm or more"
        )
    told("reading", 0.0)
    faces = read_faces(path)
    told("choosing faces", _READ)
    coarse = []
    for number, face in enumerate(faces):
        coarse.append(sample_face(face, _COARSE))
        told("choosing faces", _READ + (_CHOSEN - _READ) / 2 * number / len(faces))
    try:
        chosen = choose_faces(pair, member, coarse)
    except GeometryError as error:
        raise FileError(path, str(error)) from error
    parts = []
    for number, index in enumerate(chosen.indices):
        told("taking points", _CHOSEN + (1 - _CHOSEN) * number / len(chosen.indices))
        found = sample_face(faces[index], counts_for(faces[index], apart))
        parts.append(outward(member, found, chosen.shift))
    points, normals = (np.concatenate([getattr(part, name) for part in parts]) for name in ("points", "normals"))
    return SampledModel(MeasuredPoints(points, normals), chosen.shift, len(chosen.indices), len(faces))
