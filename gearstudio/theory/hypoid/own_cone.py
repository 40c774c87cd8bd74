"""The involute pinion on base cones of its own, as for a bevel pair, against the conjugate one: a reference only.

Both touch at the mean point with the same tangent plane, spiral angle, pressure angle and cutter. Without offset
they are the same flank; with it they part by up to hundreds of micrometres.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.flank import FlankName, InvoluteFlank
from gearstudio.theory.hypoid.conjugate import pinion_flank
from gearstudio.theory.hypoid.pair import HypoidPair

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class EaseOff:
    """Normal distance of one pinion flank from another over the working flank.

    Attributes
    ----------
    places : ndarray, shape (n_v,)
        v from toe to heel.
    heights : ndarray, shape (n_u,)
        u from the start of contact to the tip.
    metal : ndarray, shape (n_u, n_v)
        [mm], positive where the flank has metal that the conjugate one has not; not a number inside the base cone.
    """

    places: Floats
    heights: Floats
    metal: Floats

    @property
    def rms(self) -> float:
        """Root of the mean square [mm]."""
        return float(np.sqrt(np.nanmean(self.metal**2)))

    @property
    def extreme(self) -> float:
        """Largest distance [mm], signed."""
        return float(self.metal.ravel()[np.nanargmax(np.abs(self.metal))])


def own_cone_flank(pair: HypoidPair, name: FlankName) -> InvoluteFlank:
    """The pinion's flank as a spherical involute on a base cone of its own."""
    return InvoluteFlank(pair.member("pinion", name), pair.side("pinion", name))


def own_cone_ease_off(pair: HypoidPair, name: FlankName, n_u: int = 15, n_v: int = 21) -> EaseOff:
    """How far the own-base-cone flank departs from the conjugate flank.

    Raises
    ------
    GeometryError
        The conjugate flank has no such points.
    """
    own, conjugate = own_cone_flank(pair, name), pinion_flank(pair, name)
    u, v = np.linspace(0.0, 1.0, n_u), np.linspace(0.0, 1.0, n_v)
    rho, delta, _ = conjugate.locate(conjugate.points(u[:, None], v))
    member = own.member
    above = delta >= member.base_angle
    points = own.points_at(rho, np.where(above, delta, member.base_angle))
    return EaseOff(v, u, np.where(above, conjugate.deviation(points), np.nan))
