"""All faces of one tooth and its space: the flanks as a method makes them, and their neighbours grafted on.

Every face is a surface over [0, 1]²: its first parameter runs along the profile with growing azimuth, the
second from toe to heel, so that its natural normal points out of the metal. Neighbours meet in the edges
of the flanks as they are, so the tooth is closed whatever a flank's deviation is.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gearstudio.catalogue import Variant
from gearstudio.errors import GeometryError
from gearstudio.kernel.surfaces import reconstructed
from gearstudio.methods import Construction, Target, method
from gearstudio.methods.base import Refinement, between
from gearstudio.nurbs import NurbsSurface
from gearstudio.theory.cones import ConeLimit, MemberGeometry
from gearstudio.theory.flank import InvoluteFlank
from gearstudio.theory.profile import Segment, ToothProfile, tooth_profile

Floats = NDArray[np.float64]
Edge = Callable[[Floats], Floats]
"""A lengthwise edge: points (n, 3) at places (n,) from toe to heel."""

_DEGREE = 5
_FIRST_GRID = (9, 9)
_SMOOTH_SHARE = 0.1
_END_ROUNDS = 8
_STEP = 1e-5
_FARTHEST_CONTINUATION = 0.05


@dataclass(frozen=True)
class ToothFace:
    """One face of a tooth: ``kind`` with the side it is on (+1, -1, or 0), and its surface."""

    kind: Segment
    side: int
    surface: NurbsSurface


@dataclass(frozen=True)
class Tooth:
    """The faces of one pitch in the order of azimuth, from the fillet at smaller azimuth to the root beyond."""

    member: MemberGeometry
    profile: ToothProfile
    faces: tuple[ToothFace, ...]
    constructions: dict[str, Construction]


def build_tooth(member: MemberGeometry, method_id: str, variant: Variant, target: Target) -> Tooth:
    """Model every face of a tooth.

    Raises
    ------
    GeometryError
        There is no tooth space, or a flank cannot be brought to the ends of the tooth.
    ModellingError
        The method could not make a flank.
    """
    profile = tooth_profile(member)
    foot = ConeLimit(profile.fillet.foot_angle, 0.0, member.pitch_angle)
    if profile.fillet.on_meridian:
        foot = member.base_limit
    flanks = {side: InvoluteFlank(member, side, foot) for side in (-1, 1)}
    built = {side: method(method_id).build(flank, variant, target) for side, flank in flanks.items()}
    goal = _SMOOTH_SHARE * target.tolerance
    surfaces = {side: _to_the_ends(flanks[side], built[side].surface, goal) for side in (-1, 1)}
    faces = _grafted(member, profile, surfaces, goal)
    return Tooth(member, profile, faces, {flanks[side].name: built[side] for side in (-1, 1)})


def _grafted(
    member: MemberGeometry, profile: ToothProfile, surfaces: dict[int, NurbsSurface], goal: float
) -> tuple[ToothFace, ...]:
    foots = {side: _edge_of(surfaces[side], 0.0) for side in (-1, 1)}
    tips = {side: _edge_of(surfaces[side], 1.0) for side in (-1, 1)}
    names = profile.segments
    below = [name for name in names if name in ("fillet", "meridian")]

    def lower(side: int) -> list[ToothFace]:
        """Faces between root and flank, from the root up."""
        made = []
        for name in below:
            exact = _theory(member, profile, name, side)
            top = foots[side] if name == below[-1] else None
            made.append(ToothFace(name, side, _fitted(_blended(member, exact, None, top), goal)))
        return made

    def ascending(faces: Sequence[ToothFace]) -> list[ToothFace]:
        return [replace(face, surface=_mirrored(face.surface)) for face in reversed(faces)]

    tip = _blended(member, _across(member, profile, "tip"), tips[-1], tips[1])
    faces = [
        *lower(-1),
        ToothFace("flank", -1, surfaces[-1]),
        ToothFace("tip", 0, _fitted(tip, goal)),
        *ascending([*lower(1), ToothFace("flank", 1, surfaces[1])]),
    ]
    if "root" in names:
        faces.append(ToothFace("root", 0, _fitted(_across(member, profile, "root"), goal)))
    return tuple(faces)


def _theory(member: MemberGeometry, profile: ToothProfile, name: Segment, side: int) -> Callable[..., Floats]:
    """Exact points of a segment on one side, from the root's end (x = 0) up, at places v."""

    def points(x: Floats, v: Floats) -> Floats:
        x, v = np.broadcast_arrays(x, v)
        rho_u = member.inner_cone_distance + v * member.face_width
        delta, phi = profile.angles(name, x, member.limit_angle(member.tip_limit, rho_u))
        return _placed(member, delta, side * phi, rho_u)

    return points


