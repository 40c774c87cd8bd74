"""Measured points against the theory: which tooth and flank, best fit, deviations, errors."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.deviation import statistics
from gearstudio.analysis.measurement_errors import FormErrors, PitchErrors, form_errors, pitch_errors
from gearstudio.analysis.measurement_fit import (
    Assignment,
    Pose,
    assign,
    deviations,
    fit_pose,
    places,
)
from gearstudio.errors import GeometryError
from gearstudio.results import Statistics
from gearstudio.theory.cones import MemberGeometry, PairGeometry
from gearstudio.theory.flank import FLANKS, FlankName, InvoluteFlank
from gearstudio.theory.modified import flank_of, flank_on

Floats = NDArray[np.float64]
Ints = NDArray[np.int_]
Report = Callable[[str, float], None]

_BESIDE_DEPTH = 0.3
_BESIDE_FACE = 0.1
_MOST_BESIDE = 0.2
_MOST_MOVED = 0.002
_LOOKED_AT = 2000
_SHIFTS = np.linspace(-0.5, 0.5, 41)
_WORST_RMS_MODULES = 0.03
_WORST_RMS_MM = 0.02
_UNITS = ((25.4, "inches"), (1000.0, "metres"), (0.001, "micrometres"))


@dataclass(frozen=True)
class MeasuredPoints:
    """Some points as read from a file: shape (n, 3) [mm], with normals of the same shape or none."""

    points: Floats
    normals: Floats | None = None


@dataclass(frozen=True)
class MeasurementResult:
    """Measured points and how far they are from the theoretical flanks.

    Attributes
    ----------
    member : str
    points : ndarray, shape (n, 3)
        As measured, without those that lie beside the teeth [mm].
    deviation_um : ndarray, shape (n,)
        After the best fit, normal, positive where metal is added.
    side, tooth : ndarray of int, shape (n,)
        Tooth 0 is the one at azimuth 0; they count with growing azimuth.
    face_place, profile_place : ndarray, shape (n,)
        0 at the toe, 1 at the heel; 0 at the root (or base cone), 1 at the tip.
    pose : Pose
        The best fit: how the part lay.
    statistics : Statistics
    beside : int
        Points left out because they lie beside the flanks.
    pitch : mapping of flank to PitchErrors
    form : mapping of flank to FormErrors
    """

    member: str
    hand: int
    points: Floats
    deviation_um: Floats
    side: Ints
    tooth: Ints
    face_place: Floats
    profile_place: Floats
    pose: Pose
    statistics: Statistics
    beside: int
    pitch: dict[FlankName, PitchErrors]
    form: dict[FlankName, FormErrors]

    @property
    def flanks(self) -> list[FlankName]:
        """The flank of each point by name."""
        return ["concave" if concave else "convex" for concave in self.side == self.hand]


def measure(
    pair: PairGeometry,
    member_name: str,
    chunks: Iterable[MeasuredPoints],
    *,
    turn: bool = True,
    shift: bool = True,
    start_shift: float = 0.0,
    report: Report | None = None,
) -> MeasurementResult:
    """Compare measured points with a member's theoretical flanks.

    Parameters
    ----------
    pair : PairGeometry
    member_name : {"pinion", "wheel"}
    chunks : iterable of MeasuredPoints
        All with normals or all without; the points in any order.
    turn, shift : bool
        Whether the best fit may turn the part about and shift it along its axis.
    start_shift : float
        About where the part's apex lies on the axis [mm], where that is farther off than a best fit looks.
    report : callable, optional
        Told the stage and the part of the work done.

    Raises
    ------
    GeometryError
        Too few points, points that are not numbers, not in mm, or of another gear, with the reason.
    """
    member = pair.member(member_name)
    told = report or (lambda stage, fraction: None)
    points, normals = _collected(chunks)
    start = np.array([0.0, 0.0, _start(member, points, start_shift) if shift else 0.0])
    points = points - start
    _check_size(pair, member, points)
    told("best fit", 0.2)
    facing = None if normals is None else _facing(points, normals)
    near, pose, facing = _placed(member, points, facing, (turn, shift), lambda p: told("best fit", 0.2 + 0.4 * p))
    beside, points = int(np.count_nonzero(~near)), points[near]
    own = pose.undo(points)
    assigned = assign(member, own, facing)
    told("deviations", 0.6)
    error = deviations(member, own, assigned)
    _check_fit(pair, member, points, float(np.sqrt(np.mean(error**2))))
    told("errors", 0.75)
    face, profile = places(member, own)
    return MeasurementResult(
        member_name, member.hand, points + start, error * 1e3, assigned.side, assigned.tooth, face, profile,
        replace(pose, shift=pose.shift + float(start[2])),
        statistics([error * 1e3]), beside,
        {name: pitch_errors(flank, own, error, assigned) for name, flank in _measured(member, assigned)},
        form_errors(member, own, assigned, (turn, shift)),
    )  # fmt: skip


def _start(member: MemberGeometry, points: Floats, near: float) -> float:
    """About where the apex lies on the axis [mm]: the given place, unless more points are among the teeth from another.

    Teeth may be so thin, or so short, that a shift within the reach of a best fit takes points out of them.
    """
    some = points[:: max(1, len(points) // _LOOKED_AT)]
    shifts = near + _SHIFTS[np.argsort(np.abs(_SHIFTS), kind="stable")] * member.module
    shares = [_share_beside(member, some - np.array([0.0, 0.0, shift])) for shift in shifts]
    return float(shifts[np.argmin(shares)])


def _placed(
    member: MemberGeometry,
    points: Floats,
    facing: Ints | None,
    free: tuple[bool, bool],
    report: Callable[[float], None],
) -> tuple[NDArray[np.bool_], Pose, Ints | None]:
    """Which points are of the teeth, shape (n,), their best fit, and the side that those face.

    Points are judged anew where the best fit has moved many of them into the teeth or out.
    """
    near = _beside_flank(member, points) <= 0
    pose, side = fit_pose(member, points[near], None if facing is None else facing[near], free, report)
    settled = _beside_flank(member, pose.undo(points)) <= 0
    if np.mean(settled != near) > _MOST_MOVED and np.count_nonzero(settled) > np.count_nonzero(near):
        near = settled
        pose, side = fit_pose(member, points[near], None if facing is None else facing[near], free, report)
    return near, pose, side


def _measured(member: MemberGeometry, assigned: Assignment) -> list[tuple[FlankName, InvoluteFlank]]:
    flanks = [(name, flank_of(member, name)) for name in FLANKS]
    return [(name, flank) for name, flank in flanks if np.any(assigned.side == flank.side)]


def _collected(chunks: Iterable[MeasuredPoints]) -> tuple[Floats, Floats | None]:
    parts = list(chunks)
    points = np.concatenate([part.points for part in parts]) if parts else np.empty((0, 3))
    if len(points) < 3:
        raise GeometryError(f"{len(points)} measured points are too few; a best fit takes 3 or more")
    if not np.all(np.isfinite(points)):
        raise GeometryError("a coordinate of the measured points is not a number")
    found = [part.normals for part in parts if part.normals is not None]
    return points, np.concatenate(found) if len(found) == len(parts) else None


def _facing(points: Floats, normals: Floats) -> Ints:
    """+1 where a normal points towards growing azimuth, -1 elsewhere."""
    return np.where(normals[:, 1] * points[:, 0] - normals[:, 0] * points[:, 1] >= 0, 1, -1)


def _beside_flank(member: MemberGeometry, points: Floats) -> Floats:
    """How far points lie outside the room in which a flank may be measured, not positive inside, shape (n,)."""
    face, profile = places(member, points)
    beyond = np.maximum(np.maximum(-face, face - 1) - _BESIDE_FACE, np.maximum(-profile, profile - 1) - _BESIDE_DEPTH)
    return np.where(np.isfinite(beyond), beyond, np.inf)


def _share_beside(member: MemberGeometry, points: Floats) -> float:
    with np.errstate(all="ignore"):
        return float(np.mean(_beside_flank(member, points) > 0))


def _check_size(pair: PairGeometry, member: MemberGeometry, points: Floats) -> None:
    share = _share_beside(member, points)
    if share <= _MOST_BESIDE:
        return
    for factor, unit in _UNITS:
        if _share_beside(member, points * factor) <= _MOST_BESIDE:
            raise GeometryError(
                f"the points look as if they were in {unit}: multiplied by {factor:g} they lie on the "
                f"{member.name}'s teeth; convert them to mm"
            )
    rho, delta, _ = flank_on(member, 1).locate(points)
    angles = np.degrees(np.r_[delta.min(), delta.max(), member.root_angle, member.tip_angle])
    mate = _mate(pair, member)
    hint = f"they fit the {mate.name}" if _share_beside(mate, points) <= _MOST_BESIDE else (
        "they are of another gear, or the origin is not at the apex and z not along the axis"
    )  # fmt: skip
    raise GeometryError(
        f"{share:.0%} of the points lie beside the {member.name}'s teeth: they are {rho.min():.5g} to "
        f"{rho.max():.5g} mm from the apex and at {angles[0]:.4g}° to {angles[1]:.4g}° from the axis, its flanks at "
        f"{member.inner_cone_distance:.5g} to {member.outer_cone_distance:.5g} mm and {angles[2]:.4g}° to "
        f"{angles[3]:.4g}°; {hint}"
    )


def _check_fit(pair: PairGeometry, member: MemberGeometry, points: Floats, rms: float) -> None:
    allowed = _WORST_RMS_MODULES * member.module + _WORST_RMS_MM
    if rms <= allowed:
        return
    hint, mate = "they are of another gear (number of teeth, spiral angle, hand)", _mate(pair, member)
    if _fits(member, points * np.array([1.0, -1.0, 1.0]), allowed):
        hint = "they fit a gear of the other hand"
    elif _share_beside(mate, points) <= _MOST_BESIDE and _fits(mate, points, allowed):
        hint = f"they fit the {mate.name}"
    raise GeometryError(
        f"the points do not lie on this {member.name}'s flanks: {rms:.3g} mm rms are left after the best fit, "
        f"where {allowed:.3g} mm could be a measured deviation; {hint}"
    )


def _mate(pair: PairGeometry, member: MemberGeometry) -> MemberGeometry:
    return pair.wheel if member is pair.pinion else pair.pinion


def _fits(member: MemberGeometry, points: Floats, allowed: float) -> bool:
    some = points[:: max(1, len(points) // 2000)]
    try:
        own = fit_pose(member, some, None, (True, True))[0].undo(some)
    except GeometryError:
        return False
    return bool(np.sqrt(np.mean(deviations(member, own, assign(member, own)) ** 2)) <= allowed)
