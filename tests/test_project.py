"""Design files: what is written reads back, what is damaged says how, and nothing is left half-made."""

from __future__ import annotations

import errno
import os
import pickle
import stat
import tomllib
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from gearstudio import files
from gearstudio.design import Design, all_field_specs, with_field
from gearstudio.errors import DesignError, FileError
from gearstudio.presets import PRESETS
from gearstudio.project import design_text, load_design, open_design, save_design
from gearstudio.validation import check
from tests.designs import GOLDEN

one_line = st.text(
    st.characters(exclude_categories=["Cc", "Cs", "Zl", "Zp"]), max_size=20
)  # letters of every script, quotes and backslashes among them


def load_error(path: Path) -> str:
    with pytest.raises((DesignError, FileError)) as caught:
        load_design(path)
    return str(caught.value)


# --- what is written reads back


@pytest.mark.parametrize("preset", PRESETS, ids=lambda preset: preset.key)
def test_presets_survive_the_file(preset: Any, tmp_path: Path) -> None:
    save_design(tmp_path / "a.gear.toml", preset.design)
    assert load_design(tmp_path / "a.gear.toml") == preset.design


@pytest.mark.parametrize("name", GOLDEN)
def test_golden_designs_survive_the_file(name: str, tmp_path: Path) -> None:
    save_design(tmp_path / "a.gear.toml", GOLDEN[name][0])
    assert load_design(tmp_path / "a.gear.toml") == GOLDEN[name][0]


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    name=one_line,
    module=st.floats(3.9, 4.1),
    angle=st.floats(34.0, 36.0),
    bore=st.one_of(st.none(), st.floats(0.0, 20.0)),
    width=st.one_of(st.none(), st.floats(10.0, 30.0)),
)
def test_any_value_survives_the_file_exactly(
    name: str, module: float, angle: float, bore: float | None, width: float | None, tmp_path: Path
) -> None:
    design = Design()
    for path, value in {
        "name": name,
        "pair.outer_module": module,
        "lengthwise.spiral_angle_deg": angle,
        "blank.pinion.bore_diameter": bore,
        "pair.face_width": width,
        "lengthwise.spiral_angle_of": "wheel",
    }.items():
        design = with_field(design, path, value)
    assert not [issue for issue in check(design) if issue.severity == "error"]
    save_design(tmp_path / "a.gear.toml", design)
    assert load_design(tmp_path / "a.gear.toml") == design


def test_the_file_names_every_field_of_a_bevel_pair() -> None:
    text = design_text(Design())
    assert text.startswith("format = 1\n")
    for spec in all_field_specs().values():
        key = spec.path.rpartition(".")[2]
        assert f"\n{key} = " in text or f"\n# {key} = derived" in text, spec.path


def test_missing_keys_take_their_defaults(tmp_path: Path) -> None:
    path = tmp_path / "a.gear.toml"
    path.write_text("format = 1\n", encoding="utf-8")
    assert load_design(path) == Design()


@pytest.mark.parametrize("content", [b"\xef\xbb\xbfformat = 1\n", b"format = 1\r\n[pair]\r\npinion_teeth = 17\r\n"])
def test_other_editors_habits_are_read(content: bytes, tmp_path: Path) -> None:
    path = tmp_path / "a.gear.toml"
    path.write_bytes(content)
    assert load_design(path) == Design()


def test_presets_open_by_key() -> None:
    assert open_design("preset:default") == Design()
    with pytest.raises(FileError, match="preset:default"):
        open_design("preset:defalt")


