"""Solids as files for other CAD programs: writers by format, and what is found when a file is read back."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from OCP.BRep import BRep_Builder
from OCP.BRepTools import BRepTools
from OCP.IFSelect import IFSelect_ReturnStatus
from OCP.IGESCAFControl import IGESCAFControl_Writer
from OCP.IGESControl import IGESControl_Controller, IGESControl_Reader
from OCP.Interface import Interface_Static
from OCP.STEPCAFControl import STEPCAFControl_Writer
from OCP.STEPControl import STEPControl_Reader, STEPControl_StepModelType
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Shape

from gearstudio.errors import FileError
from gearstudio.kernel.cutting import compound, parts
from gearstudio.kernel.document import Part, located, make_document
from gearstudio.kernel.solids import corner_box, is_closed, is_valid, solid_volume
from gearstudio.kernel.step import settle
from gearstudio.results import FileCheck

SOLID_FORMATS = ("step", "iges", "brep")


def write_solids(path: Path, name: str, made: Sequence[Part], format_: str) -> FileCheck:
    """Write parts and read the file back.

    Parameters
    ----------
    path : Path
        Written in place.
    name : str
        Of the product as a whole.
    made : sequence of Part
        One, or several that make an assembly.
    format_ : {"step", "iges", "brep"}

    Raises
    ------
    FileError
        The kernel could not write or read the file, or what it reads is not what was written.
    """
    settle()
    write, read = _WRITERS[format_], _READERS[format_]
    if not write(path, name, made):
        raise FileError(path, f"the CAD kernel could not write the {format_.upper()} file; the disk may be full")
    shape = read(path)
    if shape is None or shape.IsNull():
        raise FileError(path, "the file is not complete after writing; the disk may be full")
    return _checked(path, format_, shape, made)


def _checked(path: Path, format_: str, shape: TopoDS_Shape, made: Sequence[Part]) -> FileCheck:
    solids = parts(shape, TopAbs_ShapeEnum.TopAbs_SOLID)
    wanted = sum(part.volume for part in made)
    volume = sum(solid_volume(solid) for solid in solids)
    box = corner_box(compound([located(part) for part in made]))
    check = FileCheck(
        format=format_,
        valid=bool(solids) and is_valid(shape),
        closed=bool(solids) and all(is_closed(solid) for solid in solids),
        solids=len(solids),
        faces=len(parts(shape, TopAbs_ShapeEnum.TopAbs_FACE)),
        volume=volume,
        volume_error=abs(volume - wanted) / wanted,
        box_error=float(np.abs(corner_box(shape) - box).max()) if solids else np.inf,
    )
    check.require(path, len(made))
    return check


def _write_step(path: Path, name: str, made: Sequence[Part]) -> bool:
    writer = STEPCAFControl_Writer()
    writer.SetNameMode(True)
    writer.SetColorMode(True)
    writer.Transfer(make_document(name, made), STEPControl_StepModelType.STEPControl_AsIs)
    return bool(writer.Write(str(path)) == IFSelect_ReturnStatus.IFSelect_RetDone)


def _write_iges(path: Path, name: str, made: Sequence[Part]) -> bool:
    IGESControl_Controller.Init_s()
    Interface_Static.SetIVal_s("write.iges.brep.mode", 1)
    Interface_Static.SetCVal_s("write.iges.unit", "MM")
    writer = IGESCAFControl_Writer()
    writer.SetNameMode(True)
    writer.SetColorMode(True)
    writer.Transfer(make_document(name, made))
    return bool(writer.Write(str(path)))


def _write_brep(path: Path, name: str, made: Sequence[Part]) -> bool:
    shapes = [located(part) for part in made]
    return bool(BRepTools.Write_s(shapes[0] if len(shapes) == 1 else compound(shapes), str(path)))


def _read_step(path: Path) -> TopoDS_Shape | None:
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
    return shape if BRepTools.Read_s(shape, str(path), BRep_Builder()) else None


_WRITERS: dict[str, Callable[[Path, str, Sequence[Part]], bool]] = {
    "step": _write_step,
    "iges": _write_iges,
    "brep": _write_brep,
}
_READERS: dict[str, Callable[[Path], TopoDS_Shape | None]] = {
    "step": _read_step,
    "iges": _read_iges,
    "brep": _read_brep,
}
