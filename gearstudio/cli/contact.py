"""``contact``: the tooth contact analysis, for drive and coast."""

from __future__ import annotations

import argparse
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from gearstudio.analysis.contact_placing import Misalignment
from gearstudio.cli.numbers import echoed, number, numbers
from gearstudio.cli.output import STANDARD_OUTPUT, problem, table, write_json
from gearstudio.errors import GeometryError
from gearstudio.project import open_design
from gearstudio.theory.cones import PairGeometry, pair_geometry

if TYPE_CHECKING:
    from gearstudio.analysis.contact_result import ContactResult, FlankContact

TABLE_SHAPE = (50, 30)
PINIONS = ("conjugate", "own_cone")
UNUSABLE_INPUT = 2


def misalignment(text: str) -> Misalignment:
    """Four numbers ``E,P,G,S`` as a misalignment; raises ArgumentTypeError."""
    found = numbers(text, 4)
    if len(found) != 4 or not np.all(np.isfinite(found)):
        raise argparse.ArgumentTypeError(f"{echoed(text)} is not E,P,G,S: three lengths in mm and an angle in degrees")
    return Misalignment(*found)


def thickness(text: str) -> float:
    """A thickness of the marking compound [µm]; raises ArgumentTypeError."""
    value = number(text)
    if not 0 < value < np.inf:
        raise argparse.ArgumentTypeError(f"{echoed(text)} is not a thickness in µm; use more than 0")
    return value


def run(args: argparse.Namespace) -> int:
    """Carry the command out; the exit status is 2 when the flanks do not meet at all."""
    from gearstudio.analysis.contact import contact_analysis

    design = open_design(args.design)
    pair = pair_geometry(design)
    if args.pinion == "own_cone":
        if not pair.has_offset:
            problem(
                "--pinion: without an offset the pinion on base cones of its own is the conjugate one; leave it out"
            )
            return UNUSABLE_INPUT
        pair = replace(pair, own_cone_pinion=True)
    try:
        result = contact_analysis(pair, args.misalign, thickness_um=args.thickness)
    except GeometryError as error:
        problem(f"--misalign: {error}" if args.misalign else f"{args.design}: {error}")
        return UNUSABLE_INPUT
    if args.json != STANDARD_OUTPUT:
        print(f"{design.name}\n\n{_text(result)}")
    for issue in result.warnings:
        problem(f"warning: {issue}")
    if args.json is not None:
        write_json(args.json, contact_record(pair, result))
    return 0


def contact_record(pair: PairGeometry, result: ContactResult) -> dict[str, Any]:
    """A contact analysis as plain values, as interface.md nests them."""
    placed = result.misalignment
    return {
        **_side(pair, result, result.drive),
        "coast": _side(pair, result, result.coast),
        "misalignment": {
            "E_mm": placed.offset,
            "P_mm": placed.pinion_axial,
            "G_mm": placed.wheel_axial,
            "S_deg": placed.shaft_angle_deg,
        },
        "thickness_um": result.thickness_um,
        "pinion": "own_cone" if pair.own_cone_pinion else "conjugate",
        "play_mm": result.play_mm,
        "warnings": [{"code": w.code, "field": w.field, "message": w.message} for w in result.warnings],
    }


def _side(pair: PairGeometry, result: ContactResult, side: FlankContact) -> dict[str, Any]:
    from gearstudio.analysis.contact import contact_table

    rho, delta, gap = contact_table(pair, result.misalignment, side, TABLE_SHAPE)
    return {
        "pinion_flank": side.pinion.flank,
        "transmission_error_arcsec": np.stack([side.turn_deg, side.error_arcsec], axis=-1),
        "peak_to_peak_arcsec": side.peak_to_peak_arcsec,
        "pattern": {"rho": rho, "delta_deg": np.degrees(delta), "gap_um": gap},
        "contact_ratio": side.contact_ratio,
        "pattern_share": side.pattern_share,
        "pattern_centre": list(side.pattern_centre),
        "path": {
            "pinion_angle_deg": side.path.turn_deg,
            "pinion": side.path.pinion_points,
            "wheel": side.path.wheel_points,
        },
        "edges": list(side.path.edges),
    }


def _text(result: ContactResult) -> str:
    sides = [result.drive, result.coast]
    rows = [
        ("", *(f"{side.direction} ({side.pinion.flank} pinion)" for side in sides)),
        ("transmission error, peak to peak", *(f"{side.peak_to_peak_arcsec:.4g}″" for side in sides)),
        ("contact ratio in mesh", *(f"{side.contact_ratio:.3f}" for side in sides)),
        (f"pattern at {result.thickness_um:g} µm", *(f"{side.pattern_share:.1%}" for side in sides)),
        ("its centre from the toe", *(f"{side.pattern_centre[0]:.1%}" for side in sides)),
        ("its centre from the root", *(f"{side.pattern_centre[1]:.1%}" for side in sides)),
        ("least ease-off", *(f"{side.ease_off_um.min():.3f} µm" for side in sides)),
        ("greatest ease-off", *(f"{side.ease_off_um.max():.3f} µm" for side in sides)),
    ]
    return f"{table(rows)}\n\nbacklash left: {result.play_mm:.4g} mm at the heel"
