"""Solids on their way into the views: layers are made in a thread, the newest order is put up."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Literal

from PySide6.QtCore import QObject, Signal

from ui.analysis.background import Newest
from ui.section import Plane
from ui.solid_layers import SolidOptions
from ui.solid_view import SolidView
from ui.solid_workshop import Order, Wares

if TYPE_CHECKING:
    from gearstudio.theory.cones import PairGeometry
    from ui.session import Key
    from ui.solid_panel import SolidPanel
    from ui.solids import Built

Motion = Literal["", "turning", "sliding"]
"""What moves now: the pair in mesh, or the section plane."""


class SolidStage(QObject):
    """Carries orders out for a view; what is asked for again only gets new words.

    Signals
    -------
    changed(object, bool)
        An `Order` is in sight, with other gears than before or not.
    failed(str, str)
    """

    changed = Signal(object, bool)
    failed = Signal(str, str)

    def __init__(self, view: SolidView, words: Callable[[], tuple[str, str]], parent: QObject) -> None:
        super().__init__(parent)
        self._view, self._words = view, words
        self._wanted: Order | None = None
        self._shown: Order | None = None
        self._making = Newest("solids in sight", self)
        self._making.done.connect(self._on_made)
        self._making.failed.connect(lambda _order, text, details: self.failed.emit(text, details))

    def show(
        self, pair: PairGeometry, keys: tuple[Key, ...], built: Mapping[Key, Built], panel: SolidPanel, motion: Motion
    ) -> None:
        """Show what there is of these solids, as a panel wants them, soon."""
        options, section = SolidOptions(panel.edges, panel.deviation), panel.section.plane
        plane = None if section is None else Plane(*section)
        there = {key: built[key] for key in keys if key in built}
        cut = "" if motion == "turning" or plane is None else "coarse" if motion == "sliding" else "fine"
        turn = self._view.angle if cut and len(keys) > 1 else 0.0
        self._show(Order(pair, keys, there, options, plane, turn, cut))

    def _show(self, order: Order) -> None:
        if self._wanted is not None and vars(order) == vars(self._wanted):
            if self._shown is self._wanted:
                self._view.grid.set_titles({"solid": self._words()})
            return
        self._wanted, workshop = order, self._view.workshop
        self._making.request(order, lambda: workshop.make(order))

    def forget(self) -> None:
        """Put up nothing any more of what was asked for so far."""
        self._wanted = self._shown = None
        self._making.cancel()

    def close(self) -> None:
        """Let the thread end."""
        self._making.close()

    def _on_made(self, order: Order, wares: Wares) -> None:
        if self._wanted is None or order.keys != self._wanted.keys:
            return
        before = self._view.gears
        self._shown = order
        self._view.put_up(wares, self._words())
        self.changed.emit(order, self._view.gears != before)
