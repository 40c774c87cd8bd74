"""All that takes keys has a name and a tooltip, nothing is cut off, and the wheel changes no value."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QAccessible, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSlider,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QDialog,
    QDoubleSpinBox,
    QScrollBar,
    QSlider,
    QWidget,
)

from tests.ui.reading import takes_keys, tip_of, where_is
from tests.ui.stand_ins import Bench
from ui.habits import Habits
from ui.messages import ReportDialog
from ui.palette import Palette
from ui.preferences_dialog import PreferencesDialog

pytestmark = pytest.mark.ui


@pytest.fixture
def bench(bench_with_habits: Bench) -> Bench:
    return bench_with_habits


def test_the_wheel_leaves_every_value_alone(bench: Bench, qtbot) -> None:
    extra = [QDoubleSpinBox(maximum=9, value=5), QSlider(Qt.Orientation.Horizontal, value=50), QComboBox()]
    extra[2].addItems(["a", "b", "c"])
    for widget in extra:
        qtbot.addWidget(widget)
        widget.show()
    kinds = (QAbstractSpinBox, QAbstractSlider, QComboBox)
    found = [w for w in bench.window.findChildren(QWidget) if isinstance(w, kinds) and not isinstance(w, QScrollBar)]
    for widget in [*found, *extra]:
        before = _reading(widget)
        for step in (-120, 120):
            event = QWheelEvent(
                QPointF(5, 5), widget.mapToGlobal(QPointF(5, 5)), QPoint(0, 0), QPoint(0, step),
                Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase, False,
            )  # fmt: skip
            QApplication.sendEvent(widget, event)
            assert _reading(widget) == before, widget


def test_window_and_dialogs_have_names_and_tooltips_for_all_that_takes_keys(bench: Bench, qtbot) -> None:
    habits: Habits = bench.habits  # type: ignore[attr-defined]
    dialogs: list[QDialog] = [
        PreferencesDialog(habits.preferences, habits.keys, bench.window),
        Palette(habits.offers(), None, bench.window),
        ReportDialog("Title", "Words", "Report", bench.window),
    ]
    nameless, silent = [], []
    for top in [bench.window, *dialogs]:
        for widget in top.findChildren(QWidget):
            if not takes_keys(widget):
                continue
            if not QAccessible.queryAccessibleInterface(widget).text(QAccessible.Text.Name):
                nameless.append(where_is(widget))
            if not tip_of(widget):
                silent.append(where_is(widget))
    assert not nameless, "\n".join(nameless)
    assert not silent, "\n".join(silent)


def test_nothing_is_cut_off_in_the_preferences(bench: Bench) -> None:
    habits: Habits = bench.habits  # type: ignore[attr-defined]
    dialog = PreferencesDialog(habits.preferences, habits.keys, bench.window)
    dialog.show()
    for page in range(dialog.tabs.count()):
        dialog.tabs.setCurrentIndex(page)
        QTest.qWait(20)
        for button in dialog.findChildren(QAbstractButton):
            if button.isVisible() and button.text():
                assert button.fontMetrics().horizontalAdvance(button.text()) <= button.width(), button.text()
        for combo in dialog.findChildren(QComboBox):
            needed = max(combo.fontMetrics().horizontalAdvance(combo.itemText(i)) for i in range(combo.count()))
            assert not combo.isVisible() or needed + 30 <= combo.width()
    assert dialog.width() <= 1280 and dialog.height() <= 720


def _reading(widget: QWidget) -> object:
    return widget.currentIndex() if isinstance(widget, QComboBox) else widget.value()  # type: ignore[attr-defined]
