"""How far a modelled flank is from the theoretical one."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from gearstudio.nurbs import NurbsSurface
from gearstudio.results import Statistics
from gearstudio.theory.flank import InvoluteFlank

Floats = NDArray[np.float64]


def deviation_map(flank: InvoluteFlank, surface: NurbsSurface, samples: tuple[int, int]) -> tuple[Floats, Floats]:
    """Sample a surface over its whole extent, edges included.

    Returns
    -------
    points : ndarray, shape (n_u, n_v, 3)
        [mm]
    deviation_um : ndarray, shape (n_u, n_v)
        Signed and normal, positive where metal is added [µm] (theory 5).
    """
    points = surface.uniform_grid(*samples)
    return points, flank.deviation(points) * 1e3


def statistics(deviations_um: Iterable[Floats]) -> Statistics:
    """Summary over one or several maps [µm]."""
    values = np.concatenate([np.ravel(part) for part in deviations_um])
    return Statistics(
        max_um=float(np.abs(values).max()),
        mean_um=float(np.abs(values).mean()),
        rms_um=float(np.sqrt(np.mean(values**2))),
        lowest_um=float(values.min()),
        highest_um=float(values.max()),
    )


def edge_deviation(flank: InvoluteFlank, points: Floats) -> float:
    """Farthest that the edges of a sampled surface lie from the edges of the working flank [mm].

    Parameters
    ----------
    flank : InvoluteFlank
    points : ndarray, shape (n_u, n_v, 3)
        u root to tip, v toe to heel; only the border rows are used.

    Notes
    -----
    Measured along the flank: polar angle times cone distance at root and tip, cone distance at toe and heel.
    """
    member = flank.member
    rho, delta, _ = flank.locate(points)
    place = (member.end_distance(rho, delta) - member.inner_cone_distance) / member.face_width
    toe, heel = np.abs(place[:, 0]).max(), np.abs(place[:, -1] - 1.0).max()
    lower, upper = flank.limits(place[0])[0], flank.limits(place[-1])[1]
    root, tip = np.abs(delta[0] - lower) * rho[0], np.abs(delta[-1] - upper) * rho[-1]
    return float(max(toe * member.face_width, heel * member.face_width, root.max(), tip.max()))
