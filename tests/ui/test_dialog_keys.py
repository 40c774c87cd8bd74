"""Enter and Escape in dialogs do what one expects, and menus that click out can be used by keys alone."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtGui import QAction, QContextMenuEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog, QFileDialog, QMenu, QMessageBox, QToolButton, QWidget

from tests.ui.dialogs import TEETH, backups_dialog, film_dialog, picture_dialog, recovery_dialog
from tests.ui.stand_ins import Bench
from ui.charts.menu import chart_menu
from ui.color_bar import ColorBar
from ui.form_section import Section
from ui.habits import Habits
from ui.language import Language
from ui.mnemonics import mark
from ui.tables import copy_menu

pytestmark = pytest.mark.ui
ENTER, ESCAPE = Qt.Key.Key_Return, Qt.Key.Key_Escape


@pytest.fixture
def bench(qtbot) -> Iterator[Bench]:
    made = Bench()
    made.habits = Habits(made.controller)  # type: ignore[attr-defined]
    made.window.show()
    qtbot.waitExposed(made.window)
    yield made
    made.close()


@pytest.fixture
def show(bench: Bench, qtbot) -> Iterator[Callable]:
    shown: list[QDialog] = []

    def run(make: Callable[[Bench], QDialog]) -> QDialog:
        dialog = make(bench)
        shown.append(dialog)
        dialog.show()
        qtbot.waitExposed(dialog)
        dialog.activateWindow()
        return dialog

    yield run
    for dialog in shown:
        dialog.close()
        dialog.deleteLater()


def press(dialog: QDialog, key: Qt.Key) -> None:
    QTest.keyClick(dialog.focusWidget() or dialog, key)


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Titles of the file dialogs that were asked for; none gives a name."""
    titles: list[str] = []

    def ask(_parent: QWidget, title: str, *_: object) -> tuple[str, str]:
        titles.append(title)
        return "", ""

    monkeypatch.setattr(QFileDialog, "getSaveFileName", ask)
    return titles


class TestRecovery:
    def test_the_keyboard_begins_in_the_list_and_enter_recovers_what_is_chosen(self, show) -> None:
        dialog = show(recovery_dialog)
        chosen: list = []
        dialog.recovered_chosen.connect(lambda one, version: chosen.append((one.snapshot.title, version.draft)))
        assert dialog.focusWidget() is dialog.list
        second = dialog.list.topLevelItem(1).text(0)
        press(dialog, Qt.Key.Key_Down)
        press(dialog, ENTER)
        assert [title for title, _ in chosen] == [second] and chosen[0][1][TEETH] == {"axle": 41, "shaft": 42}[second]
        assert not dialog.isVisible()

    def test_escape_keeps_everything_for_later(self, show) -> None:
        dialog = show(recovery_dialog)
        files = [one.file for one in dialog._left]
        chosen: list = []
        dialog.recovered_chosen.connect(lambda *_: chosen.append(1))
        press(dialog, ESCAPE)
        assert not dialog.isVisible() and not chosen and len(files) == 2 and all(file.exists() for file in files)

    @pytest.mark.parametrize(("key", "left"), [(ESCAPE, 2), (ENTER, 2), (Qt.Key.Key_Left, 1)])
    def test_discarding_asks_and_only_yes_discards(self, show, key: Qt.Key, left: int) -> None:
        dialog = show(recovery_dialog)
        dialog.discard.setFocus()

        def answer() -> None:
            box = QApplication.activeModalWidget()
            assert isinstance(box, QMessageBox)
            if key == Qt.Key.Key_Left:
                box.button(QMessageBox.StandardButton.Discard).setFocus()
            press(box, ENTER if key == Qt.Key.Key_Left else key)

        QTimer.singleShot(50, answer)
        press(dialog, Qt.Key.Key_Space)
        assert dialog.list.topLevelItemCount() == left and dialog.isVisible()

    def test_letters_open_and_discard(self, show) -> None:
        dialog = show(recovery_dialog)
        letters = [mark(one.text()) for one in (dialog.recover, dialog.saved, dialog.discard, dialog.later)]
        assert len(set(letters)) == 4 and all(letters)


class TestBackups:
    def test_enter_goes_back_to_the_chosen_save_and_escape_changes_nothing(self, show) -> None:
        for key, expected in ((ENTER, [41]), (ESCAPE, [])):
            dialog = show(backups_dialog)
            chosen: list = []
            dialog.chosen.connect(lambda version, _, found=chosen: found.append(version.draft[TEETH]))
            dialog.list.setFocus()
            press(dialog, Qt.Key.Key_Down)
            press(dialog, key)
            assert chosen == expected and not dialog.isVisible()

    def test_enter_on_close_closes(self, show) -> None:
        dialog = show(backups_dialog)
        chosen: list = []
        dialog.chosen.connect(lambda *_: chosen.append(1))
        dialog.restore.setEnabled(False)
        press(dialog, ENTER)
        assert not chosen and dialog.isVisible(), "what cannot be gone back to is not"


