"""Faces of revolution between circles about the axis, and bodies made of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from OCP.Geom import Geom_Surface
from OCP.Geom2d import Geom2d_Curve
from OCP.gp import gp_Pnt2d
from OCP.TopoDS import TopoDS_Edge, TopoDS_Face, TopoDS_Solid, TopoDS_Vertex

from gearstudio.kernel.convert import CONFUSION_MM
from gearstudio.kernel.maker import HERE, Maker, Point
from gearstudio.kernel.revolved import TURN, Revolved, circle

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Ring:
    """A circle of the body; on the axis there is none."""

    point: Point
    seam: float
    edge: TopoDS_Edge | None
    vertex: TopoDS_Vertex | None

    @staticmethod
    def of(maker: Maker, point: Point, seam: float) -> Ring:
        """The circle through (radius, height), cut open at an azimuth."""
        radius, height = point
        if radius <= CONFUSION_MM:
            return Ring((0.0, height), seam, None, None)
        vertex = maker.vertex(np.array([radius * np.cos(seam), radius * np.sin(seam), height]), 0.0)
        return Ring(point, seam, maker.edge(circle(radius, height, seam), (0.0, TURN), vertex, vertex), vertex)


def turned_face(maker: Maker, here: Ring, there: Ring, sphere: bool = False) -> TopoDS_Face:
    """Add the face between two rings, told in the order that has the metal on the left."""
    revolved = Revolved(here.point, there.point, here.seam, sphere)
    surface = revolved.geometry()
    wires: list[list[tuple[TopoDS_Edge, bool]]] = []
    for ring, forward in ((here, True), (there, False)):
        if ring.edge is not None:
            maker.lay(ring.edge, _Placed(revolved, ring).trace(), surface)
            wires.append([(ring.edge, forward)])
    if not revolved.is_plane:
        seam = seam_edge(maker, revolved, surface, here.point, there.point, here.vertex, there.vertex)
        wires = [[wires[0][0], (seam, True), wires[1][0], (seam, False)]]
    return maker.face(surface, wires, revolved.outward)


@dataclass(frozen=True)
class _Placed:
    """A ring on a surface of revolution, whose azimuths may begin elsewhere."""

    revolved: Revolved
    ring: Ring

    def trace(self) -> Geom2d_Curve:
        """Curve of the ring on the surface."""
        trace = self.revolved.circle_on(*self.ring.point)
        if self.revolved.is_plane:
            trace = trace.Rotated(gp_Pnt2d(0.0, 0.0), self.ring.seam - self.revolved.seam)
        return trace


def seam_edge(
    maker: Maker,
    revolved: Revolved,
    surface: Geom_Surface,
    start: Point,
    end: Point,
    start_vertex: TopoDS_Vertex,
    end_vertex: TopoDS_Vertex,
) -> TopoDS_Edge:
    """The edge along which a turned face is cut open; it grows with the surface's v."""
    curve, low, high = revolved.meridian(start, end)
    if revolved.v_at(*start) > revolved.v_at(*end):
        start_vertex, end_vertex = end_vertex, start_vertex
    edge = maker.edge(curve, (low, high), start_vertex, end_vertex)
    traces = [revolved.meridian_on(start, end, turned) for turned in (True, False)]
    maker.builder.UpdateEdge(edge, *traces, surface, HERE, CONFUSION_MM)
    return edge


@dataclass(frozen=True)
class TurnedBody:
    """A body of revolution, and its face for each side of the outline that does not lie on the axis."""

    solid: TopoDS_Solid
    faces: dict[int, TopoDS_Face]


def turned_solid(points: Floats, sphere: Sequence[bool], seam: float) -> TurnedBody:
    """The body of revolution of a closed outline.

    Parameters
    ----------
    points : ndarray, shape (n, 2)
        (radius, height) [mm], in the order of a gear's outline: tooth, heel, body, toe.
    sphere : sequence of bool
        For each side, from point i to the next, whether it is part of a sphere about the apex.
    seam : float
        Azimuth at which its faces are cut open [rad].
    """
    maker = Maker()
    rings = [Ring.of(maker, (float(r), float(z)), seam) for r, z in points]
    faces = {}
    for side, (here, there, round_) in enumerate(zip(rings, [*rings[1:], rings[0]], sphere, strict=True)):
        if here.edge is not None or there.edge is not None:
            faces[side] = turned_face(maker, here, there, round_)
    return TurnedBody(maker.solid(), faces)
