"""Best fit of measured points to a gear by turning about and shifting along its axis."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import Flank
from gearstudio.theory.involute import roll_arc
from gearstudio.theory.modified import flank_on

Floats = NDArray[np.float64]
Ints = NDArray[np.int_]

_COARSE_POINTS = 1500
_ROUGH_POINTS = 20_000
_COARSE_TURNS = 96
_COARSE_SHIFTS = np.linspace(-0.5, 0.5, 21)
_ROUNDS = 12
_CONVERGED = 1e-9  # of the last step; what is left is its square
_WORST_CONDITION = 1e9
_BLOCK = 50_000


@dataclass(frozen=True)
class Pose:
    """How the measured part lies: turned about the axis [rad], then shifted along it [mm]."""

    turn: float = 0.0
    shift: float = 0.0

    def undo(self, points: Floats) -> Floats:
        """Points in the gear's own frame, shape (n, 3)."""
        c, s = np.cos(self.turn), np.sin(self.turn)
        x, y = points[:, 0], points[:, 1]
        return np.stack([c * x + s * y, c * y - s * x, points[:, 2] - self.shift], axis=-1)


@dataclass(frozen=True)
class Assignment:
    """Where each point belongs; arrays of shape (n,).

    Attributes
    ----------
    side : ndarray of int
        +1 or -1.
    tooth : ndarray of int
        0 for the tooth at azimuth 0, counted with growing azimuth.
    """

    side: Ints
    tooth: Ints


def turned_back(member: MemberGeometry, points: Floats, tooth: Ints) -> Floats:
    """Points brought to the tooth at azimuth 0, shape (n, 3)."""
    angle = tooth * member.pitch
    c, s = np.cos(angle), np.sin(angle)
    x, y = points[:, 0], points[:, 1]
    return np.stack([c * x + s * y, c * y - s * x, points[:, 2]], axis=-1)


def azimuth_lever(flank: Flank, points: Floats) -> tuple[Floats, Floats]:
    """Azimuth of points beyond the flank of the tooth at 0 [rad], and normal distance per azimuth [mm/rad], (n,)."""
    m = flank.member
    rho, delta, phi = flank.locate(points)
    above = np.clip(delta, m.base_angle, np.pi - m.base_angle)
    return phi - flank.azimuth(rho, above), flank.lever(rho, delta)


def assign(member: MemberGeometry, points: Floats, facing: Ints | None = None) -> Assignment:
    """Tooth and flank of points in the gear's frame: the nearest, or the nearest of the side that they face."""
    sides, distances, teeth = (1, -1), [], []
    for side in sides:
        angle, lever = azimuth_lever(flank_on(member, side), points)
        tooth = np.rint(angle / member.pitch)
        distance = np.abs(angle - tooth * member.pitch) * lever
        if facing is not None:
            distance = np.where(facing == side, distance, np.inf)
        distances.append(distance)
        teeth.append(tooth.astype(int) % member.teeth)
    first = distances[0] <= distances[1]
    return Assignment(np.where(first, 1, -1), np.where(first, teeth[0], teeth[1]))


def deviations(member: MemberGeometry, points: Floats, assigned: Assignment) -> Floats:
    """Signed normal distance of points in the gear's frame from the flank that each belongs to [mm], (n,)."""
    error = np.empty(len(points))
    for start in range(0, len(points), _BLOCK):
        block = slice(start, start + _BLOCK)
        at_zero = turned_back(member, points[block], assigned.tooth[block])
        side = assigned.side[block]
        for one in (1, -1):
            chosen = np.flatnonzero(side == one)
            if chosen.size:
                error[start + chosen] = flank_on(member, one).deviation(at_zero[chosen])
    return error


def normals_at(member: MemberGeometry, points: Floats, assigned: Assignment) -> Floats:
    """Normals out of the metal of the flanks below points in the gear's frame, shape (n, 3)."""
    at_zero = turned_back(member, points, assigned.tooth)
    normals = np.empty_like(points)
    for side in (1, -1):
        chosen = assigned.side == side
        flank = flank_on(member, side)
        rho, delta, _ = flank.locate(at_zero[chosen])
        psi = roll_arc(np.clip(delta, member.base_angle, np.pi - member.base_angle), member.base_angle)
        normals[chosen] = flank.normals_at(psi, rho)
    return turned_back(member, normals, -assigned.tooth)


def rigid_columns(points: Floats, normals: Floats) -> Floats:
    """How the deviation changes with the pose's turn and shift, shape (n, 2)."""
    about = normals[:, 1] * points[:, 0] - normals[:, 0] * points[:, 1]
    return np.stack([-about, -normals[:, 2]], axis=-1)


