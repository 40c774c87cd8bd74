"""Every command that opens something: it opens, all of it has a name and a tip, nothing is cut, Escape closes it."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtCore import QSettings, Qt, QTimer
from PySide6.QtGui import QAccessible
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QDialog,
    QDialogButtonBox,
    QLabel,
    QMessageBox,
    QToolButton,
    QWidget,
)

from gearstudio.design import Design
from gearstudio.project import save_design
from tests.ui.reading import takes_keys, tip_of, where_is
from tests.ui.screen import NEEDS_SCREEN
from tests.ui.whole import PATIENCE_MS, complete
from ui.actions import COMMANDS
from ui.app import Studio
from ui.charts.frame import _Hint as Hint

pytestmark = NEEDS_SCREEN
DIALOGS = (
    "export", "report", "screenshot", "film", "backups", "compare_design", "preferences", "palette", "keys",
    "guide", "glossary", "equations", "about", "reset_settings",
)  # fmt: skip
DOTS = {"open", "save_as", "recover"}
"""The system's own dialogs of files, and one that needs a program that died; tested with files and recovery."""


@pytest.fixture
def studio(open_studio, qtbot, settings: QSettings, tmp_path: Path) -> Studio:
    folder = tmp_path
    settings.setValue("help/tour_seen", True)
    made = open_studio(data=folder / "data")
    made.window.resize(1280, 720)
    for _ in range(PATIENCE_MS // 50):
        if complete(made):
            break
        QTest.qWait(50)
    save_design(folder / "a.gear.toml", Design())
    made.files.open_path(folder / "a.gear.toml")
    qtbot.waitUntil(lambda: made.session.path is not None, timeout=PATIENCE_MS)
    assert made.files.save()
    QTest.qWait(500)
    return made


def shown() -> list[QWidget]:
    return [w for w in QApplication.topLevelWidgets() if isinstance(w, QDialog) and w.isVisible()]


def cut(top: QWidget) -> list[str]:
    """Words that have less room than they need, and widgets that reach out of the dialog."""
    found = []
    for widget in top.findChildren(QWidget):
        plain = isinstance(widget, QAbstractButton | QLabel) and not isinstance(widget, QToolButton | Hint)
        if not widget.isVisible() or not plain:
            continue
        text = widget.text().replace("&", "")
        rich = isinstance(widget, QLabel) and (widget.wordWrap() or not widget.pixmap().isNull() or "<" in text)
        if (
            text
            and not rich
            and widget.fontMetrics().horizontalAdvance(max(text.split("\n"), key=len)) > widget.width()
        ):
            found.append(f"{where_is(widget)}: {text}")
        if (
            isinstance(widget, QLabel)
            and widget.wordWrap()
            and widget.heightForWidth(widget.width()) > widget.height() + 1
        ):
            found.append(f"{where_is(widget)}: lines of {text[:60]}")
    return found


def unnamed(top: QWidget) -> list[str]:
    """Widgets that take keys without a name or a tip; the system's buttons of message boxes speak for themselves."""
    found = []
    for widget in top.findChildren(QWidget):
        standard = isinstance(widget.parentWidget(), QDialogButtonBox) and isinstance(top, QMessageBox)
        if not takes_keys(widget) or standard:
            continue
        if not QAccessible.queryAccessibleInterface(widget).text(QAccessible.Text.Name):
            found.append(f"no name: {where_is(widget)}")
        if not tip_of(widget):
            found.append(f"no tip: {where_is(widget)}")
    return found


def test_every_command_with_dots_is_looked_at() -> None:
    assert {command.name for command in COMMANDS if command.text.endswith("…")} <= {*DIALOGS, *DOTS}


def test_dialogs_are_whole_and_escape_closes_them(studio: Studio) -> None:
    wrong = [line for name in DIALOGS for line in faults(studio, name)]
    assert not wrong, "\n".join(wrong)


def faults(studio: Studio, name: str) -> list[str]:
    seen: list[tuple[list[str], list[str], bool]] = []

    def look() -> None:
        for dialog in shown():
            QTest.qWait(150)
            screen = dialog.screen().availableGeometry() if dialog.screen() else dialog.geometry()
            fits = dialog.height() <= 720 and dialog.width() <= 1280 and screen.isValid()
            seen.append((unnamed(dialog), cut(dialog), fits))
            QTest.keyClick(dialog, Qt.Key.Key_Escape)

    QTimer.singleShot(250, look)
    studio.window.commands[name].trigger()
    for _ in range(100):
        if seen and not shown():
            break
        QTest.qWait(50)
    found = [f"{name}: {line}" for names, cuts, _ in seen for line in (*names, *cuts)]
    if not seen or shown():
        found.append(f"{name}: nothing opened" if not seen else f"{name}: Escape does not close it")
    return [*found, *(f"{name}: larger than 1280 x 720" for *_, fits in seen if not fits)]


def test_no_page_is_cut_at_the_least_size(studio: Studio) -> None:
    window, wrong = studio.window, []
    for tab in ("comparison", "charts", "contact", "datasheet", "measurement"):
        window.analysis.show_tab(tab)
        QTest.qWait(1000)
        wrong += [f"{tab}: {line}" for line in cut(window)]
    assert (window.width(), window.height()) == (1280, 720)
    assert not wrong, "\n".join(wrong)
