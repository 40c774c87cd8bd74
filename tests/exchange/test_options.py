"""Every option of every format: what it changes in the file, and that the gear read back is the same."""

from __future__ import annotations

import json
import struct
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from gearstudio.analysis.gear_deviation import GearTheory
from gearstudio.checks import FaceCheck, FileCheck
from gearstudio.design import Design, with_field
from gearstudio.exchange.solids import Product
from gearstudio.formats import FORMATS, OPTIONS, ExportOptions, options_of
from gearstudio.theory.place import Place

pytestmark = pytest.mark.kernel

SMALL = with_field(with_field(Design(), "pair.pinion_teeth", 9), "pair.wheel_teeth", 14)
COARSE = 0.05


def written(folder: Path, format_: str, member: str = "pinion", part: str = "tooth", **options: Any) -> Path:
    path = folder / f"Zahn 歯.{format_}"
    chosen = ExportOptions(**{"chord": COARSE, **options})
    check = Product(SMALL, member, part, "profile_sweep", "optimised", options=chosen).write(path, format_)
    assert not check.problems()
    assert check.box_error < 1e-4
    assert check.deviations and max(face.largest_um for face in check.deviations) < 0.1
    return path


def text_of(path: Path) -> str:
    return path.read_text(encoding="latin-1")


def tree_of(path: Path) -> dict[str, Any]:
    content = path.read_bytes()
    (length,) = struct.unpack_from("<I", content, 12)
    return dict(json.loads(content[20 : 20 + length]))


def model_of(path: Path) -> str:
    with zipfile.ZipFile(path) as package:
        return package.read("3D/3dmodel.model").decode()


@pytest.mark.parametrize(
    ("schema", "word"),
    [("ap242", "AP242_MANAGED_MODEL"), ("ap214", "AUTOMOTIVE_DESIGN"), ("ap203", "CONFIG_CONTROL_DESIGN")],
)
def test_step_schemas(schema: str, word: str, tmp_path: Path) -> None:
    assert word in text_of(written(tmp_path, "step", step_schema=schema)).partition("DATA;")[0]


def test_one_choice_does_not_stay_for_the_next_file(tmp_path: Path) -> None:
    written(tmp_path, "step", step_schema="ap203", step_unit="inch")
    text = text_of(written(tmp_path, "step"))
    assert "AP242" in text and "SI_UNIT(.MILLI.,.METRE.)" in text and "INCH" not in text


def test_units_change_the_numbers_and_not_the_gear(tmp_path: Path) -> None:
    assert "'INCH'" in text_of(written(tmp_path, "step", step_unit="inch"))
    assert "4HINCH" in text_of(written(tmp_path, "iges", iges_unit="inch")).replace("\n", "")
    assert 'unit="micron"' in model_of(written(tmp_path, "3mf", threemf_unit="micron"))
    assert 'unit="inch"' in model_of(written(tmp_path, "3mf", threemf_unit="inch"))


def test_iges_as_trimmed_surfaces_has_no_solids_and_is_sewn_when_read(tmp_path: Path) -> None:
    def entities(path: Path) -> set[str]:
        return {line[:8].strip() for line in text_of(path).splitlines() if line[72:73] == "D"}

    assert "186" in entities(written(tmp_path, "iges"))
    loose = entities(written(tmp_path, "iges", iges_bodies="surfaces"))
    assert "186" not in loose and "144" in loose


def test_encodings(tmp_path: Path) -> None:
    for format_, option, text in (("brep", "brep_encoding", "DBRep_DrawableShape"), ("stl", "stl_encoding", "solid ")):
        sizes = {}
        for encoding in ("text", "binary"):
            path = written(tmp_path, format_, **{option: encoding})
            assert text_of(path).lstrip().startswith(text) == (encoding == "text")
            sizes[encoding] = path.stat().st_size
        assert sizes["binary"] < 0.8 * sizes["text"]


def test_an_stl_of_text_that_was_cut_off_is_noticed(tmp_path: Path) -> None:
    from gearstudio.errors import FileError
    from gearstudio.exchange.meshes import read_meshes

    path = written(tmp_path, "stl", stl_encoding="text")
    path.write_bytes(path.read_bytes()[:-5000])
    with pytest.raises(FileError, match="cut off"):
        read_meshes(path, "stl")


def test_glb_axes_and_units(tmp_path: Path) -> None:
    def corner(path: Path) -> tuple[float, list[float]]:
        tree = tree_of(path)
        return max(tree["accessors"][0]["max"]), tree["nodes"][0]["matrix"]

    usual, turned = corner(written(tmp_path, "glb"))
    larger, upright = corner(written(tmp_path, "glb", glb_up="z", glb_unit="mm"))
    assert larger == pytest.approx(1000 * usual, rel=1e-6)
    assert turned[5] == 0 and upright[5] == 1


