"""Panels behind each other have tabs where they are, and nowhere else."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtCore import QSettings, Qt
from PySide6.QtWidgets import QTabBar

from ui.main_window import MainWindow
from ui.session import Session
from ui.upkeep import Upkeep

pytestmark = pytest.mark.ui


def make(qtbot, path: Path) -> tuple[MainWindow, Upkeep]:
    session = Session()
    window = MainWindow(session, QSettings(str(path), QSettings.Format.IniFormat))
    session.setParent(window)
    upkeep = Upkeep(window)
    window.restore_layout()
    qtbot.addWidget(window)
    window.show()
    qtbot.waitExposed(window)
    return window, upkeep


def rows(window: MainWindow) -> list[QTabBar]:
    """Those that the window shows; Qt puts one of a single tab outside, but one that it forgot can be anywhere."""
    found = window.findChildren(QTabBar, options=Qt.FindChildOption.FindDirectChildrenOnly)
    return [row for row in found if row.isVisible()]


def in_sight(window: MainWindow) -> list[int]:
    """How many tabs each row has that lies in the window."""
    return [row.count() for row in rows(window) if row.geometry().intersects(window.rect())]


def test_a_layout_of_the_last_time_leaves_no_tabs_over_the_menus(qtbot, theme, tmp_path: Path) -> None:
    for _ in range(2):
        window, upkeep = make(qtbot, tmp_path / "settings.ini")
        assert in_sight(window) == []
        assert len(rows(window)) == 1
        upkeep.log.toggleViewAction().trigger()
        qtbot.waitUntil(lambda shown=window: in_sight(shown) == [2])
        upkeep.log.toggleViewAction().trigger()
        qtbot.waitUntil(lambda shown=window: in_sight(shown) == [])
        window.close()
