"""Volume of teeth whose profile changes along the face, by integrating theory section by section."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.chamfer import EndChamfer
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.section import Profile, Segment

Floats = NDArray[np.float64]
Angles = Callable[[Floats], tuple[Floats, Floats]]
"""Polar angle and azimuth [rad] of sections at shares of a curve, (n, m) for (n, m) or (n, 1)."""

_ALONG, _ACROSS = 24, 32
_BISECTIONS = 45


def teeth_volume(profile: Profile, chamfers: Sequence[EndChamfer] = ()) -> float:
    """Volume of all teeth above the root cone and below the face cone [mm^3], less what chamfers take off their ends.

    Notes
    -----
    With rho_u, polar angle and azimuth as coordinates the volume of a tooth is the integral of
    ``rho^2 sin(delta) d(rho)/d(rho_u)`` over its sections; on each side the azimuth is a function of the polar angle.
    A chamfer takes off the sections next to its end from the polar angle up at which they meet its cone.
    """
    member = profile.member
    ends = member.inner_cone_distance, member.outer_cone_distance
    total = _between(profile, *ends, lambda rho_u: np.zeros_like(rho_u))
    for chamfer in chamfers:
        radius, height = chamfer.face
        start = float(member.end_distance(np.hypot(radius, height), np.arctan2(radius, height)))
        low, high = (start, ends[1]) if chamfer.heel else (ends[0], start)
        total -= _between(profile, low, high, lambda rho_u, cut=chamfer: _met(member, cut, rho_u))  # type: ignore[misc]
    return member.teeth * total


def _between(profile: Profile, low: float, high: float, above: Callable[[Floats], Floats]) -> float:
    """Volume of a tooth between two sections rho_u [mm], from polar angles up [rad]."""
    y, weight = np.polynomial.legendre.leggauss(_ALONG)
    rho_u = low + (y + 1) / 2 * (high - low)
    sections = sum(_half_section(profile, side, rho_u, above(rho_u)) for side in (1, -1))
    return float(np.sum(weight * sections)) * (high - low) / 2


def _met(member: MemberGeometry, chamfer: EndChamfer, rho_u: Floats) -> Floats:
    """Polar angle at which sections meet the cone of a chamfer [rad]."""
    low, high = (member.limit_angle(limit, rho_u) for limit in (member.root_limit, member.tip_limit))
    for _ in range(_BISECTIONS):
        delta = (low + high) / 2
        rho = member.cone_distance(rho_u, delta)
        inside = chamfer.beyond(np.stack([rho * np.sin(delta), np.zeros_like(delta), rho * np.cos(delta)], axis=-1)) < 0
        low, high = np.where(inside, delta, low), np.where(inside, high, delta)
    return (low + high) / 2


def _half_section(profile: Profile, side: int, rho_u: Floats, above: Floats) -> Floats:
    """What a side adds to sections: its integral from polar angles, or from the root, to the tip [mm^2]."""
    total = np.zeros_like(rho_u)
    for angles in (*(_below(profile, name, side, rho_u) for name in profile.below(side)), _flank(profile, side, rho_u)):
        total += _integral(profile, side, angles, rho_u, above)
    return total


def _below(profile: Profile, name: Segment, side: int, rho_u: Floats) -> Angles:
    shift = profile.shift_on(side)

    def angles(x: Floats) -> tuple[Floats, Floats]:
        delta, phi = profile.rising(name, side, x, rho_u)
        return delta, phi if shift is None else phi + shift(profile.member.cone_distance(rho_u, delta), delta)

    return angles


def _flank(profile: Profile, side: int, rho_u: Floats) -> Angles:
    member, flank = profile.member, profile.flank(side)
    v = (rho_u - member.inner_cone_distance) / member.face_width

    def angles(x: Floats) -> tuple[Floats, Floats]:
        rho, delta, azimuth = flank.locate(flank.points(x, v))
        return delta, np.remainder(azimuth - member.lengthwise.azimuth(rho) + np.pi, 2 * np.pi) - np.pi

    return angles


def _integral(profile: Profile, side: int, angles: Angles, rho_u: Floats, above: Floats) -> Floats:
    """The integral over a curve, from where it is above polar angles, at Gauss' nodes of its parameter."""
    member = profile.member
    nodes, weight = np.polynomial.legendre.leggauss(_ACROSS)
    first = _passing(angles, above)
    delta, phi = angles(first + (nodes[:, None] + 1) / 2 * (1 - first))
    rho = member.cone_distance(rho_u, delta)
    stretch = rho**2 * np.sin(delta) * rho / rho_u
    return np.asarray(side * np.sum(weight[:, None] / 2 * phi * stretch * _slopes(delta), axis=0))


def _passing(angles: Angles, above: Floats) -> Floats:
    """Shares of a rising curve at which it passes polar angles, shape (m,): 0 or 1 where it lies above or below."""
    ends = angles(np.array([[0.0], [1.0]]))[0]
    low, high = np.zeros_like(above), np.ones_like(above)
    if np.all(ends[0] >= above):
        return low
    for _ in range(_BISECTIONS):
        middle = (low + high) / 2
        under = angles(middle[None, :])[0][0] < above
        low, high = np.where(under, middle, low), np.where(under, high, middle)
    return np.asarray(np.where(ends[0] >= above, 0.0, np.where(ends[1] <= above, 1.0, (low + high) / 2)))


def _slopes(values: Floats) -> Floats:
    """Derivatives by the parameter in [0, 1] at Gauss' nodes along the first axis."""
    nodes = np.polynomial.legendre.leggauss(_ACROSS)[0]
    series = np.polynomial.legendre.legfit(nodes, values, _ACROSS - 1)
    return np.asarray(2 * np.polynomial.legendre.legval(nodes, np.polynomial.legendre.legder(series)).T)
