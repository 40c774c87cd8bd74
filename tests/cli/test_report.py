"""The command ``report``: a PDF of the sections asked for, and what it says when something is missing."""

from __future__ import annotations

from pathlib import Path

import pytest

from gearstudio import cli
from gearstudio.cli import report_pictures
from gearstudio.design import Design
from gearstudio.exchange.measured import nominal_grid_text
from gearstudio.project import save_design
from gearstudio.theory.cones import pair_geometry


@pytest.fixture
def design(tmp_path: Path) -> Path:
    path = tmp_path / "pair.gear.toml"
    save_design(path, Design())
    return path


def test_a_part_of_the_report_is_written(design: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "out.pdf"
    assert cli.main(["report", str(design), "--out", str(target), "--sections", "design,sheet,exports"]) == 0
    assert target.read_bytes().startswith(b"%PDF") and capsys.readouterr().out.strip() == str(target)


def test_a_picture_that_fails_is_one_line_and_the_report_is_made(
    design: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(report_pictures, "_PICTURES", {"views.jpg": ("--view", "nowhere")})
    target = tmp_path / "out.pdf"
    assert cli.main(["report", str(design), "--out", str(target), "--sections", "pictures"]) == 0
    (line,) = capsys.readouterr().err.splitlines()
    assert "views" in line and "nowhere" in line and target.exists()


def test_a_report_in_another_language_with_measured_points(
    design: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    points, target = tmp_path / "points.csv", tmp_path / "out.pdf"
    nominal = nominal_grid_text(pair_geometry(Design()).wheel, 9, 5)
    points.write_text(nominal, encoding="utf-8")
    words = ["report", str(design), "--out", str(target), "--sections", "design,measurement"]
    assert cli.main([*words, "--language", "de", "--measured", str(points)]) == 0
    assert target.read_bytes().startswith(b"%PDF")
    points.write_text("x,y,z\n900,0,0\n0,900,0\n0,0,900\n", encoding="utf-8")
    target.unlink()
    capsys.readouterr()
    assert cli.main([*words, "--measured", str(points)]) == 2
    assert "points.csv" in capsys.readouterr().err and not target.exists()


def test_measured_points_that_are_missing_are_told(
    design: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["report", str(design), "--out", str(tmp_path / "a.pdf"), "--sections", "measurement"]
    assert cli.main(words) == 2
    assert "--measured" in capsys.readouterr().err
    assert cli.main([*words, "--measured", str(tmp_path / "none.csv")]) == 2
    assert "none.csv" in capsys.readouterr().err
    assert cli.main([*words, "--language", "fr"]) == 2


def test_an_unknown_section_is_refused(design: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["report", str(design), "--out", str(tmp_path / "a.pdf"), "--sections", "poems"]) == 2
    assert "poems" in capsys.readouterr().err and not (tmp_path / "a.pdf").exists()
