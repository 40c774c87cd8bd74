"""What bounds a tooth at tip, root and base: surfaces about the gear axis, as polar angles (theory 2, 6)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]


class Limit(Protocol):
    """A surface about the gear axis that bounds a tooth."""

    def at_sphere(self, rho: ArrayLike, /) -> Floats:
        """Polar angle [rad] at distance rho from the apex."""
        ...

    def at_back_cone(self, rho_u: ArrayLike, /) -> Floats:
        """Polar angle [rad] on the back cone rho cos(delta_k - delta) = rho_u."""
        ...


@dataclass(frozen=True)
class ConeLimit:
    """A cone about the gear axis that bounds a tooth; its apex need not be the gear's.

    Attributes
    ----------
    angle : float
        Half angle [rad].
    offset : float
        Signed distance of its elements from the gear's apex, in the axial plane [mm]; 0 for a common apex.
    pitch_angle : float
        Of the member [rad]: the back and front cones stand square to its pitch element.
    """

    angle: float
    offset: float
    pitch_angle: float

    def at_sphere(self, rho: ArrayLike) -> Floats:
        """Polar angle [rad] of the cone at distance rho from the apex, delta_tip(rho) of theory 2."""
        return np.asarray(self.angle + np.arcsin(self.offset / np.asarray(rho, dtype=np.float64)))

    def at_back_cone(self, rho_u: ArrayLike) -> Floats:
        """Polar angle [rad] where the cone meets the back cone rho cos(delta_k - delta) = rho_u (theory 6)."""
        lean = self.angle - self.pitch_angle
        height = self.offset / np.cos(lean) + np.asarray(rho_u, dtype=np.float64) * np.tan(lean)
        return np.asarray(self.pitch_angle + np.arctan2(height, rho_u))
