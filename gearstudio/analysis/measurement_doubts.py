"""Measured points that fit badly but pass: which number of the design, if it were another, would explain them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from pydantic import ValidationError

from gearstudio.analysis.measurement_fit import Assignment, Pose, deviations, normals_at, rigid_columns
from gearstudio.design import Design, with_field
from gearstudio.errors import GeometryError, Issue
from gearstudio.theory.cones import MemberGeometry, pair_geometry
from gearstudio.validation import check

Floats = NDArray[np.float64]

_DOUBTED_RMS_MODULES = 0.0007
_DOUBTED_RMS_MM = 0.003
_BAD_RMS_MODULES = 0.004
_BAD_RMS_MM = 0.01
"""Parts as bad as this are seldom made; an angle that is off by less is an error of making, and told as that."""
_EXPLAINED = 0.3
_LEAST_UM = 0.01
_ROUNDS = 5
_SETTLED = 1e-6
_LOOKED_AT = 400


@dataclass(frozen=True)
class _Number:
    """A number of the design that points may contradict: where it is, its step for a slope, how it is said."""

    field: str
    step: Callable[[float], float]
    an_error_of_making: bool
    words: Callable[[float], str]


_NUMBERS = (
    _Number("lengthwise.cutter_radius", lambda r: 1e-3 * r, False, lambda r: f"a cutter radius of {r:.5g} mm"),
    _Number("tooth.profile_shift", lambda _x: 1e-3, False, lambda x: f"a profile shift of {x:.3g}"),
    _Number("lengthwise.spiral_angle_deg", lambda _b: 0.01, True, lambda b: f"a spiral angle of {b:.5g}°"),
    _Number("pair.pressure_angle_deg", lambda _a: 0.01, True, lambda a: f"a pressure angle of {a:.4g}°"),
)


def doubts(
    member: MemberGeometry, points: Floats, assigned: Assignment, error: Floats, free: tuple[bool, bool], design: Design
) -> tuple[Issue, ...]:
    """Warnings that points may not be of this gear; none where they fit well.

    Parameters
    ----------
    member : MemberGeometry
    points : ndarray, shape (n, 3)
        In the gear's frame, after the best fit [mm].
    assigned : Assignment
        Tooth and side of each.
    error : ndarray, shape (n,)
        Their deviations [mm].
    free : (bool, bool)
        Whether the best fit was free to turn and to shift.
    design : Design
        Of the pair. One number of it after the other is fitted to the points too.
    """
    rms = float(np.sqrt(np.mean(error**2)))
    if rms <= _DOUBTED_RMS_MODULES * member.module + _DOUBTED_RMS_MM:
        return ()
    bad = rms > _BAD_RMS_MODULES * member.module + _BAD_RMS_MM
    number, words = _likeliest(member, points, assigned, rms, free, design)
    if number is not None and (bad or not number.an_error_of_making):
        text = (
            f"the points fit this {member.name} badly: {1e3 * rms:.3g} µm rms are left after the best fit; {words}. "
            "Check that the part is of this design, or give the design the value that it was made with"
        )
        return (Issue("other_gear_likely", number.field, text, "warning"),)
    if not bad:
        return ()
    text = (
        f"the points fit this {member.name} badly: {1e3 * rms:.3g} µm rms are left after the best fit, and no single "
        "number of the design explains them. Check that the part is of this design, and all points of its flanks"
    )
    return (Issue("fits_badly", "", text, "warning"),)


def explanation(
    member: MemberGeometry, points: Floats, assigned: Assignment, error: Floats, free: tuple[bool, bool], design: Design
) -> str:
    """The number of the design that explains the deviations, in words; empty where none does."""
    rms = float(np.sqrt(np.mean(error**2)))
    return _likeliest(member, points, assigned, rms, free, design)[1]


def _likeliest(
    member: MemberGeometry, points: Floats, assigned: Assignment, rms: float, free: tuple[bool, bool], design: Design
) -> tuple[_Number | None, str]:
    every = max(1, len(points) // _LOOKED_AT)
    some = Assignment(assigned.side[::every], assigned.tooth[::every])
    found = list(_explanations(member, points[::every], some, free, design))
    left, number, value = min(found, key=lambda found: found[0], default=(np.inf, _NUMBERS[0], 0.0))
    if left >= _EXPLAINED * rms:
        return None, ""
    given = number.words(_value(design, number.field))
    left_um = f"{1e3 * left:.2g}" if 1e3 * left >= _LEAST_UM else "0.00"
    return number, f"with {number.words(value)} instead of {given} it would be {left_um} µm"


def _explanations(
    member: MemberGeometry, points: Floats, assigned: Assignment, free: tuple[bool, bool], design: Design
) -> Iterator[tuple[float, _Number, float]]:
    """What each number, fitted together with the pose, would leave (rms, mm), and its value."""
    for number in _NUMBERS:
        if number.field == "lengthwise.cutter_radius" and design.lengthwise.curve != "circular_arc":
            continue
        fitted = _fitted(member, points, assigned, free, design, number)
        if fitted is not None:
            yield fitted[0], number, fitted[1]


def _fitted(
    member: MemberGeometry,
    points: Floats,
    assigned: Assignment,
    free: tuple[bool, bool],
    design: Design,
    number: _Number,
) -> tuple[float, float] | None:
    """Least rms [mm] and the number's value by Gauss and Newton's rule; None where no gear can be made on the way."""
    value, pose = _value(design, number.field), Pose()
    here = member
    for _ in range(_ROUNDS):
        own = pose.undo(points)
        error = deviations(here, own, assigned)
        step = number.step(value)
        beside = _made(design, number.field, value + step, member.name)
        if beside is None:
            return None
        slope = (deviations(beside, own, assigned) - error) / step
        rigid = rigid_columns(own, normals_at(here, own, assigned))[:, np.flatnonzero(free)]
        columns = np.column_stack([rigid, slope])
        size = np.linalg.norm(columns, axis=0)
        if np.any(size == 0):
            return None
        change = -np.linalg.lstsq(columns / size, error, rcond=None)[0] / size
        moved = np.zeros(2)
        moved[np.flatnonzero(free)] = change[:-1]
        pose, value = Pose(pose.turn + float(moved[0]), pose.shift + float(moved[1])), value + float(change[-1])
        made = _made(design, number.field, value, member.name)
        if made is None:
            return None
        here = made
        if abs(change[-1]) <= _SETTLED * step:
            break
    return float(np.sqrt(np.mean(deviations(here, pose.undo(points), assigned) ** 2))), value


def _value(design: Design, field: str) -> float:
    table, _, key = field.partition(".")
    return float(getattr(getattr(design, table), key))


def _made(design: Design, field: str, value: float, member: str) -> MemberGeometry | None:
    try:
        tried = with_field(design, field, value)
        if any(issue.severity == "error" for issue in check(tried, 0.0)):
            return None
        return pair_geometry(tried).member(member)
    except (ValidationError, GeometryError):
        return None
