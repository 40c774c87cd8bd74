"""``info``: the geometry data sheet of both members, and warnings."""

from __future__ import annotations

import argparse
from dataclasses import asdict
from typing import Any

import numpy as np

from gearstudio.analysis.datasheet import DataSheet, data_sheet, sheet_text
from gearstudio.catalogue import MEMBERS
from gearstudio.cli.output import STANDARD_OUTPUT, table, write_json
from gearstudio.design import Design
from gearstudio.project import open_design
from gearstudio.theory.cones import MemberGeometry, PairGeometry, pair_geometry
from gearstudio.theory.fillet import fillet
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.hypoid.dimensions import dimensions
from gearstudio.theory.hypoid.pair import HypoidPair
from gearstudio.theory.modified import flank_member, flank_of
from gearstudio.theory.pair import overlap_ratio, tip_half_azimuth, transverse_contact_ratio
from gearstudio.validation import check

_OF_THE_TOOTH = (
    ("hand", "Hand", ""),
    ("tip_half_azimuth_deg", "Half tooth at the tip", "°"),
    ("theta_toe_deg", "Tooth turned at the toe", "°"),
    ("theta_heel_deg", "Tooth turned at the heel", "°"),
)
"""What the data sheet does not name."""


def run(args: argparse.Namespace) -> int:
    """Carry the command out; the exit status."""
    design = open_design(args.design)
    data = info(design)
    if args.json != STANDARD_OUTPUT:
        print(_text(design, data))
    if args.json is not None:
        write_json(args.json, data)
    return 0


def info(design: Design) -> dict[str, Any]:
    """The derived geometry of a design, as interface.md names it: mm, and degrees where a name ends in ``_deg``."""
    pair = pair_geometry(design)
    warnings = [{"code": w.code, "field": w.field, "message": w.message} for w in check(design)]
    members: dict[str, Any] = {name: member_info(pair.member(name)) for name in MEMBERS}
    return {**members, "pair": pair_info(pair), "datasheet": sheet_records(data_sheet(design)), "warnings": warnings}


def sheet_records(sheet: DataSheet) -> list[dict[str, Any]]:
    """The data sheet as plain values, one record for each quantity of each member."""
    return [
        {
            **asdict(quantity),
            "inputs": [dict(zip(("symbol", "value", "unit"), i, strict=True)) for i in quantity.inputs],
        }
        for quantity in sheet.quantities
    ]


def member_info(member: MemberGeometry) -> dict[str, Any]:
    """What there is to know of one member."""
    inner, outer = member.inner_cone_distance, member.outer_cone_distance
    tip = float(member.limit_angle(member.tip_limit, outer))
    theta = np.degrees(member.lengthwise.azimuth([inner, outer]))
    spiral = np.degrees(member.lengthwise.spiral_angle([inner, outer]))
    tip_half = _tip_half(member, outer)
    return {
        "teeth": member.teeth,
        "hand": "right" if member.hand > 0 else "left",
        "pitch_angle_deg": float(np.degrees(member.pitch_angle)),
        "base_angle_deg": float(np.degrees(member.base_angle)),
        "tip_angle_deg": float(np.degrees(member.tip_angle)),
        "root_angle_deg": float(np.degrees(member.root_angle)),
        "transverse_pressure_angle_deg": float(np.degrees(member.transverse_pressure_angle)),
        "gamma_deg": float(np.degrees(member.gamma)),
        "outer_cone_distance": outer,
        "mean_cone_distance": member.mean_cone_distance,
        "inner_cone_distance": inner,
        "face_width": member.face_width,
        "outer_pitch_diameter": member.module * member.teeth,
        "outer_tip_diameter": 2 * float(member.cone_distance(outer, tip) * np.sin(tip)),
        "base_radius": member.base_radius,
        "addendum": member.addendum,
        "dedendum": member.dedendum,
        "half_tooth_azimuth_deg": float(np.degrees(member.half_tooth_azimuth)),
        "tip_half_azimuth_deg": float(np.degrees(tip_half)),
        "tip_width": 2 * tip_half * float(np.sin(member.tip_limit.at_sphere(outer))) * outer,
        **({} if member.hypoid is None else _each_flank(member)),
        "theta_toe_deg": float(theta[0]),
        "theta_heel_deg": float(theta[1]),
        "spiral_angle_toe_deg": float(spiral[0]),
        "spiral_angle_heel_deg": float(spiral[1]),
        "fillet_radius": _fillet(member),
    }


