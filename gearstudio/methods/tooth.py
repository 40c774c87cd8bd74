"""All faces of one tooth and its space: the flanks as a method makes them, and their neighbours grafted on.

Every face is a surface over [0, 1]²: its first parameter runs along the profile with growing azimuth, the
second from toe to heel, so that its natural normal points out of the metal. The lengthwise space of all other
faces holds the flanks' own, so that neighbours share their edge exactly, whatever a flank's deviation is.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from gearstudio.catalogue import Variant
from gearstudio.errors import GeometryError
from gearstudio.methods import Construction, Target, method
from gearstudio.methods.base import SAFETY
from gearstudio.methods.grafts import (
    Edge,
    across_angles,
    blended,
    edge_of,
    lower_angles,
    own_coordinates,
    profile_space,
    reversed_across,
)
from gearstudio.methods.space import Points, Space, fitted, space_v
from gearstudio.methods.trimming import trimmed
from gearstudio.nurbs import NurbsSurface
from gearstudio.theory.chamfer import EndChamfer
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import name_of
from gearstudio.theory.profile import profile_of
from gearstudio.theory.section import Profile, Segment

Floats = NDArray[np.float64]

_EDGE_SHARE = 0.1
_FOOT_SAMPLES = 33
_LEAST_FILLET = 0.3
_TURNED_SHARE = 0.2
"""Part of the goal for faces that micro-geometry turns, so that they stay tangent to the flank as well."""


@dataclass(frozen=True)
class ToothFace:
    """One face of a tooth: ``kind`` with the side it is on (+1, -1, or 0), and its surface."""

    kind: Segment
    side: int
    surface: NurbsSurface

    def title(self, hand: int) -> str:
        """What it is called on a tooth of a hand: ``concave``, ``concave fillet``, ``tip``, ..."""
        flank = name_of(hand, self.side)
        return self.kind if self.side == 0 else flank if self.kind == "flank" else f"{flank} {self.kind}"


@dataclass(frozen=True)
class Tooth:
    """The faces of one pitch in the order of azimuth, from the fillet at smaller azimuth to the root beyond.

    ``member`` and ``profile`` are without the micro-geometry of the design where the method cannot follow it.
    ``chamfers`` end them at toe and heel; the faces go on beyond.
    """

    member: MemberGeometry
    profile: Profile
    faces: tuple[ToothFace, ...]
    constructions: dict[str, Construction]
    chamfers: tuple[EndChamfer, ...] = ()


def build_tooth(member: MemberGeometry, method_id: str, variant: Variant, target: Target) -> Tooth:
    """Model every face of a tooth.

    Raises
    ------
    GeometryError
        There is no tooth space, or a flank cannot be cut off at the limits of the tooth.
    ModellingError
        The method could not make a flank.
    """
    profile = profile_of(member)
    flanks = {side: profile.flank(side) for side in (-1, 1)}
    built = {side: method(method_id).build(flank, variant, target) for side, flank in flanks.items()}
    if any(construction.instead is not None for construction in built.values()):
        profile = profile.unmodified({side: built[side].instead or flanks[side] for side in (-1, 1)})
    goal = _EDGE_SHARE * target.tolerance
    surfaces = {side: trimmed(profile.flank(side), built[side].surface, goal) for side in (-1, 1)}
    for side in (-1, 1):
        _check_foot(profile, side, surfaces[side])
    faces = graft(profile, surfaces, SAFETY * target.tolerance)
    return Tooth(profile.member, profile, faces, {flanks[side].name: built[side] for side in (-1, 1)})


def graft(profile: Profile, flanks: dict[int, NurbsSurface], goal: float) -> tuple[ToothFace, ...]:
    """All faces of a tooth from its flanks by side, the others fitted within a goal [mm]."""
    return _Grafting(profile, flanks, goal).faces()


def _check_foot(profile: Profile, side: int, surface: NurbsSurface) -> None:
    """Refuse a flank whose lower edge leaves no room for the fillet."""
    member = profile.member
    rho_u, delta, _ = own_coordinates(member, surface.grid([0.0], np.linspace(0.0, 1.0, _FOOT_SAMPLES))[0])
    root = member.limit_angle(member.root_limit, rho_u)
    if np.any(delta - root < _LEAST_FILLET * (profile.foot_angle(side, rho_u) - root)):
        raise GeometryError(
            f"a {member.name} flank reaches into the root; the variant is too inaccurate for this design "
            "to make a tooth of"
        )


@dataclass
class _Grafting:
    """Fits the faces beside the flanks; ``v`` is their common lengthwise space, which grows as a face asks."""

    profile: Profile
    flanks: dict[int, NurbsSurface]
    goal: float
    made: dict[tuple[str, int], NurbsSurface] = field(default_factory=dict)

    def faces(self) -> tuple[ToothFace, ...]:
        self._fit_in_one_space()

        def face(name: Segment, side: int) -> ToothFace:
            surface = self.flanks[side] if name == "flank" else self.made[name, side]
            return ToothFace(name, side, reversed_across(surface) if side > 0 else surface)

        first, last = self.profile.below(-1), self.profile.below(1)
        faces = [face(name, -1) for name in (*first, "flank")]
        faces += [face("tip", 0), *(face(name, 1) for name in reversed((*last, "flank")))]
        return (*faces, face("root", 0)) if self.profile.has_root else tuple(faces)

    def _fit_in_one_space(self) -> None:
        """A face that needs a larger space makes the others, whose free edges must be the same, be fitted again."""
        space = space_v(self.flanks[-1]).joined(space_v(self.flanks[1]))
        while True:
            first = space
            for side in (-1, 1):
                below = self.profile.below(side)
                for name in below:
                    space = self._fit(name, side, self._lower(name, side, below[-1]), space)
            space = self._fit("tip", 0, self._tip(), space)
            if self.profile.has_root:
                space = self._fit("root", 0, self._root(), space)
            if len(space.knots) == len(first.knots):
                return

    def _fit(self, name: Segment, side: int, points: Points, space: Space) -> Space:
        what = f"{self.profile.member.name} {name}"
        turned = side != 0 and self.profile.shift_on(side) is not None
        surface = fitted(what, profile_space(), space, points, _TURNED_SHARE * self.goal if turned else self.goal)
        self.made[name, side] = surface
        return space_v(surface)

    def _lower(self, name: Segment, side: int, highest: Segment) -> Points:
        def top(y: Floats) -> Edge:
            return self._edge(self.flanks[side], 0.0, y) if name == highest else self._free(y)

        angles = lower_angles(self.profile, name, side)
        return blended(self.profile.member, angles, self._free, top, self.profile.shift_on(side))

    def _tip(self) -> Points:
        return blended(
            self.profile.member,
            across_angles(self.profile, "tip"),
            lambda y: self._edge(self.flanks[-1], 1.0, y),
            lambda y: self._edge(self.flanks[1], 1.0, y),
        )

    def _root(self) -> Points:
        member = self.profile.member
        first = self.made["fillet", 1]
        last = self.made["fillet", -1]
        return blended(
            member,
            across_angles(self.profile, "root"),
            lambda y: self._edge(first, 0.0, y),
            lambda y: self._edge(last, 0.0, y, member.pitch),
        )

    def _free(self, y: Floats) -> Edge:
        return Edge(self.profile.places(y))

    def _edge(self, surface: NurbsSurface, u: float, y: Floats, turned: float = 0.0) -> Edge:
        return edge_of(self.profile.member, surface, u, y, turned)
