"""Measured points against the theory: which tooth and flank, best fit, deviations, errors."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.deviation import statistics
from gearstudio.analysis.measurement_checks import Fitted, beside_flank, check_fit, check_size, share_beside
from gearstudio.analysis.measurement_doubts import doubts, explanation
from gearstudio.analysis.measurement_errors import FormErrors, PitchErrors, form_errors, pitch_errors
from gearstudio.analysis.measurement_fit import (
    Assignment,
    Pose,
    assign,
    deviations,
    fit_pose,
    places,
)
from gearstudio.design import Design
from gearstudio.errors import GeometryError, Issue
from gearstudio.results import Statistics
from gearstudio.theory.cones import MemberGeometry, PairGeometry
from gearstudio.theory.flank import FLANKS, Flank, FlankName
from gearstudio.theory.modified import flank_of

Floats = NDArray[np.float64]
Ints = NDArray[np.int_]
Report = Callable[[str, float], None]

_MOST_MOVED = 0.002
_LOOKED_AT = 2000
_SHIFTS = np.linspace(-0.5, 0.5, 41)


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
    warnings : tuple of Issue
        Doubts whether the points are of this gear.
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
    warnings: tuple[Issue, ...] = ()

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
    design: Design | None = None,
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
    design : Design, optional
        Of the pair; with it, points that fit a similar gear much better than this one are told apart from a part
        with errors, and doubts are told.
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
    check_size(pair, member, points)
    told("best fit", 0.2)
    facing = None if normals is None else _facing(points, normals)
    near, pose, facing = _placed(member, points, facing, (turn, shift), lambda p: told("best fit", 0.2 + 0.4 * p))
    beside, points = int(np.count_nonzero(~near)), points[near]
    own = pose.undo(points)
    assigned = assign(member, own, facing)
    told("deviations", 0.6)
    error = deviations(member, own, assigned)
    check_fit(
        pair, member, points, Fitted((turn, shift), float(np.sqrt(np.mean(error**2)))), design,
        lambda: "" if design is None else explanation(member, own, assigned, error, (turn, shift), design),
    )  # fmt: skip
    told("errors", 0.75)
    found = () if design is None else doubts(member, own, assigned, error, (turn, shift), design)
    face, profile = places(member, own)
    return MeasurementResult(
        member_name, member.hand, points + start, error * 1e3, assigned.side, assigned.tooth, face, profile,
        replace(pose, shift=pose.shift + float(start[2])),
        statistics([error * 1e3]), beside,
        {name: pitch_errors(flank, own, error, assigned) for name, flank in _measured(member, assigned)},
        form_errors(member, own, assigned, (turn, shift)),
        found,
    )  # fmt: skip


def _start(member: MemberGeometry, points: Floats, near: float) -> float:
    """About where the apex lies on the axis [mm]: the given place, unless more points are among the teeth from another.

    Teeth may be so thin, or so short, that a shift within the reach of a best fit takes points out of them.
    """
    some = points[:: max(1, len(points) // _LOOKED_AT)]
    shifts = near + _SHIFTS[np.argsort(np.abs(_SHIFTS), kind="stable")] * member.module
    shares = [share_beside(member, some - np.array([0.0, 0.0, shift])) for shift in shifts]
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
    near = beside_flank(member, points) <= 0
    pose, side = fit_pose(member, points[near], None if facing is None else facing[near], free, report)
    settled = beside_flank(member, pose.undo(points)) <= 0
    if np.mean(settled != near) > _MOST_MOVED and np.count_nonzero(settled) > np.count_nonzero(near):
        near = settled
        pose, side = fit_pose(member, points[near], None if facing is None else facing[near], free, report)
    return near, pose, side


def _measured(member: MemberGeometry, assigned: Assignment) -> list[tuple[FlankName, Flank]]:
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
