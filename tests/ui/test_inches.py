"""Inches in every place that shows a length, at once and without a change of the design or of what is set."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearstudio.design import Design, all_field_specs
from gearstudio.validation.messages import field_issue
from tests.ui.made_up_solid import solid_of
from tests.ui.reading import texts_of
from tests.ui.stand_ins import Bench
from ui import units
from ui.analysis.contact_controls import ContactControls
from ui.explain import problem_text
from ui.habits import Habits
from ui.materials import MATERIALS, density_unit, properties
from ui.properties_table import PropertiesTable
from ui.tables import table_text
from ui.units import Display, in_sentence, per_length, small_text
from ui.views.quantities import Quantity

MILLIMETRES = re.compile(r"(?<![µ\w])mm\b(?!²)|1/mm")
ABOUT_FILES = ("files stay in mm", "in mm; or a STEP", "in mm, or a STEP")


@pytest.fixture
def habits(qtbot) -> Iterator[Habits]:
    bench = Bench()
    yield Habits(bench.controller)
    bench.close()
    units.use(Display())


@pytest.fixture
def inches() -> Iterator[None]:
    units.use(Display("in"))
    yield
    units.use(Display())


def left_over(habits: Habits) -> list[str]:
    shown = list(texts_of(habits._window))
    found = [f"{where}: {text}" for where, text in shown if MILLIMETRES.search(re.sub("<[^>]*>", " ", text))]
    return [one for one in found if not any(words in one for words in ABOUT_FILES)]


@pytest.mark.ui
def test_no_millimetre_is_left_in_the_window(habits: Habits, qtbot) -> None:
    window, session = habits._window, habits._session
    habits._controller.charts_ready()
    for tab in ("charts", "contact", "datasheet", "measurement"):
        window.analysis.show_tab(tab)
    page = window.analysis.pages["contact"]
    qtbot.waitUntil(lambda: "µm" in page.facts.text(), timeout=20_000)
    session.edit("pair.face_width", 500.0)
    draft, design = dict(session.draft), session.design
    qtbot.wait(300)
    assert len(left_over(habits)) > 20
    assert " mm" in window.form.rows["pair.face_width"].message
    habits.preferences.set(length="in")
    qtbot.wait(400)
    assert not left_over(habits)
    assert " in" in page.facts.text() and "µm" not in page.facts.text()
    assert session.draft == draft and session.design is design
    habits.preferences.set(length="mm")
    qtbot.wait(50)
    assert len(left_over(habits)) > 20 and "µm" in page.facts.text()


@pytest.mark.ui
def test_misalignments_are_typed_in_inches_and_stay_what_they_are(qtbot, inches: None) -> None:
    units.use(Display())
    controls = ContactControls()
    qtbot.addWidget(controls)
    controls.set_module(4.0)
    controls.rows["offset"].set_value(0.123)
    controls.rows["shaft_angle_deg"].set_value(0.5)
    told: list[object] = []
    controls.changed.connect(lambda: told.append(1))
    before = controls.misalignment
    units.use(Display("in"))
    controls.show_units()
    assert not told and controls.misalignment == before
    box = controls.rows["offset"].box
    assert box.suffix() == " in" and box.value() == pytest.approx(0.123 / 25.4, abs=1e-5)
    assert controls.rows["shaft_angle_deg"].box.suffix() == " °" and controls.thickness.box.suffix() == " µm"
    box.setValue(0.01)
    assert told and controls.misalignment.offset == pytest.approx(0.254)
    controls.rows["offset"].slider.setValue(controls.rows["offset"].slider.maximum())
    reach = controls.misalignment.offset
    units.use(Display())
    controls.show_units()
    assert controls.misalignment.offset == reach and box.value() == pytest.approx(reach, abs=5e-4)
    controls.reset()
    assert controls.misalignment.offset == 0


@given(st.decimals(min_value="0.001", max_value="9999", places=3))
def test_sentences_of_the_core_are_converted(value) -> None:
    try:
        units.use(Display("in"))
        said = in_sentence(f"use at least {value} mm, not 3 mm; 2 µm and 4 mmm stay, as does a 5 mm.step")
    finally:
        units.use(Display())
    number = float(said.split()[3])
    assert said.split()[4] == "in," and number * 25.4 == pytest.approx(float(value), rel=1e-3)
    assert "0.11811 in" in said or "0.118 in" in said
    assert "2 µm and 4 mmm stay, as does a 5 mm.step" in said
    assert in_sentence("use 3 mm") == "use 3 mm"


def test_a_line_of_a_file_stays_in_its_unit(inches) -> None:
    for line in ("line 3, “face_width = 25.4 mm”: ", "Zeile 3, „face_width = 25.4 mm“: "):
        assert in_sentence(f"{line}25.4 mm is too much") == f"{line}1 in is too much"


def test_limits_at_a_field_are_in_inches(inches: None) -> None:
    module = all_field_specs()["pair.outer_module"]
    said = [problem_text(field_issue(module, value).message, module) for value in (254.0, 0, "x")]
    assert said[0] == "10 in is above the most of 3.937 in; use 0.0039370079 to 3.9370079 in"
    assert said[1] == "0 in is below the least of 0.00394 in; use 0.0039370079 to 3.9370079 in"
    assert said[2] == '"x" is not a number; use 0.0039370079 to 3.9370079 in'
    teeth = all_field_specs()["pair.pinion_teeth"]
    assert problem_text(field_issue(teeth, 3).message, teeth) == "3 is below the least of 5 teeth; use 5 to 200"


def test_small_lengths_and_curvatures(inches: None) -> None:
    assert small_text(0.0254) == "0.00100 in" and per_length("1/mm²") == ("1/in²", pytest.approx(25.4**2))
    assert per_length("%") == ("%", 1.0)
    assert Quantity("mean", "Mean curvature", "1/mm", False).text(0.1) == "2.54 1/in"
    units.use(Display())
    assert small_text(0.0254) == "25.4 µm" and per_length("1/mm") == ("1/mm", 1.0)


@pytest.mark.ui
def test_solids_are_weighed_in_pounds(qtbot, inches: None) -> None:
    solid = solid_of(Design(), "wheel")
    found = {row.title: row for row in properties((solid,), 7850.0)}
    unit, factor = density_unit()
    assert unit == "lb/in³" and 7850.0 * factor == pytest.approx(0.2836, abs=1e-4)
    volume, mass = float(found["Volume"].texts[0]), float(found["Mass"].texts[0])
    assert found["Volume"].unit == "in³" and found["Mass"].unit in ("oz", "lb")
    pounds = mass if found["Mass"].unit == "lb" else mass / 16
    assert pounds == pytest.approx(volume * 0.28360, rel=2e-3)
    assert found["Centre z"].unit == "in" and found["Area"].unit == "in²"
    table = PropertiesTable()
    qtbot.addWidget(table)
    table.show_results({"wheel": solid})
    assert table.density_field.text() == "0.2836" and "lb/in³" in table.density_field.toolTip()
    table.density_field.setText("0.0975")
    table.density_field.textEdited.emit("0.0975")
    assert table.density == pytest.approx(0.0975 / factor)
    for material in MATERIALS:
        table.material.setCurrentIndex(table.material.findData(material.density))
        table.density_field.textEdited.emit(table.density_field.text())
        assert table.density == material.density, "what is shown, typed again, is the same material"
    units.use(Display())
    table.show_units()
    assert table.density_field.text() == f"{MATERIALS[-1].density:g}"
    assert ", g\t" in table_text(table.table)
