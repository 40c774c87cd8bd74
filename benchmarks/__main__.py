"""Measures every timed promise in one run and prints it with its target; exit status 1 when one is not kept."""

from __future__ import annotations

import os
import platform
import statistics
import sys
from collections.abc import Iterator
from functools import partial

from benchmarks import animation, compare, contact, gear, peers, report, solids, startup, window
from benchmarks.measurement import Measurement, Remark, ratios

RATIO, GAP_MS = 0.3, 50.0
GEAR_RATIO, GROWTH, MEGABYTES = 0.1, 1.2, 4.0


def measurements() -> Iterator[Measurement | Remark]:
    """One after the other, each as soon as it is measured."""
    peer = peers.measure()
    unit = statistics.median(peer)
    yield Measurement("py_gearworks 0.0.24, one 40-tooth wheel", peer, unit="s", decimals=2)

    other = peers.measure_other()
    title = "cq_gears, one 40-tooth wheel"
    yield Remark(f"{title}: {other}") if isinstance(other, str) else Measurement(title, other, unit="s", decimals=2)

    for member in ("wheel", "pinion"):
        readings = [seconds / unit for seconds in compare.measure(member)]
        yield Measurement(f"comparison of all six variants, {member} / py_gearworks", readings, RATIO)

    readings = [seconds / unit for seconds in contact.measure()]
    yield Measurement("contact analysis, 100 × 60 points, 40 positions / py_gearworks", readings, contact.TARGET)

    title = "whole 40-tooth wheel, checked / py_gearworks"
    yield Measurement(title, ratios(gear.build_and_check, peers.build_wheel, 5, times=3), GEAR_RATIO)
    yield Measurement("growth of that time with the teeth, exponent", [gear.growth()], GROWTH, decimals=2)
    yield Measurement("STEP file of that wheel", [gear.file_megabytes()], MEGABYTES, unit="MB", decimals=2)

    hypoid, bevel = partial(gear.build_pair, 25.4), partial(gear.build_pair, 0.0)
    title = "hypoid pair 11/41, checked / bevel pair of the same teeth"
    yield Measurement(title, ratios(hypoid, bevel, 5), gear.HYPOID_TARGET, decimals=2)

    title = "report of the default design, all sections / py_gearworks"
    yield Measurement(title, ratios(report.make, peers.build_wheel, 3), report.TARGET, decimals=2)

    edits = window.measure()
    yield Measurement("an edit to all three views / py_gearworks", [e.seconds / unit for e in edits], RATIO)
    yield Measurement("the same in seconds, the pause after an edit included", [e.seconds for e in edits], unit="s")
    gaps, with_frames = [e.gap_ms for e in edits], [e.gap_with_frames_ms for e in edits]
    title = "longest event-loop gap of a full rebuild, frames left out"
    yield Measurement(title, gaps, GAP_MS, unit="ms", decimals=0, judged="maximum")
    yield Measurement("the same with frames, drawn by software or not", with_frames, unit="ms", decimals=0)

    shown = solids.measure()
    title = "the longest while whole gears come, go and are cut, frames left out"
    yield Measurement(title, [one.alone for one in shown], GAP_MS, unit="ms", decimals=0, judged="maximum")
    yield Measurement("the same with frames", [one.with_frames for one in shown], unit="ms", decimals=0)

    frames = animation.measure()
    title = "frame of the turning pair / repaint as it is while it moves"
    yield Measurement(title, [frame.turning / frame.moving for frame in frames], animation.TARGET, decimals=2)
    title = "the same / repaint standing still, fine and smoothed"
    yield Measurement(title, [frame.turning / frame.standing for frame in frames], animation.TARGET, decimals=2)
    yield Measurement("the same in milliseconds", [frame.turning for frame in frames], unit="ms", decimals=0)

    starts = startup.measure()
    loaded = [float(len(start.loaded_at_first_paint)) for start in starts]
    title = "VTK, OCP, build123d modules loaded at the first paint"
    yield Measurement(title, loaded, 0.0, decimals=0, judged="maximum")
    yield Measurement("start to first paint", [s.first_paint for s in starts], unit="s", decimals=2)
    yield Measurement(
        "start to the picture of the exact flanks", [s.exact_flanks for s in starts], unit="s", decimals=2
    )
    yield Measurement("start to all three methods", [s.all_methods for s in starts], unit="s", decimals=2)


def main() -> int:
    """Print every measurement; the exit status."""
    machine = f"{platform.platform()}, Python {platform.python_version()}, {os.cpu_count()} cores"
    print(f"{machine}, load {os.getloadavg()[0]:.1f} (a busy machine spoils the gaps)", flush=True)
    kept = True
    for measurement in measurements():
        print(measurement, flush=True)
        kept &= measurement.passed
    print("all promises kept" if kept else "a promise is not kept")
    return 0 if kept else 1


if __name__ == "__main__":
    sys.exit(main())
