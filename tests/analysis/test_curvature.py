"""Curvature against closed forms, of theory and of surfaces."""

from __future__ import annotations

import numpy as np
import pytest

from gearstudio.analysis.comparison import build_variant
from gearstudio.analysis.curvature import (
    CurvatureMap,
    curvature_difference,
    surface_curvature,
    surface_derivatives,
    theory_curvature,
    theory_curvature_at,
)
from gearstudio.catalogue import MEMBERS
from gearstudio.design import Design
from gearstudio.errors import GeometryError
from gearstudio.nurbs import NurbsSurface
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.involute_flank import InvoluteFlank, involute_flank
from gearstudio.theory.modified import flank_of
from tests.designs import GOLDEN

PARTS = ("gaussian", "mean", "largest", "smallest")
U, V = np.meshgrid(np.linspace(0.1, 1.0, 7), np.linspace(0.0, 1.0, 6), indexing="ij")


MICRO = {
    "lengthwise_crowning_um": 20.0,
    "profile_crowning_um": 10.0,
    "spiral_angle_correction_um": 8.0,
    "pressure_angle_correction_um": -6.0,
    "bias_um": 12.0,
}


def flanks(name: str, taken_off: dict[str, float] | None = None) -> list[InvoluteFlank]:
    flat = GOLDEN[name][0].model_dump()
    every = {member: dict.fromkeys(FLANKS, taken_off or {}) for member in MEMBERS}
    pair = pair_geometry(Design.model_validate({**flat, "modifications": every}))
    return [flank_of(member, flank) for member in (pair.pinion, pair.wheel) for flank in FLANKS]


def test_straight_teeth_are_cones() -> None:
    """Generators through the apex: one curvature is 0, the other that of a spherical involute, 1 / (rho tan psi)."""
    for flank in flanks("straight"):
        found = theory_curvature(flank, U, V)
        psi, rho = flank.coordinates(U, V)
        assert np.abs(found.gaussian).max() < 1e-14
        assert np.abs(found.smallest).max() < 1e-14
        assert found.largest == pytest.approx(1 / (rho * np.tan(psi)), rel=1e-10)


@pytest.mark.parametrize("name", GOLDEN)
def test_flank_curves_as_the_plane_rolls(name: str) -> None:
    """Meusnier and Euler: square to the rolling plane the point turns about the line of contact, whatever the spiral.

    Its path lies on the sphere and has the curvature sqrt(1 + cot^2 psi)/rho there; the flank's normal lies in the
    rolling plane at the angle of the generating line, tan = rho theta' sin(delta_b), from the tangent of the circle.
    """
    for flank in flanks(name):
        psi, rho = flank.coordinates(U, V)
        m = flank.member
        line = np.arctan(rho * m.lengthwise.azimuth_slope(rho) * np.sin(m.base_angle))
        bend = np.cos(line) / np.tan(psi) - flank.side * np.sin(line)
        found = theory_curvature_at(flank, psi, rho)
        along, _, second, *_ = flank.derivatives_at(psi, rho)
        normal_curvature = -np.sum(second * found.normals, axis=-1) / np.sum(along**2, axis=-1)
        assert normal_curvature == pytest.approx(bend / rho, rel=1e-12)
        assert np.all(found.smallest <= bend / rho + 1e-12) and np.all(bend / rho <= found.largest + 1e-12)


@pytest.mark.parametrize("taken_off", [{}, MICRO], ids=["exact", "modified"])
@pytest.mark.parametrize("name", GOLDEN)
def test_curvature_by_normals(name: str, taken_off: dict[str, float]) -> None:
    """Weingarten: the derivative of the normal, taken by differences, has the same invariants."""
    for flank in flanks(name, taken_off):
        psi, rho = flank.coordinates(U, V)
        found = theory_curvature_at(flank, psi, rho)
        h, k = 1e-5, 1e-5 * rho
        n_psi = (flank.normals_at(psi + h, rho) - flank.normals_at(psi - h, rho)) / (2 * h)
        n_rho = (flank.normals_at(psi, rho + k) - flank.normals_at(psi, rho - k)) / (2 * k)[..., None]
        a, b, *_ = flank.derivatives_at(psi, rho)
        first = np.stack([np.stack([np.sum(i * j, -1) for j in (a, b)], -1) for i in (a, b)], -2)
        second = np.stack([np.stack([np.sum(i * j, -1) for j in (n_psi, n_rho)], -1) for i in (a, b)], -2)
        shape = np.linalg.solve(first, second)
        assert np.linalg.det(shape) == pytest.approx(found.gaussian, rel=1e-5, abs=1e-9)
        assert np.trace(shape, axis1=-2, axis2=-1) / 2 == pytest.approx(found.mean, rel=1e-6)


