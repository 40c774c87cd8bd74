"""Curvature of conjugate flanks by how their normals turn, without second derivatives."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.hypoid.conjugate import ConjugateFlank
from gearstudio.theory.vectors import dot

Floats = NDArray[np.float64]


def curvatures(flank: ConjugateFlank, psi: Floats, rho: Floats) -> tuple[Floats, Floats]:
    """Principal curvatures of a flank without micro-geometry, the larger first, positive where convex [1/mm]."""
    p = flank.envelope.at(psi, rho)
    E, F, G = dot(p.by_psi, p.by_psi), dot(p.by_psi, p.by_rho), dot(p.by_rho, p.by_rho)
    L, N = dot(p.normal_by_psi, p.by_psi), dot(p.normal_by_rho, p.by_rho)
    M = (dot(p.normal_by_psi, p.by_rho) + dot(p.normal_by_rho, p.by_psi)) / 2
    square = E * G - F * F
    mean, gaussian = (E * N - 2 * F * M + G * L) / (2 * square), (L * N - M * M) / square
    spread = np.sqrt(np.maximum(mean**2 - gaussian, 0.0))
    return mean + spread, mean - spread
