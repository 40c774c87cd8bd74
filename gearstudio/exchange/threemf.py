"""3MF: a zipped XML with one object for each part [mm]."""

from __future__ import annotations

import zipfile
from collections.abc import Sequence
from pathlib import Path
from xml.etree import ElementTree
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import NDArray

from gearstudio.results import Mesh

Floats = NDArray[np.float64]
NamedMesh = tuple[str, Mesh, Floats]

_CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
_MODEL = "3D/3dmodel.model"
_TYPES = """<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>"""
_RELATIONS = f"""<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/{_MODEL}" Id="model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>"""


def write(path: Path, meshes: Sequence[NamedMesh]) -> None:
    """Every mesh as an object, placed by an item of the build."""
    objects = "".join(_object(number, name, mesh) for number, (name, mesh, _) in enumerate(meshes, start=1))
    items = "".join(_item(number, placement) for number, (_, _, placement) in enumerate(meshes, start=1))
    model = (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<model unit="millimeter" xml:lang="en" xmlns="{_CORE}">\n'
        f"<resources>\n{objects}</resources>\n<build>\n{items}</build>\n</model>\n"
    )
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=4) as package:
        package.writestr("[Content_Types].xml", _TYPES)
        package.writestr("_rels/.rels", _RELATIONS)
        package.writestr(_MODEL, model)


def read(path: Path) -> list[Mesh]:
    """The placed meshes, in the order of the build. ValueError when the file is cut off."""
    try:
        with zipfile.ZipFile(path) as package:
            root = ElementTree.fromstring(package.read(_MODEL))
    except (zipfile.BadZipFile, ElementTree.ParseError) as error:
        raise ValueError("not a complete 3MF file") from error
    tag = f"{{{_CORE}}}"
    objects = {item.get("id"): item for item in root.iter(f"{tag}object")}
    meshes = []
    for item in root.iter(f"{tag}item"):
        mesh = objects[item.get("objectid")]
        points = _values(mesh, f"{tag}vertex", ("x", "y", "z")).astype(np.float64)
        triangles = _values(mesh, f"{tag}triangle", ("v1", "v2", "v3")).astype(np.int64)
        rows = np.array((item.get("transform") or "1 0 0 0 1 0 0 0 1 0 0 0").split(), dtype=np.float64).reshape(4, 3)
        meshes.append(Mesh(points @ rows[:3] + rows[3], {"all": triangles}))
    return meshes


def _object(number: int, name: str, mesh: Mesh) -> str:
    vertices = "\n".join(f'<vertex x="{x:.12g}" y="{y:.12g}" z="{z:.12g}"/>' for x, y, z in mesh.points.tolist())
    triangles = "\n".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in mesh.triangles.tolist())
    return (
        f'<object id="{number}" type="model" name={quoteattr(name)}>\n<mesh>\n<vertices>\n{vertices}\n</vertices>\n'
        f"<triangles>\n{triangles}\n</triangles>\n</mesh>\n</object>\n"
    )


def _item(number: int, placement: Floats) -> str:
    rows = np.vstack([placement.T, np.zeros(3)]).ravel()
    return f'<item objectid="{number}" transform="{" ".join(f"{value:.15g}" for value in rows)}"/>\n'


def _values(parent: ElementTree.Element, tag: str, keys: tuple[str, ...]) -> NDArray[np.str_]:
    return np.array([[element.get(key) for key in keys] for element in parent.iter(tag)], dtype=np.str_)
