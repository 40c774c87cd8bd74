"""Point clouds: rows at cone distances, columns from root or base cone to tip."""

from __future__ import annotations

from itertools import pairwise
from typing import get_args

import numpy as np
import pytest

from gearstudio.design import Design
from gearstudio.errors import GeometryError
from gearstudio.theory.cloud import SPACINGS, Spacing, flank_grid
from gearstudio.theory.cones import MemberGeometry, pair_geometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.involute_flank import involute_flank
from tests.theory.members import MEMBERS


@pytest.mark.parametrize("spacing", get_args(Spacing))
@pytest.mark.parametrize("member", MEMBERS.values(), ids=MEMBERS)
def test_rows_and_columns(member: MemberGeometry, spacing: Spacing) -> None:
    for name in FLANKS:
        flank = involute_flank(member, name)
        points = flank_grid(flank, 6, 9, spacing)
        assert points.shape == (6, 9, 3)
        rho = np.linalg.norm(points, axis=-1)
        delta = np.arctan2(np.hypot(points[..., 0], points[..., 1]), points[..., 2])
        assert np.ptp(rho, axis=1).max() < 1e-13 * member.outer_cone_distance
        ends = (member.inner_cone_distance, member.outer_cone_distance)
        assert (rho[0, 0], rho[-1, 0]) == pytest.approx(ends, rel=1e-14)
        assert delta[:, 0] == pytest.approx(np.full(6, max(member.root_angle, member.base_angle)), abs=1e-13)
        assert delta[:, -1] == pytest.approx(member.tip_limit.at_sphere(rho[:, 0]), abs=1e-13)
        assert np.all(np.diff(rho[:, 0]) > 0) and np.all(np.diff(delta, axis=1) > 0)
        assert np.abs(flank.deviation(points)).max() < 1e-11 * max(1.0, member.outer_cone_distance / 250)


def test_uniform_is_even_in_cone_distance_and_polar_angle() -> None:
    points = flank_grid(involute_flank(pair_geometry(Design()).wheel, "convex"), 5, 6, "uniform")
    rho = np.linalg.norm(points, axis=-1)
    delta = np.arccos(points[..., 2] / rho)
    assert np.ptp(np.diff(rho[:, 0])) < 1e-12
    assert np.ptp(np.diff(delta[2])) < 1e-12


def test_arc_spacing_divides_every_profile_into_equal_lengths() -> None:
    flank = involute_flank(pair_geometry(Design()).pinion, "concave")
    points = flank_grid(flank, 4, 7, "arc")
    for row in points:
        rho, delta, _ = flank.locate(row)
        dense = np.concatenate([flank.points_at(rho[0], np.linspace(a, b, 400)) for a, b in pairwise(delta)]).reshape(
            6, 400, 3
        )
        lengths = np.linalg.norm(np.diff(dense, axis=1), axis=-1).sum(axis=1)
        assert lengths == pytest.approx(np.full(6, lengths.mean()), rel=2e-3)


def test_cosine_spacing_is_denser_toward_the_ends() -> None:
    points = flank_grid(involute_flank(pair_geometry(Design()).wheel, "convex"), 9, 9, "cosine")
    rho = np.linalg.norm(points[:, 0], axis=-1)
    steps = np.diff(rho)
    assert steps[0] < 0.3 * steps[4] and steps == pytest.approx(steps[::-1], rel=1e-9)


@pytest.mark.parametrize(("rows", "cols", "spacing"), [(1, 7, "uniform"), (7, 1, "arc"), (7, 7, "even")])
def test_a_grid_without_area_or_of_unknown_spacing_is_refused(rows: int, cols: int, spacing: str) -> None:
    with pytest.raises(GeometryError):
        flank_grid(involute_flank(pair_geometry(Design()).wheel, "convex"), rows, cols, spacing)
    assert set(SPACINGS) == {"uniform", "arc", "cosine"}
