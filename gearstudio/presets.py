"""Designs to start from; every one passes `gearstudio.validation.check` without an error."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from gearstudio.design import Design


@dataclass(frozen=True)
class Preset:
    """A ready design: a stable short key, a title for a menu, and one line on what it shows."""

    key: str
    title: str
    description: str
    design: Design


def _preset(key: str, title: str, description: str, **tables: dict[str, Any]) -> Preset:
    return Preset(key, title, description, Design.model_validate({"name": title, **tables}))


PRESETS: tuple[Preset, ...] = (
    Preset(
        "default",
        "Default spiral bevel pair",
        "17/40 teeth at 90° with a cutter arc of 80 mm and 35° spiral; the pinion's root lies inside its base cone",
        Design(),
    ),
    _preset(
        "straight",
        "Straight bevel pair",
        "16/32 teeth without spiral: teeth on straight lines to the apex, long and short addendum",
        pair={"pinion_teeth": 16, "wheel_teeth": 32, "outer_module": 2.5, "pressure_angle_kind": "transverse",
              "face_width": 12.0, "pinion_hand": "right"},
        lengthwise={"curve": "archimedean", "spiral_angle_deg": 0.0},
        tooth={"profile_shift": 0.3},
    ),
    _preset(
        "zerol",
        "Zerol pair",
        "25/50 teeth curved by the cutter, but with no spiral angle at the mean point; shaft angle 75°",
        pair={"pinion_teeth": 25, "wheel_teeth": 50, "outer_module": 2.0, "shaft_angle_deg": 75.0, "face_width": 14.0},
        lengthwise={"spiral_angle_deg": 0.0, "cutter_radius": 60.0},
    ),
    _preset(
        "archimedean-miter",
        "Archimedean miter pair",
        "Two equal gears at 90° with the Archimedean spiral, the spiral angle given at the toe as in the paper",
        pair={"pinion_teeth": 20, "wheel_teeth": 20, "outer_module": 3.0, "pressure_angle_kind": "transverse",
              "face_width_factor": 0.25, "pinion_hand": "right"},
        lengthwise={"curve": "archimedean", "spiral_angle_deg": 25.0, "spiral_angle_at": "toe"},
        tooth={"clearance_factor": 0.2},
    ),
    _preset(
        "automotive",
        "Automotive 9/41",
        "A rear-axle ratio with few pinion teeth: strong profile shift, constant clearance, a little backlash",
        pair={"pinion_teeth": 9, "wheel_teeth": 41, "outer_module": 4.6},
        lengthwise={"cutter_radius": 95.25},
        tooth={"addendum_factor": 0.85, "clearance_factor": 0.188, "profile_shift": 0.3, "backlash": 0.12,
               "fillet_factor": 0.25, "tip_cone": "constant_clearance"},
    ),
    _preset(
        "obtuse-logarithmic",
        "Obtuse shafts, logarithmic spiral",
        "14/35 teeth at 110°: a nearly flat wheel, and the same spiral angle everywhere on the face",
        pair={"pinion_teeth": 14, "wheel_teeth": 35, "outer_module": 6.0, "shaft_angle_deg": 110.0,
              "pressure_angle_deg": 22.5, "pinion_hand": "right"},
        lengthwise={"curve": "logarithmic", "spiral_angle_deg": 32.0},
        tooth={"addendum_factor": 0.85, "clearance_factor": 0.188, "profile_shift": 0.25},
    ),
    _preset(
        "acute",
        "Acute shafts",
        "18/27 teeth at 45°: slender cones, long cone distance",
        pair={"pinion_teeth": 18, "wheel_teeth": 27, "outer_module": 3.0, "shaft_angle_deg": 45.0,
              "face_width_factor": 0.2},
        lengthwise={"spiral_angle_deg": 25.0, "cutter_radius": 70.0},
    ),
    _preset(
        "fine",
        "Fine instrument pair",
        "20/60 teeth of module 0.5 mm",
        pair={"pinion_teeth": 20, "wheel_teeth": 60, "outer_module": 0.5},
        lengthwise={"spiral_angle_deg": 30.0, "cutter_radius": 15.0},
        tooth={"backlash": 0.01},
    ),
    _preset(
        "coarse",
        "Coarse mill drive",
        "19/43 teeth of module 20 mm, outer cone distance near half a metre",
        pair={"pinion_teeth": 19, "wheel_teeth": 43, "outer_module": 20.0, "face_width_factor": 0.25},
        lengthwise={"spiral_angle_deg": 30.0, "cutter_radius": 400.0},
        tooth={"backlash": 0.4, "tip_cone": "constant_clearance"},
    ),
    _preset(
        "logarithmic",
        "Logarithmic pair",
        "15/45 teeth, 28° spiral everywhere, sphere ends as in the paper",
        pair={"pinion_teeth": 15, "wheel_teeth": 45, "outer_module": 5.0},
        lengthwise={"curve": "logarithmic", "spiral_angle_deg": 28.0},
        tooth={"profile_shift": 0.2, "ends": "sphere"},
    ),
    _preset(
        "hypoid-car",
        "Hypoid, passenger car",
        "11/41 teeth with an offset of 25.4 mm: a rear axle whose pinion lies below the wheel's axis",
        pair={"pinion_teeth": 11, "wheel_teeth": 41, "outer_module": 4.75, "face_width": 30.0, "offset": 25.4},
        lengthwise={"spiral_angle_deg": 48.0, "cutter_radius": 76.2},
        tooth={"backlash": 0.15},
        depth={"system": "iso23509"},
    ),
    _preset(
        "hypoid-pick-up",
        "Hypoid, pick-up",
        "10/41 teeth with an offset of 38.1 mm, nearly a third of the wheel's radius",
        pair={"pinion_teeth": 10, "wheel_teeth": 41, "outer_module": 5.85, "face_width": 37.0, "offset": 38.1},
        lengthwise={"spiral_angle_deg": 50.0, "cutter_radius": 88.9},
        tooth={"backlash": 0.18},
        depth={"system": "iso23509"},
    ),
    _preset(
        "hypoid-truck",
        "Hypoid, heavy truck",
        "9/37 teeth on a wheel of 420 mm with an offset of 40 mm; teeth of a tapering depth with a tilted root line",
        pair={"pinion_teeth": 9, "wheel_teeth": 37, "outer_module": 11.35, "face_width": 62.0, "offset": 40.0},
        lengthwise={"spiral_angle_deg": 45.0, "cutter_radius": 152.4},
        tooth={"backlash": 0.3},
        depth={"system": "iso23509", "taper": "tilted_root"},
    ),
    _preset(
        "hypoid-80",
        "Hypoid, all-wheel drive at 80°",
        "13/37 teeth with an offset of 15 mm and shafts at 80°",
        pair={"pinion_teeth": 13, "wheel_teeth": 37, "outer_module": 4.6, "face_width": 27.0, "offset": 15.0,
              "shaft_angle_deg": 80.0},
        lengthwise={"spiral_angle_deg": 42.0, "cutter_radius": 76.2},
        tooth={"backlash": 0.12},
        depth={"system": "iso23509"},
    ),
    _preset(
        "hypoid-negative",
        "Hypoid, negative offset",
        "13/42 teeth with an offset of −10 mm: the pinion's spiral angle is the smaller one, and its cone the slimmer",
        pair={"pinion_teeth": 13, "wheel_teeth": 42, "outer_module": 4.05, "face_width": 30.0, "offset": -10.0,
              "pinion_hand": "right"},
        lengthwise={"spiral_angle_deg": 30.0, "cutter_radius": 76.2},
        tooth={"backlash": 0.12},
        depth={"system": "iso23509"},
    ),
    _preset(
        "uniform-depth",
        "Bevel pair of uniform depth",
        "14/39 teeth after ISO 23509: the same depth from toe to heel, for gears that one cutter head finishes",
        pair={"pinion_teeth": 14, "wheel_teeth": 39, "outer_module": 4.5, "face_width": 25.4},
        lengthwise={"cutter_radius": 76.2},
        tooth={"backlash": 0.1},
        depth={"system": "iso23509", "taper": "uniform"},
    ),
)  # fmt: skip
PRESETS_BY_KEY = {preset.key: preset for preset in PRESETS}
