"""Small tools for arrays of vectors, shape (..., 3)."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]


def matched(a: ArrayLike, b: ArrayLike) -> tuple[Floats, Floats]:
    """Two quantities as floats of one shape, broadcast together."""
    first, second = np.broadcast_arrays(np.asarray(a, dtype=np.float64), np.asarray(b, dtype=np.float64))
    return first, second


def of(x: Floats, y: Floats, z: Floats | np.float64) -> Floats:
    """Vectors of components, the first as large as any; on short arrays several times faster than numpy's stack."""
    made = np.empty((*x.shape, 3))
    made[..., 0], made[..., 1], made[..., 2] = x, y, z
    return made


def cross(a: Floats, b: Floats) -> Floats:
    """a x b; several times faster on long arrays than numpy's own."""
    ax, ay, az = a[..., 0], a[..., 1], a[..., 2]
    bx, by, bz = b[..., 0], b[..., 1], b[..., 2]
    return of(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)


def dot(a: Floats, b: Floats) -> Floats:
    """a . b, shape (...)."""
    return np.asarray(a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1] + a[..., 2] * b[..., 2])


def turned(vectors: Floats, angle: Floats) -> Floats:
    """Vectors turned about z by an angle each."""
    c, s = np.cos(angle), np.sin(angle)
    x, y = vectors[..., 0], vectors[..., 1]
    return of(c * x - s * y, s * x + c * y, vectors[..., 2])


def quarter(vectors: Floats) -> Floats:
    """z x vectors: turned by a quarter about the axis, the axial part dropped."""
    return of(-vectors[..., 1], vectors[..., 0], np.float64(0.0))


def turned_derivatives(
    point: Floats, by: tuple[Floats, ...], shift: tuple[Floats, ...]
) -> tuple[Floats, Floats, Floats, Floats, Floats]:
    """First and second derivatives of R_z(s) X by two parameters (a, b, aa, ab, bb), shape (..., 3) each.

    Parameters
    ----------
    point : array, shape (..., 3)
        X.
    by : five arrays, shape (..., 3)
        Derivatives of X.
    shift : six arrays, shape (...)
        s and its derivatives.
    """
    s, s_a, s_b, s_aa, s_ab, s_bb = (part[..., None] for part in shift)
    a, b, aa, ab, bb = by
    x_j, a_j, b_j = quarter(point), quarter(a), quarter(b)
    x_jj = quarter(x_j)
    parts = (
        a + s_a * x_j,
        b + s_b * x_j,
        aa + 2 * s_a * a_j + s_aa * x_j + s_a**2 * x_jj,
        ab + s_a * b_j + s_b * a_j + s_ab * x_j + s_a * s_b * x_jj,
        bb + 2 * s_b * b_j + s_bb * x_j + s_b**2 * x_jj,
    )
    first, second, *others = (turned(part, s[..., 0]) for part in parts)
    return first, second, others[0], others[1], others[2]


def spherical(points: ArrayLike) -> tuple[Floats, Floats, Floats]:
    """Spherical coordinates rho [mm], delta_k [rad], phi [rad] of points, shape (...) each (theory 1)."""
    x, y, z = np.moveaxis(np.asarray(points, dtype=np.float64), -1, 0)
    radius = np.hypot(x, y)
    return np.hypot(radius, z), np.arctan2(radius, z), np.arctan2(y, x)


def from_spherical(rho: ArrayLike, polar_angle: ArrayLike, azimuth: ArrayLike) -> Floats:
    """Points of spherical coordinates, broadcast together, shape (..., 3) [mm]: the inverse of `spherical`."""
    rho, azimuth = np.asarray(rho, dtype=np.float64), np.asarray(azimuth, dtype=np.float64)
    radius = rho * np.sin(polar_angle)
    return of(radius * np.cos(azimuth), radius * np.sin(azimuth), rho * np.cos(polar_angle))


def wrapped(angle: ArrayLike) -> Floats:
    """Angles brought to the turn from -pi to pi [rad]."""
    return np.asarray(np.remainder(np.asarray(angle, dtype=np.float64) + np.pi, 2 * np.pi) - np.pi)


def unit(vectors: Floats) -> Floats:
    """Vectors of length one."""
    return np.asarray(vectors / np.sqrt(dot(vectors, vectors))[..., None])


def about_axis(angle: float) -> Floats:
    """Rotation matrix about z, shape (3, 3)."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
