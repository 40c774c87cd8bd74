"""Solids and meshes as files: what is in them, and what happens when they cannot be written."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from OCP.collections import Sequence_TDF_Label
from OCP.STEPCAFControl import STEPCAFControl_Reader
from OCP.TCollection import TCollection_ExtendedString
from OCP.TDocStd import TDocStd_Document
from OCP.XCAFDoc import XCAFDoc_DocumentTool

from gearstudio.design import Design, with_field
from gearstudio.errors import FileError
from gearstudio.exchange import glb, stl, threemf
from gearstudio.formats import ExportOptions
from gearstudio.jobs import ExportJob
from gearstudio.kernel.step import read_name, settle
from gearstudio.methods.gear import blank_sizes, design_tooth, ignore
from gearstudio.methods.gear_mesh import gear_mesh, tooth_mesh
from gearstudio.presets import PRESETS
from gearstudio.results import Mesh
from gearstudio.theory.blank import blank_outline

pytestmark = pytest.mark.kernel

ROOT = Path(__file__).resolve().parents[2]
SOLIDS, MESHES = ("step", "iges", "brep"), ("stl", "3mf", "glb")
SMALL = with_field(with_field(Design(), "pair.pinion_teeth", 9), "pair.wheel_teeth", 14)


def export(directory: Path, formats: tuple[str, ...], **changes: Any) -> ExportJob:
    job = ExportJob(SMALL, "pinion", "gear", "profile_sweep", "optimised", formats, directory)
    return replace(job, **changes)


@pytest.mark.parametrize("part", ["tooth", "gear"])
def test_every_format_is_written_under_any_name_and_read_back(part: str, tmp_path: Path) -> None:
    folder = tmp_path / "Имя с пробелом 歯車"
    files = export(folder, SOLIDS + MESHES, part=part).run(ignore)
    assert [file.path.name for file in files] == [f"pinion-{part}.{kind}" for kind in SOLIDS + MESHES]
    for file in files:
        assert file.check is not None
        assert (file.check.valid, file.check.closed, file.check.solids) == (True, True, 1)
        assert file.check.volume_error < 1e-6
        assert file.check.box_error < 1e-4
        assert file.size == file.path.stat().st_size
    assert len(list(folder.iterdir())) == 6


def test_a_pair_is_an_assembly_of_two_named_parts(tmp_path: Path) -> None:
    files = export(tmp_path, ("step", "3mf", "glb"), member="pair").run(ignore)
    assert [file.check.solids for file in files if file.check] == [2, 2, 2]
    assert files[0].path == tmp_path / "pair-gear.step"
    names = step_names(files[0].path)
    assert names[""] == ["pair-gear"]
    assert sorted(names["pair-gear"]) == ["pinion", "wheel"]
    assert {"tooth 7 concave", "tooth 9 convex fillet", "tooth 1 root"} <= set(names["pinion"])
    assert len(names["wheel"]) > 14 * 5


def test_step_is_ap242_in_millimetres_with_colours(tmp_path: Path) -> None:
    (file,) = export(tmp_path, ("step",)).run(ignore)
    text = file.path.read_text()
    assert "AP242" in text
    assert "SI_UNIT(.MILLI.,.METRE.)" in text
    assert text.count("COLOUR_RGB") >= 3


def test_the_default_wheel_is_a_small_file(tmp_path: Path) -> None:
    for method in ("rotating_line", "point_cloud"):
        (file,) = export(tmp_path, ("step",), design=Design(), member="wheel", method=method).run(ignore)
        assert file.size < 4e6


def test_meshes_are_watertight_within_their_chord() -> None:
    for preset in PRESETS:
        for member in ("pinion", "wheel"):
            tooth = design_tooth(preset.design, member, "profile_sweep", "optimised")
            chord = 1e-4 * tooth.member.outer_cone_distance
            outline = blank_outline(tooth.member, blank_sizes(preset.design, member)).points
            whole, single = gear_mesh(tooth, outline, chord), tooth_mesh(tooth, chord)
            assert whole.is_closed
            assert single.is_closed
            assert min(whole.volume, single.volume) > 0
            assert largest_chord(whole, tooth) < chord


def largest_chord(mesh: Mesh, tooth: Any) -> float:
    """Farthest that middles of triangles lie from the flanks that they stand for, on the tooth at azimuth 0."""

    worst = 0.0
    for side in (-1, 1):
        flank = tooth.profile.flank(side)
        triangles = mesh.groups[flank.name]
        one = triangles[(np.arange(len(triangles)) % (len(triangles) // 2)) < len(triangles) // 2 // tooth.member.teeth]
        worst = max(worst, float(np.abs(flank.deviation(mesh.points[one].mean(axis=1))).max()))
    return worst


def test_an_open_mesh_is_not_called_closed() -> None:
    tooth = design_tooth(SMALL, "pinion", "point_cloud", "optimised")
    mesh = tooth_mesh(tooth, 0.05)
    tip = mesh.groups["tip"]
    assert not Mesh(mesh.points, {**mesh.groups, "tip": tip[1:]}).is_closed
    assert not Mesh(mesh.points, {**mesh.groups, "tip": tip[:, ::-1]}).is_closed
    assert not Mesh(mesh.points, {**mesh.groups, "again": tip[:1]}).is_closed


@pytest.mark.parametrize(("module", "kind"), [(stl, "stl"), (threemf, "3mf"), (glb, "glb")])
def test_a_file_that_was_cut_off_is_noticed(module: Any, kind: str, tmp_path: Path) -> None:
    (file,) = export(tmp_path, (kind,), part="tooth").run(ignore)
    file.path.write_bytes(file.path.read_bytes()[: file.size * 2 // 3])
    with pytest.raises(ValueError, match=r".+"):
        module.read(file.path)


def test_the_chord_asked_for_is_kept(tmp_path: Path) -> None:
    options = [ExportOptions(chord=chord) for chord in (0.1, 0.005)]
    coarse, fine = (export(tmp_path, ("stl",), options=each).run(ignore)[0].check for each in options)
    assert fine.faces > 3 * coarse.faces


FULL_DISK = """
import resource, sys
from pathlib import Path
from tests.kernel.test_exchange import export, ignore
from gearstudio.errors import FileError
resource.setrlimit(resource.RLIMIT_FSIZE, (30_000, 30_000))
try:
    export(Path(sys.argv[1]), (sys.argv[2],)).run(ignore)
