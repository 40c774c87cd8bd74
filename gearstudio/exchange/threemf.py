"""3MF: a zipped XML with one object for each part, its faces coloured as materials."""

from __future__ import annotations

import zipfile
from collections.abc import Sequence
from pathlib import Path
from xml.etree import ElementTree
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import NDArray

from gearstudio.exchange.colors import face_color
from gearstudio.formats import USUAL, ExportOptions
from gearstudio.results import Mesh
from gearstudio.theory.place import Place

NamedMesh = tuple[str, Mesh, Place]

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
_MATERIALS = 1
_MILLIMETRES = {"micron": 1e-3, "millimeter": 1.0, "centimeter": 10.0, "inch": 25.4, "foot": 304.8, "meter": 1e3}


def write(path: Path, meshes: Sequence[NamedMesh], options: ExportOptions = USUAL) -> None:
    """Every mesh as an object, placed by an item of the build."""
    groups = list(dict.fromkeys(group for _, mesh, _ in meshes for group in mesh.groups)) if options.colors else []
    factor = 1 / _MILLIMETRES[options.threemf_unit]
    objects = "".join(
        _object(number, name if options.names else "", mesh, factor, groups)
        for number, (name, mesh, _) in enumerate(meshes, start=_MATERIALS + 1)
    )
    items = "".join(_item(number, placed, factor) for number, (_, _, placed) in enumerate(meshes, start=_MATERIALS + 1))
    model = (
        f'<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<model unit="{options.threemf_unit}" xml:lang="en" xmlns="{_CORE}">\n'
        f"<resources>\n{_materials(groups)}{objects}</resources>\n<build>\n{items}</build>\n</model>\n"
    )
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=4) as package:
        package.writestr("[Content_Types].xml", _TYPES)
        package.writestr("_rels/.rels", _RELATIONS)
        package.writestr(_MODEL, model)


def read(path: Path) -> list[Mesh]:
    """The placed meshes in mm, in the order of the build. ValueError when the file is cut off."""
    try:
        with zipfile.ZipFile(path) as package:
            root = ElementTree.fromstring(package.read(_MODEL))
    except (zipfile.BadZipFile, ElementTree.ParseError) as error:
        raise ValueError("not a complete 3MF file") from error
    tag = f"{{{_CORE}}}"
    factor = _MILLIMETRES[root.get("unit", "millimeter")]
    objects = {item.get("id"): item for item in root.iter(f"{tag}object")}
    meshes = []
    for item in root.iter(f"{tag}item"):
        mesh = objects[item.get("objectid")]
        points = _values(mesh, f"{tag}vertex", ("x", "y", "z")).astype(np.float64)
        triangles = _values(mesh, f"{tag}triangle", ("v1", "v2", "v3")).astype(np.int64)
        rows = np.array((item.get("transform") or "1 0 0 0 1 0 0 0 1 0 0 0").split(), dtype=np.float64).reshape(4, 3)
        meshes.append(Mesh(factor * (points @ rows[:3] + rows[3]), {"all": triangles}))
    return meshes


def _materials(groups: Sequence[str]) -> str:
    if not groups:
        return ""
    shades = ("".join(f"{round(255 * value):02X}" for value in face_color(group)) for group in groups)
    bases = "".join(f'<base name={quoteattr(g)} displaycolor="#{s}"/>\n' for g, s in zip(groups, shades, strict=True))
    return f'<basematerials id="{_MATERIALS}">\n{bases}</basematerials>\n'


def _object(number: int, name: str, mesh: Mesh, factor: float, groups: Sequence[str]) -> str:
    points = (factor * mesh.points).tolist()
    vertices = "\n".join(f'<vertex x="{x:.12g}" y="{y:.12g}" z="{z:.12g}"/>' for x, y, z in points)
    triangles = "\n".join(
        f'<triangle v1="{a}" v2="{b}" v3="{c}"{_paint(group, groups)}/>'
        for group, corners in mesh.groups.items()
        for a, b, c in corners.tolist()
    )
    title = f" name={quoteattr(name)}" if name else ""
    paint = f' pid="{_MATERIALS}" pindex="0"' if groups else ""
    return (
        f'<object id="{number}" type="model"{title}{paint}>\n<mesh>\n<vertices>\n{vertices}\n</vertices>\n'
        f"<triangles>\n{triangles}\n</triangles>\n</mesh>\n</object>\n"
    )


def _paint(group: str, groups: Sequence[str]) -> str:
    return f' pid="{_MATERIALS}" p1="{groups.index(group)}"' if groups else ""


def _item(number: int, place: Place, factor: float) -> str:
    rows = np.vstack([place.matrix.T, factor * place.shift]).ravel()
    return f'<item objectid="{number}" transform="{" ".join(f"{value:.15g}" for value in rows)}"/>\n'


def _values(parent: ElementTree.Element, tag: str, keys: tuple[str, ...]) -> NDArray[np.str_]:
    return np.array([[element.get(key) for key in keys] for element in parent.iter(tag)], dtype=np.str_)