def _tip_half(member: MemberGeometry, rho: float) -> float:
    """Half the tooth's azimuth at its tip at the heel [rad]."""
    if member.hypoid is None:
        return float(tip_half_azimuth(member, rho))
    flanks = [flank_of(member, name) for name in FLANKS]
    places = [flank.locate(flank.points(1.0, 1.0)) for flank in flanks]
    turned = [float(phi - member.lengthwise.azimuth(at)) for at, _, phi in places]
    return sum(flank.side * phi for flank, phi in zip(flanks, turned, strict=True)) / 2


def _fillet(member: MemberGeometry) -> float:
    """Radius of the fillet at the heel [mm]; with an offset the one asked for."""
    return member.fillet_radius if member.hypoid is not None else fillet(member).radius * member.outer_cone_distance


def _each_flank(member: MemberGeometry) -> dict[str, Any]:
    """What differs from flank to flank with an offset; the pinion's base cones are those of its reference."""
    sides = {name: flank_member(member, flank_of(member, name).side) for name in FLANKS}
    return {
        name: {
            "base_angle_deg": float(np.degrees(one.base_angle)),
            "transverse_pressure_angle_deg": float(np.degrees(one.transverse_pressure_angle)),
            "gamma_deg": float(np.degrees(one.gamma)),
        }
        for name, one in sides.items()
    }


def pair_info(pair: PairGeometry) -> dict[str, Any]:
    """What both members share."""
    return {
        "shaft_angle_deg": float(np.degrees(pair.shaft_angle)),
        "gear_ratio": pair.wheel.teeth / pair.pinion.teeth,
        "outer_module": pair.wheel.module,
        "mean_normal_module": pair.mean_normal_module,
        "normal_pressure_angle_deg": float(np.degrees(pair.normal_pressure_angle)),
        "mean_spiral_angle_deg": float(np.degrees(pair.mean_spiral_angle)),
        "transverse_contact_ratio": transverse_contact_ratio(pair),
        "overlap_ratio": overlap_ratio(pair),
        **({} if pair.hypoid is None else _standard_info(pair.hypoid)),
    }


def _standard_info(pair: HypoidPair) -> dict[str, Any]:
    """Dimensions of the standard: offset, angles in its planes, limit pressure angle."""
    found = dimensions(pair)
    angles = {
        "offset_angle_axial_deg": found.offset_angle_axial,
        "offset_angle_pitch_deg": found.offset_angle_pitch,
        "limit_pressure_angle_deg": found.limit_pressure_angle,
        "drive_pressure_angle_deg": found.drive_pressure_angle,
        "coast_pressure_angle_deg": found.coast_pressure_angle,
        "pinion_spiral_angle_deg": found.pinion.mean.spiral_angle,
        "wheel_spiral_angle_deg": found.wheel.mean.spiral_angle,
    }
    return {
        "offset": found.offset,
        **{name: float(np.degrees(angle)) for name, angle in angles.items()},
        "pinion_mean_cone_distance": found.pinion.mean.cone_distance,
        "wheel_mean_cone_distance": found.wheel.mean.cone_distance,
        "working_depth": found.working_depth,
        "clearance": found.clearance,
    }


def _text(design: Design, data: dict[str, Any]) -> str:
    rows: list[tuple[str, ...]] = [("", *MEMBERS, "")]
    rows += [(title, *(_cell(data[name][key]) for name in MEMBERS), unit) for key, title, unit in _OF_THE_TOOTH]
    warnings = [f"warning: {w['field']}: {w['message']}" for w in data["warnings"]]
    sheet = sheet_text(data_sheet(design), "text")
    return "\n".join([design.name, "", sheet, table(rows, (0, 3)), *([""] if warnings else []), *warnings])


def _cell(value: object) -> str:
    return f"{value:.5f}" if isinstance(value, float) else str(value)