class TestPicturesAndFilms:
    @pytest.mark.parametrize("make", [picture_dialog, film_dialog])
    def test_enter_saves_and_escape_closes(self, show, asked: list[str], make) -> None:
        dialog = show(make)
        press(dialog, ENTER)
        assert len(asked) == 1 and dialog.isVisible(), "no name, nothing done"
        press(dialog, ESCAPE)
        assert not dialog.isVisible() and len(asked) == 1

    def test_escape_gives_a_film_up_and_leaves_no_file(self, show, tmp_path: Path, monkeypatch) -> None:
        dialog = show(film_dialog)
        given_up: list[int] = []

        class Begun:
            def give_up(self) -> None:
                given_up.append(1)

        dialog._film = Begun()
        press(dialog, ESCAPE)
        assert given_up and not dialog.isVisible() and not list(tmp_path.iterdir())


def menus_of(bench: Bench) -> dict[str, QMenu]:
    window = bench.window
    return {
        "field": next(iter(window.form.rows.values())).make_menu(),
        "group": window.form.findChild(Section).make_menu(),
        "table": copy_menu(window.table.view),
        "derived": copy_menu(window.derived.view),
        "chart": chart_menu(window, lambda: None, lambda _what: None, lambda: None),
        "scale": ColorBar(window).make_menu(),
    }


@pytest.mark.parametrize("language", ["en", "de", "zh"])
def test_letters_of_menus_that_click_out_are_their_own(qapp: QApplication, qtbot, language: str) -> None:
    spoken = Language(qapp, language)
    bench = Bench()
    try:
        for name, menu in menus_of(bench).items():
            letters = Counter(filter(None, (mark(action.text()) for action in menu.actions())))
            assert max(letters.values(), default=1) == 1, (name, letters)
            assert all(action.text() or action.isSeparator() for action in menu.actions())
    finally:
        bench.close()
        spoken.speak("en")


def test_menus_are_walked_by_arrows_carried_out_by_enter_and_left_by_escape(bench: Bench, qtbot) -> None:
    for name, menu in menus_of(bench).items():
        done: list[QAction] = []
        menu.triggered.connect(done.append)
        possible = [action for action in menu.actions() if action.isEnabled() and not action.isSeparator()]
        menu.popup(bench.window.mapToGlobal(QPoint(20, 20)))
        qtbot.waitExposed(menu)
        met = []
        for _ in possible:
            QTest.keyClick(menu, Qt.Key.Key_Down)
            met.append(menu.activeAction())
        assert met == possible, name
        QTest.keyClick(menu, ESCAPE)
        assert not menu.isVisible() and not done, name


@pytest.mark.parametrize("where", ["field", "group", "table", "derived", "scale"])
def test_the_menu_key_opens_the_menu_where_the_keyboard_is(bench: Bench, qtbot, where: str) -> None:
    window = bench.window
    scale = ColorBar(window)
    scale.resize(80, 300)
    scale.show()
    places: dict[str, QWidget] = {
        "field": next(iter(window.form.rows.values())).field,
        "group": window.form.findChild(Section).findChild(QToolButton),
        "table": window.table.view,
        "derived": window.derived.view,
        "scale": scale.findChild(QWidget, "automatic"),
    }
    focused = places[where]
    assert focused.focusPolicy() & Qt.FocusPolicy.TabFocus, "the keyboard comes there"
    event = QContextMenuEvent(QContextMenuEvent.Reason.Keyboard, QPoint(5, 5), focused.mapToGlobal(QPoint(5, 5)))
    QTimer.singleShot(0, lambda: QApplication.sendEvent(focused, event))
    qtbot.waitUntil(lambda: isinstance(QApplication.activePopupWidget(), QMenu), timeout=3000)
    popup = QApplication.activePopupWidget()
    assert any(action.isEnabled() for action in popup.actions())
    popup.close()


def test_the_range_of_colours_can_be_typed_without_a_mouse(bench: Bench, qtbot) -> None:
    scale = ColorBar(bench.window)
    scale.resize(80, 300)
    scale.show()
    typing = next(action for action in scale.make_menu().actions() if "ype" in action.text())
    typing.trigger()
    assert scale._editor.isVisible() and scale._editor.focusWidget() is scale._editor._fields[0]
    QTest.keyClick(scale._editor, ESCAPE)
    assert not scale._editor.isVisible()
