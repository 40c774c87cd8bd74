"""How far a modelled flank is from the theoretical one."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from gearstudio.nurbs import NurbsSurface
from gearstudio.results import Statistics
from gearstudio.theory.flank import Flank

Floats = NDArray[np.float64]


def deviation_map(flank: Flank, surface: NurbsSurface, samples: tuple[int, int]) -> tuple[Floats, Floats]:
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
