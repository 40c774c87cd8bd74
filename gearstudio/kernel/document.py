"""Parts with names, colours and places as a document of the kernel, for formats that carry product structure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from OCP.gp import gp_Trsf
from OCP.Quantity import Quantity_Color, Quantity_TypeOfColor
from OCP.TCollection import TCollection_ExtendedString
from OCP.TDataStd import TDataStd_Name
from OCP.TDF import TDF_Label
from OCP.TDocStd import TDocStd_Document
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS_Face, TopoDS_Shape, TopoDS_Solid
from OCP.XCAFDoc import XCAFDoc_ColorType, XCAFDoc_DocumentTool

from gearstudio.theory.place import Place

Color = tuple[float, float, float]


@dataclass(frozen=True)
class Part:
    """A solid to hand on.

    Attributes
    ----------
    name : str
    solid : TopoDS_Solid
    volume : float
        [mm^3], to know it again by.
    faces : tuple of (str, TopoDS_Face)
        Those that have a name.
    color : (float, float, float)
        Red, green, blue, 0 to 1.
    face_colors : tuple of (str, color)
        Of faces whose name ends in a word.
    place : Place or None
        Where it stands in an assembly.
    """

    name: str
    solid: TopoDS_Solid
    volume: float
    faces: tuple[tuple[str, TopoDS_Face], ...] = ()
    color: Color = (0.72, 0.74, 0.78)
    face_colors: tuple[tuple[str, Color], ...] = ()
    place: Place | None = None


def location(place: Place | None) -> TopLoc_Location:
    """A place as the kernel's location."""
    if place is None:
        return TopLoc_Location()
    motion = gp_Trsf()
    motion.SetValues(*np.column_stack([place.matrix, place.shift]).ravel().tolist())
    return TopLoc_Location(motion)


def located(part: Part) -> TopoDS_Shape:
    """The part's solid where it stands."""
    return part.solid.Located(location(part.place))


def make_document(name: str, parts: Sequence[Part], face_names: bool = True) -> TDocStd_Document:
    """One part, or an assembly of several, with the names and colours of parts and, if wanted, names of faces."""
    document = TDocStd_Document(TCollection_ExtendedString("XmlXCAF"))
    shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    labels = [_add(document, part, face_names) for part in parts]
    if len(parts) > 1:
        whole = shapes.NewShape()
        set_name(whole, name)
        for label, part in zip(labels, parts, strict=True):
            set_name(shapes.AddComponent(whole, label, location(part.place)), part.name)
        shapes.UpdateAssemblies()
    return document


def set_name(label: TDF_Label, text: str) -> None:
    """Name a label; any letters."""
    TDataStd_Name.Set_s(label, TCollection_ExtendedString(text, True))


def _add(document: TDocStd_Document, part: Part, face_names: bool) -> TDF_Label:
    shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    colors = XCAFDoc_DocumentTool.ColorTool_s(document.Main())
    label = shapes.AddShape(part.solid, False)
    set_name(label, part.name)
    colors.SetColor(label, _color(part.color), XCAFDoc_ColorType.XCAFDoc_ColorSurf)
    for name, face in part.faces:
        sub = shapes.AddSubShape(label, face)
        if sub.IsNull():
            continue
        if face_names:
            set_name(sub, name)
        for word, color in part.face_colors:
            if name.endswith(word):
                colors.SetColor(sub, _color(color), XCAFDoc_ColorType.XCAFDoc_ColorSurf)
    return label


def _color(color: Color) -> Quantity_Color:
    return Quantity_Color(*color, Quantity_TypeOfColor.Quantity_TOC_sRGB)
