"""What a field shows it reads, in every language: as it is, pasted with its unit, and in sums."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QGridLayout,
    QWidget,
)

from gearstudio.design import FieldSpec, all_field_specs, field_specs
from gearstudio.formats import OPTIONS
from tests.ui.made_up import member_of
from tests.ui.stand_ins import Bench
from ui import formatting, units
from ui.analysis.number_slider import NumberSlider
from ui.derived_panel import QUANTITIES
from ui.export_options import OptionsPanel
from ui.expressions import ExpressionError, evaluate
from ui.fields import NumberField, read_number
from ui.language import Language
from ui.properties_table import PropertiesTable

NUMBERS = [spec for spec in field_specs() if spec.kind in ("int", "float")]
MODULE = all_field_specs()["pair.outer_module"]
FOREIGN = {"de": re.compile(r"\d\.\d"), "en": re.compile(r"\d,\d"), "zh": re.compile(r"\d,\d")}


@pytest.mark.ui
@pytest.mark.parametrize("language", ["de", "en", "zh"])
def test_every_field_reads_what_it_shows(language: str, speak, qtbot, theme) -> None:
    speak(language)
    bench = Bench()
    try:
        for spec in NUMBERS:
            row = bench.window.form.rows[spec.path]
            for value in some_values(spec):
                row.field.set_value(value)
                text = row.field.text()
                assert not FOREIGN[language].search(text)
                pasted_all_ways(row.field, spec, text, value)
            row.field.set_value(None if spec.optional else spec.default)
            hint = row.field.placeholderText()
            assert not hint or not isinstance(read_number(hint, spec)[0], str)
    finally:
        bench.close()


def some_values(spec: FieldSpec) -> list[int | float]:
    if spec.kind == "int":
        return [int(spec.default or 17)]
    return [float(spec.default or 1.5), 0.125, -2.5e-7, 1234.5678, 100_000.25]


def pasted_all_ways(field: NumberField, spec: FieldSpec, text: str, value: float) -> None:
    """As it stands, with its unit, with a true minus sign, in a sum."""
    unit = units.unit_shown(spec.unit) if spec.unit in ("mm", "°") else ""
    for way in (text, f" {text}\n", f"{text} {unit}".strip(), text.replace("-", formatting.MINUS), f"({text})*1"):
        field.clear()
        field.insert(way)
        assert field.value() == pytest.approx(value, rel=1e-11), way


@given(value=st.floats(-1e6, 1e6), length=st.sampled_from(["mm", "in"]), language=st.sampled_from(["de", "en", "zh"]))
def test_shown_lengths_read_back(qapp, value: float, length: str, language: str) -> None:
    spoken = Language(qapp, language)
    try:
        units.use(units.Display(length))
        read = read_number(units.shown_text(value, "mm"), MODULE)[0]
        assert read == pytest.approx(value, rel=1e-7)
        assert read_number(units.with_unit(value, "mm", 6), MODULE)[0] == pytest.approx(value, abs=1e-5)
        assert read_number(formatting.number(value, ".12g"), all_field_specs()["tooth.profile_shift"])[0] == (
            pytest.approx(value, rel=1e-11)
        )
    finally:
        units.use(units.Display())
        spoken.speak("en")


def test_derived_values_can_be_pasted_into_a_field(german) -> None:
    wheel = member_of("default")
    shown = {q.title: (q.text(wheel), q.unit, q.read(wheel)) for q in QUANTITIES if q.unit}
    assert all("," in text for text, *_ in shown.values())
    for text, unit, value in shown.values():
        spec = MODULE if unit == "mm" else all_field_specs()["lengthwise.spiral_angle_deg"]
        for pasted in (text, text + units.spaced(unit)):
            assert read_number(pasted, spec)[0] == pytest.approx(value, abs=5e-4)


class TestSums:
    @pytest.mark.parametrize(
        ("text", "value"),
        [("max(1,5; 2)", 2.0), ("min(1,5;2)", 1.5), ("pow(3,2)", 9.0), ("1,5 + 2.5", 4.0),
         ("hypot(3,4)", 5.0), ("max(1.5, 2)", 2.0), ("max(hypot(3,4), 2)", 5.0), ("max(1, 2, 3)", 3.0)],
    )  # fmt: skip
    def test_in_german(self, text: str, value: float, german) -> None:
        assert evaluate(text, "") == pytest.approx(value)

    @pytest.mark.parametrize("text", ["max(1,5, 2)", "min(1,5,2)", "1 + hypot(1,5, (2+1))", "max(hypot(3,4), 1,5)"])
    def test_what_could_be_read_in_two_ways_is_refused_in_german(self, text: str, speak) -> None:
        assert evaluate(text, "") > 0
        speak("de")
        with pytest.raises(ExpressionError, match=";"):
            evaluate(text, "")


@pytest.mark.ui
class TestTheBoxOfANumber:
    @pytest.fixture
    def row(self, qtbot) -> Iterator[NumberSlider]:
        holder = QWidget()
        qtbot.addWidget(holder)
        made = NumberSlider(QGridLayout(holder), 0, "Offset", "A tip", "mm", 3)
        made.set_range(-1.0, 1.0, most=10.0)
        holder.show()
        yield made
        holder.hide()

    @pytest.mark.parametrize("text", ["1,5", "1.5", "1,5 mm", "+1.5"])
    @pytest.mark.parametrize("language", ["de", "en"])
    def test_point_and_comma_are_typed(self, text: str, language: str, speak, row: NumberSlider) -> None:
        speak(language)
        row.box.selectAll()
        QTest.keyClicks(row.box, text)
        QTest.keyClick(row.box, Qt.Key.Key_Return)
        assert row.value == 1.5 and row.box.text() == ("1,500 mm" if language == "de" else "1.500 mm")
        QTest.keyClick(row.box, Qt.Key.Key_Up)
        assert row.value == pytest.approx(1.51)

    @pytest.mark.parametrize("text", ["abc", "1,5,5", "99", ""])
    def test_what_is_no_number_in_its_range_leaves_the_one_before(self, text: str, german, row: NumberSlider) -> None:
        row.set_value(-0.25)
        row.box.selectAll()
        QTest.keyClicks(row.box, text)
        QTest.keyClick(row.box, Qt.Key.Key_Return)
        assert row.value == -0.25 and row.box.text() == "−0,250 mm"


@pytest.mark.ui
def test_remembered_options_of_an_export_follow_the_language(german, qtbot) -> None:
    page = OptionsPanel(0.0123)
    qtbot.addWidget(page)
    number = next(spec.name for spec in OPTIONS.values() if spec.kind == "number")
    page.set_choices({number: "0.25"})
    assert page.editor(number).text() == "0,25" and page._value(OPTIONS[number]) == 0.25
    assert page.editor("chord").placeholderText() == "0,0123"


@pytest.mark.ui
def test_a_density_stays_when_the_language_changes(speak, qtbot) -> None:
    before = PropertiesTable()
    qtbot.addWidget(before)
    before.density_field.setText("7123.5")
    before.density_field.textEdited.emit("7123.5")
    speak("de")
    after = PropertiesTable()
    qtbot.addWidget(after)
    after.take_state(before.keep_state())
    assert after.density == 7123.5 and after.density_field.text() == "7123,5"
