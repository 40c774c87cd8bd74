"""Points taken from STEP files: of our own exports moved about, in another unit, and of what is no such gear."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from gearstudio import cli
from gearstudio.analysis.measurement import MeasurementResult, measure
from gearstudio.design import Design
from gearstudio.errors import FileError, GeometryError
from gearstudio.jobs import ExportJob, SampleJob
from gearstudio.theory.cones import pair_geometry
from tests.designs import GOLDEN

pytestmark = pytest.mark.kernel
DESIGN = Design()
SMALL = Design.model_validate({"pair": {"pinion_teeth": 11, "wheel_teeth": 19, "pinion_hand": "right"}})


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("step")


@cache
def exported(folder: Path, design: Design, member: str, part: str) -> Path:
    job = ExportJob(design, member, part, "point_cloud", "optimised", ("step",), folder / f"{hash(design.name)}-{part}")
    return job.run(lambda stage, fraction: None)[0].path


def moved(path: Path, *, turn: float = 0.0, shift: float = 0.0, axis: str = "z", unit: str = "MM") -> Path:
    """A copy that is turned [rad] and then shifted along z [mm], written in another unit."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
    from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt, gp_Trsf, gp_Vec
    from OCP.Interface import Interface_Static
    from OCP.STEPControl import STEPControl_StepModelType, STEPControl_Writer

    from gearstudio.kernel.cutting import compound
    from gearstudio.kernel.sampling import read_faces
    from gearstudio.kernel.step import settle

    settle()
    rotation, translation = gp_Trsf(), gp_Trsf()
    rotation.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(*(float(axis == name) for name in "xyz"))), turn)
    translation.SetTranslation(gp_Vec(0.0, 0.0, shift))
    shape = BRepBuilderAPI_Transform(compound(list(read_faces(path))), translation.Multiplied(rotation), True).Shape()
    target = path.with_name(f"{turn}-{shift}-{axis}-{unit}-{path.name}")
    Interface_Static.SetCVal_s("write.step.unit", unit)
    writer = STEPControl_Writer()
    writer.Transfer(shape, STEPControl_StepModelType.STEPControl_AsIs)
    writer.Write(str(target))
    Interface_Static.SetCVal_s("write.step.unit", "MM")
    return target


def measured(path: Path, design: Design, member: str) -> MeasurementResult:
    found = SampleJob(design, member, path).run(lambda stage, fraction: None)
    return measure(pair_geometry(design), member, [found.points], start_shift=found.shift)


@pytest.mark.parametrize("member", ["pinion", "wheel"])
@pytest.mark.parametrize(("part", "faces"), [("flanks", 2), ("tooth", 2), ("gear", None)])
def test_flanks_are_found_wherever_the_part_lies(folder: Path, member: str, part: str, faces: int | None) -> None:
    path, geometry = exported(folder, SMALL, member, part), pair_geometry(SMALL).member(member)
    seen: list[float] = []
    found = SampleJob(SMALL, member, path).run(lambda stage, fraction: seen.append(fraction))
    assert found.flank_faces == (faces or 2 * geometry.teeth) and found.faces >= found.flank_faces
    assert seen == sorted(seen) and seen[-1] <= 1
    for turn, shift, unit in ((0.0, 0.0, "INCH"), (0.4, 0.8, "MM"), (1.9, -41.5, "MM")):
        result = measured(moved(path, turn=turn, shift=shift, unit=unit), SMALL, member)
        assert result.statistics.max_um < 0.05 and result.beside == 0
        assert result.pose.shift == pytest.approx(shift, abs=1e-4)
        off = (result.pose.turn - turn) / geometry.pitch
        assert off == pytest.approx(round(off), abs=1e-5)
        assert len(set(result.tooth)) == (1 if faces else geometry.teeth)
        assert set(result.flanks) == {"concave", "convex"}


@pytest.mark.parametrize("name", list(GOLDEN)[:4])
def test_other_designs(folder: Path, name: str) -> None:
    design = GOLDEN[name][0].model_copy(update={"name": name})
    for member in ("pinion", "wheel"):
        result = measured(moved(exported(folder, design, member, "tooth"), turn=0.3, shift=5.0), design, member)
        assert result.statistics.max_um < 0.05
        assert result.pose.shift == pytest.approx(5.0, abs=1e-3)


def test_the_spacing_is_kept(folder: Path) -> None:
    path, pair = exported(folder, SMALL, "wheel", "tooth"), pair_geometry(SMALL)
    spacing = pair.wheel.face_width / 40
    found = SampleJob(SMALL, "wheel", path, spacing).run(lambda *_: None).points.points
    distance = np.linalg.norm(found[:, None] - found[None], axis=-1) + 1e9 * np.eye(len(found))
    assert 0.5 * spacing < np.median(distance.min(axis=1)) <= spacing
    with pytest.raises(GeometryError, match="too many"):
        SampleJob(SMALL, "wheel", path, 1e-6).run(lambda *_: None)


@pytest.mark.parametrize(
    ("change", "member", "words"),
    [
        ({}, "pinion", "flanks of the wheel"),
        ({"pair": {"pinion_teeth": 11, "wheel_teeth": 19, "pinion_hand": "left"}}, "wheel", "other hand"),
        ({"pair": {"pinion_teeth": 11, "wheel_teeth": 27, "pinion_hand": "right"}}, "wheel", "another gear"),
        (
            {
                "pair": {"pinion_teeth": 11, "wheel_teeth": 19, "pinion_hand": "right"},
                "lengthwise": {"spiral_angle_deg": 25.0},
            },
            "wheel",
            "another gear",
        ),
    ],
)
def test_another_gear_is_refused_with_the_reason(folder: Path, change: dict, member: str, words: str) -> None:
    design = Design.model_validate(change) if change else SMALL
    with pytest.raises((FileError, GeometryError), match=words):
        measured(exported(folder, SMALL, "wheel", "gear"), design, member)


def test_a_model_that_lies_otherwise_is_refused_with_the_reason(folder: Path) -> None:
    path = exported(folder, SMALL, "wheel", "tooth")
    with pytest.raises(FileError, match=r"lies along -y"):
        measured(moved(path, turn=np.pi / 2, axis="x"), SMALL, "wheel")
    with pytest.raises(FileError, match=r"lies along -z"):
        measured(moved(path, turn=np.pi, axis="x"), SMALL, "wheel")
    with pytest.raises(FileError, match=r"lies along \+x"):
        measured(moved(path, turn=np.pi / 2, axis="y"), SMALL, "wheel")


def test_files_that_are_no_models(folder: Path) -> None:
    (folder / "text.step").write_text("hello", encoding="utf-8")
    for name, words in (("text.step", "cannot read"), ("missing.step", "no such file")):
        with pytest.raises(FileError, match=words):
            measured(folder / name, SMALL, "wheel")


def test_the_command_takes_models(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = exported(folder, DESIGN, "wheel", "flanks")
    given = ["measure", "preset:default", str(path), "--member", "wheel", "--spacing", "2", "--json", "-"]
    assert cli.main(given) == 0
    record = json.loads(capsys.readouterr().out)
    assert record["count"] == len(record["points"]) > 30 and record["max_um"] < 0.05
    assert cli.main(["measure", "preset:default", str(path), "--member", "pinion"]) == 2
    problems = capsys.readouterr().err.splitlines()
    assert len(problems) == 1 and "flanks of the wheel" in problems[0]