def _across(member: MemberGeometry, profile: ToothProfile, name: Segment) -> Callable[..., Floats]:
    """Exact points of the tip (about azimuth 0) or of the root (about half a pitch), with growing azimuth."""
    middle = 0.0 if name == "tip" else member.pitch / 2

    def points(x: Floats, v: Floats) -> Floats:
        x, v = np.broadcast_arrays(x, v)
        rho_u = member.inner_cone_distance + v * member.face_width
        end = np.full_like(x, 0.0 if name == "tip" else 1.0)
        delta, phi = profile.angles(name, end, member.limit_angle(member.tip_limit, rho_u))
        half = np.abs(phi - middle)
        return _placed(member, delta, middle + (2 * x - 1) * half, rho_u)

    return points


def _placed(member: MemberGeometry, delta: Floats, phi: Floats, rho_u: Floats) -> Floats:
    rho = member.cone_distance(rho_u, delta)
    azimuth, radius = phi + member.lengthwise.azimuth(rho), rho * np.sin(delta)
    return np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth), rho * np.cos(delta)], axis=-1)


def _blended(
    member: MemberGeometry, exact: Callable[..., Floats], first: Edge | None, last: Edge | None
) -> Callable[..., Floats]:
    """The exact face, moved so that it meets given edges at x = 0 and x = 1."""

    def points(x: Floats, v: Floats) -> Floats:
        x, v = np.broadcast_arrays(x, v)
        places = v[0]
        ends = [places if edge is None else _place(member, edge(places)) for edge in (first, last)]
        moved = exact(x, (1 - x) * ends[0] + x * ends[1])
        for at, edge, weight in ((0.0, first, 1 - x), (1.0, last, x)):
            if edge is not None:
                gap = edge(places) - exact(np.full_like(places, at), ends[int(at)])
                moved = moved + weight[..., None] * gap
        return np.asarray(moved)

    return points


def _place(member: MemberGeometry, points: Floats) -> Floats:
    """Where points lie between toe (0) and heel (1)."""
    radius = np.hypot(points[..., 0], points[..., 1])
    rho, delta = np.hypot(radius, points[..., 2]), np.arctan2(radius, points[..., 2])
    return np.asarray((member.end_distance(rho, delta) - member.inner_cone_distance) / member.face_width)


def _edge_of(surface: NurbsSurface, u: float) -> Edge:
    return lambda places: surface.grid(np.array([u]), places)[0]


def _fitted(points: Callable[..., Floats], goal: float) -> NurbsSurface:
    """A B-spline through points(x, v) that keeps to them within a goal [mm]."""

    def attempt(counts: tuple[int, ...]) -> tuple[Construction, tuple[float, ...]]:
        x, v = (np.linspace(0.0, 1.0, n) for n in counts)
        surface = reconstructed(x, v, points(x[:, None], v[None, :]), _DEGREE)

        def gap(x: Floats, v: Floats) -> float:
            return float(np.linalg.norm(surface.grid(x, v) - points(x[:, None], v[None, :]), axis=-1).max())

        return Construction(surface), (gap(between(x), v), gap(x, between(v)))

    return Refinement("tooth", goal, (_DEGREE + 1, _DEGREE + 1)).run(_FIRST_GRID, attempt).surface


def _mirrored(surface: NurbsSurface) -> NurbsSurface:
    """The same surface with its first parameter reversed."""
    knots = np.asarray((surface.knots_u[0] + surface.knots_u[-1] - surface.knots_u)[::-1])
    weights = None if surface.weights is None else surface.weights[::-1]
    return replace(surface, poles=surface.poles[::-1], knots_u=knots, weights=weights)


def _to_the_ends(flank: InvoluteFlank, surface: NurbsSurface, goal: float) -> NurbsSurface:
    """The surface, shortened or continued a little so that it ends on the end surfaces of the tooth.

    Raises
    ------
    GeometryError
        It would have to be continued too far.
    """
    member, edge = flank.member, np.linspace(0.0, 1.0, 33)
    border = surface.grid(edge, np.array([0.0, 1.0]))
    miss = np.abs(_place(member, border) - np.array([0.0, 1.0])).max() * member.face_width
    if miss <= goal:
        return surface

    def trimmed(x: Floats, v: Floats) -> Floats:
        x, v = np.broadcast_arrays(x, v)
        toe, heel = (_parameter_at(member, surface, x[:, 0], end) for end in (0.0, 1.0))
        return surface.points(x, toe[:, None] + v * (heel - toe)[:, None])

    return _fitted(trimmed, goal)


def _parameter_at(member: MemberGeometry, surface: NurbsSurface, u: Floats, end: float) -> Floats:
    """v at which the surface's lines u reach the toe (0) or the heel (1)."""
    v = np.full_like(u, end)
    for _ in range(_END_ROUNDS):
        ahead = _place(member, surface.points(u, v + _STEP))
        here = _place(member, surface.points(u, v))
        v = v - (here - end) * _STEP / (ahead - here)
    if not np.all(np.abs(v - end) < _FARTHEST_CONTINUATION):
        raise GeometryError(
            f"the {member.name} flank ends too far from the {'heel' if end else 'toe'} to be brought there"
        )
    return v
