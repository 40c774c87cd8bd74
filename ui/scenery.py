"""The layers of a member and of its results, made in a thread for the views; what was made is kept for the next."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from ui.analysis.background import Newest
from ui.session import Key

if TYPE_CHECKING:
    from gearstudio.results import VariantResult
    from gearstudio.theory.cones import MemberGeometry
    from gearstudio.theory.flank import FlankName
    from ui.layers import Layer


@dataclass(frozen=True, eq=False)
class Sight:
    """What the views are to show: these variants of a member, with the results that there are of them.

    ``roll`` and ``flank`` are those of the rolling plane; it may roll on while a scene is made.
    """

    keys: tuple[Key, ...]
    member: MemberGeometry
    results: Mapping[Key, VariantResult]
    roll: float
    flank: FlankName

    def has_results_of(self, other: Sight) -> bool:
        """Whether it differs from the other one in nothing but the member's geometry and the rolling plane."""
        mine, its = ({key: id(result) for key, result in one.results.items()} for one in (self, other))
        return (self.keys, mine) == (other.keys, its)

    def is_like(self, other: Sight) -> bool:
        """Whether the other one looks the same but for the rolling plane."""
        return self.has_results_of(other) and self.member == other.member


@dataclass(frozen=True, eq=False)
class Rolled:
    """The rolling plane of a member at a place, and the angle [deg] that it rolls through for a flank."""

    member: MemberGeometry
    roll: float
    flank: FlankName
    layers: tuple[Layer, ...]
    span_deg: float

    def is_at(self, member: MemberGeometry, roll: float, flank: FlankName) -> bool:
        """Whether it is that of a member there."""
        return (self.roll, self.flank) == (roll, flank) and self.member == member


@dataclass(frozen=True, eq=False)
class Scene:
    """A sight as layers: of the member, of the rolling plane, and of each result."""

    sight: Sight
    shared: tuple[Layer, ...]
    rolled: Rolled
    made: Mapping[Key, tuple[VariantResult, tuple[Layer, ...]]]


def make_rolled(member: MemberGeometry, roll: float, flank: FlankName) -> Rolled:
    """Roll the plane to a place in [0, 1]."""
    from ui.scene import SceneOptions, roll_span_deg, rolling_layers

    options = SceneOptions(flank)
    return Rolled(member, roll, flank, rolling_layers(member, roll, options), roll_span_deg(member, options))


def make_scene(sight: Sight, before: Scene | None) -> Scene:
    """Make the layers ready for the renderer; those of results that are in the scene before are taken from there."""
    from ui.scene import member_layers, result_layers

    held = {id(result): layers for result, layers in before.made.values()} if before is not None else {}
    made = {key: (result, held.get(id(result)) or result_layers(result)) for key, result in sight.results.items()}
    place = sight.member, sight.roll, sight.flank
    rolled = before.rolled if before is not None and before.rolled.is_at(*place) else make_rolled(*place)
    shared = member_layers(sight.member)
    for layers in (shared, rolled.layers, *(layers for _, layers in made.values())):
        for layer in layers:
            layer.load()
    return Scene(sight, shared, rolled, made)


class Scenery(QObject):
    """Makes scenes one at a time, the newest next.

    Signals
    -------
    made()
        ``scene`` is another one.
    failed()
        The scene asked for could not be made.
    """

    made = Signal()
    failed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.scene: Scene | None = None
        self._asked: Sight | None = None
        self._newest = Newest("scene", self)
        self._newest.done.connect(self._on_done)
        self._newest.failed.connect(lambda *_: self.failed.emit())

    def now(self, sight: Sight) -> Scene:
        """A scene of it, made at once where there is none."""
        if self.scene is None or not self.scene.sight.is_like(sight):
            self._asked = None
            self._newest.cancel()
            self.scene = make_scene(sight, self.scene)
        return self.scene

    def soon(self, sight: Sight) -> Scene | None:
        """A scene of it; None where it must be made, which is told."""
        before = self.scene
        if before is not None and before.sight.is_like(sight):
            return before
        if self._asked is None or not self._asked.is_like(sight):
            self._asked = sight
            self._newest.request(sight, lambda: make_scene(sight, before))
        return None

    def close(self) -> None:
        """Make no more."""
        self._newest.close()

    def _on_done(self, sight: Sight, scene: Scene) -> None:
        if self._asked is None:
            return
        self.scene = scene
        if sight is self._asked:
            self._asked = None
        self.made.emit()
