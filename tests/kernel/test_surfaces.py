"""Surfaces carried out of the kernel and back: equal to the last digits, valid faces, honest refusals."""

from __future__ import annotations

import numpy as np
import pytest
from OCP.BRep import BRep_Tool
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.gp import gp_Pnt
from OCP.ShapeAnalysis import ShapeAnalysis_Surface

from gearstudio.analysis.comparison import build_variant
from gearstudio.catalogue import MEMBERS, VARIANTS
from gearstudio.design import Design
from gearstudio.errors import GeometryError
from gearstudio.kernel.convert import to_face, to_record, to_surface
from gearstudio.kernel.surfaces import curve_through, interpolated_points, oriented, pipe, reconstructed, skin
from gearstudio.methods import METHODS
from gearstudio.nurbs import NurbsSurface, basis_matrix
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.involute_flank import involute_flank

pytestmark = pytest.mark.kernel


def sphere_octant() -> NurbsSurface:
    """The textbook rational patch: a quarter circle turned by a quarter, radius 10."""
    w = np.sqrt(0.5)
    arc = np.array([[10.0, 0.0], [10.0, 10.0], [0.0, 10.0]])  # (radius, height)
    turn = np.array([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    poles = np.array([[[r * x, r * y, h] for x, y in turn] for r, h in arc])
    weights = np.outer([1, w, 1], [1, w, 1])
    knots = np.array([0.0, 0.0, 0.0, 1.0, 1.0, 1.0])
    return NurbsSurface(poles, knots, knots, 2, 2, weights)


def at_kernel(surface: NurbsSurface, u: np.ndarray, v: np.ndarray) -> np.ndarray:
    """The kernel's own evaluation on a grid."""
    geometry, point = to_surface(surface), gp_Pnt()
    points = np.empty((len(u), len(v), 3))
    for i, a in enumerate(u.tolist()):
        for j, b in enumerate(v.tolist()):
            geometry.D0(a, b, point)
            points[i, j] = point.X(), point.Y(), point.Z()
    return points


@pytest.mark.parametrize("member", MEMBERS)
@pytest.mark.parametrize("variant", VARIANTS)
@pytest.mark.parametrize("method", METHODS, ids=[m.info.id for m in METHODS])
def test_the_record_is_the_kernels_surface(method, variant: str, member: str) -> None:
    u, v = np.r_[0.0, 0.123, 0.5, 0.77, 1.0], np.r_[0.0, 0.31, 0.9, 1.0]
    for flank in build_variant(Design(), member, method.info.id, variant).flanks.values():
        assert np.abs(flank.surface.grid(u, v) - at_kernel(flank.surface, u, v)).max() < 1e-12
        pairs = flank.surface.points(u[:, None], v[None, :])
        assert np.abs(pairs - flank.surface.grid(u, v)).max() < 1e-12
        again = to_record(to_surface(flank.surface))
        assert np.array_equal(again.poles, flank.surface.poles)
        assert np.array_equal(again.knots_u, flank.surface.knots_u)
        assert np.array_equal(again.knots_v, flank.surface.knots_v)


@pytest.mark.parametrize("member", MEMBERS)
@pytest.mark.parametrize("variant", VARIANTS)
@pytest.mark.parametrize("method", METHODS, ids=[m.info.id for m in METHODS])
def test_faces_are_valid_and_end_at_the_natural_bounds(method, variant: str, member: str) -> None:
    for flank in build_variant(Design(), member, method.info.id, variant).flanks.values():
        face = to_face(flank.surface)
        assert BRepCheck_Analyzer(face).IsValid()
        bounds = ShapeAnalysis_Surface(BRep_Tool.Surface_s(face)).Bounds()
        assert bounds == pytest.approx((0.0, 1.0, 0.0, 1.0), abs=1e-14)


def test_rational_surfaces() -> None:
    surface = sphere_octant()
    u, v = np.linspace(0, 1, 7), np.linspace(0, 1, 9)
    points = surface.grid(u, v)
    assert np.linalg.norm(points, axis=-1) == pytest.approx(np.full((7, 9), 10.0), abs=1e-13)
    assert np.abs(points - at_kernel(surface, u, v)).max() < 1e-13
    assert np.abs(points - surface.points(u[:, None], v[None, :])).max() < 1e-13
    again = to_record(to_surface(surface))
    assert again.weights == pytest.approx(surface.weights)
    assert surface.uniform_grid(7, 9) == pytest.approx(points)


def test_basis_functions_sum_to_one_and_their_derivatives_to_nothing() -> None:
    knots = np.r_[[0.0] * 4, 0.2, 0.5, 0.5, 0.9, [1.0] * 4]
    places = np.linspace(0, 1, 31)
    assert basis_matrix(places, knots, 3).sum(axis=1) == pytest.approx(np.ones(31), abs=1e-14)
    assert basis_matrix(places, knots, 3, derivative=1).sum(axis=1) == pytest.approx(np.zeros(31), abs=1e-11)


@pytest.mark.parametrize("turn", range(8))
def test_oriented_brings_corners_where_they_are_wanted(turn: int) -> None:
    flank = involute_flank(pair_geometry(Design()).wheel, "convex")
    grid = flank.evenly_divided(6, 5)
    wanted = grid[np.ix_([0, -1], [0, -1])]
    given = grid.transpose(1, 0, 2) if turn & 1 else grid
    given = given[:: -1 if turn & 2 else 1, :: -1 if turn & 4 else 1]
    surface = oriented(interpolated_points(given), wanted)
    assert np.abs(surface.grid([0.0, 1.0], [0.0, 1.0]) - wanted).max() < 1e-9
    assert surface.bounds == (0.0, 1.0, 0.0, 1.0)


def test_a_flat_start_has_no_derivative_there_and_takes_every_point() -> None:
    flank = involute_flank(pair_geometry(Design()).pinion, "concave")
    u, v = np.linspace(0, 1, 9), np.linspace(0, 1, 6)
    points = flank.points(u[:, None], v[None, :])
    surface = reconstructed(u, v, points, 5, flat_start=True)
    assert np.abs(surface.grid(u, v) - points).max() < 1e-12
    assert np.abs(surface.poles[1] - surface.poles[0]).max() < 1e-12


def test_a_moved_curve_is_the_same_curve() -> None:
    points = np.array([[0.0, 0.0, 0.0], [1.0, 0.5, 0.0], [2.0, 0.0, 1.0], [3.0, 1.0, 1.0]])
    curve = curve_through(np.linspace(0, 1, 4), points, 3)
    c, s = np.cos(0.7), np.sin(0.7)
    motion = np.array([[c, -s, 0.0, 5.0], [s, c, 0.0, -2.0], [0.0, 0.0, 1.0, 1.0]])
    surface = skin([curve, curve.moved(motion)], 1e-7)
    u = np.array([0.0, 1 / 3, 2 / 3, 1.0])
    ends = surface.grid(u, np.array(surface.bounds[2:]))
    assert ends[:, 0] == pytest.approx(points, abs=1e-9)
    assert ends[:, 1] == pytest.approx(points @ motion[:, :3].T + motion[:, 3], abs=1e-9)


def test_what_the_kernel_cannot_sweep_is_a_geometry_error() -> None:
    point = np.zeros((4, 3)) + np.linspace(0, 1e-9, 4)[:, None]
    degenerate = [[0.0, 0.0, 0.0], [0.0, 0.0, 1e-9]]
    with pytest.raises(GeometryError):
        pipe(
            [curve_through(np.linspace(0, 1, 4), point, 3)],
            curve_through(np.array([0.0, 1.0]), np.array(degenerate), 1),
            1e-7,
        )
