"""The two working flanks of a tooth as a STEP file that is read back."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from gearstudio.errors import FileError
from gearstudio.kernel.step import read_flanks_step, write_flanks_step
from gearstudio.nurbs import NurbsSurface

_READ_BACK_MM = 1e-6


def write_checked_flanks(path: Path, surfaces: Mapping[str, NurbsSurface], name: str) -> None:
    """Write the flanks and make sure that the file holds them; FileError when it does not."""
    write_flanks_step(path, surfaces, name)
    read = read_flanks_step(path)
    if set(read) != set(surfaces):
        raise FileError(path, "the file is not complete after writing; the disk may be full")
    for flank, surface in surfaces.items():
        if np.abs(read[flank].uniform_grid(9, 9) - surface.uniform_grid(9, 9)).max() > _READ_BACK_MM:
            raise FileError(path, f"the {flank} flank is not the same after reading the file back")
