"""Fillets below conjugate flanks, which are given by no formula of the place along the face."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.hypoid.conjugate import ConjugateFlank
from gearstudio.theory.hypoid.edge import StartOfContact
from gearstudio.theory.hypoid.fillets import BEYOND, Circle, places
from gearstudio.theory.hypoid.modified import ModifiedConjugate
from gearstudio.theory.hypoid.undercut import LEAST_AREA_RATIO
from gearstudio.theory.relief import FlankRelief
from gearstudio.theory.vectors import dot, quarter

Floats = NDArray[np.float64]

_NODES = 25
_STEP = 1e-5
_STEPS = 20
_ACCURACY = 1e-8
"""Last step of a root [rad]: the next would be nearly its square."""
_LOWEST = (0.15, 0.25, 0.35, 0.5, 0.65, 0.8, 1.0)


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
    """

    whole: ConjugateFlank
    radius: float
    like: ConjugateSide | None = None

    @property
    def on_meridian(self) -> bool:
        """Never."""
        return False

    @cached_property
    def flank(self) -> ConjugateFlank:
        """See `FilletSide`."""
        if self.like is None:
            return replace(self.whole, lower=StartOfContact(self._series.foot_angle, BEYOND))
        longer = self.whole.member.face_width / self.like.whole.member.face_width
        return replace(self.whole, lower=StartOfContact(self.like._series.foot_angle, (0.5 + BEYOND) / longer - 0.5))

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

    def start_azimuth(self) -> float:
        """There is no meridian."""
        raise NotImplementedError

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
        rho_u = places(m, 0.5 + (0.5 + BEYOND) * nodes)
        return np.asarray(chebyshev.chebfit(nodes, self._line(rho_u, m.limit_angle(m.tip_limit, rho_u))[0], _NODES - 1))

    def _along(self, rho_u: Floats) -> Floats:
        """Where the polynomials are taken, -1 to 1 from a little before the toe to a little beyond the heel."""
        return (_shares(self.whole.member, rho_u) - 0.5) / (0.5 + BEYOND)

    @cached_property
    def _series(self) -> Circle:
        """Chebyshev coefficients of the circles over the face and a little beyond."""
        nodes = chebyshev.chebpts1(_NODES)
        found = self._solved(places(self.whole.member, 0.5 + (0.5 + BEYOND) * nodes))

        def series(values: Floats) -> Floats:
            return np.asarray(chebyshev.chebfit(nodes, values, _NODES - 1), dtype=np.float64)

        return Circle(series(found.radius), found.centre_angle, series(found.centre_azimuth), series(found.foot_angle))

    def _solved(self, rho_u: Floats) -> Circle:
        m = self.whole.member
        root, start = m.limit_angle(m.root_limit, rho_u), self.whole.limits(_shares(m, rho_u))[0]
        wanted = np.full_like(rho_u, self.radius)
        if np.any(start <= root):
            raise GeometryError(f"contact on the {m.name}'s {self.whole.name} flank starts below its root cone")
        try:
            return self._touching_flank(rho_u, root, start, wanted)
        except GeometryError:
            return self._touching_lowest(rho_u, root, start, wanted)

    def _touching_flank(self, rho_u: Floats, root: Floats, start: Floats, radius: Floats) -> Circle:
        """Circles of a radius: the foot is sought on the flank."""

        def off(foot: Floats) -> Floats:
            return self._centre(rho_u, foot, radius)[0] - root - radius

        foot = _secant(off, root + 0.6 * radius, root + 0.7 * radius)
        if np.any(foot > start) or np.any(foot < root):
            raise GeometryError(
                f"a fillet of {self.radius * self.whole.member.outer_cone_distance:.4g} mm on the "
                f"{self.whole.member.name} reaches into the {self.whole.name} flank that meets the wheel's tip"
            )
        self._require_regular(rho_u, foot, start)
        centre, azimuth = self._centre(rho_u, foot, radius)
        return Circle(radius, centre, azimuth, foot)

    def _touching_lowest(self, rho_u: Floats, root: Floats, start: Floats, least: Floats) -> Circle:
        """Circles that touch the flank at the lowest place where it is regular."""
        for share in _LOWEST:
            foot = root + share * (start - root)
            try:
                self._require_regular(rho_u, foot, start)
            except GeometryError:
                continue

            def off(radius: Floats, foot: Floats = foot) -> Floats:
                return self._centre(rho_u, foot, radius)[0] - root - radius

            radius = _secant(off, 1.5 * (foot - root), 2.0 * (foot - root))
            if np.any(radius < least):
                continue
            centre, azimuth = self._centre(rho_u, foot, radius)
            return Circle(radius, centre, azimuth, foot)
        m = self.whole.member
        raise GeometryError(
            f"no fillet of {float(least[0]) * m.outer_cone_distance:.4g} mm joins root and start of contact on the "
            f"{m.name}'s {self.whole.name} flank; use a smaller fillet factor or a larger clearance"
        )

    def _require_regular(self, rho_u: Floats, foot: Floats, start: Floats) -> None:
        share = np.array([[0.0], [0.5]])
        delta = foot + share * (start - foot)
        m = self.whole.member
        p = self.whole.envelope.at(*self.whole.generating(m.cone_distance(rho_u, delta), delta))
        if np.any(p.area_ratio <= LEAST_AREA_RATIO):
            raise GeometryError("the flank is undercut below the start of contact")

    def _centre(self, rho_u: Floats, foot: Floats, radius: Floats) -> tuple[Floats, Floats]:
        """Polar angle and azimuth of the centres of circles that touch the flank at polar angles."""
        phi, slope = self._line(rho_u, foot)
        lean = np.sin(foot) * slope
        norm = np.hypot(1.0, lean)
        down, onward = -lean / norm, 1 / norm
        cos_r, sin_r, cos_f, sin_f = np.cos(radius), np.sin(radius), np.cos(foot), np.sin(foot)
        height = cos_r * cos_f - sin_r * down * sin_f
        out = cos_r * sin_f + sin_r * down * cos_f
        return np.arctan2(np.hypot(out, sin_r * onward), height), phi + np.arctan2(sin_r * onward, out)

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
        return side * (np.remainder(azimuth + np.pi, 2 * np.pi) - np.pi), side * slope


def _shares(member: MemberGeometry, rho_u: Floats) -> Floats:
    return np.asarray((rho_u - member.inner_cone_distance) / member.face_width)


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
