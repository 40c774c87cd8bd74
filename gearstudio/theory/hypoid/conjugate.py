"""The pinion's flank conjugate to the wheel's: a flank like any other, given by the wheel's natural coordinates."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import FlankName, border_gap, name_of
from gearstudio.theory.hypoid.best_line import best_line
from gearstudio.theory.hypoid.edge import StartOfContact, start_of_contact
from gearstudio.theory.hypoid.envelope import Envelope
from gearstudio.theory.hypoid.inverse import Guess, generating_point
from gearstudio.theory.hypoid.pair import HypoidPair
from gearstudio.theory.hypoid.reach import Reach, reach_of
from gearstudio.theory.hypoid.second import derivatives
from gearstudio.theory.involute_flank import InvoluteFlank
from gearstudio.theory.vectors import dot, matched, quarter, spherical

Floats = NDArray[np.float64]

_FOOT_POINT_STEPS = 8
_EDGE_STEPS = 8
_FOOT_POINT_ACCURACY = 1e-12
_SECOND_ORDER = 3e-7
"""Distances [of rho] whose first value, exact to second order, is right to 1e-13."""
_KEPT = 64


@dataclass(frozen=True)
class ConjugateFlank:
    """A pinion flank that rolls with the wheel's without any error of transmission.

    Natural coordinates are psi [rad] and rho [mm] of the wheel's point that generates it. The working flank
    reaches from the start of contact, the image of the wheel's face cone, to the pinion's face cone.

    Attributes
    ----------
    member : MemberGeometry
        The pinion; its base cone is that of the reference `swept`.
    side : {+1, -1}
    envelope : Envelope
    lower : StartOfContact or None
        Another lower edge, as that of a fillet.
    alike : ConjugateFlank or None
        A flank of the same shape, whose start of contact and guesses serve this one too.
    """

    member: MemberGeometry
    side: int
    envelope: Envelope
    lower: StartOfContact | None = None
    alike: ConjugateFlank | None = field(default=None, repr=False, compare=False)

    @property
    def name(self) -> FlankName:
        """``concave`` or ``convex``."""
        return name_of(self.member.hand, self.side)

    @property
    def starts_on_base(self) -> bool:
        """Never: the lower edge is the start of contact, where the flank is regular."""
        return False

    @cached_property
    def swept(self) -> InvoluteFlank:
        """The nearest flank that one rigid line sweeps, on base cone and line of its own (`best_line.best_line`)."""
        return best_line(self)

    def limits(self, v: ArrayLike) -> tuple[Floats, Floats]:
        """Polar angles of start of contact and tip at places v along the face, (...) each [rad]."""
        m = self.member
        v = np.asarray(v, dtype=np.float64)
        return self._start(v), m.limit_angle(m.tip_limit, self.member.along_face(v))

    def coordinates(self, u: ArrayLike, v: ArrayLike) -> tuple[Floats, Floats]:
        """psi [rad] and rho [mm] of the wheel at (u, v); the polar angle is linear in u.

        Raises
        ------
        GeometryError
            The flank has no such point.
        """
        u, v = matched(u, v)
        low, high = self.limits(v)
        delta = low + u * (high - low)
        return self.generating(self.member.cone_distance(self.member.along_face(v), delta), delta)

    def points(self, u: ArrayLike, v: ArrayLike) -> Floats:
        """Points of the working flank, shape (..., 3) [mm]."""
        return self.at(*self.coordinates(u, v))

    def normals(self, u: ArrayLike, v: ArrayLike) -> Floats:
        """Unit normals out of the metal, shape (..., 3)."""
        return self.normals_at(*self.coordinates(u, v))

    def along(self, share: ArrayLike) -> Floats:
        """Places v at which shares in [0, 1] divide the face for an interpolation, as on the wheel."""
        m = self.envelope.wheel.member
        rho_u = m.lengthwise.divided(m.inner_cone_distance, m.outer_cone_distance, share)
        return m.face_share(rho_u)

    def evenly_divided(self, n_u: int, n_v: int) -> Floats:
        """Points of the working flank at evenly spaced polar angles and places along the face, (n_u, n_v, 3)."""
        return self.points(np.linspace(0.0, 1.0, n_u)[:, None], np.linspace(0.0, 1.0, n_v))

    def points_at(self, rho: ArrayLike, polar_angle: ArrayLike) -> Floats:
        """Points at distance rho from the pitch apex [mm] and polar angle [rad], shape (..., 3).

        Raises
        ------
        GeometryError
            The flank has no such point.
        """
        rho, delta = matched(rho, polar_angle)
        return self.at(*self.generating(rho, delta))

    def lower_angle(self, rho: ArrayLike) -> Floats:
        """Polar angle of the lower edge at distances from the pitch apex [rad]."""
        rho, m = np.asarray(rho, dtype=np.float64), self.member
        delta = np.full_like(rho, m.pitch_angle)
        for _ in range(_EDGE_STEPS):
            delta = self._start(m.face_share(m.end_distance(rho, delta)))
        return delta

    def trace(self, v: ArrayLike) -> Floats:
        """Points where the flank meets the pinion's pitch cone, shape (..., 3)."""
        rho = self.member.along_face(v)
        return self.at(*self.generating(rho, np.full_like(rho, self.member.pitch_angle)))

    def at(self, psi: ArrayLike, rho: ArrayLike, /) -> Floats:
        """Points at natural coordinates, shape (..., 3)."""
        return self.envelope.points(psi, rho)

    def normals_at(self, psi: ArrayLike, rho: ArrayLike, /) -> Floats:
        """Unit normals out of the metal at natural coordinates, shape (..., 3)."""
        return self.envelope.at(psi, rho).normal

    def derivatives_at(self, psi: ArrayLike, rho: ArrayLike, /) -> tuple[Floats, Floats, Floats, Floats, Floats]:
        """First and second derivatives by the natural coordinates, shape (..., 3) each, in closed form."""
        psi, rho = matched(psi, rho)
        return derivatives(self.envelope, psi, rho)

    def locate(self, points: ArrayLike) -> tuple[Floats, Floats, Floats]:
        """Spherical coordinates rho [mm], delta_k [rad], phi [rad] about the pinion's pitch apex, (...) each."""
        return spherical(points)

    def natural(self, points: ArrayLike) -> tuple[Floats, Floats]:
        """Natural coordinates of the flank at points on or near it, (...) each."""
        return self.natural_at(*self.locate(points)[:2])

    def natural_at(self, rho: ArrayLike, polar_angle: ArrayLike) -> tuple[Floats, Floats]:
        """Natural coordinates at places on the flank, or of the nearest one not far beyond its edges, (...) each."""
        rho, delta = matched(rho, polar_angle)
        return self.generating(*self._within(rho, delta))

    def azimuth(self, rho: ArrayLike, polar_angle: ArrayLike) -> Floats:
        """phi(rho, delta_k) of the flank, or of the nearest place not far beyond its edges [rad]."""
        return self.locate(self.at(*self.natural_at(rho, polar_angle)))[2]

    def lever(self, rho: ArrayLike, polar_angle: ArrayLike) -> Floats:
        """Normal distance per difference in azimuth [mm/rad]."""
        point, normal = self._surface(*self.natural_at(rho, polar_angle))
        return np.asarray(self.side * dot(quarter(point), normal))

    def deviation(self, points: ArrayLike) -> Floats:
        """Signed normal distance of points from the flank, positive where metal is added.

        Parameters
        ----------
        points : array_like, shape (..., 3)
            Near this flank of the tooth centred at azimuth 0 [mm].

        Returns
        -------
        ndarray, shape (...)
            e [mm]: the foot point is iterated. Far beyond its edges the flank is continued by its tangent planes.
        """
        points = np.asarray(points, dtype=np.float64)
        moved, gap = points, np.zeros(points.shape[:-1])
        for _ in range(_FOOT_POINT_STEPS):
            rho, delta, _ = self.locate(moved)
            foot, normal = self._surface(*self.natural_at(rho, delta))
            before, gap = gap, dot(points - foot, normal)
            settled = np.abs(gap - before) <= _FOOT_POINT_ACCURACY * rho
            if np.all(settled | (np.abs(gap) <= _SECOND_ORDER * rho)):
                break
            moved = points - gap[..., None] * normal
        return gap

    def edge_deviation(self, points: Floats) -> float:
        """Farthest that the border of a surface (n_u, n_v, 3) lies from the edges of the working flank [mm]."""
        return border_gap(self, points)

    def _surface(self, psi: Floats, rho: Floats) -> tuple[Floats, Floats]:
        """Points and unit normals out of the metal at natural coordinates."""
        made = self.envelope.at(psi, rho)
        return made.point, made.normal

    @cached_property
    def _start(self) -> StartOfContact:
        if self.lower is not None:
            return self.lower
        return start_of_contact(self.envelope, self.member) if self.alike is None else self.alike._start

    @cached_property
    def _reach(self) -> Reach:
        return reach_of(self)

    def generating(self, rho: Floats, delta: Floats) -> tuple[Floats, Floats]:
        """Natural coordinates at distances from the pitch apex [mm] and polar angles [rad]; raises as `coordinates`."""
        m, like = self.member, self.alike or self
        guess = None if like._guess is None else like._guess.at(*like._shares(rho, delta))
        return generating_point(self.envelope, rho, delta, m.lengthwise.mean_cone_distance, m.pitch_angle, guess)

    @cached_property
    def _guess(self) -> Guess | None:
        """Where to look for generating points, or None where the flank is not regular enough."""
        v, u = (nodes.ravel() for nodes in Guess.places())
        low, high = self.limits(v)
        delta = low + u * (high - low)
        m, rho = self.member, self.member.cone_distance(self.member.along_face(v), delta)
        try:
            found = generating_point(self.envelope, rho, delta, m.lengthwise.mean_cone_distance, m.pitch_angle)
        except GeometryError:
            return None
        return Guess.through(*found)

    def _shares(self, rho: Floats, delta: Floats) -> tuple[Floats, Floats]:
        """v and u of places on the flank."""
        m = self.member
        v = m.face_share(m.end_distance(rho, delta))
        low, high = self.limits(v)
        return v, np.asarray((delta - low) / (high - low))

    def _within(self, rho: Floats, delta: Floats) -> tuple[Floats, Floats]:
        """The nearest place not far beyond the edges."""
        m, reach = self.member, self._reach
        share = m.face_share(m.end_distance(rho, delta))
        v = np.clip(share, -reach.beside, 1 + reach.beside)
        low, high = self.limits(v)
        delta = np.clip(delta, low - reach.below * (high - low), high + reach.above * (high - low))
        return m.cone_distance(self.member.along_face(v), delta), delta


