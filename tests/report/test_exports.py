"""What the report says of exports: from their records, and whether they still hold."""

from pathlib import Path

import pytest

from gearstudio.checks import FaceCheck, FileCheck
from gearstudio.design import Design, with_field
from gearstudio.exchange.record import Subject, record_path, write_record
from gearstudio.report.blocks import Table, Text
from gearstudio.report.exports import chapter_blocks, exports_in

FACES = (
    FaceCheck("wheel", "concave", 1, 0.004, 0.05),
    FaceCheck("wheel", "concave", 7, 0.007, 0.05),
    FaceCheck("wheel", "root", 1, 0.3, 0.2),
)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    path = tmp_path / "wheel-gear.step"
    path.write_bytes(b"ISO-10303-21;")
    check = FileCheck("step", True, True, 1, 84, 12.0, 0.0, 0.0, deviations=FACES, kernel="Kernel 8.0")
    write_record(path, "step", Design(), Subject("wheel", "gear", "rotating_line", "optimised"), check)
    return tmp_path


def test_the_largest_deviation_of_each_face_and_the_kernel_are_told(folder: Path) -> None:
    (one,) = exports_in(folder, Design())
    assert [(face.name, face.largest_um) for face in one.faces] == [("concave", 0.007), ("root", 0.3)]
    assert "Kernel 8.0" in one.made and "valid" in one.found and "closed" in one.found
    faces = [block for block in chapter_blocks((one,), folder) if isinstance(block, Table)][-1]
    assert [row[-1] for row in faces.rows if len(row) > 1] == ["within", "OUT OF LIMITS"]


def test_files_that_changed_are_gone_or_belong_to_another_design_are_remarked(folder: Path) -> None:
    path = folder / "wheel-gear.step"
    (one,) = exports_in(folder, with_field(Design(), "pair.wheel_teeth", 41))
    assert any("pair.wheel_teeth" in remark for remark in one.remarks)
    path.write_bytes(b"other")
    assert any("checksum" in remark for remark in exports_in(folder, Design())[0].remarks)
    path.unlink()
    assert any("gone" in remark for remark in exports_in(folder, Design())[0].remarks)


def test_a_damaged_record_is_told_and_leaves_the_others_alone(folder: Path) -> None:
    record_path(folder / "a.step").write_text("{", encoding="utf-8")
    damaged, good = exports_in(folder, Design())
    assert damaged.remarks and good.faces


def test_without_exports_or_folder_the_chapter_says_so(tmp_path: Path) -> None:
    for folder in (None, tmp_path):
        (block,) = chapter_blocks(exports_in(folder, Design()), folder)
        assert isinstance(block, Text)
