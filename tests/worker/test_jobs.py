"""The product's jobs: light to import, honest about what they cannot do, and nothing half-made left."""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
from dataclasses import FrozenInstanceError, replace
from pathlib import Path

import pytest

from gearstudio.design import Design
from gearstudio.errors import FileError
from gearstudio.jobs import BuildJob, ExportJob, warm_up
from gearstudio.results import VariantResult

ROOT = Path(__file__).resolve().parents[2]


def ignore(stage: str, fraction: float) -> None:
    """No one watches."""


def export(directory: Path) -> ExportJob:
    return ExportJob(Design(), "wheel", "flanks", "point_cloud", "published", ("step",), directory)


@pytest.mark.parametrize("module", ["gearstudio.jobs", "gearstudio.worker"])
def test_importing_loads_nothing_heavy(module: str) -> None:
    program = f"import {module}, sys; sys.exit(not {{'OCP', 'build123d', 'numpy', 'pydantic'}}.isdisjoint(sys.modules))"
    assert subprocess.run([sys.executable, "-c", program], cwd=ROOT, check=False).returncode == 0


def test_jobs_are_frozen_and_travel() -> None:
    for job in (BuildJob(Design(), "pinion", "point_cloud", "published"), export(Path("out"))):
        assert pickle.loads(pickle.dumps(job)) == job
        with pytest.raises(FrozenInstanceError):
            job.member = "wheel"  # type: ignore[misc]


def test_labels_name_what_is_made() -> None:
    assert BuildJob(Design(), "pinion", "point_cloud", "published").label == "pinion, point_cloud, published"
    assert export(Path("out")).label == "wheel-flanks, step"


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"part": "hub"}, "'hub' is not offered"),
        ({"member": "pair"}, "of a pair only the part 'gear'"),
        ({"part": "gear", "construction": "cast"}, "no construction 'cast'"),
        ({"formats": ("step", "dxf")}, "cannot be written as 'dxf'"),
    ],
)
def test_what_is_not_offered_is_refused_before_anything_is_written(
    tmp_path: Path, change: dict[str, object], words: str
) -> None:
    with pytest.raises(FileError, match=words):
        replace(export(tmp_path), **change).run(ignore)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_is_a_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "taken").write_text("")
    with pytest.raises(FileError, match="a file where the folder should be"):
        export(tmp_path / "taken").run(ignore)
    with pytest.raises(FileError, match="not a folder"):
        export(tmp_path / "taken" / "deeper").run(ignore)


def test_a_name_taken_by_a_folder_is_refused(tmp_path: Path) -> None:
    (tmp_path / "wheel-flanks.step").mkdir()
    with pytest.raises(FileError, match="a folder of this name"):
        export(tmp_path).run(ignore)


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write anywhere")
def test_a_folder_without_permission_is_refused(tmp_path: Path) -> None:
    tmp_path.chmod(0o500)
    with pytest.raises(FileError, match="no permission"):
        export(tmp_path).run(ignore)


def test_clearing_up_removes_what_a_killed_process_left_and_nothing_else(tmp_path: Path) -> None:
    for name in (".77-wheel-flanks.step", ".78-wheel-flanks.step", "wheel-flanks.step"):
        (tmp_path / name).write_text("")
    export(tmp_path).clear_up(77)
    export(tmp_path).clear_up(77)
    assert sorted(path.name for path in tmp_path.iterdir()) == [".78-wheel-flanks.step", "wheel-flanks.step"]


@pytest.mark.kernel
def test_warming_up_imports_what_jobs_need() -> None:
    warm_up()
    assert "OCP" in sys.modules


@pytest.mark.kernel
def test_building_gives_both_flanks_with_the_samples_asked_for() -> None:
    stages: list[tuple[str, float]] = []
    result = BuildJob(Design(), "wheel", "point_cloud", "published", (9, 11)).run(lambda *told: stages.append(told))
    assert isinstance(result, VariantResult)
    assert {flank: made.deviation_um.shape for flank, made in result.flanks.items()} == {
        "concave": (9, 11),
        "convex": (9, 11),
    }
    assert stages == [("building", 0.0)]


@pytest.mark.kernel
def test_exporting_makes_the_folder_and_replaces_an_older_file(tmp_path: Path) -> None:
    folder = tmp_path / "new" / "folder"
    (file,) = export(folder).run(ignore)
    assert file.path == folder / "wheel-flanks.step"
    assert file.size == file.path.stat().st_size > 10_000
    file.path.write_text("older")
    export(folder).run(ignore)
    assert file.path.read_text().startswith("ISO-10303-21")
    assert [path.name for path in folder.iterdir()] == ["wheel-flanks.step"]


FULL_DISK = """
import resource, sys
from pathlib import Path
from tests.worker.test_jobs import export, ignore
from gearstudio.errors import FileError
resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))
try:
    export(Path(sys.argv[1])).run(ignore)
except FileError as error:
    print(error)
    sys.exit(7)
"""


@pytest.mark.kernel
@pytest.mark.skipif(sys.platform == "win32", reason="no limit on file sizes")
def test_a_full_disk_is_noticed_and_the_older_file_stays(tmp_path: Path) -> None:
    (tmp_path / "wheel-flanks.step").write_text("older")
    done = subprocess.run(
        [sys.executable, "-c", FULL_DISK, str(tmp_path)], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert done.returncode == 7, done.stderr
    assert str(tmp_path / "wheel-flanks.step") in done.stdout
    assert [(path.name, path.read_text()) for path in tmp_path.iterdir()] == [("wheel-flanks.step", "older")]
