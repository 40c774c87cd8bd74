"""The commands ``contact`` and ``measure``: interface.md's names, exit status, and one line for each problem."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gearstudio.analysis.contact_placing import Misalignment
from gearstudio.cli.contact import misalignment, thickness
from gearstudio.cli.numbers import number
from gearstudio.cli.parser import make_parser
from gearstudio.design import Design, with_field
from gearstudio.project import save_design


@pytest.fixture
def design(tmp_path: Path) -> Path:
    path = tmp_path / "pair.gear.toml"
    save_design(path, Design())
    return path


@pytest.fixture
def points(run: Any, design: Path, tmp_path: Path) -> Path:
    path = tmp_path / "points.dat"
    status, *_ = run(
        "points", design, "--member", "wheel", "--flank", "concave", "--format", "dat", "--out", path, "--rows", 5
    )
    assert status == 0
    return path


def test_contact_writes_what_interface_names(run: Any, design: Path, tmp_path: Path) -> None:
    target = tmp_path / "contact.json"
    status, out, problems = run("contact", design, "--json", target)
    assert status == 0 and problems == [] and "transmission error" in out
    record = json.loads(target.read_text())
    for side in (record, record["coast"]):
        error = np.array(side["transmission_error_arcsec"])
        assert error.shape[1] == 2 and np.ptp(error[:, 0]) == pytest.approx(3 * 360 / 17)
        assert side["peak_to_peak_arcsec"] <= 0.01
        pattern = side["pattern"]
        assert np.array(pattern["gap_um"]).shape == (len(pattern["rho"]), len(pattern["delta_deg"]))
        assert np.max(pattern["gap_um"]) < 0.01
        assert side["contact_ratio"] == pytest.approx(1.531 + 1.724, abs=0.02)


def test_contact_alone_on_standard_output(run: Any, design: Path) -> None:
    status, out, _ = run("contact", design, "--json", "-", "--misalign", "-0.05,0.02,0,-0.01")
    record = json.loads(out)
    assert status == 0
    assert record["misalignment"] == {"E_mm": -0.05, "P_mm": 0.02, "G_mm": 0.0, "S_deg": -0.01}
    assert record["peak_to_peak_arcsec"] > 1


def test_contact_warns_of_edges(run: Any, design: Path) -> None:
    status, _, problems = run("contact", design, "--misalign=0,0,0.05,0")
    assert status == 0
    assert problems and all(line.startswith("warning: ") for line in problems)


@pytest.mark.parametrize(
    ("value", "reason"),
    [
        ("30,0,0,0", "no contact"),
        ("-30,0,0,0", "no contact"),
        ("1,2,3", "not E,P,G,S"),
        ("1,2,3,x", "not E,P,G,S"),
        ("nan,0,0,0", "not E,P,G,S"),
        ("", "not E,P,G,S"),
    ],
)
def test_contact_refuses_in_one_line(run: Any, design: Path, value: str, reason: str) -> None:
    status, out, problems = run("contact", design, "--misalign", value)
    assert status == 2 and out == "" and len(problems) == 1 and reason in problems[0]


@pytest.mark.parametrize(
    "text", ["-0.05,0.02,0,-0.01", "-0,05;0,02;0;-0,01", "-0,05 0,02 0 -0,01", "−0.05, 0.02, 0, -.01"]
)
def test_a_misalignment_has_points_and_commas_or_commas_and_semicolons(text: str) -> None:
    assert misalignment(text) == Misalignment(-0.05, 0.02, 0.0, -0.01)


@pytest.mark.parametrize("text", ["0,05,0,0", "0,1,0,0,0", "0,05,0,0,0,0,0,0", "-0,5,0,0,0"])
def test_commas_that_seem_to_stand_before_decimals_are_not_guessed_at(run: Any, design: Path, text: str) -> None:
    status, out, problems = run("contact", design, "--misalign", text)
    assert (status, out, len(problems)) == (2, "", 1)
    assert f"the commas of {text} part 4 numbers" in problems[0] and '"0,05;0;0;0"' in problems[0]
    assert misalignment("0,05;0;0;0").offset == 0.05


@pytest.mark.parametrize(
    ("text", "value"), [("3,5", 3.5), ("0,050", 0.05), (",5", 0.5), ("1,5e-1", 0.15), ("12", 12.0)]
)
def test_a_single_number_may_have_a_decimal_comma(text: str, value: float) -> None:
    assert number(text) == thickness(text) == value


def test_a_comma_that_may_part_thousands_is_not_guessed_at(run: Any, design: Path) -> None:
    status, _, problems = run("contact", design, "--thickness", "1,500")
    assert status == 2 and "1,500 may be 1.500 or 1500; write one of them" in problems[0]
    assert np.isnan(number("1,2,3")) and np.isnan(number("a")) and np.isnan(number("1,500.5"))


def test_contact_refuses_a_thickness_of_nothing(run: Any, design: Path) -> None:
    status, _, problems = run("contact", design, "--thickness", "0")
    assert status == 2 and "thickness" in problems[0]


def test_measure_writes_what_interface_names(run: Any, design: Path, points: Path, tmp_path: Path) -> None:
    target = tmp_path / "measured.json"
    status, out, problems = run("measure", design, points, "--member", "wheel", "--json", target)
    assert status == 0 and problems == [] and "concave" in out
    record = json.loads(target.read_text())
    assert record["count"] == len(record["points"]) == 35
    assert record["best_fit"] == pytest.approx({"rotation_deg": 0, "axial_mm": 0}, abs=1e-9)
    assert record["max_um"] < 1e-6 and record["mean_um"] <= record["rms_um"] <= record["max_um"]
    exact = np.loadtxt(points)
    assert np.array_equal([point["xyz"] for point in record["points"]], exact)
    assert {(point["flank"], point["tooth"]) for point in record["points"]} == {("concave", 0)}


def test_measure_finds_how_the_part_lay(run: Any, design: Path, points: Path, tmp_path: Path) -> None:
    x, y, z = np.loadtxt(points).T
    angle = np.radians(11.0)  # one pitch of 9 degrees and 2 degrees more
    moved = np.stack([x * np.cos(angle) - y * np.sin(angle), x * np.sin(angle) + y * np.cos(angle), z + 0.25], axis=1)
    np.savetxt(tmp_path / "moved.csv", moved, delimiter=",", header="x,y,z", comments="", fmt="%.17g")
    status, out, _ = run("measure", design, tmp_path / "moved.csv", "--member", "wheel", "--json", "-")
    record = json.loads(out)
    assert status == 0
    assert record["best_fit"]["rotation_deg"] == pytest.approx(2, abs=1e-6)
    assert record["best_fit"]["axial_mm"] == pytest.approx(0.25, abs=1e-6)
    assert {point["tooth"] for point in record["points"]} == {1}
    status, out, _ = run("measure", design, tmp_path / "moved.csv", "--member", "wheel", "--json", "-", "--no-shift")
    assert json.loads(out)["best_fit"]["axial_mm"] == 0 and json.loads(out)["max_um"] > 1


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("1 2\n", "columns"),
        ("1 2 nan\n", "finite"),
        ("1 2 3\n4 5 6\n", "too few"),
        ("100 0 0\n0 100 0\n0 0 100\n", "another gear"),
    ],
)
def test_measure_refuses_in_one_line(run: Any, design: Path, tmp_path: Path, text: str, reason: str) -> None:
    (tmp_path / "bad.dat").write_text(text)
    status, out, problems = run("measure", design, tmp_path / "bad.dat", "--member", "wheel")
    assert status == 2 and out == "" and len(problems) == 1
    assert reason in problems[0] and "bad.dat" in problems[0]


def test_measure_says_inches(run: Any, design: Path, points: Path, tmp_path: Path) -> None:
    np.savetxt(tmp_path / "inch.dat", np.loadtxt(points) / 25.4)
    status, _, problems = run("measure", design, tmp_path / "inch.dat", "--member", "wheel")
    assert status == 2 and "inches" in problems[0]


def test_measure_names_a_missing_file(run: Any, design: Path, tmp_path: Path) -> None:
    status, _, problems = run("measure", design, tmp_path / "none.dat", "--member", "wheel")
    assert status == 2 and "none.dat" in problems[0] and len(problems) == 1


def test_measure_warns_of_points_that_another_cutter_explains(run: Any, points: Path, tmp_path: Path) -> None:
    other, target = tmp_path / "other.gear.toml", tmp_path / "measured.json"
    save_design(other, with_field(Design(), "lengthwise.cutter_radius", 72.0))
    status, _, problems = run("measure", other, points, "--member", "wheel", "--json", target)
    assert status == 0
    (warning,) = json.loads(target.read_text())["warnings"]
    assert (warning["code"], warning["field"]) == ("other_gear_likely", "lengthwise.cutter_radius")
    assert "80 mm instead of a cutter radius of 72 mm" in warning["message"]
    assert len(problems) == 1 and "warning: lengthwise.cutter_radius: the points fit this wheel badly" in problems[0]


def test_every_option_that_takes_a_length_takes_a_decimal_comma() -> None:
    parse = make_parser().parse_args
    made = parse(["measure", "preset:default", "p.step", "--member", "wheel", "--spacing", "0,5"])
    words = ["export", "preset:default", "--member", "wheel", "--part", "gear", "--format", "stl", "--out", "."]
    assert made.spacing == 0.5 and parse([*words, "--chord", "0,01"]).chord == 0.01
