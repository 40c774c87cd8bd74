"""Turns the session into what the 3D views show: panels with titles, one colour range, the rolling plane."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer, Slot

from ui.formatting import METHOD_TITLES, VARIANT_TITLES, micrometres
from ui.session import Key, Session

if TYPE_CHECKING:
    from gearstudio.results import VariantResult
    from gearstudio.theory.cones import MemberGeometry
    from ui.layers import Layer, Panel
    from ui.view_area import ViewArea

REDRAW_PAUSE_MS = 15


def view_title(key: Key) -> str:
    """Method and variant, over a view."""
    return f"{METHOD_TITLES[key.method]} · {VARIANT_TITLES[key.variant].lower()}"


def view_subtitle(session: Session, key: Key) -> str:
    """How a view's result stands: its deviation, or why there is none (yet)."""
    result = session.results.get(key)
    if key in session.failures:
        return session.failures[key].message
    if result is not None:
        largest, mean = micrometres(result.statistics.max_um), micrometres(result.statistics.mean_um)
        return f"max {largest} · mean {mean}" if key in session.current else f"updating… (max was {largest})"
    return "building…" if key == session.building else "waiting for the CAD kernel…"


class Presenter(QObject):
    """Feeds a view area from a session; it does nothing until the views are there, nor while it is not ``active``."""

    def __init__(self, session: Session, area: ViewArea, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._area = area
        self.active = True
        self._roll = 1.0
        self._flank = "concave"
        self._rolled: tuple[tuple[MemberGeometry, float, str], tuple[Layer, ...]] | None = None
        self._made: dict[Key, tuple[VariantResult, tuple[Layer, ...]]] = {}
        self._redraw = QTimer(self, singleShot=True, interval=REDRAW_PAUSE_MS)
        self._redraw.timeout.connect(self.redraw)

    @property
    def flank(self) -> str:
        """The flank that the rolling plane generates."""
        return self._flank

    @Slot()
    def redraw_soon(self) -> None:
        """Many things may change at once; draw them together."""
        if not self._redraw.isActive():
            self._redraw.start()

    def redraw(self) -> None:
        """Show the session as it is now."""
        self._redraw.stop()
        grid, session = self._area.grid, self._session
        if grid is None or session.pair is None or not self.active:
            return
        from ui.layers import Panel
        from ui.scene import member_layers

        member = session.pair.member(session.member)
        shared = (*member_layers(member), *self._rolling(member))
        panels = [
            Panel(key.method, view_title(key), view_subtitle(session, key), (*shared, *self._layers_of(key)))
            for key in session.visible_keys
        ]
        if _same_layers(panels, grid.panels):
            grid.set_titles({panel.key: (panel.title, panel.subtitle) for panel in panels})
        else:
            grid.set_panels(panels)
        self._show_color_range()

    def set_roll(self, roll: float) -> None:
        """Roll the tangent plane to a place in [0, 1]."""
        self._roll = roll
        if self.active and self._area.grid is not None and self._session.pair is not None:
            self._area.grid.update_layers(self._rolling(self._session.pair.member(self._session.member)))

    def set_flank(self, flank: str) -> None:
        """Choose the flank that the rolling plane generates."""
        self._flank = flank
        self.redraw()

    def apply_color_range(self, limit_um: float) -> None:
        """Colour every view over this range."""
        if self._area.grid is not None:
            self._area.grid.set_color_range(limit_um)

    def _show_color_range(self) -> None:
        shown = [self._session.results[key] for key in self._session.visible_keys if key in self._session.results]
        if shown and self._area.color_bar is not None:
            self._area.color_bar.set_data_limit(max(result.statistics.max_um for result in shown))

    def _rolling(self, member: MemberGeometry) -> tuple[Layer, ...]:
        """The rolling plane, computed anew only when it is another one."""
        from ui.scene import SceneOptions, roll_span_deg, rolling_layers

        wanted = (member, self._roll, self._flank)
        if self._rolled is None or self._rolled[0] != wanted:
            options = SceneOptions(flank=self._flank)
            self._rolled = wanted, rolling_layers(member, self._roll, options)
            if self._area.roll_slider is not None:
                self._area.roll_slider.set_span(roll_span_deg(member, options))
        return self._rolled[1]

    def _layers_of(self, key: Key) -> tuple[Layer, ...]:
        """Layers of a result, made once; those of results that are gone are forgotten."""
        from ui.scene import result_layers

        results = self._session.results
        self._made = {old: made for old, made in self._made.items() if results.get(old) is made[0]}
        result = results.get(key)
        if result is None:
            return ()
        if key not in self._made:
            self._made[key] = (result, result_layers(result))
        return self._made[key][1]


def _same_layers(some: Sequence[Panel], others: Sequence[Panel]) -> bool:
    """Whether the panels differ at most in their words."""
    return [(panel.key, *map(id, panel.layers)) for panel in some] == [
        (panel.key, *map(id, panel.layers)) for panel in others
    ]
