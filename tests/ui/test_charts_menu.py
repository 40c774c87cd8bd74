"""The menu of a chart, and tables that go into a spreadsheet in the language and unit of the window."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QContextMenuEvent, QGuiApplication
from PySide6.QtWidgets import QApplication, QMenu

from tests.ui.reading import texts_of
from ui import units
from ui.charts.chart import Chart
from ui.charts.frame import ChartFrame
from ui.charts.records import Axis, ChartData, Series, Table
from ui.language import Language

pytestmark = pytest.mark.ui


@pytest.fixture
def frame(qtbot) -> ChartFrame:
    chart = Chart()
    x = np.linspace(0.0, 10.0, 11)
    chart.show_data(ChartData("curve", Axis("Way", "mm"), Axis("Size", "µm"), (Series("one", x, x**2, "pinion"),)))
    made = ChartFrame(chart)
    qtbot.addWidget(made)
    made.resize(500, 300)
    made.show()
    qtbot.waitExposed(made)
    return made


@pytest.fixture(params=["en", "de", "zh"])
def speaking(request, qapp: QApplication) -> Iterator[str]:
    language = Language(qapp, request.param)
    yield request.param
    language.speak("en")


@pytest.fixture
def inches() -> Iterator[None]:
    units.use(units.Display("in"))
    yield
    units.use(units.Display())


def right_click(frame: ChartFrame, qtbot) -> QMenu:
    view = frame.chart._view
    place = view.mapFromScene(view.scene().itemsBoundingRect().center())
    qtbot.mouseClick(view.viewport(), Qt.MouseButton.RightButton, pos=QPointF(place).toPoint())
    found = [menu for menu in frame.findChildren(QMenu) if menu.isVisible()]
    assert len(found) == 1
    return found[0]


def test_the_right_button_opens_a_menu_of_our_own(speaking: str, frame: ChartFrame, qtbot) -> None:
    menu = right_click(frame, qtbot)
    texts = [action.text() for action in menu.actions() if not action.isSeparator()]
    assert len(texts) == 5
    letters = [text[text.index("&") + 1].lower() for text in texts]
    assert len(set(letters)) == 5
    said = [text for _, text in texts_of(frame)]
    assert not any("Export" in text or "Axis" in text for text in said)
    frame.chart.plot.setXRange(2, 3)
    menu.actions()[0].trigger()
    qtbot.wait(50)
    assert frame.chart.plot.vb.viewRange()[0][1] > 9
    menu.actions()[-3].trigger()
    data = QGuiApplication.clipboard().mimeData()
    assert data.hasText() and not data.hasImage()
    menu.close()


def test_a_drag_of_the_right_button_scales_and_opens_nothing(frame: ChartFrame, qtbot) -> None:
    view = frame.chart._view.viewport()
    before = frame.chart.plot.vb.viewRange()
    qtbot.mousePress(view, Qt.MouseButton.RightButton, pos=QPoint(250, 150))
    for step in range(1, 9):
        qtbot.mouseMove(view, QPoint(250 + 8 * step, 150 - 5 * step))
        qtbot.wait(20)
    qtbot.mouseRelease(view, Qt.MouseButton.RightButton, pos=QPoint(314, 110))
    assert not [menu for menu in frame.findChildren(QMenu) if menu.isVisible()]
    assert frame.chart.plot.vb.viewRange() is not before


def test_the_menu_key_opens_it_from_the_frame(frame: ChartFrame) -> None:
    asked = QContextMenuEvent(QContextMenuEvent.Reason.Keyboard, QPoint(5, 5), frame.mapToGlobal(QPoint(5, 5)))
    QApplication.sendEvent(frame, asked)
    found = [menu for menu in frame.findChildren(QMenu) if menu.isVisible()]
    assert len(found) == 1
    found[0].close()


def test_a_copied_table_speaks_the_language_and_the_unit(inches: None, qapp: QApplication) -> None:
    table = Table(("member", "flank", "x [mm]", "gap [µm]"), [("pinion", "concave", 25.4, 3.5)])
    language = Language(qapp, "de")
    try:
        shown = table.shown()
    finally:
        language.speak("en")
    assert shown.head[2:] == ("x [in]", shown.head[3]) and shown.head[3].endswith("[µm]")
    assert shown.rows[0][2:] == ["1", "3,5"] and "konkav" in shown.rows[0][1].lower()
    assert table.text() == "member,flank,x [mm],gap [µm]\npinion,concave,25.4,3.5\n", "files stay as they are"
