"""The flat buttons with an icon at the right end of a chart's or table's head."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QMenu, QToolButton

from ui.theme import set_icon

ICON_PX = 16


def tool_button(icon: str, tip: str, run: Callable[[], object] | None = None) -> QToolButton:
    """A button that does one thing."""
    button = QToolButton()
    button.setAutoRaise(True)
    button.setIconSize(QSize(ICON_PX, ICON_PX))
    set_icon(button, icon)
    button.setToolTip(tip)
    button.setAccessibleName(tip)
    if run is not None:
        button.clicked.connect(lambda _checked=False: run())
    return button


def menu_button(icon: str, tip: str, choices: Sequence[tuple[str, str]], run: Callable[[str], object]) -> QToolButton:
    """A button that opens a menu of (identifier, words); the identifier chosen is handed over."""
    button = tool_button(icon, tip)
    button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
    menu = QMenu(button)
    for identifier, words in choices:
        menu.addAction(words).triggered.connect(lambda _checked=False, chosen=identifier: run(chosen))
    button.setMenu(menu)
    return button
