"""Where the window is too narrow for it, the panel beside the views stands behind another one, with a tab for each."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, QTimer, Signal
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QFrame, QStackedLayout, QVBoxLayout, QWidget

from ui.method_bar import Segments
from ui.words import noted

if TYPE_CHECKING:
    from ui.view_area import ViewArea

LEAST_VIEW = 480
"""The views are to be as wide as this, in pixels."""
_REST_MS = 120
_HOST, _GUEST = "host", "guest"
_TIP = noted("These panels share a place while the window is narrow")


class SharedPlace(QWidget):
    """A panel that can take in another one.

    Signals
    -------
    came_or_went()
        It is in sight now, or no more.
    """

    came_or_went = Signal()

    def __init__(self, title: str, host: QWidget, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.tabs = Segments(((_HOST, title, _TIP), (_GUEST, noted("Display"), _TIP)), "Panels that share a place")
        self.tabs.chosen.connect(self._show)
        self._card = QFrame()
        self._card.setProperty("role", "card")
        self._inside = QVBoxLayout(self._card)
        self._inside.setContentsMargins(1, 1, 1, 1)
        framed = QWidget()
        frame = QVBoxLayout(framed)
        frame.setContentsMargins(2, 0, 8, 4)
        frame.addWidget(self._card)
        self._stack = QStackedLayout()
        self._stack.addWidget(host)
        self._stack.addWidget(framed)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.tabs, 0, Qt.AlignmentFlag.AlignHCenter)
        layout.addLayout(self._stack, 1)
        self.tabs.hide()

    def take(self, guest: QWidget, in_front: bool) -> None:
        """Take a panel in, in front of the other or behind it."""
        self._inside.addWidget(guest)
        guest.show()
        self.tabs.show()
        self._show(_GUEST if in_front else _HOST)

    def release(self) -> None:
        """Show the one panel alone; the other is about to go."""
        self.tabs.hide()
        self._show(_HOST)

    def keep_state(self) -> bool:
        """Whether the guest is in front."""
        return self._stack.currentIndex() == 1

    def take_state(self, in_front: bool) -> None:
        """Show what was in front."""
        if not self.tabs.isHidden():
            self._show(_GUEST if in_front else _HOST)

    def _show(self, which: str) -> None:
        self.tabs.set_choice(which)
        self._stack.setCurrentIndex(int(which == _GUEST))

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.came_or_went.emit()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self.came_or_went.emit()


class Sharing(QObject):
    """Leaves every panel where the user has it; of the panel beside the views alone it decides where it stands.

    It stands beside them as long as they keep `LEAST_VIEW`; else it is the guest of a `SharedPlace` that is open.
    """

    def __init__(self, area: ViewArea, parent: QObject) -> None:
        super().__init__(parent)
        self._area = area
        self._places: list[SharedPlace] = []
        self._panel: QWidget | None = None
        self._place: SharedPlace | None = None
        self._open = False
        self._rest = QTimer(self, singleShot=True, interval=_REST_MS)
        self._rest.timeout.connect(self.settle)
        area.resized.connect(self._rest.start)

    @property
    def place(self) -> SharedPlace | None:
        """Where the panel is a guest; None beside the views."""
        return self._place

    @property
    def places(self) -> tuple[SharedPlace, ...]:
        """All that there are."""
        return tuple(self._places)

    def shared(self, title: str, host: QWidget) -> SharedPlace:
        """A place for a panel that can take in the one beside the views."""
        made = SharedPlace(title, host)
        made.came_or_went.connect(self._rest.start)
        self._places.append(made)
        return made

    def adopt(self, panel: QWidget) -> None:
        """Look after a panel; it is closed at first."""
        self._panel = panel
        panel.hide()
        self._area.add_panel(panel)

    def set_open(self, on: bool) -> None:
        """Open the panel in front of what it shares a place with, or close it."""
        if self._panel is None or on == self._open:
            return
        self._open = on
        if on:
            self._panel.show()
            self.settle(in_front=True)
        else:
            self._move(None)
            self._panel.hide()

    def settle(self, in_front: bool = False) -> None:
        """Put the panel where there is room for it now; nothing moves while the views are out of sight."""
        if not self._open or not self._area.isVisible():
            return
        place = None if self._room() >= LEAST_VIEW else self._open_place()
        if place is not self._place:
            self._move(place, in_front)

    def _room(self) -> int:
        """Width that the panel would leave to the views."""
        assert self._panel is not None
        bar = self._area.color_bar
        beside = bar.width() if bar is not None and bar.isVisible() else 0
        return self._area.width() - self._panel.sizeHint().width() - beside

    def _open_place(self) -> SharedPlace | None:
        window = self._area.window()
        return next((place for place in self._places if place.isVisible() and place.window() is window), None)

    def _move(self, place: SharedPlace | None, in_front: bool = False) -> None:
        assert self._panel is not None
        focus = self._area.window().focusWidget()
        if self._place is not None:
            self._place.release()
        self._place = place
        if place is None:
            self._area.add_panel(self._panel)
            self._panel.show()
        else:
            place.take(self._panel, in_front)
        if focus is not None and self._panel.isAncestorOf(focus):
            focus.setFocus()
