"""Method 3: a NURBS surface from the discrete point cloud (paper section 5, theory 7)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio import catalogue
from gearstudio.catalogue import MethodInfo, Variant
from gearstudio.kernel.surfaces import interpolated_points, oriented, reconstructed
from gearstudio.methods.base import SAFETY, Construction, Refinement, Target, node_errors
from gearstudio.results import ConstructionCurve
from gearstudio.theory.flank import Flank

Floats = NDArray[np.float64]

PUBLISHED_GRID = (7, 7)
FIRST_GRID = (12, 14)
_END_DENSITY = 0.6


@dataclass(frozen=True)
class PointCloud:
    """``published``: 7 x 7 points, evenly divided, and the kernel's own interpolation.

    ``optimised``: tensor-product reconstruction over psi and the arc of the tooth trace, in which the flank
    is analytic, from a 12 x 14 grid that is denser toward the edges and grows where the tolerance asks.
    """

    info: MethodInfo = catalogue.POINT_CLOUD

    def build(self, flank: Flank, variant: Variant, target: Target) -> Construction:
        """See `Method.build`."""
        return self._published(flank) if variant == "published" else self._optimised(flank, target)

    def _published(self, flank: Flank) -> Construction:
        rows, cols = PUBLISHED_GRID
        points = flank.evenly_divided(cols, rows)
        corners = points[np.ix_([0, -1], [0, -1])]
        surface = oriented(interpolated_points(points), corners)
        return Construction(surface, _cloud(points), {"grid": [cols, rows], "spacing": "even", "parameters": "kernel"})

    def build_with(self, flank: Flank, count: int, target: Target) -> Construction:
        """See `Method.build_with`."""
        return self._attempt(flank, (count, count), target)[0]

    def _optimised(self, flank: Flank, target: Target) -> Construction:
        goal, order = SAFETY * target.tolerance, target.point_cloud_degree + 1
        refinement = Refinement(self.info.id, goal, (order, order))
        return refinement.run(FIRST_GRID, lambda counts: self._attempt(flank, counts, target))

    def _attempt(self, flank: Flank, counts: tuple[int, ...], target: Target) -> tuple[Construction, tuple[float, ...]]:
        degree = target.point_cloud_degree
        u, v = (denser_to_the_ends(max(n, degree + 1)) for n in counts)
        points = flank.points(u[:, None], flank.along(v)[None, :])
        surface = reconstructed(u, v, points, degree, flank.starts_on_base)
        settings = {"grid": [len(u), len(v)], "spacing": "non-uniform", "parameters": "psi, trace"}
        return Construction(surface, _cloud(points), settings), node_errors(flank, surface, u, v)


def denser_to_the_ends(count: int) -> Floats:
    """Places in [0, 1], between evenly spaced and cosine spaced, shape (count,)."""
    even = np.linspace(0.0, 1.0, count)
    return np.asarray((1 - _END_DENSITY) * even + _END_DENSITY * (1 - np.cos(np.pi * even)) / 2)


def _cloud(points: Floats) -> tuple[ConstructionCurve, ...]:
    u_lines = [ConstructionCurve("u_line", points[:, j]) for j in range(points.shape[1])]
    v_lines = [ConstructionCurve("v_line", points[i]) for i in range(points.shape[0])]
    return ConstructionCurve("points", points.reshape(-1, 3)), *u_lines, *v_lines
