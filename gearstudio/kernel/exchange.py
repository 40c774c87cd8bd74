"""Files of CAD programs read back: the solids and faces in them."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from importlib import metadata
from pathlib import Path

from OCP.BinTools import BinTools
from OCP.BRep import BRep_Builder
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeSolid, BRepBuilderAPI_Sewing
from OCP.BRepTools import BRepTools
from OCP.IFSelect import IFSelect_ReturnStatus
from OCP.IGESControl import IGESControl_Reader
from OCP.Standard import Standard_Failure
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS, TopoDS_Face, TopoDS_Shape

from gearstudio.errors import FileError
from gearstudio.kernel.cutting import compound, parts
from gearstudio.kernel.solids import is_closed, is_valid, solid_volume
from gearstudio.kernel.step import settle

Shape = TopoDS_Shape

_SEWN_WITHIN = 1e-4
_BINARY_BREP = b"\nOpen CASCADE Topology"


def read_shape(path: Path, format_: str) -> TopoDS_Shape:
    """What a file holds, in mm; faces that belong to no solid are sewn into solids.

    Raises
    ------
    FileError
        The kernel finds nothing in it.
    """
    settle()
    try:
        shape = _READERS[format_](path)
    except (Standard_Failure, RuntimeError, UnicodeDecodeError) as error:
        raise _unreadable(path, format_) from error
    if shape is None or shape.IsNull():
        raise _unreadable(path, format_)
    return shape if parts(shape, TopAbs_ShapeEnum.TopAbs_SOLID) else _sewn(shape)


def solids_of(shape: TopoDS_Shape) -> list[TopoDS_Shape]:
    """The solids of a shape, each where it stands."""
    return parts(shape, TopAbs_ShapeEnum.TopAbs_SOLID)


def faces_of(shape: TopoDS_Shape) -> list[TopoDS_Face]:
    """The faces of a shape, each where it stands."""
    return [TopoDS.Face(face) for face in parts(shape, TopAbs_ShapeEnum.TopAbs_FACE)]


def verdict(shape: TopoDS_Shape) -> tuple[bool, bool, float]:
    """Whether a shape's solids are valid by the kernel's full check, and closed; their volume [mm^3]."""
    solids = solids_of(shape)
    closed = bool(solids) and all(is_closed(solid) for solid in solids)
    return bool(solids) and is_valid(shape), closed, sum(solid_volume(solid) for solid in solids)


@cache
def kernel_version() -> str:
    """Name and version of the CAD kernel."""
    for name in ("cadquery-ocp-novtk", "cadquery-ocp"):
        try:
            return f"Open CASCADE {metadata.version(name)}"
        except metadata.PackageNotFoundError:
            continue
    return "Open CASCADE"


def read_step(path: Path) -> TopoDS_Shape | None:
    """What a STEP file holds, in mm; None when the kernel cannot read it."""
    reader = STEPControl_Reader()
    if reader.ReadFile(str(path)) != IFSelect_ReturnStatus.IFSelect_RetDone:
        return None
    reader.TransferRoots()
    return reader.OneShape()


def _read_iges(path: Path) -> TopoDS_Shape | None:
    reader = IGESControl_Reader()
    if reader.ReadFile(str(path)) != IFSelect_ReturnStatus.IFSelect_RetDone:
        return None
    reader.TransferRoots()
    return reader.OneShape()


def _read_brep(path: Path) -> TopoDS_Shape | None:
    shape = TopoDS_Shape()
    with open(path, "rb") as file:
        binary = file.read(len(_BINARY_BREP)) == _BINARY_BREP
    if binary:
        return shape if BinTools.Read_s(shape, str(path)) else None
    return shape if BRepTools.Read_s(shape, str(path), BRep_Builder()) else None


_READERS: dict[str, Callable[[Path], TopoDS_Shape | None]] = {
    "step": read_step,
    "iges": _read_iges,
    "brep": _read_brep,
}


def _sewn(shape: TopoDS_Shape) -> TopoDS_Shape:
    """Closed shells of loose faces as solids, or the shape as it is."""
    sewing = BRepBuilderAPI_Sewing(_SEWN_WITHIN)
    sewing.Add(shape)
    sewing.Perform()
    shells = [TopoDS.Shell(shell) for shell in parts(sewing.SewedShape(), TopAbs_ShapeEnum.TopAbs_SHELL)]
    if not shells or not all(is_closed(shell) for shell in shells):
        return shape
    solids: list[TopoDS_Shape] = []
    for shell in shells:
        solid = BRepBuilderAPI_MakeSolid(shell).Solid()
        solids.append(solid if solid_volume(solid) > 0 else solid.Reversed())
    return compound(solids)


def _unreadable(path: Path, format_: str) -> FileError:
    return FileError(path, f"the CAD kernel cannot read this as {format_.upper()}; it may be cut off or damaged")
