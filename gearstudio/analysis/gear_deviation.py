"""How far points are from the faces of a whole gear in theory, and which face they belong to; numpy alone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.chamfer import EndChamfer
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import side_of
from gearstudio.theory.section import Profile
from gearstudio.theory.vectors import spherical, wrapped

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Distance = Callable[[Floats], Floats]

_INSIDE = 1e-3
"""How far beyond its edges a face of the tooth may own points, of the depth of the tooth."""


@dataclass(frozen=True)
class GearTheory:
    """Distances from every face of a member, in its own frame with a tooth at azimuth 0.

    Attributes
    ----------
    member : MemberGeometry
    profile : Profile
    outline : ndarray, shape (n, 2), or None
        (radius, height) of the turned body [mm]; None for a tooth alone.
    chamfers : tuple of EndChamfer
    """

    member: MemberGeometry
    profile: Profile
    outline: Floats | None = None
    chamfers: tuple[EndChamfer, ...] = ()

    @cached_property
    def names(self) -> tuple[str, ...]:
        """``concave``, ``convex fillet``, ``root``, ``tip``, ``end``, ``body``, as far as the gear has them."""
        return tuple(self._faces)

    def distance(self, name: str, points: Floats) -> Floats:
        """Distance from a face, or from the surface it lies on, of whichever sign [mm].

        Parameters
        ----------
        name : str
        points : ndarray, shape (..., 3)
            Turned to the tooth at azimuth 0 (see `to_first`).
        """
        return self._faces[name](np.asarray(points, dtype=np.float64))

    def teeth_of(self, points: Floats, behind: float = 0.0) -> Ints:
        """Number, from 0, of the tooth whose pitch, moved on by an angle [rad], holds each point (..., 3)."""
        rho, _, phi = spherical(points)
        turned = phi - self.member.lengthwise.azimuth(rho) - behind
        return np.asarray(np.round(turned / self.member.pitch).astype(np.int64) % self.member.teeth)

    def to_first(self, points: Floats, teeth: Ints | int) -> Floats:
        """Points (..., 3) of these teeth turned to the tooth at azimuth 0."""
        angle = -np.asarray(teeth) * self.member.pitch
        x = np.cos(angle) * points[..., 0] - np.sin(angle) * points[..., 1]
        y = np.sin(angle) * points[..., 0] + np.cos(angle) * points[..., 1]
        return np.stack([x, y, np.broadcast_to(points[..., 2], x.shape)], axis=-1)

    def nearest(self, points: Floats) -> tuple[Ints, Floats]:
        """The face (index into ``names``) that each point is nearest to, and how far [mm].

        Parameters
        ----------
        points : ndarray, shape (n, 3)
            Turned to the tooth at azimuth 0. A flank or fillet owns only points at its own polar angles.
        """
        least, best = np.full(len(points), np.inf), np.zeros(len(points), dtype=np.int64)
        for index, name in enumerate(self.names):
            mine = np.flatnonzero(self._may_own(name, points))
            far = np.abs(self.distance(name, points[mine]))
            nearer = mine[far < least[mine]]
            least[mine] = np.minimum(least[mine], far)
            best[nearer] = index
        return best, least

    def names_of(self, points: Floats) -> Ints:
        """The face (index into ``names``) that points (n, k, 3), k of each of n faces, lie nearest to as a whole.

        The points are turned to the tooth at azimuth 0.
        """
        worst = [
            np.where(
                np.mean(self._may_own(name, points), axis=-1) >= 0.5,
                np.abs(self.distance(name, points)).max(axis=-1),
                np.inf,
            )
            for name in self.names
        ]
        return np.asarray(np.argmin(worst, axis=0))

    # ---- faces -----------------------------------------------------------------------------------------

    @cached_property
    def _face(self) -> tuple[float, float]:
        return self.member.inner_cone_distance, self.member.outer_cone_distance

    @cached_property
    def _faces(self) -> dict[str, Distance]:
        faces = dict[str, Distance]()
        for side in (-1, 1):
            flank = self.profile.flank(side)
            faces[flank.name] = flank.deviation
            faces[f"{flank.name} fillet"] = partial(self._from_fillet, side)
            if "meridian" in self.profile.below(side):
                faces[f"{flank.name} meridian"] = partial(self._from_straight, side)
        faces |= {"tip": self._from_tip, "root": self._from_root, "end": self._from_end}
        if self.outline is not None:
            faces["body"] = self._from_body
        return faces | {chamfer.title: chamfer.beyond for chamfer in self.chamfers}

    def _may_own(self, name: str, points: Floats) -> NDArray[np.bool_]:
        """Whether points lie at the polar angles, and on the side, of a face of the tooth."""
        side, _, word = name.partition(" ")
        if side not in ("concave", "convex"):
            return np.ones(points.shape[:-1], dtype=bool)
        rho, delta, phi = spherical(points)
        member = self.member
        sign = side_of(member.hand, side)
        place = self._place(rho, delta)
        foot, flank = self.profile.foot_angle(sign, place), self.profile.flank_foot(sign, place)
        low, high = {
            "fillet": (np.zeros_like(foot), foot),
            "meridian": (foot, flank),
            "": (np.maximum(foot, flank), np.full_like(foot, np.pi)),
        }[word]
        slack = _INSIDE * (member.tip_angle - member.root_angle)
        beside = sign * wrapped(phi - member.lengthwise.azimuth(rho))
        return np.asarray((delta >= low - slack) & (delta <= high + slack) & (beside > 0))

    def _from_fillet(self, side: int, points: Floats) -> Floats:
        """From the circle of theory 6 on the unit sphere, times rho."""
        rho, delta, phi = spherical(points)
        return self.profile.off_fillet(side, rho, delta, phi - self.member.lengthwise.azimuth(rho))

    def _from_straight(self, side: int, points: Floats) -> Floats:
        """From the great circle between fillet and flank on the unit sphere, times rho."""
        rho, delta, phi = spherical(points)
        return self.profile.off_straight(side, rho, delta, phi - self.member.lengthwise.azimuth(rho))

    def _from_tip(self, points: Floats) -> Floats:
        rho, delta, _ = spherical(points)
        return np.asarray((delta - self.member.limit_angle(self.member.tip_limit, self._place(rho, delta))) * rho)

    def _from_root(self, points: Floats) -> Floats:
        rho, delta, _ = spherical(points)
        return np.asarray((delta - self.member.limit_angle(self.member.root_limit, self._place(rho, delta))) * rho)

    def _from_end(self, points: Floats) -> Floats:
        """From the back or front end, whichever is nearer."""
        rho, delta, _ = spherical(points)
        place = self.member.end_distance(rho, delta)
        low, high = self._face
        toe, heel = low - place, place - high
        return np.asarray(np.where(np.abs(toe) < np.abs(heel), toe, heel))

    def _from_body(self, points: Floats) -> Floats:
        """From the nearest segment of the outline."""
        assert self.outline is not None
        flat = np.stack([np.hypot(points[..., 0], points[..., 1]), points[..., 2]], axis=-1)
        start, way = self.outline[:-1], np.diff(self.outline, axis=0)
        offset = flat[..., None, :] - start
        share = np.einsum("...ij,ij->...i", offset, way) / np.maximum(np.einsum("ij,ij->i", way, way), 1e-300)
        gap = offset - np.clip(share, 0.0, 1.0)[..., None] * way
        return np.asarray(np.linalg.norm(gap, axis=-1).min(axis=-1))

    def _place(self, rho: Floats, delta: Floats) -> Floats:
        low, high = self._face
        return np.clip(self.member.end_distance(rho, delta), 0.5 * low, 2.0 * high)
