"""The log panel, errors that are told once, and displays that go."""

from __future__ import annotations

import logging
import threading

import pytest
from PySide6.QtCore import QRect
from PySide6.QtGui import QGuiApplication

from tests.ui.stand_ins import Bench
from ui.diagnostics import CrashCatcher, note_fact, versions
from ui.log_panel import LogDock
from ui.screens import fitted
from ui.upkeep import Upkeep

pytestmark = pytest.mark.ui


# --- log and crashes


def test_the_log_panel_shows_what_any_thread_notes(bench: Bench, qtbot) -> None:
    dock = LogDock(bench.window)
    log = logging.getLogger("gears")
    log.setLevel(logging.INFO)
    log.info("calm")
    thread = threading.Thread(target=lambda: log.error("loud"))
    thread.start()
    thread.join()
    panel = dock.panel
    qtbot.waitUntil(lambda: "loud" in panel.text.toPlainText(), timeout=2000)
    assert "calm" in panel.text.toPlainText() and panel.count.text().startswith("2 entries, 1 ")
    panel.level.setCurrentIndex(2)
    assert "calm" not in panel.text.toPlainText() and "loud" in panel.text.toPlainText()
    log.warning("between")
    qtbot.waitUntil(lambda: panel.count.text().startswith("3"), timeout=2000)
    assert "between" not in panel.text.toPlainText()
    panel.copy.click()
    assert "loud" in QGuiApplication.clipboard().text()
    panel.clear.click()
    assert not panel.text.toPlainText()
    dock.stop()
    log.error("unheard")
    qtbot.wait(20)
    assert not panel.text.toPlainText()


def test_an_error_is_told_once_however_often_it_comes(qtbot) -> None:
    catcher = CrashCatcher()
    told: list[str] = []
    catcher.crashed.connect(told.append)
    note_fact("Graphics", "a test")

    def fail(text: str) -> None:
        try:
            raise ValueError(text)
        except ValueError as error:
            catcher._on_exception(type(error), error, error.__traceback__)

    for text in ("one", "one", "two", "one"):
        fail(text)
    assert [report.partition("ValueError: ")[2][:3] for report in told] == ["one", "two"]
    assert "Graphics: a test" in told[0] and "Graphics: a test" in versions()


# --- displays


def test_a_window_whose_head_is_out_of_reach_is_brought_back() -> None:
    screens = [QRect(0, 0, 1920, 1080), QRect(1920, 0, 1280, 720)]
    for good in (QRect(100, 100, 800, 600), QRect(2000, 50, 1000, 600), QRect(-700, 30, 800, 600)):
        assert fitted(good, screens) == good
    for bad in (
        QRect(4000, 100, 800, 600),
        QRect(100, 1200, 800, 600),
        QRect(-790, 30, 800, 600),
        QRect(0, -500, 900, 600),
    ):
        placed = fitted(bad, screens)
        assert placed != bad and screens[0].contains(placed)
    assert fitted(QRect(5000, 0, 4000, 3000), screens) == screens[0]
    assert fitted(QRect(5000, 0, 10, 10), []) == QRect(5000, 0, 10, 10)


def test_the_window_comes_back_when_its_display_goes(bench: Bench, qtbot) -> None:
    upkeep = Upkeep(bench.window)
    bench.window.setGeometry(9000, 9000, 1000, 700)
    upkeep.screens._on_changed(None)
    available = QGuiApplication.primaryScreen().availableGeometry()
    qtbot.waitUntil(lambda: available.intersects(bench.window.geometry()), timeout=3000)
