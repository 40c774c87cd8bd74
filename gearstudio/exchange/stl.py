"""STL, binary or text [mm]."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from gearstudio.results import Mesh

_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("unused", "<u2")])
_HEADER = 80
_FACET = (
    "facet normal {:.6g} {:.6g} {:.6g}\nouter loop\nvertex {:.9g} {:.9g} {:.9g}\nvertex {:.9g} {:.9g} {:.9g}\n"
    "vertex {:.9g} {:.9g} {:.9g}\nendloop\nendfacet\n"
)
_WORDS = 21
_CORNERS = [8, 9, 10, 12, 13, 14, 16, 17, 18]


def write(path: Path, meshes: Sequence[Mesh], encoding: str = "binary") -> None:
    """All meshes as one list of triangles, one mesh after another."""
    corners = np.concatenate([mesh.points[mesh.triangles] for mesh in meshes])
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    normal = normal / np.where(length > 0, length, 1.0)
    if encoding == "text":
        rows = np.concatenate([normal, corners.reshape(-1, 9)], axis=1).astype(np.float32).tolist()
        body = "".join(_FACET.format(*row) for row in rows)
        path.write_text(f"solid GearStudio\n{body}endsolid GearStudio\n", encoding="ascii", newline="\n")
        return
    records = np.zeros(len(corners), _RECORD)
    records["normal"], records["corners"] = normal, corners
    with open(path, "wb") as file:
        file.write(b"GearStudio, millimetres".ljust(_HEADER))
        file.write(np.uint32(len(corners)).tobytes())
        file.write(records.tobytes())


def read(path: Path) -> list[Mesh]:
    """One mesh; corners at the same place become one point. ValueError when the file is cut off."""
    content = path.read_bytes()
    corners = _from_text(content) if content[:6].lower() == b"solid " else _from_binary(content)
    points, index = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    return [Mesh(points.astype(np.float64), {"all": index.reshape(-1, 3)})]


def _from_binary(content: bytes) -> NDArray[np.float32]:
    count = int(np.frombuffer(content, "<u4", 1, _HEADER)[0])
    return np.asarray(np.frombuffer(content, _RECORD, count, _HEADER + 4)["corners"])


def _from_text(content: bytes) -> NDArray[np.float32]:
    _, _, body = content.partition(b"\n")
    facets, end, _ = body.rpartition(b"endsolid")
    words = facets.split()
    if not end or len(words) % _WORDS:
        raise ValueError("not a complete STL file")
    return np.array(words).reshape(-1, _WORDS)[:, _CORNERS].astype(np.float32)
