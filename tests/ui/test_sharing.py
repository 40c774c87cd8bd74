"""In a narrow window the panel beside the views shares a place; in a wide one everything stays where it is put."""

from __future__ import annotations

from collections.abc import Iterator
from types import SimpleNamespace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QDockWidget, QLabel, QVBoxLayout, QWidget

from tests.ui.stand_ins import Bench
from ui.keyboard import stops
from ui.sharing import LEAST_VIEW, Sharing
from ui.view_area import ViewArea
from ui.views.display_panel import DisplayPanel

pytestmark = pytest.mark.ui
NARROW, WIDE = (1280, 720), (1560, 900)


@pytest.fixture
def bench(qtbot) -> Iterator[Bench]:
    made = Bench()
    made.panel = DisplayPanel()  # type: ignore[attr-defined]
    made.window.sharing.adopt(made.panel)  # type: ignore[attr-defined]
    made.window.resize(*NARROW)
    made.window.show()
    qtbot.waitExposed(made.window)
    yield made
    made.close()


def dock(bench: Bench, name: str) -> QDockWidget:
    return bench.window.findChild(QDockWidget, name)


def views_width(bench: Bench) -> int:
    area = bench.window.area
    return area.width() - (0 if bench.window.sharing.place else bench.panel.width())


@pytest.mark.parametrize("solid", [False, True])
def test_the_views_keep_their_width_with_every_panel_open(bench: Bench, qtbot, solid: bool) -> None:
    window, sharing = bench.window, bench.window.sharing
    window.show_solid_mode(True) if solid else dock(bench, "Layers").show()
    sharing.set_open(True)
    qtbot.waitUntil(lambda: sharing.place is sharing.places[int(solid)])
    assert bench.panel.isVisible() and sharing.place.keep_state(), "just opened: in front"
    assert views_width(bench) >= LEAST_VIEW
    sharing.place.tabs.button("host").click()
    assert not bench.panel.isVisible()
    assert (window.solid_panel if solid else window.layer_panel).isVisible()
    window.resize(*WIDE)
    qtbot.waitUntil(lambda: sharing.place is None)
    assert bench.panel.isVisible() and window.area.isAncestorOf(bench.panel) and views_width(bench) >= LEAST_VIEW
    assert not any(place.tabs.isVisible() for place in sharing.places)
    window.resize(*NARROW)
    qtbot.waitUntil(lambda: sharing.place is not None)
    assert not bench.panel.isVisible(), "what was open before stays in front"
    sharing.set_open(False)
    assert sharing.place is None and bench.panel.isHidden()


def test_a_panel_that_comes_takes_it_in_and_gives_it_back(bench: Bench, qtbot) -> None:
    window, sharing = bench.window, bench.window.sharing
    sharing.set_open(True)
    QTest.qWait(200)
    assert sharing.place is None and views_width(bench) >= LEAST_VIEW
    window.show_solid_mode(True)
    qtbot.waitUntil(lambda: sharing.place is sharing.places[1])
    assert window.solid_panel.isVisible() and not bench.panel.isVisible()
    window.show_solid_mode(False)
    qtbot.waitUntil(lambda: sharing.place is None and bench.panel.isVisible())
    layers = dock(bench, "Layers")
    layers.setFloating(True)
    layers.show()
    QTest.qWait(200)
    assert sharing.place is None, "a panel that stands by itself takes nothing from the views"


def test_no_panel_is_moved_and_the_layout_is_remembered_as_it_was(bench: Bench, qtbot) -> None:
    window, sharing = bench.window, bench.window.sharing
    dock(bench, "Layers").show()
    QTest.qWait(200)
    places = {one: one.geometry() for one in window.findChildren(QDockWidget) if one.isVisible()}
    sharing.set_open(True)
    qtbot.waitUntil(lambda: sharing.place is not None)
    assert {one: one.geometry() for one in places} == places
    kept = window.layout_state()
    sharing.set_open(False)
    window.restore_panels(kept)
    QTest.qWait(200)
    assert {one: one.geometry() for one in places} == places and all(one.isVisible() for one in places)


def test_the_keyboard_comes_by_the_tabs_and_what_is_in_front(bench: Bench, qtbot) -> None:
    sharing = bench.window.sharing
    bench.window.show_solid_mode(True)
    sharing.set_open(True)
    qtbot.waitUntil(lambda: sharing.place is not None)
    way = stops(sharing.place)
    assert way[:2] == [sharing.place.tabs.button("host"), sharing.place.tabs.button("guest")]
    assert len(way) > 8 and all(bench.panel.isAncestorOf(one) for one in way[2:])


def test_the_keyboard_goes_along_when_the_panel_moves(bench: Bench, qtbot) -> None:
    sharing = bench.window.sharing
    bench.window.show_solid_mode(True)
    sharing.set_open(True)
    qtbot.waitUntil(lambda: sharing.place is not None)
    box = next(one for one in bench.panel.findChildren(QCheckBox) if one.isVisible())
    bench.window.activateWindow()
    box.setFocus(Qt.FocusReason.TabFocusReason)
    assert bench.window.focusWidget() is box
    bench.window.resize(*WIDE)
    qtbot.waitUntil(lambda: sharing.place is None)
    assert bench.window.focusWidget() is box


def test_the_colour_scale_takes_room_too(qtbot) -> None:
    window, area = QWidget(), ViewArea()
    QVBoxLayout(window).addWidget(area)
    qtbot.addWidget(window)
    panel = QLabel()
    sharing = Sharing(area, window)
    place = sharing.shared("Layers", QWidget())
    window.layout().addWidget(place)
    sharing.adopt(panel)
    window.show()
    qtbot.waitExposed(window)
    area.color_bar = SimpleNamespace(isVisible=lambda: True, width=lambda: 80)
    window.resize(LEAST_VIEW + 60, 700)
    QTest.qWait(50)
    sharing.set_open(True)
    assert sharing.place is place
    area.color_bar = None
    area.resized.emit()
    qtbot.waitUntil(lambda: sharing.place is None)
