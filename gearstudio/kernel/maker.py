"""The kernel's builder: vertices, edges, faces and the closed shell they make."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray
from OCP.BRep import BRep_Builder
from OCP.Geom import Geom_Curve, Geom_Surface
from OCP.Geom2d import Geom2d_Curve
from OCP.gp import gp_Pnt
from OCP.TopAbs import TopAbs_Orientation
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS, TopoDS_Edge, TopoDS_Face, TopoDS_Shell, TopoDS_Solid, TopoDS_Vertex, TopoDS_Wire

from gearstudio.kernel.convert import CONFUSION_MM

Floats = NDArray[np.float64]
Point = tuple[float, float]

_FORWARD, _REVERSED = TopAbs_Orientation.TopAbs_FORWARD, TopAbs_Orientation.TopAbs_REVERSED
HERE = TopLoc_Location()
_MARGIN = 1.5


class Maker:
    """The kernel's builder, the shell it fills, and the largest gap it had to bridge."""

    def __init__(self) -> None:
        self.builder = BRep_Builder()
        self.shell = TopoDS_Shell()
        self.builder.MakeShell(self.shell)
        self.gap = 0.0

    def vertex(self, point: Floats, gap: float) -> TopoDS_Vertex:
        """A vertex that covers a gap [mm]."""
        vertex = TopoDS_Vertex()
        self.builder.MakeVertex(vertex, gp_Pnt(*point.tolist()), self._tolerance(gap))
        return vertex

    def edge(
        self, curve: Geom_Curve, span: Point, start: TopoDS_Vertex, end: TopoDS_Vertex, gap: float = 0.0
    ) -> TopoDS_Edge:
        """An edge over a range of its curve, covering a gap [mm] to its neighbours."""
        edge = TopoDS_Edge()
        self.builder.MakeEdge(edge, curve, self._tolerance(gap))
        self.builder.Add(edge, start.Oriented(_FORWARD))
        self.builder.Add(edge, end.Oriented(_REVERSED))
        self.builder.Range(edge, *span)
        return edge

    def lay(self, edge: TopoDS_Edge, trace: Geom2d_Curve, surface: Geom_Surface, gap: float = 0.0) -> None:
        """Give an edge its curve on a surface."""
        self.builder.UpdateEdge(edge, trace, surface, HERE, self._tolerance(gap))

    def face(
        self, surface: Geom_Surface, wires: Iterable[Sequence[tuple[TopoDS_Edge, bool]]], outward: bool
    ) -> TopoDS_Face:
        """Add a face to the shell; edges are told as they run seen from outside the metal."""
        face = TopoDS_Face()
        self.builder.MakeFace(face, surface, CONFUSION_MM)
        for uses in wires:
            wire = TopoDS_Wire()
            self.builder.MakeWire(wire)
            for edge, forward in uses if outward else reversed(uses):
                self.builder.Add(wire, edge.Oriented(_FORWARD if forward == outward else _REVERSED))
            wire.Closed(True)
            self.builder.Add(face, wire)
        face = face if outward else TopoDS.Face(face.Reversed())
        self.builder.Add(self.shell, face)
        return face

    def solid(self, inside_out: bool = False) -> TopoDS_Solid:
        """The closed shell as a solid; ``inside_out`` turns faces that look inward."""
        self.shell.Closed(True)
        solid = TopoDS_Solid()
        self.builder.MakeSolid(solid)
        self.builder.Add(solid, self.shell.Reversed() if inside_out else self.shell)
        return solid

    def _tolerance(self, gap: float) -> float:
        self.gap = max(self.gap, gap)
        return max(CONFUSION_MM, _MARGIN * gap)
