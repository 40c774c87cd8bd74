"""Volume of a whole gear by integrating theory, without a CAD kernel: teeth over polar angle, body by revolution."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.involute import polar_angle, roll_arc
from gearstudio.theory.profile import Segment, ToothProfile, tooth_profile

Floats = NDArray[np.float64]

_GAUSS = 40


def gear_volume(member: MemberGeometry, outline: Floats) -> float:
    """Volume of a member with its body [mm^3].

    Parameters
    ----------
    member : MemberGeometry
    outline : ndarray, shape (n, 2)
        (radius, height) of the body from back cone to front cone [mm].

    Notes
    -----
    A tooth is ``2 w(delta)`` wide in azimuth on every sphere, so its volume is the integral of
    ``2 w sin(delta) (rho_2^3 - rho_1^3)/3`` over the polar angle; below the roots the gear is turned.
    """
    return member.teeth * _tooth_volume(tooth_profile(member)) + _body_volume(member, outline)


def _tooth_volume(profile: ToothProfile) -> float:
    """The metal of one pitch above the root cone."""
    member, fillet = profile.member, profile.fillet
    total = 0.0
    for name in profile.segments:
        if name == "fillet" or name == "meridian":
            total += _below_flank(profile, name)
        elif name == "flank":
            corners = [float(member.limit_angle(member.tip_limit, rho_u)) for rho_u in _ends(member)]
            low, *rest = [fillet.foot_arc, *sorted(float(roll_arc(corner, member.base_angle)) for corner in corners)]
            for first, last in pairwise([low, *rest]):
                total += _flank_part(profile, first, last)
    return total


def _below_flank(profile: ToothProfile, name: Segment) -> float:
    s, weights = _nodes(0.0, 1.0)
    step = 1e-5
    delta, phi = profile.angles(name, s)
    slope = (profile.angles(name, s + step)[0] - profile.angles(name, s - step)[0]) / (2 * step)
    return float(np.sum(weights * slope * 2 * phi * np.sin(delta) * _shell(profile.member, delta)))


def _flank_part(profile: ToothProfile, first: float, last: float) -> float:
    """Over psi, in which nothing is singular on the base cone: sin(delta) d(delta) = cos(delta_b) sin(psi) d(psi)."""
    member = profile.member
    if last <= first:
        return 0.0
    psi, weights = _nodes(first, last)
    delta = polar_angle(psi, member.base_angle)
    share = (psi - profile.fillet.foot_arc) / (_whole(profile) - profile.fillet.foot_arc)
    _, phi = profile.angles("flank", share)
    measure = np.cos(member.base_angle) * np.sin(psi)
    return float(np.sum(weights * measure * 2 * phi * _shell(member, delta)))


def _whole(profile: ToothProfile) -> float:
    return float(roll_arc(profile.member.tip_angle, profile.member.base_angle))


def _shell(member: MemberGeometry, delta: Floats) -> Floats:
    """Integral of rho^2 over the metal at polar angles, between the tooth's ends and below its tip."""
    low, high = (member.cone_distance(rho_u, delta) for rho_u in _ends(member))
    tip = member.tip_limit
    if tip.offset != 0:
        sine = np.sin(delta - tip.angle)
        bound = tip.offset / np.where(sine == 0, np.finfo(float).tiny, sine)
        above = bound > 0
        if tip.offset > 0:
            high = np.where(above, np.minimum(high, bound), high)
        else:
            low = np.where(above, np.maximum(low, bound), high)
    return np.asarray(np.maximum(high**3 - low**3, 0.0) / 3)


def _body_volume(member: MemberGeometry, outline: Floats) -> float:
    """pi times the integral of r^2 dz round the outline below the root cone."""
    roots = [_root_point(member, rho_u) for rho_u in reversed(_ends(member))]
    sides = [_revolved(a, b) for a, b in pairwise(outline)]
    sides.append(_revolved(roots[1], roots[0]))
    round_ends = member.ends == "sphere"
    sides += [_revolved(a, b, round_ends) for a, b in ((roots[0], outline[0]), (outline[-1], roots[1]))]
    return abs(float(np.pi * sum(sides)))


def _revolved(a: Floats, b: Floats, on_sphere: bool = False) -> float:
    if on_sphere:
        square = float(a @ a)
        return square * float(b[1] - a[1]) - float(b[1] ** 3 - a[1] ** 3) / 3
    return float((b[1] - a[1]) * (a[0] ** 2 + a[0] * b[0] + b[0] ** 2) / 3)


def _root_point(member: MemberGeometry, rho_u: float) -> Floats:
    delta = member.limit_angle(member.root_limit, rho_u)
    rho = member.cone_distance(rho_u, delta)
    return np.array([float(rho * np.sin(delta)), float(rho * np.cos(delta))])


def _ends(member: MemberGeometry) -> tuple[float, float]:
    return member.inner_cone_distance, member.outer_cone_distance


def _nodes(low: float, high: float) -> tuple[Floats, Floats]:
    x, w = np.polynomial.legendre.leggauss(_GAUSS)
    return np.asarray(low + (x + 1) / 2 * (high - low)), np.asarray(w * (high - low) / 2)
