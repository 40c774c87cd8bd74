"""Settings that may be damaged or strange, and settings that are forgotten."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QByteArray
from PySide6.QtWidgets import QMessageBox

from ui import graphics
from ui.memory import DEFAULT_LIMIT_MB, LIMIT_KEY
from ui.settings_file import open_settings, reset_settings, settings_path
from ui.upkeep import Upkeep

ROOT = Path(__file__).resolve().parents[2]
pytestmark = pytest.mark.ui


def test_good_settings_are_kept() -> None:
    opened = open_settings()
    assert not opened.complaint, "a first start has no settings, and that is no damage"
    settings = opened.settings
    settings.setValue("geometry", QByteArray(bytes(range(256))))
    settings.setValue("files/recent", ["/a = b/ü.gear.toml", "/c [d];x.gear.toml"])
    settings.setValue("odd key/ä=1", {"a": 1.5})
    settings.sync()
    opened = open_settings()
    assert not opened.complaint and opened.settings.value("geometry") == QByteArray(bytes(range(256)))
    assert opened.settings.value("files/recent")[0] == "/a = b/ü.gear.toml"


@pytest.mark.parametrize("content", [b"\0" * 4000, b"\x89PNG\r\n\xff\xfe", b"no section, no value\n", b"[General\nx"])
def test_a_damaged_settings_file_is_put_aside(content: bytes) -> None:
    path = settings_path()
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)
    opened = open_settings()
    kept = path.with_name(f"{path.name}.bak")
    assert str(kept) in opened.complaint and kept.read_bytes() == content
    opened.settings.setValue("a", 1)
    opened.settings.sync()
    assert not open_settings().complaint


@pytest.mark.parametrize("value", ["x", [1, 2], QByteArray(b"junk"), None, {"a": 1}])
def test_nonsense_in_good_settings_does_not_keep_the_window_shut(qtbot, theme, value: object) -> None:
    from ui.main_window import MainWindow
    from ui.session import Session

    settings = open_settings().settings
    for key in ("geometry", "layout", LIMIT_KEY, graphics.KEY, "files/recent"):
        settings.setValue(key, value)
    window = MainWindow(Session(), settings)
    upkeep = Upkeep(window)
    window.restore_layout()
    window.show()
    assert upkeep.memory._limit_mb == DEFAULT_LIMIT_MB and graphics.graphics_mode(settings) == "auto"
    window.close()


def test_settings_are_reset_by_a_command(tmp_path) -> None:
    environment = os.environ | {"XDG_CONFIG_HOME": str(tmp_path), "QT_QPA_PLATFORM": "offscreen"}
    file = tmp_path / "GearStudio" / "GearStudio.ini"
    file.parent.mkdir()
    file.write_text("[General]\na=1\n")

    def run() -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "main.py", "--reset-settings"]
        return subprocess.run(
            command, cwd=ROOT, env=environment, capture_output=True, text=True, timeout=60, check=True
        )

    assert str(file) in run().stdout and not file.exists()
    assert file.with_name("GearStudio.ini.bak").read_text() == "[General]\na=1\n"
    assert "no settings" in run().stdout


def test_settings_are_reset_from_the_menu_after_a_question(qtbot, theme, monkeypatch) -> None:
    from ui.main_window import MainWindow
    from ui.session import Session

    settings = open_settings().settings
    settings.setValue("a", 1)
    window = MainWindow(Session(), settings)
    upkeep = Upkeep(window)
    monkeypatch.setattr(QMessageBox, "exec", lambda _box: QMessageBox.StandardButton.Cancel)
    assert not upkeep.reset_settings() and settings.value("a") is not None
    monkeypatch.setattr(QMessageBox, "exec", lambda _box: QMessageBox.StandardButton.Reset)
    window.commands["reset_settings"].trigger()
    assert settings.allKeys() == [] and ".bak" in window.messages._full
    window.close()
    assert reset_settings() is not None or not settings_path().exists()
