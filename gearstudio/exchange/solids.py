"""A tooth, a gear or a pair of a design as files, whatever the format, and files held against it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from gearstudio.catalogue import MEMBERS, Variant
from gearstudio.checks import FileCheck
from gearstudio.design import Design
from gearstudio.errors import GeometryError, ModellingError
from gearstudio.exchange.meshes import MeshPart, read_meshes, write_meshes
from gearstudio.exchange.proof import Wanted, wanted
from gearstudio.exchange.reading import check_meshes, check_shape
from gearstudio.formats import MESH_FORMATS, USUAL, ExportOptions
from gearstudio.kernel.cutting import Face, Report, Solid
from gearstudio.kernel.document import Part
from gearstudio.kernel.exchange import read_shape
from gearstudio.kernel.solids import solid_volume
from gearstudio.kernel.writing import write_solids
from gearstudio.methods.gear import Gear, blank_sizes, build_gear, design_tooth, ignore, target_of
from gearstudio.methods.gear_mesh import gear_mesh, tooth_mesh
from gearstudio.methods.single import tooth_names, tooth_solid
from gearstudio.methods.tooth import Tooth
from gearstudio.results import Mesh
from gearstudio.theory.blank import blank_outline
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.modified import flank_of
from gearstudio.theory.pair import placement
from gearstudio.theory.place import Place

Floats = NDArray[np.float64]

_CHORD_SHARE = 1e-4
_SAMPLES = (41, 41)
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
    options : ExportOptions
    """

    design: Design
    member: str
    part: str
    method: str
    variant: Variant
    construction: str = "assemble"
    options: ExportOptions = USUAL
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
            write_meshes(path, self._meshes, format_, self.options)
        else:
            write_solids(path, self.name, self.solids(ignore), format_, self.options)
        check = self.check(path, format_)
        check.require(path)
        return check

    def check(self, path: Path, format_: str) -> FileCheck:
        """Hold a file against what it should be.

        Raises
        ------
        BlankError, ModellingError
            The part cannot be built.
        FileError
            The file cannot be read.
        """
        return replace(self._checked(path, format_), remarks=self._remarks)

    def _checked(self, path: Path, format_: str) -> FileCheck:
        if format_ in MESH_FORMATS:
            counts = [len(part.mesh.triangles) for part in self._meshes]
            chord = max(self._chord(self._tooth(name)) for name in self._members)
            return check_meshes(read_meshes(path, format_, counts), format_, self._meshes, self._wanted, chord)
        return check_shape(read_shape(path, format_), format_, self.solids(ignore), self._wanted)

    @property
    def _remarks(self) -> tuple[str, ...]:
        """Of each member whose flanks are others than those of the design, by how much."""
        found = []
        for name in self._members:
            member = pair_geometry(self.design).member(name)
            missed = [
                float(np.abs(flank_of(member, flank).deviation(built.surface.uniform_grid(*_SAMPLES))).max())
                for flank in FLANKS
                if (built := self._tooth(name).constructions[flank]).instead is not None
            ]
            if missed:
                found.append(
                    f"the {name}'s flanks are up to {1e3 * max(missed):.4g} µm from those of the design, which a "
                    "rotating line cannot sweep; the faces are held against the flanks that it does sweep"
                )
        return tuple(found)

    def solids(self, report: Report) -> list[Part]:
        """The solids with names and places."""
        if not self._solids:
            self._solids = [self._solid(name, report) for name in self._members]
        return self._solids

    @property
    def _members(self) -> tuple[str, ...]:
        return MEMBERS if self.member == "pair" else (self.member,)

    @cached_property
    def _meshes(self) -> list[MeshPart]:
        return [MeshPart(name, self._mesh(name), self._place(name)) for name in self._members]

    @cached_property
    def _wanted(self) -> list[Wanted]:
        tolerance, single = self.design.methods.tolerance_um, self.part == "tooth"
        return [
            wanted(self._tooth(name), None if single else self._outline(name), self._place(name), tolerance, single)
            for name in self._members
        ]

    def _solid(self, name: str, report: Report) -> Part:
        if self.part == "tooth":
            tooth = self._tooth(name)
            shell = tooth_solid(tooth, target_of(self.design, tooth.member))
            return self._part(name, shell.solid, tooth_names(tooth, shell))
        gear: Gear = build_gear(self.design, name, self.method, self.variant, self.construction, report)
        self._teeth[name] = gear.tooth
        return self._part(name, gear.solid, gear.faces)

    def _part(self, name: str, solid: Solid, faces: tuple[tuple[str, Face], ...]) -> Part:
        place = self._place(name) if self.member == "pair" else None
        return Part(name, solid, solid_volume(solid), faces, _COLORS[name], _FLANK_COLORS, place)

    def _tooth(self, name: str) -> Tooth:
        if name not in self._teeth:
            self._teeth[name] = design_tooth(self.design, name, self.method, self.variant)
        return self._teeth[name]

    def _outline(self, name: str) -> Floats:
        return blank_outline(self._tooth(name).member, blank_sizes(self.design, name)).points

    def _chord(self, tooth: Tooth) -> float:
        return self.options.chord if self.options.chord is not None else _CHORD_SHARE * tooth.member.outer_cone_distance

    def _mesh(self, name: str) -> Mesh:
        tooth = self._tooth(name)
        angle = np.pi if self.options.angle_deg is None else float(np.radians(self.options.angle_deg))
        make: Callable[[float, float], Mesh] = (
            (lambda chord, bend: tooth_mesh(tooth, chord, bend))
            if self.part == "tooth"
            else (lambda chord, bend: gear_mesh(tooth, self._outline(name), chord, bend))
        )
        try:
            return make(self._chord(tooth), angle)
        except GeometryError as error:
            raise ModellingError(self.method, f"meshing of the {name}", str(error)) from error

    def _place(self, name: str) -> Place:
        return Place(*placement(pair_geometry(self.design), name)) if self.member == "pair" else Place()
