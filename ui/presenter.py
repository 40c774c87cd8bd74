"""Turns the session into what the 3D views show: panels with titles, one colour range, the rolling plane."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer, Slot

from ui.formatting import METHOD_TITLES, VARIANT_TITLES, micrometres
from ui.session import Key, Session
from ui.views.wardrobe import Wardrobe
from ui.words import inline, retold, told, tr

if TYPE_CHECKING:
    from gearstudio.results import VariantResult
    from gearstudio.theory.cones import MemberGeometry
    from ui.layers import Layer, Panel
    from ui.view_area import ViewArea
    from ui.views.appearance import Appearance
    from ui.views.wardrobe import Dressed

REDRAW_PAUSE_MS = 15
PART = " · "
"""Between the parts of a title."""


@retold
def view_title(key: Key) -> str:
    """Method and variant, over a view."""
    return f"{tr(METHOD_TITLES[key.method])} · {inline(VARIANT_TITLES[key.variant])}"


def view_subtitle(session: Session, key: Key) -> str:
    """How a view's result stands: its deviation, or why there is none (yet)."""
    result = session.results.get(key)
    if key in session.failures:
        return told(session.failures[key].message)
    if result is not None:
        largest = micrometres(result.statistics.max_um)
        return result_words(result) if key in session.current else tr("updating… (max was {largest})", largest=largest)
    return tr("building…") if key == session.building else tr("waiting for the CAD kernel…")


def result_words(result: VariantResult) -> str:
    """The deviation of a result in a few words."""
    return tr(
        "max {largest} · mean {mean}",
        largest=micrometres(result.statistics.max_um),
        mean=micrometres(result.statistics.mean_um),
    )


def exaggerated_words(words: str, factor: int) -> str:
    """A view's words with what its shape is to be taken for."""
    if factor == 1:
        return words
    from ui.views.factors import factor_text

    first, *others = words.split(PART)
    return PART.join([first, tr("deviation {factor}", factor=factor_text(factor)), *others])


def largest_of(results: Iterable[VariantResult]) -> float:
    """The largest deviation [µm] of several results."""
    return max(result.statistics.max_um for result in results)


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
        self._wardrobe = Wardrobe(self)
        self._wardrobe.changed.connect(self.redraw_soon)
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
        made = {
            key: (session.results[key], self._layers_of(key)) for key in session.visible_keys if key in session.results
        }
        dressed = self._wardrobe.dress(made, member, grid.appearance, grid.visible_layers)
        self._show_color_range(dressed)
        contours = self._wardrobe.contours(dressed, self._levels(grid.appearance))
        panels = []
        for key in session.visible_keys:
            own = (*dressed[key].layers, *contours[key]) if key in dressed else ()
            note = dressed[key].note if key in dressed else ""
            words = note if note and key in session.current else view_subtitle(session, key)
            words = exaggerated_words(words, self._wardrobe.factor) if key in dressed else words
            panels.append(Panel(key.method, view_title(key), words, (*shared, *own)))
        if _same_layers(panels, grid.panels):
            grid.set_titles({panel.key: (panel.title, panel.subtitle) for panel in panels})
        else:
            grid.set_panels(panels)

    def close(self) -> None:
        """End the work in the background."""
        self._redraw.stop()
        self._wardrobe.close()

    def set_roll(self, roll: float) -> None:
        """Roll the tangent plane to a place in [0, 1]."""
        self._roll = roll
        if self.active and self._area.grid is not None and self._session.pair is not None:
            self._area.grid.update_layers(self._rolling(self._session.pair.member(self._session.member)))

    def set_flank(self, flank: str) -> None:
        """Choose the flank that the rolling plane generates."""
        self._flank = flank
        self.redraw()

    def apply_color_range(self, low: float, high: float) -> None:
        """Colour every view over this range."""
        if self._area.grid is not None:
            self._area.grid.set_color_range(high, low)
            if self._area.grid.appearance.contours:
                self.redraw_soon()

    def _show_color_range(self, dressed: Mapping[Key, Dressed]) -> None:
        bar, grid = self._area.color_bar, self._area.grid
        if bar is None or grid is None or not dressed:
            return
        from ui.views.quantities import quantity_of, typical_range

        bar.show_exaggeration(self._wardrobe.factor)
        if quantity_of(grid.appearance).is_deviation:
            bar.set_data_limit(largest_of(self._session.results[key] for key in dressed))
            return
        values = [layer.scalars for one in dressed.values() for layer in one.layers if layer.scalars is not None]
        found = typical_range(quantity_of(grid.appearance), values)
        if found is not None:
            bar.set_data_range(*found)

    def _levels(self, appearance: Appearance) -> tuple[float, ...]:
        bar = self._area.color_bar
        return tuple(bar.levels()) if appearance.contours and bar is not None else ()

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
