"""The paper's way to a gear: tooth spaces cut from the turned blank by Booleans."""

from __future__ import annotations

from collections.abc import Callable, Sequence
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
from gearstudio.kernel.solids import measured_gap
from gearstudio.kernel.turned import TurnedBody

Report = Callable[[str, float], None]
Solid = TopoDS_Solid
Face = TopoDS_Face

_AT_ONCE = 8


@dataclass(frozen=True)
class CutGear:
    """A solid cut from a blank, and which of its faces the others have left.

    Attributes
    ----------
    spaces : tuple
        By tooth space and face of the space.
    blank : dict of int to tuple
        By side of the blank.
    gap : float
        Largest between neighbouring faces, as measured along every edge [mm].
    """

    solid: TopoDS_Solid
    spaces: tuple[tuple[tuple[TopoDS_Face, ...], ...], ...]
    blank: dict[int, tuple[TopoDS_Face, ...]]
    gap: float


def cut_spaces(blank: TurnedBody, space: GearShell, teeth: int, report: Report) -> CutGear:
    """Cut a tooth space, turned to every pitch, from a blank.

    Parameters
    ----------
    blank : TurnedBody
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
    report("placing the tooth spaces", 0.04)
    tools, spaces = [], []
    for index in range(teeth):
        turned = BRepBuilderAPI_Transform(space.solid, _turn(2 * np.pi * index / teeth), True)
        tools.append(turned.Shape())
        spaces.append([[turned.ModifiedShape(face)] for face in space.tooth_faces[0]])
    body: TopoDS_Shape = blank.solid
    sides = {side: [face] for side, face in blank.faces.items()}
    groups = [*sides.values(), *(group for space in spaces for group in space)]
    for first in range(0, teeth, _AT_ONCE):
        last = min(first + _AT_ONCE, teeth)
        report(f"cutting tooth spaces {first + 1} to {last} of {teeth}", 0.05 + 0.85 * first / teeth)
        body = _cut(body, tools[first:last], groups)
    report("collecting the gear", 0.9)
    solids = parts(body, TopAbs_ShapeEnum.TopAbs_SOLID)
    if len(solids) != 1:
        raise GeometryError(f"cutting the tooth spaces left {len(solids)} solids instead of one")
    report("measuring the gaps", 0.95)
    return CutGear(
        TopoDS.Solid(solids[0]),
        tuple(tuple(tuple(map(TopoDS.Face, group)) for group in space) for space in spaces),
        {side: tuple(map(TopoDS.Face, group)) for side, group in sides.items()},
        measured_gap(solids[0]),
    )


def _cut(body: TopoDS_Shape, tools: Sequence[TopoDS_Shape], groups: Sequence[list[TopoDS_Shape]]) -> TopoDS_Shape:
    """One Boolean; groups of faces are brought up to date."""
    arguments, knives = List_TopoDS_Shape(), List_TopoDS_Shape()
    arguments.Append(body)
    for tool in tools:
        knives.Append(tool)
    cutter = BRepAlgoAPI_Cut()
    cutter.SetArguments(arguments)
    cutter.SetTools(knives)
    cutter.SetRunParallel(True)
    cutter.SetUseOBB(True)
    cutter.Build()
    if not cutter.IsDone():
        raise GeometryError("the kernel could not cut the tooth spaces from the blank")
    for group in groups:
        left = [(face, cutter.Modified(face)) for face in group]
        group[:] = [new for face, made in left for new in (list(made) or [face] * (not cutter.IsDeleted(face)))]
    return cutter.Shape()


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
