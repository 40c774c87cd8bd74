"""Members that the theory's tests run over: the golden pairs, and corners of the permitted range."""

from __future__ import annotations

from typing import Any

import numpy as np

from gearstudio.design import Design
from gearstudio.theory.cones import MemberGeometry, pair_geometry
from tests.designs import GOLDEN


def made(**fields: Any) -> Design:
    """A design from its fields, each in the table it belongs to."""
    tables: dict[str, dict[str, Any]] = {"pair": {}, "lengthwise": {}, "tooth": {}}
    for key, value in fields.items():
        table = next(name for name in tables if key in type(getattr(Design(), name)).model_fields)
        tables[table][key] = value
    return Design.model_validate(tables)


CORNERS = {
    "needle": made(pinion_teeth=5, wheel_teeth=200, curve="logarithmic", addendum_factor=0.6, pressure_angle_deg=25.0),
    "crown": made(pinion_teeth=20, wheel_teeth=40, shaft_angle_deg=119.9, tip_cone="constant_clearance", backlash=0.3),
    "toe": made(curve="archimedean", spiral_angle_deg=30.0, spiral_angle_at="toe", ends="sphere", profile_shift=0.2),
    "steep": made(cutter_radius=52.0, spiral_angle_deg=55.0, pinion_hand="right", addendum_factor=0.7),
    "giant": made(outer_module=100.0, wheel_teeth=63, cutter_radius=4000.0, fillet_factor=0.2, clearance_factor=0.6),
}
DESIGNS = {name: design for name, (design, _) in GOLDEN.items()} | CORNERS
MEMBERS: dict[str, MemberGeometry] = {
    f"{name} {side}": pair_geometry(design).member(side)
    for name, design in DESIGNS.items()
    for side in ("pinion", "wheel")
}


def about_axis(angle: float) -> np.ndarray:
    """Rotation about z, written out here so that the tests do not lean on the code under test."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
