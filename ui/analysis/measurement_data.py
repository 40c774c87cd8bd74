"""Points of a file and what came out of measuring them; no widget."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from gearstudio.analysis.measurement import MeasuredPoints, MeasurementResult, measure
from gearstudio.design import Design
from gearstudio.exchange.measured import read_measured
from gearstudio.theory.cones import MemberGeometry, PairGeometry

READING = 0.5
"""Part of the work that reading a file of points is."""
ALL_TEETH = -1


@dataclass(frozen=True)
class Source:
    """Where points come from.

    Attributes
    ----------
    path : Path
    chunks : tuple of MeasuredPoints, or None
        None until they are read.
    shift : float
        About where the apex lies on the axis [mm].
    faces : (int, int), optional
        Of a CAD model: faces that are flanks, and all.
    """

    path: Path
    chunks: tuple[MeasuredPoints, ...] | None = None
    shift: float = 0.0
    faces: tuple[int, int] | None = None


@dataclass(frozen=True)
class Measurement:
    """A source with its points read, what they were compared with, and the outcome."""

    source: Source
    member: MemberGeometry
    result: MeasurementResult
    teeth: tuple[int, ...]


def measured(
    design: Design,
    pair: PairGeometry,
    member: str,
    source: Source,
    fit: tuple[bool, bool],
    report: Callable[[str, float], None],
) -> Measurement:
    """Read a source, unless it is read, and compare it with a member.

    Raises
    ------
    FileError, GeometryError
        The file cannot be used, or the points are not of this gear; with the reason.
    """
    begun = 0.0
    if source.chunks is None:
        chunks = tuple(read_measured(source.path, lambda part: report("reading", READING * part)))
        source, begun = replace(source, chunks=chunks), READING
    result = measure(
        pair,
        member,
        source.chunks or (),
        turn=fit[0],
        shift=fit[1],
        start_shift=source.shift,
        design=design,
        report=lambda stage, part: report(stage, begun + (1 - begun) * part),
    )
    return Measurement(source, pair.member(member), result, tuple(np.unique(result.tooth).tolist()))
