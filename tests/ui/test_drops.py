"""Files dropped on a window, and the windows that they get."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QMimeData, QObject, QUrl, Signal

from ui.projects import windows
from ui.projects.drops import Drops, dropped_files

ROOT = Path(__file__).resolve().parents[2]
pytestmark = pytest.mark.ui


class FakePage:
    def __init__(self) -> None:
        self.opened: list[Path] = []

    def open_path(self, path: Path) -> None:
        self.opened.append(path)


class FakeArea(QObject):
    page_made = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self.pages: dict[str, FakePage] = {}
        self.shown: list[str] = []

    def show_tab(self, tab: str) -> None:
        self.shown.append(tab)


def test_drops_are_sorted(tmp_path) -> None:
    names = ("a.csv", "b.gear.toml", "c.png", "d.GEAR.TOML", "e.DAT")
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(tmp_path / name)) for name in names] + [QUrl("https://example.com/f.csv")])
    design, others = dropped_files(data)
    assert design.name == "b.gear.toml" and [path.name for path in others] == ["a.csv", "d.GEAR.TOML", "e.DAT"]
    assert dropped_files(QMimeData()) == (None, ())


def test_points_wait_for_the_page_and_designs_get_windows(qtbot, monkeypatch, tmp_path) -> None:
    started: list[tuple[str, ...]] = []
    monkeypatch.setattr("ui.projects.drops.open_window", lambda *names: started.append(names))
    area = FakeArea()
    drops = Drops(area)
    drops.take((tmp_path / "b.gear.toml", tmp_path / "a.csv"))
    assert area.shown == ["measurement"] and started == [(str(tmp_path / "b.gear.toml"),)]
    page = area.pages["measurement"] = FakePage()
    area.page_made.emit(page)
    assert page.opened == [tmp_path / "a.csv"]
    drops.take((tmp_path / "c.ibl",))
    assert page.opened[-1] == tmp_path / "c.ibl"


def test_a_window_is_this_program_again(monkeypatch) -> None:
    assert windows.command("a.gear.toml") == [sys.executable, str(ROOT / "main.py"), "a.gear.toml"]
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    assert windows.command("a.gear.toml") == [sys.executable, "a.gear.toml"]


@pytest.mark.usefixtures("german")
def test_another_window_speaks_the_language_of_this_one(monkeypatch) -> None:
    started: list[list[str]] = []
    monkeypatch.setattr(windows.QProcess, "startDetached", lambda _program, rest: [not started.append(rest)])
    assert windows.open_window("a.gear.toml")
    assert started[0][-3:] == ["a.gear.toml", "--language", "de"]
