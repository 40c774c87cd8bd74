"""Contact ratios of a pair with offset axes, from the turns at which its conjugate flanks touch."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from gearstudio.theory.hypoid.conjugate import pinion_flank
from gearstudio.theory.hypoid.pair import HypoidPair

_SAMPLES = 9


@lru_cache(maxsize=64)
def contact_ratios(pair: HypoidPair) -> tuple[float, float, float]:
    """Transverse, overlap and total contact ratio of the drive flanks.

    Notes
    -----
    The turn of the wheel, over its pitch, during which contact moves over the profile in the middle of the face; over
    the face at half the depth; and over the whole flank. The last is what carries: the paths of the other two do not
    simply add up on flanks whose lines of contact are inclined.

    Raises
    ------
    GeometryError
        The pinion's flank does not reach over its face.
    """
    flank = pinion_flank(pair, "concave")
    share = np.linspace(0.0, 1.0, _SAMPLES)
    turn = flank.envelope.at(*flank.coordinates(share[:, None], share)).wheel_turn
    pitch, middle = 2 * np.pi / pair.given.wheel_teeth, _SAMPLES // 2
    return float(np.ptp(turn[:, middle]) / pitch), float(np.ptp(turn[middle]) / pitch), float(np.ptp(turn) / pitch)
