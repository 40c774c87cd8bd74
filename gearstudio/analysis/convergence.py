"""How a method's deviation falls with its effort: positions, sections or points, poles, and seconds."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from gearstudio.design import Design
from gearstudio.errors import GeometryError, ModellingError

Effort = Literal["count", "poles", "seconds"]
DEFAULT_COUNTS = (4, 5, 6, 7, 8, 10, 12, 15, 19, 24, 30, 38, 48)
COUNTED = {"rotating_line": "positions", "profile_sweep": "sections", "point_cloud": "points along each side"}
_SAMPLES = (41, 41)
_SHORT_S = 0.2
_REPETITIONS = 3


@dataclass(frozen=True)
class ConvergencePoint:
    """One construction: what it took and how far it is from theory.

    Attributes
    ----------
    count : int
        What `COUNTED` says of the method.
    poles : int
        Of the heavier flank's surface.
    seconds : float
        For both flanks; of short ones the shortest of a few.
    max_um, mean_um, rms_um : float
        Over both flanks, of absolute values.
    settings : mapping
        As the method tells them.
    """

    count: int
    poles: int
    seconds: float
    max_um: float
    mean_um: float
    rms_um: float
    settings: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class ConvergenceStudy:
    """A method's constructions from coarse to fine.

    Attributes
    ----------
    method : str
    points : tuple of ConvergencePoint
        With growing count.
    failures : mapping of int to str
        Counts with which the kernel made no flank, and why.
    """

    method: str
    points: tuple[ConvergencePoint, ...]
    failures: Mapping[int, str] = field(default_factory=dict)

    def order(self, effort: Effort = "poles") -> float:
        """The power of the effort by which the largest deviation falls, where it falls fastest.

        The steepest slope in logarithms over three neighbouring points: before, the construction is too coarse
        for any order; after, it has come to the kernel's own accuracy.

        Raises
        ------
        GeometryError
            Fewer than three constructions.
        """
        if len(self.points) < 3:
            raise GeometryError("the order of convergence takes three constructions or more")
        size, worst = (np.log([getattr(point, name) for point in self.points]) for name in (effort, "max_um"))
        slopes = [
            -np.polyfit(size[k : k + 3], worst[k : k + 3], 1)[0]
            for k in range(len(size) - 2)
            if np.ptp(size[k : k + 3]) > 0
        ]
        return float(max(slopes, default=0.0))

    def reaching(self, tolerance_um: float) -> ConvergencePoint | None:
        """The least count from which on the largest deviation stays within a tolerance, if there is one."""
        good = None
        for point in reversed(self.points):
            if point.max_um > tolerance_um:
                break
            good = point
        return good


def convergence_point(
    design: Design, member: str, method: str, count: int, repetitions: int = _REPETITIONS
) -> ConvergencePoint:
    """Build both flanks of a member with a given effort and measure them; short ones are timed a few times.

    Raises
    ------
    ModellingError
        The kernel made no flank.
    """
    from gearstudio.analysis.comparison import build_with_count

    results = [build_with_count(design, member, method, count, _SAMPLES)]
    while results[0].seconds < _SHORT_S and len(results) < repetitions:
        results.append(build_with_count(design, member, method, count, _SAMPLES))
    result = results[0]
    return ConvergencePoint(
        count=count,
        poles=int(np.prod(result.poles)),
        seconds=min(one.seconds for one in results),
        max_um=result.statistics.max_um,
        mean_um=result.statistics.mean_um,
        rms_um=result.statistics.rms_um,
        settings=result.settings,
    )


def convergence_study(
    method: str,
    build: Callable[[int], ConvergencePoint],
    counts: Sequence[int] = DEFAULT_COUNTS,
    report: Callable[[str, float], None] | None = None,
) -> ConvergenceStudy:
    """Build with more and more effort.

    Parameters
    ----------
    method : str
        Of interface.md.
    build : callable
        From a count to its construction; a ModellingError is noted, and the study goes on.
    counts : sequence of int
    report : callable, optional
        Told the stage and the part done.
    """
    points, failures = [], {}
    for number, count in enumerate(sorted(set(counts))):
        if report is not None:
            report(f"{method}, {count} {COUNTED[method]}", number / len(counts))
        try:
            points.append(build(count))
        except ModellingError as error:
            failures[count] = str(error)
    return ConvergenceStudy(method, tuple(points), failures)


def studies_of(found: Iterable[tuple[str, ConvergencePoint]]) -> dict[str, ConvergenceStudy]:
    """Studies from (method, point) in any order."""
    grouped: dict[str, list[ConvergencePoint]] = {}
    for method, point in found:
        grouped.setdefault(method, []).append(point)
    return {
        method: ConvergenceStudy(method, tuple(sorted(points, key=lambda point: point.count)))
        for method, points in grouped.items()
    }
