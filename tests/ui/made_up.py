"""Results without a CAD kernel: exact flanks moved along their normals by a known deviation."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from gearstudio.design import Design
from gearstudio.nurbs import NurbsSurface
from gearstudio.results import ConstructionCurve, FlankResult, Floats, Statistics, VariantResult
from gearstudio.theory.cones import MemberGeometry, pair_geometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.involute_flank import involute_flank
from ui.layers import Layer
from ui.scene import member_layers, result_layers, rolling_layers

Deviation = Callable[[Floats, Floats], Floats]

DESIGNS: dict[str, dict[str, dict[str, Any]]] = {
    "default": {},
    "straight": {"lengthwise": {"curve": "archimedean", "spiral_angle_deg": 0.0}},
    "tiny": {
        "pair": {"outer_module": 0.1, "pinion_teeth": 15, "wheel_teeth": 20},
        "lengthwise": {"cutter_radius": 2.0},
    },
    "huge": {
        "pair": {"outer_module": 100.0, "pinion_teeth": 60, "wheel_teeth": 200},
        "lengthwise": {"cutter_radius": 8000.0},
    },
    "right hand, sphere": {
        "pair": {"pinion_hand": "right"},
        "tooth": {"tip_cone": "constant_clearance", "ends": "sphere"},
    },
}


def member_of(design: str, member: str = "wheel") -> MemberGeometry:
    """A member of one of `DESIGNS`."""
    return pair_geometry(Design.model_validate(DESIGNS[design])).member(member)


def result_of(
    member: MemberGeometry, deviation: Deviation, samples: int = 21, method: str = "point_cloud"
) -> VariantResult:
    """A result whose deviation at (u, v) [µm] is given."""
    u, v = np.linspace(0, 1, samples)[:, None], np.linspace(0, 1, samples)[None, :]
    flanks = {}
    for name in FLANKS:
        flank = involute_flank(member, name)
        error = deviation(*np.broadcast_arrays(u, v)) * np.ones((samples, samples))
        points = flank.points(u, v) + 1e-3 * error[..., None] * flank.normals(u, v)
        curves = (
            ConstructionCurve("section", flank.points(np.linspace(0, 1, 9), 0.5)),
            ConstructionCurve("guide", flank.points(0.5, np.linspace(0, 1, 9))),
            ConstructionCurve("points", flank.points(u, v).reshape(-1, 3)),
        )
        flanks[name] = FlankResult(name, _flat(points), points, error, _statistics(error), 0.0, curves)
    everything = np.stack([flank.deviation_um for flank in flanks.values()])
    return VariantResult(member.name, method, "published", flanks, _statistics(everything), (4, 4), (3, 3), 0.01)


def _flat(points: Floats) -> NurbsSurface:
    knots = np.repeat([0.0, 1.0], 4)
    return NurbsSurface(points[:4, :4], knots, knots, 3, 3)


def _statistics(error: Floats) -> Statistics:
    size = np.abs(error)
    rms = float(np.sqrt(np.mean(error**2)))
    return Statistics(float(size.max()), float(size.mean()), rms, float(error.min()), float(error.max()))


def scene_layers(member: MemberGeometry, result: VariantResult, roll: float = 1.0) -> tuple[Layer, ...]:
    """Everything one view can show of a result, but for surface quality."""
    return (*member_layers(member), *result_layers(result), *rolling_layers(member, roll))