READ: dict[str, Callable[[Path], str]] = {
    "step": text_of, "iges": text_of, "3mf": model_of, "glb": lambda path: json.dumps(tree_of(path)),
}  # fmt: skip


@pytest.mark.parametrize(
    ("format_", "colour", "name"),
    [("step", "COLOUR_RGB", "convex fillet"), ("3mf", "displaycolor", 'name="pinion"'),
     ("glb", "baseColorFactor", '"pinion"'), ("iges", "314", "")],
)  # fmt: skip
def test_colours_and_names_can_be_left_out(format_: str, colour: str, name: str, tmp_path: Path) -> None:
    full = READ[format_](written(tmp_path, format_))
    plain = READ[format_](written(tmp_path, format_, colors=False, names=False))
    assert full.count(colour) > plain.count(colour)
    assert not name or (name in full and name not in plain)


def test_an_angle_between_chords_makes_more_triangles(tmp_path: Path) -> None:
    product = Product(SMALL, "pinion", "gear", "profile_sweep", "optimised", options=ExportOptions(chord=0.5))
    finer = Product(SMALL, "pinion", "gear", "profile_sweep", "optimised", options=ExportOptions(0.5, angle_deg=4.0))
    counts = [one.write(tmp_path / "a.stl", "stl").faces for one in (product, finer)]
    assert counts[1] > 3 * counts[0]


def test_a_tolerance_that_no_program_could_read_is_refused(tmp_path: Path) -> None:
    from gearstudio.errors import ModellingError

    with pytest.raises(ModellingError, match="allow a larger distance"):
        written(tmp_path, "stl", part="gear", chord=1e-5, angle_deg=0.5)


def test_a_pair_in_one_stl_is_two_closed_parts(tmp_path: Path) -> None:
    path = tmp_path / "pair.stl"
    check = Product(SMALL, "pair", "gear", "profile_sweep", "optimised", options=ExportOptions(0.1)).write(path, "stl")
    assert check.solids == 2 and {face.member for face in check.deviations} == {"pinion", "wheel"}


def test_every_option_is_of_a_format_and_has_help() -> None:
    for spec in OPTIONS.values():
        assert set(spec.formats) <= set(FORMATS["gear"]) and spec.help and spec.allows(spec.default)
    assert {spec.name for spec in options_of(["stl"])} == {"chord", "angle_deg", "stl_encoding"}
    assert options_of([]) == ()
    record = ExportOptions(chord=0.1, glb_up="z", names=False).record()
    assert ExportOptions.from_record(record) == ExportOptions(chord=0.1, glb_up="z", names=False)
    for wrong in ({"glb_up": "x"}, {"chord": -1.0}, {"chord": True}, {"names": "no"}, {"size": 3}):
        with pytest.raises(ValueError, match="="):
            ExportOptions.from_record(wrong)


def test_the_worst_of_a_kind_stands_for_it_and_one_out_of_limits_comes_first() -> None:
    faces = tuple(FaceCheck("wheel", "tip", n, um, limit) for n, um, limit in ((1, 0.5, 1), (2, 0.9, 1), (3, 0.3, 0.1)))
    check = FileCheck("step", True, True, 1, 3, 1.0, 0.0, 0.0, deviations=faces)
    assert check.worst == (faces[2],)
    assert check.problems() == ("the wheel's tip, tooth 3 lies 0.3 µm from theory instead of at most 0.1 µm",)


def test_a_face_a_little_off_is_found() -> None:
    """Faces of theory are known again wherever they are on the gear, and a hundredth of a micrometre is seen."""
    import numpy as np

    from gearstudio.exchange.proof import check_faces, wanted
    from gearstudio.methods.gear import design_tooth

    tooth = design_tooth(SMALL, "pinion", "profile_sweep", "optimised")
    part = wanted(tooth, None, Place(), 0.05)
    theory = GearTheory(tooth.member, tooth.profile)
    samples, titles = [], []
    for number in (0, 4, 8):
        for face in tooth.faces:
            samples.append(theory.to_first(face.surface.uniform_grid(9, 9).reshape(-1, 3), -number))
            titles.append((face.title(tooth.member.hand), number + 1))
    found = check_faces(samples, part)
    assert sorted((face.name, face.tooth) for face in found) == sorted(titles)
    assert all(face.good for face in found)
    index = titles.index(("concave", 5))
    samples[index] = samples[index] + np.array([0.0, 0.0, 2e-3])
    moved = [face for face in check_faces(samples, part) if not face.good]
    assert [(face.name, face.tooth) for face in moved] == [("concave", 5)]
