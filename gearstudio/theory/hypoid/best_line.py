"""The flank that one rigid line sweeps nearest to a conjugate flank, which none sweeps exactly."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import atan2, sin
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.involute_flank import InvoluteFlank
from gearstudio.theory.limit import ConeLimit

if TYPE_CHECKING:
    from gearstudio.theory.hypoid.conjugate import ConjugateFlank

Floats = NDArray[np.float64]

_ALONG, _ACROSS = 11, 9
_CLEARANCE = 1e-9
_ROUNDS = 60
_LEAST, _MOST = 0.01, 5.0


def best_line(flank: ConjugateFlank) -> InvoluteFlank:
    """The involute flank whose base cone and generating line fit a conjugate flank best.

    Notes
    -----
    Least squares of the normal distance over the working flank. The line is a circular arc; free are its curvature
    and spiral angle, the base cone's angle and the tooth's thickness; the flank that touches at the mean point is the
    start. The base cone stays below the start of contact, where the flank then begins.
    """
    from scipy.optimize import least_squares

    start, side = flank.member, flank.side
    points = flank.points(np.linspace(0.0, 1.0, _ACROSS)[:, None], np.linspace(0.0, 1.0, _ALONG))
    lowest = float(np.min(flank.limits(np.linspace(0.0, 1.0, _ALONG))[0])) - _CLEARANCE
    mean, size = start.lengthwise.mean_cone_distance, 1e3 / start.outer_cone_distance

    def fitted(x: Floats) -> MemberGeometry:
        base, half, spiral, bend = (float(value) for value in x)
        line = replace(start.lengthwise, law="circular_arc", mean_spiral_angle=spiral, cutter_radius=mean / bend)
        return replace(start, base_angle=base, half_tooth_azimuth=half, lengthwise=line)

    def distances(x: Floats) -> Floats:
        return np.asarray(InvoluteFlank(fitted(x), side).deviation(points)).ravel() * size

    base, spiral = min(start.base_angle, lowest), start.lengthwise.mean_spiral_angle
    bend = mean / start.lengthwise.cutter_radius if start.lengthwise.law == "circular_arc" else max(sin(spiral), _LEAST)
    first = np.array([base, start.half_tooth_azimuth, spiral, bend])
    low, high = np.array([0.5 * base, -np.inf, -1.3, _LEAST]), np.array([lowest, np.inf, 1.3, _MOST])
    found = least_squares(distances, np.clip(first, low, high), bounds=(low, high), x_scale=0.01, max_nfev=_ROUNDS)
    return InvoluteFlank(fitted(found.x), side, _Edge(flank))


@dataclass(frozen=True)
class _Edge:
    """The lower edge of a flank as a limit of another."""

    flank: ConjugateFlank

    def at_sphere(self, rho: ArrayLike, /) -> Floats:
        """Polar angle [rad] at cone distances."""
        return self.at_back_cone(rho)

    def at_back_cone(self, rho_u: ArrayLike, /) -> Floats:
        """Polar angle [rad] at end distances; on spheres these are the cone distances."""
        m = self.flank.member
        return self.flank.limits(m.face_share(rho_u))[0]


def edge_cone(flank: ConjugateFlank, u: float) -> ConeLimit:
    """The cone through both ends of a line u = constant of a flank."""
    toe, heel = flank.points(u, [0.0, 1.0])
    radius, height = [np.hypot(p[0], p[1]) for p in (toe, heel)], [p[2] for p in (toe, heel)]
    angle = atan2(radius[1] - radius[0], height[1] - height[0])
    distance, polar = float(np.hypot(radius[1], height[1])), atan2(radius[1], height[1])
    return ConeLimit(angle, distance * sin(polar - angle), flank.member.pitch_angle)
