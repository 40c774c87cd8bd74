"""Designs that tests share: those with independently computed numbers in ``data/golden.json``."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from gearstudio.design import Design

DATA = Path(__file__).parent / "data"
Record = dict[str, Any]


def golden_design(given: Record) -> Design:
    """The design of a golden record's input; its factors c and ha are of the outer module, r0 counts for arcs only."""
    return Design.model_validate(
        {
            "pair": {
                "pinion_teeth": given["z1"],
                "wheel_teeth": given["z2"],
                "shaft_angle_deg": given["sigma"],
                "outer_module": given["m"],
                "pressure_angle_deg": given["alpha_n"],
                "pressure_angle_kind": given["alpha_kind"],
                "face_width": given["b"],
                "pinion_hand": "right" if given["hand1"] > 0 else "left",
            },
            "lengthwise": {
                "curve": given["law"],
                "spiral_angle_deg": given["beta_m"],
                **({"cutter_radius": given["r0"]} if given["law"] == "circular_arc" else {}),
            },
            "tooth": {
                "addendum_factor": given["ha"],
                "clearance_factor": given["c"],
                "profile_shift": given["x1"],
                "ends": "sphere",
            },
        }
    )


def _read() -> dict[str, tuple[Design, Record]]:
    records = json.loads((DATA / "golden.json").read_text(encoding="utf-8"))
    return {name: (golden_design(record["input"]), record) for name, record in records.items()}


GOLDEN = _read()
