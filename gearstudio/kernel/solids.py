"""What a solid is worth: validity, closedness, volume and inertia."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Curve
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.collections import IndexedDataMap_TopoDS_Shape_List_TopoDS_Shape_TopTools_ShapeMapHasher
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopExp import TopExp, TopExp_Explorer
from OCP.TopoDS import TopoDS, TopoDS_Edge, TopoDS_Face, TopoDS_Shape

from gearstudio.kernel.boxes import bounding_box
from gearstudio.kernel.weighing import volume_of, weigh

Floats = NDArray[np.float64]

_GAP_SAMPLES = 23


@dataclass(frozen=True)
class SolidCheck:
    """The kernel's verdict on a solid.

    Attributes
    ----------
    valid, closed : bool
    shells, faces : int
    volume : float
        [mm^3], positive when the faces look outward.
    area : float
        [mm^2]
    centre : tuple of float
        Centre of mass [mm].
    inertia : ndarray, shape (3, 3)
        About the centre of mass for unit density [mm^5].
    box : ndarray, shape (2, 3)
        Least and greatest coordinates [mm].
    """

    valid: bool
    closed: bool
    shells: int
    faces: int
    volume: float
    area: float
    centre: tuple[float, float, float]
    inertia: Floats
    box: Floats


def check_solid(shape: TopoDS_Shape) -> SolidCheck:
    """Run the kernel's full check and integrate volume, area and inertia."""
    weight = weigh(shape)
    shells = _parts(shape, TopAbs_ShapeEnum.TopAbs_SHELL)
    return SolidCheck(
        valid=is_valid(shape),
        closed=is_closed(shape),
        shells=len(shells),
        faces=len(_parts(shape, TopAbs_ShapeEnum.TopAbs_FACE)),
        volume=weight.volume,
        area=weight.area,
        centre=(float(weight.centre[0]), float(weight.centre[1]), float(weight.centre[2])),
        inertia=weight.inertia,
        box=bounding_box(shape),
    )


def solid_volume(shape: TopoDS_Shape) -> float:
    """Volume [mm^3], positive when the faces look outward."""
    return volume_of(shape)


def is_closed(shape: TopoDS_Shape) -> bool:
    """Whether it has shells and all are closed."""
    shells = _parts(shape, TopAbs_ShapeEnum.TopAbs_SHELL)
    return bool(shells) and all(BRep_Tool.IsClosed_s(shell) for shell in shells)


def measured_gap(shape: TopoDS_Shape) -> float:
    """Largest distance between neighbouring faces along the edges that they share [mm]: measured, not promised."""
    users = IndexedDataMap_TopoDS_Shape_List_TopoDS_Shape_TopTools_ShapeMapHasher()
    TopExp.MapShapesAndAncestors_s(shape, TopAbs_ShapeEnum.TopAbs_EDGE, TopAbs_ShapeEnum.TopAbs_FACE, users)
    gap = 0.0
    for i in range(1, users.Extent() + 1):
        edge, faces = TopoDS.Edge(users.FindKey(i)), list(users.FindFromIndex(i))
        if len(faces) == 2 and not faces[0].IsSame(faces[1]):
            first, second = (_along(edge, TopoDS.Face(face)) for face in faces)
            gap = max(gap, float(np.linalg.norm(first - second, axis=-1).max()))
    return gap


def _along(edge: TopoDS_Edge, face: TopoDS_Face) -> Floats:
    """Points of an edge as the face has it."""
    curve = BRepAdaptor_Curve(edge, face)
    places = np.linspace(curve.FirstParameter(), curve.LastParameter(), _GAP_SAMPLES).tolist()
    return np.array([(p.X(), p.Y(), p.Z()) for p in map(curve.Value, places)])


def is_valid(shape: TopoDS_Shape) -> bool:
    """The kernel's full check, on as many cores as there are."""
    return bool(BRepCheck_Analyzer(shape, True, True).IsValid())


def _parts(shape: TopoDS_Shape, kind: TopAbs_ShapeEnum) -> list[TopoDS_Shape]:
    explorer, parts = TopExp_Explorer(shape, kind), []
    while explorer.More():
        parts.append(explorer.Current())
        explorer.Next()
    return parts
