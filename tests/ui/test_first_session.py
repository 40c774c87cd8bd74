"""A first session as a newcomer has it: mouse and keyboard alone, on the real window with the real CAD process."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QLineEdit,
    QMenu,
    QPushButton,
    QWidget,
)
from shiboken6 import isValid

from gearstudio.kernel.exchange import read_shape, solids_of
from tests.ui.screen import NEEDS_SCREEN
from tests.ui.whole import complete
from ui.app import Studio
from ui.export_dialog import ExportDialog
from ui.formatting import METHOD_TITLES
from ui.reporting.dialog import ReportDialog
from ui.views.pick_card import PickCard
from ui.views.picture_dialog import PictureDialog

pytestmark = NEEDS_SCREEN
LEFT, CTRL, SHIFT = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
EDITS = {"pair.wheel_teeth": "43", "lengthwise.spiral_angle_deg": "20+12,5", "pair.outer_module": "3.5"}


class Person:
    """Works a window as a person does; waits for what a person would wait for."""

    def __init__(self, studio: Studio) -> None:
        self.studio, self.window = studio, studio.window

    def wait(self, condition: Callable[[], bool], what: str, seconds: float = 20.0) -> None:
        end = time.monotonic() + seconds
        while not condition():
            assert time.monotonic() < end, f"waited in vain for {what}"
            QTest.qWait(20)

    def click(self, widget: QWidget, place: QPoint | None = None) -> None:
        self.wait(lambda: widget.isVisible() and widget.isEnabled(), f"{widget} to be clicked")
        assert not widget.visibleRegion().isEmpty(), f"{widget} is out of sight"
        QTest.mouseClick(widget, LEFT, pos=place or widget.rect().center())

    def points_at(self, widget: QWidget, place: QPoint) -> bool:
        """Move the mouse to a place, and say whether the status bar tells the deviation there."""
        for near in (QPoint(1, 0), QPoint(0, 0)):
            QTest.mouseMove(self.window.windowHandle(), widget.mapTo(self.window, place + near))
            QTest.qWait(50)
        return "deviation" in self.window.status.point.text()

    def press(self, key: Qt.Key, modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier) -> None:
        self.activate()
        QTest.keyClick(self.window.windowHandle(), key, modifiers)

    def activate(self) -> None:
        """Give the window the keyboard, as a window manager does when a dialog has gone."""
        self.wait(lambda: QApplication.activePopupWidget() is None, "menus to close")
        self.window.activateWindow()
        self.wait(self.window.isActiveWindow, "the keyboard")

    def choose(self, *path: str) -> None:
        """A command of the menus, by the beginnings of its titles."""
        menu: QWidget = self.window.menuBar()
        for title in path:
            action = next(a for a in menu.actions() if a.text().replace("&", "").startswith(title))
            if isinstance(menu, QMenu):
                self.wait(menu.isVisible, f"the menu with {title}")
            place = menu.actionGeometry(action).center()
            QTest.mouseMove(menu, place)
            QTest.qWait(150)
            QTest.mouseClick(menu, LEFT, pos=place)
            menu = action.menu() or menu
        self.wait(lambda: QApplication.activePopupWidget() is None, "the menus to close")
        QTest.mouseMove(self.window.windowHandle(), self.window.rect().center())

    def type_into(self, path: str, text: str) -> None:
        """Look for a field, click into it and type."""
        form, field = self.window.form, self.window.form.rows[path].field
        self.press(Qt.Key.Key_F, CTRL)
        QTest.keyClicks(form.search, path.split(".")[-1].replace("_deg", "").replace("_", " "))
        self.wait(lambda: not field.visibleRegion().isEmpty(), f"{path}, looking for {form.search.text()}", 10)
        QTest.mouseClick(field, LEFT)
        QTest.keyClick(field, Qt.Key.Key_A, CTRL)
        QTest.keyClicks(field, text)
        QTest.keyClick(field, Qt.Key.Key_Tab)

    def dialog(self, kind: type[QDialog]) -> QDialog | None:
        return next(
            (w for w in QApplication.topLevelWidgets() if isValid(w) and isinstance(w, kind) and w.isVisible()), None
        )

    def when(self, kind: type[QDialog], do: Callable[[QDialog], None]) -> None:
        """Do something in a dialog as soon as it is there, also while it holds up the rest."""

        def look() -> None:
            found = self.dialog(kind)
            if found is None:
                QTimer.singleShot(50, look)
            else:
                do(found)

        QTimer.singleShot(50, look)

    def name_file(self, name: Path) -> None:
        """Type a name into the dialog of files that will open, and press its button; give up, rather than hang."""
        end = time.monotonic() + 30

        def type_name(dialog: QDialog) -> None:
            line = dialog.findChild(QLineEdit, "fileNameEdit")
            line.setCompleter(None)  # names that begin so are offered in a list that takes the keyboard
            QTest.mouseClick(line, LEFT)
            QTest.keyClick(line, Qt.Key.Key_A, CTRL)
            QTest.keyClicks(line, str(name))
            QTimer.singleShot(100, lambda: confirm(dialog))

        def confirm(dialog: QDialog) -> None:
            if not isValid(dialog) or not dialog.isVisible():
                return
            save = dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Save)
            if time.monotonic() > end:
                dialog.reject()
                return
            QTimer.singleShot(300, lambda: confirm(dialog))
            if save.isEnabled():
                QTest.mouseClick(save, LEFT)

        self.when(QFileDialog, lambda dialog: QTimer.singleShot(300, lambda: type_name(dialog)))

    def settled(self) -> bool:
        return complete(self.studio)


@pytest.fixture
def person(open_studio) -> Person:
    made = Person(open_studio())
    made.studio.loader.finished.connect(lambda: made.studio.controller.help.tour.offer())  # as at a first start
    made.window.resize(1560, 940)
    made.wait(made.settled, "the first picture", 90)
    return made


def button(dialog: QWidget, text: str) -> QPushButton:
    return next(b for b in dialog.findChildren(QPushButton) if b.text().replace("&", "").startswith(text))


def test_a_first_session(person: Person, tmp_path: Path) -> None:
    """From a preset to a saved pair, report and picture, all of it on the disk and as it should be."""
    take_the_tour(person)
    open_a_sample_and_edit(person)
    look_around(person)
    export_the_pair(person, tmp_path)
    make_the_report(person, tmp_path / "report.pdf")
    take_a_picture(person, tmp_path / "picture.png")
    save_the_design(person, tmp_path / "mine.gear.toml")


def take_the_tour(person: Person) -> None:
    tour = person.studio.controller.help.tour
    person.wait(lambda: tour.running, "the tour")
    seen = set()
    while tour.running:
        seen.add(tour.card.title.text())
        person.click(tour.card.next)
    assert len(seen) >= 4
    tour.offer()
    assert not tour.running


def open_a_sample_and_edit(person: Person) -> None:
    session = person.studio.session
    person.choose("File", "Samples", "Archimedean")
    person.wait(lambda: session.draft["lengthwise.curve"] == "archimedean", "the sample")
    before = dict(session.draft)
    for path, text in EDITS.items():
        person.type_into(path, text)
    values = [session.draft[path] for path in EDITS]
    assert values == [43, 32.5, 3.5]
    person.press(Qt.Key.Key_Z, CTRL)
    assert session.draft == before | dict(zip(EDITS, [43, 32.5, before["pair.outer_module"]], strict=True))
    person.wait(person.settled, "the edited flanks")


def look_around(person: Person) -> None:
    """Layers, and a point of a flank with the values of every method."""
    grid, panel = person.window.area.grid, person.window.layer_panel
    person.choose("View", "Panels", "Layers")
    person.click(panel.box("pitch_cone"))
    assert "pitch_cone" in grid.visible_layers
    person.click(panel.sets.button("Generation"))
    assert "tangent_plane" in grid.visible_layers and "pitch_cone" not in grid.visible_layers
    person.click(panel.sets.button("Deviation"))
    person.press(Qt.Key.Key_F3)
    QTest.qWait(700)
    layer = next(x for x in grid.panels[1].layers if x.key == "deviation/concave")
    x, y = grid.viewport.looks[1].project(layer.points[len(layer.points) // 2])
    place = grid.viewport.place_of(1, float(x), float(y)).toPoint()
    person.wait(lambda: person.points_at(grid.viewport, place), "the deviation at the pointer")
    person.click(grid.viewport, place)
    card = person.studio.controller.display.picks.card
    person.wait(card.isVisible, "the card of the point")
    person.wait(lambda: methods_of(card) >= set(METHOD_TITLES.values()), "the values of all methods")


def methods_of(card: PickCard) -> set[str]:
    """Those for which the card has a deviation."""
    return {name.split(",")[0] for name, deviation, *_ in card.rows()[1:] if deviation != "–"}


def export_the_pair(person: Person, folder: Path) -> None:
    person.press(Qt.Key.Key_G, CTRL | SHIFT)
    mode = person.studio.controller.solid_mode
    person.wait(lambda: len(mode.keys) == 2 and all(mode.solids.is_current(k) for k in mode.keys), "both gears", 60)

    def answer(dialog: QDialog) -> None:
        line = next(w for w in dialog.findChildren(QLineEdit) if w.accessibleName() == "Folder")
        QTest.keyClick(line, Qt.Key.Key_A, CTRL)
        QTest.keyClicks(line, str(folder))
        QTest.mouseClick(button(dialog, "Export"), LEFT)

    person.when(ExportDialog, answer)
    person.press(Qt.Key.Key_E, CTRL)
    person.wait(lambda: "read back and checked" in person.window.messages.text, "the export", 60)
    written = folder / "pair-gear.step"
    assert written.stat().st_size > 100_000
    assert len(solids_of(read_shape(written, "step"))) == 2


def make_the_report(person: Person, written: Path) -> None:
    person.press(Qt.Key.Key_P, CTRL)
    person.wait(lambda: person.dialog(ReportDialog) is not None, "the dialog of the report")
    dialog = person.dialog(ReportDialog)
    person.click(button(dialog, "Update"))
    person.wait(dialog.save.isEnabled, "the report", 60)
    person.name_file(written)
    person.click(dialog.save)
    person.wait(written.exists, "the file of the report")
    assert written.read_bytes().startswith(b"%PDF") and written.stat().st_size > 50_000
    QTest.keyClick(dialog, Qt.Key.Key_Escape)
    assert person.dialog(ReportDialog) is None


def take_a_picture(person: Person, written: Path) -> None:
    person.press(Qt.Key.Key_F12)
    person.wait(lambda: person.dialog(PictureDialog) is not None, "the dialog of pictures")
    person.name_file(written)
    person.click(button(person.dialog(PictureDialog), "Save"))
    person.wait(lambda: person.dialog(PictureDialog) is None, "the picture")
    picture = QImage(str(written))
    grid = person.window.area.grid
    assert picture.height() == 2 * grid.height()
    colours = {picture.pixel(x, y) for x in range(0, picture.width(), 40) for y in range(0, picture.height(), 40)}
    assert len(colours) > 20


def save_the_design(person: Person, written: Path) -> None:
    from gearstudio.project import load_design

    person.name_file(written)
    person.press(Qt.Key.Key_S, CTRL)
    person.wait(written.exists, "the file of the design")
    saved = load_design(written)
    assert (saved.pair.wheel_teeth, saved.lengthwise.spiral_angle_deg) == (43, 32.5)
    assert not person.studio.session.unsaved and "mine" in person.window.windowTitle()
