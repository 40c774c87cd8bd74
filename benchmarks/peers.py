"""Other programs' gears: one build of the 40-tooth spiral bevel wheel of the default pair, a solid each."""

from __future__ import annotations

import importlib.util
import math

from benchmarks.measurement import timed


def build_wheel() -> object:
    """By py_gearworks: 40 teeth to 17 at 90°, module 4 mm, spiral angle 35°, face width 0.3 of the cone distance."""
    import py_gearworks

    cone_distance = 0.5 * 4.0 * math.hypot(17, 40)
    wheel = py_gearworks.BevelGear(
        number_of_teeth=40,
        module=4.0,
        height=0.3 * cone_distance,
        cone_angle=2 * math.atan2(40, 17),
        helix_angle=math.radians(35),
    )
    return wheel.build_part()


def measure(times: int = 5) -> list[float]:
    """Seconds of one build, each time; the imports and one build before are not counted."""
    build_wheel()
    return timed(build_wheel, times)


def build_other_wheel() -> object:
    """The same by cq_gears, which has no release in the package index: it is used where somebody has installed it."""
    import cq_gears

    wheel = cq_gears.BevelGear(
        module=4.0,
        teeth_number=40,
        cone_angle=math.degrees(math.atan2(40, 17)),
        face_width=0.3 * 0.5 * 4.0 * math.hypot(17, 40),
        pressure_angle=20.0,
        helix_angle=35.0,
    )
    return wheel.build()


def measure_other(times: int = 3) -> list[float] | str:
    """Seconds of one build by cq_gears, each time, or why there are none."""
    if importlib.util.find_spec("cq_gears") is None:
        return "not installed, so not measured"
    try:
        build_other_wheel()
        return timed(build_other_wheel, times)
    except Exception as error:  # whatever goes wrong in another program is no fault of this one
        return f"installed, but it made no wheel: {error}"


if __name__ == "__main__":
    print(measure(), measure_other())
