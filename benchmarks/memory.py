"""Memory of the window and of the CAD process over many edits and rebuilds, after warm-up.

``python -m benchmarks.memory`` prints both courses; exit status 1 when either grows beyond the target.
"""

from __future__ import annotations

import gc
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING

import psutil

from benchmarks.opening import opened
from benchmarks.window import is_settled, pause, wait_until

if TYPE_CHECKING:
    from ui.app import Studio

EDITS, REBUILDS, WARM_UP = 200, 50, 40
TARGET = 1.05
FIELDS = (
    ("lengthwise.spiral_angle_deg", (30.0, 31.0, 32.0, 33.0, 34.0)),
    ("pair.wheel_teeth", (40, 41, 43)),
    ("tooth.profile_shift", (0.0, 0.05, 0.1)),
)
REST_MS = 300


@dataclass(frozen=True)
class Course:
    """Resident megabytes after the warm-up, after the edits, after the rebuilds."""

    name: str
    warm: float
    edited: float
    rebuilt: float

    @property
    def growth(self) -> float:
        """The larger of the two later values over the first."""
        return max(self.edited, self.rebuilt) / self.warm

    def __str__(self) -> str:
        course = f"{self.warm:.0f} MB warm, {self.edited:.0f} after {EDITS} edits, {self.rebuilt:.0f} after {REBUILDS}"
        return f"{self.name}: {course} rebuilds; growth {self.growth - 1:+.1%} (most {TARGET - 1:.0%})"


def measure() -> tuple[Course, Course]:
    """The window's and the CAD process's memory, from one run of the real program."""
    with opened() as studio:
        wait_until(lambda: is_settled(studio))
        readings: list[tuple[float, float]] = []
        for times, work in ((WARM_UP, _edit), (EDITS, _edit), (REBUILDS, _rebuild)):
            for number in range(times):
                work(studio, number)
            readings.append(_megabytes(studio))
    window, worker = zip(*readings, strict=True)
    return Course("window", *window), Course("CAD process", *worker)


def _edit(studio: Studio, number: int) -> None:
    field, values = FIELDS[number % len(FIELDS)]
    value = values[(number // len(FIELDS)) % len(values)]
    before = studio.session.design
    studio.window.form.field_edited.emit(field, value)
    if studio.session.design != before:
        wait_until(lambda: is_settled(studio))
    if number % 10 == 0:
        studio.session.select(member="pinion" if number % 20 else "wheel")
        wait_until(lambda: is_settled(studio))


def _rebuild(studio: Studio, _number: int) -> None:
    studio.controller.builds.rebuild()
    wait_until(lambda: is_settled(studio))


def _megabytes(studio: Studio) -> tuple[float, float]:
    pause(REST_MS)
    gc.collect()
    runner = studio.controller.runner
    assert runner is not None
    pids = (psutil.Process().pid, runner.process_id)
    window, worker = (psutil.Process(pid).memory_info().rss / 2**20 for pid in pids)
    return window, worker


def main() -> int:
    """Print both courses; the exit status."""
    courses = measure()
    for course in courses:
        print(course)
    return 0 if all(course.growth <= TARGET for course in courses) else 1


if __name__ == "__main__":
    sys.exit(main())
