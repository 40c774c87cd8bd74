"""How the views show things, as one record that is remembered; no widget."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from typing import Any, Literal

from ui.views.factors import AUTOMATIC, FACTORS, OFF
from ui.views.zebra import FEWEST, MOST, Stripes

Against = Literal["", "absolute", "relative"]
Unit = Literal["auto", "um", "nm", "uin"]
Ground = Literal["theme", "white", "grey", "black"]

GROUNDS: dict[str, tuple[str, bool]] = {
    "white": ("#ffffff", False),
    "grey": ("#8a9099", True),
    "black": ("#000000", True),
}
"""Colour of a plain ground, and whether what is drawn on it takes the colours of the dark theme."""


@dataclass(frozen=True)
class LayerLook:
    """What the user changed of a layer: colour ``#rrggbb`` and opacity, None for as it is made."""

    color: str | None = None
    opacity: float | None = None


@dataclass(frozen=True)
class Appearance:
    """Choices about the views.

    Attributes
    ----------
    quantity : str
        What colours the CAD flanks, of `quantities.QUANTITIES`.
    against : str
        Curvature as it is, or less that of theory, or relative to it.
    colors : str
        Colour map, of `colormap.MAPS`; ``auto`` suits the quantity.
    steps : int
        Number of colours; 0 for a smooth run.
    contours, edges, scale_bar, axes, linked, parallel, zebra : bool
    unit : str
        Of deviations.
    exaggeration : int
        Flanks are drawn with their deviation so many times as large; 1 as they are, 0 for what suits them.
    ground : str
    stripes : Stripes
    combs : str
        Along the ``profile`` or ``lengthwise``.
    comb_scale : float
        1 is a length that suits the tooth.
    looks : mapping of layer id to LayerLook
    """

    quantity: str = "deviation"
    against: Against = ""
    colors: str = "auto"
    steps: int = 0
    contours: bool = False
    unit: Unit = "auto"
    exaggeration: int = OFF
    edges: bool = True
    zebra: bool = False
    stripes: Stripes = field(default_factory=Stripes)
    combs: Literal["profile", "lengthwise"] = "profile"
    comb_scale: float = 1.0
    parallel: bool = False
    linked: bool = True
    scale_bar: bool = True
    axes: bool = True
    ground: Ground = "theme"
    looks: Mapping[str, LayerLook] = field(default_factory=dict)

    def with_look(self, layer_id: str, look: LayerLook) -> Appearance:
        """With a layer shown otherwise."""
        looks = {**self.looks, layer_id: look}
        return replace(self, looks={name: one for name, one in looks.items() if one != LayerLook()})


def to_text(appearance: Appearance) -> str:
    """As it is remembered."""
    return json.dumps(asdict(appearance))


def from_text(text: object) -> Appearance:
    """What was remembered; whatever of it makes no sense takes its default."""
    try:
        data = json.loads(str(text))
    except ValueError:
        return Appearance()
    if not isinstance(data, dict):
        return Appearance()
    default = asdict(Appearance())
    good: dict[str, Any] = {}
    for entry in fields(Appearance):
        value = data.get(entry.name)
        if entry.name == "stripes":
            good["stripes"] = _stripes(value)
        elif entry.name == "looks":
            good["looks"] = _looks(value)
        elif type(value) is type(default[entry.name]) and _sensible(entry.name, value):
            good[entry.name] = value
    return Appearance(**good)


_CHOICES: dict[str, tuple[object, ...]] = {
    "quantity": ("deviation", "gaussian", "mean", "largest", "smallest"),
    "against": ("", "absolute", "relative"),
    "colors": ("auto", "balance", "purple_green", "dusk", "grey"),
    "steps": (0, 6, 8, 10, 12, 16, 20),
    "exaggeration": (OFF, AUTOMATIC, *FACTORS),
    "unit": ("auto", "um", "nm", "uin"),
    "combs": ("profile", "lengthwise"),
    "ground": ("theme", *GROUNDS),
}
STEPS = _CHOICES["steps"]


def _sensible(name: str, value: Any) -> bool:
    if name == "comb_scale":
        return bool(0.01 <= value <= 100)
    return name not in _CHOICES or value in _CHOICES[name]


def _stripes(value: Any) -> Stripes:
    try:
        made = Stripes(int(value["count"]), bool(value["with_gear"]), float(value["angle_deg"]))
    except (TypeError, KeyError, ValueError):
        return Stripes()
    return made if FEWEST <= made.count <= MOST and 0 <= made.angle_deg <= 180 else Stripes()


def _looks(value: Any) -> dict[str, LayerLook]:
    made = {}
    for name, one in value.items() if isinstance(value, dict) else ():
        color, opacity = (one.get("color"), one.get("opacity")) if isinstance(one, dict) else (None, None)
        if not (isinstance(color, str) and len(color) == 7 and color.startswith("#")):
            color = None
        if not (isinstance(opacity, float) and 0 <= opacity <= 1):
            opacity = None
        made[str(name)] = LayerLook(color, opacity)
    return made
