"""What the 3D views can show: the list of layers, and the plain-array record that one drawn thing is.

A `Layer` knows no renderer: `scene.py` makes such records from theory and results, `actors.py` draws them.
Several records may share one ``layer_id`` (a disc and its rim); ``part`` tells them apart.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ui.pick_mesh import PickMesh

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
LayerKind = Literal["surface", "lines", "points"]


@dataclass(frozen=True)
class Ink:
    """A colour (#rrggbb) with one value for each theme."""

    light: str
    dark: str


@dataclass(frozen=True)
class Style:
    """How a layer is drawn.

    Attributes
    ----------
    ink : Ink
    opacity : float
        Below 1 the surface is glass.
    width : float
        Of lines, or diameter of points, in device-independent pixels.
    gloss : float
        Strength of the highlight, 0 for paper.
    flat : bool
        Drawn in its plain colour, whatever the light.
    lift : int
        Of coincident things the one with the higher lift is seen.
    inside : Ink or None
        What the surface shows from within the metal, in plain colour; None for the same as from outside.
    """

    ink: Ink
    opacity: float = 1.0
    width: float = 1.5
    gloss: float = 0.15
    flat: bool = False
    lift: int = 0
    inside: Ink | None = None


@dataclass(frozen=True, eq=False)
class Layer:
    """One thing to draw; compared by identity, so that what did not change is not sent to the renderer again.

    Attributes
    ----------
    layer_id : str
        Row of `LAYERS` that switches it.
    part : str
        Its name within the layer.
    kind : {"surface", "lines", "points"}
    points : ndarray, shape (n, 3)
        [mm].
    style : Style
    cells : ndarray, shape (m, 3), (m, 2) or (0, 0)
        Triangles of a surface, segments of lines; none for points.
    normals : ndarray, shape (n, 3), or None
        Unit normals of a surface.
    scalars : ndarray, shape (n,), or None
        Deviation [µm] or what else is drawn with the shared colour scale; NaN is drawn in grey.
    body : str
        What it moves with and is cut with; empty for what stands still and stays whole.
    level : {"", "fine", "coarse"}
        Drawn only while the picture stands still, or only while it moves; empty for always.
    deviation : ndarray, shape (n,), or None
        Deviation [µm] of a surface whose scalars may be something else.
    true_points : ndarray, shape (n, 3), or None
        Where the points are [mm], if they are drawn elsewhere to make their deviation seen.
    offset : ndarray, shape (n, 3), or None
        How far the points are from where theory has them [mm].
    """

    layer_id: str
    part: str
    kind: LayerKind
    points: Floats
    style: Style
    cells: Indices = field(default_factory=lambda: np.empty((0, 0), dtype=np.int64))
    normals: Floats | None = None
    scalars: Floats | None = None
    body: str = ""
    level: Literal["", "fine", "coarse"] = ""
    deviation: Floats | None = None
    true_points: Floats | None = None
    offset: Floats | None = None

    @property
    def key(self) -> str:
        """Name of the one actor that draws this."""
        return f"{self.layer_id}/{self.part}"

    @cached_property
    def bounds(self) -> tuple[Floats, Floats]:
        """Lowest and highest coordinates, (3,) each."""
        columns = self.points.T
        return np.array([x.min() for x in columns]), np.array([x.max() for x in columns])

    @cached_property
    def single(self) -> dict[str, NDArray[np.float32]]:
        """Points, normals and scalars as the renderer takes them."""
        arrays = (("points", self.points), ("normals", self.normals), ("scalars", self.scalars))
        return {name: np.array(x, dtype=np.float32, order="C") for name, x in arrays if x is not None}

    @cached_property
    def pick_mesh(self) -> PickMesh:
        """Its triangles, ready for rays."""
        return PickMesh(self.points, self.cells)

    def load(self) -> None:
        """Compute, in whatever thread this is, what showing will need."""
        if len(self.points):
            _ = self.bounds, self.single

    def prepare(self) -> None:
        """Compute, in whatever thread this is, what showing and pointing will need."""
        self.load()
        if len(self.points) and self.kind == "surface":
            _ = self.pick_mesh


@dataclass(frozen=True)
class Panel:
    """What one view shows: a key, the words over it, and its layers."""

    key: str
    title: str
    subtitle: str
    layers: tuple[Layer, ...]


@dataclass(frozen=True)
class LayerInfo:
    """A row of the list of layers, as menus and check boxes show it."""

    id: str
    title: str
    visible: bool
    tooltip: str
    ink: Ink


GREY = Ink("#c3c8ce", "#8b929a")
STEEL = Ink("#7f9cc0", "#7d9dc6")
INK = Ink("#2c3540", "#e8edf2")
VIOLET = Ink("#7d6bb3", "#a795e0")
SAGE = Ink("#5f9c85", "#7cc4a6")
CYAN = Ink("#2f9fb8", "#58c4da")
MAGENTA = Ink("#c2185b", "#ff5c9a")
PURPLE = Ink("#5b34a8", "#b79bff")
GREEN = Ink("#15803d", "#5fd68b")
MINT = Ink("#1fa58f", "#3cc9b0")
GRAPHITE = Ink("#4a5663", "#b9c3cd")
VERMILLION = Ink("#c4501b", "#ee8a4e")

LAYERS: tuple[LayerInfo, ...] = (
    LayerInfo("deviation", "Coloured flanks", True, "CAD flanks coloured by deviation or curvature", VERMILLION),
    LayerInfo("cad_flank", "CAD flanks", False, "Both flanks as the method made them, in one colour", STEEL),
    LayerInfo("theory_flank", "Theoretical flank", False, "The exact flank, translucent", MINT),
    LayerInfo("sections", "Sections", False, "Heel and toe profiles, sections and positions used", INK),
    LayerInfo("guides", "Guide curves", False, "Curves along the tooth that guide the surface", GREEN),
    LayerInfo("points", "Points, U and V lines", False, "Points of the exact flank on U and V lines", GRAPHITE),
    LayerInfo("combs", "Curvature combs", False, "Teeth as long as the CAD flank is curved", GREEN),
    LayerInfo("normals", "Normals", False, "Arrows along the normals of the CAD flanks", INK),
    LayerInfo(
        "generating_line", "Generating line", False, "The line in the plane, and the flank it has swept", MAGENTA
    ),
    LayerInfo("tangent_plane", "Tangent plane", False, "Circular plane of radius R that rolls on the base cone", CYAN),
    LayerInfo("base_spiral", "Base-cone spiral", False, "Where the involutes start on the base cone", PURPLE),
    LayerInfo("base_cone", "Base cone", False, "The cone on which the plane rolls", VIOLET),
    LayerInfo("pitch_cone", "Pitch cone", False, "The cone that rolls on the mate's", SAGE),
    LayerInfo("tooth", "One tooth", True, "Tip, fillets, root and ends of the tooth, in light grey", GREY),
    LayerInfo("gear", "All teeth", True, "The other teeth and the body, in light grey", GREY),
)

SOLID = "solid"
"""Layers of whole gears: drawn whenever they are there, whatever the switches say."""

DEFAULT_VISIBLE = frozenset(info.id for info in LAYERS if info.visible)

LAYER_SETS: tuple[tuple[str, frozenset[str]], ...] = (
    ("Deviation", DEFAULT_VISIBLE),
    ("Generation", frozenset({"generating_line", "tangent_plane", "base_spiral", "base_cone", "tooth"})),
    ("Construction", frozenset({"cad_flank", "sections", "guides", "points", "tooth"})),
)

TOOTH_WHOLE, TOOTH_BARED, TOOTH_WALLS = "whole", "bared", "walls"
"""The parts of the layer ``tooth``: with its flanks in grey and its fillets, or open for flanks drawn otherwise;
and the sides and floor that close it where no other teeth do."""

_FLANK_IDS = frozenset({"deviation", "cad_flank", "theory_flank"})


def drawn(layers: Iterable[Layer], visible: Collection[str]) -> tuple[Layer, ...]:
    """The layers to draw when the given ids are switched on.

    Most follow their own switch. Three rules keep one surface from covering another in the same place:
    the deviation map takes the place of the plain CAD flank; the tooth leaves out its own flanks when they are drawn
    otherwise; and the tooth belongs to the whole gear as well.
    """
    layers = tuple(layers)
    wanted, present = {*visible, SOLID}, {layer.layer_id for layer in layers}
    if "gear" in wanted:
        wanted.add("tooth")
    if {"deviation"} & wanted & present:
        wanted.discard("cad_flank")
    hidden = {("tooth", TOOTH_WHOLE if _FLANK_IDS & wanted & present else TOOTH_BARED)}
    if {"gear"} & wanted & present:
        hidden.add(("tooth", TOOTH_WALLS))
    return tuple(x for x in layers if x.layer_id in wanted and (x.layer_id, x.part) not in hidden)
