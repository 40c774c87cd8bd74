"""The faces of one pitch of a gear on grids, as fine as a chordal tolerance asks; numpy alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.nurbs import NurbsSurface, basis_matrix
from gearstudio.results import SolidResult
from gearstudio.theory.chamfer import EndChamfer
from gearstudio.theory.spread import Spread
from ui.grids import grid_triangles
from ui.meshes import Mesh

Floats = NDArray[np.float64]

_PROBE = 17
_MOST = 24
_MOST_TRIANGLES = 260_000


@dataclass(frozen=True, eq=False)
class Patch:
    """A face on a grid: points and unit normals (n_u, n_v, 3)."""

    points: Floats
    normals: Floats


def pitch_patches(result: SolidResult, chamfers: Sequence[EndChamfer], tolerance: float) -> list[Patch]:
    """Every face of a pitch as far as chamfers leave it; neighbours share the places of their points."""
    counts = [_counts(face.surface, tolerance) for face in result.faces]
    along = max(n_v for _, n_v in counts)
    across = [n_u for n_u, _ in counts]
    heavy = 2 * along * sum(across) * result.teeth / _MOST_TRIANGLES
    if heavy > 1:
        along = max(3, round(along / heavy))
    spreads = [Spread.of(face.surface, chamfers) for face in result.faces]
    return [_patch(spread, n, along + 1) for spread, n in zip(spreads, across, strict=True)]


def _counts(surface: NurbsSurface, tolerance: float) -> tuple[int, int]:
    """Segments in u and v that keep a chord within the tolerance."""
    grid = surface.uniform_grid(_PROBE, _PROBE)
    found = []
    for curves in (np.swapaxes(grid, 0, 1), grid):
        bend = curves[:, 2:] - 2 * curves[:, 1:-1] + curves[:, :-2]
        chord = curves[:, 2:] - curves[:, :-2]
        length = np.einsum("ijk,ijk->ij", chord, chord)
        along = np.einsum("ijk,ijk->ij", bend, chord) / np.maximum(length, np.finfo(float).tiny)
        sag = np.linalg.norm(bend - along[..., None] * chord, axis=-1).max() / 8
        found.append(int(np.clip(np.ceil((_PROBE - 1) * np.sqrt(sag / tolerance)), 1, _MOST)))
    return found[0], found[1]


def _patch(spread: Spread, steps: int, n_v: int) -> Patch:
    surface, share = spread.surface, np.linspace(0.0, 1.0, n_v)
    u = spread.places(spread.steps(steps))
    v = spread.between(u, share)
    points, along_u, along_v = _derivatives_at(surface, u, v)
    normals = np.cross(along_u, along_v)
    length = np.linalg.norm(normals, axis=-1, keepdims=True)
    flat = length[..., 0] <= 1e-9 * length.max(initial=0.0)
    if np.any(flat):  # an edge where the surface is not regular takes its neighbours' normals
        inner = np.cross(*_derivatives_at(surface, u + 1e-4 * (0.5 - u) * 2, v + 1e-4 * (0.5 - v) * 2)[1:])
        normals = np.where(flat[..., None], inner, normals)
        length = np.linalg.norm(normals, axis=-1, keepdims=True)
    return Patch(points, normals / np.maximum(length, np.finfo(float).tiny))


def _derivatives_at(surface: NurbsSurface, u: Floats, v: Floats) -> tuple[Floats, Floats, Floats]:
    """Points and both first derivatives at u (n,) and v (n, m): at once where every row has the same v."""
    if np.all(v == v[0]):
        return _with_derivatives(surface, u, v[0])
    rows = [_with_derivatives(surface, u[k : k + 1], v[k]) for k in range(len(u))]
    points, along_u, along_v = (np.concatenate(part) for part in zip(*rows, strict=True))
    return points, along_u, along_v


def _with_derivatives(surface: NurbsSurface, u: Floats, v: Floats) -> tuple[Floats, Floats, Floats]:
    """Points and both first derivatives on a grid."""
    bu, du = (basis_matrix(u, surface.knots_u, surface.degree_u, order) for order in (0, 1))
    bv, dv = (basis_matrix(v, surface.knots_v, surface.degree_v, order) for order in (0, 1))
    weights = np.ones(surface.poles.shape[:2]) if surface.weights is None else surface.weights
    poles = np.concatenate([surface.poles * weights[..., None], weights[..., None]], axis=-1)
    bases = ((bu, bv), (du, bv), (bu, dv))
    value, by_u, by_v = (np.einsum("ai,ijk,bj->abk", a, poles, b, optimize=True) for a, b in bases)
    weight = value[..., 3:]
    points = value[..., :3] / weight
    return points, (by_u[..., :3] - by_u[..., 3:] * points) / weight, (by_v[..., :3] - by_v[..., 3:] * points) / weight


def patch_mesh(patch: Patch) -> Mesh:
    """Quadrilaterals cut along their shorter diagonals, which lie nearer to a twisted face."""
    rows, cols = patch.points.shape[:2]
    cells = grid_triangles(rows, cols)
    usual = patch.points[:-1, 1:] - patch.points[1:, :-1]
    other = patch.points[1:, 1:] - patch.points[:-1, :-1]
    if np.linalg.norm(other, axis=-1).sum() < np.linalg.norm(usual, axis=-1).sum():
        backwards = np.arange(rows * cols).reshape(rows, cols)[:, ::-1].ravel()
        cells = backwards[cells][:, ::-1]
    return Mesh(patch.points.reshape(-1, 3), patch.normals.reshape(-1, 3), cells)
