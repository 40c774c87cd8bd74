"""GLB: binary glTF 2.0, one node for each part, one primitive with its colour for each group of faces.

As glTF asks it is in metres with y up; ``asset.extras`` says so, or how else it was written.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearstudio.exchange.colors import linear_color
from gearstudio.formats import USUAL, ExportOptions
from gearstudio.results import Mesh
from gearstudio.theory.place import Place

NamedMesh = tuple[str, Mesh, Place]

_UNITS = {"m": 1e-3, "mm": 1.0}
_UPS = {"y": np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]), "z": np.eye(3)}
_FLOAT, _UINT, _POSITIONS, _INDICES = 5126, 5125, 34962, 34963
_JSON_CHUNK, _BINARY_CHUNK, _MAGIC = 0x4E4F534A, 0x004E4942, 0x46546C67


def write(path: Path, meshes: Sequence[NamedMesh], options: ExportOptions = USUAL) -> None:
    """Every mesh as a node with its place."""
    chunks: list[bytes] = []
    extras = {"unit": options.glb_unit, "up": options.glb_up}
    tree: dict[str, Any] = {
        "asset": {"version": "2.0", "generator": "GearStudio", "extras": extras},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(meshes)))}],
        "nodes": [],
        "meshes": [],
        "materials": [],
        "accessors": [],
        "bufferViews": [],
    }
    for index, (name, mesh, place) in enumerate(meshes):
        matrix = np.eye(4)
        matrix[:3, :3] = _UPS[options.glb_up] @ place.matrix
        matrix[:3, 3] = _UPS[options.glb_up] @ place.shift * _UNITS[options.glb_unit]
        title = {"name": name} if options.names else {}
        tree["nodes"].append({**title, "mesh": index, "matrix": matrix.T.ravel().tolist()})
        points = (mesh.points * _UNITS[options.glb_unit]).astype("<f4")
        bounds = {"min": points.min(axis=0).tolist(), "max": points.max(axis=0).tolist()}
        position = _accessor(tree, chunks, points, _FLOAT, "VEC3", _POSITIONS)
        tree["accessors"][position] |= bounds
        primitives = []
        for group, triangles in mesh.groups.items():
            corners = _accessor(tree, chunks, triangles.astype("<u4").ravel(), _UINT, "SCALAR", _INDICES)
            primitive: dict[str, Any] = {"attributes": {"POSITION": position}, "indices": corners}
            if options.colors:
                primitive["material"] = len(tree["materials"])
                tree["materials"].append(_material(group, options.names))
            primitives.append(primitive)
        tree["meshes"].append({**title, "primitives": primitives})
    if not options.colors:
        del tree["materials"]
    binary = b"".join(chunks)
    tree["buffers"] = [{"byteLength": len(binary)}]
    text = json.dumps(tree, ensure_ascii=False, separators=(",", ":")).encode("utf-8")
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<III", _MAGIC, 2, 12 + 8 + len(text) + 8 + len(binary)))
        file.write(struct.pack("<II", len(text), _JSON_CHUNK) + text)
        file.write(struct.pack("<II", len(binary), _BINARY_CHUNK) + binary)


def read(path: Path) -> list[Mesh]:
    """The placed meshes, back in millimetres with z up. ValueError when the file is cut off."""
    content = path.read_bytes()
    if len(content) < 20 or struct.unpack_from("<III", content) != (_MAGIC, 2, len(content)):
        raise ValueError("not a complete GLB file")
    (length,) = struct.unpack_from("<I", content, 12)
    tree = json.loads(content[20 : 20 + length])
    binary = content[20 + length + 8 :]
    extras = tree["asset"].get("extras", {})
    up, unit = _UPS[extras.get("up", "y")], _UNITS[extras.get("unit", "m")]

    def values(index: int, kind: str, width: int) -> NDArray[np.generic]:
        accessor = tree["accessors"][index]
        start = tree["bufferViews"][accessor["bufferView"]]["byteOffset"]
        return np.frombuffer(binary, kind, accessor["count"] * width, start).reshape(-1, width)

    meshes = []
    for node in tree["nodes"]:
        primitives = tree["meshes"][node["mesh"]]["primitives"]
        points = values(primitives[0]["attributes"]["POSITION"], "<f4", 3).astype(np.float64) / unit
        matrix = np.array(node["matrix"]).reshape(4, 4).T
        place = Place(up.T @ matrix[:3, :3], up.T @ matrix[:3, 3] / unit)
        corners = [values(p["indices"], "<u4", 1).reshape(-1, 3).astype(np.int64) for p in primitives]
        meshes.append(Mesh(place.of(points), {str(k): part for k, part in enumerate(corners)}))
    return meshes


def _accessor(
    tree: dict[str, Any], chunks: list[bytes], values: NDArray[np.generic], kind: int, shape: str, target: int
) -> int:
    """Append values as bytes with their view; the index of the accessor."""
    data = values.tobytes()
    view = {"buffer": 0, "byteOffset": sum(map(len, chunks)), "byteLength": len(data), "target": target}
    chunks.append(data)
    tree["bufferViews"].append(view)
    count = len(values)
    tree["accessors"].append(
        {"bufferView": len(tree["bufferViews"]) - 1, "componentType": kind, "count": count, "type": shape}
    )
    return len(tree["accessors"]) - 1


def _material(group: str, named: bool) -> dict[str, Any]:
    color = [*linear_color(group), 1.0]
    title = {"name": group} if named else {}
    look = {"baseColorFactor": color, "metallicFactor": 0.6, "roughnessFactor": 0.45}
    return {**title, "pbrMetallicRoughness": look}
