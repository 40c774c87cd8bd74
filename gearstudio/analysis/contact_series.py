"""A flank as polynomials of its places, for the closer look of a contact analysis, which asks for very many points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from gearstudio.theory.flank import Flank
from gearstudio.theory.hypoid.modified import ModifiedConjugate
from gearstudio.theory.modified import ModifiedFlank
from gearstudio.theory.relief import FlankRelief
from gearstudio.theory.vectors import spherical, turned

Floats = NDArray[np.float64]

_SIZES = (14, 20, 30, 44)
_TAIL = 3
_ACCURACY = 1e-13
"""Of the outer cone distance, that the last coefficients must not exceed."""


@dataclass(frozen=True)
class FlankSeries:
    """Points of a flank as Chebyshev polynomials of (u, v); micro-geometry, which has corners, is laid over them.

    Attributes
    ----------
    coefficients : ndarray, shape (n, n, 4)
        By v and u, of x, y, z of the flank without micro-geometry [mm] and of the azimuth by which metal taken off
        turns it [rad/mm].
    relief : FlankRelief or None
    """

    coefficients: Floats
    relief: FlankRelief | None

    def points(self, u: Floats, v: Floats) -> Floats:
        """Points, shape (..., 3) [mm]."""
        size, parts = len(self.coefficients), self.coefficients.shape[-1]
        along, across = (chebyshev.chebvander(2 * x - 1, size - 1) for x in (v, u))
        lines = (along @ self.coefficients.reshape(size, -1)).reshape(*u.shape, size, parts)
        values = (across[..., None, :] @ lines)[..., 0, :]
        if self.relief is None:
            return np.asarray(values)
        rho, delta, _ = spherical(values[..., :3])
        return turned(values[..., :3], self.relief.value(rho, delta) * values[..., 3])


def flank_series(flank: Flank) -> FlankSeries | None:
    """The series of a flank, exact to 1e-13 of its size; None where no reasonable one is."""
    for size in _SIZES:
        made = _fitted(flank, size)
        tail = max(np.abs(made.coefficients[-_TAIL:, :, :3]).max(), np.abs(made.coefficients[:, -_TAIL:, :3]).max())
        if tail <= _ACCURACY * flank.member.outer_cone_distance:
            return made
    return None


def _fitted(flank: Flank, size: int) -> FlankSeries:
    nodes = chebyshev.chebpts1(size)
    share = (1 + nodes) / 2
    relief = None
    psi, rho = flank.coordinates(share, share[:, None])
    if isinstance(flank, ModifiedFlank | ModifiedConjugate) and flank.relief is not None:
        relief = flank.relief
        values = np.concatenate([flank.plain.at(psi, rho), flank.turning(psi, rho)[..., None]], axis=-1)
    else:
        values = flank.at(psi, rho)
    to = np.linalg.inv(chebyshev.chebvander(nodes, size - 1))
    return FlankSeries(to @ (to @ values.reshape(size, -1)).reshape(size, size, -1), relief)
