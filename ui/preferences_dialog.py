"""The dialog of preferences: every choice takes effect at once, or says when it will."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QLabel,
    QSpinBox,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from ui.keyboard import tab_as_read
from ui.keys import Keys
from ui.keys_page import KeysPage
from ui.preferences import (
    GRAPHICS,
    LANGUAGES,
    LEAST_AUTOSAVE_S,
    LEAST_MEMORY_MB,
    MOST_AUTOSAVE_S,
    MOST_DECIMALS,
    MOST_MEMORY_MB,
    THEMES,
    Choices,
    Preferences,
)
from ui.words import tr

UNITS = (("mm", "Millimetres"), ("in", "Inches"))


class PreferencesDialog(QDialog):
    """Pages for display, work and keys; it follows the preferences, whoever changes them."""

    def __init__(self, preferences: Preferences, keys: Keys, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Preferences"))
        self.resize(740, 520)
        self._preferences = preferences
        self.editors: dict[str, QComboBox | QSpinBox] = {}
        self.tabs = QTabWidget()
        self.tabs.setDocumentMode(True)
        self.tabs.addTab(self._display_page(), tr("Display"))
        self.tabs.addTab(self._work_page(), tr("Work"))
        self.tabs.addTab(KeysPage(keys), tr("Keys"))
        self.tabs.setAccessibleName(tr("Pages of the preferences"))
        self.tabs.tabBar().setAccessibleName(tr("Pages of the preferences"))
        for number, tip in enumerate(
            (tr("Units, colours and language"), tr("Memory, graphics and recovery"), tr("Keys of all commands"))
        ):
            self.tabs.setTabToolTip(number, tip)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        restore = buttons.addButton(tr("Restore defaults"), QDialogButtonBox.ButtonRole.ResetRole)
        restore.setToolTip(tr("Display and work as for a new user; keys have a button of their own"))
        restore.clicked.connect(lambda: preferences.take(Choices()))
        close = buttons.button(QDialogButtonBox.StandardButton.Close)
        close.setToolTip(tr("Close; every choice is already in force"))
        close.setDefault(True)
        restore.setAutoDefault(False)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 12, 16, 12)
        layout.setSpacing(12)
        layout.addWidget(self.tabs, 1)
        layout.addWidget(buttons)
        tab_as_read(self, buttons)
        preferences.changed.connect(self._on_changed)
        self._show(preferences.choices)

    def _display_page(self) -> QWidget:
        page, form = _page()
        self._choice(form, "length", tr("Lengths in"), UNITS, tr("Shown and typed in this unit; files stay in mm"))
        _note(form, tr("A value with another unit can always be typed: 3in, {length}mm.", length=76.2))
        _note(form, tr("Deviations stay in µm and nm; the colour scale of the views has µin as well."))
        box = self._number(form, "decimals", tr("Decimals"), 0, MOST_DECIMALS, "")
        box.setSpecialValueText(tr("Automatic"))
        box.setToolTip(tr("Digits after the point of lengths in mm and angles; two more in inches"))
        self._choice(form, "theme", tr("Theme"), THEMES, tr("Colours of the window"))
        self._choice(form, "language", tr("Language"), LANGUAGES, tr("Words of the window"))
        _note(form, tr("The window changes its language at once; the design and its results stay as they are."))
        return page

    def _work_page(self) -> QWidget:
        page, form = _page()
        box = self._number(form, "memory_limit_mb", tr("Memory of the CAD kernel"), 0, MOST_MEMORY_MB, " MB")
        box.setSingleStep(LEAST_MEMORY_MB // 2)
        box.setSpecialValueText(tr("No limit"))
        box.setToolTip(tr("Above this the CAD process is replaced when it is at rest; 0 for no limit"))
        self._choice(form, "graphics", tr("3D views drawn by"), GRAPHICS, tr("What draws the 3D views"))
        _note(form, tr("Another way to draw takes effect at the next start."))
        seconds = self._number(
            form, "autosave_seconds", tr("Copy of unsaved work after"), LEAST_AUTOSAVE_S, MOST_AUTOSAVE_S, " s"
        )
        seconds.setToolTip(tr("After a crash, edits since the last copy are lost"))
        return page

    def _choice(self, form: QFormLayout, name: str, title: str, rows: tuple[tuple[str, str], ...], tip: str) -> None:
        combo = QComboBox()
        for value, text in rows:
            combo.addItem(tr(text), value)
        combo.activated.connect(lambda _index: self._preferences.set(**{name: combo.currentData()}))
        self._add(form, name, title, combo)
        combo.setToolTip(tip)

    def _number(self, form: QFormLayout, name: str, title: str, low: int, high: int, unit: str) -> QSpinBox:
        box = QSpinBox()
        box.setRange(low, high)
        box.setSuffix(unit)
        box.setKeyboardTracking(False)
        box.lineEdit().setTextMargins(6, 0, 0, 0)
        box.valueChanged.connect(lambda value: self._preferences.set(**{name: value}))
        self._add(form, name, title, box)
        return box

    def _add(self, form: QFormLayout, name: str, title: str, editor: QComboBox | QSpinBox) -> None:
        editor.setAccessibleName(title)
        editor.setMinimumWidth(250)
        form.addRow(title, editor)
        self.editors[name] = editor

    def _on_changed(self, _before: Choices, now: Choices) -> None:
        self._show(now)

    def _show(self, choices: Choices) -> None:
        for name, editor in self.editors.items():
            value: Any = getattr(choices, name)
            editor.blockSignals(True)
            if isinstance(editor, QComboBox):
                editor.setCurrentIndex(editor.findData(value))
            else:
                editor.setValue(value)
            editor.blockSignals(False)


def _page() -> tuple[QWidget, QFormLayout]:
    page = QWidget()
    form = QFormLayout(page)
    form.setContentsMargins(12, 18, 12, 12)
    form.setHorizontalSpacing(18)
    form.setVerticalSpacing(10)
    form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.FieldsStayAtSizeHint)
    form.setLabelAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
    return page, form


def _note(form: QFormLayout, text: str) -> None:
    label = QLabel(text)
    label.setProperty("role", "muted")
    label.setWordWrap(True)
    label.setMinimumWidth(400)
    form.addRow("", label)
