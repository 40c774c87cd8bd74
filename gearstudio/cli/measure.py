"""``measure``: measured points against the theory."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from gearstudio.cli.output import STANDARD_OUTPUT, Progress, problem, table, write_json
from gearstudio.errors import GeometryError
from gearstudio.project import open_design
from gearstudio.theory.cones import PairGeometry, pair_geometry

if TYPE_CHECKING:
    from gearstudio.analysis.measurement import MeasuredPoints, MeasurementResult

UNUSABLE_INPUT = 2
_READING = 0.2


def run(args: argparse.Namespace) -> int:
    """Carry the command out; the exit status is 2 when the points are not of this gear."""
    from gearstudio.analysis.measurement import measure

    design = open_design(args.design)
    pair = pair_geometry(design)
    progress = Progress()
    fit = {"turn": not args.no_turn, "shift": not args.no_shift}
    try:
        chunks, start = _points(args, pair, lambda stage, part: progress(stage, _READING * part))
        result = measure(pair, args.member, chunks, **fit, start_shift=start, design=design, report=progress)
    except GeometryError as error:
        progress.clear()
        problem(f"{args.points}: {error}")
        return UNUSABLE_INPUT
    finally:
        progress.clear()
    for warning in result.warnings:
        problem(f"{args.points}: warning: {warning}")
    if args.json != STANDARD_OUTPUT:
        print(_text(result))
    if args.json is not None:
        write_json(args.json, measurement_record(result))
    return 0


def _points(
    args: argparse.Namespace, pair: PairGeometry, report: Callable[[str, float], None]
) -> tuple[Iterable[MeasuredPoints], float]:
    """The points of a file, or of the flanks in a STEP file, and about where on the axis the apex lies."""
    from gearstudio.exchange.measured import is_model, read_measured

    if not is_model(args.points):
        return read_measured(args.points, lambda part: report("reading", part)), 0.0
    from gearstudio.exchange.measured_step import sample_step

    found = sample_step(Path(args.points), pair, args.member, args.spacing, report)
    return [found.points], found.shift


def measurement_record(result: MeasurementResult) -> dict[str, Any]:
    """A measurement as plain values, as interface.md nests them."""
    return {
        "count": len(result.points),
        "beside": result.beside,
        "best_fit": {"rotation_deg": float(np.degrees(result.pose.turn)), "axial_mm": result.pose.shift},
        "max_um": result.statistics.max_um,
        "mean_um": result.statistics.mean_um,
        "rms_um": result.statistics.rms_um,
        "warnings": [{"code": w.code, "field": w.field, "message": w.message} for w in result.warnings],
        "flanks": {
            name: {
                "spiral_angle_error_um": form.spiral_um,
                "spiral_angle_error_deg": form.spiral_deg,
                "pressure_angle_error_um": form.pressure_um,
                "lengthwise_crown_um": form.lengthwise_crown_um,
                "profile_crown_um": form.profile_crown_um,
                "bias_um": form.bias_um,
                "pitch": {
                    "tooth": result.pitch[name].tooth,
                    "cumulative_um": result.pitch[name].cumulative_um,
                    "single_um": result.pitch[name].single_um,
                    "total_um": result.pitch[name].total_um,
                    "largest_single_um": result.pitch[name].largest_single_um,
                },
            }
            for name, form in result.form.items()
        },
        "points": [
            {"xyz": xyz, "deviation_um": deviation, "flank": flank, "tooth": tooth}
            for xyz, deviation, flank, tooth in zip(
                result.points.tolist(), result.deviation_um.tolist(), result.flanks, result.tooth.tolist(), strict=True
            )
        ],
    }


def _text(result: MeasurementResult) -> str:
    flanks = list(result.form)
    forms, pitches = [result.form[name] for name in flanks], [result.pitch[name] for name in flanks]
    summary = [
        ("points", f"{len(result.points)}", ""),
        ("left out beside the flanks", f"{result.beside}", ""),
        ("turned by", f"{np.degrees(result.pose.turn):.6f}", "°"),
        ("shifted by", f"{result.pose.shift:.6f}", "mm"),
        ("largest deviation", f"{result.statistics.max_um:.3f}", "µm"),
        ("mean deviation", f"{result.statistics.mean_um:.3f}", "µm"),
        ("rms deviation", f"{result.statistics.rms_um:.3f}", "µm"),
    ]
    errors = [
        ("µm", *flanks),
        ("spiral-angle error, heel to toe", *(f"{form.spiral_um:.3f}" for form in forms)),
        ("pressure-angle error, tip to root", *(f"{form.pressure_um:.3f}" for form in forms)),
        ("lengthwise crowning", *(f"{form.lengthwise_crown_um:.3f}" for form in forms)),
        ("profile crowning", *(f"{form.profile_crown_um:.3f}" for form in forms)),
        ("bias", *(f"{form.bias_um:.3f}" for form in forms)),
        ("total cumulative pitch error", *(f"{pitch.total_um:.3f}" for pitch in pitches)),
        ("largest single pitch error", *(f"{pitch.largest_single_um:.3f}" for pitch in pitches)),
    ]
    return f"{result.member}\n\n{table(summary, (0, 2))}\n\n{table(errors)}"
