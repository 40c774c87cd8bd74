"""Feeds the views with solids, alone in their own frame or as a pair in the world's."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from gearstudio.theory.place import Place
from ui.layers import Layer, Panel
from ui.measuring import Frame
from ui.section import Plane
from ui.solid_layers import PlacedGear, SolidOptions, base_place
from ui.solid_workshop import PAIR, Order, Wares, Workshop, turns_of

if TYPE_CHECKING:
    from gearstudio.theory.cones import PairGeometry
    from ui.session import Key
    from ui.solids import Built
    from ui.view_grid import ViewGrid

__all__ = ["PAIR", "SolidView"]


class SolidView:
    """Shows solids in a view grid: at once by `show`, or by `put_up` what a `Workshop` made elsewhere."""

    def __init__(self, grid: ViewGrid) -> None:
        self.grid = grid
        self.gears: tuple[PlacedGear, ...] = ()
        self.plane: Plane | None = None
        self.in_mesh = False
        self.workshop = Workshop()
        self._pair: PairGeometry | None = None
        self._turn = 0.0

    @property
    def layers(self) -> tuple[Layer, ...]:
        """What is shown."""
        return self.grid.panels[0].layers if self.grid.panels else ()

    def show(
        self,
        pair: PairGeometry,
        keys: Sequence[Key],
        built: dict[Key, Built],
        options: SolidOptions,
        words: tuple[str, str],
    ) -> None:
        """Show the solids of these keys, two of them in mesh; teeth from theory stand for one that is not there yet."""
        order = Order(pair, tuple(keys), dict(built), options, self.plane, self._turn)
        self.put_up(self.workshop.make(order), words)

    def put_up(self, wares: Wares, words: tuple[str, str]) -> None:
        """Show what was made."""
        order = wares.order
        self._pair, self.in_mesh = order.pair, order.in_mesh
        self.gears, self.plane = wares.gears, order.plane
        self.grid.store.cut(self.plane)
        self.grid.store.move(self.turns)
        self.grid.set_panels([Panel("solid", *words, wares.layers)])

    def turn(self, angle: float) -> None:
        """Turn the pair in mesh by an angle of the pinion [rad]: only matrices change."""
        self._turn = angle
        self.grid.store.move(self.turns)
        self.grid.viewport.set_moving()
        self.grid.viewport.update()

    def close(self) -> None:
        """Leave the views whole and unmoved."""
        self.gears, self.plane, self._turn = (), None, 0.0
        self.workshop = Workshop()
        self.grid.store.cut(None)

    @property
    def angle(self) -> float:
        """How far the pinion has turned [rad]."""
        return self._turn

    @property
    def turns(self) -> dict[str, Place]:
        """How each member has moved from where its layers put it."""
        return turns_of(self._pair, self.in_mesh, self._turn)

    @property
    def frames(self) -> dict[str, Frame]:
        """How the members in sight stand."""
        turns, pair = self.turns, self._pair if self.in_mesh else None
        return {
            gear.member: Frame(Place() if pair is None else base_place(pair, gear.member), turns[gear.member])
            for gear in self.gears
        }

    def extent(self, axis: int) -> tuple[float, float] | None:
        """Lowest and highest coordinate of the solids [mm]."""
        boxes = [x.bounds for x in self.layers if x.body and x.kind == "surface" and len(x.points)]
        if not boxes:
            return None
        return float(min(b[0][axis] for b in boxes)), float(max(b[1][axis] for b in boxes))
