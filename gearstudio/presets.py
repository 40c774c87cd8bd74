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
)  # fmt: skip
PRESETS_BY_KEY = {preset.key: preset for preset in PRESETS}
