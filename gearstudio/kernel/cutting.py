"""The paper's way to a gear: tooth spaces cut from the turned blank by Booleans."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from OCP.BRep import BRep_Builder
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
from OCP.collections import List_TopoDS_Shape
from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt, gp_Trsf
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS, TopoDS_Compound, TopoDS_Face, TopoDS_Shape, TopoDS_Solid

from gearstudio.errors import GeometryError
from gearstudio.kernel.shell import GearShell

Report = Callable[[str, float], None]
Solid = TopoDS_Solid
Face = TopoDS_Face


@dataclass(frozen=True)
class CutGear:
    """A solid cut from a blank, and which of its faces each face of each tooth space left, by space and face."""

    solid: TopoDS_Solid
    spaces: tuple[tuple[tuple[TopoDS_Face, ...], ...], ...]


def cut_spaces(blank: TopoDS_Solid, space: GearShell, teeth: int, report: Report) -> CutGear:
    """Cut a tooth space, turned to every pitch, from a blank.

    Parameters
    ----------
    blank : TopoDS_Solid
    space : GearShell
        Of one tooth space.
    teeth : int
    report : callable
        Takes the stage that begins and the fraction done.

    Raises
    ------
    GeometryError
        The Boolean failed or left other than one solid.
    """
    report("placing the tooth spaces", 0.0)
    tools, faces = List_TopoDS_Shape(), []
    for index in range(teeth):
        turned = BRepBuilderAPI_Transform(space.solid, _turn(2 * np.pi * index / teeth), True)
        tools.Append(turned.Shape())
        faces.append([turned.ModifiedShape(face) for face in space.tooth_faces[0]])
    blanks = List_TopoDS_Shape()
    blanks.Append(blank)
    report("cutting the tooth spaces from the blank", 0.05)
    cutter = BRepAlgoAPI_Cut()
    cutter.SetArguments(blanks)
    cutter.SetTools(tools)
    cutter.SetRunParallel(True)
    cutter.SetUseOBB(True)
    cutter.Build()
    if not cutter.IsDone():
        raise GeometryError("the kernel could not cut the tooth spaces from the blank")
    report("collecting the gear", 0.95)
    solids = parts(cutter.Shape(), TopAbs_ShapeEnum.TopAbs_SOLID)
    if len(solids) != 1:
        raise GeometryError(f"cutting the tooth spaces left {len(solids)} solids instead of one")
    left = tuple(tuple(tuple(map(TopoDS.Face, cutter.Modified(face))) for face in tool) for tool in faces)
    return CutGear(TopoDS.Solid(solids[0]), left)


def compound(shapes: list[TopoDS_Shape]) -> TopoDS_Shape:
    """Several shapes as one."""
    made, builder = TopoDS_Compound(), BRep_Builder()
    builder.MakeCompound(made)
    for shape in shapes:
        builder.Add(made, shape)
    return made


def parts(shape: TopoDS_Shape, kind: TopAbs_ShapeEnum) -> list[TopoDS_Shape]:
    """All parts of a kind, each once for every use."""
    explorer, found = TopExp_Explorer(shape, kind), []
    while explorer.More():
        found.append(explorer.Current())
        explorer.Next()
    return found


def _turn(angle: float) -> gp_Trsf:
    turn = gp_Trsf()
    turn.SetRotation(gp_Ax1(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(0.0, 0.0, 1.0)), angle)
    return turn
