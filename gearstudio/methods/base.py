"""What a method is, what it hands over, and how an optimised variant refines itself."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from gearstudio.catalogue import MethodInfo, Variant
from gearstudio.errors import ModellingError
from gearstudio.nurbs import NurbsSurface
from gearstudio.results import ConstructionCurve
from gearstudio.theory.flank import Flank

Floats = NDArray[np.float64]

SAFETY = 0.5
"""Part of the tolerance that a refinement aims at: it looks between its nodes, not everywhere."""
_MAX_ROUNDS = 14
_MAX_COUNT = 1600
_LARGE_CONE_DISTANCE = 250.0


@dataclass(frozen=True)
class Target:
    """What an optimised variant has to reach.

    Attributes
    ----------
    tolerance : float
        Largest deviation wanted [mm].
    point_cloud_degree : int
        Degree of the NURBS reconstruction.
    """

    tolerance: float
    point_cloud_degree: int = 3

    @staticmethod
    def for_cone_distance(tolerance_um: float, cone_distance: float, point_cloud_degree: int = 3) -> Target:
        """The tolerance as given, in proportion beyond an outer cone distance of 250 mm."""
        scale = max(1.0, cone_distance / _LARGE_CONE_DISTANCE)
        return Target(tolerance_um * 1e-3 * scale, point_cloud_degree)


@dataclass(frozen=True)
class Construction:
    """A flank as a method made it: the surface over [0, 1]², what it was made from, what it took.

    ``instead`` is the flank that was modelled where the method cannot follow the one that was asked for.
    """

    surface: NurbsSurface
    curves: tuple[ConstructionCurve, ...] = ()
    settings: Mapping[str, Any] = field(default_factory=dict)
    instead: Flank | None = None


class Method(Protocol):
    """One way to model a flank."""

    @property
    def info(self) -> MethodInfo:
        """What it is called."""
        ...

    def build(self, flank: Flank, variant: Variant, target: Target) -> Construction:
        """Model a flank.

        Raises
        ------
        ModellingError
            The kernel could not, or the tolerance was not reached.
        """
        ...

    def build_with(self, flank: Flank, count: int, target: Target) -> Construction:
        """Model a flank as the optimised variant does, with a given effort and whatever deviation comes of it.

        Parameters
        ----------
        flank : Flank
        count : int
            Positions, sections, or points along each side of the grid; other counts follow from it.
        target : Target
            Its tolerance decides nothing but how closely the kernel follows what it is given.

        Raises
        ------
        ModellingError, GeometryError
            The kernel could not.
        """
        ...


def between(nodes: Floats) -> Floats:
    """Places between neighbouring nodes where an interpolation is looked at: three in each gap."""
    gaps = np.diff(nodes)
    return np.asarray((nodes[:-1, None] + gaps[:, None] * np.array([0.25, 0.5, 0.75])).ravel())


def node_errors(flank: Flank, surface: NurbsSurface, u: Floats, v: Floats) -> tuple[float, float]:
    """What the nodes of each direction cost, for u and v [mm].

    The larger of the deviation and of the distance of the edges from the flank's, taken between the nodes
    of one direction along the node lines of the other.
    """
    across, along = surface.grid(np.r_[0.0, between(u), 1.0], v), surface.grid(u, np.r_[0.0, between(v), 1.0])
    errors = [max(np.abs(flank.deviation(grid)).max(), flank.edge_deviation(grid)) for grid in (across, along)]
    return float(errors[0]), float(errors[1])


@dataclass
class Refinement:
    """Grows counts of nodes until the errors that they cause are below a goal.

    Attributes
    ----------
    method : str
        For messages.
    goal : float
        [mm], for the sum of the errors.
    orders : tuple of int
        Power by which each error falls with its count.
    """

    method: str
    goal: float
    orders: tuple[int, ...]

    def run(
        self,
        counts: tuple[int, ...],
        attempt: Callable[[tuple[int, ...]], tuple[Construction, tuple[float, ...]]],
    ) -> Construction:
        """Call ``attempt(counts) -> (construction, errors)`` with growing counts; return the first good one.

        Raises
        ------
        ModellingError
            The goal was not met with the largest counts allowed.
        """
        errors: tuple[float, ...] = ()
        for _ in range(_MAX_ROUNDS):
            construction, errors = attempt(counts)
            if sum(errors) <= self.goal:
                return construction
            grown = tuple(self._grown(*x) for x in zip(counts, errors, self.orders, strict=True))
            if grown == counts:
                break
            counts = grown
        raise ModellingError(
            self.method,
            "refinement",
            f"{sum(errors) * 1e3:.3g} µm remained with {' x '.join(map(str, counts))} nodes where a step of the "
            f"construction needs {self.goal * 1e3:.3g} µm; raise methods.tolerance_um",
        )

    def _grown(self, count: int, error: float, order: int) -> int:
        share = self.goal / len(self.orders)
        if error <= share:
            return count
        factor = float(np.clip(1.05 * (error / share) ** (1 / order), 1.15, 2.5))
        return min(int(np.ceil(count * factor)), max(count, _MAX_COUNT))
