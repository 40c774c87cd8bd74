"""What the views show: which method (or all three), which variant, which member."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QButtonGroup, QFrame, QHBoxLayout, QPushButton, QSizePolicy, QWidget

from gearstudio.catalogue import MEMBERS, METHOD_IDS, METHOD_INFOS, VARIANTS
from ui.formatting import MEMBER_TITLES, METHOD_TITLES, VARIANT_TITLES
from ui.session import ALL
from ui.words import tr

ALL_TIP = "The three methods side by side, seen from the same place"
MEMBER_TIPS = {"pinion": "Show the pinion and build its flanks", "wheel": "Show the wheel and build its flanks"}
VARIANT_TIPS = {
    "published": "The construction as printed: few positions, two profiles, 7 × 7 points",
    "optimised": "Refined until the expected deviation is below the tolerance",
}


class Segments(QFrame):
    """One choice of a few, as buttons in a row.

    Signals
    -------
    chosen(str)
        Identifier of the button that the user pressed.
    """

    chosen = Signal(str)

    def __init__(self, choices: Sequence[tuple[str, str, str]], name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "segments")
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(tr(name))
        self._group = QButtonGroup(self)
        self._group.setExclusive(True)
        self._buttons: dict[str, QPushButton] = {}
        self._row = QHBoxLayout(self)
        self._row.setContentsMargins(2, 2, 2, 2)
        self._row.setSpacing(1)
        for choice in choices:
            self.add(*choice)

    def add(self, identifier: str, title: str, tip: str) -> None:
        """Append a choice."""
        button = _BoldStableButton(tr(title))
        button.setToolTip(tr(tip))
        button.clicked.connect(lambda _checked: self.chosen.emit(identifier))
        self._group.addButton(button)
        self._buttons[identifier] = button
        self._row.addWidget(button)

    def set_choice(self, identifier: str) -> None:
        """Show a choice without announcing it."""
        self._buttons[identifier].setChecked(True)

    def clear_choice(self) -> None:
        """Show that none of them is chosen."""
        self._group.setExclusive(False)
        for button in self._buttons.values():
            button.setChecked(False)
        self._group.setExclusive(True)

    def button(self, identifier: str) -> QPushButton:
        """The button of a choice."""
        return self._buttons[identifier]


class _BoldStableButton(QPushButton):
    """A button as wide as its bold text, so that choosing it moves nothing."""

    def __init__(self, text: str) -> None:
        super().__init__(text)
        self.setCheckable(True)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.ensurePolished()
        font = self.font()
        font.setBold(True)
        self.setMinimumWidth(QFontMetrics(font).horizontalAdvance(text) + 20)


class MethodBar(QWidget):
    """Member, method and variant.

    Signals
    -------
    member_chosen(str), method_chosen(str), variant_chosen(str)
    """

    member_chosen = Signal(str)
    method_chosen = Signal(str)
    variant_chosen = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.methods = Segments(
            [(ALL, tr("All three"), ALL_TIP)]
            + [(method, METHOD_TITLES[method], _method_tip(method)) for method in METHOD_IDS],
            tr("Method"),
        )
        self.variants = Segments([(v, VARIANT_TITLES[v], VARIANT_TIPS[v]) for v in VARIANTS], tr("Variant"))
        self.members = Segments([(m, MEMBER_TITLES[m], MEMBER_TIPS[m]) for m in MEMBERS], tr("Member"))
        self.methods.chosen.connect(self.method_chosen)
        self.variants.chosen.connect(self.variant_chosen)
        self.members.chosen.connect(self.member_chosen)
        self._layout = QHBoxLayout(self)
        self._layout.setContentsMargins(4, 6, 8, 4)
        self._layout.setSpacing(7)
        for segments in (self.members, self.methods, self.variants):
            self._layout.addWidget(segments)
        self._layout.addStretch(1)

    def show_selection(self, member: str, method: str, variant: str) -> None:
        """Show a selection without announcing it."""
        self.members.set_choice(member)
        self.methods.set_choice(method)
        self.variants.set_choice(variant)


def _method_tip(method: str) -> str:
    info = next(info for info in METHOD_INFOS if info.id == method)
    return tr("{summary} ({section} of the paper)", summary=tr(info.summary), section=tr(info.paper_section))