def places(member: MemberGeometry, points: Floats) -> tuple[Floats, Floats]:
    """Place along the face (0 toe, 1 heel) and along the profile (0 root, 1 tip, by polar angle), (n,) each."""
    flank = flank_on(member, 1)
    rho, delta, _ = flank.locate(points)
    face = member.face_share(member.end_distance(rho, delta))
    low, high = flank.limits(face)
    return np.asarray(face), np.asarray((delta - low) / (high - low))


def fit_pose(
    member: MemberGeometry,
    points: Floats,
    facing: Ints | None,
    free: tuple[bool, bool],
    report: Callable[[float], None] | None = None,
) -> tuple[Pose, Ints | None]:
    """The pose that leaves the least squares of deviations.

    Parameters
    ----------
    member : MemberGeometry
    points : ndarray, shape (n, 3)
        As measured.
    facing : ndarray of int, shape (n,), or None
        Sign of the normals about the axis: the side, or its opposite where the normals point into the metal.
    free : (bool, bool)
        Whether turn and shift are to be found; 0 otherwise.
    report : callable, optional
        Told the part of the work done when there are many points.

    Returns
    -------
    pose : Pose
        Its turn is within half a pitch.
    side : ndarray or None
        `facing`, reversed where that fits.

    Raises
    ------
    GeometryError
        The points do not determine what is free.
    """
    pose, facing = _coarse(member, points, facing, free)
    if any(free):
        every = max(1, len(points) // _ROUGH_POINTS)
        some, seen = points[::every], None if facing is None else facing[::every]
        pose = _refined(member, some, seen, free, pose, lambda fraction: None)
        if every > 1:
            pose = _refined(member, points, facing, free, pose, report or (lambda fraction: None))
    if free[0]:
        half = member.pitch / 2
        pose = replace(pose, turn=float((pose.turn + half) % member.pitch - half))
    return pose, facing


def _refined(
    member: MemberGeometry,
    points: Floats,
    facing: Ints | None,
    free: tuple[bool, bool],
    pose: Pose,
    report: Callable[[float], None],
) -> Pose:
    """The pose improved by Gauss and Newton's rule until it stands still."""
    chosen = list(np.flatnonzero(free))
    for number in range(_ROUNDS):
        total, right = np.zeros((2, 2)), np.zeros(2)
        for start in range(0, len(points), _BLOCK):
            own = pose.undo(points[start : start + _BLOCK])
            found = assign(member, own, None if facing is None else facing[start : start + _BLOCK])
            columns = rigid_columns(own, normals_at(member, own, found))
            total += columns.T @ columns
            right += columns.T @ deviations(member, own, found)
            report(1 - 0.5**number * (1 - min(1.0, (start + _BLOCK) / len(points)) / 2))
        part = total[np.ix_(chosen, chosen)]
        size = np.sqrt(np.diag(part))
        if np.any(size <= 0) or np.linalg.cond(part / np.outer(size, size)) > _WORST_CONDITION:
            raise GeometryError(
                "the points do not tell turning and shifting apart; measure more of the flanks or fix one of the two"
            )
        step = np.zeros(2)
        step[chosen] = -np.linalg.solve(part / np.outer(size, size), right[chosen] / size) / size
        pose = Pose(pose.turn + float(step[0]), pose.shift + float(step[1]))
        if abs(step[0]) * member.outer_cone_distance + abs(step[1]) < _CONVERGED * member.outer_cone_distance:
            break
    return pose


def _coarse(
    member: MemberGeometry, points: Floats, facing: Ints | None, free: tuple[bool, bool]
) -> tuple[Pose, Ints | None]:
    """The best of many poses on some of the points."""
    every = max(1, len(points) // _COARSE_POINTS)
    some, seen = points[::every], None if facing is None else facing[::every]
    turns = np.arange(_COARSE_TURNS) * (member.pitch / _COARSE_TURNS) if free[0] else np.zeros(1)
    best, pose, sign = np.inf, Pose(), 1
    for shift in _COARSE_SHIFTS * member.module if free[1] else np.zeros(1):
        own = Pose(0.0, float(shift)).undo(some)
        found = [azimuth_lever(flank_on(member, side), own) for side in (1, -1)]
        distance = np.stack([_to_tooth(member, angle - turns[:, None]) * lever for angle, lever in found])
        for orientation in (1,) if seen is None else (1, -1):
            near = distance.min(axis=0) if seen is None else np.where(orientation * seen > 0, *distance)
            cost = np.minimum(near, 0.25 * member.module).mean(axis=1)
            lowest = int(np.argmin(cost))
            if cost[lowest] < best:
                best, pose, sign = float(cost[lowest]), Pose(float(turns[lowest]), float(shift)), orientation
    return pose, None if facing is None else facing * sign


def _to_tooth(member: MemberGeometry, angle: Floats) -> Floats:
    """Distance of an azimuth from the nearest multiple of the pitch [rad]."""
    return np.asarray(np.abs(angle - np.rint(angle / member.pitch) * member.pitch))
