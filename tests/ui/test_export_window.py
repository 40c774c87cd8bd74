"""Exports through the dialog of the real window: every format, any name, and what stays when it fails."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication

from gearstudio.cli import main
from gearstudio.project import save_design
from ui.app import Studio
from ui.export_dialog import ExportDialog

pytestmark = [pytest.mark.ui, pytest.mark.gl, pytest.mark.kernel]
PATIENCE_MS = 120_000


@pytest.fixture
def studio(open_studio, qtbot) -> Studio:
    made = open_studio()
    qtbot.waitUntil(lambda: made.controller.runner is not None, timeout=PATIENCE_MS)
    return made


def export(studio: Studio, qtbot, fill: Callable[[ExportDialog], None]) -> None:
    """Open the dialog by the command, fill it in as a user would, and wait for the answer."""
    studio.window.messages.clear()

    def answer() -> None:
        dialog = QApplication.activeModalWidget()
        assert isinstance(dialog, ExportDialog)
        fill(dialog)
        assert dialog._export.isEnabled(), dialog._files.text()
        dialog._export.click()

    QTimer.singleShot(0, answer)
    studio.window.commands["export"].trigger()
    qtbot.waitUntil(lambda: "xport" in studio.window.messages.topic and bool(studio.window.messages.text),
                    timeout=PATIENCE_MS)  # fmt: skip


def test_every_format_is_written_from_the_window_and_good(studio: Studio, qtbot, tmp_path) -> None:
    folder = tmp_path / "Räder 齿轮 и пробел"

    def fill(dialog: ExportDialog) -> None:
        dialog._part.setCurrentIndex(dialog._part.findData("tooth"))
        for box in dialog._formats.values():
            box.setChecked(True)
        for name, value in (("step_unit", "inch"), ("step_schema", "ap214"), ("stl_encoding", "text")):
            editor = dialog.options.editor(name)
            editor.setCurrentIndex(editor.findData(value))
        dialog.options.editor("chord").setText("0,03")
        dialog._record.setChecked(True)
        dialog._folder.setText(str(folder))

    export(studio, qtbot, fill)
    messages = studio.window.messages
    assert "Wrote" in messages.text, messages._full
    assert messages._full.count("of theory") > 6 * 5 and "Open CASCADE" in messages._full
    names = {f"wheel-tooth.{kind}" for kind in ("step", "iges", "brep", "stl", "3mf", "glb")}
    assert {path.name for path in folder.iterdir()} == names | {f"{name}.check.json" for name in names}
    assert "AUTOMOTIVE_DESIGN" in (folder / "wheel-tooth.step").read_text()[:3000]
    assert (folder / "wheel-tooth.stl").read_bytes().startswith(b"solid ")
    save_design(folder / "пара.gear.toml", studio.session.design)
    assert main(["verify", str(folder / "пара.gear.toml")]) == 0

    kept = (folder / "wheel-tooth.step").read_bytes()
    (folder / "wheel-tooth.glb").unlink()
    (folder / "wheel-tooth.glb").mkdir()
    export(studio, qtbot, lambda dialog: None)
    assert "failed" in messages.text and "folder of this name" in messages._full
    assert (folder / "wheel-tooth.step").read_bytes() == kept
    assert not [path for path in Path(folder).iterdir() if path.name.startswith(".")]