# --- damage


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "the file is empty and holds no design"),
        (b" \n\t\n", "the file is empty"),
        (b"\xef\xbb\xbf", "the file is empty"),
        (b"\x89PNG\r\n\x1a\n\x00\x00", "this is a picture (PNG), no design of GearStudio"),
        (b"\x7fELF\x02\x01\x01\x00", "this is no text, so no design of GearStudio"),
        (b"ISO-10303-21;\nHEADER;\n", "this is a model (STEP), no design"),
        (b"x,y,z\n1,2,3\n", "nothing in it belongs to a design of GearStudio"),
        (b"[project]\nname = 'other'\n", "nothing in it belongs to a design of GearStudio"),
        (b'format = 1\nname = "\xe4"\n', "line 2 is not UTF-8"),
        ("format = 1\n".encode("utf-16"), "is not UTF-8 but UTF-16"),
        (b"format = 1\n[pair\n", "line 2, “[pair”: the heading of a table stands alone"),
        (b"PK\x03\x04\x00\x00", "this is an archive (ZIP)"),
        (b"format = 1\nformat = 1\n", "line 2, “format = 1”: “format” stands in line 1 too"),
        (b"format = 7\n[other]\nkey = 1\n", "7 is newer than format 1, which this GearStudio reads; update GearStudio"),
        (b"format = 0\n", "format: 0 is unknown"),
        (b'format = "1"\n', '"1" is not a format number'),
        (b"[pair]\npinion_teeth = 17\n", "format = 1"),
        (
            b"format = 1\n[pair]\npinion_teth = 17\n",
            "pair.pinion_teth: unknown key; the nearest known one is pair.pinion_",
        ),
        (b'format = 1\n[pair]\npinion_teeth = "17"\n', '"17" is a text; use 5 to 200'),
        (
            b'format = 1\n[pair]\nouter_module = "3,5"\n',
            '"3,5" is a text; use 0.1 to 100, with a point and without quotation marks',
        ),
        (b'format = 1\n[pair]\npinion_teeth = "few"\n', 'pair.pinion_teeth: "few" is not a whole number; use 5 to'),
        (b'format = 1\n[pair]\npinion_teeth = " "\n', "pair.pinion_teeth: the value is empty; use 5 to 200"),
        (b"format = 1\n[pair]\npinion_teeth = 1979-05-27\n", "a value of type date is not a whole number"),
        (b"format = 1\n[pair]\nouter_module = nan\n", "nan is not a finite number"),
        (b"format = 1\npair = 5\n", "pair: 5 is not a table"),
        (b"format = 1\n[[pair]]\npinion_teeth = 17\n", "pair: a list is not a table"),
        (b"format = 1\na = " + b"[" * 100_000, "nested too deeply"),
        (b"format = 1\n[pair]\npinion_teeth = " + b"9" * 10_000, "thousands of digits"),
        (b"format = 1\n#" + b" " * 1_100_000, "too large for a design file"),
    ],
)
def test_damage_is_named(content: bytes, said: str, tmp_path: Path) -> None:
    path = tmp_path / "a.gear.toml"
    path.write_bytes(content)
    assert said in load_error(path)


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("outer_module = 3,5", "have a point, not a comma; write “outer_module = 3.5”"),
        ("outer_module=-1,25e1 # mm", "have a point, not a comma; write “outer_module = -1.25e1”"),
        ("outer_module = 3,5 mm", "without a unit, which is always the same; write “outer_module = 3.5”"),
        ("outer_module = 3.5mm", "write “outer_module = 3.5”"),
        ("outer_module = .5", "digits on both sides of its point; write “outer_module = 0.5”"),
        ("outer_module = -5. # mm", "write “outer_module = -5.0”"),
        ("outer_module =", "the value after the sign = is missing"),
        ("outer_module = # mm", "the value after the sign = is missing"),
        ("outer_module: 3.5", "this is no heading of a table"),
        ("pinion_hand = left", 'straight quotation marks; write “pinion_hand = "left"”'),
        ("pinion_hand = “left”", 'write “pinion_hand = "left"”'),
        ('pinion_hand = "left', "two straight quotation marks on one line"),
        ("outer_module = 3.5.1", "neither a number"),
    ],
)
def test_a_line_that_cannot_be_read_is_quoted_with_what_to_write(line: str, said: str, tmp_path: Path) -> None:
    path = tmp_path / "a.gear.toml"
    path.write_text(f"format = 1\n[pair]\n{line}\nwheel_teeth = 40\n", encoding="utf-8")
    found = load_error(path)
    assert found.startswith(f"line 3, “{line}”: ") and said in found
    assert "\n" not in found and "TOML" not in found
    _, offered, remedy = found.rpartition("; write ")
    assert not offered or tomllib.loads(remedy.strip("“”")), "what is offered can be read"


