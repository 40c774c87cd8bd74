"""Turns the session into what the 3D views show: panels with titles, one colour range, the rolling plane."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer, Slot

from ui.formatting import METHOD_TITLES, VARIANT_TITLES, micrometres
from ui.scenery import Rolled, Scene, Scenery, Sight, make_rolled
from ui.session import Key, Session
from ui.views.wardrobe import Wardrobe
from ui.words import inline, retold, told, tr

if TYPE_CHECKING:
    from gearstudio.results import VariantResult
    from gearstudio.theory.cones import MemberGeometry
    from gearstudio.theory.flank import FlankName
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
        self._flank: FlankName = "concave"
        self._rolled: Rolled | None = None
        self._scenery = Scenery(self)
        self._scenery.made.connect(self._on_made)
        self._scenery.failed.connect(self.redraw)  # it fails here too, where that is told
        self._wardrobe = Wardrobe(self)
        self._wardrobe.changed.connect(self.redraw_soon)
        self._redraw = QTimer(self, singleShot=True, interval=REDRAW_PAUSE_MS)
        self._redraw.timeout.connect(self._put_up_soon)

    @property
    def flank(self) -> FlankName:
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
        sight = self._sight()
        if sight is not None:
            self._put_up(self._scenery.now(sight))

    def _put_up_soon(self) -> None:
        """Show the session when the layers for that are made; until then what was seen before stays."""
        sight = self._sight()
        scene = self._scenery.soon(sight) if sight is not None else None
        if scene is not None:
            self._put_up(scene)

    def _on_made(self) -> None:
        """Show a scene, also of the member as it was a moment ago: where edits never rest there is no newer one."""
        sight, scene = self._sight(), self._scenery.scene
        if sight is not None and scene is not None and scene.sight.has_results_of(sight):
            self._put_up(scene)

    def _sight(self) -> Sight | None:
        """What is to be seen; None while there are no views for it."""
        session = self._session
        if self._area.grid is None or session.pair is None or not self.active:
            return None
        results = {key: session.results[key] for key in session.visible_keys if key in session.results}
        member = session.pair.member(session.member)
        return Sight(session.visible_keys, member, results, self._roll, self._flank)

    def _put_up(self, scene: Scene) -> None:
        from ui.layers import Panel

        grid, session, member = self._area.grid, self._session, scene.sight.member
        assert grid is not None
        if scene.rolled.is_at(member, self._roll, self._flank) and self._rolled is not scene.rolled:
            self._take_rolled(scene.rolled)
        shared = (*scene.shared, *self._rolling(member))
        dressed = self._wardrobe.dress(scene.made, member, grid.appearance, grid.visible_layers)
        self._show_color_range(scene, dressed)
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
        self._scenery.close()
        self._wardrobe.close()

    def set_roll(self, roll: float) -> None:
        """Roll the tangent plane to a place in [0, 1]."""
        self._roll = roll
        if self.active and self._area.grid is not None and self._session.pair is not None:
            self._area.grid.update_layers(self._rolling(self._session.pair.member(self._session.member)))

    def set_flank(self, flank: FlankName) -> None:
        """Choose the flank that the rolling plane generates."""
        self._flank = flank
        self.redraw()

    def apply_color_range(self, low: float, high: float) -> None:
        """Colour every view over this range."""
        if self._area.grid is not None:
            self._area.grid.set_color_range(high, low)
            if self._area.grid.appearance.contours:
                self.redraw_soon()

    def _show_color_range(self, scene: Scene, dressed: Mapping[Key, Dressed]) -> None:
        bar, grid = self._area.color_bar, self._area.grid
        if bar is None or grid is None or not dressed:
            return
        from ui.views.quantities import quantity_of, typical_range

        bar.show_exaggeration(self._wardrobe.factor)
        if quantity_of(grid.appearance).is_deviation:
            bar.set_data_limit(largest_of(scene.sight.results[key] for key in dressed))
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
        if self._rolled is None or not self._rolled.is_at(member, self._roll, self._flank):
            self._take_rolled(make_rolled(member, self._roll, self._flank))
        assert self._rolled is not None
        return self._rolled.layers

    def _take_rolled(self, rolled: Rolled) -> None:
        self._rolled = rolled
        if self._area.roll_slider is not None:
            self._area.roll_slider.set_span(rolled.span_deg)


def _same_layers(some: Sequence[Panel], others: Sequence[Panel]) -> bool:
    """Whether the panels differ at most in their words."""
    return [(panel.key, *map(id, panel.layers)) for panel in some] == [
        (panel.key, *map(id, panel.layers)) for panel in others
    ]
