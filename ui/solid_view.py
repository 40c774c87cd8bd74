"""Feeds the views with solids: what is made for a solid is made once and kept until it is replaced."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from typing import TYPE_CHECKING, Any

from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.place import Place
from ui.layers import Layer, Panel
from ui.measuring import Frame
from ui.section import Plane
from ui.solid_layers import (
    PlacedGear,
    SolidOptions,
    base_place,
    cut_layers,
    gear_layers,
    motion,
    preview_layers,
    put,
)

if TYPE_CHECKING:
    from gearstudio.theory.cones import PairGeometry
    from ui.session import Key
    from ui.solids import Built
    from ui.view_grid import ViewGrid

PAIR = ("pinion", "wheel")


class SolidView:
    """Shows solids in a view grid, alone in their own frame or as a pair in the world's."""

    def __init__(self, grid: ViewGrid) -> None:
        self.grid = grid
        self.gears: tuple[PlacedGear, ...] = ()
        self.plane: Plane | None = None
        self.in_mesh = False
        self._pair: PairGeometry | None = None
        self._turn = 0.0
        self._made: dict[tuple[str, str], tuple[Hashable, Any]] = {}

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
        moving: bool = False,
    ) -> None:
        """Show the solids of these keys, two of them in mesh; teeth from theory stand for one that is not there yet.

        While ``moving`` the cut faces are left out, for they would have to be computed for every frame.
        """
        self._pair, self.in_mesh = pair, len(keys) > 1
        self.gears = tuple(self._placed(key, built[key]) for key in keys if key in built)
        shown = [layer for gear in self.gears for layer in self._layers_of(gear, options)]
        for key in keys:
            if key not in built:
                shown += self._preview(pair, key.member)
        self.grid.store.cut(self.plane)
        self.grid.store.move(self.turns)
        if self.plane is not None and not moving:
            shown += self._cut(self.plane)
        self.grid.set_panels([Panel("solid", *words, tuple(shown))])

    def turn(self, angle: float) -> None:
        """Turn the pair in mesh by an angle of the pinion [rad]: only matrices change."""
        self._turn = angle
        self.grid.store.move(self.turns)
        self.grid.viewport.set_moving()
        self.grid.viewport.update()

    def close(self) -> None:
        """Leave the views whole and unmoved."""
        self.gears, self.plane, self._turn = (), None, 0.0
        self._made.clear()
        self.grid.store.cut(None)

    @property
    def angle(self) -> float:
        """How far the pinion has turned [rad]."""
        return self._turn

    @property
    def turns(self) -> dict[str, Place]:
        """How each member has moved from where its layers put it."""
        if self._pair is None or not self.in_mesh:
            return {member: Place() for member in PAIR}
        return {member: motion(self._pair, member, self._turn) for member in PAIR}

    @property
    def frames(self) -> dict[str, Frame]:
        """How the members in sight stand."""
        turns, whole = self.turns, self.in_mesh and self._pair is not None
        return {
            gear.member: Frame(base_place(self._pair, gear.member) if whole else Place(), turns[gear.member])  # type: ignore[arg-type]
            for gear in self.gears
        }

    def extent(self, axis: int) -> tuple[float, float] | None:
        """Lowest and highest coordinate of the solids [mm]."""
        boxes = [x.bounds for x in self.layers if x.body and x.kind == "surface" and len(x.points)]
        if not boxes:
            return None
        return float(min(b[0][axis] for b in boxes)), float(max(b[1][axis] for b in boxes))

    # ---- parts -----------------------------------------------------------------------------------------

    def _placed(self, key: Key, built: Built) -> PlacedGear:
        if not self.in_mesh:
            return built.gear

        def make() -> PlacedGear:
            return put(built.gear, base_place(pair_geometry(built.design), key.member))

        return self._kept("gear", key.member, (built,), make)

    def _layers_of(self, gear: PlacedGear, options: SolidOptions) -> tuple[Layer, ...]:
        return self._kept("layers", gear.member, (gear, options), lambda: gear_layers(gear, options))

    def _preview(self, pair: PairGeometry, member: str) -> tuple[Layer, ...]:
        return self._kept("preview", member, (pair, self.in_mesh), lambda: preview_layers(pair, member, self.in_mesh))

    def _cut(self, plane: Plane) -> tuple[Layer, ...]:
        turns = self.turns
        label = (self.gears, plane, self._turn if self.in_mesh else 0.0)
        return self._kept("cut", "", label, lambda: cut_layers([put(g, turns[g.member]) for g in self.gears], plane))

    def _kept(self, kind: str, member: str, label: Hashable, make: Callable[[], Any]) -> Any:
        """What was made for a label, made once; of each kind and member only the newest is kept."""
        held = self._made.get((kind, member))
        if held is None or held[0] != label:
            held = self._made[kind, member] = (label, make())
        return held[1]
