"""The style sheet: it is read, and finds its icons, in whatever folder the program is."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtGui import QColor, QImage
from PySide6.QtWidgets import QCheckBox
from pytestqt.qtbot import QtBot

from ui import theme

pytestmark = pytest.mark.ui


@pytest.fixture(params=["plain", "Büro & Platz (1)", "a 'quoted' \"one\"; {b}", "齿轮"])
def folder(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """The window's folder, somewhere else."""
    place = tmp_path / request.param
    shutil.copytree(theme.HERE / "icons", place / "icons")
    shutil.copy(theme.HERE / "style.qss", place)
    with monkeypatch.context() as patch:
        patch.setattr(theme, "HERE", place)
        yield place
    theme.style_sheet(theme.LIGHT)


def ticked(qtbot: QtBot) -> QImage:
    """A ticked box in the style."""
    box = QCheckBox()
    qtbot.addWidget(box)
    box.setStyleSheet(theme.style_sheet(theme.LIGHT))
    box.setChecked(True)
    return box.grab().toImage()


def test_the_style_holds_in_any_folder(qtbot: QtBot, folder: Path) -> None:
    image = ticked(qtbot)
    colours = [image.pixelColor(x, y) for x in range(image.width()) for y in range(image.height())]
    assert colours.count(QColor(theme.LIGHT.accent)) > 50
    (folder / "icons" / "tick.svg").write_bytes((folder / "icons" / "close.svg").read_bytes())
    assert ticked(qtbot) != image
