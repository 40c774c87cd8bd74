"""How far beyond its edges a conjugate flank is regular, so that points beside it can be measured."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from gearstudio.errors import GeometryError

if TYPE_CHECKING:
    from gearstudio.theory.hypoid.conjugate import ConjugateFlank

Floats = NDArray[np.float64]

_ABOVE, _BELOW = 0.25, 0.05
_BESIDE = (0.25, 0.12, 0.06, 0.03)


@dataclass(frozen=True)
class Reach:
    """Shares of height and face width by which the flank goes on above and below, and beyond toe and heel."""

    above: float
    below: float
    beside: float


def reach_of(flank: ConjugateFlank) -> Reach:
    """Look for the shares: below and beside the flank may fold back, above it does not."""
    below = _BELOW if _is_regular(flank, np.full(9, -_BELOW), np.linspace(0.0, 1.0, 9)) else 0.0
    u = np.linspace(-below, 1 + _ABOVE, 7)[:, None]
    sides = (x for x in _BESIDE if _is_regular(flank, u, np.array([-x, -x / 2, 1 + x / 2, 1 + x])))
    return Reach(_ABOVE, below, next(sides, 0.0))


def _is_regular(flank: ConjugateFlank, u: Floats, v: Floats) -> bool:
    try:
        return bool(np.all(flank.envelope.at(*flank.coordinates(u, v)).area_ratio > 0))
    except GeometryError:
        return False
