"""``compare``: every method and variant built, measured, and set side by side."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from gearstudio.catalogue import MEMBERS, METHOD_INFOS, VARIANTS
from gearstudio.cli.convergence import studies, study_records, study_text
from gearstudio.cli.output import STANDARD_OUTPUT, Progress, problem, table, write_json
from gearstudio.design import Design
from gearstudio.errors import ModellingError
from gearstudio.project import open_design

if TYPE_CHECKING:
    from gearstudio.results import Statistics, VariantResult

HEADINGS = ("Method", "Variant", "max µm", "mean µm", "rms µm", "poles", "degree", "seconds", "settings")


def run(args: argparse.Namespace) -> int:
    """Carry the command out; the exit status is 1 when a variant could not be made."""
    design = open_design(args.design)
    members = MEMBERS if args.member == "both" else (args.member,)
    progress, tolerance = Progress(), design.methods.tolerance_um
    try:
        compared, failures = compare(design, members, progress)
        studied = {name: studies(design, name, progress) for name in members if args.convergence}
    finally:
        progress.clear()
    if args.json != STANDARD_OUTPUT:
        for name in members:
            print(f"{name} of {design.name}\n\n{_text(compared[name])}\n")
        for name, found in studied.items():
            print(f"convergence, {name} of {design.name}\n\n{study_text(found, tolerance)}\n")
    if args.json is not None:
        records = {name: study_records(found, tolerance) for name, found in studied.items()}
        write_json(args.json, {"members": compared, **({"convergence": records} if records else {})})
    for line in failures:
        problem(line)
    return 1 if failures else 0


def compare(design: Design, members: tuple[str, ...], progress: Progress) -> tuple[dict[str, Any], list[str]]:
    """Records of every variant of every method of some members, as interface.md nests them, and what failed."""
    from gearstudio.analysis.comparison import build_variant

    work = [(member, info, variant) for member in members for info in METHOD_INFOS for variant in VARIANTS]
    compared: dict[str, Any] = {member: {info.id: {} for info in METHOD_INFOS} for member in members}
    failures = []
    for index, (member, info, variant) in enumerate(work):
        progress(f"{member}, {info.title}, {variant}", index / len(work))
        try:
            record = variant_record(build_variant(design, member, info.id, variant))
        except ModellingError as error:
            record = {"error": str(error)}
            failures.append(f"{member} {info.id} {variant}: {error}")
        compared[member][info.id][variant] = record
    return compared, failures


def variant_record(result: VariantResult) -> dict[str, Any]:
    """One variant's deviations and cost as plain values."""
    return {
        **_statistics(result.statistics),
        "edge_um": max(flank.edge_um for flank in result.flanks.values()),
        "seconds": result.seconds,
        "poles": list(result.poles),
        "degree": list(result.degree),
        "settings": dict(result.settings),
        "flanks": {
            name: {**_statistics(flank.statistics), "edge_um": flank.edge_um} for name, flank in result.flanks.items()
        },
    }


def _statistics(statistics: Statistics) -> dict[str, float]:
    return {
        "max_um": statistics.max_um,
        "mean_um": statistics.mean_um,
        "rms_um": statistics.rms_um,
        "lowest_um": statistics.lowest_um,
        "highest_um": statistics.highest_um,
    }


def _text(methods: dict[str, Any]) -> str:
    rows: list[tuple[str, ...]] = [HEADINGS]
    for info in METHOD_INFOS:
        rows += [(info.title, variant, *_cells(record)) for variant, record in methods[info.id].items()]
    return table(rows, (0, 1, 8))


def _cells(record: dict[str, Any]) -> tuple[str, ...]:
    if "error" in record:
        return "", "", "", "", "", "", f"failed: {record['error']}"
    deviations = (f"{record[key]:.4f}" for key in ("max_um", "mean_um", "rms_um"))
    sizes = (" × ".join(str(n) for n in record[key]) for key in ("poles", "degree"))
    settings = ", ".join(f"{key} {value}" for key, value in record["settings"].items())
    return *deviations, *sizes, f"{record['seconds']:.3f}", settings
