"""Fillets below conjugate flanks, which are given by no formula of the place along the face."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.hypoid.conjugate import ConjugateFlank
from gearstudio.theory.hypoid.edge import StartOfContact
from gearstudio.theory.hypoid.fillets import BEYOND, Circle, FilletError
from gearstudio.theory.hypoid.modified import ModifiedConjugate
from gearstudio.theory.hypoid.straight import Tangent, Touched
from gearstudio.theory.hypoid.undercut import LEAST_AREA_RATIO
from gearstudio.theory.relief import FlankRelief
from gearstudio.theory.vectors import dot, quarter, wrapped

Floats = NDArray[np.float64]

_NODES = 25
_STEP = 1e-5
_STEPS = 20
_ACCURACY = 1e-8
"""Last step of a root [rad]: the next would be nearly its square."""
_LOWEST = (0.15, 0.25, 0.35, 0.5, 0.65, 0.8, 1.0)
_SAME = 1e-6


@dataclass(frozen=True)
class _Solved:
    """Circles at nodes along the face, or the Chebyshev coefficients of them, and where the flank is touched."""

    radius: Floats
    centre_azimuth: Floats
    foot_angle: Floats
    touched: Touched

    def fitted(self, nodes: Floats) -> _Solved:
        """The coefficients."""
        t = self.touched
        values = np.stack([self.radius, self.centre_azimuth, self.foot_angle, t.angle, t.azimuth, t.lean], axis=-1)
        radius, azimuth, foot, *touched = chebyshev.chebfit(nodes, values, len(nodes) - 1).T
        return _Solved(radius, azimuth, foot, Touched(*touched))


@dataclass(frozen=True)
class ConjugateSide:
    """A fillet below a conjugate flank, solved at nodes along the face and held as polynomials of the place.

    Attributes
    ----------
    whole : ConjugateFlank
        From the start of contact.
    radius : float
        Of the circle [rad]. Where the flank does not reach down to it, the circle is the larger one that touches
        the flank at the lowest place where it is regular.
    like : ConjugateSide or None
        Of a shorter face with the same middle, whose fillet goes on here.
    on_tangent : bool
        Whether the circle has its radius all the same, and touches the tangent of that lowest place below the flank.
    """

    whole: ConjugateFlank
    radius: float
    like: ConjugateSide | None = None
    on_tangent: bool = False

    @cached_property
    def straight(self) -> Tangent | None:
        """See `FilletSide`."""
        return Tangent(self._touched, lambda rho_u: self.circle(rho_u).foot_angle) if self.on_tangent else None

    @property
    def is_larger(self) -> bool:
        """Whether the circle is larger than was asked for."""
        return bool(self._series.radius[0] > (1 + _SAME) * self.radius)

    @cached_property
    def flank(self) -> ConjugateFlank:
        """See `FilletSide`."""
        if self.like is None:
            return replace(self.whole, lower=StartOfContact(self._lower, BEYOND))
        longer = self.whole.member.face_width / self.like.whole.member.face_width
        return replace(self.whole, lower=StartOfContact(self.like._lower, (0.5 + BEYOND) / longer - 0.5))

    def smaller(self, share: float) -> ConjugateSide:
        """See `FilletSide`."""
        return replace(self, radius=share * self.radius)

    def extended(self, member: MemberGeometry) -> ConjugateSide:
        """See `FilletSide`."""
        return replace(self, whole=replace(self.flank, member=member, lower=None, alike=None), like=self)

    @property
    def _lower(self) -> Floats:
        """Chebyshev coefficients of the polar angle at which the flank begins."""
        return self._series.touched.angle if self.on_tangent else self._series.foot_angle

    def _touched(self, rho_u: Floats) -> Touched:
        if self.like is not None:
            return self.like._touched(rho_u)
        s = self._series.touched
        return Touched(*chebyshev.chebval(self._along(rho_u), np.stack([s.angle, s.azimuth, s.lean], axis=-1)))

    def circle(self, rho_u: Floats) -> Circle:
        """See `FilletSide`."""
        if self.like is not None:
            return self.like.circle(rho_u)
        m, s = self.whole.member, self._series
        t = self._along(rho_u)
        radius, azimuth, foot = chebyshev.chebval(t, np.stack([s.radius, s.centre_azimuth, s.foot_angle], axis=-1))
        return Circle(radius, m.limit_angle(m.root_limit, rho_u) + radius, azimuth, foot)

    def tip_azimuth(self, rho_u: Floats) -> Floats:
        """See `FilletSide`."""
        return np.asarray(chebyshev.chebval(self._along(rho_u), self._tip), dtype=np.float64)

    @property
    def relief(self) -> FlankRelief | None:
        """See `FilletSide`."""
        return self.whole.relief if isinstance(self.whole, ModifiedConjugate) else None

    def turn(self, rho: Floats, delta: Floats) -> tuple[Floats, Floats]:
        """See `FilletSide`; the slope is a difference upwards, for below the foot there may be no flank."""
        here, above, beyond = (self._turn(rho, delta + k * _STEP) for k in range(3))
        return here, (4 * above - 3 * here - beyond) / (2 * _STEP)

    def _turn(self, rho: Floats, delta: Floats) -> Floats:
        assert self.relief is not None
        made = self.whole.envelope.at(*self.flank.natural_at(rho, delta))
        return np.asarray(-self.relief.value(rho, delta) / dot(quarter(made.point), made.normal))

    @cached_property
    def _tip(self) -> Floats:
        """Chebyshev coefficients of the tip's azimuth."""
        nodes, m = chebyshev.chebpts1(_NODES), self.whole.member
        rho_u = m.along_face(0.5 + (0.5 + BEYOND) * nodes)
        return np.asarray(chebyshev.chebfit(nodes, self._line(rho_u, m.limit_angle(m.tip_limit, rho_u))[0], _NODES - 1))

    def _along(self, rho_u: Floats) -> Floats:
        """Where the polynomials are taken, -1 to 1 from a little before the toe to a little beyond the heel."""
        return (self.whole.member.face_share(rho_u) - 0.5) / (0.5 + BEYOND)

    @cached_property
    def _series(self) -> _Solved:
        """Chebyshev coefficients of what is solved over the face and a little beyond."""
        nodes, m = chebyshev.chebpts1(_NODES), self.whole.member
        rho_u = m.along_face(0.5 + (0.5 + BEYOND) * nodes)
        root, start = m.limit_angle(m.root_limit, rho_u), self.whole.limits(m.face_share(rho_u))[0]
        if np.any(start <= root):
            raise FilletError(
                f"contact on the {m.name}'s {self.whole.name} flank starts below its root cone",
                "use a larger clearance or shallower teeth",
            )
        return self._solved(rho_u, root, start).fitted(nodes)

    def _solved(self, rho_u: Floats, root: Floats, start: Floats) -> _Solved:
        if self.on_tangent:
            return self._touching_tangent(root, next(self._regular(rho_u, root, start)))
        try:
            return self._touching_flank(rho_u, root, start)
        except GeometryError:
            return self._touching_lowest(root, self._regular(rho_u, root, start))

    def _touching_flank(self, rho_u: Floats, root: Floats, start: Floats) -> _Solved:
        """Circles of the radius: the foot is sought on the flank."""

        def off(foot: Floats) -> Floats:
            return self._on_flank(rho_u, foot).largest(root) - self.radius

        foot = _secant(off, root + 0.6 * self.radius, root + 0.7 * self.radius)
        if np.any(foot > start) or np.any(foot < root):
            raise GeometryError(
                f"a fillet of {self.radius * self.whole.member.outer_cone_distance:.4g} mm on the "
                f"{self.whole.member.name} reaches into the {self.whole.name} flank that meets the wheel's tip"
            )
        self._require_regular(rho_u, foot, start)
        touched = self._on_flank(rho_u, foot)
        return _Solved(np.full_like(foot, self.radius), touched.circle(self.radius, root)[0], foot, touched)

    def _touching_lowest(self, root: Floats, candidates: Iterator[Touched]) -> _Solved:
        """Circles that touch the flank at the lowest place where it is regular."""
        largest = 0.0
        for touched in candidates:
            radius = touched.largest(root)
            if np.all(radius >= self.radius):
                return _Solved(radius, touched.circle(radius, root)[0], touched.angle, touched)
            largest = max(largest, float(radius.min()))
        m = self.whole.member
        raise FilletError(
            f"no fillet of {self.radius * m.outer_cone_distance:.4g} mm joins root and start of contact on the "
            f"{m.name}'s {self.whole.name} flank",
            "use a smaller fillet factor or a larger clearance",
            largest * m.outer_cone_distance,
        )

    def _touching_tangent(self, root: Floats, touched: Touched) -> _Solved:
        """Circles of the radius that touch the tangent of the lowest place where the flank is regular."""
        azimuth, foot = touched.circle(self.radius, root)
        return _Solved(np.full_like(foot, self.radius), azimuth, foot, touched)

    def _regular(self, rho_u: Floats, root: Floats, start: Floats) -> Iterator[Touched]:
        """Places on the flank, from the root up, above which it is regular."""
        for share in _LOWEST:
            foot = root + share * (start - root)
            try:
                self._require_regular(rho_u, foot, start)
            except GeometryError:
                continue
            yield self._on_flank(rho_u, foot)

    def _require_regular(self, rho_u: Floats, foot: Floats, start: Floats) -> None:
        share = np.array([[0.0], [0.5]])
        delta = foot + share * (start - foot)
        m = self.whole.member
        p = self.whole.envelope.at(*self.whole.generating(m.cone_distance(rho_u, delta), delta))
        if np.any(p.area_ratio <= LEAST_AREA_RATIO):
            raise GeometryError("the flank is undercut below the start of contact")

    def _on_flank(self, rho_u: Floats, foot: Floats) -> Touched:
        """Places of the flank at polar angles."""
        phi, slope = self._line(rho_u, foot)
        return Touched(foot, phi, np.sin(foot) * slope)

    def _line(self, rho_u: Floats, delta: Floats) -> tuple[Floats, Floats]:
        """Azimuth of the flank in its sections, towards the space, and its slope over the polar angle."""
        m, side = self.whole.member, self.whole.side
        rho = m.cone_distance(rho_u, delta)
        p = self.whole.envelope.at(*self.whole.generating(rho, delta))
        x, y, z = np.moveaxis(p.point, -1, 0)
        radius = np.hypot(x, y)
        theta, turn = m.lengthwise.azimuth(rho), m.lengthwise.azimuth_slope(rho)
        azimuth = np.arctan2(y, x) - theta
        c, s = x / radius, y / radius
        normal = p.normal
        n_phi = c * normal[..., 1] - s * normal[..., 0]
        n_out = c * normal[..., 0] + s * normal[..., 1]
        n_delta = (z * n_out - radius * normal[..., 2]) / rho
        n_rho = (radius * n_out + z * normal[..., 2]) / rho
        stretch = rho * np.tan(delta - m.pitch_angle) if m.ends != "sphere" else np.zeros_like(rho)
        along = rho * n_delta + stretch * (n_rho + rho * np.sin(delta) * turn * n_phi)
        slope = -along / (rho * np.sin(delta) * n_phi)
        return side * wrapped(azimuth), side * slope


def _secant(function: Callable[[Floats], Floats], before: Floats, now: Floats) -> Floats:
    """Roots of a function near two starts, all at once."""
    f_before = function(before)
    for _ in range(_STEPS):
        f_now = function(now)
        difference = np.where(f_now == f_before, 1.0, f_now - f_before)
        step = -f_now * (now - before) / difference
        before, f_before, now = now, f_now, now + step
        if np.all(np.abs(step) <= _ACCURACY):
            return now
    raise GeometryError("the fillet of a hypoid tooth could not be found")
