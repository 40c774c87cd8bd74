"""The other program's gear: one build of the 40-tooth spiral bevel wheel of the default pair by py_gearworks."""

from __future__ import annotations

import math

from benchmarks.measurement import timed


def build_wheel() -> object:
    """A solid 40-tooth wheel to 17 at 90°: module 4 mm, spiral angle 35°, face width 0.3 of the cone distance."""
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


if __name__ == "__main__":
    print(measure())
