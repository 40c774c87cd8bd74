"""The parameter form: what is typed reaches the draft as it is, and every problem stands at its field."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from gearstudio.design import field_specs
from tests.ui.stand_ins import Bench
from ui import units
from ui.explain import limits_text, tooltip
from ui.fields import ChoiceField, NumberField

pytestmark = pytest.mark.ui
NUMBERS = [spec for spec in field_specs() if spec.kind in ("int", "float")]
NONSENSE = (
    "",
    " ",
    "abc",
    "-1e300",
    "1e999",
    "nan",
    "inf",
    "1,2,3",
    "0x1F",
    "½",
    "💥",
    "'; drop",
    "-0",
    "9" * 400,
    "1e-320",
)
TEETH = "pair.pinion_teeth"


@pytest.fixture
def bench(bench: Bench) -> Bench:
    bench.window.resize(1280, 720)
    return bench


@pytest.mark.parametrize("spec", NUMBERS, ids=lambda spec: spec.path)
def test_nonsense_in_a_number_is_told_at_its_field_and_changes_no_model(bench: Bench, qtbot, spec) -> None:
    good = bench.session.design
    row = bench.window.form.rows[spec.path]
    for text in NONSENSE:
        bench.type_into(spec.path, text)
        assert row.field.text() == text[: row.field.maxLength()], "what was typed stays"
        wrong = [issue for issue in bench.session.issues if issue.severity == "error"]
        if wrong:
            assert bench.session.design == good
            assert any(issue.field in bench.window.form.rows for issue in wrong)
        else:
            good = bench.session.design
    bench.type_into(spec.path, "abc")
    assert row.field.property("severity") == "error"
    qtbot.waitUntil(lambda: "abc" in row.message)


def test_nonsense_in_the_name_is_told_too(bench: Bench) -> None:
    for text in ("", "x" * 500, "日本語 ½", "<b>&"):
        bench.type_into("name", text)
    assert bench.session.draft["name"] == "<b>&" and bench.session.issues == ()
    bench.type_into("name", "x" * 500)
    assert [issue.field for issue in bench.session.issues] == ["name"]


def test_a_sum_without_a_value_says_why(bench: Bench, qtbot) -> None:
    row = bench.window.form.rows["pair.outer_module"]
    for text, reason in (("1/0", "divides by zero"), ("9**9**9", "no finite value"), ("4*/2", "neither a number")):
        bench.type_into("pair.outer_module", text)
        qtbot.waitUntil(lambda told=reason: told in row.message)
    bench.type_into("pair.outer_module", "4")
    qtbot.waitUntil(lambda: not row.message)


def test_a_problem_follows_the_unit(bench: Bench, qtbot) -> None:
    row = bench.window.form.rows["pair.outer_module"]
    bench.type_into("pair.outer_module", "254")
    qtbot.waitUntil(lambda: row.message.startswith("254 is above the most of 100 mm"))
    try:
        units.use(units.Display("in"))
        row.show_units()
        assert row.message.startswith("10 in is above the most of 3.937 in")
    finally:
        units.use(units.Display())


def test_a_cell_pasted_from_a_spreadsheet_loses_its_end_of_line(bench: Bench) -> None:
    field = bench.window.form.rows["pair.outer_module"].field
    bench.type_into("pair.outer_module", "5,5\r\n")
    assert bench.session.draft["pair.outer_module"] == 5.5
    field.editingFinished.emit()
    assert field.text() == "5.5" and bench.session.draft["pair.outer_module"] == 5.5


def test_messages_wait_for_a_pause_and_go_at_once(bench: Bench, qtbot) -> None:
    row = bench.window.form.rows[TEETH]
    bench.type_into(TEETH, "3")
    assert row.field.property("severity") == "error" and row.message == ""
    qtbot.waitUntil(lambda: bool(row.message))
    assert row._message.isVisible()
    assert "last good model" in bench.window.form._summary.text()
    bench.type_into(TEETH, "20")
    assert row.field.property("severity") == "" and not row._message.isVisible()


def test_warnings_are_amber_and_leave_the_model_alone(bench: Bench) -> None:
    from gearstudio.errors import Issue

    bench.window.form.show_issues((Issue("thin", TEETH, "rather few teeth", "warning"),))
    assert bench.window.form.rows[TEETH].field.property("severity") == "warning"
    assert bench.window.form._summary.text() == "1 warning"


def test_decimal_comma_and_point_mean_the_same(bench: Bench) -> None:
    bench.type_into("pair.outer_module", "3,25")
    assert bench.session.design.pair.outer_module == 3.25
    bench.type_into("pair.outer_module", "3.5")
    assert bench.session.design.pair.outer_module == 3.5


def test_arrow_keys_step_and_stop_at_the_limit(bench: Bench) -> None:
    field = bench.window.form.rows[TEETH].field
    QTest.keyClick(field, Qt.Key.Key_Up)
    assert bench.session.design.pair.pinion_teeth == 18
    QTest.keyClick(field, Qt.Key.Key_PageDown)
    assert bench.session.design.pair.pinion_teeth == 8
    QTest.keyClick(field, Qt.Key.Key_PageDown)
    assert field.text() == "5"
    bench.type_into(TEETH, "abc")
    QTest.keyClick(field, Qt.Key.Key_Up)
    assert field.text() == "abc"


def test_stepping_an_empty_optional_field_starts_at_the_derived_value(bench: Bench) -> None:
    field = bench.window.form.rows["pair.face_width"].field
    assert field.text() == "" and float(field.placeholderText()) == pytest.approx(26.078)
    QTest.keyClick(field, Qt.Key.Key_Up)
    assert bench.session.design.pair.face_width == pytest.approx(26.578)
    bench.type_into("pair.face_width", "")
    assert bench.session.design.pair.face_width is None


def test_the_wheel_changes_nothing(bench: Bench) -> None:
    for row in bench.window.form.rows.values():
        before = row.field.value()
        place = QPointF(5, 5)
        event = QWheelEvent(
            place, row.field.mapToGlobal(place), QPoint(0, 0), QPoint(0, -120), Qt.MouseButton.NoButton,
            Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase, False,
        )  # fmt: skip
        row.field.setFocus()
        QApplication.sendEvent(row.field, event)
        assert row.field.value() == before


def test_fields_without_effect_are_closed_with_the_reason(bench: Bench) -> None:
    rows = bench.window.form.rows
    assert rows["lengthwise.cutter_radius"].field.isEnabled()
    assert not rows["lengthwise.spiral_angle_at"].field.isEnabled()
    choose(rows["lengthwise.curve"].field, "archimedean")
    assert not rows["lengthwise.cutter_radius"].field.isEnabled()
    assert "Not used now" in rows["lengthwise.cutter_radius"].toolTip()
    assert rows["lengthwise.spiral_angle_at"].field.isEnabled()
    bench.type_into("pair.face_width", "20")
    assert not rows["pair.face_width_factor"].field.isEnabled()


def test_a_closed_field_with_an_error_opens_for_repair(bench: Bench) -> None:
    rows = bench.window.form.rows
    choose(rows["lengthwise.curve"].field, "archimedean")
    choose(rows["lengthwise.spiral_angle_at"].field, "toe")
    choose(rows["lengthwise.curve"].field, "logarithmic")
    wrong = {issue.field for issue in bench.session.issues if issue.severity == "error"}
    for path, row in rows.items():
        if path in wrong:
            assert row.field.isEnabled()


def test_a_click_on_the_summary_goes_to_the_problem(bench: Bench) -> None:
    bench.type_into("methods.tolerance_um", "x")
    bench.window.form.rows[TEETH].field.setFocus()
    bench.window.form._summary.click()
    assert QApplication.focusWidget() is bench.window.form.rows["methods.tolerance_um"].field or not (
        bench.window.isActiveWindow()
    )


def test_every_field_explains_itself() -> None:
    for spec in field_specs():
        text = tooltip(spec)
        assert spec.description.split("<")[0][:20] in text.replace("&#x27;", "'")
        if spec.kind in ("int", "float"):
            assert "Range: " in text and limits_text(spec) in text
        if spec.equation:
            assert "=" in text or "<" in text


def test_nothing_is_cut_off_at_1280_by_720(bench: Bench) -> None:
    form = bench.window.form
    QTest.qWait(50)
    page = form._scroll.widget()
    assert page.width() <= form._scroll.viewport().width()
    for row in form.rows.values():
        field = row.field
        if isinstance(field, ChoiceField):
            needed = max(field.fontMetrics().horizontalAdvance(field.itemText(i)) for i in range(field.count()))
            assert needed + 38 <= field.width(), row.spec.path
        elif isinstance(field, NumberField):
            assert field.fontMetrics().horizontalAdvance("0000.0000") + 16 <= field.width()
        label = row._label
        assert label.heightForWidth(label.width()) <= label.height(), row.spec.path


def choose(field: ChoiceField, value: str) -> None:
    field.setCurrentIndex(field.findData(value))
    field.activated.emit(field.currentIndex())
