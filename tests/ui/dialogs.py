"""Dialogs with something in them, for tests of how they look and what keys do in them."""

from __future__ import annotations

from pathlib import Path
from tempfile import mkdtemp
from types import SimpleNamespace

from PySide6.QtWidgets import QWidget

from gearstudio.design import Design, with_field
from gearstudio.project import save_design
from tests.ui.places import left_behind
from tests.ui.stand_ins import Bench
from ui.color_bar import ColorBar
from ui.projects.autosave import abandoned
from ui.projects.backups import Backups
from ui.projects.backups_dialog import BackupsDialog
from ui.projects.recovery_dialog import RecoveryDialog
from ui.views.film_dialog import FilmDialog
from ui.views.motions import turntable
from ui.views.picture_dialog import PictureDialog

TEETH = "pair.wheel_teeth"


class StillWindow(QWidget):
    """As much of a window as a dialog of pictures and films asks before it begins; the views are empty."""

    def __init__(self, bench: Bench) -> None:
        super().__init__(bench.window)
        self.area = SimpleNamespace(grid=QWidget(self), color_bar=ColorBar(self))
        self.messages = bench.window.messages


def recovery_dialog(bench: Bench) -> RecoveryDialog:
    """With a design that was never saved, and one that was saved before."""
    folder = Path(mkdtemp())
    saved = folder / "shaft.gear.toml"
    save_design(saved, Design())
    left_behind(folder, None, "axle", **{TEETH: 41})
    left_behind(folder, saved, "shaft", **{TEETH: 42})
    return RecoveryDialog(abandoned(folder / "recovery"), bench.window)


def backups_dialog(bench: Bench) -> BackupsDialog:
    """With two saves of a design."""
    folder = Path(mkdtemp())
    path, backups = folder / "shaft.gear.toml", Backups(folder / "backups")
    for teeth in (41, 42):
        save_design(path, with_field(Design(), TEETH, teeth))
        backups.keep(path)
    return BackupsDialog(backups, path, dict(bench.session.draft), bench.window)


def picture_dialog(bench: Bench) -> PictureDialog:
    return PictureDialog(StillWindow(bench), "/tmp")  # type: ignore[arg-type]


def film_dialog(bench: Bench) -> FilmDialog:
    return FilmDialog(StillWindow(bench), "/tmp", (turntable(),))  # type: ignore[arg-type]
