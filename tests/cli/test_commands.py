"""The command line: interface.md's names, its exit status, and one line for each problem."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import main as door
from gearstudio import cli
from gearstudio.catalogue import MEMBERS, METHOD_IDS, VARIANTS
from gearstudio.design import Design, with_field
from gearstudio.errors import ModellingError
from gearstudio.project import save_design
from tests.designs import GOLDEN

ROOT = Path(__file__).resolve().parents[2]
POINTS = ["--member", "pinion", "--flank", "concave", "--format", "dat"]
EXPORT = ["--member", "wheel", "--part", "flanks", "--format", "step"]
# From a printed technical reference: Gleason spiral bevel pair, 20/40, module 3, 20°, 35°, face width 20.
PRINTED = {
    "pair": {"pinion_teeth": 20, "wheel_teeth": 40, "outer_module": 3.0, "face_width": 20.0},
    "tooth": {
        "addendum_factor": 0.85,
        "clearance_factor": 0.188,
        "profile_shift": 0.2925,
        "tip_cone": "constant_clearance",
    },
}
PRINTED_VALUES = {
    "pitch_angle_deg": (26.56505, 63.43495),
    "outer_cone_distance": (67.08204, 67.08204),
    "addendum": (3.4275, 1.6725),
    "dedendum": (2.2365, 3.9915),
    "tip_angle_deg": (29.97024, 65.34447),
    "root_angle_deg": (24.65553, 60.02976),
    "outer_tip_diameter": (66.1313, 121.4959),
}


@pytest.fixture
def bad_design(tmp_path: Path) -> Path:
    path = tmp_path / "bad.gear.toml"
    path.write_text("format = 1\n[pair]\npinion_teeth = 3\nouter_module = 0\n", encoding="utf-8")
    return path


# --- info


@pytest.mark.parametrize("name", GOLDEN)
def test_info_gives_the_golden_values(name: str, run: Any, tmp_path: Path) -> None:
    design, record = GOLDEN[name]
    save_design(tmp_path / "a.gear.toml", design)
    status, _, problems = run("info", tmp_path / "a.gear.toml", "--json", tmp_path / "info.json")
    assert (status, problems) == (0, [])
    data = json.loads((tmp_path / "info.json").read_text(encoding="utf-8"))
    lengths = {"outer_cone_distance", "face_width", "base_radius"}
    for member in MEMBERS:
        for key, value in record[member].items():
            if key != "flank":
                assert data[member][key if key in lengths else f"{key}_deg"] == pytest.approx(value, abs=1e-10), key
    assert {"transverse_contact_ratio", "overlap_ratio"} <= data["pair"].keys()
    assert data["warnings"] == []


def test_info_gives_a_printed_reference(run: Any, tmp_path: Path) -> None:
    save_design(tmp_path / "a.gear.toml", Design.model_validate(PRINTED))
    _, out, _ = run("info", tmp_path / "a.gear.toml", "--json", "-")
    data = json.loads(out)
    for key, values in PRINTED_VALUES.items():
        for member, value in zip(MEMBERS, values, strict=True):
            assert data[member][key] == pytest.approx(value, abs=6e-5), (member, key)


def test_info_prints_a_table_and_its_warnings(run: Any, tmp_path: Path) -> None:
    design = with_field(with_field(Design(), "pair.pinion_teeth", 9), "pair.wheel_teeth", 41)
    save_design(tmp_path / "a.gear.toml", design)
    status, out, problems = run("info", tmp_path / "a.gear.toml", "--json", tmp_path / "info.json")
    assert (status, problems) == (0, [])
    lines = out.splitlines()
    assert any(line.split() == ["Pitch", "angle", "δ", "12.38076", "77.61924", "°"] for line in lines)
    assert any(line.split()[:3] == ["Total", "contact", "ratio"] for line in lines)
    assert any(line.startswith("warning: tooth.profile_shift: ") for line in lines)
    data = json.loads((tmp_path / "info.json").read_text(encoding="utf-8"))
    assert [(w["code"], w["field"]) for w in data["warnings"]] == [("interference", "tooth.profile_shift")]


def test_info_holds_the_data_sheet(run: Any) -> None:
    _, out, _ = run("info", "preset:default", "--json", "-")
    data = json.loads(out)
    sheet = {(line["name"], line["owner"]): line for line in data["datasheet"]}
    for member in MEMBERS:
        assert sheet["Pitch angle", member]["value"] == pytest.approx(data[member]["pitch_angle_deg"], abs=1e-12)
    ratio = sheet["Transverse contact ratio", "pair"]
    assert ratio["value"] == pytest.approx(data["pair"]["transverse_contact_ratio"])
    assert ratio["unit"] == "" and ratio["formula"] and {"symbol", "value", "unit"} == set(ratio["inputs"][0])


def test_info_to_standard_output_is_nothing_but_json(run: Any) -> None:
    status, out, problems = run("info", "preset:zerol", "--json", "-")
    assert (status, problems) == (0, [])
    assert json.loads(out)["pinion"]["teeth"] == 25


# --- points


def test_points_of_both_flanks_with_normals(run: Any, tmp_path: Path) -> None:
    target = tmp_path / "nominal.csv"
    given = [
        "points",
        "preset:default",
        "--member",
        "pinion",
        "--flank",
        "both",
        "--rows",
        9,
        "--cols",
        5,
        "--out",
        target,
    ]
    assert run(*given, "--format", "csv") == (0, "", [])
    head, *lines = target.read_text(encoding="utf-8").splitlines()
    assert head == "x,y,z,nx,ny,nz,flank,row,column" and len(lines) == 2 * 9 * 5
    status, out, _ = run("measure", "preset:default", target, "--member", "pinion", "--json", "-")
    record = json.loads(out)
    assert status == 0 and record["max_um"] < 1e-6 and record["count"] == 90
    assert {point["flank"] for point in record["points"]} == {"concave", "convex"}
    status, _, problems = run(*given, "--format", "dat")
    assert status == 2 and "csv" in problems[0]


def test_points_go_to_a_file_or_to_standard_output(run: Any, tmp_path: Path) -> None:
    size = ["--rows", 3, "--cols", 4]
    assert run("points", "preset:default", *POINTS, *size, "--out", tmp_path / "a.dat") == (0, "", [])
    status, out, problems = run("points", "preset:default", *POINTS, *size, "--out", "-")
    assert (status, problems) == (0, [])
    assert out == (tmp_path / "a.dat").read_text(encoding="utf-8")
    points = np.loadtxt(tmp_path / "a.dat").reshape(3, 4, 3)
    rho = np.linalg.norm(points, axis=-1)
    assert np.allclose(rho, rho[:, :1]) and rho[0, 0] < rho[1, 0] < rho[2, 0]
    polar = np.arccos(points[..., 2] / rho)
    assert np.all(np.diff(polar, axis=1) > 0)


@pytest.mark.parametrize("count", ["1", "0", "-3", "2001", "7.5", "many", "9" * 5000, "nan", ""])
@pytest.mark.parametrize("option", ["--rows", "--cols"])
def test_a_number_of_lines_has_limits(option: str, count: str, run: Any) -> None:
    status, out, problems = run("points", "preset:default", *POINTS, "--out", "-", f"{option}={count}")
    assert (status, out) == (2, "")
    assert len(problems) == 1 and option in problems[0] and "use 2 to 2000" in problems[0]


# --- compare


@pytest.mark.kernel
def test_compare_lists_every_method_and_variant(run: Any, tmp_path: Path) -> None:
    status, out, problems = run("compare", "preset:default", "--member", "wheel", "--json", tmp_path / "c.json")
    assert (status, problems) == (0, [])
    methods = json.loads((tmp_path / "c.json").read_text(encoding="utf-8"))["members"]
    assert list(methods) == ["wheel"]
    assert {(m, v) for m, variants in methods["wheel"].items() for v in variants} == {
        (m, v) for m in METHOD_IDS for v in VARIANTS
    }
    for variants in methods["wheel"].values():
        for record in variants.values():
            assert 0 < record["mean_um"] <= record["rms_um"] <= record["max_um"]
            assert record["max_um"] == pytest.approx(max(-record["lowest_um"], record["highest_um"]))
            assert record["max_um"] == max(flank["max_um"] for flank in record["flanks"].values())
            assert record["edge_um"] == max(flank["edge_um"] for flank in record["flanks"].values())
            assert record["seconds"] > 0 and record["settings"]
            assert len(record["poles"]) == len(record["degree"]) == 2
        assert variants["optimised"]["max_um"] <= 0.05
    assert sum("optimised" in line for line in out.splitlines()) == len(METHOD_IDS)


@pytest.mark.kernel
def test_a_variant_that_fails_leaves_the_others(run: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from gearstudio.analysis import comparison

    sound = comparison.build_variant

    def build(design: Design, member: str, method: str, variant: Any) -> Any:
        if (method, variant) == ("profile_sweep", "published"):
            raise ModellingError(method, "pipe", "no shape")
        return sound(design, member, method, variant)

    monkeypatch.setattr(comparison, "build_variant", build)
    status, out, problems = run("compare", "preset:default", "--member", "pinion", "--json", tmp_path / "c.json")
    assert status == 1
    assert problems == ["pinion profile_sweep published: profile_sweep: pipe failed: no shape"]
    assert "failed: profile_sweep: pipe failed: no shape" in out
    methods = json.loads((tmp_path / "c.json").read_text(encoding="utf-8"))["members"]["pinion"]
    assert methods["profile_sweep"]["published"] == {"error": "profile_sweep: pipe failed: no shape"}
    assert "max_um" in methods["profile_sweep"]["optimised"] and "max_um" in methods["point_cloud"]["published"]


# --- export


@pytest.mark.kernel
def test_export_makes_its_folder_and_names_each_file(run: Any, tmp_path: Path) -> None:
    folder = tmp_path / "new" / "parts"
    status, out, problems = run("export", "preset:straight", *EXPORT, "--out", folder)
    assert (status, problems) == (0, [])
    assert out.splitlines() == [str(folder / "wheel-flanks.step")]
    assert [path.name for path in folder.iterdir()] == ["wheel-flanks.step"]
    assert (folder / "wheel-flanks.step").read_text(encoding="utf-8").startswith("ISO-10303-21")


@pytest.mark.parametrize("part", ["flanks", "tooth"])
def test_what_export_does_not_offer_is_said(part: str, run: Any, tmp_path: Path) -> None:
    status, _, problems = run(
        "export", "preset:default", "--member", "pair", "--part", part, "--format", "stl", "--out", tmp_path / "new"
    )
    assert status == 2
    assert [line.split(":")[0] for line in problems] == (["--format"] if part == "flanks" else []) + ["--part"]
    assert not (tmp_path / "new").exists()


# --- problems


@pytest.mark.parametrize(
    "argv",
    [
        ["info"],
        ["compare", "--member", "both"],
        ["points", *POINTS, "--out", "-"],
        ["export", *EXPORT, "--out", "out"],
    ],
)
def test_an_unusable_design_is_one_line_for_each_problem(argv: list[str], run: Any, bad_design: Path) -> None:
    status, out, problems = run(argv[0], bad_design, *argv[1:])
    assert (status, out) == (2, "")
    assert problems == [
        "pair.pinion_teeth: 3 is below the least of 5 teeth; use 5 to 200",
        "pair.outer_module: 0 is below the least of 0.1 mm; use 0.1 to 100",
    ]


@pytest.mark.parametrize("name", ["none.gear.toml", "", ".", "preset:none", "preset:", "a\0b", "line\nbreak"])
def test_a_design_that_is_not_there_is_one_line(name: str, run: Any) -> None:
    status, out, problems = run("info", name)
    assert (status, out, len(problems)) == (2, "", 1)


@pytest.mark.parametrize(
    "argv",
    [
        [],
        ["info"],
        ["infos", "preset:default"],
        ["info", "preset:default", "extra"],
        ["points", "preset:default"],
        ["points", "preset:default", *POINTS, "--out", "-", "--spacing", "even"],
        ["compare", "preset:default", "--member", "gear"],
        ["compare", "preset:default", "--json"],
        ["export", "preset:default", *EXPORT],
        ["export", "preset:default", *EXPORT, "--out", "x", "--method", "magic"],
        ["report", "preset:default"],
    ],
)
def test_wrong_arguments_are_one_line_and_status_2(argv: list[str], run: Any) -> None:
    status, out, problems = run(*argv)
    assert (status, out, len(problems)) == (2, "", 1)


def test_a_file_that_cannot_be_written_is_one_line(run: Any, tmp_path: Path) -> None:
    missing = tmp_path / "none" / "a.json"
    status, _, problems = run("info", "preset:default", "--json", missing)
    assert status == 2
    assert problems == [f"{missing}: there is no such file or folder; choose another folder, or make this one first"]


def test_an_unexpected_failure_is_one_line_and_a_log(run: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(design: object) -> None:
        raise ZeroDivisionError("division by zero")

    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    monkeypatch.setenv("LOCALAPPDATA", str(tmp_path))
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setattr("gearstudio.cli.info.pair_geometry", fail)
    status, out, problems = run("info", "preset:default")
    assert (status, out, len(problems)) == (1, "", 1)
    assert "ZeroDivisionError" in problems[0]
    log = Path(problems[0].rpartition(" are in ")[2])
    assert log.is_relative_to(tmp_path)
    assert "Traceback" in log.read_text(encoding="utf-8")


def test_an_interrupt_has_its_own_status(run: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(name: str) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("gearstudio.cli.info.open_design", interrupt)
    assert run("info", "preset:default") == (130, "", ["interrupted"])


# --- the one door


def test_the_door_knows_the_commands() -> None:
    assert door.COMMANDS == cli.COMMANDS


@pytest.mark.parametrize(("word", "said"), [("inf", "the nearest command is info"), ("Export", "export")])
def test_a_mistyped_command_opens_no_window(word: str, said: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert door.main([word, "preset:default"]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert said in line


@pytest.mark.parametrize("argv", [["--version"], ["--help"], ["info", "--help"]])
def test_help_is_printed(argv: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert door.main(argv) == 0
    captured = capsys.readouterr()
    assert captured.out and not captured.err


def test_light_commands_load_nothing_heavy() -> None:
    program = (
        "import sys, main; status = main.main(['info', 'preset:default', '--json', '-']);"
        "heavy = {'OCP', 'build123d', 'scipy', 'PySide6', 'pyvista', 'vtk', 'vtkmodules'};"
        "sys.exit(status or len(heavy & {name.split('.')[0] for name in sys.modules}))"
    )
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr


def test_a_reader_that_leaves_early_is_no_failure() -> None:
    command = [sys.executable, "main.py", "points", "preset:default", *POINTS, "--rows", "300", "--cols", "300"]
    with subprocess.Popen(
        [*command, "--out", "-"], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdout is not None and process.stderr is not None
        process.stdout.readline()
        process.stdout.close()
        assert process.stderr.read() == b""
        assert process.wait(60) == 0


@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "utf-8"])
def test_any_terminal_can_show_the_table(encoding: str) -> None:
    done = subprocess.run(
        [sys.executable, "main.py", "info", "preset:default"],
        cwd=ROOT,
        capture_output=True,
        check=False,
        env={"PYTHONIOENCODING": encoding, "PATH": ""},
    )
    assert done.returncode == 0 and not done.stderr
    assert b"Pitch angle" in done.stdout
