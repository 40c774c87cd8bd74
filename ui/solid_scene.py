"""A whole gear as meshes for the eye and for measuring, from the surfaces of its solid; numpy alone.

Every face is evaluated on a grid as fine as a chordal tolerance asks; one pitch is made and turned for the other
teeth. Neighbouring patches share the places of their points, so that all of them together are closed.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from gearstudio.nurbs import NurbsSurface, basis_matrix
from gearstudio.results import FaceResult, SolidResult
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.modified import flank_on
from ui.grids import grid_triangles, path_segments, turned
from ui.meshes import Mesh, copied_cells, copies, joined, stitched, turned_to

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]

FINE, COARSE = 1.5e-4, 1.2e-3
"""Chordal tolerances, of the radius of the gear."""
_PROBE = 17
_MOST = 24
_MOST_TRIANGLES = 260_000
_CREASE = np.cos(np.radians(9.0))


@dataclass(frozen=True, eq=False)
class GearMesh:
    """A gear as three meshes that close each other, and the edges one sees.

    Attributes
    ----------
    flanks, teeth, body : Mesh
        Both flanks of every tooth; tips, fillets and roots; end faces and the turned body.
    deviation_um : ndarray, shape (len(flanks.points),)
        Signed normal deviation from theory [µm].
    edges : ndarray, shape (n, 3)
    segments : ndarray, shape (m, 2)
    """

    flanks: Mesh
    teeth: Mesh
    body: Mesh
    deviation_um: Floats
    edges: Floats
    segments: Indices

    @property
    def volume(self) -> float:
        """Enclosed by all three [mm^3]."""
        return self.flanks.enclosed + self.teeth.enclosed + self.body.enclosed

    @property
    def triangles(self) -> int:
        """Of all three."""
        return sum(len(mesh.cells) for mesh in (self.flanks, self.teeth, self.body))


def gear_radius(result: SolidResult) -> float:
    """Largest distance from the axis, as the box tells [mm]."""
    return float(np.abs(result.box[:, :2]).max())


def gear_mesh(result: SolidResult, member: MemberGeometry, fineness: float = FINE) -> GearMesh:
    """Mesh a gear.

    Parameters
    ----------
    result : SolidResult
    member : MemberGeometry
        The theory from which the flanks' deviation is taken.
    fineness : float
        Chordal tolerance, of the gear's radius.
    """
    tolerance = fineness * gear_radius(result)
    azimuths = 2 * np.pi / result.teeth * np.arange(result.teeth)
    patches = _patches(result, tolerance)
    is_flank = [face.kind == "flank" for face in result.faces]
    meshes = [_patch_mesh(patch) for patch in patches]
    flanks = joined([mesh for mesh, flank in zip(meshes, is_flank, strict=True) if flank])
    others = joined([mesh for mesh, flank in zip(meshes, is_flank, strict=True) if not flank])
    body, rings = _body(result, patches, azimuths, tolerance)
    edges, segments = _edges(patches, azimuths, rings)
    off = [_deviation(member, f, p.points) for f, p, x in zip(result.faces, patches, is_flank, strict=True) if x]
    deviation = np.tile(np.concatenate(off) if off else np.empty(0), result.teeth)
    return GearMesh(copies(flanks, azimuths), copies(others, azimuths), body, deviation, edges, segments)


# ---- faces of one pitch -----------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class _Patch:
    """A face on a grid: points and unit normals (n_u, n_v, 3)."""

    points: Floats
    normals: Floats


def _patches(result: SolidResult, tolerance: float) -> list[_Patch]:
    counts = [_counts(face.surface, tolerance) for face in result.faces]
    along = max(n_v for _, n_v in counts)
    across = [n_u for n_u, _ in counts]
    heavy = 2 * along * sum(across) * result.teeth / _MOST_TRIANGLES
    if heavy > 1:
        along = max(3, round(along / heavy))
    return [_patch(face.surface, n + 1, along + 1) for face, n in zip(result.faces, across, strict=True)]


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


def _patch(surface: NurbsSurface, n_u: int, n_v: int) -> _Patch:
    u0, u1, v0, v1 = surface.bounds
    u, v = np.linspace(u0, u1, n_u), np.linspace(v0, v1, n_v)
    points, along_u, along_v = _with_derivatives(surface, u, v)
    normals = np.cross(along_u, along_v)
    length = np.linalg.norm(normals, axis=-1, keepdims=True)
    flat = length[..., 0] <= 1e-9 * length.max(initial=0.0)
    if np.any(flat):  # an edge where the surface is not regular takes its neighbours' normals
        inner = np.cross(*_with_derivatives(surface, u + 1e-4 * (0.5 - u) * 2, v + 1e-4 * (0.5 - v) * 2)[1:])
        normals = np.where(flat[..., None], inner, normals)
        length = np.linalg.norm(normals, axis=-1, keepdims=True)
    return _Patch(points, normals / np.maximum(length, np.finfo(float).tiny))


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


def _patch_mesh(patch: _Patch) -> Mesh:
    """Quadrilaterals cut along their shorter diagonals, which lie nearer to a twisted face."""
    rows, cols = patch.points.shape[:2]
    cells = grid_triangles(rows, cols)
    usual = patch.points[:-1, 1:] - patch.points[1:, :-1]
    other = patch.points[1:, 1:] - patch.points[:-1, :-1]
    if np.linalg.norm(other, axis=-1).sum() < np.linalg.norm(usual, axis=-1).sum():
        backwards = np.arange(rows * cols).reshape(rows, cols)[:, ::-1].ravel()
        cells = backwards[cells][:, ::-1]
    return Mesh(patch.points.reshape(-1, 3), patch.normals.reshape(-1, 3), cells)


def _deviation(member: MemberGeometry, face: FaceResult, points: Floats) -> Floats:
    return 1e3 * np.asarray(flank_on(member, face.side).deviation(points)).ravel()


# ---- ends and body ----------------------------------------------------------------------------------------


def _body(result: SolidResult, patches: list[_Patch], azimuths: Floats, tolerance: float) -> tuple[Mesh, list[Floats]]:
    """End faces and turned faces, and the circles where they meet at an angle."""
    outline = result.outline
    step = 2 * np.sqrt(2 * tolerance / max(float(outline[:, 0].max()), tolerance))
    count = result.teeth * int(np.ceil(2 * np.pi / result.teeth / min(step, 0.6)))
    around = 2 * np.pi / count * np.arange(count)
    heel, toe = (_profile(patches, azimuths, end) for end in (-1, 0))
    meshes = [_end(heel, outline[0], around, 1.0, result.spherical_ends, tolerance)]
    meshes += [_strip(here, there, around) for here, there in pairwise(outline)]
    meshes.append(_end(toe, outline[-1], around, -1.0, result.spherical_ends, tolerance))
    rings = [_ring(point, around) for point in outline if point[0] > 0]
    return joined(meshes), rings


def _profile(patches: list[_Patch], azimuths: Floats, end: int) -> Floats:
    """The closed loop of tooth profiles at toe (0) or heel (-1), every point once, shape (n, 3)."""
    pitch = np.concatenate([patch.points[:-1, end] for patch in patches])
    return turned(pitch, azimuths).reshape(-1, 3)


def _ring(point: Floats, around: Floats) -> Floats:
    radius, height = point
    return np.stack([radius * np.cos(around), radius * np.sin(around), np.full_like(around, height)], axis=-1)


def _revolved_normals(way: Floats, points: Floats) -> Floats:
    """Normals of a cone, cylinder or plane whose outline runs this way (radius, height), at points."""
    n_r, n_z = np.array([way[1], -way[0]]) / np.linalg.norm(way)
    azimuth = np.arctan2(points[:, 1], points[:, 0])
    return np.stack([n_r * np.cos(azimuth), n_r * np.sin(azimuth), np.full_like(azimuth, n_z)], axis=-1)


def _strip(here: Floats, there: Floats, around: Floats) -> Mesh:
    closed = np.append(around, around[0])
    points = np.concatenate([_ring(here, closed), _ring(there, closed)])
    angles = np.concatenate([closed, closed])
    directions = np.stack([np.cos(angles), np.sin(angles), np.zeros_like(angles)], axis=-1)
    return turned_to(Mesh(points, _revolved_normals(there - here, directions), grid_triangles(2, len(closed))))


def _end(loop: Floats, ring: Floats, around: Floats, sign: float, spherical: bool, tolerance: float) -> Mesh:
    """The face between the tooth profiles and the body; a sphere in several rows, a cone in one."""
    azimuth = np.unwrap(np.arctan2(loop[:, 1], loop[:, 0]))
    radius = np.hypot(loop[:, 0], loop[:, 1])
    rows = [loop]
    if spherical:
        rho = float(np.linalg.norm(ring))
        polar, last = np.arctan2(radius, loop[:, 2]), float(np.arctan2(*ring))
        count = int(np.clip(np.ceil(np.abs(polar - last).max() * np.sqrt(rho / (8 * tolerance))), 2, _MOST))
        for share in np.arange(1, count) / count:
            delta = polar + share * (last - polar)
            flat = rho * np.sin(delta)
            rows.append(np.stack([flat * np.cos(azimuth), flat * np.sin(azimuth), rho * np.cos(delta)], axis=-1))
    inner = _ring(ring, around)
    points = np.concatenate([*rows, inner])
    n = len(loop)
    cells = [_row_cells(n) + n * index for index in range(len(rows) - 1)]
    cells.append(stitched(azimuth, around) + n * (len(rows) - 1))
    if spherical:
        normals = sign * points / np.linalg.norm(points, axis=-1, keepdims=True)
    else:
        lowest = int(np.argmin(radius))
        way = sign * (ring - np.array([radius[lowest], loop[lowest, 2]]))
        normals = _revolved_normals(way, points)
    return turned_to(Mesh(points, normals, np.concatenate(cells)))


def _row_cells(n: int) -> Indices:
    """Triangles between two closed rows of n points."""
    i = np.arange(n)
    after = (i + 1) % n
    return np.concatenate([np.stack([i, after, n + i], axis=-1), np.stack([after, n + after, n + i], axis=-1)])


# ---- edges ------------------------------------------------------------------------------------------------


def _edges(patches: list[_Patch], azimuths: Floats, rings: list[Floats]) -> tuple[Floats, Indices]:
    """Where two faces meet at an angle: along the teeth, round their ends and round the body."""
    paths = []
    for before, patch in zip([patches[-1], *patches[:-1]], patches, strict=True):
        there = before.normals[-1]
        if before is patches[-1]:
            there = turned(there, -azimuths[1:2])[0]
        if np.any(np.einsum("ij,ij->i", there, patch.normals[0]) < _CREASE):
            paths.append(patch.points[0])
    for end in (0, -1):
        paths += [patch.points[:, end] for patch in patches]
    pitch = np.concatenate(paths)
    one = path_segments(tuple(len(path) for path in paths))
    points = turned(pitch, azimuths).reshape(-1, 3)
    segments = [copied_cells(one, len(pitch), len(azimuths))]
    start = len(points)
    for ring in rings:
        i = np.arange(len(ring))
        segments.append(start + np.stack([i, (i + 1) % len(ring)], axis=-1))
        start += len(ring)
    return np.concatenate([points, *rings]), np.concatenate(segments)
