"""Second derivatives of the pinion's flank, by differentiating the condition of contact twice.

With F(t; a) = 0 the condition of `envelope` and a, b the natural coordinates,

    t_ab = -(F_ab + F_at t_b + F_bt t_a + F_tt t_a t_b) / F_t,

and a point of the pinion, R_z(t) p seen from a member that turns u times as fast about its axis e_1, has with
E v = z x v + u e_1 x v the derivatives

    X_a  = R p_a + t_a S,   S = z x R p + u e_1 x (R p - d),
    X_ab = R p_ab + t_b E R p_a + t_a E R p_b + t_ab S + t_a t_b (E (z x R p) + u e_1 x S).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.hypoid.envelope import Envelope, WheelPoint
from gearstudio.theory.involute import tangent_plane
from gearstudio.theory.vectors import cross, quarter, turned

Floats = NDArray[np.float64]
Pairs = tuple[Floats, Floats, Floats]
"""What belongs to the pairs psi psi, psi rho, rho rho."""

_PAIRS = ((0, 0), (0, 1), (1, 1))


@dataclass(frozen=True)
class _Twice:
    """Second derivatives of the wheel's points and of their normals, shape (..., 3) each."""

    point: Pairs
    normal: Pairs


def derivatives(envelope: Envelope, psi: Floats, rho: Floats) -> tuple[Floats, Floats, Floats, Floats, Floats]:
    """First and second derivatives of the pinion's points by psi and rho, shape (..., 3) each, in its own frame."""
    w = envelope.wheel_point(psi, rho)
    twice = _wheel_twice(envelope, psi, rho, w)
    turn, slopes, bends = _turns(envelope, w, twice)
    point, first = envelope.moved(w, turn, slopes)
    ratio, axis = envelope.ratio, envelope.axes.pinion_axis

    def swung(vectors: Floats) -> Floats:
        return quarter(vectors) + ratio * cross(axis, vectors)

    by = [turned(d, turn) for d in (w.by_psi, w.by_rho)]
    spun = quarter(turned(w.point, turn))
    sliding = spun + ratio * cross(axis, point)
    bent = swung(spun) + ratio * cross(axis, sliding)
    second = [
        turned(there, turn)
        + slopes[b][..., None] * swung(by[a])
        + slopes[a][..., None] * swung(by[b])
        + bend[..., None] * sliding
        + (slopes[a] * slopes[b])[..., None] * bent
        for (a, b), there, bend in zip(_PAIRS, twice.point, bends, strict=True)
    ]
    wheel_turn = envelope.turn_of_wheel(turn)
    own = [envelope.to_pinion(x, wheel_turn) for x in (*first, *second)]
    return own[0], own[1], own[2], own[3], own[4]


def _turns(envelope: Envelope, w: WheelPoint, twice: _Twice) -> tuple[Floats, tuple[Floats, Floats], Pairs]:
    """t at contact with its first and second derivatives."""
    turn, slopes = envelope.turn(w)
    c, s = np.cos(turn), np.sin(turn)
    a, b, _ = envelope.coefficients(w.normal, cross(w.point, w.normal))
    points, normals = (w.by_psi, w.by_rho), (w.normal_by_psi, w.normal_by_rho)
    once = [
        envelope.coefficients(n, cross(p, w.normal) + cross(w.point, n)) for p, n in zip(points, normals, strict=True)
    ]
    steep, falling = b * c - a * s, -(a * c + b * s)
    mixed = [b_j * c - a_j * s for a_j, b_j, _ in once]
    bends = []
    for (i, j), p, n in zip(_PAIRS, twice.point, twice.normal, strict=True):
        moment = cross(p, w.normal) + cross(points[i], normals[j]) + cross(points[j], normals[i]) + cross(w.point, n)
        a_ij, b_ij, c_ij = envelope.coefficients(n, moment)
        all_ = (
            a_ij * c + b_ij * s + c_ij + mixed[i] * slopes[j] + mixed[j] * slopes[i] + falling * slopes[i] * slopes[j]
        )
        bends.append(np.asarray(-all_ / steep))
    return turn, slopes, (bends[0], bends[1], bends[2])


def _wheel_twice(envelope: Envelope, psi: Floats, rho: Floats, w: WheelPoint) -> _Twice:
    """Second derivatives on the wheel; theta(rho) turns all of it about the axis."""
    member, side = envelope.wheel.member, envelope.side
    sin_b, cos_b = np.sin(member.base_angle), np.cos(member.base_angle)
    _, across, plane = tangent_plane(member.base_angle, envelope.wheel.contact_azimuth(psi, rho))
    sin_psi, cos_psi, r = np.sin(psi)[..., None], np.cos(psi)[..., None], rho[..., None]
    slope, bend = (x[..., None] for x in member.lengthwise.azimuth_derivatives(rho)[1:])
    third = member.lengthwise.azimuth_third(rho)[..., None]
    lean, lean_1, lean_2 = r * slope, slope + r * bend, 2 * bend + r * third
    ray = w.point / r
    cot_b = cos_b / sin_b
    share = cot_b * cos_psi - side * lean * sin_psi * cos_b
    normals = (
        -side * cot_b * share * across - (cot_b * sin_psi + side * lean * cos_psi * cos_b) * plane,
        slope * quarter(w.normal_by_psi) - side * lean_1 * sin_psi * cos_b * plane,
        bend * quarter(w.normal)
        + slope * quarter(w.normal_by_rho)
        - side * sin_b * (lean_2 * ray + lean_1 * slope * quarter(ray)),
    )
    points = envelope.wheel.derivatives_at(psi, rho)[2:]
    return _Twice((points[0], points[1], points[2]), normals)
