"""B-spline curves and surfaces as plain arrays: what methods hand over and analysis reads.

The kernel builds surfaces; this record carries one out of it without loss, so that a window or a
deviation map needs no CAD kernel to evaluate it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]


def basis_matrix(parameters: ArrayLike, knots: Floats, degree: int, derivative: int = 0) -> Floats:
    """Values of all basis functions at the given parameters.

    Parameters
    ----------
    parameters : array_like, shape (n,)
        Within the knot range; outside it the end polynomials are continued.
    knots : ndarray, shape (m + degree + 1,)
        Clamped, with multiplicities written out.
    degree : int
    derivative : int
        Order of derivative, 0 for the values.

    Returns
    -------
    ndarray, shape (n, m)
    """
    count = len(knots) - degree - 1
    from scipy.interpolate import BSpline

    spline = BSpline(knots, np.eye(count), degree, extrapolate=True)
    return np.asarray(spline(np.asarray(parameters, dtype=np.float64), nu=derivative))


@dataclass(frozen=True)
class NurbsSurface:
    """A tensor-product (rational) B-spline surface.

    Attributes
    ----------
    poles : ndarray, shape (n_u, n_v, 3)
        Control points [mm].
    knots_u, knots_v : ndarray
        Clamped knot vectors with multiplicities written out.
    degree_u, degree_v : int
    weights : ndarray, shape (n_u, n_v), or None
        None for a polynomial surface.
    """

    poles: Floats
    knots_u: Floats
    knots_v: Floats
    degree_u: int
    degree_v: int
    weights: Floats | None = None

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Parameter range (u0, u1, v0, v1)."""
        return (
            float(self.knots_u[0]),
            float(self.knots_u[-1]),
            float(self.knots_v[0]),
            float(self.knots_v[-1]),
        )

    def grid(self, u: ArrayLike, v: ArrayLike) -> Floats:
        """Points on the tensor grid of two parameter lists, shape (len(u), len(v), 3)."""
        bu = basis_matrix(u, self.knots_u, self.degree_u)
        bv = basis_matrix(v, self.knots_v, self.degree_v)
        if self.weights is None:
            return np.asarray(np.einsum("ai,ijk,bj->abk", bu, self.poles, bv, optimize=True))
        homogeneous = np.einsum("ai,ijk,bj->abk", bu, self.poles * self.weights[..., None], bv, optimize=True)
        scale = bu @ self.weights @ bv.T
        return np.asarray(homogeneous / scale[..., None])

    def points(self, u: ArrayLike, v: ArrayLike) -> Floats:
        """Points at pairs of parameters of like shape (...), shape (..., 3)."""
        u, v = np.broadcast_arrays(np.asarray(u, dtype=np.float64), np.asarray(v, dtype=np.float64))
        bu = basis_matrix(u.ravel(), self.knots_u, self.degree_u)
        bv = basis_matrix(v.ravel(), self.knots_v, self.degree_v)
        weights = np.ones(self.poles.shape[:2]) if self.weights is None else self.weights
        rows = np.einsum("ai,ijk->ajk", bu, np.concatenate([self.poles * weights[..., None], weights[..., None]], -1))
        homogeneous = np.einsum("ajk,aj->ak", rows, bv)
        return np.asarray(homogeneous[:, :3] / homogeneous[:, 3:]).reshape(*u.shape, 3)

    def uniform_grid(self, n_u: int, n_v: int) -> Floats:
        """Points at evenly spaced parameters, both ends included, shape (n_u, n_v, 3)."""
        u0, u1, v0, v1 = self.bounds
        return self.grid(np.linspace(u0, u1, n_u), np.linspace(v0, v1, n_v))
