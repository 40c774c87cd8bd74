"""How a method's deviation falls with its effort: positions, sections or points, poles, and seconds."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from gearstudio.errors import GeometryError, ModellingError
from gearstudio.results import VariantResult

DEFAULT_TOLERANCES_UM = tuple(float(x) for x in np.geomspace(100.0, 0.003, 10))
EFFORTS = {"rotating_line": "positions", "profile_sweep": "sections", "point_cloud": "grid"}


@dataclass(frozen=True)
class ConvergencePoint:
    """One construction: what was asked for, what it took and how far it is from theory.

    Attributes
    ----------
    tolerance_um : float
    effort : int
        Positions, sections, or points of the grid.
    poles : int
        Of the heavier flank's surface.
    max_um, rms_um : float
        Over both flanks.
    seconds : float
    settings : mapping
        As the method tells them.
    """

    tolerance_um: float
    effort: int
    poles: int
    max_um: float
    rms_um: float
    seconds: float
    settings: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class ConvergenceStudy:
    """A method's constructions from coarse to fine.

    Attributes
    ----------
    method : str
    effort_name : str
        What `ConvergencePoint.effort` counts.
    points : tuple of ConvergencePoint
        Without repetitions of the same effort.
    stopped : str
        Why the finest tolerances are missing; empty when none is.
    """

    method: str
    effort_name: str
    points: tuple[ConvergencePoint, ...]
    stopped: str = ""

    @property
    def order(self) -> float:
        """The power of the poles by which the largest deviation falls, by a straight line in logarithms.

        Raises
        ------
        GeometryError
            Fewer than two different numbers of poles.
        """
        poles, worst = (np.log([getattr(p, name) for p in self.points]) for name in ("poles", "max_um"))
        if len(np.unique(poles)) < 2:
            raise GeometryError("the order of convergence takes two constructions with different numbers of poles")
        return float(-np.polyfit(poles, worst, 1)[0])

    def reaching(self, tolerance_um: float) -> ConvergencePoint | None:
        """The least effort whose largest deviation is within a tolerance, if any is."""
        good = [point for point in self.points if point.max_um <= tolerance_um]
        return min(good, key=lambda point: point.effort, default=None)


def convergence_study(
    method: str,
    build: Callable[[float], VariantResult],
    tolerances_um: Sequence[float] = DEFAULT_TOLERANCES_UM,
    report: Callable[[str, float], None] | None = None,
) -> ConvergenceStudy:
    """Let a method meet tighter and tighter tolerances.

    Parameters
    ----------
    method : str
        Of interface.md.
    build : callable
        From a tolerance [µm] to the optimised variant that meets it.
    tolerances_um : sequence of float
    report : callable, optional
        Told the stage and the part done.
    """
    name = EFFORTS[method]
    found: list[ConvergencePoint] = []
    stopped = ""
    for number, tolerance in enumerate(sorted(tolerances_um, reverse=True)):
        if report is not None:
            report(f"{method}, {tolerance:.3g} µm", number / len(tolerances_um))
        try:
            result = build(tolerance)
        except ModellingError as error:
            stopped = str(error)
            break
        point = ConvergencePoint(
            tolerance_um=tolerance,
            effort=int(np.prod(result.settings[name])),
            poles=int(np.prod(result.poles)),
            max_um=result.statistics.max_um,
            rms_um=result.statistics.rms_um,
            seconds=result.seconds,
            settings=result.settings,
        )
        if not found or (point.effort, point.poles) != (found[-1].effort, found[-1].poles):
            found.append(point)
    return ConvergenceStudy(method, name, tuple(found), stopped)
