"""The faces beside the flanks: exact fillets, roots and tips, moved so that they meet the flanks' edges as they are.

A face is blended in the tooth's own coordinates (place along the face, polar angle, azimuth in the section), in
which its ends stay on the end surfaces of the tooth whatever a flank's deviation is.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.methods.space import Points, Space
from gearstudio.nurbs import NurbsSurface
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.section import Profile, Segment, Shift
from gearstudio.theory.vectors import from_spherical, spherical, wrapped

Floats = NDArray[np.float64]
Angles = Callable[[Floats, Floats], tuple[Floats, Floats]]
"""Polar angle and azimuth in the section of exact points at x (0 to 1) of a face and rho_u [mm]."""


@dataclass(frozen=True)
class Edge:
    """A lengthwise edge in the tooth's own coordinates, shape (n,) each.

    ``rho_u`` tells the end surface through a point [mm], ``delta`` its polar angle, ``phi`` its azimuth
    before the section is turned by theta [rad]; the last two are None on an edge that theory gives.
    """

    rho_u: Floats
    delta: Floats | None = None
    phi: Floats | None = None


def edge_of(member: MemberGeometry, surface: NurbsSurface, u: float, places: Floats, turned: float = 0.0) -> Edge:
    """The edge u of a surface that is turned about the axis by an angle [rad]."""
    rho_u, delta, phi = own_coordinates(member, surface.grid(np.array([u]), places)[0])
    return Edge(rho_u, delta, phi + turned)


def own_coordinates(member: MemberGeometry, points: Floats) -> tuple[Floats, Floats, Floats]:
    """rho_u [mm], polar angle and azimuth [rad] of points (..., 3) in the tooth's own coordinates, shape (...) each."""
    rho, delta, phi = spherical(points)
    return member.end_distance(rho, delta), delta, wrapped(phi - member.lengthwise.azimuth(rho))


def placed(member: MemberGeometry, rho_u: Floats, delta: Floats, phi: Floats) -> Floats:
    """Points of the tooth's own coordinates, shape (..., 3) [mm]."""
    rho = member.cone_distance(rho_u, delta)
    return from_spherical(rho, delta, phi + member.lengthwise.azimuth(rho))


def blended(
    member: MemberGeometry,
    exact: Angles,
    first: Callable[[Floats], Edge],
    last: Callable[[Floats], Edge],
    shift: Shift | None = None,
) -> Points:
    """Points of an exact face, moved linearly across it so that it meets two edges at x = 0 and x = 1.

    ``shift`` is by how much micro-geometry turns the exact face.
    """

    def at(x: Floats, rho_u: Floats) -> tuple[Floats, Floats]:
        delta, phi = exact(x, rho_u)
        return delta, phi if shift is None else phi + shift(member.cone_distance(rho_u, delta), delta)

    def points(x: Floats, y: Floats) -> Floats:
        edges = (first(y), last(y))
        weight = (1 - x[:, None], x[:, None])
        rho_u = weight[0] * edges[0].rho_u + weight[1] * edges[1].rho_u
        delta, phi = at(x[:, None], rho_u)
        for end, (edge, share) in enumerate(zip(edges, weight, strict=True)):
            if edge.delta is not None and edge.phi is not None:
                there = at(np.full((1, 1), float(end)), edge.rho_u[None, :])
                delta = delta + share * (edge.delta - there[0])
                phi = phi + share * wrapped(edge.phi - there[1])
        return placed(member, rho_u, delta, phi)

    return points


def lower_angles(profile: Profile, name: Segment, side: int) -> Angles:
    """A fillet or meridian on one side, from the root's end (x = 0) up."""
    return lambda x, rho_u: profile.rising(name, side, x, rho_u)


def across_angles(profile: Profile, name: Segment) -> Angles:
    """The tip (about azimuth 0) or the root (about half a pitch), with growing azimuth."""

    def angles(x: Floats, rho_u: Floats) -> tuple[Floats, Floats]:
        delta, first, last = profile.across(name, rho_u)
        return delta, first + x * (last - first)

    return angles


def reversed_across(surface: NurbsSurface) -> NurbsSurface:
    """The same surface with its first parameter reversed."""
    knots = np.asarray((surface.knots_u[0] + surface.knots_u[-1] - surface.knots_u)[::-1])
    return NurbsSurface(surface.poles[::-1], knots, surface.knots_v, surface.degree_u, surface.degree_v)


def profile_space() -> Space:
    """Where the fit of a face begins across the tooth."""
    return Space.even(5, 1)
