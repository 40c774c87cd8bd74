"""The mesh of a pair with offset axes: a conjugate pinion flank, or one on a base cone of its own as a reference."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.analysis.contact_placing import FlankMesh
from gearstudio.theory.flank import Flank
from gearstudio.theory.hypoid.axes import Axes
from gearstudio.theory.hypoid.conjugate import ConjugateFlank
from gearstudio.theory.hypoid.pair import HypoidPair
from gearstudio.theory.modified import conjugate_on, flank_on, swept_on

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class HypoidMesh(FlankMesh):
    """A pinion flank and the wheel flank that it meets, on axes with an offset.

    Everything is as without an offset once the world is turned so that a tooth space of the wheel stands at azimuth
    0, and its origin is the wheel's pitch apex.
    """

    @cached_property
    def pinion_flank(self) -> Flank:
        """The conjugate flank, or with `PairGeometry.own_cone_pinion` the involute on a base cone of its own."""
        pinion = self.pair.pinion
        return swept_on(pinion, self.side) if self.pair.own_cone_pinion else flank_on(pinion, self.side)

    def contact_turn(self, psi: ArrayLike, rho: ArrayLike) -> Floats:
        """phi_1 at which a point of the conjugate flank touches in the perfect pair [rad]; about that on another."""
        if self.pair.own_cone_pinion:
            points = self.pinion_flank.at(psi, rho)
            psi, rho = self._conjugate.natural(points)
        envelope = self._conjugate.envelope
        turn = envelope.wheel_turn(psi, rho)
        return np.asarray(self.side * envelope.thinning - envelope.ratio * turn)

    def start_of_contact(self, v: ArrayLike) -> Floats:
        """u in [0, 1] on the pinion that the wheel's tip reaches: where the conjugate flank begins, shape (...)."""
        v = np.asarray(v, dtype=np.float64)
        if not self.pair.own_cone_pinion:
            return np.zeros_like(v)
        flank, start = self.pinion_flank, self._conjugate.limits(v)[0]
        ends = [flank.coordinates(u, v)[0] for u in (0.0, 1.0)]
        psi, _ = flank.natural_at(np.full_like(v, flank.member.mean_cone_distance), start)
        return np.clip((psi - ends[0]) / (ends[1] - ends[0]), 0.0, 1.0)

    def reach(self, v: ArrayLike) -> tuple[Floats, Floats]:
        """Polar angles on the pinion from which the wheel's tip reaches, and of its tip [rad], shape (...) each."""
        return self._conjugate.limits(v)

    @cached_property
    def _hypoid(self) -> HypoidPair:
        assert self.pair.hypoid is not None
        return self.pair.hypoid

    @cached_property
    def _conjugate(self) -> ConjugateFlank:
        return conjugate_on(replace(self.pair.pinion, reliefs=(None, None)), self.side)

    @cached_property
    def _axes(self) -> Axes:
        m = self.misalignment
        return self._hypoid.misaligned(m.offset, m.pinion_axial, m.wheel_axial, float(np.radians(m.shaft_angle_deg)))

    def _world(self, points: Floats, turn: ArrayLike) -> tuple[Floats, Floats, Floats]:
        """Coordinates of pinion points about the wheel's apex, the wheel's tooth space at azimuth 0."""
        axes = self._axes
        c, s = np.cos(axes.mean_azimuth), np.sin(axes.mean_azimuth)
        back = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
        frame, shift = back @ axes.pinion_frame, back @ (axes.pinion_apex - axes.wheel_apex)
        cos_t, sin_t = np.cos(turn), np.sin(turn)
        x, y, z = points[..., 0], points[..., 1], points[..., 2]
        x, y = x * cos_t - y * sin_t, x * sin_t + y * cos_t
        seen = [row[0] * x + row[1] * y + row[2] * z + d for row, d in zip(frame, shift, strict=True)]
        return seen[0], seen[1], seen[2]
