"""A tooth, a gear or a pair of a design as files, whatever the format."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from gearstudio.catalogue import MEMBERS, Variant
from gearstudio.design import Design
from gearstudio.exchange.meshes import MESH_FORMATS, MeshPart, write_meshes
from gearstudio.kernel.cutting import Face, Report, Solid
from gearstudio.kernel.document import Part
from gearstudio.kernel.exchange import SOLID_FORMATS, write_solids
from gearstudio.kernel.solids import solid_volume
from gearstudio.methods.gear import Gear, blank_sizes, build_gear, design_tooth, ignore, target_of
from gearstudio.methods.gear_mesh import gear_mesh, tooth_mesh
from gearstudio.methods.single import tooth_names, tooth_solid
from gearstudio.methods.tooth import Tooth
from gearstudio.results import FileCheck, Mesh
from gearstudio.theory.blank import blank_outline
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.pair import pinion_placement, wheel_placement

Floats = NDArray[np.float64]

FORMATS = (*SOLID_FORMATS, *MESH_FORMATS)
_CHORD_SHARE = 1e-4
_COLORS = {"pinion": (0.80, 0.74, 0.62), "wheel": (0.66, 0.72, 0.80)}
_FLANK_COLORS = (("concave", (0.20, 0.45, 0.75)), ("convex", (0.82, 0.45, 0.20)))


@dataclass
class Product:
    """What is exported, built when a format first needs it.

    Attributes
    ----------
    member : {"pinion", "wheel", "pair"}
    part : {"tooth", "gear"}
    construction : {"assemble", "cut"}
        Of the solids; meshes are of the same surfaces either way.
    chord : float or None
        Farthest that triangles may lie from the surfaces [mm]; by default 1e-4 of the outer cone distance.
    """

    design: Design
    member: str
    part: str
    method: str
    variant: Variant
    construction: str = "assemble"
    chord: float | None = None
    _solids: list[Part] = field(default_factory=list)
    _teeth: dict[str, Tooth] = field(default_factory=dict)

    @property
    def name(self) -> str:
        """As files and products are called."""
        return f"{self.member}-{self.part}"

    def write(self, path: Path, format_: str) -> FileCheck:
        """Write a file, read it back and say what was found.

        Raises
        ------
        BlankError, ModellingError
            It cannot be built.
        FileError, OSError
            It cannot be written, or is not the same when read back.
        """
        if format_ in MESH_FORMATS:
            parts = [MeshPart(name, self._mesh(name), self._placement(name)) for name in self._members]
            return write_meshes(path, parts, format_)
        return write_solids(path, self.name, self.solids(ignore), format_)

    def solids(self, report: Report) -> list[Part]:
        """The solids with names and places."""
        if not self._solids:
            self._solids = [self._solid(name, report) for name in self._members]
        return self._solids

    @property
    def _members(self) -> tuple[str, ...]:
        return MEMBERS if self.member == "pair" else (self.member,)

    def _solid(self, name: str, report: Report) -> Part:
        if self.part == "tooth":
            tooth = self._tooth(name)
            shell = tooth_solid(tooth, target_of(self.design, tooth.member))
            return self._part(name, shell.solid, tooth_names(tooth, shell))
        gear: Gear = build_gear(self.design, name, self.method, self.variant, self.construction, report)
        self._teeth[name] = gear.tooth
        return self._part(name, gear.solid, gear.faces)

    def _part(self, name: str, solid: Solid, faces: tuple[tuple[str, Face], ...]) -> Part:
        placement = self._placement(name) if self.member == "pair" else None
        return Part(name, solid, solid_volume(solid), faces, _COLORS[name], _FLANK_COLORS, placement)

    def _tooth(self, name: str) -> Tooth:
        if name not in self._teeth:
            self._teeth[name] = design_tooth(self.design, name, self.method, self.variant)
        return self._teeth[name]

    def _mesh(self, name: str) -> Mesh:
        tooth = self._tooth(name)
        chord = self.chord if self.chord is not None else _CHORD_SHARE * tooth.member.outer_cone_distance
        if self.part == "tooth":
            return tooth_mesh(tooth, chord)
        return gear_mesh(tooth, blank_outline(tooth.member, blank_sizes(self.design, name)).points, chord)

    def _placement(self, name: str) -> Floats:
        if self.member != "pair":
            return np.eye(3)
        pair = pair_geometry(self.design)
        return pinion_placement(pair) if name == "pinion" else wheel_placement(pair)
