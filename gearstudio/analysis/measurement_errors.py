"""Errors that gear people name, read from deviations: of the pitch, of the angles, and crowning."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.measurement_fit import (
    Assignment,
    Pose,
    azimuth_lever,
    deviations,
    normals_at,
    places,
    rigid_columns,
    turned_back,
)
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import FLANKS, Flank, FlankName
from gearstudio.theory.modified import flank_of

Floats = NDArray[np.float64]
Ints = NDArray[np.int_]

_FORMS = 5
_ROUNDS = 2
_SMALLEST = 1e-12
_BLOCK = 50_000


@dataclass(frozen=True)
class PitchErrors:
    """Places of a flank on the teeth that were measured, as arcs of the mean pitch circle [µm].

    Attributes
    ----------
    tooth : ndarray of int, shape (n,)
    index_um : ndarray, shape (n,)
        Error of the place towards growing azimuth, against the mean of all.
    cumulative_um : ndarray, shape (n,)
        The same against the first tooth measured.
    single_um : ndarray, shape (n,)
        Against the tooth before; 0 where that was not measured.
    total_um, largest_single_um : float
        Range of the cumulative errors; largest single error without its sign.
    """

    tooth: Ints
    index_um: Floats
    cumulative_um: Floats
    single_um: Floats
    total_um: float
    largest_single_um: float


@dataclass(frozen=True)
class FormErrors:
    """Shape of a flank, mean of all its teeth, over the whole flank [µm].

    Attributes
    ----------
    spiral_um : float
        Spiral-angle error: metal at the heel more than at the toe.
    pressure_um : float
        Pressure-angle error: metal at the tip more than at the root.
    lengthwise_crown_um, profile_crown_um : float
        Height of the middle above both ends.
    bias_um : float
        Twist: root-toe and tip-heel corners more than the other two.
    spiral_deg : float
        The spiral-angle error as an angle, in the tangent plane at the mean cone distance.
    """

    spiral_um: float
    pressure_um: float
    lengthwise_crown_um: float
    profile_crown_um: float
    bias_um: float
    spiral_deg: float


@dataclass(frozen=True)
class NamedError:
    """An error of a flank by its name; ``of`` reads it from shape and pitch, in the unit: None where there is none."""

    title: str
    of: Callable[[FormErrors, PitchErrors], float | None]
    unit: str = "µm"


NAMED_ERRORS = (
    NamedError("Spiral angle", lambda form, _: form.spiral_um),
    NamedError("Spiral angle, as an angle", lambda form, _: form.spiral_deg, "°"),
    NamedError("Pressure angle", lambda form, _: form.pressure_um),
    NamedError("Lengthwise crown", lambda form, _: form.lengthwise_crown_um),
    NamedError("Profile crown", lambda form, _: form.profile_crown_um),
    NamedError("Bias", lambda form, _: form.bias_um),
    NamedError("Pitch, single", lambda _, pitch: pitch.largest_single_um if len(pitch.tooth) > 1 else None),
    NamedError("Pitch, total", lambda _, pitch: pitch.total_um if len(pitch.tooth) > 1 else None),
)


def pitch_errors(flank: Flank, points: Floats, error: Floats, assigned: Assignment) -> PitchErrors:
    """Pitch errors of one flank.

    Parameters
    ----------
    flank : Flank
    points : ndarray, shape (n, 3)
        In the gear's frame, all of them.
    error : ndarray, shape (n,)
        Deviations [mm].
    assigned : Assignment
    """
    member = flank.member
    chosen = assigned.side == flank.side
    tooth = assigned.tooth[chosen]
    _, lever = azimuth_lever(flank, turned_back(member, points[chosen], tooth))
    angle = flank.side * error[chosen] / lever
    counts = np.bincount(tooth, minlength=member.teeth)
    present = np.flatnonzero(counts)
    index = np.bincount(tooth, weights=angle, minlength=member.teeth)[present] / counts[present]
    index_um = (index - index.mean()) * member.mean_cone_distance * np.sin(member.pitch_angle) * 1e3
    before = np.roll(index_um, 1)
    follows = (present - np.roll(present, 1)) % member.teeth == 1
    single = np.where(follows, index_um - before, 0.0)
    return PitchErrors(
        present, index_um, index_um - index_um[0], single, float(np.ptp(index_um)), float(np.abs(single).max())
    )


def form_errors(
    member: MemberGeometry, points: Floats, assigned: Assignment, fitted: tuple[bool, bool]
) -> dict[FlankName, FormErrors]:
    """Angle errors and crowning of each flank that was measured.

    Parameters
    ----------
    member : MemberGeometry
    points, assigned
        As for `pitch_errors`.
    fitted : (bool, bool)
        Whether turn and shift were found by the best fit. It has then taken a part of the errors along, which is
        found again together with them; what both flanks have in common counts as shift.
    """
    sides = [side for side in (1, -1) if np.any(assigned.side == side)]
    pose, forms = Pose(), np.empty(0)
    for _ in range(_ROUNDS):
        forms, turn, shift = _solved(member, pose.undo(points), assigned, sides, fitted)
        pose = Pose(pose.turn - turn, pose.shift - shift)
    named = {name: flank_of(member, name).side for name in FLANKS}
    return {
        name: _named(member, forms[sides.index(side) * _FORMS :][:_FORMS] * 1e3)
        for name, side in named.items()
        if side in sides
    }


def _solved(
    member: MemberGeometry, points: Floats, assigned: Assignment, sides: list[int], fitted: tuple[bool, bool]
) -> tuple[Floats, float, float]:
    """Coefficients of the shape of each side [mm], and the turn [rad] and shift [mm] that go with them."""
    width = len(sides) * _FORMS + 2
    total, right = np.zeros((width, width)), np.zeros(width)
    for start in range(0, len(points), _BLOCK):
        block = slice(start, start + _BLOCK)
        found = Assignment(assigned.side[block], assigned.tooth[block])
        error, normals = deviations(member, points[block], found), normals_at(member, points[block], found)
        face, profile = places(member, points[block] - error[:, None] * normals)
        along, across = 2 * face - 1, 2 * profile - 1
        shape = np.stack([along, across, along**2, across**2, along * across], axis=-1)
        rigid = rigid_columns(points[block], normals)
        rest = [
            rigid[:, 0] if fitted[0] else found.side.astype(float),
            np.zeros(len(error)) if len(sides) < 2 else rigid[:, 1] if fitted[1] else np.ones(len(error)),
        ]
        table = [np.where((found.side == side)[:, None], shape, 0.0) for side in sides]
        columns = np.concatenate([*table, np.stack(rest, axis=-1)], axis=-1)
        total += columns.T @ columns
        right += columns.T @ error
    size = np.sqrt(np.diag(total))
    size[size == 0] = 1.0
    solution = np.linalg.lstsq(total / np.outer(size, size), right / size, rcond=_SMALLEST)[0] / size
    turn, shift = solution[-2] * fitted[0], solution[-1] * (fitted[1] and len(sides) == 2)
    return solution[:-2], float(turn), float(shift)


def _named(member: MemberGeometry, c: Floats) -> FormErrors:
    slope = 2 * c[0] * 1e-3 / member.face_width
    beta = float(member.lengthwise.spiral_angle(member.mean_cone_distance))
    return FormErrors(
        spiral_um=float(2 * c[0]),
        pressure_um=float(2 * c[1]),
        lengthwise_crown_um=float(-c[2]),
        profile_crown_um=float(-c[3]),
        bias_um=float(2 * c[4]),
        spiral_deg=float(np.degrees(np.arctan(slope * np.cos(beta)))),
    )