@lru_cache(maxsize=_KEPT)
def envelope(pair: HypoidPair, side: int) -> Envelope:
    """The envelope that the wheel's flank on a side makes of the pinion's; remembered."""
    wheel = wheel_flank(pair, pair.flank_name("wheel", side))
    full = np.pi / pair.given.wheel_teeth - pair.half_space_azimuth
    generator = InvoluteFlank(replace(wheel.member, half_tooth_azimuth=full), side)
    return Envelope(generator, pair.axes, pair.ratio, pair.half_space_azimuth, pair.ratio * pair.backlash_azimuth)


def wheel_flank(pair: HypoidPair, name: FlankName) -> InvoluteFlank:
    """The wheel's flank: a spherical involute on the base cone of this flank."""
    return InvoluteFlank(pair.member("wheel", name), pair.side("wheel", name))


@lru_cache(maxsize=_KEPT)
def _shape(pair: HypoidPair, name: FlankName) -> ConjugateFlank:
    """The flank that has the tables of all that differ from it in thickness and fillets alone."""
    return _made(pair, name)


def _made(pair: HypoidPair, name: FlankName) -> ConjugateFlank:
    side = pair.side("pinion", name)
    return ConjugateFlank(pair.member("pinion", name), side, envelope(pair, side))


def pinion_flank(pair: HypoidPair, name: FlankName) -> ConjugateFlank:
    """The pinion's conjugate flank, not looked at for undercut: `undercut.trouble` tells of that."""
    bare = replace(pair, given=replace(pair.given, backlash=0.0, fillet_factor=0.0))
    return replace(_made(pair, name), alike=_shape(bare, name))
