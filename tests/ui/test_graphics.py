"""What draws the views: chosen, asked of the drivers, and missed in words."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QSettings

from ui import graphics

ROOT = Path(__file__).resolve().parents[2]
pytestmark = pytest.mark.ui


def test_the_mode_of_the_command_line_wins(tmp_path) -> None:
    settings = QSettings(str(tmp_path / "a.ini"), QSettings.Format.IniFormat)
    assert graphics.graphics_mode(None) == "auto" and graphics.graphics_mode(settings) == "auto"
    settings.setValue(graphics.KEY, "software")
    assert graphics.graphics_mode(settings) == "software"
    assert graphics.graphics_mode(settings, "off") == "off"


def test_software_drawing_is_asked_of_the_drivers() -> None:
    environment: dict[str, str] = {}
    graphics.prepare("auto", environment)
    assert not environment
    graphics.prepare("software", environment)
    assert environment["LIBGL_ALWAYS_SOFTWARE"] == "1" and environment["QT_OPENGL"] == "software"


def test_what_helps_is_said() -> None:
    broken = graphics.Graphics(problem="This display offers no OpenGL.")
    assert "--graphics software" in graphics.advice(broken, "auto")
    assert "Mesa" in graphics.advice(broken, "software")
    assert graphics.advice(graphics.probe("off"), "off") == graphics.probe("off").problem


WITHOUT_OPENGL = """
import sys
from PySide6.QtCore import QTimer
from ui.app import Studio, make_application
from ui.theme import Theme
application = make_application(["gearstudio"])
studio = Studio(Theme(application))
studio.window.may_close = lambda: True
studio.controller.settled.connect(lambda: QTimer.singleShot(500, finish))
def finish():
    print(studio.window.area.placeholder._text.replace(chr(10), " "), len(studio.session.current), flush=True)
    studio.window.close()
    application.quit()
studio.window.show()
QTimer.singleShot(60000, application.quit)
application.exec()
"""


@pytest.mark.gl
@pytest.mark.skipif(not sys.platform.startswith("linux") or not os.environ.get("DISPLAY"), reason="needs X")
def test_without_opengl_the_window_says_so_and_everything_else_works() -> None:
    environment = os.environ | {"QT_QPA_PLATFORM": "xcb", "QT_XCB_GL_INTEGRATION": "none"}
    command = [sys.executable, "-c", WITHOUT_OPENGL]
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    assert "no OpenGL" in done.stdout and "--graphics software" in done.stdout and done.stdout.strip().endswith(" 6")
