"""The small parts of the solid mode: measuring, materials, blanks as drawn, the bar that turns, the export dialog."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QSettings

from gearstudio.checks import FileCheck
from gearstudio.design import Design
from gearstudio.errors import GeometryError
from gearstudio.formats import ExportOptions
from gearstudio.presets import PRESETS
from gearstudio.theory.blank import BlankError
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.place import Place
from tests.ui.made_up_solid import solid_of
from tests.ui.stand_ins import Bench
from ui.blank_shape import blank_shape
from ui.export_dialog import ExportDialog
from ui.exporting import export_report
from ui.layers import SOLID, Ink, Layer, Style
from ui.materials import MATERIALS, properties
from ui.measuring import Frame, Picked, measure, pick
from ui.mesh_bar import MeshBar
from ui.properties_table import PropertiesTable
from ui.section import Plane
from ui.solid_words import measured
from ui.tables import table_text

pytestmark = pytest.mark.ui


# ---- measuring ---------------------------------------------------------------------------------------------


def box(half: float = 10.0) -> Layer:
    """A cube about the origin."""
    points = half * np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    corners, normals, cells = [], [], []
    for quad in quads:
        middle = points[list(quad)].mean(axis=0)
        start = len(corners)
        corners += [points[i] for i in quad]
        normals += [middle / np.linalg.norm(middle)] * 4
        cells += [[start, start + 1, start + 2], [start, start + 2, start + 3]]
    style = Style(Ink("#ffffff", "#ffffff"))
    return Layer(SOLID, "box", "surface", np.array(corners), style, np.array(cells), np.array(normals), body="wheel")


def turn_z(angle: float) -> np.ndarray:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def test_a_ray_finds_the_face_the_cut_face_and_nothing_beyond() -> None:
    frames, layers = {"wheel": Frame(Place(), Place())}, (box(),)
    ray = (np.array([100.0, 1.0, 2.0]), np.array([-1.0, 0.0, 0.0]))
    found = pick(layers, frames, ray)
    assert found is not None and np.allclose(found.point, [10, 1, 2]) and np.allclose(found.normal, [1, 0, 0])
    found = pick(layers, frames, ray, Plane(0, 4.0, 1))
    assert found is not None and np.allclose(found.point, [4, 1, 2]) and np.allclose(found.normal, [1, 0, 0])
    found = pick(layers, frames, ray, Plane(2, 5.0, 1))
    assert found is not None and np.allclose(found.point, [10, 1, 2])
    assert pick(layers, frames, ray, Plane(2, 1.0, 1)) is None
    assert pick(layers, frames, ray, Plane(0, -20.0, 1)) is None


def test_a_turned_body_is_picked_where_it_is_and_told_in_its_own_frame() -> None:
    turn = Place(turn_z(0.3), np.array([0.5, 0.0, -0.25]))
    base = Place(turn_z(np.pi / 2), np.array([0.0, 0.0, 1.0]))
    ray = (np.array([100.0, 0.0, 2.0]), np.array([-1.0, 0.0, 0.0]))
    found = pick((box(),), {"wheel": Frame(base, turn)}, ray)
    assert found is not None and found.point[1] == pytest.approx(0.0)
    assert np.allclose(turn.of(base.of(found.local)), found.point)
    assert np.allclose(found.point[0], 0.5 + 10 / np.cos(0.3))


def test_what_lies_between_two_points() -> None:
    def picked(member: str, *local: float) -> Picked:
        return Picked(member, np.array(local), np.array(local), np.array([0.0, 0.0, 1.0]))

    found = measure(picked("wheel", 3, 0, 1), picked("wheel", 0, 5, 2))
    assert found.distance == pytest.approx(np.sqrt(9 + 25 + 1)) and found.across == (-3.0, 5.0, 1.0)
    assert (found.radial, found.axial) == (2.0, 1.0) and found.azimuth == pytest.approx(90.0) and found.normals == 0.0
    assert "Azimuth" in measured(found)
    apart = measure(picked("wheel", 3, 0, 1), picked("pinion", 0, 5, 2))
    assert apart.radial is None and "Azimuth" not in measured(apart)


# ---- properties --------------------------------------------------------------------------------------------


def test_mass_and_inertia_follow_the_density() -> None:
    result = solid_of(Design(), "wheel")
    rows = {row.title: row for row in properties([result, None], 7850.0)}
    assert rows["Mass"].texts == ("7.850", "–") and rows["Mass"].unit == "g"
    assert rows["Volume"].unit == "cm³" and rows["Volume"].texts[0] == "1.000"
    assert rows["Inertia z"].texts[0] == "157.0" and rows["Inertia z"].unit == "g mm²"
    heavy = {row.title: row for row in properties([result], 8800.0)}
    assert float(heavy["Mass"].texts[0]) / 7.85 == pytest.approx(8800 / 7850, rel=1e-3)


def test_a_material_gives_the_density_and_a_density_the_material(qtbot) -> None:
    table = PropertiesTable()
    qtbot.addWidget(table)
    table.show_results({"wheel": solid_of(Design(), "wheel")})
    table.material.setCurrentIndex(4)
    assert table.density == MATERIALS[4].density and "Mass, g\t2.700" in table_text(table.table)
    for text, name in (("8500", "Brass"), ("1234,5", "Custom"), ("7850", "Steel")):
        table.density_field.setText(text)
        table.density_field.textEdited.emit(text)
        assert table.material.currentText() == name
    table.density_field.textEdited.emit("-3")
    assert table.density == 7850.0 and table.density_field.property("severity") == "error"


# ---- blanks ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("preset", PRESETS, ids=lambda preset: preset.key)
@pytest.mark.parametrize("ends", ["back_cone", "sphere"])
def test_a_section_is_drawn_of_every_preset(preset, ends: str) -> None:
    data = preset.design.model_dump()
    data["tooth"]["ends"] = ends
    design = Design.model_validate(data)
    pair = pair_geometry(design)
    for member in (pair.pinion, pair.wheel):
        try:
            shape = blank_shape(design, member)
        except GeometryError:
            continue
        area = _area(shape.body)
        assert abs(area) > 0 and abs(_area(shape.tooth)) > 0
        texts = " ".join(d.text for d in shape.dimensions)
        assert f"R {member.outer_cone_distance:.2f}" in texts and "t_B" in texts and len(shape.notes) == 3


def _area(ring: np.ndarray) -> float:
    x, y = ring.T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def test_the_drawings_follow_the_form_and_dim_when_a_size_is_impossible(qtbot, theme) -> None:
    bench = Bench()
    try:
        drawing = bench.controller.blanks.drawings["wheel"]
        assert drawing.shape is not None
        bench.session.edit("blank.wheel.bore_diameter", 31.0)
        assert any("d ⌀31.00" in d.text for d in drawing.shape.dimensions)
        bench.session.edit("blank.wheel.bore_diameter", 150.0)
        assert drawing._note and any(i.field == "blank.wheel.bore_diameter" for i in bench.session.issues)
        bench.session.edit("blank.wheel.bore_diameter", None)
        assert not drawing._note
        assert not any("31.00" in d.text for d in drawing.shape.dimensions)
        row = bench.window.form.rows["blank.wheel.hub_diameter"]
        assert float(row.field.placeholderText()) > 0
        with pytest.raises(BlankError):
            wrong = bench.session.design.model_dump()
            wrong["blank"]["wheel"]["bore_diameter"] = 150.0
            design = Design.model_validate(wrong)
            blank_shape(design, pair_geometry(design).wheel)
        drawing.resize(300, 232)
        assert not drawing.grab().toImage().allGray()
    finally:
        bench.close()


# ---- turning -----------------------------------------------------------------------------------------------


def test_the_bar_steps_slides_and_plays(qtbot) -> None:
    bar = MeshBar()
    qtbot.addWidget(bar)
    bar.set_pair(20, 40)
    angles: list[float] = []
    bar.turned.connect(angles.append)
    bar.step(1)
    assert angles == [pytest.approx(1.5)]
    bar.step(-2)
    assert angles[-1] == pytest.approx(358.5) and "wheel −179.2°" in bar._label.text()
    bar._slider.setValue(900)
    assert angles[-1] == pytest.approx(90.0)
    bar.play()
    assert bar.playing
    qtbot.waitUntil(lambda: angles[-1] > 91, timeout=3000)
    bar.pause()
    stood = angles[-1]
    qtbot.wait(80)
    assert angles[-1] == stood and not bar.playing


# ---- exports -----------------------------------------------------------------------------------------------


def test_the_dialog_offers_what_goes_together(bench: Bench, tmp_path) -> None:
    dialog = ExportDialog(bench.session, str(tmp_path), bench.window, mode="pair")
    assert dialog.job().member == "pair" and dialog.job().part == "gear" and not dialog._part.isEnabled()
    dialog._formats["stl"].setChecked(True)
    chord = dialog.options.editor("chord")
    assert dialog.formats == ("step", "stl") and chord.isVisibleTo(dialog)
    for text, good in (("0,05", True), ("x", False), ("-1", False), ("", True)):
        chord.setText(text)
        assert dialog._export.isEnabled() == good
        assert ("Triangles within" in dialog._files.text()) != good
    dialog._member.setCurrentIndex(dialog._member.findData("pinion"))
    dialog._part.setCurrentIndex(dialog._part.findData("flanks"))
    assert dialog.formats == ("step",) and not chord.isVisibleTo(dialog) and not dialog._formats["stl"].isEnabled()
    dialog._formats["step"].setChecked(False)
    assert not dialog._export.isEnabled()


def test_the_last_choices_are_remembered(bench: Bench, tmp_path) -> None:
    settings = QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat)
    first = ExportDialog(bench.session, str(tmp_path), bench.window, settings)
    first._part.setCurrentIndex(first._part.findData("gear"))
    first._construction.setCurrentIndex(1)
    for name, box in first._formats.items():
        box.setChecked(name in ("iges", "glb"))
    first.options.editor("chord").setText("0.02")
    first.options.editor("step_unit").setCurrentIndex(1)
    first.options.editor("names").setChecked(False)
    first._record.setChecked(True)
    first._folder.setText(str(tmp_path / "Räder 齿轮"))
    first.accept()
    again = ExportDialog(bench.session, str(tmp_path), bench.window, settings)
    job = again.job()
    assert (job.part, job.construction, job.formats, job.records) == ("gear", "cut", ("iges", "glb"), True)
    assert job.options == ExportOptions(chord=0.02, names=False)
    again._formats["step"].setChecked(True)
    assert again.job().options.step_unit == "inch"
    assert job.directory == tmp_path / "Räder 齿轮"


def test_what_was_read_back_is_told(tmp_path) -> None:
    from gearstudio.jobs import ExportedFile

    check = FileCheck("step", True, True, 2, 386, 352492.0, 1e-10, 1e-9)
    files = (ExportedFile(tmp_path / "pair-gear.step", "step", 4_360_000, check),)
    text, details = export_report(files)
    assert "pair-gear.step (4.4 MB)" in text and "2 closed valid solids, 386 faces" in details
