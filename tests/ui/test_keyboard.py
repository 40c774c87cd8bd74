"""Everything can be reached and told by the keyboard alone: order of Tab, names, marks of keys, visible focus."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from itertools import groupby

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QAccessible, QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QDialog,
    QGroupBox,
    QLabel,
    QMenu,
    QMenuBar,
    QPushButton,
    QWidget,
)

from gearstudio.design import Design, with_field
from gearstudio.presets import PRESETS
from gearstudio.project import save_design
from tests.ui.dialogs import backups_dialog, film_dialog, picture_dialog, recovery_dialog
from tests.ui.stand_ins import Bench
from ui.export_dialog import ExportDialog
from ui.habits import Habits
from ui.help.equations import EquationBrowser
from ui.help.guide import GuideWindow
from ui.keyboard import stops
from ui.language import Language
from ui.messages import ReportDialog
from ui.palette import Palette
from ui.preferences_dialog import PreferencesDialog
from ui.projects.compare_dialog import CompareDialog
from ui.reporting.dialog import ReportDialog as ReportMaker
from ui.theme import Theme

pytestmark = pytest.mark.ui
STAYS = 60
"""So many presses of Tab may stay in a text, at its links."""
Make = Callable[[Bench, Habits], QDialog]
DIALOGS: dict[str, Make] = {
    "preferences": lambda bench, habits: PreferencesDialog(habits.preferences, habits.keys, bench.window),
    "palette": lambda bench, habits: Palette(habits.offers(), None, bench.window),
    "about": lambda bench, _: ReportDialog("Title", "Words", "Report", bench.window),
    "export": lambda bench, _: ExportDialog(bench.session, "/tmp", bench.window, None, "gear"),
    "report": lambda bench, _: ReportMaker("name", "wheel", "/tmp", bench.window),
    "guide": lambda bench, _: GuideWindow(bench.window),
    "equations": lambda bench, _: EquationBrowser(bench.session, bench.window),
    "compare": lambda bench, _: CompareDialog(bench.session, (), "/tmp", bench.window),
    "recovery": lambda bench, _: recovery_dialog(bench),
    "backups": lambda bench, _: backups_dialog(bench),
    "picture": lambda bench, _: picture_dialog(bench),
    "film": lambda bench, _: film_dialog(bench),
}


@pytest.fixture
def bench(qtbot) -> Iterator[Bench]:
    made = Bench()
    made.habits = Habits(made.controller)  # type: ignore[attr-defined]
    menus = made.window.commands.presets, made.window.commands.resets
    for menu in menus:
        for preset in PRESETS:
            menu.addAction(preset.title).setObjectName(f"{id(menu)}.{preset.key}")
    made.window.resize(1400, 900)
    made.window.show()
    made.controller.charts_ready()
    qtbot.waitExposed(made.window)
    yield made
    made.close()


@pytest.fixture(params=list(DIALOGS))
def dialog(request, bench: Bench, qtbot) -> Iterator[QDialog]:
    made = DIALOGS[request.param](bench, bench.habits)  # type: ignore[attr-defined]
    made.show()
    qtbot.waitExposed(made)
    yield made
    made.close()
    made.deleteLater()


def reachable(top: QWidget) -> set[QWidget]:
    """What Tab should come by."""
    return {
        one
        for one in top.findChildren(QWidget)
        if one.window() is top
        and one.isVisible()
        and one.isEnabled()
        and one.focusPolicy() & Qt.FocusPolicy.TabFocus
        and one.focusProxy() is None
    }


def walk(top: QWidget, key: Qt.Key = Qt.Key.Key_Tab) -> list[QWidget]:
    """The way from where the keyboard is once around."""
    top.activateWindow()
    if top.focusWidget() is None:
        top.setFocus()
    way: list[QWidget] = []
    stayed = 0
    while stayed < STAYS:
        QTest.keyClick(top.focusWidget() or top, key)
        found = top.focusWidget()
        if way and found is way[-1]:
            stayed += 1
            continue
        if found in way:
            break
        way.append(found)
    return way


def place(widget: QWidget, top: QWidget) -> tuple[int, int]:
    at = widget.mapTo(top, QPoint())
    return at.x(), at.y()


@pytest.mark.parametrize("tab", ["comparison", "charts", "contact", "datasheet", "measurement"])
def test_tab_goes_through_the_window_as_one_reads_it(bench: Bench, qtbot, tab: str) -> None:
    window = bench.window
    window.analysis.show_tab(tab)
    qtbot.wait(100)
    window.form.search.setFocus()
    way = walk(window)
    assert set(way) == reachable(window) and len(way) == len(set(way)) > 50
    start = way.index(next(one for one in way if window.method_bar.isAncestorOf(one)))
    way = way[start:] + way[:start]
    parts = [window.method_bar, window.form, window.derived, window.area, window.analysis.bar, window.analysis]
    numbers = [next((n for n, part in enumerate(parts) if part is one or part.isAncestorOf(one)), 6) for one in way]
    assert numbers == sorted(numbers), "one panel after the other"
    fields = [place(one, window)[1] for one in way if window.form.isAncestorOf(one)][1:]
    assert fields == sorted(fields), "fields from above"
    back = walk(window, Qt.Key.Key_Backtab)
    assert set(back) == set(way)


def test_tab_comes_by_everything_in_a_dialog_once(dialog: QDialog) -> None:
    pages = dialog.tabs.count() if isinstance(dialog, PreferencesDialog) else 1
    for page in range(pages):
        if isinstance(dialog, PreferencesDialog):
            dialog.tabs.setCurrentIndex(page)
        way = walk(dialog)
        assert set(way) == reachable(dialog) and len(way) == len(set(way))


def test_tab_goes_through_a_dialog_as_one_reads_it(dialog: QDialog, qtbot) -> None:
    if isinstance(dialog, ExportDialog | ReportMaker):
        return  # two columns, the left one first
    qtbot.wait(50)
    way = walk(dialog)
    read = [one for one in stops(dialog) if one in way]
    start = way.index(read[0])
    assert way[start:] + way[:start] == read


def test_tab_goes_through_the_chapters_first_and_the_pages_next(bench: Bench, qtbot) -> None:
    dialog = ReportMaker("name", "wheel", "/tmp", bench.window)
    qtbot.addWidget(dialog)
    dialog.show()
    qtbot.waitExposed(dialog)
    way = walk(dialog)
    start = way.index(next(iter(dialog._boxes.values())))
    kinds = [kind for kind, _ in groupby(type(one).__name__ for one in way[start:] + way[:start])]
    assert kinds == ["QCheckBox", "QComboBox", "QPushButton", "PagesView", "QPushButton"]


def test_a_dialog_opens_on_its_main_button_and_closes_on_escape(dialog: QDialog, qtbot) -> None:
    buttons = [one for one in dialog.findChildren(QPushButton) if one.isVisible()]
    if buttons and not isinstance(dialog, GuideWindow):
        assert [one for one in buttons if one.isDefault()], [one.text() for one in buttons]
    QTest.keyClick(dialog.focusWidget() or dialog, Qt.Key.Key_Escape)
    qtbot.waitUntil(lambda: not dialog.isVisible(), timeout=2000)


def test_everything_that_takes_keys_has_a_name(bench: Bench, dialog: QDialog) -> None:
    for tab in ("charts", "contact", "datasheet", "measurement"):
        bench.window.analysis.show_tab(tab)
    nameless = [
        f"{type(one).__name__} in {type(one.parentWidget()).__name__}: {one.toolTip()}"
        for top in (bench.window, dialog)
        for one in top.findChildren(QWidget)
        if one.focusPolicy() & Qt.FocusPolicy.TabFocus and one.focusProxy() is None and not _part_of_another(one)
        if not _name(one)
    ]
    assert not nameless, "\n".join(sorted(set(nameless)))


@pytest.mark.parametrize("language", ["en", "de", "zh"])
def test_marks_of_keys_are_unique_in_every_menu_and_dialog(qapp: QApplication, qtbot, language: str) -> None:
    spoken = Language(qapp, language)
    made = Bench()
    habits = Habits(made.controller)
    try:
        wrong = dict(_clashes("menu bar", made.window.menuBar().actions()))
        for menu in made.window.menuBar().findChildren(QMenu) + made.window.findChildren(QMenu):
            wrong |= dict(_clashes(menu.title(), menu.actions()))
        for name, make in DIALOGS.items():
            dialog = make(made, habits)
            texts = [one.text() for one in dialog.findChildren(QAbstractButton)]
            texts += [one.text() for one in dialog.findChildren(QLabel) if one.buddy() is not None]
            letters = Counter(filter(None, map(_mark, texts)))
            wrong |= {f"{name}: {letter}": count for letter, count in letters.items() if count > 1}
            dialog.close()
            dialog.deleteLater()
        assert not wrong, wrong
    finally:
        made.close()
        spoken.speak("en")


@pytest.mark.parametrize("scheme", [Qt.ColorScheme.Light, Qt.ColorScheme.Dark])
def test_one_sees_where_the_keyboard_is(bench: Bench, theme: Theme, qtbot, scheme: Qt.ColorScheme, tmp_path) -> None:
    theme.choose(scheme)
    window, unseen = bench.window, []
    try:
        save_design(tmp_path / "other.gear.toml", with_field(Design(), "pair.pinion_teeth", 19))
        window.analysis.show_tab("contact")
        window.activateWindow()
        qtbot.waitUntil(window.isActiveWindow, timeout=5000)
        kinds = {(type(one), one.property("role"), type(one.parentWidget())): one for one in walk(window)}
        assert len(kinds) > 10
        for one in kinds.values():
            window.form.search.setFocus() if one is not window.form.search else window.derived.view.setFocus()
            QTest.qWait(1)
            before = one.grab().toImage()
            one.setFocus(Qt.FocusReason.TabFocusReason)
            QTest.qWait(1)
            if one.grab().toImage() == before:
                unseen.append(f"{type(one).__name__} {one.accessibleName() or getattr(one, 'text', str)()}")
    finally:
        theme.choose(Qt.ColorScheme.Unknown)
    assert not unseen, "\n".join(unseen)


def _clashes(place: str, actions: list[QAction]) -> Iterator[tuple[str, list[str]]]:
    marked = [(_mark(action.text()), action.text()) for action in actions if action.isVisible()]
    for letter, count in Counter(letter for letter, _ in marked if letter).items():
        if count > 1:
            yield f"{place}: {letter}", [text for mark, text in marked if mark == letter]


def _mark(text: str) -> str:
    at = text.replace("&&", "  ").find("&")
    return text[at + 1].lower() if 0 <= at < len(text) - 1 else ""


def _name(widget: QWidget) -> str:
    said = QAccessible.queryAccessibleInterface(widget).text(QAccessible.Text.Name)
    if said or isinstance(widget, QLabel):
        return said or "its text"
    return widget.title() if isinstance(widget, QGroupBox) else ""


def _part_of_another(widget: QWidget) -> bool:
    name = widget.metaObject().className()
    return name in ("QComboBoxListView", "QHeaderView", "QMenu") or isinstance(widget, QMenu | QMenuBar)
