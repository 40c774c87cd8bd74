"""A contact analysis as a slider asks for it: 100 × 60 points, 40 positions, each time with another misalignment."""

from __future__ import annotations

from itertools import count

from benchmarks.measurement import timed

POINTS, POSITIONS = (60, 100), 40
TARGET = 0.05


def measure(times: int = 9) -> list[float]:
    """Seconds of one analysis of the drive side, each time; the imports and one analysis before are not counted."""
    from gearstudio.analysis.contact import one_direction
    from gearstudio.analysis.contact_placing import Misalignment
    from gearstudio.design import Design
    from gearstudio.theory.cones import pair_geometry

    pair = pair_geometry(Design())
    slider = count()

    def analyse() -> None:
        one_direction(pair, "drive", Misalignment(offset=0.005 * next(slider)), points=POINTS, positions=POSITIONS)

    analyse()
    return timed(analyse, times)


if __name__ == "__main__":
    print(measure())
