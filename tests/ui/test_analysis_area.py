"""The area of analysis: pages made when first shown, kept in step with the session, with the room they need."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.ui.stand_ins import Bench

ROOT = Path(__file__).resolve().parents[2]
TABS = ("comparison", "charts", "contact", "datasheet", "measurement")
pytestmark = pytest.mark.ui


@pytest.fixture
def bench(qtbot, theme) -> Iterator[Bench]:
    made = Bench()
    made.window.resize(1280, 720)
    made.window.reset_layout()
    made.window.show()
    qtbot.waitExposed(made.window)
    yield made
    made.close()


def test_the_charts_library_is_not_loaded_before_its_stage() -> None:
    program = "import sys, ui.app; print([m for m in sys.modules if m.startswith(('pyqtgraph', 'ui.charts'))])"
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_a_tab_chosen_early_is_filled_when_the_library_comes(bench: Bench, qtbot) -> None:
    area = bench.window.analysis
    area.tabs.button("datasheet").click()
    assert area.page is None and area._waiting.isVisible()
    bench.controller.charts_ready()
    qtbot.waitUntil(lambda: area.page is not None)
    assert list(area.pages) == ["datasheet"] and not area._waiting.isVisible()
    assert area.page.table.table.rowCount() > 60


def test_pages_follow_the_session(bench: Bench, qtbot) -> None:
    area = bench.window.analysis
    bench.controller.charts_ready()
    area.show_tab("charts")
    area.show_tab("datasheet")
    bench.session.edit("pair.wheel_teeth", 51)
    page = area.pages["datasheet"]
    page.table.choose("delta")
    row = page.table.table.currentRow()
    qtbot.waitUntil(lambda: page.table.table.item(row, 2).text() == "18.43495")
    bench.session.select(member="pinion")
    area.show_tab("charts")
    qtbot.waitUntil(lambda: "pinion" in area.pages["charts"].chart.name)


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080)])
def test_every_page_has_room_and_cuts_nothing_off(bench: Bench, qtbot, size: tuple[int, int]) -> None:
    window, area = bench.window, bench.window.analysis
    window.resize(*size)
    window.reset_layout()
    bench.controller.charts_ready()
    for tab in TABS:
        area.show_tab(tab)
        qtbot.wait(100)
        assert (window.width(), window.height()) == size, tab
        assert window.area.height() >= 200, tab
        if tab != "comparison":
            page = area.pages[tab]
            assert page.height() >= 220, tab
            assert page.minimumSizeHint().width() <= page.width(), tab


def test_the_analysis_may_take_the_room_of_the_views(bench: Bench, qtbot) -> None:
    window, area = bench.window, bench.window.analysis
    bench.controller.charts_ready()
    area.show_tab("charts")
    before = area.height()
    area.expand.click()
    qtbot.waitUntil(lambda: area.height() > before + 150)
    assert not window.area.isVisible()
    area.expand.click()
    qtbot.waitUntil(lambda: window.area.isVisible())
    area.expand.click()
    window.reset_layout()
    assert window.area.isVisibleTo(window) and not area.expand.isChecked()


def test_what_a_page_says_is_shown(bench: Bench) -> None:
    bench.controller.charts_ready()
    bench.window.analysis.show_tab("datasheet")
    bench.window.analysis.page.copy("text")
    assert "Copied the data sheet" in bench.window.messages.text


def test_a_library_that_cannot_be_loaded_is_told_in_its_place(bench: Bench) -> None:
    area = bench.window.analysis
    area.show_tab("contact")
    area.show_failure("The analysis could not be loaded.")
    assert area.page is None and "could not" in area._waiting.text()
    area.show_tab("comparison")
    assert bench.window.table.isVisible()
