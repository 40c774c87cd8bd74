"""The two working flanks of a tooth as a STEP file that is read back."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.comparison import build_variant
from gearstudio.catalogue import MemberName, Variant
from gearstudio.checks import FaceCheck, FileCheck
from gearstudio.design import Design
from gearstudio.formats import USUAL, ExportOptions
from gearstudio.kernel.exchange import kernel_version
from gearstudio.kernel.step import read_flanks_step, write_flanks_step
from gearstudio.nurbs import NurbsSurface
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.modified import flank_of

Floats = NDArray[np.float64]

_SAMPLES = (41, 41)
_READ_BACK_UM = 1e-3


@dataclass
class FlankProduct:
    """The flanks as a method makes them, built when first needed."""

    design: Design
    member: MemberName
    method: str
    variant: Variant
    options: ExportOptions = USUAL

    def write(self, path: Path, format_: str) -> FileCheck:
        """Write the flanks and make sure that the file holds them.

        Raises
        ------
        ModellingError
            The method could not make them.
        FileError
            They cannot be written, or are not the same when read back.
        """
        write_flanks_step(path, self._surfaces, f"{self.member}-flanks", self.options)
        check = self.check(path, format_)
        check.require(path)
        return check

    def check(self, path: Path, format_: str) -> FileCheck:
        """Hold a file against what it should be; FileError when it cannot be read."""
        found = read_flanks_step(path)
        deviations = tuple(
            FaceCheck(self.member, name, 1, self._from_theory(name, surface), self._limit(name))
            for name, surface in found.items()
            if name in self._surfaces
        )
        apart = [np.abs(_grid(found[name]) - _grid(own)).max() for name, own in self._surfaces.items() if name in found]
        points = np.concatenate([_grid(surface) for surface in found.values()] or [np.zeros((1, 3))])
        low, high = points.min(axis=0).tolist(), points.max(axis=0).tolist()
        return FileCheck(
            format=format_,
            valid=set(found) == set(self._surfaces),
            closed=False,
            solids=0,
            faces=len(found),
            volume=0.0,
            volume_error=0.0,
            box_error=float(max(apart, default=np.inf)),
            wanted_solids=0,
            box=((low[0], low[1], low[2]), (high[0], high[1], high[2])),
            deviations=deviations,
            kernel=kernel_version(),
        )

    @cached_property
    def _surfaces(self) -> dict[str, NurbsSurface]:
        result = build_variant(self.design, self.member, self.method, self.variant, (9, 9))
        return {name: made.surface for name, made in result.flanks.items()}

    def _from_theory(self, name: str, surface: NurbsSurface) -> float:
        flank = flank_of(pair_geometry(self.design).member(self.member), "concave" if name == "concave" else "convex")
        return 1e3 * float(np.abs(flank.deviation(_grid(surface))).max())

    def _limit(self, name: str) -> float:
        return self._from_theory(name, self._surfaces[name]) + _READ_BACK_UM


def _grid(surface: NurbsSurface) -> Floats:
    return surface.uniform_grid(*_SAMPLES).reshape(-1, 3)
