"""Point files: the numbers of theory, in formats that other programs read."""

from __future__ import annotations

import io
from typing import Any

import numpy as np
import pytest

from gearstudio.catalogue import MEMBERS
from gearstudio.exchange.points import CSV_HEADER, POINT_FORMATS, point_cloud, points_text
from gearstudio.theory.cloud import SPACINGS
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.involute_flank import involute_flank
from tests.designs import GOLDEN

ROWS, COLS = 5, 4


@pytest.fixture(params=FLANKS)
def cloud(request: pytest.FixtureRequest) -> Any:
    member = pair_geometry(GOLDEN["default"][0]).pinion
    return point_cloud(involute_flank(member, request.param), ROWS, COLS, "uniform")


@pytest.mark.parametrize("name", GOLDEN)
@pytest.mark.parametrize("member", MEMBERS)
@pytest.mark.parametrize("flank", FLANKS)
def test_dat_holds_the_golden_points_in_order(name: str, member: str, flank: Any) -> None:
    design, record = GOLDEN[name]
    geometry = pair_geometry(design).member(member)
    made = point_cloud(involute_flank(geometry, flank), 5, 5, "uniform")
    side = geometry.hand if flank == "concave" else -geometry.hand
    expected = [point["xyz"] for point in record[member]["flank"] if point["side"] == side]
    points = np.loadtxt(io.StringIO(points_text(made, "dat")))
    np.testing.assert_allclose(points, expected, rtol=0, atol=1e-11)


def test_dat_reads_back_exactly(cloud: Any) -> None:
    points = np.loadtxt(io.StringIO(points_text(cloud, "dat")))
    assert np.array_equal(points, cloud.points.reshape(-1, 3))


def test_csv_has_one_header_and_reads_back_exactly(cloud: Any) -> None:
    header, *lines = points_text(cloud, "csv").splitlines()
    assert header == CSV_HEADER and header.startswith("x,y,z")
    table = np.array([[float(cell) for cell in line.split(",")] for line in lines])
    assert table.shape == (ROWS * COLS, 8)
    assert np.array_equal(table[:, :3], cloud.points.reshape(-1, 3))
    np.testing.assert_allclose(np.linalg.norm(table[:, :3], axis=1), table[:, 6], rtol=1e-14)
    np.testing.assert_allclose(np.degrees(np.arccos(table[:, 2] / table[:, 6])), table[:, 7], rtol=1e-12)


@pytest.mark.parametrize("name", FLANKS)
def test_csv_normals_are_unit_and_square_to_the_flank_and_out_of_the_metal(name: Any) -> None:
    member = pair_geometry(GOLDEN["default"][0]).pinion
    flank = involute_flank(member, name)
    cloud = point_cloud(flank, ROWS, COLS, "uniform")
    np.testing.assert_allclose(np.linalg.norm(cloud.normals, axis=-1), 1.0, atol=1e-14)
    step = 1e-5
    for moved in (
        flank.points_at(cloud.rho + step, cloud.polar_angle),
        flank.points_at(cloud.rho, cloud.polar_angle + step / member.outer_cone_distance),
    ):
        chord = moved - cloud.points
        chord /= np.linalg.norm(chord, axis=-1, keepdims=True)
        np.testing.assert_allclose(np.sum(chord * cloud.normals, axis=-1), 0.0, atol=1e-3)
    outside = flank.deviation(cloud.points + step * cloud.normals)
    np.testing.assert_allclose(outside, step, rtol=1e-3)
    turned = np.arctan2(cloud.points[..., 1], cloud.points[..., 0]) - member.lengthwise.azimuth(cloud.rho)
    away = cloud.points[..., 0] * cloud.normals[..., 1] - cloud.points[..., 1] * cloud.normals[..., 0]
    assert np.all(turned * away > 0)


def test_ibl_has_one_curve_for_each_row(cloud: Any) -> None:
    lines = points_text(cloud, "ibl").splitlines()
    assert lines[0] == "Open Index arclength"
    body = np.array(lines[1:]).reshape(ROWS, COLS + 2)
    for index, block in enumerate(body):
        assert list(block[:2]) == [f"Begin section ! {index + 1}", f"Begin curve ! {index + 1}"]
        points = np.array([[float(cell) for cell in line.split()] for line in block[2:]])
        assert np.array_equal(points, cloud.points[index])


@pytest.mark.parametrize("format_", POINT_FORMATS)
@pytest.mark.parametrize("spacing", SPACINGS)
def test_every_spacing_keeps_the_corners(format_: Any, spacing: Any) -> None:
    flank = involute_flank(pair_geometry(GOLDEN["zerol"][0]).wheel, "convex")
    even, made = (point_cloud(flank, 6, 7, kind) for kind in ("uniform", spacing))
    for corner in [(0, 0), (0, -1), (-1, 0), (-1, -1)]:
        np.testing.assert_allclose(made.points[corner], even.points[corner], atol=1e-11)
    assert points_text(made, format_).endswith("\n")
