"""Watertight triangles of a gear or a tooth: one tooth sampled once and turned, neighbours sharing points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.errors import GeometryError
from gearstudio.methods.grafts import own_coordinates, placed
from gearstudio.methods.rings import SHARE, TWIST_SHARE, Points, Rings
from gearstudio.methods.tooth import Tooth
from gearstudio.nurbs import NurbsSurface
from gearstudio.results import Mesh
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import name_of
from gearstudio.theory.spread import Spread

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

_FIRST = 8
_FEWEST, _MOST = 2, 400
_FINE = 4
_MOST_TRIANGLES = 6_000_000


def gear_mesh(tooth: Tooth, outline: Floats, tolerance: float, angle: float = np.pi) -> Mesh:
    """Triangles of a whole gear.

    Parameters
    ----------
    tooth : Tooth
    outline : ndarray, shape (n, 2)
        (radius, height) of the body from heel to toe [mm].
    tolerance : float
        Farthest that a triangle may lie from the surface [mm].
    angle : float
        Largest between neighbouring chords [rad].

    Raises
    ------
    GeometryError
        That takes more triangles than any program would read.
    """
    member = tooth.member
    sampled = _Sampled.of(tooth, tolerance, angle)
    maker = Points()
    columns = maker.add(_all_turns(sampled.points, member.teeth))
    placed_points = maker.stacked()
    groups: dict[str, list[Ints]] = {}
    for name, first, last in sampled.faces:
        starts = np.arange(first, last)[None, :] + sampled.columns * np.arange(member.teeth)[:, None]
        groups.setdefault(name, []).append(_quads(columns, starts.ravel(), True, placed_points))
    body: list[Ints] = []
    rings = Rings(member, outline, tolerance, angle, maker)
    for end in (1, 0):
        loop, ladder = _end_ladder(sampled, columns, end, maker)
        body.append(ladder)
        body.append(rings.transition(loop, end))
    body.append(rings.body())
    groups["body"] = body
    return Mesh(maker.stacked(), {name: np.concatenate(parts) for name, parts in groups.items()})


def tooth_mesh(tooth: Tooth, tolerance: float, angle: float = np.pi) -> Mesh:
    """Triangles of a single tooth, closed below along the root cone; see `gear_mesh`."""
    sampled = _Sampled.of(tooth, tolerance, angle, with_root=False)
    maker = Points()
    columns = maker.add(sampled.points)
    groups: dict[str, list[Ints]] = {}
    for name, first, last in sampled.faces:
        groups.setdefault(name, []).append(
            _quads(columns, np.arange(first, last), False, sampled.points.reshape(-1, 3))
        )
    bottoms = []
    for end in (1, 0):
        loop, ladder = _end_ladder(sampled, columns, end, maker)
        groups.setdefault("body", []).append(ladder)
        bottoms.append(loop)
    left, right = sampled.points[0], sampled.points[-1]
    inner = [
        _across(sampled.member, left[k], right[k], sampled.tip_count) for k in range(1, sampled.points.shape[1] - 1)
    ]
    rows = [bottoms[1], *(np.r_[columns[0, k + 1], maker.add(row), columns[-1, k + 1]] for k, row in enumerate(inner))]
    grid = np.stack([*rows, bottoms[0]], axis=1)[::-1]
    groups["body"].append(_quads(grid, np.arange(len(grid) - 1), False, maker.stacked()))
    return Mesh(maker.stacked(), {name: np.concatenate(parts) for name, parts in groups.items()})


@dataclass(frozen=True)
class _Sampled:
    """The faces of one pitch as one grid of points (columns, places); neighbours share a column.

    ``faces`` names runs of columns; ``side_count`` columns climb each side, ``tip_count`` cross the tip.
    """

    member: MemberGeometry
    points: Floats
    faces: tuple[tuple[str, int, int], ...]
    side_count: int
    tip_count: int
    columns: int

    @staticmethod
    def of(tooth: Tooth, tolerance: float, angle: float, with_root: bool = True) -> _Sampled:
        faces = [face for face in tooth.faces if with_root or face.kind != "root"]
        goal = SHARE * tolerance
        along = max(_count(face.surface, 1, goal, angle) for face in faces)
        across = {"tip": _end_count(tooth, goal, angle)}
        for face in faces:
            least = max(across.get(face.kind, 0), _twist(face.surface) / (4 * along * TWIST_SHARE * tolerance))
            across[face.kind] = max(int(np.ceil(least)), _count(face.surface, 0, goal, angle))
        if 2 * along * sum(across[face.kind] for face in faces) * tooth.member.teeth > _MOST_TRIANGLES:
            raise GeometryError(
                f"triangles within {tolerance:.3g} mm and {np.degrees(angle):.3g}° of the {tooth.member.name} would be "
                f"more than {_MOST_TRIANGLES // 1_000_000} million; allow a larger distance or angle"
            )
        spread = [Spread.of(face.surface, tooth.chamfers) for face in faces]
        steps = {face.kind: one.steps(across[face.kind]) for face, one in zip(faces, spread, strict=True)}
        across |= {kind: sum(counts) for kind, counts in steps.items()}
        v = np.linspace(0.0, 1.0, along + 1)
        grids, runs, at = [], [], 0
        for face, one in zip(faces, spread, strict=True):
            n = across[face.kind]
            counts = steps[face.kind] if face.side > 0 else steps[face.kind][::-1]
            grids.append(one.grid(counts, v)[: n if with_root or face is not faces[-1] else None])
            runs.append((_group(face.kind, face.side, tooth.member.hand), at, at + n))
            at += n
        side = sum(n for name, n in across.items() if name in ("fillet", "meridian", "flank"))
        return _Sampled(tooth.member, np.concatenate(grids), tuple(runs), side, across["tip"], at)


def _group(kind: str, side: int, hand: int) -> str:
    return kind if kind != "flank" else name_of(hand, side)


def _count(surface: NurbsSurface, axis: int, goal: float, angle: float) -> int:
    """Even steps along one parameter whose chords keep to a goal, their error falling with the square, and an angle."""
    fine = np.linspace(0.0, 1.0, 2 * _FIRST * _FINE + 1)
    coarse = np.linspace(0.0, 1.0, 9)
    points = surface.grid(fine, coarse) if axis == 0 else np.swapaxes(surface.grid(coarse, fine), 0, 1)
    sagitta = np.linalg.norm(points[1:-1:1] - (points[:-2] + points[2:]) / 2, axis=-1).max()
    steps = (len(fine) - 1) * float(np.sqrt(sagitta / goal)) / 2
    ways = np.diff(points, axis=0)
    ways /= np.maximum(np.linalg.norm(ways, axis=-1, keepdims=True), np.finfo(float).tiny)
    bend = 2 * np.arcsin(np.clip(np.linalg.norm(np.diff(ways, axis=0), axis=-1).max() / 2, 0.0, 1.0))
    return int(np.clip(np.ceil(max(steps, (len(fine) - 1) * bend / angle)), _FEWEST, _MOST))


def _twist(surface: NurbsSurface) -> float:
    """Largest normal part of the mixed derivative [mm]: a cell's diagonals lie a quarter of its share of it away."""
    p = surface.uniform_grid(_FIRST + 1, _FIRST + 1)
    one, other = p[1:, 1:] - p[:-1, :-1], p[1:, :-1] - p[:-1, 1:]
    normal = np.cross(one, other)
    normal /= np.maximum(np.linalg.norm(normal, axis=-1, keepdims=True), np.finfo(float).tiny)
    mixed = p[1:, 1:] - p[1:, :-1] - p[:-1, 1:] + p[:-1, :-1]
    return float(_FIRST**2 * np.abs(np.einsum("ijk,ijk->ij", mixed, normal)).max())