def test_all_decimal_commas_are_told_at_once_and_the_file_once(tmp_path: Path) -> None:
    path = tmp_path / "a.gear.toml"
    path.write_text("format = 1\n[pair]\nouter_module = 3,5\nshaft_angle_deg = 90,0\n", encoding="utf-8")
    with pytest.raises(DesignError) as caught:
        load_design(path)
    assert [issue.message[:6] for issue in caught.value.issues] == ["line 3", "line 4"]
    assert caught.value.path == str(path) and str(path) not in str(caught.value)
    again = pickle.loads(pickle.dumps(caught.value))
    assert (again.issues, again.path, str(again)) == (caught.value.issues, caught.value.path, str(caught.value))


def test_every_problem_of_a_file_is_reported(tmp_path: Path) -> None:
    path = tmp_path / "a.gear.toml"
    path.write_text("[pair]\npinion_teeth = 3\nwheel_teeth = 500\n[lengthwise]\ncutter_radius = -1\n", encoding="utf-8")
    with pytest.raises(DesignError) as caught:
        load_design(path)
    assert {issue.field for issue in caught.value.issues} == {
        "format",
        "pair.pinion_teeth",
        "pair.wheel_teeth",
        "lengthwise.cutter_radius",
    }


@given(content=st.binary(max_size=60))
@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_no_content_raises_anything_else(content: bytes, tmp_path: Path) -> None:
    path = tmp_path / "a.gear.toml"
    for text in (content, b"format = 1\n" + content):
        path.write_bytes(text)
        try:
            load_design(path)
        except (DesignError, FileError) as error:
            assert str(error)


def test_a_missing_file_and_a_folder_are_named(tmp_path: Path) -> None:
    assert load_error(tmp_path / "none.gear.toml").endswith(
        "there is no such file or folder; check its name, it may have been moved"
    )
    assert "this is a folder, not a file" in load_error(tmp_path)
    assert "a part of the path is a file" in load_error(Path(__file__) / "a.gear.toml")
    assert "this is not a file name" in load_error(Path("a\0b"))
    assert "this is a device" in load_error(Path(os.devnull))


# --- writing


def fail_with(number: int) -> Any:
    def fail(*args: object) -> None:
        raise OSError(number, os.strerror(number))

    return fail


@pytest.mark.parametrize(
    ("number", "said"),
    [(errno.ENOSPC, "the disk is full"), (errno.EACCES, "no permission"), (errno.EROFS, "the disk is read-only")],
)
def test_a_failed_save_keeps_what_was_there(
    number: int, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.gear.toml"
    save_design(path, Design())
    for step in ("fsync", "replace"):
        with monkeypatch.context() as patch:
            patch.setattr(files.os, step, fail_with(number))
            with pytest.raises(FileError, match=said):
                save_design(path, with_field(Design(), "pair.pinion_teeth", 18))
        assert load_design(path) == Design()
        assert list(tmp_path.iterdir()) == [path]


def test_saving_where_it_cannot_be_says_why(tmp_path: Path) -> None:
    for path, said in [
        (tmp_path, "this is a folder, not a file; choose another name"),
        (tmp_path / "none" / "a.gear.toml", "no such file or folder; choose another folder, or make this one first"),
        (tmp_path / ("x" * 300), "the name is too long; choose a shorter one"),
    ]:
        with pytest.raises(FileError, match=said):
            save_design(path, Design())
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(os.name == "nt", reason="links and modes of POSIX")
def test_saving_keeps_links_and_modes(tmp_path: Path) -> None:
    path, link = tmp_path / "a.gear.toml", tmp_path / "link.gear.toml"
    save_design(path, Design())
    path.chmod(0o600)
    link.symlink_to(path)
    save_design(link, with_field(Design(), "pair.pinion_teeth", 18))
    assert link.is_symlink()
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert load_design(path).pair.pinion_teeth == 18


def test_what_another_program_could_not_write_is_told_by_the_system(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert files.why_not_written(tmp_path / "a.step", "no reason") == "no reason"
    assert files.why_not_written(tmp_path / "none" / "a.step", "no reason").startswith(
        "there is no such file or folder"
    )
    monkeypatch.setattr(files.os, "fsync", fail_with(errno.ENOSPC))
    assert files.why_not_written(tmp_path / "a.step", "no reason").startswith("the disk is full; free some space")
    assert list(tmp_path.iterdir()) == []
