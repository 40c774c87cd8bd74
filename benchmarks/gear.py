"""A whole 40-tooth wheel with fillets, body and full check; how the time grows with the teeth; its file."""

from __future__ import annotations

import math
import statistics
import tempfile
from pathlib import Path

from benchmarks.measurement import timed

TEETH = (20, 40, 80)
HYPOID_TARGET = 1.5


def build_and_check(teeth: int = 40) -> None:
    """A wheel of the default design with so many teeth, assembled and found valid."""
    from gearstudio.design import Design, with_field
    from gearstudio.kernel.solids import is_valid
    from gearstudio.methods.gear import build_gear

    gear = build_gear(with_field(Design(), "pair.wheel_teeth", teeth), "wheel", "rotating_line", "optimised")
    if not is_valid(gear.solid):
        raise RuntimeError(f"the wheel of {teeth} teeth is not valid")


def measure(teeth: int = 40, times: int = 7) -> list[float]:
    """Seconds of one build with its check, each time; the imports and one build before are not counted."""
    build_and_check(teeth)
    return timed(lambda: build_and_check(teeth), times)


def build_pair(offset: float) -> None:
    """Both members of the passenger car's hypoid pair, or of a bevel pair of the same teeth, found valid."""
    from gearstudio.design import with_field
    from gearstudio.kernel.solids import is_valid
    from gearstudio.methods.gear import build_gear
    from gearstudio.presets import PRESETS_BY_KEY

    design = with_field(PRESETS_BY_KEY["hypoid-car"].design, "pair.offset", offset)
    if offset == 0:
        design = with_field(with_field(design, "depth.system", "outer_module"), "lengthwise.spiral_angle_deg", 35.0)
    for member in ("pinion", "wheel"):
        if not is_valid(build_gear(design, member, "profile_sweep", "optimised").solid):
            raise RuntimeError(f"the {member} with an offset of {offset} mm is not valid")


def growth() -> float:
    """Exponent of the time over the number of teeth, by least squares in the logarithms."""
    seconds = [statistics.median(measure(teeth, 5)) for teeth in TEETH]
    x, y = [math.log(n) for n in TEETH], [math.log(s) for s in seconds]
    return statistics.linear_regression(x, y).slope


def file_megabytes() -> float:
    """Size of the default wheel's STEP file."""
    from gearstudio.design import Design
    from gearstudio.jobs import ExportJob

    with tempfile.TemporaryDirectory() as folder:
        job = ExportJob(Design(), "wheel", "gear", "rotating_line", "optimised", ("step",), Path(folder))
        return job.run(lambda stage, fraction: None)[0].size / 1e6


if __name__ == "__main__":
    print(measure(), growth(), file_megabytes())
