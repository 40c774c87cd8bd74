"""Exports held against their designs again: good ones, changed, cut off, gone, of another gear."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path
from typing import Any

import pytest

from gearstudio.cli import main
from gearstudio.design import Design, with_field
from gearstudio.project import save_design

pytestmark = pytest.mark.kernel

SMALL = with_field(with_field(Design(), "pair.pinion_teeth", 9), "pair.wheel_teeth", 14)
FORMATS = ("step", "brep", "stl", "glb")


@pytest.fixture(scope="module")
def original(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project whose exports lie beside it, with records."""
    folder = tmp_path_factory.mktemp("Проект 歯車")
    save_design(folder / "räder.gear.toml", SMALL)
    formats = [word for name in FORMATS for word in ("--format", name)]
    common = ["--member", "pinion", "--record", "--out", str(folder)]
    assert (
        main(["export", str(folder / "räder.gear.toml"), *common, "--part", "tooth", *formats, "--chord", "0.02"]) == 0
    )
    assert main(["export", str(folder / "räder.gear.toml"), *common, "--part", "flanks", "--format", "step"]) == 0
    return folder


@pytest.fixture
def project(original: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(original, tmp_path / "Kopie 2")) / "räder.gear.toml"


def verify(*words: object, capsys: pytest.CaptureFixture[str]) -> tuple[int, str, str]:
    capsys.readouterr()
    status = main(["verify", *map(str, words)])
    captured = capsys.readouterr()
    return status, captured.out, captured.err


def test_a_project_and_its_exports_are_good(project: Path, tmp_path: Path, capsys: Any) -> None:
    target = tmp_path / "found.json"
    status, out, _ = verify(project, "--json", target, capsys=capsys)
    assert status == 0
    assert out.count("as it should be") == 5 and "pinion concave fillet" in out and "Open CASCADE" in out
    data = json.loads(target.read_text(encoding="utf-8"))
    assert data["good"] and len(data["files"]) == 5
    faces = next(f for f in data["files"] if f["file"].endswith("tooth.step"))["check"]["deviations"]
    assert {face["name"] for face in faces} >= {"concave", "convex", "concave fillet", "convex fillet", "tip", "root"}
    assert max(face["largest_um"] for face in faces) < 0.1


def test_a_file_changed_by_hand_is_found(project: Path, capsys: Any) -> None:
    path = project.with_name("pinion-tooth.stl")
    content = bytearray(path.read_bytes())
    content[84 + 50 * 100 + 12 + 8 : 84 + 50 * 100 + 12 + 12] = b"\0\0\x80\x42"
    path.write_bytes(content)
    status, out, _ = verify(path, capsys=capsys)
    assert status == 1 and "checksum" in out and "not valid" in out and "from theory instead of" in out


def test_a_text_changed_without_harm_is_still_said(project: Path, capsys: Any) -> None:
    path = project.with_name("pinion-tooth.step")
    path.write_text(path.read_text().replace("Open CASCADE Model", "My model"))
    status, out, _ = verify(path, capsys=capsys)
    assert status == 1 and "checksum" in out and "from theory" not in out


@pytest.mark.parametrize("name", ["pinion-tooth.step", "pinion-tooth.brep", "pinion-tooth.stl", "pinion-tooth.glb"])
def test_a_file_that_was_cut_off_is_said(name: str, project: Path, capsys: Any) -> None:
    path = project.with_name(name)
    path.write_bytes(path.read_bytes()[: path.stat().st_size * 2 // 3])
    status, out, _ = verify(path, capsys=capsys)
    assert status == 1 and "cut off" in out


def test_a_file_that_is_gone_and_a_record_that_is_damaged(project: Path, capsys: Any) -> None:
    project.with_name("pinion-tooth.glb").unlink()
    project.with_name("pinion-tooth.stl.check.json").write_text("{]")
    status, out, _ = verify(project, capsys=capsys)
    assert status == 1 and "the file is gone" in out and "no record of an export" in out


def test_a_design_changed_since_is_said(project: Path, capsys: Any) -> None:
    save_design(project, with_field(SMALL, "tooth.backlash", 0.05))
    status, out, _ = verify(project, capsys=capsys)
    assert status == 1 and "another state of the design: tooth.backlash" in out


def test_another_gear_is_said_to_be_one(project: Path, capsys: Any) -> None:
    for name in ("pinion-tooth.step", "pinion-tooth.stl"):
        path = project.with_name(name)
        path.with_name(f"{name}.check.json").unlink()
        status, out, _ = verify(path, "--design", project, "--method", "profile_sweep", "--chord", 0.02, capsys=capsys)
        assert (status, "as it should be" in out) == (0, True) or name.endswith("stl")
        status, out, _ = verify(path, "--design", "preset:default", capsys=capsys)
        assert status == 1 and "not the pinion tooth of this design" in out


def test_unusable_input_is_one_line_a_problem(project: Path, tmp_path: Path, capsys: Any) -> None:
    stray = tmp_path / "part.step"
    stray.write_text("x")
    bare = tmp_path / "bare"
    bare.mkdir()
    shutil.copy(project, bare)
    for words, said in (
        ([tmp_path / "none.step"], "no such file"),
        ([tmp_path], "this is a folder"),
        ([stray], "--design"),
        ([stray.with_name("räder.gear.toml")], "no such file"),
        ([bare / project.name], "no exports here"),
        ([stray.with_suffix(".txt")], "no such file"),
    ):
        status, out, err = verify(*words, capsys=capsys)
        assert (status, out) == (2, "") and said in err


def test_flanks_that_a_rotating_line_cannot_sweep_are_told(tmp_path: Path, capsys: Any) -> None:
    crowned = with_field(SMALL, "modifications.pinion.concave.lengthwise_crowning_um", 25.0)
    save_design(tmp_path / "crowned.gear.toml", crowned)
    words = ["--member", "pinion", "--part", "tooth", "--format", "step", "--record", "--out", str(tmp_path)]
    assert main(["export", str(tmp_path / "crowned.gear.toml"), *words, "--method", "rotating_line"]) == 0
    status, out, _ = verify(tmp_path / "crowned.gear.toml", capsys=capsys)
    assert status == 0 and re.search(r"flanks are up to 2[45][.\d]* µm from those of the design", out)
    assert main(["export", str(tmp_path / "crowned.gear.toml"), *words, "--method", "point_cloud"]) == 0
    assert "those of the design" not in verify(tmp_path / "crowned.gear.toml", capsys=capsys)[1]
