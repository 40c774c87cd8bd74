"""Curvature of the theoretical flank in closed form, and of a modelled surface, by the fundamental forms."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.errors import GeometryError
from gearstudio.nurbs import NurbsSurface, basis_matrix
from gearstudio.theory.flank import Flank
from gearstudio.theory.vectors import dot, matched

Floats = NDArray[np.float64]
Derivatives = tuple[Floats, Floats, Floats, Floats, Floats]

_BELOW_PSI = 1e-6


@dataclass(frozen=True)
class CurvatureMap:
    """Curvature at points of a surface, seen from outside the metal; arrays of shape (n_u, n_v).

    A convex flank has positive normal curvatures.

    Attributes
    ----------
    points, normals : ndarray, shape (n_u, n_v, 3)
        [mm]; unit vectors out of the metal.
    gaussian : ndarray
        [1/mm²]
    mean, largest, smallest : ndarray
        Mean and principal curvatures [1/mm].
    """

    points: Floats
    normals: Floats
    gaussian: Floats
    mean: Floats
    largest: Floats
    smallest: Floats

    def less(self, other: CurvatureMap) -> CurvatureMap:
        """The difference of every curvature to that of another map at the same places."""
        return CurvatureMap(
            self.points,
            self.normals,
            self.gaussian - other.gaussian,
            self.mean - other.mean,
            self.largest - other.largest,
            self.smallest - other.smallest,
        )


def theory_curvature(flank: Flank, u: ArrayLike, v: ArrayLike) -> CurvatureMap:
    """Curvature of the theoretical flank at (u, v), broadcast together; see `theory_curvature_at`."""
    return theory_curvature_at(flank, *flank.coordinates(u, v))


def theory_curvature_at(flank: Flank, psi: ArrayLike, rho: ArrayLike) -> CurvatureMap:
    """Curvature of the theoretical flank at natural coordinates.

    Parameters
    ----------
    flank : Flank
    psi, rho : array_like
        Arc [rad] and cone distance [mm], broadcast together.

    Raises
    ------
    GeometryError
        A point lies on the base cone, where one curvature is infinite.
    """
    psi, rho = matched(psi, rho)
    if np.any(psi < _BELOW_PSI):
        raise GeometryError("the flank's curvature is infinite on the base cone; take points above it")
    return _curvature(flank.at(psi, rho), flank.derivatives_at(psi, rho), flank.normals_at(psi, rho))


def surface_curvature(surface: NurbsSurface, flank: Flank, u: ArrayLike, v: ArrayLike) -> CurvatureMap:
    """Curvature of a modelled flank on the tensor grid of two parameter lists (of the surface's own range).

    The theoretical flank says which side is outside. It raises GeometryError where the surface is folded.
    """
    points, derivatives = surface_derivatives(surface, u, v)
    psi, rho = flank.natural(points)
    return _curvature(points, derivatives, flank.normals_at(psi, rho))


def curvature_difference(surface: NurbsSurface, flank: Flank, u: ArrayLike, v: ArrayLike) -> CurvatureMap:
    """Curvature of a modelled flank less that of theory at the same places.

    Raises
    ------
    GeometryError
        A place lies on the base cone (as `theory_curvature_at`); keep u away from 0 where the flank starts there.
    """
    modelled = surface_curvature(surface, flank, u, v)
    return modelled.less(theory_curvature_at(flank, *flank.natural(modelled.points)))


def surface_derivatives(surface: NurbsSurface, u: ArrayLike, v: ArrayLike) -> tuple[Floats, Derivatives]:
    """Points and X_u, X_v, X_uu, X_uv, X_vv of a surface on a tensor grid, shape (len(u), len(v), 3) each."""
    weights = np.ones(surface.poles.shape[:2]) if surface.weights is None else surface.weights
    poles = np.concatenate([surface.poles * weights[..., None], weights[..., None]], axis=-1)
    along_u = [basis_matrix(u, surface.knots_u, surface.degree_u, k) for k in range(3)]
    along_v = [basis_matrix(v, surface.knots_v, surface.degree_v, k) for k in range(3)]

    def part(i: int, j: int) -> tuple[Floats, Floats]:
        full = np.einsum("ai,ijk,bj->abk", along_u[i], poles, along_v[j], optimize=True)
        return full[..., :3], full[..., 3:]

    (a, w), (a_u, w_u), (a_v, w_v) = part(0, 0), part(1, 0), part(0, 1)
    (a_uu, w_uu), (a_uv, w_uv), (a_vv, w_vv) = part(2, 0), part(1, 1), part(0, 2)
    x = a / w
    x_u, x_v = (a_u - w_u * x) / w, (a_v - w_v * x) / w
    x_uu = (a_uu - 2 * w_u * x_u - w_uu * x) / w
    x_uv = (a_uv - w_u * x_v - w_v * x_u - w_uv * x) / w
    x_vv = (a_vv - 2 * w_v * x_v - w_vv * x) / w
    return x, (x_u, x_v, x_uu, x_uv, x_vv)


def _curvature(points: Floats, derivatives: Derivatives, outward: Floats) -> CurvatureMap:
    """From the first and second fundamental form."""
    a, b, a_a, a_b, b_b = derivatives
    normal = np.cross(a, b)
    area = np.linalg.norm(normal, axis=-1, keepdims=True)
    if np.any(area <= np.finfo(float).eps * np.linalg.norm(a, axis=-1, keepdims=True)):
        raise GeometryError("the surface has no tangent plane somewhere; it is folded or starts on the base cone")
    normal = normal / area
    normal = np.where(dot(normal, outward)[..., None] < 0, -normal, normal)
    E, F, G = dot(a, a), dot(a, b), dot(b, b)
    L, M, N = -dot(a_a, normal), -dot(a_b, normal), -dot(b_b, normal)
    square = E * G - F * F
    gaussian = (L * N - M * M) / square
    mean = (E * N - 2 * F * M + G * L) / (2 * square)
    spread = np.sqrt(np.maximum(mean**2 - gaussian, 0.0))
    return CurvatureMap(points, normal, gaussian, mean, mean + spread, mean - spread)
