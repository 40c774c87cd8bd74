"""From a field, its explanation, the data sheet or the derived values to the equation, and back to the fields."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QAction, QWhatsThisClickedEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWhatsThis, QWidget
from pytestqt.qtbot import QtBot

from gearstudio.design import all_field_specs
from gearstudio.equations import EQUATIONS, equation, equation_for, fields_of, holds
from gearstudio.presets import PRESETS
from tests.ui.stand_ins import Bench
from ui.derived_panel import QUANTITIES, SYMBOL
from ui.explain import explanation
from ui.habits import Habits
from ui.help.equations import EquationBrowser, used_by_text
from ui.help.rows import RowEquations
from ui.help.ways import keys_of_symbol

pytestmark = pytest.mark.ui


@pytest.fixture
def bench(qtbot: QtBot, theme: object) -> Iterator[Bench]:
    made = Bench()
    made.session.load(made.session.design)
    made.window.resize(1400, 900)
    made.window.show()
    qtbot.waitExposed(made.window)
    yield made
    made.close()


def shown(bench: Bench) -> str:
    """The equation that the browser shows."""
    browser = bench.controller.help._equations
    assert browser is not None and browser.isVisible()
    return browser.list.currentItem().data(0, Qt.ItemDataRole.UserRole).key


def load(bench: Bench, key: str) -> None:
    bench.session.load(next(preset.design for preset in PRESETS if preset.key == key))


def press(command: QAction, widget: QWidget) -> None:
    QTest.keySequence(widget, command.shortcut())


def test_the_menu_of_a_field_opens_its_equation(bench: Bench) -> None:
    row = bench.window.form.rows["tooth.fillet_factor"]
    action = next(action for action in row.make_menu().actions() if action.text() == "Show equation")
    action.trigger()
    assert shown(bench) == "fillet"
    texts = [action.text() for action in bench.window.form.rows["name"].make_menu().actions()]
    assert "Show equation" not in texts


def test_the_key_opens_the_equation_of_the_field_with_the_cursor(bench: Bench, qtbot: QtBot) -> None:
    bench.window.activateWindow()
    bench.window.form.go_to("lengthwise.cutter_radius")
    qtbot.waitUntil(lambda: bench.window.form.focused_path() == "lengthwise.cutter_radius")
    press(bench.window.commands["show_equation"], bench.window.form.rows["lengthwise.cutter_radius"].field)
    assert shown(bench) == "trace"
    load(bench, "hypoid-car")
    bench.controller.help.ways.show_field("pair.shaft_angle_deg")
    assert shown(bench) == "pitch_cones"


def popup() -> QWidget | None:
    """The box with an explanation."""
    visible = (widget for widget in QApplication.topLevelWidgets() if widget.isVisible())
    return next((widget for widget in visible if widget.metaObject().className() == "QWhatsThat"), None)


def test_what_is_clicked_is_explained(bench: Bench, qtbot: QtBot) -> None:
    Habits(bench.controller)
    row = bench.window.form.rows["pair.wheel_teeth"]
    derived = bench.window.derived.view
    for widget, place in ((row, row._label.geometry().center()), (derived.viewport(), QPoint(20, 20))):
        QWhatsThis.enterWhatsThisMode()
        QTest.mouseClick(widget, Qt.MouseButton.LeftButton, pos=place)
        qtbot.waitUntil(lambda: popup() is not None)
        QWhatsThis.hideText()
        qtbot.waitUntil(lambda: popup() is None)
        assert not QWhatsThis.inWhatsThisMode()


def test_a_click_on_the_link_of_an_explanation_opens_the_equation(bench: Bench, qtbot: QtBot) -> None:
    habits = Habits(bench.controller)
    habits.explain("tooth.fillet_factor")
    qtbot.waitUntil(lambda: popup() is not None)
    widget = popup()
    assert widget is not None
    for y in range(widget.height() - 10, 10, -6):
        place = QPoint(30, y)
        QTest.mouseMove(widget, place)
        if widget.cursor().shape() == Qt.CursorShape.PointingHandCursor:
            QTest.mouseClick(widget, Qt.MouseButton.LeftButton, pos=place)
            break
    assert shown(bench) == "fillet"
    assert popup() is None


def test_the_link_in_an_explanation_opens_the_equation(bench: Bench) -> None:
    asked = []
    bench.controller.help.ways.equation_asked.connect(asked.append)
    path = "modifications.wheel.convex.tip_relief_um"
    assert QApplication.sendEvent(bench.window, QWhatsThisClickedEvent(f"equation:{path}"))
    assert asked == ["tip_relief"] and shown(bench) == "tip_relief"


def test_an_explanation_leads_to_the_glossary(bench: Bench) -> None:
    assert "glossary:Backlash" in explanation(all_field_specs()["tooth.backlash"], 0.1, "", [])
    assert QApplication.sendEvent(bench.window, QWhatsThisClickedEvent("glossary:Backlash"))
    guide = bench.controller.help._guide
    assert guide is not None and guide.pages.currentData() == "glossary"
    assert guide.view.textCursor().block().text().startswith("Backlash")


def test_a_derived_value_has_a_button_and_a_key(bench: Bench, qtbot: QtBot) -> None:
    view, ways = bench.window.derived.view, bench.controller.help.ways.derived
    row = next(r for r in range(view.rowCount()) if view.item(r, 0).data(SYMBOL) == "δ_b")
    place = view.visualItemRect(view.item(row, 1)).center()
    QTest.mouseMove(view.viewport(), place + QPoint(3, 0))
    QTest.mouseMove(view.viewport(), place)
    qtbot.waitUntil(ways.button.isVisible)
    assert ways.button.geometry().center().y() == pytest.approx(place.y(), abs=2)
    qtbot.mouseClick(ways.button, Qt.MouseButton.LeftButton)
    assert shown(bench) == "base_angle"
    view.setCurrentCell(0, 0)
    view.setFocus()
    QTest.keyClick(view, Qt.Key.Key_Return)
    assert shown(bench) == "pitch_angle"


def test_every_derived_value_leads_to_an_equation(bench: Bench) -> None:
    for key in ("default", "hypoid-car", "uniform-depth"):
        load(bench, key)
        view = bench.window.derived.view
        symbols = [view.item(row, 0).data(SYMBOL) for row in range(view.rowCount())]
        assert len(symbols) > len(QUANTITIES)
        pair = bench.session.pair
        assert pair is not None
        assert all(holds(equation(equation_for(keys_of_symbol(symbol), pair)), pair) for symbol in symbols)


def test_rows_of_the_data_sheet_and_their_explanations_lead_to_equations(bench: Bench, qtbot: QtBot) -> None:
    from ui.analysis.datasheet_page import DatasheetPage

    page = DatasheetPage()
    qtbot.addWidget(page)
    page.resize(900, 400)
    page.show()
    bench.window.analysis.page_made.emit(page)
    page.show_session(bench.session)
    page.table.choose("R_b")
    assert "Show equation" in page.explanation.text()
    page.explanation._text.linkActivated.emit("R_b")
    assert shown(bench) == "base_radius"
    page.table.choose("d_ae")
    page.table.table.setFocus()
    QTest.keyClick(page.table.table, Qt.Key.Key_Return)
    assert shown(bench) == "diameters"
    rows = bench.controller.help.ways.sheet
    assert isinstance(rows, RowEquations)
    head = page.table.table.item(0, 0)
    assert head is not None and page.table.equations_at(0) == ()


def test_the_browser_leads_back_to_the_fields(bench: Bench, qtbot: QtBot) -> None:
    browser = bench.controller.help.open_equations("taper")
    assert "Dedendum angle" in browser.used_by.text()
    browser.used_by.linkActivated.emit("depth.dedendum_angle_deg")
    qtbot.waitUntil(lambda: bench.window.form.rows["depth.dedendum_angle_deg"].isVisible())
    for one in EQUATIONS:
        assert used_by_text(one.key).count("<a href") <= max(len(fields_of(one.key)), 0)
    assert used_by_text("relief").count("<a href") == 7, "the same field of four flanks is named once"


def test_what_does_not_hold_is_grey_and_chosen_all_the_same(bench: Bench, qtbot: QtBot) -> None:
    browser: EquationBrowser = bench.controller.help.open_equations("offset_arms")
    pair = bench.session.pair
    assert pair is not None
    for item in browser._items():
        grey = item.foreground(0).style() != Qt.BrushStyle.NoBrush
        assert grey != holds(item.data(0, Qt.ItemDataRole.UserRole), pair)
    browser.search.setText("fillet")
    browser.choose("offset_arms")
    assert browser.search.text() == "" and shown(bench) == "offset_arms"
