"""Volume of teeth whose profile changes along the face, by integrating theory section by section."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.section import Profile

Floats = NDArray[np.float64]

_ALONG, _ACROSS = 24, 32


def teeth_volume(profile: Profile) -> float:
    """Volume of all teeth above the root cone and below the face cone [mm^3].

    Notes
    -----
    With rho_u, polar angle and azimuth as coordinates the volume of a tooth is the integral of
    ``rho^2 sin(delta) d(rho)/d(rho_u)`` over its sections; on each side the azimuth is a function of the polar angle.
    """
    member = profile.member
    y, weight = np.polynomial.legendre.leggauss(_ALONG)
    v, weight = (y + 1) / 2, weight / 2 * member.face_width
    total = sum(float(np.sum(weight * _half_section(profile, side, v))) for side in (1, -1))
    return member.teeth * total


def _half_section(profile: Profile, side: int, v: Floats) -> Floats:
    """What a side adds to the sections at places v: its integral from root to tip [mm^2]."""
    member, flank = profile.member, profile.flank(side)
    rho_u = member.inner_cone_distance + v * member.face_width
    x, weight = np.polynomial.legendre.leggauss(_ACROSS)
    x, weight = (x + 1) / 2, weight / 2
    total = np.zeros_like(v)
    for name in profile.below(side):
        delta, phi = profile.rising(name, side, x[:, None], rho_u)
        shift = profile.shift_on(side)
        if shift is not None:
            phi = phi + shift(member.cone_distance(rho_u, delta), delta)
        total += _integral(profile, side, delta, phi, rho_u, weight)
    rho, delta, azimuth = flank.locate(flank.points(x[:, None], v))
    phi = np.remainder(azimuth - member.lengthwise.azimuth(rho) + np.pi, 2 * np.pi) - np.pi
    return total + _integral(profile, side, delta, phi, rho_u, weight)


def _integral(profile: Profile, side: int, delta: Floats, phi: Floats, rho_u: Floats, weight: Floats) -> Floats:
    """The integral over a curve's polar angles, given at Gauss' nodes of its parameter."""
    member = profile.member
    rho = member.cone_distance(rho_u, delta)
    stretch = rho**2 * np.sin(delta) * rho / rho_u
    return np.asarray(side * np.sum(weight[:, None] * phi * stretch * _slopes(delta), axis=0))


def _slopes(values: Floats) -> Floats:
    """Derivatives by the parameter in [0, 1] at Gauss' nodes along the first axis."""
    nodes = np.polynomial.legendre.leggauss(_ACROSS)[0]
    series = np.polynomial.legendre.legfit(nodes, values, _ACROSS - 1)
    return np.asarray(2 * np.polynomial.legendre.legval(nodes, np.polynomial.legendre.legder(series)).T)
