"""The paper's way to a gear: tooth spaces cut from the turned blank by Booleans."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from OCP.BRep import BRep_Builder
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
from OCP.collections import List_TopoDS_Shape
from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt, gp_Trsf
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS, TopoDS_Compound, TopoDS_Shape, TopoDS_Solid

from gearstudio.errors import GeometryError

Report = Callable[[str, float], None]
Solid = TopoDS_Solid


def cut_spaces(blank: TopoDS_Solid, space: TopoDS_Solid, teeth: int, report: Report) -> TopoDS_Solid:
    """Cut a tooth space, turned to every pitch, from a blank.

    Parameters
    ----------
    blank, space : TopoDS_Solid
    teeth : int
    report : callable
        Takes the stage that begins and the fraction done.

    Raises
    ------
    GeometryError
        The Boolean failed or left other than one solid.
    """
    report("placing the tooth spaces", 0.0)
    tools = List_TopoDS_Shape()
    for index in range(teeth):
        tools.Append(_turned(space, 2 * np.pi * index / teeth))
    blanks = List_TopoDS_Shape()
    blanks.Append(blank)
    report("cutting the tooth spaces from the blank", 0.05)
    cutter = BRepAlgoAPI_Cut()
    cutter.SetArguments(blanks)
    cutter.SetTools(tools)
    cutter.SetRunParallel(True)
    cutter.Build()
    if not cutter.IsDone():
        raise GeometryError("the kernel could not cut the tooth spaces from the blank")
    report("collecting the gear", 0.95)
    solids = parts(cutter.Shape(), TopAbs_ShapeEnum.TopAbs_SOLID)
    if len(solids) != 1:
        raise GeometryError(f"cutting the tooth spaces left {len(solids)} solids instead of one")
    return TopoDS.Solid(solids[0])


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


def _turned(solid: TopoDS_Solid, angle: float) -> TopoDS_Shape:
    turn = gp_Trsf()
    turn.SetRotation(gp_Ax1(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(0.0, 0.0, 1.0)), angle)
    return BRepBuilderAPI_Transform(solid, turn, True).Shape()