def _end_count(tooth: Tooth, goal: float, angle: float) -> int:
    """Even steps across the foot of the tooth's ends, which are as curved as the circle that they stand on."""
    member, heel = tooth.member, np.array(tooth.member.outer_cone_distance)
    delta, after, before = tooth.profile.across("root", heel)
    radius = float(member.cone_distance(heel, delta) * np.sin(delta))
    step = min(2 * float(np.arccos(1 - min(goal / radius, 0.5))), angle)
    return int(np.clip(np.ceil(float(after + member.pitch - before) / step), _FEWEST, _MOST))


def _all_turns(points: Floats, teeth: int) -> Floats:
    """Points (n, k, 3) of every tooth, shape (teeth n, k, 3)."""
    angles = 2 * np.pi * np.arange(teeth) / teeth
    x = np.cos(angles)[:, None, None] * points[..., 0] - np.sin(angles)[:, None, None] * points[..., 1]
    y = np.sin(angles)[:, None, None] * points[..., 0] + np.cos(angles)[:, None, None] * points[..., 1]
    z = np.broadcast_to(points[..., 2], x.shape)
    return np.stack([x, y, z], axis=-1).reshape(-1, points.shape[1], 3)


def _quads(grid: Ints, starts: Ints, closed: bool = True, points: Floats | None = None) -> Ints:
    """Two triangles for every cell between columns starts and starts + 1 of a grid of indices.

    With their points the cells are cut along the diagonals that are shorter as a whole, which lie nearer to a
    twisted face.
    """
    here, there = grid[starts], grid[(starts + 1) % len(grid) if closed else starts + 1]
    a, b, c, d = here[:, :-1], there[:, :-1], there[:, 1:], here[:, 1:]
    halves = (a, b, c), (a, c, d)
    if points is not None:
        usual, other = (float(np.linalg.norm(points[p] - points[q], axis=-1).sum()) for p, q in ((a, c), (b, d)))
        halves = ((a, b, d), (b, c, d)) if other < usual else halves
    return np.concatenate([np.stack(half, -1).reshape(-1, 3) for half in halves])


