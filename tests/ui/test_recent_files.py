"""The list of recent files."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QMenu

from ui.projects.recent import Recent

pytestmark = pytest.mark.ui


def test_recent_files_are_remembered_newest_first(qtbot, theme, settings: QSettings, tmp_path) -> None:
    paths = [tmp_path / f"{number}.gear.toml" for number in range(15)]
    for path in paths:
        path.touch()
    menu = QMenu()
    recent = Recent(menu, settings)
    for path in [*paths, paths[12]]:
        recent.add(path)
    assert recent.paths[:3] == (paths[12], paths[14], paths[13]) and len(set(recent.paths)) == 12
    assert Recent(QMenu(), settings).paths == recent.paths
    chosen: list[Path] = []
    recent.chosen.connect(chosen.append)
    menu.actions()[1].trigger()
    assert chosen == [paths[14]]


def test_missing_recent_files_are_marked_and_removed(qtbot, theme, settings: QSettings, tmp_path) -> None:
    here, gone = tmp_path / "here.gear.toml", tmp_path / "gone & away.gear.toml"
    here.touch()
    menu = QMenu()
    recent = Recent(menu, settings)
    recent.add(gone)
    recent.add(here)
    assert menu.actions()[0].isEnabled() and not menu.actions()[1].isEnabled()
    assert "gone && away" in menu.actions()[1].text() and "missing" in menu.actions()[1].text()
    next(action for action in menu.actions() if "missing ones" in action.text()).trigger()
    assert recent.paths == (here,)
    menu.actions()[-1].trigger()
    assert recent.paths == () and not menu.actions()[-1].isEnabled() and not menu.actions()[0].isVisible()


@pytest.mark.parametrize("stored", [None, "one", ["a", 3, None], 7, {"a": 1}, ["\0"], [""]])
def test_strange_settings_do_no_harm(qtbot, theme, settings: QSettings, stored: object) -> None:
    settings.setValue("files/recent", stored)
    recent = Recent(QMenu(), settings)
    assert all(isinstance(path, Path) and path.name for path in recent.paths)
