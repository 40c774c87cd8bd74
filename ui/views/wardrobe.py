"""Dresses the layers of the results in sight as the user wants to see them; what was made is kept until it changes."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from ui.session import Key
from ui.views.surface_quality import Found, SurfaceQuality
from ui.words import tr

if TYPE_CHECKING:
    from gearstudio.results import VariantResult
    from gearstudio.theory.cones import MemberGeometry
    from ui.layers import Layer
    from ui.views.appearance import Appearance

Made = Mapping[Key, tuple["VariantResult", tuple["Layer", ...]]]


@dataclass(frozen=True)
class Dressed:
    """The layers of a result, and what is to be said instead of its deviation."""

    layers: tuple[Layer, ...]
    note: str = ""


class Wardrobe(QObject):
    """Asks for surface quality only while something shows it.

    Signals
    -------
    changed()
        The same question would be answered otherwise now.
    """

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._quality = SurfaceQuality(self)
        self._quality.changed.connect(self.changed)
        self.factor = 1
        self._bent: dict[Key, tuple[tuple[object, ...], tuple[Layer, ...]]] = {}
        self._worn: dict[Key, tuple[tuple[object, ...], Dressed]] = {}
        self._lines: dict[tuple[int, tuple[float, ...]], tuple[Layer, Layer]] = {}

    def close(self) -> None:
        """Compute no more."""
        self._quality.close()

    def dress(
        self, made: Made, member: MemberGeometry, appearance: Appearance, visible: Collection[str]
    ) -> dict[Key, Dressed]:
        """Layers and words of each result; ``factor`` tells how much larger their deviation is drawn."""
        from ui.views.exaggeration import factor_for
        from ui.views.quantities import quantity_of

        self.factor = factor_for(appearance.exaggeration, [result for result, _ in made.values()])
        made = self._displaced(made, member)
        colored = not quantity_of(appearance).is_deviation
        if not made or not (colored or appearance.zebra or {"combs", "normals"} & set(visible)):
            self._worn.clear()
            return {key: Dressed(layers) for key, (_, layers) in made.items()}
        found = dict(zip(made, self._quality.of([result for result, _ in made.values()], member), strict=True))
        typical = _typical(found, appearance)
        wanted = (appearance.quantity, appearance.against, appearance.combs, appearance.comb_scale, typical)
        self._worn = {key: worn for key, worn in self._worn.items() if key in made}
        for key, (result, layers) in made.items():
            label = (id(layers), id(found[key]), wanted)
            if key not in self._worn or self._worn[key][0] != label:
                self._worn[key] = (label, _dressed(layers, result, found[key], appearance, typical))
        return {key: self._worn[key][1] for key in made}

    def _displaced(self, made: Made, member: MemberGeometry) -> Made:
        from ui.views.exaggeration import displaced

        kept = {}
        for key, (result, layers) in made.items():
            label = (result, layers, self.factor)
            held = self._bent.get(key)
            same = held is not None and all(one is other for one, other in zip(held[0], label, strict=True))
            kept[key] = held if same and held is not None else (label, displaced(layers, result, member, self.factor))
        self._bent = kept
        return {key: (made[key][0], layers) for key, (_, layers) in kept.items()}

    def contours(self, dressed: Mapping[Key, Dressed], levels: tuple[float, ...]) -> dict[Key, tuple[Layer, ...]]:
        """Lines of equal value on every coloured surface."""
        from ui.views.contours import contour_layer
        from ui.views.dressing import COLORED

        kept, lines = {}, {}
        for key, one in dressed.items():
            own = []
            for layer in one.layers if levels else ():
                if layer.layer_id == COLORED and layer.kind == "surface":
                    label = (id(layer), levels)
                    kept[label] = self._lines.get(label) or (layer, contour_layer(layer, levels))
                    own.append(kept[label][1])
            lines[key] = tuple(line for line in own if len(line.points))
        self._lines = kept
        return lines


def _typical(found: Mapping[Key, Found | None], appearance: Appearance) -> float:
    from ui.views.dressing import typical_curvature

    return typical_curvature([one for one in found.values() if isinstance(one, Mapping)], appearance.combs)


def _dressed(
    layers: tuple[Layer, ...], result: VariantResult, found: Found | None, appearance: Appearance, typical: float
) -> Dressed:
    import numpy as np

    from ui.views.dressing import COLORED, dressed
    from ui.views.quantities import quantity_of

    quantity = quantity_of(appearance)
    quality = found if isinstance(found, Mapping) else None
    worn = dressed(layers, result, quality, appearance, typical)
    if quantity.is_deviation:
        return Dressed(worn)
    if quality is None:
        return Dressed(worn, found if isinstance(found, str) else tr("computing the curvature…"))
    values = np.concatenate([x.scalars for x in worn if x.layer_id == COLORED and x.scalars is not None])
    values = values[np.isfinite(values)]
    if not len(values):
        return Dressed(worn, tr("no curvature to show"))
    return Dressed(worn, quantity.span_text(float(values.min()), float(values.max())))
