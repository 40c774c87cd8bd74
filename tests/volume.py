"""Volume of a whole gear by integrating theory, without a CAD kernel: teeth over polar angle, body by revolution."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from gearstudio.theory.chamfer import EndChamfer, end_point
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.involute import polar_angle, roll_arc
from gearstudio.theory.profile import ToothProfile, profile_of
from gearstudio.theory.section import Segment
from tests.section_volume import teeth_volume

Floats = NDArray[np.float64]

_GAUSS = 40


def gear_volume(member: MemberGeometry, outline: Floats, chamfers: Sequence[EndChamfer] = ()) -> float:
    """Volume of a member with its body [mm^3].

    Parameters
    ----------
    member : MemberGeometry
    outline : ndarray, shape (n, 2)
        (radius, height) of the body from back cone to front cone [mm].
    chamfers : sequence of EndChamfer

    Notes
    -----
    A tooth is ``2 w(delta)`` wide in azimuth on every sphere, so its volume is the integral of
    ``2 w sin(delta) (rho_2^3 - rho_1^3)/3`` over the polar angle; below the roots the gear is turned. Where the profile
    changes along the face it is integrated by sections (`teeth_volume`).

    Raises
    ------
    GeometryError
        There is no tooth.
    """
    profile = profile_of(member)
    if isinstance(profile, ToothProfile):
        return member.teeth * _tooth_volume(profile, chamfers) + _body_volume(member, outline)
    return teeth_volume(profile, chamfers) + _body_volume(member, outline)


def _tooth_volume(profile: ToothProfile, chamfers: Sequence[EndChamfer]) -> float:
    """The metal of one pitch above the root cone, between the polar angles at which its ends change."""
    member = profile.member
    corners = [float(member.limit_angle(member.tip_limit, rho_u)) for rho_u in _ends(member)]
    corners += [float(np.arctan2(*point)) for chamfer in chamfers for point in (chamfer.face, chamfer.foot)]
    total = _added_by_relief(profile, corners, chamfers)
    for name in profile.segments:
        if name == "fillet" or name == "meridian":
            breaks = [0.0, *_breaks_below_flank(profile, name, corners), 1.0]
            total += sum(_below_flank(profile, name, chamfers, *span) for span in pairwise(breaks))
        elif name == "flank":
            foot = profile.fillet.foot_arc
            arcs = [float(roll_arc(corner, member.base_angle)) for corner in corners if corner > member.base_angle]
            breaks = [foot, *sorted(arc for arc in arcs if arc > foot)]
            total += sum(_flank_part(profile, chamfers, *span) for span in pairwise(breaks))
    return total


def _breaks_below_flank(profile: ToothProfile, name: Segment, corners: Sequence[float]) -> list[float]:
    """Where a segment, over which the polar angle grows from 0 to 1, passes the corners."""

    def above(s: float, corner: float) -> float:
        return float(profile.angles(name, s)[0]) - corner

    inside = [corner for corner in sorted(corners) if above(0.0, corner) < 0 < above(1.0, corner)]
    return [float(brentq(above, 0.0, 1.0, args=(corner,), xtol=1e-14)) for corner in inside]


def _below_flank(
    profile: ToothProfile, name: Segment, chamfers: Sequence[EndChamfer], first: float, last: float
) -> float:
    s, weights = _nodes(first, last)
    step = 1e-5
    delta, phi = profile.angles(name, s)
    slope = (profile.angles(name, s + step)[0] - profile.angles(name, s - step)[0]) / (2 * step)
    return float(np.sum(weights * slope * 2 * phi * np.sin(delta) * _shell(profile.member, delta, chamfers)))


def _flank_part(profile: ToothProfile, chamfers: Sequence[EndChamfer], first: float, last: float) -> float:
    """Over psi, in which nothing is singular on the base cone: sin(delta) d(delta) = cos(delta_b) sin(psi) d(psi)."""
    member = profile.member
    if last <= first:
        return 0.0
    psi, weights = _nodes(first, last)
    delta = polar_angle(psi, member.base_angle)
    share = (psi - profile.fillet.foot_arc) / (_whole(profile) - profile.fillet.foot_arc)
    _, phi = profile.angles("flank", share)
    measure = np.cos(member.base_angle) * np.sin(psi)
    return float(np.sum(weights * measure * 2 * phi * _shell(member, delta, chamfers)))


def _whole(profile: ToothProfile) -> float:
    return float(roll_arc(profile.member.tip_angle, profile.member.base_angle))


def _added_by_relief(profile: ToothProfile, breaks: Sequence[float], chamfers: Sequence[EndChamfer]) -> float:
    """What micro-geometry adds to a tooth: the integral of side shift rho^2 sin(delta) over polar angle and rho."""
    member, total = profile.member, 0.0
    if member.reliefs == (None, None):
        return total
    foot = profile.fillet.foot_angle
    inner = {foot, max(foot, member.base_angle), *(b for b in breaks if b > member.root_angle)}
    for span in pairwise([member.root_angle, *sorted(inner)]):
        delta, weights = _nodes(*span)
        low, high = _span(member, delta, chamfers)
        x, w = _nodes(0.0, 1.0)
        width = np.maximum(high - low, 0.0)[:, None]
        rho = low[:, None] + x * width
        turned = sum(side * profile.shift(side, rho, np.broadcast_to(delta[:, None], rho.shape)) for side in (1, -1))
        total += float(np.sum(weights * np.sin(delta) * np.sum(w * width * rho**2 * turned, axis=1)))
    return total


def _shell(member: MemberGeometry, delta: Floats, chamfers: Sequence[EndChamfer]) -> Floats:
    """Integral of rho^2 over the metal at polar angles, between the tooth's ends and below its tip and chamfers."""
    low, high = _span(member, delta, chamfers)
    return np.asarray(np.maximum(high**3 - low**3, 0.0) / 3)


def _span(member: MemberGeometry, delta: Floats, chamfers: Sequence[EndChamfer]) -> tuple[Floats, Floats]:
    """Least and greatest distance of the metal from the apex at polar angles."""
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
    for chamfer in chamfers:
        slope = chamfer.normal[0] * np.sin(delta) + chamfer.normal[1] * np.cos(delta)
        bound = np.dot(chamfer.normal, chamfer.face) / slope
        low, high = (low, np.minimum(high, bound)) if np.all(slope > 0) else (np.maximum(low, bound), high)
    return low, high


def _body_volume(member: MemberGeometry, outline: Floats) -> float:
    """pi times the integral of r^2 dz round the outline below the root cone."""
    roots = [end_point(member, member.root_limit, v) for v in (1.0, 0.0)]
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


def _ends(member: MemberGeometry) -> tuple[float, float]:
    return member.inner_cone_distance, member.outer_cone_distance


def _nodes(low: float, high: float) -> tuple[Floats, Floats]:
    x, w = np.polynomial.legendre.leggauss(_GAUSS)
    return np.asarray(low + (x + 1) / 2 * (high - low)), np.asarray(w * (high - low) / 2)
