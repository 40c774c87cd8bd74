"""The closed-form deviation against the CAD kernel's own projection of points onto the theoretical flank."""

from __future__ import annotations

import numpy as np
import pytest
from OCP.GeomAPI import GeomAPI_ProjectPointOnSurf
from OCP.gp import gp_Pnt

from gearstudio.analysis.comparison import build_variant
from gearstudio.catalogue import MEMBERS
from gearstudio.design import Design
from gearstudio.kernel.convert import to_surface
from gearstudio.kernel.surfaces import reconstructed
from gearstudio.methods import METHODS
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.involute_flank import InvoluteFlank, involute_flank
from tests.theory.members import CORNERS, made

pytestmark = pytest.mark.kernel

DESIGNS = {"default": Design(), "miter": made(wheel_teeth=17, curve="archimedean", ends="sphere"), **CORNERS}


def dense(flank: InvoluteFlank):
    """The theoretical flank as the kernel holds it, true to 1e-9 of the cone distance, a little beyond its edges."""
    u, v = np.linspace(0.0, 1.04, 60), np.linspace(-0.04, 1.04, 61)
    surface = reconstructed(u, v, flank.points(u[:, None], v[None, :]), 7)
    exact = flank.deviation(surface.grid(np.linspace(0, 1, 77), np.linspace(0, 1, 79)))
    assert np.abs(exact).max() < 1e-9 * flank.member.outer_cone_distance
    return to_surface(surface)


def kernel_distance(geometry, point: np.ndarray) -> float:
    projection = GeomAPI_ProjectPointOnSurf(gp_Pnt(*point.tolist()), geometry, 1e-12)
    return projection.LowerDistance()


@pytest.mark.parametrize("member_name", MEMBERS)
@pytest.mark.parametrize("design", DESIGNS.values(), ids=DESIGNS)
def test_random_points_up_to_a_hundred_micrometres_off(design: Design, member_name: str) -> None:
    member = pair_geometry(design).member(member_name)
    rng = np.random.default_rng(3)
    for name in FLANKS:
        flank = involute_flank(member, name)
        geometry = dense(flank)
        # So near to the base cone that the curvature's radius is the distance itself, "the" nearest point is none.
        u, v = rng.uniform(0.15, 0.97, 4), rng.uniform(0.03, 0.97, 4)
        size = rng.uniform(-1e-3, 1e-3, 4) * min(100.0, member.outer_cone_distance)
        points = flank.points(u, v) + size[:, None] * flank.normals(u, v)
        for point, expected, found in zip(points, size, flank.deviation(points), strict=True):
            assert kernel_distance(geometry, point) == pytest.approx(abs(found), abs=1e-6)
            assert np.sign(found) == np.sign(expected)


@pytest.mark.parametrize("method", METHODS, ids=[m.info.id for m in METHODS])
@pytest.mark.parametrize("member_name", MEMBERS)
def test_published_surfaces_are_measured_right(member_name: str, method) -> None:
    result = build_variant(Design(), member_name, method.info.id, "published", samples=(6, 5))
    for name in FLANKS:
        flank = involute_flank(pair_geometry(Design()).member(member_name), name)
        geometry, measured = dense(flank), result.flanks[name]
        inner = (slice(1, -1), slice(1, -1))
        points, sizes = measured.points[inner].reshape(-1, 3), measured.deviation_um[inner].ravel() * 1e-3
        for point, size in zip(points, sizes, strict=True):
            assert kernel_distance(geometry, point) == pytest.approx(abs(size), abs=1e-6)
