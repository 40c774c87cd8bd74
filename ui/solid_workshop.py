"""Makes the layers of solids in sight, in any thread: what was made for a solid is kept until it is replaced."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from gearstudio.theory.cones import PairGeometry, pair_geometry
from gearstudio.theory.place import Place
from ui.layers import Layer
from ui.section import Plane
from ui.solid_layers import (
    Level,
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
    from ui.session import Key
    from ui.solids import Built

PAIR = ("pinion", "wheel")


@dataclass(frozen=True, eq=False)
class Order:
    """What is to be seen.

    Attributes
    ----------
    pair : PairGeometry
    keys : tuple of Key
        Two of them stand in mesh.
    built : mapping of Key to Built
        Teeth from theory stand for a solid that is not among them.
    options : SolidOptions
    plane : Plane or None
        Of the section.
    turn : float
        Of the pinion in mesh [rad].
    cut : {"fine", "coarse", ""}
        Which meshes the cut faces are made of; none while the pair turns, for every frame would need others.
    """

    pair: PairGeometry
    keys: tuple[Key, ...]
    built: Mapping[Key, Built]
    options: SolidOptions
    plane: Plane | None = None
    turn: float = 0.0
    cut: Level | str = "fine"

    @property
    def in_mesh(self) -> bool:
        """Whether the gears stand in the world's frame."""
        return len(self.keys) > 1


@dataclass(frozen=True, eq=False)
class Wares:
    """What an order has become."""

    order: Order
    gears: tuple[PlacedGear, ...]
    layers: tuple[Layer, ...]


def turns_of(pair: PairGeometry | None, in_mesh: bool, turn: float) -> dict[str, Place]:
    """How each member has moved from where its layers put it."""
    if pair is None or not in_mesh:
        return {member: Place() for member in PAIR}
    return {member: motion(pair, member, turn) for member in PAIR}


class Workshop:
    """Carries orders out, one at a time."""

    def __init__(self) -> None:
        self._made: dict[tuple[str, str], tuple[Hashable, Any]] = {}

    def make(self, order: Order) -> Wares:
        """Layers with all that the views and the pointer will ask of them."""
        gears = tuple(self._placed(order, key) for key in order.keys if key in order.built)
        layers = [layer for gear in gears for layer in self._layers_of(gear, order.options)]
        for key in order.keys:
            if key not in order.built:
                layers += self._preview(order, key.member)
        if order.plane is not None and order.cut:
            layers += self._cut(order, gears)
        for layer in layers:
            layer.prepare()
        return Wares(order, gears, tuple(layers))

    def _placed(self, order: Order, key: Key) -> PlacedGear:
        built = order.built[key]
        if not order.in_mesh:
            return built.gear

        def make() -> PlacedGear:
            return put(built.gear, base_place(pair_geometry(built.design), key.member))

        return self._kept("gear", key.member, (built,), make)  # type: ignore[no-any-return]

    def _layers_of(self, gear: PlacedGear, options: SolidOptions) -> tuple[Layer, ...]:
        return self._kept("layers", gear.member, (gear, options), lambda: gear_layers(gear, options))  # type: ignore[no-any-return]

    def _preview(self, order: Order, member: str) -> tuple[Layer, ...]:
        label = (order.pair, order.in_mesh)
        return self._kept("preview", member, label, lambda: preview_layers(order.pair, member, order.in_mesh))  # type: ignore[no-any-return]

    def _cut(self, order: Order, gears: tuple[PlacedGear, ...]) -> tuple[Layer, ...]:
        plane, turn = order.plane, order.turn if order.in_mesh else 0.0
        assert plane is not None
        turns = turns_of(order.pair, order.in_mesh, turn)

        def make() -> tuple[Layer, ...]:
            placed = [(gear.member, gear.level(order.cut), turns[gear.member]) for gear in gears]
            return cut_layers(placed, plane)

        return self._kept("cut", "", (gears, plane, turn, order.cut), make)  # type: ignore[no-any-return]

    def _kept(self, kind: str, member: str, label: Hashable, make: Callable[[], Any]) -> Any:
        """What was made for a label, made once; of each kind and member only the newest is kept."""
        held = self._made.get((kind, member))
        if held is None or held[0] != label:
            held = self._made[kind, member] = (label, make())
        return held[1]
