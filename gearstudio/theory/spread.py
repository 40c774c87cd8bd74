"""Grids of points on the faces of a tooth as far as the chamfers at its ends leave them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.nurbs import NurbsSurface
from gearstudio.theory.chamfer import EndChamfer, EndCut, end_cut

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Spread:
    """A face over [0, 1]², cut off where chamfers end it."""

    surface: NurbsSurface
    cuts: tuple[EndCut, ...]

    @staticmethod
    def of(surface: NurbsSurface, chamfers: Sequence[EndChamfer]) -> Spread:
        """A face of a tooth with chamfers."""
        found = (end_cut(surface, chamfer) for chamfer in chamfers)
        return Spread(surface, tuple(cut for cut in found if cut is not None))

    @property
    def breaks(self) -> Floats:
        """Where along u a chamfer begins or ends, and both ends of the face."""
        return np.unique([0.0, *(u for cut in self.cuts for u in (cut.first, cut.last)), 1.0])

    def steps(self, count: int) -> list[int]:
        """About so many steps along u, divided among the spans between the breaks."""
        return [max(1, int(np.ceil(count * share - 1e-6))) for share in np.diff(self.breaks)]

    def places(self, steps: Sequence[int]) -> Floats:
        """u at steps in every span between the breaks, both ends included."""
        spans = zip(self.breaks[:-1], self.breaks[1:], steps, strict=True)
        return np.append(np.concatenate([np.linspace(a, b, n, endpoint=False) for a, b, n in spans]), 1.0)

    def between(self, u: Floats, share: Floats) -> Floats:
        """v at shares of the way from toe to heel at each u, shape (len(u), len(share))."""
        low, high = np.zeros_like(u), np.ones_like(u)
        for cut in self.cuts:
            if cut.heel:
                high = cut.v(u)
            else:
                low = cut.v(u)
        return np.asarray(low[:, None] + share * (high - low)[:, None])

    def grid(self, steps: Sequence[int], share: Floats) -> Floats:
        """Points at steps in every span along u and shares of the way from toe to heel, shape (n, m, 3)."""
        u = self.places(steps)
        return self.surface.points(u[:, None], self.between(u, share)) if self.cuts else self.surface.grid(u, share)
