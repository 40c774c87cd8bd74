"""What is under the pointer: rays against the triangles that are drawn; the renderer is not asked."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ui.layers import Layer

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Hover:
    """A point under the pointer, in what a person reads: mm, degrees, µm.

    Attributes
    ----------
    panel_key, flank : str
        The view, and the flank or, of a solid, its face in words.
    xyz, rho, delta_deg
        In the gear's own frame.
    deviation_um : float or None
    value : float or None
        What colours it.
    member, face : str
        Of a solid: whose, and the face as the core names it.
    tooth : int or None
        From 1; None for a face of none.
    """

    panel_key: str
    flank: str
    xyz: tuple[float, float, float]
    rho: float
    delta_deg: float
    deviation_um: float | None
    value: float | None = None
    member: str = ""
    face: str = ""
    tooth: int | None = None

    @property
    def side(self) -> str:
        """``concave`` or ``convex`` on a flank, else empty."""
        name = self.face.removesuffix(" flank") if self.member else self.flank
        return name if name in ("concave", "convex") else ""


@dataclass(frozen=True, eq=False)
class Hit:
    """Where a ray meets a surface: distance along it, the corners' indices and their weights there."""

    layer: Layer
    distance: float
    point: Floats
    corners: NDArray[np.int64]
    weights: Floats

    @property
    def scalar(self) -> float | None:
        """The layer's scalar there, linear over the triangle; None where there is none."""
        return self._at(self.layer.scalars)

    @property
    def deviation(self) -> float | None:
        """The deviation there [µm], whatever the colours show."""
        return self.scalar if self.layer.deviation is None else self._at(self.layer.deviation)

    @property
    def true_point(self) -> Floats:
        """The point itself, wherever it is drawn."""
        true = self.layer.true_points
        return self.point if true is None else np.asarray(self.weights @ true[self.corners])

    def _at(self, values: Floats | None) -> float | None:
        if values is None:
            return None
        value = float(self.weights @ values[self.corners])
        return value if np.isfinite(value) else None


def first_hit(layers: Iterable[Layer], start: Floats, direction: Floats) -> Hit | None:
    """The nearest meeting of a ray with any of some surfaces."""
    best: Hit | None = None
    for layer in layers:
        found = layer.pick_mesh.cast(start, direction) if len(layer.cells) else None
        if found is not None and (best is None or found.distance < best.distance):
            point = start + found.distance * direction
            best = Hit(layer, found.distance, point, found.corners, found.weights)
    return best


def describe(hit: Hit, panel_key: str) -> Hover:
    """What a hit tells the user."""
    point = hit.true_point
    x, y, z = (float(c) for c in point)
    rho, delta = float(np.linalg.norm(point)), float(np.degrees(np.arctan2(np.hypot(x, y), z)))
    return Hover(panel_key, hit.layer.part, (x, y, z), rho, delta, hit.deviation, hit.scalar)
