"""How the ticked formats are written: a row for each option that one of them has."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QFormLayout,
    QFrame,
    QLabel,
    QLineEdit,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from gearstudio.formats import OPTIONS, ExportOptions, OptionSpec, options_of
from ui.fields import set_severity
from ui.formatting import number_text, parse_number
from ui.words import tr

Editor = QComboBox | QCheckBox | QLineEdit


class OptionsPanel(QWidget):
    """Shows the options of some formats; the help of the one in use stands below.

    Signals
    -------
    changed()
    """

    changed = Signal()

    def __init__(self, usual_chord: float | None, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._formats: tuple[str, ...] = ()
        self._editors: dict[str, Editor] = {}
        self._page = QWidget()
        self._form = QFormLayout(self._page)
        self._form.setContentsMargins(2, 2, 10, 2)
        self._form.setSpacing(7)
        self._form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.FieldsStayAtSizeHint)
        for spec in OPTIONS.values():
            self._add(spec)
        if usual_chord is not None:
            self._line("chord").setPlaceholderText(number_text(float(f"{usual_chord:.3g}")))
        self._line("angle_deg").setPlaceholderText(tr("none"))
        self._help = QLabel()
        self._help.setProperty("role", "muted")
        self._help.setWordWrap(True)
        self._help.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._help.setMinimumHeight(3 * self._help.fontMetrics().lineSpacing())
        scroll = QScrollArea()
        scroll.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        scroll.setWidgetResizable(True)
        scroll.setFrameShape(QFrame.Shape.NoFrame)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setWidget(self._page)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(8)
        layout.addWidget(scroll, 1)
        layout.addWidget(self._help)

    def editor(self, name: str) -> Editor:
        """What an option is chosen with."""
        return self._editors[name]

    def show_formats(self, formats: Iterable[str]) -> None:
        """Show the options of these formats."""
        self._formats = tuple(formats)
        shown = options_of(self._formats)
        for name, editor in self._editors.items():
            self._form.setRowVisible(editor, OPTIONS[name] in shown)
        self._say("" if shown else tr("Tick a format to see how it can be written."))

    def options(self) -> ExportOptions:
        """What is chosen for the formats in sight, the others as usual; ValueError while `problem` is not empty."""
        values = {spec.name: self._value(spec) for spec in options_of(self._formats)}
        return ExportOptions(**{name: value for name, value in values.items() if OPTIONS[name].allows(value)})

    def problem(self) -> str:
        """What is wrong with a number, for the user; each wrong one is marked."""
        problems = []
        for spec in OPTIONS.values():
            if spec.kind == "number":
                good = spec not in options_of(self._formats) or spec.allows(self._value(spec))
                set_severity(self._line(spec.name), "" if good else "error")
                if not good:
                    low, high = (number_text(limit) for limit in spec.limits)
                    words = tr("{title}: a number from {low} to {high} {unit}, or nothing",
                               title=tr(spec.title), low=low, high=high, unit=spec.unit)  # fmt: skip
                    problems.append(words)
        return "\n".join(problems)

    def choices(self) -> dict[str, str]:
        """Every choice as text, to be remembered."""
        return {name: self._text(name) for name in self._editors}

    def set_choices(self, texts: Mapping[str, str]) -> None:
        """The inverse of `choices`; what is not among the choices leaves the option as usual."""
        for name, text in texts.items():
            editor = self._editors.get(name)
            if isinstance(editor, QComboBox) and editor.findData(text) >= 0:
                editor.setCurrentIndex(editor.findData(text))
            elif isinstance(editor, QCheckBox) and text in ("yes", "no"):
                editor.setChecked(text == "yes")
            elif isinstance(editor, QLineEdit):
                value = parse_number(text)
                editor.setText(text if isinstance(value, str) else number_text(value))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Show the help of what is pointed at or has the focus."""
        if event.type() in (QEvent.Type.Enter, QEvent.Type.FocusIn):
            name = watched.objectName()
            if name in OPTIONS:
                self._say(tr(OPTIONS[name].help))
        return super().eventFilter(watched, event)

    # ---- parts -----------------------------------------------------------------------------------------

    def _add(self, spec: OptionSpec) -> None:
        editor = _MAKERS[spec.kind](spec, self.changed.emit)
        editor.setObjectName(spec.name)
        editor.setAccessibleName(tr(spec.title))
        editor.setToolTip(tr(spec.help))
        editor.installEventFilter(self)
        title = "" if spec.kind == "switch" else f"{tr(spec.title)} [{spec.unit}]" if spec.unit else tr(spec.title)
        self._editors[spec.name] = editor
        self._form.addRow(title, editor)

    def _line(self, name: str) -> QLineEdit:
        editor = self._editors[name]
        assert isinstance(editor, QLineEdit)
        return editor

    def _text(self, name: str) -> str:
        editor = self._editors[name]
        if isinstance(editor, QComboBox):
            return str(editor.currentData())
        if isinstance(editor, QCheckBox):
            return "yes" if editor.isChecked() else "no"
        return editor.text().strip()

    def _value(self, spec: OptionSpec) -> Any:
        text = self._text(spec.name)
        if spec.kind == "switch":
            return text == "yes"
        return text if spec.kind == "choice" else parse_number(text) if text else None

    def _say(self, text: str) -> None:
        self._help.setText(text)


def _combo(spec: OptionSpec, changed: Callable[[], None]) -> Editor:
    combo = QComboBox()
    for value, title in spec.choices:
        combo.addItem(tr(title), value)
    combo.setCurrentIndex(combo.findData(spec.default))
    combo.currentIndexChanged.connect(lambda _index: changed())
    return combo


def _switch(spec: OptionSpec, changed: Callable[[], None]) -> Editor:
    box = QCheckBox(tr(spec.title))
    box.setChecked(bool(spec.default))
    box.toggled.connect(lambda _on: changed())
    return box


def _number(spec: OptionSpec, changed: Callable[[], None]) -> Editor:
    line = QLineEdit()
    line.setMaximumWidth(110)
    line.textChanged.connect(lambda _text: changed())
    return line


_MAKERS: dict[str, Callable[[OptionSpec, Callable[[], None]], Editor]] = {
    "choice": _combo,
    "switch": _switch,
    "number": _number,
}
