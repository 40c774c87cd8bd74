"""STEP files with named faces, and their reading back."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path

from OCP.BRep import BRep_Builder, BRep_Tool
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.collections import Sequence_TDF_Label
from OCP.Geom import Geom_BSplineSurface
from OCP.IFSelect import IFSelect_ReturnStatus
from OCP.Interface import Interface_Static
from OCP.Message import Message, Message_PrinterOStream
from OCP.STEPCAFControl import STEPCAFControl_Controller, STEPCAFControl_Reader, STEPCAFControl_Writer
from OCP.STEPControl import STEPControl_StepModelType
from OCP.TCollection import TCollection_ExtendedString
from OCP.TDataStd import TDataStd_Name
from OCP.TDF import TDF_Label
from OCP.TDocStd import TDocStd_Document
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS, TopoDS_Compound
from OCP.XCAFDoc import XCAFDoc_DocumentTool

from gearstudio.errors import FileError
from gearstudio.files import why_not_written
from gearstudio.formats import USUAL, ExportOptions
from gearstudio.kernel.convert import to_face, to_record
from gearstudio.kernel.document import set_name
from gearstudio.nurbs import NurbsSurface

_SCHEMAS = {"ap203": 3, "ap214": 4, "ap242": 5}
_UNITS = {"mm": "MM", "inch": "INCH"}
_BARE_MEASURE = re.compile(rb"(=\s*LENGTH_MEASURE_WITH_UNIT)\(\s*([0-9.E+-]+),")


def write_flanks_step(
    path: Path, surfaces: Mapping[str, NurbsSurface], name: str, options: ExportOptions = USUAL
) -> None:
    """Write surfaces as named faces of one part.

    Parameters
    ----------
    path : Path
        Written in place; an existing file is overwritten.
    surfaces : mapping of face name to NurbsSurface
        [mm]
    name : str
        Of the part.
    options : ExportOptions
        Schema and unit; the faces have their names always.

    Raises
    ------
    FileError
        The kernel could not write the file.
    """
    settle()
    document = TDocStd_Document(TCollection_ExtendedString("XmlXCAF"))
    shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    part, builder = TopoDS_Compound(), BRep_Builder()
    builder.MakeCompound(part)
    faces = {face_name: to_face(surface) for face_name, surface in surfaces.items()}
    for face in faces.values():
        builder.Add(part, face)
    label = shapes.AddShape(part, False)
    set_name(label, name)
    for face_name, face in faces.items():
        set_name(shapes.AddSubShape(label, face), face_name)
    if not save_step(path, document, options):
        raise not_written(path, "step")


def save_step(path: Path, document: TDocStd_Document, options: ExportOptions, names: bool = True) -> bool:
    """Write a document with its colours; whether the kernel did."""
    Interface_Static.SetIVal_s("write.step.schema", _SCHEMAS[options.step_schema])
    Interface_Static.SetCVal_s("write.step.unit", _UNITS[options.step_unit])
    writer = STEPCAFControl_Writer()
    writer.SetNameMode(names)
    writer.SetColorMode(options.colors)
    writer.Transfer(document, STEPControl_StepModelType.STEPControl_AsIs)
    if writer.Write(str(path)) != IFSelect_ReturnStatus.IFSelect_RetDone:
        return False
    _name_measures(path)
    return True


def not_written(path: Path, format_: str) -> FileError:
    """Why the kernel did not write a file, as far as it can be found out: it keeps that to itself."""
    text = f"the CAD kernel could not write the {format_.upper()} file and gave no reason; try another format or folder"
    return FileError(path, why_not_written(path, text))


def read_flanks_step(path: Path) -> dict[str, NurbsSurface]:
    """Read the named B-spline faces of a STEP file back [mm]; cones, planes and the like are passed over.

    Raises
    ------
    FileError
        Not a STEP file, or a face that is not valid.
    """
    settle()
    reader = STEPCAFControl_Reader()
    reader.SetNameMode(True)
    if reader.ReadFile(str(path)) != IFSelect_ReturnStatus.IFSelect_RetDone:
        raise FileError(path, "the CAD kernel cannot read this as STEP")
    document = TDocStd_Document(TCollection_ExtendedString("XmlXCAF"))
    reader.Transfer(document)
    shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    roots = Sequence_TDF_Label()
    shapes.GetFreeShapes(roots)
    found: dict[str, NurbsSurface] = {}
    for i in range(1, roots.Length() + 1):
        parts = Sequence_TDF_Label()
        shapes.GetSubShapes_s(roots.Value(i), parts)
        for j in range(1, parts.Length() + 1):
            shape = shapes.GetShape_s(parts.Value(j))
            if shape.ShapeType() == TopAbs_ShapeEnum.TopAbs_FACE:
                if not BRepCheck_Analyzer(shape).IsValid():
                    raise FileError(path, f"face {read_name(parts.Value(j))!r} is not valid after reading back")
                surface = BRep_Tool.Surface_s(TopoDS.Face(shape))
                if isinstance(surface, Geom_BSplineSurface):
                    found[read_name(parts.Value(j))] = to_record(surface)
    return found


@cache
def settle() -> None:
    """The kernel's process-wide settings for STEP, and no chatter on standard output."""
    Message.DefaultMessenger_s().RemovePrinters(Message_PrinterOStream.get_type_descriptor_s())
    STEPCAFControl_Controller.Init_s()
    Interface_Static.SetIVal_s("write.surfacecurve.mode", 0)  # edges as curves in space alone: half the size
    Interface_Static.SetIVal_s("write.stepcaf.subshapes.name", 1)
    Interface_Static.SetIVal_s("read.stepcaf.subshapes.name", 1)


def _name_measures(path: Path) -> None:
    """Give the factor of a converted unit its type, which a choice among measures needs and the kernel leaves out."""
    text = path.read_bytes()
    named = _BARE_MEASURE.sub(rb"\1(LENGTH_MEASURE(\2),", text)
    if named != text:
        path.write_bytes(named)


def read_name(label: TDF_Label) -> str:
    """Name of a label; empty when it has none."""
    attribute = TDataStd_Name()
    return str(attribute.Get().ToExtString()) if label.FindAttribute(TDataStd_Name.GetID_s(), attribute) else ""
