"""What a report is made of: everything that has to be computed for the sections wanted."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import TypeVar

from gearstudio.analysis.comparison import build_variant
from gearstudio.analysis.contact import contact_analysis
from gearstudio.analysis.contact_result import ContactResult
from gearstudio.analysis.convergence import ConvergenceStudy, convergence_point, convergence_study
from gearstudio.analysis.datasheet import DataSheet, data_sheet
from gearstudio.catalogue import MEMBERS, METHOD_IDS, VARIANTS, MemberName, Variant
from gearstudio.design import Design
from gearstudio.errors import GearStudioError, Issue
from gearstudio.report.exports import Exported, exports_in
from gearstudio.report.language import told
from gearstudio.report.measuring import Measured, MeasuredFile, compared
from gearstudio.results import VariantResult
from gearstudio.theory.cones import PairGeometry, pair_geometry
from gearstudio.validation import check

Report = Callable[[str, float], None]
Key = tuple[MemberName, str, Variant]
T = TypeVar("T")

_BUILT_FOR = {"comparison", "deviation", "curvature", "topography"}
_PATIENCE_S = 1.0
_SAMPLES = (49, 49)
_COUNTS = (4, 6, 8, 11, 15, 21, 30)


@dataclass(frozen=True)
class Content:
    """A design and what was computed from it.

    Attributes
    ----------
    results : mapping of (member, method, variant) to VariantResult
        Those that could be built; the reasons for the others are in `failures`.
    sheet, contact : None where the section is not wanted or the geometry does not allow it.
    folder, exports :
        Where the project is, if it is saved, and the exports with a record there.
    measured :
        Measured points against this design; None where there are none or where they are of another gear.
    warnings :
        What is doubtful about the design.
    """

    design: Design
    pair: PairGeometry
    member: MemberName
    results: Mapping[Key, VariantResult] = field(default_factory=dict)
    failures: Mapping[Key, str] = field(default_factory=dict)
    sheet: DataSheet | None = None
    contact: ContactResult | None = None
    studies: tuple[ConvergenceStudy, ...] = ()
    notes: tuple[str, ...] = ()
    folder: Path | None = None
    exports: tuple[Exported, ...] = ()
    measured: Measured | None = None
    warnings: tuple[Issue, ...] = ()


@dataclass(frozen=True)
class Beside:
    """What else goes into a report: the project's folder with its exports, measured points."""

    folder: Path | None = None
    measured: MeasuredFile | Measured | None = None


def gather(
    design: Design, member: MemberName, sections: Collection[str], report: Report, beside: Beside | None = None
) -> Content:
    """Compute what the sections need; a part that fails is noted and leaves the others alone."""
    pair, beside = pair_geometry(design), beside or Beside()
    results: dict[Key, VariantResult] = {}
    failures: dict[Key, str] = {}
    if _BUILT_FOR & set(sections):
        keys: list[Key] = [(m, method, v) for m in MEMBERS for method in METHOD_IDS for v in VARIANTS]
        for index, key in enumerate(keys):
            report(f"building {key[0]}, {key[1]}, {key[2]}", 0.5 * index / len(keys))
            try:
                results[key] = build_variant(design, *key, _SAMPLES)
            except GearStudioError as error:
                failures[key] = str(error)
    notes: list[str] = []
    report("geometry data sheet", 0.5)
    sheet = _tried(lambda: data_sheet(design), notes) if "sheet" in sections else None
    report("tooth contact", 0.55)
    contact = _tried(lambda: contact_analysis(pair), notes) if "contact" in sections else None
    report("convergence", 0.58)
    studies = _studies(design, member) if "convergence" in sections else ()
    exports = exports_in(beside.folder, design) if "exports" in sections else ()
    file = beside.measured if "measurement" in sections else None
    measured = None if file is None else _tried(lambda: compared(design, pair, file), notes)
    return Content(
        design, pair, member, results, failures, sheet, contact, studies, tuple(notes), beside.folder, exports,
        measured, check(design, _PATIENCE_S),
    )  # fmt: skip


def _studies(design: Design, member: MemberName) -> tuple[ConvergenceStudy, ...]:
    return tuple(
        convergence_study(method, partial(convergence_point, design, member, method, repetitions=1), _COUNTS)
        for method in METHOD_IDS
    )


def _tried(make: Callable[[], T], notes: list[str]) -> T | None:
    try:
        return make()
    except GearStudioError as error:
        notes.append(told(error))
        return None
