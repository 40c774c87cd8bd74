"""The kernel's ways to make a surface: skin, pipe, interpolation of points; and curves to feed them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from OCP.Approx import Approx_ParametrizationType
from OCP.BRep import BRep_Tool
from OCP.BRepOffsetAPI import BRepOffsetAPI_MakePipeShell, BRepOffsetAPI_ThruSections
from OCP.BRepTools import BRepTools_WireExplorer
from OCP.Geom import Geom_BSplineCurve, Geom_BSplineSurface
from OCP.GeomAPI import GeomAPI_PointsToBSplineSurface
from OCP.gp import gp_Trsf
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopExp import TopExp, TopExp_Explorer
from OCP.TopoDS import TopoDS, TopoDS_Shape
from scipy.interpolate import BSpline, make_interp_spline

from gearstudio.errors import GeometryError
from gearstudio.kernel.convert import CONFUSION_MM, point_grid, to_curve, to_record, to_surface, to_wire
from gearstudio.nurbs import NurbsSurface

Floats = NDArray[np.float64]

_SKIN_MAX_DEGREE = 8
_PIPE_MAX_DEGREE = 8
_PIPE_MAX_SEGMENTS = 100


@dataclass(frozen=True)
class Curve:
    """A B-spline curve held by the kernel."""

    geometry: Geom_BSplineCurve

    def moved(self, matrix: Floats) -> Curve:
        """The same rigid curve after a motion, matrix of shape (3, 4) or (3, 3)."""
        rows = np.column_stack([matrix[:, :3], matrix[:, 3] if matrix.shape[1] == 4 else np.zeros(3)])
        motion = gp_Trsf()
        motion.SetValues(*rows.ravel().tolist())
        return Curve(self.geometry.Transformed(motion))


def curve_through(parameters: Floats, points: Floats, degree: int, flat_start: bool = False) -> Curve:
    """The B-spline curve of a degree that takes points (n, 3) at given parameters (n,).

    With ``flat_start`` its first derivative vanishes at the start, as an involute's does on the base cone
    in the parameter psi; without it noise could turn the curve back there.
    """
    spline = _interpolation(parameters, points, degree, flat_start)
    return Curve(to_curve(spline.c, spline.t, spline.k))


def skin(sections: Sequence[Curve], tolerance: float) -> NurbsSurface:
    """The kernel's skin through compatible curves at evenly spaced parameters.

    Parameters
    ----------
    sections : sequence of Curve
        At v = 0 ... 1, evenly; u is their own parameter.
    tolerance : float
        Within which the skin meets the sections [mm].

    Raises
    ------
    GeometryError
        The kernel made no single surface.
    """
    builder = BRepOffsetAPI_ThruSections(False, False, max(tolerance, CONFUSION_MM))
    builder.CheckCompatibility(False)
    builder.SetParType(Approx_ParametrizationType.Approx_IsoParametric)
    builder.SetMaxDegree(_SKIN_MAX_DEGREE)
    for section in sections:
        builder.AddWire(to_wire(section.geometry))
    return _only_surface(lambda: builder, "skin")


def pipe(profiles: Sequence[Curve], spine: Curve, tolerance: float) -> NurbsSurface:
    """The kernel's pipe: profiles swept along a spine.

    Parameters
    ----------
    profiles : sequence of Curve
        The first stands at the start of the spine, a second at its end.
    spine : Curve
    tolerance : float
        Of the kernel's approximation [mm].

    Raises
    ------
    GeometryError
        The kernel made no single surface: neither with the spine's own frame nor with a discrete one, nor with
        a tolerance a thousand times as wide, which a spine of several turns may need.
    """
    path = to_wire(spine.geometry)
    edge = BRepTools_WireExplorer(path).Current()
    ends = [TopExp.FirstVertex_s(edge, True), TopExp.LastVertex_s(edge, True)]

    def attempt(discrete: bool, tolerance: float) -> NurbsSurface:
        def builder() -> BRepOffsetAPI_MakePipeShell:
            maker = BRepOffsetAPI_MakePipeShell(path)
            if discrete:
                maker.SetDiscreteMode()
            else:
                maker.SetMode(False)
            maker.SetTolerance(tolerance, tolerance, 1e-4)
            maker.SetMaxDegree(_PIPE_MAX_DEGREE)
            maker.SetMaxSegments(_PIPE_MAX_SEGMENTS)
            for profile, end in zip(profiles, ends, strict=False):
                maker.Add(to_wire(profile.geometry), end, False, False)
            return maker

        return _only_surface(builder, "pipe")

    for discrete, wider in ((False, 1.0), (True, 1.0), (False, 1e3)):
        try:
            return attempt(discrete, wider * tolerance)
        except GeometryError:
            continue
    return attempt(True, 1e3 * tolerance)


def interpolated_points(points: Floats) -> NurbsSurface:
    """The kernel's own bicubic interpolation of a grid of points (n_u, n_v, 3), at parameters of its own choice.

    Raises
    ------
    GeometryError
        The kernel did not interpolate them.
    """
    maker = GeomAPI_PointsToBSplineSurface()
    maker.Interpolate(point_grid(points))
    if not maker.IsDone():
        raise GeometryError("the kernel's interpolation of the points failed")
    return to_record(maker.Surface())


def reconstructed(u: Floats, v: Floats, points: Floats, degree: int, flat_start: bool = False) -> NurbsSurface:
    """The tensor-product B-spline of a degree that takes points (n_u, n_v, 3) at given (u, v).

    ``flat_start`` as in `curve_through`, for every line along u.
    """
    along_u = _interpolation(u, points, degree, flat_start)
    along_v = _interpolation(v, along_u.c.transpose(1, 0, 2), degree, flat_start=False)
    record = NurbsSurface(along_v.c.transpose(1, 0, 2), along_u.t, along_v.t, along_u.k, along_v.k)
    return to_record(to_surface(record))


def _interpolation(parameters: Floats, values: Floats, degree: int, flat_start: bool) -> BSpline:
    degree = min(degree, len(parameters) - 1)
    if not flat_start:
        return make_interp_spline(parameters, values, k=degree)
    sites = np.r_[parameters[0], parameters]
    inner = [sites[i + 1 : i + 1 + degree].mean() for i in range(len(sites) - degree - 1)]
    knots = np.r_[[sites[0]] * (degree + 1), inner, [sites[-1]] * (degree + 1)]
    flat = [(1, np.zeros(values.shape[1:]))]
    return make_interp_spline(parameters, values, k=degree, t=knots, bc_type=(flat, None))


def oriented(surface: NurbsSurface, corners: Floats) -> NurbsSurface:
    """The same surface over [0, 1]², turned so that its corners come nearest to the given ones.

    Parameters
    ----------
    surface : NurbsSurface
    corners : ndarray, shape (2, 2, 3)
        Wanted at (u, v) = (0, 0), (0, 1); (1, 0), (1, 1).
    """
    candidates = [_unit_domain(turned) for turned in _all_turns(surface)]
    return min(candidates, key=lambda s: float(np.sum((s.grid([0, 1], [0, 1]) - corners) ** 2)))


def _all_turns(s: NurbsSurface) -> list[NurbsSurface]:
    turns = []
    for swapped in (False, True):
        weights = s.weights
        if swapped:
            weights = None if weights is None else weights.T
            s = NurbsSurface(s.poles.transpose(1, 0, 2), s.knots_v, s.knots_u, s.degree_v, s.degree_u, weights)
        for flip_u in (False, True):
            for flip_v in (False, True):
                pick = (slice(None, None, -1 if flip_u else 1), slice(None, None, -1 if flip_v else 1))
                turns.append(
                    NurbsSurface(
                        s.poles[pick],
                        _flipped(s.knots_u) if flip_u else s.knots_u,
                        _flipped(s.knots_v) if flip_v else s.knots_v,
                        s.degree_u,
                        s.degree_v,
                        None if s.weights is None else s.weights[pick],
                    )
                )
    return turns


def _flipped(knots: Floats) -> Floats:
    return np.asarray((knots[0] + knots[-1] - knots)[::-1])


def _unit_domain(s: NurbsSurface) -> NurbsSurface:
    u0, u1, v0, v1 = s.bounds
    return NurbsSurface(
        s.poles, (s.knots_u - u0) / (u1 - u0), (s.knots_v - v0) / (v1 - v0), s.degree_u, s.degree_v, s.weights
    )


def _only_surface(builder: Callable[[], Any], what: str) -> NurbsSurface:
    """Run a sweeping builder of the kernel and take the one surface out of its shape."""
    try:
        maker = builder()
        maker.Build()
        shape = maker.Shape()
    except Exception as error:  # the kernel's exceptions share no base class, only their home
        if not type(error).__module__.startswith("OCP"):
            raise
        raise GeometryError(f"the kernel's {what} failed: {str(error).splitlines()[0]}") from error
    faces = _faces(shape)
    if len(faces) != 1:
        raise GeometryError(f"the kernel's {what} gave {len(faces)} faces where one was expected")
    return to_record(faces[0])


def _faces(shape: TopoDS_Shape) -> list[Geom_BSplineSurface]:
    explorer = TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_FACE)
    surfaces = []
    while explorer.More():
        surfaces.append(BRep_Tool.Surface_s(TopoDS.Face(explorer.Current())))
        explorer.Next()
    return surfaces
