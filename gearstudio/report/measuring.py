"""Measured points that go into a report, and what comes out of comparing them with the design."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from gearstudio.analysis.measurement import MeasuredPoints, MeasurementResult, measure
from gearstudio.catalogue import MemberName
from gearstudio.design import Design
from gearstudio.theory.cones import PairGeometry


@dataclass(frozen=True)
class MeasuredFile:
    """Points as they were read.

    Attributes
    ----------
    name : str
        Of the file.
    member : {"pinion", "wheel"}
    chunks : tuple of MeasuredPoints
    fit : (bool, bool)
        Whether the best fit may turn the part about, and shift it along its axis.
    shift : float
        About where the apex lies on the axis [mm].
    faces : (int, int), optional
        Of a CAD model: faces that are flanks, and all.
    """

    name: str
    member: MemberName
    chunks: tuple[MeasuredPoints, ...]
    fit: tuple[bool, bool] = (True, True)
    shift: float = 0.0
    faces: tuple[int, int] | None = None


@dataclass(frozen=True)
class Measured:
    """A file and the outcome."""

    file: MeasuredFile
    result: MeasurementResult


def read_file(path: Path, pair: PairGeometry, member: MemberName, report: Callable[[str, float], None]) -> MeasuredFile:
    """The points of a file, or of the flanks in a STEP file.

    Raises
    ------
    FileError, GeometryError
        The file cannot be used, with the reason.
    """
    from gearstudio.exchange.measured import is_model, read_measured

    if not is_model(path):
        chunks = tuple(read_measured(path, lambda part: report("reading", part)))
        return MeasuredFile(path.name, member, chunks)
    from gearstudio.exchange.measured_step import sample_step

    found = sample_step(path, pair, member, None, report)
    return MeasuredFile(path.name, member, (found.points,), shift=found.shift, faces=(found.flank_faces, found.faces))


def compared(design: Design, pair: PairGeometry, given: MeasuredFile | Measured) -> Measured:
    """Measured points held against the design, unless they are already.

    Raises
    ------
    GeometryError
        They are not of this gear, with the reason.
    """
    if isinstance(given, Measured):
        return given
    turn, shift = given.fit
    result = measure(pair, given.member, given.chunks, turn=turn, shift=shift, start_shift=given.shift, design=design)
    return Measured(given, result)
