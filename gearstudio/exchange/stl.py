"""Binary STL [mm]."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from gearstudio.results import Mesh

_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("unused", "<u2")])
_HEADER = 80


def write(path: Path, meshes: Sequence[Mesh]) -> None:
    """All meshes as one list of triangles."""
    corners = np.concatenate([mesh.points[mesh.triangles] for mesh in meshes])
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    records = np.zeros(len(corners), _RECORD)
    records["normal"], records["corners"] = normal / np.where(length > 0, length, 1.0), corners
    with open(path, "wb") as file:
        file.write(b"GearStudio, millimetres".ljust(_HEADER))
        file.write(np.uint32(len(corners)).tobytes())
        file.write(records.tobytes())


def read(path: Path) -> list[Mesh]:
    """One mesh; corners at the same place become one point. ValueError when the file is cut off."""
    content = path.read_bytes()
    count = int(np.frombuffer(content, "<u4", 1, _HEADER)[0])
    records = np.frombuffer(content, _RECORD, count, _HEADER + 4)
    points, index = np.unique(records["corners"].reshape(-1, 3), axis=0, return_inverse=True)
    return [Mesh(points.astype(np.float64), {"all": index.reshape(-1, 3)})]