def test_base_cone_is_refused() -> None:
    with pytest.raises(GeometryError, match="base cone"):
        theory_curvature(involute_flank(pair_geometry(Design()).pinion, "concave"), 0.0, 0.5)


def quarter_cylinder(radius: float) -> NurbsSurface:
    """An exact quarter of a cylinder about z: a rational arc swept straight."""
    arc = np.array([[radius, 0, 0], [radius, radius, 0], [0, radius, 0]], dtype=float)
    poles = np.stack([arc, arc + np.array([0, 0, 5.0])], axis=1)
    weights = np.tile(np.array([1, np.sqrt(0.5), 1])[:, None], (1, 2))
    knots = np.array([0, 0, 0, 1, 1, 1.0])
    return NurbsSurface(poles, knots, np.array([0, 0, 1, 1.0]), 2, 1, weights)


def test_derivatives_of_a_rational_surface() -> None:
    surface = quarter_cylinder(3.0)
    u = np.linspace(0.05, 0.95, 9)
    points, (x_u, x_v, x_uu, x_uv, x_vv) = surface_derivatives(surface, u, [0.5])
    assert np.hypot(points[..., 0], points[..., 1]) == pytest.approx(3.0)
    h = 1e-5
    ahead, behind = surface.grid(u + h, [0.5]), surface.grid(u - h, [0.5])
    assert x_u == pytest.approx((ahead - behind) / (2 * h), abs=1e-7)
    assert x_uu == pytest.approx((ahead - 2 * points + behind) / h**2, abs=1e-3)
    assert np.cross(x_u, x_v)[..., 2] == pytest.approx(0)
    assert np.abs(x_uv).max() < 1e-12 and np.abs(x_vv).max() < 1e-12


def test_surface_through_theory_has_its_curvature() -> None:
    """The same surface in both forms: an interpolation of high degree, far finer than any tolerance."""
    from scipy.interpolate import make_interp_spline

    flank = involute_flank(pair_geometry(Design()).wheel, "convex")
    u, v = (1 - np.cos(np.pi * np.linspace(0, 1, 24))) / 2, np.linspace(0, 1, 24)
    across = make_interp_spline(u, flank.points(u[:, None], v), k=9)
    along = make_interp_spline(v, np.moveaxis(across.c, 1, 0), k=9)
    surface = NurbsSurface(np.moveaxis(along.c, 0, 1), across.t, along.t, 9, 9)
    found = surface_curvature(surface, flank, np.linspace(0.1, 0.9, 21), np.linspace(0.1, 0.9, 21))
    truth = theory_curvature_at(flank, *flank.natural(found.points))
    for part in PARTS:
        assert getattr(found, part) == pytest.approx(getattr(truth, part), rel=1e-6)


def relative(difference: CurvatureMap, truth: CurvatureMap) -> float:
    return max(np.abs(getattr(difference, p)).max() / np.abs(getattr(truth, p)).max() for p in PARTS)


@pytest.mark.kernel
@pytest.mark.parametrize("flank_name", FLANKS)
def test_optimised_point_cloud_has_the_curvature_of_theory(flank_name: str) -> None:
    design = Design.model_validate({"methods": {"tolerance_um": 0.001, "point_cloud_degree": 8}})
    result = build_variant(design, "wheel", "point_cloud", "optimised", (5, 5))
    flank = involute_flank(pair_geometry(design).wheel, "concave" if flank_name == "concave" else "convex")
    surface = result.flanks[flank_name].surface
    u0, u1, v0, v1 = surface.bounds
    inside = np.linspace(0.1, 0.9, 17)
    difference = curvature_difference(surface, flank, u0 + inside * (u1 - u0), v0 + inside * (v1 - v0))
    truth = theory_curvature_at(flank, *flank.natural(difference.points))
    assert relative(difference, truth) < 1e-6


def test_folded_surface_is_refused() -> None:
    flank = involute_flank(pair_geometry(Design()).wheel, "convex")
    knots = np.array([0, 0, 1, 1.0])
    flat = NurbsSurface(np.zeros((2, 2, 3)) + flank.points(0.5, 0.5), knots, knots, 1, 1)
    with pytest.raises(GeometryError, match="folded"):
        surface_curvature(flat, flank, [0.5], [0.5])