def _across(member: MemberGeometry, left: Floats, right: Floats, count: int) -> Floats:
    """Points between two points of an end surface (..., 3), without them, shape (..., count - 1, 3)."""
    own = [own_coordinates(member, points) for points in (left, right)]
    t = np.arange(1, count) / count
    mixed = [a[..., None] + t * (b - a)[..., None] for a, b in zip(*own, strict=True)]
    return placed(member, mixed[0], mixed[1], mixed[2])


def _end_ladder(sampled: _Sampled, columns: Ints, end: int, maker: Points) -> tuple[Ints, Ints]:
    """Triangles of all teeth at toe or heel above the root, and the loop of indices along their lower side."""
    side, tip, pitch = sampled.side_count, sampled.tip_count, sampled.columns
    k = -end
    edge = sampled.points[:, k]
    left, right = edge[: side + 1], edge[side + tip : 2 * side + tip + 1]
    if len(right) == side:  # without a root face the next tooth's first column ends this one
        right = np.vstack([right, _all_turns(edge[:1, None], round(sampled.member.teeth))[1]])
    inner = _across(sampled.member, left[:side], right[::-1][:side], tip)
    teeth = len(columns) // pitch if len(columns) % pitch == 0 else 1
    inner_all = maker.add(_all_turns(inner, teeth).reshape(teeth, side, tip - 1, 3))
    loop, triangles = [], []
    for tooth in range(teeth):
        index = (tooth * pitch + np.arange(pitch + 1)) % len(columns)
        edge_index = columns[index, k]
        rows = np.empty((side + 1, tip + 1), dtype=np.int64)
        rows[:, 0], rows[:, -1] = edge_index[: side + 1], edge_index[side + tip : 2 * side + tip + 1][::-1]
        rows[:side, 1:-1], rows[side] = inner_all[tooth], edge_index[side : side + tip + 1]
        triangles.append(_quads(rows, np.arange(side), closed=False))
        loop += [rows[0, : -1 if teeth > 1 else None], edge_index[2 * side + tip : -1] if teeth > 1 else rows[0, :0]]
    made = np.concatenate(triangles)
    return np.concatenate(loop), made if end else made[:, ::-1]