except FileError as error:
    print(error)
    sys.exit(7)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="no limit on file sizes")
@pytest.mark.parametrize("kind", SOLIDS + MESHES)
def test_a_full_disk_is_noticed_and_the_older_file_stays(kind: str, tmp_path: Path) -> None:
    older = tmp_path / f"pinion-gear.{kind}"
    older.write_text("older")
    command = [sys.executable, "-c", FULL_DISK, str(tmp_path), kind]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 7, done.stderr
    assert str(older) in done.stdout
    assert [(path.name, path.read_text()) for path in tmp_path.iterdir()] == [(older.name, "older")]


@pytest.mark.parametrize("kind", ["step", "glb"])
def test_a_name_taken_by_a_folder_is_refused(kind: str, tmp_path: Path) -> None:
    (tmp_path / f"pinion-gear.{kind}").mkdir()
    with pytest.raises(FileError, match="a folder of this name"):
        export(tmp_path, (kind,)).run(ignore)


CUTTING = """
import sys
from pathlib import Path
from tests.kernel.test_exchange import export
def report(stage, fraction):
    print(stage, flush=True)
export(Path(sys.argv[1]), ("step",), construction="cut").run(report)
"""


def test_cancelling_in_the_middle_of_a_boolean_leaves_the_older_file_alone(tmp_path: Path) -> None:
    older = tmp_path / "pinion-gear.step"
    older.write_text("older")
    command = [sys.executable, "-c", CUTTING, str(tmp_path)]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        for line in process.stdout:
            if line.startswith("cutting"):
                break
        process.kill()
    export(tmp_path, ("step",)).clear_up(process.pid)
    assert [(path.name, path.read_text()) for path in tmp_path.iterdir()] == [(older.name, "older")]


def step_names(path: Path) -> dict[str, list[str]]:
    """Names in a STEP file by the name of the product that they belong to; products under an empty name."""
    settle()
    reader = STEPCAFControl_Reader()
    reader.SetNameMode(True)
    reader.ReadFile(str(path))
    document = TDocStd_Document(TCollection_ExtendedString("XmlXCAF"))
    reader.Transfer(document)
    shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    free, every = Sequence_TDF_Label(), Sequence_TDF_Label()
    shapes.GetFreeShapes(free)
    shapes.GetShapes(every)
    names: dict[str, list[str]] = {"": [read_name(free.Value(i)) for i in range(1, free.Length() + 1)]}
    for i in range(1, every.Length() + 1):
        label, below = every.Value(i), Sequence_TDF_Label()
        if shapes.IsAssembly_s(label):
            shapes.GetComponents_s(label, below)
        else:
            shapes.GetSubShapes_s(label, below)
        names[read_name(label)] = [read_name(below.Value(j)) for j in range(1, below.Length() + 1)]
    return names
