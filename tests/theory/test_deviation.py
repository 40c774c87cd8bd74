"""Deviation of points: sign, size, and agreement with a search for the nearest point that knows no formula."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import least_squares

from gearstudio.design import Design
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.involute_flank import InvoluteFlank, involute_flank
from tests.theory.members import MEMBERS, made

over_flanks = pytest.mark.parametrize(
    "flank",
    [involute_flank(member, name) for member in MEMBERS.values() for name in FLANKS],
    ids=[f"{member} {name}" for member in MEMBERS for name in FLANKS],
)
V = np.linspace(0.03, 0.97, 6)[None, :]


@over_flanks
@pytest.mark.parametrize("share", [0.0, 1e-9, -1e-9, 1e-6, -1e-6, 1e-4, -1e-4])
def test_a_point_moved_along_the_normal_deviates_by_that_much(flank: InvoluteFlank, share: float) -> None:
    """Outside is positive on either side. Sizes are shares of the outer cone distance."""
    scale = flank.member.outer_cone_distance
    u = np.linspace(0.05, 1.0, 7)[:, None]  # nearer to the base cone the radius of curvature is as small as this
    error = flank.deviation(flank.points(u, V) + share * scale * flank.normals(u, V)) - share * scale
    assert np.abs(error).max() < 2e-12 * scale + 1e-5 * abs(share) * scale


@over_flanks
@pytest.mark.parametrize("share", [1e-9, -1e-9, 1e-6, -1e-6, 1e-4])
def test_so_it_does_on_the_lower_edge(flank: InvoluteFlank, share: float) -> None:
    scale = flank.member.outer_cone_distance
    error = flank.deviation(flank.points(0.0, V) + share * scale * flank.normals(0.0, V)) - share * scale
    assert np.abs(error).max() < 2e-12 * scale + 1e-5 * abs(share) * scale


@pytest.mark.parametrize("name", FLANKS)
@pytest.mark.parametrize("member_name", ["pinion", "wheel"])
def test_agrees_with_a_search_for_the_nearest_point(member_name: str, name: str) -> None:
    """Random points up to 100 µm away; the search minimises the distance over (psi, rho) and nothing else."""
    member = pair_geometry(Design()).member(member_name)
    flank, rng = involute_flank(member, name), np.random.default_rng(5)
    psi, rho = flank.coordinates(rng.uniform(0.1, 0.95, 12), rng.uniform(0.05, 0.95, 12))
    points = flank.at(psi, rho) + rng.uniform(-0.1, 0.1, (12, 3)) / np.sqrt(3)
    found = flank.deviation(points)
    for point, start, size in zip(points, np.stack([psi, rho], -1), found, strict=True):
        nearest = least_squares(
            lambda x, point=point: flank.at(x[0], x[1]) - point, start, x_scale=[1e-2, 1.0], xtol=1e-15, ftol=1e-15
        )
        distance = np.linalg.norm(nearest.fun)
        assert distance < 0.101
        assert abs(size) == pytest.approx(distance, abs=1e-6)  # 1e-3 µm
        middle = float(member.lengthwise.azimuth(nearest.x[1]))
        outward = flank.side * np.array([-np.sin(middle), np.cos(middle), 0.0])
        assert np.sign(size) == np.sign(outward @ (point - flank.at(*nearest.x)))


def test_below_the_base_cone_the_meridian_goes_on() -> None:
    member = pair_geometry(Design()).pinion
    assert member.root_angle < member.base_angle
    for name in FLANKS:
        flank = involute_flank(member, name)
        rho = np.linspace(member.inner_cone_distance, member.outer_cone_distance, 9)
        start = flank.points_at(rho, member.base_angle)
        radial = np.hypot(start[:, 0], start[:, 1])
        delta = member.base_angle - np.array([[1e-9], [1e-4], [0.01]])
        scale = rho * np.sin(delta) / radial
        points = np.stack([start[:, 0] * scale, start[:, 1] * scale, rho * np.cos(delta)], axis=-1)
        assert np.abs(flank.deviation(points)).max() < 1e-12
        for size in (1e-6, 1e-3, 0.05):
            tangent = np.gradient(points, rho, axis=1, edge_order=2)
            meridian = points[:1] - points[2:]
            normal = flank.side * np.cross(tangent, meridian)
            normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
            inner = (slice(1, 3), slice(2, 7))
            moved = (points + np.sign(np.sum(normal * flank.normals(0.0, 0.5), -1))[..., None] * size * normal)[inner]
            assert flank.deviation(moved) == pytest.approx(np.full(moved.shape[:-1], size), rel=2e-3)


def test_far_points_have_finite_deviations() -> None:
    rng = np.random.default_rng(1)
    for design in (Design(), made(cutter_radius=52.0, spiral_angle_deg=55.0, addendum_factor=0.7)):
        for member in (pair_geometry(design).pinion, pair_geometry(design).wheel):
            flank = involute_flank(member, "concave")
            points = rng.uniform(-1, 1, (4000, 3)) * 2 * member.outer_cone_distance
            assert np.all(np.isfinite(flank.deviation(points)))


@over_flanks
def test_edges_of_the_flank_itself_are_where_they_should_be(flank: InvoluteFlank) -> None:
    u, v = np.linspace(0, 1, 9)[:, None], np.linspace(0, 1, 9)[None, :]
    scale = flank.member.outer_cone_distance
    assert flank.edge_deviation(flank.points(u, v)) < 1e-12 * scale
    short = flank.points(u, 0.01 + 0.99 * v)
    assert flank.edge_deviation(short) == pytest.approx(0.01 * flank.member.face_width, rel=1e-6)
    low = flank.points(0.99 * u, v)
    rho, delta, _ = flank.locate(np.stack([low[-1], flank.points(u, v)[-1]]))
    assert flank.edge_deviation(low) == pytest.approx(((delta[1] - delta[0]) * rho[0]).max(), rel=1e-3)
