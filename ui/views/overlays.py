"""Everything in Qt type over the panes, and where it goes: titles, values, markers, axes and scale bars."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

from ui.layers import Panel
from ui.view_overlay import LEAST_TITLE, MARGIN, Axes, Divider, Marker, PaneTitle, Pin, ScaleBar
from ui.views.panes import PANES

if TYPE_CHECKING:
    from ui.views.panes import Panes

Place = tuple[float, float, float]


class Overlays:
    """The overlays of a view grid."""

    def __init__(self, parent: QWidget) -> None:
        self._parent = parent
        self.titles = [PaneTitle(parent) for _ in range(PANES)]
        self.values = [PaneTitle(parent) for _ in range(PANES)]
        self.markers = [Marker(parent) for _ in range(PANES)]
        self.pins = [Pin(parent) for _ in range(PANES)]
        self.dividers = [Divider(parent) for _ in range(PANES - 1)]
        self.axes = [Axes(parent) for _ in range(PANES)]
        self.scales = [ScaleBar(parent) for _ in range(PANES)]
        self.axes_wanted = self.scales_wanted = True

    @property
    def in_pictures(self) -> tuple[QWidget, ...]:
        """What belongs into a picture of the views, from the lowest up."""
        return (*self.dividers, *self.axes, *self.scales, *self.pins, *self.titles)

    @property
    def title_height(self) -> int:
        """How far down from the top of the views titles reach."""
        return max((title.geometry().bottom() for title in self.titles if not title.isHidden()), default=0)

    def set_theme(self, dark: bool) -> None:
        """Light or dark."""
        for overlay in (*self.titles, *self.values, *self.dividers, *self.axes, *self.scales):
            overlay.set_theme(dark)

    def follow(self, panes: Panes, count: int) -> None:
        """The cameras have moved."""
        for pane in range(count):
            self.axes[pane].set_camera(panes.looks[pane])
            self.scales[pane].set_camera(panes.looks[pane], self._parent.height())

    def place(self, panels: Sequence[Panel], hovering: bool, linked: bool) -> None:
        """Put everything where it belongs in the parent's size."""
        parent = self._parent
        width = parent.width() / max(len(panels), 1)
        for pane in range(PANES):
            title, value = self.titles[pane], self.values[pane]
            shown = pane < len(panels)
            if shown:
                title.set_text(panels[pane].title, panels[pane].subtitle)
                title.fit(max(round(width) - 2 * MARGIN, 60))
                title.move(round(pane * width) + MARGIN, MARGIN)
                value.move(
                    round((pane + 1) * width) - value.width() - MARGIN, parent.height() - value.height() - MARGIN
                )
            title.setVisible(shown and not title.empty and width >= LEAST_TITLE)
            value.setVisible(shown and not value.empty and hovering)
            own = shown and (pane == 0 or not linked)
            axes, scale = self.axes[pane], self.scales[pane]
            axes.move(round(pane * width) + MARGIN // 2, parent.height() - axes.height() - MARGIN // 2)
            axes.setVisible(own and self.axes_wanted)
            left = axes.width() if self.axes_wanted else MARGIN // 2
            scale.move(round(pane * width) + left + MARGIN // 2, parent.height() - scale.height() - MARGIN)
            scale.set_room(width / 3)
            scale.setVisible(own and self.scales_wanted)
        for index, divider in enumerate(self.dividers):
            divider.setGeometry(round((index + 1) * width), 0, 1, parent.height())
            divider.setVisible(index + 1 < len(panels))

    def point(self, panes: Panes, count: int, hover: Place | None, pin: Place | None) -> None:
        """Put the markers of a point under the pointer and of one that was picked into every pane."""
        for marks, place in ((self.markers, hover), (self.pins, pin)):
            for pane, mark in enumerate(marks):
                if place is None or pane >= count:
                    mark.hide()
                    continue
                x, y = panes.looks[pane].project(place)
                mark.place(panes.place_of(pane, float(x), float(y)))
