"""A whole gear as meshes for the eye and for measuring, from the surfaces of its solid; numpy alone.

Every face is evaluated on a grid as fine as a chordal tolerance asks; one pitch is made and turned for the other
teeth. Neighbouring patches share the places of their points, so that all of them together are closed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from gearstudio.results import FaceResult, SolidResult
from gearstudio.theory.chamfer import EndChamfer, end_chamfers
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.profile import profile_of
from gearstudio.theory.section import Profile
from ui.grids import grid_triangles, path_segments, turned
from ui.meshes import Mesh, copied_cells, copies, joined, stitched, turned_to
from ui.solid_patches import Patch, patch_mesh, pitch_patches

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]

FINE, COARSE = 1.5e-4, 1.2e-3
"""Chordal tolerances, of the radius of the gear."""
_MOST = 24
_SAME_PLACE = 1e-7
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
    corners, midpoints : ndarray, shape (k, 3)
        Where edges of the teeth end, and their middles.
    """

    flanks: Mesh
    teeth: Mesh
    body: Mesh
    deviation_um: Floats
    edges: Floats
    segments: Indices
    corners: Floats
    midpoints: Floats

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
    chamfers = end_chamfers(member, result.end_chamfer)
    patches = pitch_patches(result, chamfers, tolerance)
    is_flank = [face.kind == "flank" for face in result.faces]
    meshes = [patch_mesh(patch) for patch in patches]
    flanks = joined([mesh for mesh, flank in zip(meshes, is_flank, strict=True) if flank])
    others = joined([mesh for mesh, flank in zip(meshes, is_flank, strict=True) if not flank])
    body, rings, arcs = _body(result, patches, chamfers, azimuths, tolerance)
    paths = [*_sharp_edges(patches, azimuths), *arcs]
    edges, segments = _edges(paths, azimuths, rings)
    theory = profile_of(member)
    off = [_deviation(theory, f, p.points) for f, p, x in zip(result.faces, patches, is_flank, strict=True) if x]
    deviation = np.tile(np.concatenate(off) if off else np.empty(0), result.teeth)
    marks = _corners(paths, azimuths), turned(np.array([_middle(path) for path in paths]), azimuths).reshape(-1, 3)
    return GearMesh(copies(flanks, azimuths), copies(others, azimuths), body, deviation, edges, segments, *marks)


def _deviation(theory: Profile, face: FaceResult, points: Floats) -> Floats:
    return 1e3 * np.asarray(theory.flank(face.side).deviation(points)).ravel()


# ---- ends and body ----------------------------------------------------------------------------------------


def _body(
    result: SolidResult,
    patches: list[Patch],
    chamfers: Sequence[EndChamfer],
    azimuths: Floats,
    tolerance: float,
) -> tuple[Mesh, list[Floats], list[Floats]]:
    """End faces, chamfers and turned faces; the circles where they meet at an angle; a pitch's arcs below chamfers."""
    outline = result.outline
    step = 2 * np.sqrt(2 * tolerance / max(float(outline[:, 0].max()), tolerance))
    count = result.teeth * int(np.ceil(2 * np.pi / result.teeth / min(step, 0.6)))
    around = 2 * np.pi / count * np.arange(count)
    pitches = {end: np.concatenate([patch.points[:-1, end] for patch in patches]) for end in (-1, 0)}
    made, arcs = [], []
    for chamfer in chamfers:
        end = -chamfer.end
        mesh, place, arc = _chamfer(pitches[end], chamfer)
        pitches[end][place] = arc
        made.append(copies(mesh, azimuths))
        arcs.append(arc)
    heel, toe = (turned(pitches[end], azimuths).reshape(-1, 3) for end in (-1, 0))
    meshes = [*made, _end(heel, outline[0], around, 1.0, result.spherical_ends, tolerance)]
    meshes += [_strip(here, there, around) for here, there in pairwise(outline)]
    meshes.append(_end(toe, outline[-1], around, -1.0, result.spherical_ends, tolerance))
    rings = [_ring(point, around) for point in outline if point[0] > 0]
    return joined(meshes), rings, arcs


def _chamfer(pitch: Floats, chamfer: EndChamfer) -> tuple[Mesh, slice, Floats]:
    """The chamfer of a tooth below a part of its profile (n, 3): that part, and the arc that takes its place."""
    size = float(np.hypot(*np.subtract(chamfer.face, chamfer.foot)))
    cut = np.flatnonzero(chamfer.beyond(pitch) > -1e-4 * size)
    place = slice(int(cut[0]), int(cut[-1]) + 1)
    upper = pitch[place]
    azimuth = np.unwrap(np.arctan2(upper[:, 1], upper[:, 0]))
    arc = _ring(np.array(chamfer.foot), np.linspace(azimuth[0], azimuth[-1], len(upper)))
    arc[[0, -1]] = upper[[0, -1]]
    points = np.concatenate([upper, arc])
    angle = np.arctan2(points[:, 1], points[:, 0])
    n_r, n_z = chamfer.normal
    normals = np.stack([n_r * np.cos(angle), n_r * np.sin(angle), np.full_like(angle, n_z)], axis=-1)
    cells = grid_triangles(2, len(upper))
    corners = points[cells]
    flat = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=-1) == 0
    return turned_to(Mesh(points, normals, cells[~flat])), place, arc


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


def _sharp_edges(patches: list[Patch], azimuths: Floats) -> list[Floats]:
    """Where two faces of a pitch meet at an angle: along the teeth and round their ends."""
    paths = []
    for before, patch in zip([patches[-1], *patches[:-1]], patches, strict=True):
        there = before.normals[-1]
        if before is patches[-1]:
            there = turned(there, -azimuths[1:2])[0]
        if np.any(np.einsum("ij,ij->i", there, patch.normals[0]) < _CREASE):
            paths.append(patch.points[0])
    return [*paths, *(patch.points[:, end] for end in (0, -1) for patch in patches)]


def _edges(paths: list[Floats], azimuths: Floats, rings: list[Floats]) -> tuple[Floats, Indices]:
    """The edges of a pitch for every tooth, and those round the body, as points and segments."""
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


def _corners(paths: list[Floats], azimuths: Floats) -> Floats:
    """Both ends of every path, each place once, for every tooth."""
    ends = np.concatenate([path[[0, -1]] for path in paths])
    size = float(np.abs(ends).max())
    _, first = np.unique(np.round(ends / (_SAME_PLACE * size)), axis=0, return_index=True)
    return turned(ends[np.sort(first)], azimuths).reshape(-1, 3)


def _middle(path: Floats) -> Floats:
    """Half way along a path."""
    along = np.cumsum([0.0, *np.linalg.norm(np.diff(path, axis=0), axis=1)])
    return np.array([np.interp(along[-1] / 2, along, column) for column in path.T])
