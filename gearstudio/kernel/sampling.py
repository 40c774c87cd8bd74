"""Points of faces, and with normals those of a STEP file that any program wrote."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepTools import BRepTools
from OCP.gp import gp_Pnt, gp_Pnt2d, gp_Vec
from OCP.IntTools import IntTools_FClass2d
from OCP.Standard import Standard_Failure
from OCP.TopAbs import TopAbs_Orientation, TopAbs_State
from OCP.TopoDS import TopoDS_Face

from gearstudio.errors import FileError
from gearstudio.kernel.exchange import faces_of, read_step
from gearstudio.kernel.step import settle
from gearstudio.results import FaceSamples

Floats = NDArray[np.float64]

_PARAMETER_TOLERANCE = 1e-9
_ON_BORDER = 1e-7
_MEASURING_POINTS = 9
_FEWEST, _MOST = 3, 400


def face_points(face: TopoDS_Face, count: int) -> Floats:
    """Points of a face on an even grid of its parameters, its border included, shape (n, 3) [mm].

    At most count² points: those beyond a border that cuts through the grid are left out.
    """
    surface, (u0, u1, v0, v1) = BRepAdaptor_Surface(face), BRepTools.UVBounds_s(face)
    grid = np.linspace(u0, u1, count), np.linspace(v0, v1, count)
    found = [_place(surface, *uv) for uv in _inside(face, *grid, _ON_BORDER, with_border=True)]
    return np.array(found, dtype=np.float64).reshape(-1, 3)


def read_faces(path: Path) -> list[TopoDS_Face]:
    """The faces of a STEP file, placed as in its assembly.

    Raises
    ------
    FileError
        Not a STEP file, or one without faces.
    """
    settle()
    if not path.is_file():
        raise FileError(path, "there is no such file")
    shape = read_step(path)
    if shape is None:
        raise FileError(path, "the CAD kernel cannot read this as STEP")
    faces = [] if shape.IsNull() else faces_of(shape)
    if not faces:
        raise FileError(path, "there are no faces in it; points can be taken from solids and surfaces only")
    return faces


def counts_for(face: TopoDS_Face, spacing: float) -> tuple[int, int]:
    """How many points along each parameter are about a spacing [mm] apart."""
    surface, (u0, u1, v0, v1) = BRepAdaptor_Surface(face), BRepTools.UVBounds_s(face)
    share = np.linspace(0.0, 1.0, _MEASURING_POINTS)
    middle_u, middle_v = (u0 + u1) / 2, (v0 + v1) / 2
    lines = ([(u0 + s * (u1 - u0), middle_v) for s in share], [(middle_u, v0 + s * (v1 - v0)) for s in share])
    lengths = [np.linalg.norm(np.diff([_place(surface, *uv) for uv in line], axis=0), axis=1).sum() for line in lines]
    along_u, along_v = (int(np.clip(np.ceil(length / spacing), _FEWEST, _MOST)) for length in lengths)
    return along_u, along_v


def sample_face(face: TopoDS_Face, counts: tuple[int, int]) -> FaceSamples:
    """Points of a grid in the surface's parameters, those beyond the face's border left out.

    They stand in the middle of the grid's cells. A face that the kernel cannot evaluate has none.
    """
    try:
        return _sampled(face, counts)
    except Standard_Failure:
        return FaceSamples(np.empty((0, 3)), np.empty((0, 3)), np.empty(0))


def _sampled(face: TopoDS_Face, counts: tuple[int, int]) -> FaceSamples:
    surface, (u0, u1, v0, v1) = BRepAdaptor_Surface(face), BRepTools.UVBounds_s(face)
    step_u, step_v = (u1 - u0) / counts[0], (v1 - v0) / counts[1]
    grid = u0 + (np.arange(counts[0]) + 0.5) * step_u, v0 + (np.arange(counts[1]) + 0.5) * step_v
    point, along_u, along_v = gp_Pnt(), gp_Vec(), gp_Vec()
    found = []
    for u, v in _inside(face, *grid, _PARAMETER_TOLERANCE):
        surface.D1(u, v, point, along_u, along_v)
        across = along_u.Crossed(along_v)
        found.append((point.X(), point.Y(), point.Z(), across.X(), across.Y(), across.Z()))
    table = np.array(found).reshape(-1, 6)
    sizes = np.linalg.norm(table[:, 3:], axis=1)
    table, sizes = table[sizes > 0], sizes[sizes > 0]
    sign = -1.0 if face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED else 1.0
    return FaceSamples(table[:, :3], sign * table[:, 3:] / sizes[:, None], sizes * abs(step_u * step_v))


def _inside(
    face: TopoDS_Face, u: Floats, v: Floats, tolerance: float, with_border: bool = False
) -> Iterator[tuple[float, float]]:
    """The nodes of a grid of parameters that lie inside a face's border, or on it where that counts."""
    classifier = IntTools_FClass2d(face, tolerance)
    for at_u in u.tolist():
        for at_v in v.tolist():
            state = classifier.Perform(gp_Pnt2d(at_u, at_v))
            if state == TopAbs_State.TopAbs_IN or (with_border and state != TopAbs_State.TopAbs_OUT):
                yield at_u, at_v


def _place(surface: BRepAdaptor_Surface, u: float, v: float) -> tuple[float, float, float]:
    point = surface.Value(u, v)
    return point.X(), point.Y(), point.Z()
