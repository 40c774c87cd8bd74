"""Curvature and normals of modelled flanks where their deviation is drawn, beside those of theory; numpy alone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.curvature import (
    CurvatureMap,
    surface_curvature,
    surface_derivatives,
    theory_curvature_at,
)
from gearstudio.errors import GeometryError
from gearstudio.nurbs import NurbsSurface
from gearstudio.results import FlankResult, VariantResult
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import Flank
from gearstudio.theory.modified import flank_of

Floats = NDArray[np.float64]
NAMES = ("gaussian", "mean", "largest", "smallest")
_ABOVE_BASE = 2e-3
"""Roll arc [rad] below which theory counts as infinitely curved; a value there would say nothing."""
_NO_CURVATURE = 1e-9
"""Part of the typical curvature below which a relative difference has no meaning."""


@dataclass(frozen=True, eq=False)
class FlankQuality:
    """Of one flank, arrays (n_u, n_v, ...) at the points of its deviation map; NaN where curvature is infinite.

    Attributes
    ----------
    normals : ndarray, shape (n_u, n_v, 3)
        Out of the metal.
    made, theory : dict of ndarray
        Curvatures by name [1/mm, 1/mm²].
    profile, lengthwise : ndarray
        Normal curvature of the parameter lines along the profile and along the face [1/mm], convex positive.
    """

    normals: Floats
    made: dict[str, Floats]
    theory: dict[str, Floats]
    profile: Floats
    lengthwise: Floats

    def values(self, name: str, against: str) -> Floats:
        """A curvature, less that of theory [same unit], or relative to it [%]."""
        if not against:
            return self.made[name]
        difference = self.made[name] - self.theory[name]
        if against == "absolute":
            return difference
        size = np.abs(self.theory[name])
        least = _NO_CURVATURE * float(np.nanmedian(size)) if np.any(np.isfinite(size)) else 0.0
        with np.errstate(all="ignore"):
            return np.where(size > least, 100 * difference / size, np.nan)


def variant_quality(result: VariantResult, member: MemberGeometry) -> dict[str, FlankQuality]:
    """Both flanks of a result, by name.

    Raises
    ------
    GeometryError
        A surface is folded.
    """
    return {
        name: flank_quality(flank, flank_of(member, "concave" if name == "concave" else "convex"))
        for name, flank in result.flanks.items()
    }


def flank_quality(result: FlankResult, flank: Flank) -> FlankQuality:
    """Curvature at the points of the deviation map; see `FlankQuality`."""
    rows, cols = result.points.shape[:2]
    u0, u1, v0, v1 = result.surface.bounds
    u, v = np.linspace(u0, u1, rows), np.linspace(v0, v1, cols)
    start = 0
    try:
        found = surface_curvature(result.surface, flank, u, v)
    except GeometryError:  # it may start on the base cone, where it has no curvature
        start = 1
        found = surface_curvature(result.surface, flank, u[1:], v)
    psi, rho = flank.natural(found.points)
    steady = psi > _ABOVE_BASE
    exact = theory_curvature_at(flank, np.where(steady, psi, 1.0), rho)
    lines = line_curvatures(result.surface, u[start:], v, found.normals)

    def whole(values: Floats) -> Floats:
        return np.concatenate([np.full((start, *values.shape[1:]), np.nan), np.where(steady, values, np.nan)])

    normals = np.concatenate([found.normals[:start], found.normals])
    return FlankQuality(normals, _named(found, whole), _named(exact, whole), whole(lines[0]), whole(lines[1]))


def _named(found: CurvatureMap, whole: object) -> dict[str, Floats]:
    return {name: whole(np.asarray(getattr(found, name))) for name in NAMES}  # type: ignore[operator]


def line_curvatures(surface: NurbsSurface, u: Floats, v: Floats, normals: Floats) -> tuple[Floats, Floats]:
    """Normal curvature of the parameter lines along u and v, L/E and N/G of the fundamental forms, (n_u, n_v) each."""
    _, (along_u, along_v, second_u, _, second_v) = surface_derivatives(surface, u, v)

    def curvature(first: Floats, second: Floats) -> Floats:
        return np.asarray(-np.sum(second * normals, axis=-1) / np.sum(first * first, axis=-1))

    return curvature(along_u, second_u), curvature(along_v, second_v)
