"""Between numpy arrays and the kernel's own collections."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakeWire
from OCP.collections import Array1_double, Array1_gp_Pnt, Array1_gp_Pnt2d, Array1_int, Array2_double, Array2_gp_Pnt
from OCP.Geom import Geom_BSplineCurve, Geom_BSplineSurface
from OCP.gp import gp_Pnt, gp_Pnt2d
from OCP.TopoDS import TopoDS_Face, TopoDS_Wire

from gearstudio.errors import GeometryError
from gearstudio.nurbs import NurbsSurface

Floats = NDArray[np.float64]

CONFUSION_MM = 1e-7
"""Two points nearer than this are one point to the kernel."""


def point_row(points: Floats) -> Array1_gp_Pnt:
    """Points of shape (n, 3) as a kernel array."""
    row = Array1_gp_Pnt(1, len(points))
    for i, (x, y, z) in enumerate(points.tolist(), start=1):
        row.SetValue(i, gp_Pnt(x, y, z))
    return row


def point_row_2d(points: Floats) -> Array1_gp_Pnt2d:
    """Points of shape (n, 2) as a kernel array."""
    row = Array1_gp_Pnt2d(1, len(points))
    for i, (x, y) in enumerate(points.tolist(), start=1):
        row.SetValue(i, gp_Pnt2d(x, y))
    return row


def point_grid(points: Floats) -> Array2_gp_Pnt:
    """Points of shape (n_u, n_v, 3) as a kernel array."""
    grid = Array2_gp_Pnt(1, points.shape[0], 1, points.shape[1])
    for i, row in enumerate(points.tolist(), start=1):
        for j, (x, y, z) in enumerate(row, start=1):
            grid.SetValue(i, j, gp_Pnt(x, y, z))
    return grid


def numbers(row: Array1_double) -> tuple[float, ...]:
    """A kernel array's numbers, several times as fast as by its own iterator."""
    return tuple(map(row.Value, range(row.Lower(), row.Upper() + 1)))


def knots_and_multiplicities(knots: Floats) -> tuple[Array1_double, Array1_int]:
    """A written-out knot vector as the kernel's distinct knots and multiplicities."""
    distinct, counts = np.unique(knots, return_counts=True)
    values, multiplicities = Array1_double(1, len(distinct)), Array1_int(1, len(distinct))
    for i, (knot, count) in enumerate(zip(distinct.tolist(), counts.tolist(), strict=True), start=1):
        values.SetValue(i, knot)
        multiplicities.SetValue(i, count)
    return values, multiplicities


def to_curve(poles: Floats, knots: Floats, degree: int) -> Geom_BSplineCurve:
    """A kernel curve from poles (n, 3), written-out clamped knots and degree."""
    return Geom_BSplineCurve(point_row(poles), *knots_and_multiplicities(knots), degree)


def to_surface(surface: NurbsSurface) -> Geom_BSplineSurface:
    """A kernel surface equal to the record."""
    u_knots, u_counts = knots_and_multiplicities(surface.knots_u)
    v_knots, v_counts = knots_and_multiplicities(surface.knots_v)
    poles: list[Any] = [point_grid(surface.poles)]
    if surface.weights is not None:
        weights = Array2_double(1, surface.weights.shape[0], 1, surface.weights.shape[1])
        for (i, j), weight in np.ndenumerate(surface.weights):
            weights.SetValue(i + 1, j + 1, float(weight))
        poles.append(weights)
    return Geom_BSplineSurface(*poles, u_knots, v_knots, u_counts, v_counts, surface.degree_u, surface.degree_v)


def to_record(surface: Geom_BSplineSurface) -> NurbsSurface:
    """The kernel's surface as a record; weights that are all alike are dropped."""
    n_u, n_v = surface.NbUPoles(), surface.NbVPoles()
    grid = surface.Poles()
    poles = np.empty((n_u, n_v, 3))
    for i in range(n_u):
        for j in range(n_v):
            poles[i, j] = grid.Value(i + 1, j + 1).Coord()
    weights = None
    if surface.IsURational() or surface.IsVRational():
        weights = np.array([[surface.Weight(i + 1, j + 1) for j in range(n_v)] for i in range(n_u)])
        if np.ptp(weights) <= 1e-14 * weights.max():
            weights = None
    u_knots, v_knots = np.array(numbers(surface.UKnotSequence())), np.array(numbers(surface.VKnotSequence()))
    return NurbsSurface(poles, u_knots, v_knots, surface.UDegree(), surface.VDegree(), weights)


def to_wire(curve: Geom_BSplineCurve) -> TopoDS_Wire:
    """The whole curve as a wire of one edge."""
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve).Edge()).Wire()


def to_face(surface: NurbsSurface) -> TopoDS_Face:
    """A face with the surface's natural bounds.

    Raises
    ------
    GeometryError
        The kernel refuses the surface.
    """
    maker = BRepBuilderAPI_MakeFace(to_surface(surface), CONFUSION_MM)
    if not maker.IsDone():
        raise GeometryError(f"the CAD kernel made no face of the surface ({maker.Error()})")
    return maker.Face()
