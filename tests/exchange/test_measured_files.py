"""Files of measured points: what is read, what is refused and why."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from gearstudio.analysis.measurement import measure
from gearstudio.design import Design
from gearstudio.errors import FileError
from gearstudio.exchange.measured import nominal_grid_text, read_measured
from gearstudio.exchange.points import POINT_FORMATS, PointFormat, point_cloud, points_text
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.involute_flank import involute_flank

PAIR = pair_geometry(Design())
XYZ = np.array([[1.5, -2.25, 3.0], [4.0, 5.5, -6.0], [7.0, 8.0, 9.125]])


def read(path: Path, text: str) -> tuple[np.ndarray, np.ndarray | None]:
    path.write_text(text, encoding="utf-8")
    parts = list(read_measured(path))
    normals = [part.normals for part in parts if part.normals is not None]
    return np.concatenate([part.points for part in parts]), np.concatenate(normals) if normals else None


@pytest.mark.parametrize("format_", POINT_FORMATS)
def test_our_own_files_read_back_exactly(tmp_path: Path, format_: PointFormat) -> None:
    cloud = point_cloud(involute_flank(PAIR.wheel, "concave"), 5, 4, "uniform")
    points, normals = read(tmp_path / f"p.{format_}", points_text(cloud, format_))
    assert np.array_equal(points, cloud.points.reshape(-1, 3))
    assert (normals is not None) == (format_ == "csv")
    if normals is not None:
        assert np.array_equal(normals, cloud.normals.reshape(-1, 3))


@pytest.mark.parametrize(
    "text",
    [
        "1.5 -2.25 3\n4 5.5 -6\n7 8 9.125\n",
        "1.5,-2.25,3\n4,5.5,-6\n7,8,9.125",
        "1.5, -2.25, 3\r\n4, 5.5, -6\r\n\r\n7, 8, 9.125\r\n",
        "1.5;-2.25;3\n4;5.5;-6\n7;8;9.125\n",
        "1,5;-2,25;3\n4;5,5;-6\n7;8;9,125\n",
        "1,5 -2,25 3\n4 5,5 -6\n7 8 9,125\n",
        "1.5\t-2.25\t3\n4\t5.5\t-6\n7\t8\t9.125\n",
        "# a remark\n! another\n1.5 -2.25 3\n# in between\n4 5.5 -6\n7 8 9.125\n",
        "x,y,z\n1.5,-2.25,3\n4,5.5,-6\n7,8,9.125\n",
        "X [mm];Y [mm];Z [mm]\n1.5;-2.25;3\n4;5.5;-6\n7;8;9.125\n",
        "# x y z\n1.5 -2.25 3\n4 5.5 -6\n7 8 9.125\n",
        "name,z,y,x\na,3,-2.25,1.5\nb,-6,5.5,4\nc,9.125,8,7\n",
        "\ufeffx,y,z\n1.5,-2.25,3\n4,5.5,-6\n7,8,9.125\n",
    ],
)
def test_usual_layouts(tmp_path: Path, text: str) -> None:
    points, normals = read(tmp_path / "points.txt", text)
    assert np.array_equal(points, XYZ) and normals is None


@pytest.mark.parametrize("header", ["", "x y z nx ny nz\n", "X Y Z I J K\n"])
def test_normals(tmp_path: Path, header: str) -> None:
    points, normals = read(tmp_path / "p.dat", header + "1 2 3 0 0 1\n4 5 6 1 0 0\n")
    assert points.tolist() == [[1, 2, 3], [4, 5, 6]]
    assert normals is not None and normals.tolist() == [[0, 0, 1], [1, 0, 0]]


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "no points"),
        ("# only a remark\n", "no points"),
        ("1 2\n3 4\n", "line 1 has 2 columns"),
        ("1 2 3 4\n", "line 1 has 4 columns"),
        ("x,y\n1,2\n", "no column z"),
        ("a,b,c\n1,2,3\n", "line 1: 'a' is not a number"),
        ("1 2 3\n4 5\n", "line 2 has 2 columns"),
        ("1 2 3\n\n# x\n4 nan 6\n", "line 4: 'nan' is not a finite number"),
        ("1 2 3\n4 5 inf\n", "line 2: 'inf'"),
        ("1 2 3\n4 5 six\n", "line 2: 'six' is not a number"),
        ("x,y,z\n1,2,\n", "line 2: '' is not a number"),
        ("x [in],y [in],z [in]\n1,2,3\n", "the header says inches; convert"),
        ("x (m),y (m),z (m)\n1,2,3\n", "metres"),
    ],
)
def test_what_cannot_be_used_says_why(tmp_path: Path, text: str, reason: str) -> None:
    with pytest.raises(FileError) as caught:
        read(tmp_path / "p.csv", text)
    assert reason in str(caught.value) and "p.csv" in str(caught.value)


def test_binary_and_missing_files(tmp_path: Path) -> None:
    (tmp_path / "b.csv").write_bytes(bytes(range(256)) * 20)
    with pytest.raises(FileError):
        list(read_measured(tmp_path / "b.csv"))
    with pytest.raises(FileError, match="no such file"):
        list(read_measured(tmp_path / "none.csv"))


def test_many_points_come_in_chunks_with_progress(tmp_path: Path) -> None:
    count = 12_500
    path = tmp_path / "many.csv"
    path.write_text("x,y,z\n" + "".join(f"{k},{k}.5,-1e-3\n" for k in range(count)))
    told: list[float] = []
    parts = list(read_measured(path, told.append))
    assert [len(part.points) for part in parts] == [4_999, 5_000, 2_501]
    assert told == sorted(told) and told[-1] == pytest.approx(1, abs=1e-9)
    assert np.array_equal(np.concatenate([part.points for part in parts])[:, 0], np.arange(count))


def test_problem_in_a_late_chunk_has_its_line(tmp_path: Path) -> None:
    path = tmp_path / "late.dat"
    path.write_text("1 2 3\n" * 250_000 + "1 x 3\n")
    with pytest.raises(FileError, match="line 250001: 'x'"):
        list(read_measured(path))


def test_nominal_grid_for_a_measuring_machine(tmp_path: Path) -> None:
    text = nominal_grid_text(PAIR.pinion, 5, 4)
    lines = text.splitlines()
    assert lines[0] == "x,y,z,nx,ny,nz,flank,row,column" and len(lines) == 1 + 2 * 5 * 4
    points, normals = read(tmp_path / "nominal.csv", text)
    assert normals is not None and np.linalg.norm(normals, axis=1) == pytest.approx(1)
    result = measure(PAIR, "pinion", read_measured(tmp_path / "nominal.csv"))
    assert result.statistics.max_um < 1e-6 and len(points) == 40
    assert [line.split(",")[6] for line in lines[1:]] == result.flanks
