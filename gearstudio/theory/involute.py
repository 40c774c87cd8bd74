"""The spherical involute and the plane that rolls on the base cone (theory 3 and 5.1)."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.vectors import matched

Floats = NDArray[np.float64]


def roll_arc(polar_angle: ArrayLike, base_angle: float) -> Floats:
    r"""Arc psi rolled off the base circle when the involute reaches a polar angle.

    Parameters
    ----------
    polar_angle : array_like, shape (...)
        delta_k [rad], base_angle <= delta_k <= pi - base_angle.
    base_angle : float
        delta_b [rad], in (0, pi/2).

    Returns
    -------
    ndarray, shape (...)
        psi [rad], 0 on the base cone; the roll angle is psi / sin(delta_b).

    Raises
    ------
    GeometryError
        A polar angle lies inside the base cone, where the involute does not exist, or is not a number.

    Notes
    -----
    .. math:: \cos\psi = \cos\delta_k / \cos\delta_b

    theory.md section 3, by half angles: arccos has lost half its digits near the base cone.
    """
    delta = np.asarray(polar_angle, dtype=np.float64)
    if not 0 < base_angle < np.pi / 2:
        raise GeometryError(f"base angle {base_angle:.6g} rad is outside (0, pi/2)")
    slack = 4 * np.finfo(float).eps
    if not np.all((delta >= base_angle - slack) & (delta <= np.pi - base_angle + slack)):
        raise GeometryError("polar angle lies inside the base cone: the involute does not exist there")
    square = np.sin((delta + base_angle) / 2) * np.sin((delta - base_angle) / 2) / np.cos(base_angle)
    return np.asarray(2 * np.arcsin(np.sqrt(np.clip(square, 0.0, 1.0))))


def polar_angle(psi: ArrayLike, base_angle: float) -> Floats:
    """Polar angle delta_k [rad] reached after rolling the arc psi [rad]; the inverse of `roll_arc`."""
    psi = np.asarray(psi, dtype=np.float64)
    square = np.sin(base_angle / 2) ** 2 + np.cos(base_angle) * np.sin(psi / 2) ** 2
    return np.asarray(2 * np.arcsin(np.sqrt(square)))


def azimuth_from_arc(psi: ArrayLike, base_angle: float) -> Floats:
    """Azimuth beta [rad] of the involute's point after rolling the arc psi [rad] (theory 3).

    It starts as psi^3: the flank leaves the base cone along a meridian.
    """
    psi = np.asarray(psi, dtype=np.float64)
    sin_b = np.sin(base_angle)
    return np.asarray(psi / sin_b - np.arctan2(np.sin(psi), sin_b * np.cos(psi)))


def involute_azimuth(polar_angle: ArrayLike, base_angle: float) -> Floats:
    r"""Azimuth of a spherical involute at a given polar angle.

    The involute leaves the base cone at azimuth 0 and unwinds towards positive azimuth; mirror it for the
    opposite flank. It does not depend on the distance from the apex.

    Parameters
    ----------
    polar_angle : array_like, shape (...)
        delta_k [rad].
    base_angle : float
        delta_b [rad].

    Returns
    -------
    ndarray, shape (...)
        beta(delta_k) [rad].

    Raises
    ------
    GeometryError
        As `roll_arc`.

    Notes
    -----
    .. math:: \beta = \psi/\sin\delta_b - \operatorname{atan2}(\sin\psi, \sin\delta_b\cos\psi)

    theory.md section 3 (the paper's equations 1 and 11 divide both terms by sin(delta_b)).
    """
    return azimuth_from_arc(roll_arc(polar_angle, base_angle), base_angle)


def base_azimuth(member: MemberGeometry) -> float:
    """Half a tooth's azimuth on the base cone, where its profile starts: at the pitch cone, and beta(delta) [rad]."""
    return member.half_tooth_azimuth + float(involute_azimuth(member.pitch_angle, member.base_angle))


def start_azimuth(member: MemberGeometry, side: int, rho: ArrayLike) -> Floats:
    """Azimuth phi_0 [rad] where a flank meets the base cone at cone distance rho [mm] (theory 5.1)."""
    return np.asarray(side * base_azimuth(member) + member.lengthwise.azimuth(rho))


def tangent_plane(base_angle: ArrayLike, contact_azimuth: ArrayLike) -> tuple[Floats, Floats, Floats]:
    """Axes of the plane that touches the base cone at an azimuth, each of shape (..., 3) (theory 5.1).

    Returns
    -------
    along, across, normal : ndarray, shape (..., 3)
        e_t along the line of contact, e_phi across it in the plane, and e_t x e_phi reversed: out of the cone.
    """
    a = np.asarray(contact_azimuth, dtype=np.float64)
    sin_b, cos_b, zero = np.sin(base_angle), np.cos(base_angle), np.zeros_like(a)
    along = np.stack([sin_b * np.cos(a), sin_b * np.sin(a), zero + cos_b], axis=-1)
    across = np.stack([-np.sin(a), np.cos(a), zero], axis=-1)
    normal = np.stack([cos_b * np.cos(a), cos_b * np.sin(a), zero - sin_b], axis=-1)
    return along, across, normal


def generating_line(member: MemberGeometry, side: int, rho: ArrayLike, contact_azimuth: ArrayLike) -> Floats:
    """Points of the generating line while the plane touches the base cone at an azimuth.

    Parameters
    ----------
    member : MemberGeometry
    side : {+1, -1}
    rho : array_like, shape (...)
        Cone distances of the points [mm].
    contact_azimuth : array_like, broadcastable with rho
        a [rad]. All points of one line share it: the line moves as a rigid body.

    Returns
    -------
    ndarray, shape (..., 3)

    Notes
    -----
    K(rho; a) = rho [cos(psi) e_t(a) + sin(psi) e_phi(a)], psi = (phi_0(rho) - a) sin(delta_b):
    theory.md section 5.1. psi of the wrong sign for the side lies beyond the cusp and is no flank.
    """
    rho, a = matched(rho, contact_azimuth)
    psi = (start_azimuth(member, side, rho) - a) * np.sin(member.base_angle)
    along, across, _ = tangent_plane(member.base_angle, a)
    unit = np.cos(psi)[..., None] * along + np.sin(psi)[..., None] * across
    return np.asarray(rho[..., None] * unit)


def base_cone_spiral(member: MemberGeometry, side: int, rho: ArrayLike) -> Floats:
    """Starting points (R_n, delta_b, theta_n) of the involutes on the base cone, shape (..., 3) (theory 5.1, [8])."""
    rho = np.asarray(rho, dtype=np.float64)
    azimuth = start_azimuth(member, side, rho)
    sin_b, cos_b = np.sin(member.base_angle), np.cos(member.base_angle)
    return np.stack([rho * sin_b * np.cos(azimuth), rho * sin_b * np.sin(azimuth), rho * cos_b], axis=-1)
