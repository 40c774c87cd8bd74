"""Layers of whole gears for the views, alone or as a pair in mesh; plain arrays, no renderer."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from gearstudio.theory.cones import PairGeometry
from gearstudio.theory.pair import placement
from gearstudio.theory.place import Place
from ui import layers as look
from ui.layers import SOLID, Ink, Layer, Style
from ui.meshes import Mesh, placed
from ui.section import Plane, filled, outline
from ui.solid_scene import GearMesh
from ui.tooth_mesh import context_layers

Level = Literal["fine", "coarse"]


@dataclass(frozen=True)
class Paint:
    """Colours of a member: its machined faces, its flanks, what is cut through."""

    body: Ink
    flank: Ink
    cut: Ink


PAINTS = {
    "pinion": Paint(Ink("#c2b190", "#b39f7a"), Ink("#d3c19c", "#c6b086"), Ink("#dcb876", "#c2994e")),
    "wheel": Paint(Ink("#aab6c4", "#8f9dae"), Ink("#bac7d6", "#a0afc2"), Ink("#9db6d6", "#6f8db4")),
}
_MAP = Ink("#e9e9e9", "#d9d9d9")
_EDGE = Ink("#2f3843", "#0f1318")


@dataclass(frozen=True)
class SolidOptions:
    """What of a solid is shown."""

    edges: bool = True
    deviation: bool = False


@dataclass(frozen=True, eq=False)
class PlacedGear:
    """A gear's fine and coarse mesh in the frame of the view, before anything turns."""

    member: str
    fine: GearMesh
    coarse: GearMesh

    def level(self, level: str) -> tuple[Mesh, ...]:
        """The meshes of a level, which close each other."""
        mesh = self.coarse if level == "coarse" else self.fine
        return mesh.flanks, mesh.teeth, mesh.body


def base_place(pair: PairGeometry, member: str) -> Place:
    """Where a member stands in the world at turn 0 of the pinion (theory 8)."""
    return Place(*placement(pair, member))


def motion(pair: PairGeometry, member: str, pinion_turn: float) -> Place:
    """How a placed member moves in the world when the pinion turns."""
    return Place(*placement(pair, member, pinion_turn)).after(base_place(pair, member).inverse)


def put(gear: PlacedGear, place: Place) -> PlacedGear:
    """A gear in another frame."""
    return replace(gear, fine=_moved(gear.fine, place), coarse=_moved(gear.coarse, place))


def _moved(mesh: GearMesh, place: Place) -> GearMesh:
    flanks, teeth, body = (placed(part, place) for part in (mesh.flanks, mesh.teeth, mesh.body))
    edges, corners, midpoints = (place.of(points) for points in (mesh.edges, mesh.corners, mesh.midpoints))
    return GearMesh(flanks, teeth, body, mesh.deviation_um, edges, mesh.segments, corners, midpoints)


def gear_layers(gear: PlacedGear, options: SolidOptions) -> tuple[Layer, ...]:
    """Both levels of a gear."""
    made: list[Layer] = []
    levels: tuple[tuple[Level, GearMesh], ...] = (("fine", gear.fine), ("coarse", gear.coarse))
    for level, mesh in levels:
        made += _surfaces(gear.member, level, mesh, options)
        if options.edges:
            style = Style(_EDGE, width=1.2 if level == "fine" else 1.0, lift=4)
            name = f"{gear.member} edges {level}"
            made.append(Layer(SOLID, name, "lines", mesh.edges, style, mesh.segments, body=gear.member, level=level))
    return tuple(made)


def _surfaces(member: str, level: Level, mesh: GearMesh, options: SolidOptions) -> list[Layer]:
    paint = PAINTS[member]
    plain = Style(paint.body, gloss=0.22, inside=paint.cut)
    colored = Style(_MAP, gloss=0.06, inside=paint.cut)
    flank = colored if options.deviation else Style(paint.flank, gloss=0.35, inside=paint.cut)
    made = []
    for role, part, style in (("flanks", mesh.flanks, flank), ("teeth", mesh.teeth, plain), ("body", mesh.body, plain)):
        scalars = mesh.deviation_um if role == "flanks" and options.deviation else None
        name = f"{member} {role} {level}"
        made.append(Layer(SOLID, name, "surface", part.points, style, part.cells, part.normals, scalars, member, level))
    return made


def preview_layers(pair: PairGeometry, member: str, in_mesh: bool) -> tuple[Layer, ...]:
    """The teeth of theory, in place of a solid that is still being built."""
    place = base_place(pair, member) if in_mesh else Place()
    made = []
    for layer in context_layers(pair.member(member)):
        if (layer.layer_id, layer.part) in (("tooth", look.TOOTH_WHOLE), ("gear", "teeth")):
            style = Style(PAINTS[member].body, gloss=0.1)
            points, normals = place.of(layer.points), layer.normals @ place.matrix.T
            name = f"{member} preview {layer.layer_id}"
            made.append(Layer(SOLID, name, "surface", points, style, layer.cells, normals, body=member))
    return tuple(made)


def cut_layers(gears: Sequence[tuple[str, tuple[Mesh, ...], Place]], plane: Plane) -> tuple[Layer, ...]:
    """The faces that a section plane lays open, with their outlines.

    Parameters
    ----------
    gears : sequence of (member, meshes, place)
        Meshes that close each other, and where they have moved.
    plane : Plane
    """
    made = []
    for member, meshes, place in gears:
        segments = outline([placed(mesh, place) for mesh in meshes], plane)
        if not len(segments):
            continue
        face = filled(segments, plane)
        style = Style(PAINTS[member].cut, flat=True, lift=5)
        made.append(Layer(SOLID, f"{member} cut", "surface", face.points, style, face.cells, face.normals))
        lines = np.arange(2 * len(segments)).reshape(-1, 2)
        edge = Style(look.INK, width=1.6, lift=8)
        made.append(Layer(SOLID, f"{member} cut edge", "lines", segments.reshape(-1, 3), edge, lines))
    return tuple(made)
