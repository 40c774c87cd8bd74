"""The command ``report``: a PDF of the sections asked for, and what it says when something is missing."""

from __future__ import annotations

from pathlib import Path

import pytest

from gearstudio import cli
from gearstudio.cli import report_pictures
from gearstudio.design import Design
from gearstudio.project import save_design


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


def test_an_unknown_section_is_refused(design: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["report", str(design), "--out", str(tmp_path / "a.pdf"), "--sections", "poems"]) == 2
    assert "poems" in capsys.readouterr().err and not (tmp_path / "a.pdf").exists()
