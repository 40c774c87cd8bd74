"""The bounding box of a shape as it is, not of its poles: corners first, then what reaches beyond them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from OCP.Bnd import Bnd_Box
from OCP.BRep import BRep_Tool
from OCP.BRepBndLib import BRepBndLib
from OCP.BRepTools import BRepTools
from OCP.collections import IndexedMap_TopoDS_Shape_TopTools_ShapeMapHasher
from OCP.Geom import Geom_ConicalSurface, Geom_CylindricalSurface, Geom_Plane
from OCP.gp import gp_Pnt2d
from OCP.IntTools import IntTools_FClass2d
from OCP.TopAbs import TopAbs_ShapeEnum, TopAbs_State
from OCP.TopExp import TopExp
from OCP.TopoDS import TopoDS, TopoDS_Shape

from gearstudio.kernel.parametric import Parametric, parametric

Floats = NDArray[np.float64]

_WITHIN_EDGES = (Geom_Plane, Geom_CylindricalSurface, Geom_ConicalSurface)
"""A face of these reaches in no direction beyond its edges, unless it is closed over the apex, which is a corner."""
_FINEST = 1e-9
_ON_BORDER = 1e-9
_LOOKS = 33
_ROUNDS = 8
_ALONG_AXIS = 0.99


def bounding_box(shape: TopoDS_Shape) -> Floats:
    """Least and greatest coordinates of a shape [mm], shape (2, 3).

    The kernel's precise box is slow and for faces too large or too small, its quick one is that of the poles: only the
    few edges and faces whose poles lie beyond what is known are looked at closely.
    """
    known = corner_box(shape)
    finest = _FINEST * float(np.abs(known).max())
    for kind, closely in ((TopAbs_ShapeEnum.TopAbs_EDGE, _edge_box), (TopAbs_ShapeEnum.TopAbs_FACE, _face_box)):
        for part in _parts(shape, kind):
            quick = _quick_box(part)
            beyond = np.stack([known[0] - quick[0], quick[1] - known[1]]) > finest
            if np.any(beyond):
                precise = closely(part, beyond)
                known = np.stack([np.fmin(known[0], precise[0]), np.fmax(known[1], precise[1])])
    return known


def corners(shape: TopoDS_Shape) -> Floats:
    """Its vertices [mm], shape (n, 3), each once."""
    points = [BRep_Tool.Pnt_s(TopoDS.Vertex(v)) for v in _parts(shape, TopAbs_ShapeEnum.TopAbs_VERTEX)]
    return np.array([point.Coord() for point in points])


def corner_box(shape: TopoDS_Shape) -> Floats:
    """Least and greatest coordinates of its vertices [mm], shape (2, 3); quick, and the same in every format."""
    points = corners(shape)
    return np.stack([points.min(axis=0), points.max(axis=0)])


def _edge_box(edge: TopoDS_Shape, beyond: NDArray[np.bool_]) -> Floats:
    box = Bnd_Box()
    BRepBndLib.AddOptimal_s(edge, box, False, False)
    return np.array([box.CornerMin().Coord(), box.CornerMax().Coord()])


def _face_box(shape: TopoDS_Shape, beyond: NDArray[np.bool_]) -> Floats:
    """Coordinates at the places inside a face where its normal lies along an axis; nan where there are none."""
    face, found = TopoDS.Face(shape), np.full((2, 3), np.nan)
    geometry = BRep_Tool.Surface_s(face)
    if isinstance(geometry, _WITHIN_EDGES):
        return found
    surface = parametric(geometry)
    u0, u1, v0, v1 = BRepTools.UVBounds_s(face)
    _, normals = surface.at(np.linspace(u0, u1, _LOOKS), np.linspace(v0, v1, _LOOKS))
    upright = np.abs(normals) > _ALONG_AXIS * np.linalg.norm(normals, axis=-1, keepdims=True)
    for end, axis in np.argwhere(beyond & np.any(upright, axis=(0, 1))).tolist():
        sign = 2 * end - 1
        place, value = _farthest(surface, np.array([[u0, u1], [v0, v1]]), axis, sign)
        if IntTools_FClass2d(face, _ON_BORDER).Perform(gp_Pnt2d(*place)) == TopAbs_State.TopAbs_IN:
            found[end, axis] = value
    return found


def _farthest(surface: Parametric, bounds: Floats, axis: int, sign: int) -> tuple[tuple[float, float], float]:
    """Where in a range of (u, v) a coordinate is greatest, or with sign -1 least; and how great."""
    here = bounds
    for _ in range(_ROUNDS):
        u, v = (np.linspace(low, high, _LOOKS) for low, high in here)
        height = surface.at(u, v)[0][..., axis]
        i, j = np.unravel_index(np.argmax(sign * height), height.shape)
        middle, reach = np.array([[u[i]], [v[j]]]), np.array([[u[1] - u[0]], [v[1] - v[0]]])
        here = np.clip(middle + reach * np.array([-1.0, 1.0]), bounds[:, :1], bounds[:, 1:])
    return (float(u[i]), float(v[j])), float(height[i, j])


def _parts(shape: TopoDS_Shape, kind: TopAbs_ShapeEnum) -> list[TopoDS_Shape]:
    found = IndexedMap_TopoDS_Shape_TopTools_ShapeMapHasher()
    TopExp.MapShapes_s(shape, kind, found)
    return [found.FindKey(i) for i in range(1, found.Extent() + 1)]


def _quick_box(part: TopoDS_Shape) -> Floats:
    box = Bnd_Box()
    BRepBndLib.Add_s(part, box, False)
    return np.array([box.CornerMin().Coord(), box.CornerMax().Coord()])
