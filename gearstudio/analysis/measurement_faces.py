"""Which faces of any CAD model are flanks of a member, however it is turned about and shifted along its axis."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.measurement_fit import places
from gearstudio.errors import GeometryError
from gearstudio.results import FaceSamples
from gearstudio.theory.cones import MemberGeometry, PairGeometry
from gearstudio.theory.modified import flank_on

Floats = NDArray[np.float64]

_ALIKE = np.cos(np.radians(12.0))
_SLACK = 0.1
_LEAST_SHARE = 0.5
_SEARCHED_POINTS = 1500
_STEP_MODULES = 0.25
_MOST_SHIFTS = 1200
_STAYS = 0.9
_FINER = 9
_CLOSE = np.sin(np.radians(3.0))
_UNITS = ((25.4, "inches"), (1000.0, "metres"), (1e-3, "micrometres"))
_AS_IT_IS = np.eye(3)
_TURNS = {
    "+x": np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]),
    "-x": np.array([[0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]]),
    "+y": np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
    "-y": np.array([[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]]),
    "-z": np.diag([1.0, -1.0, -1.0]),
}
"""Rotations that bring an axis to +z."""


@dataclass(frozen=True)
class FlankFaces:
    """The faces of a model that are flanks.

    Attributes
    ----------
    indices : tuple of int
    shift : float
        About where the apex lies on the axis [mm]: 0, unless the model is shifted farther than a best fit looks.
    """

    indices: tuple[int, ...]
    shift: float


def choose_faces(pair: PairGeometry, member: MemberGeometry, faces: Sequence[FaceSamples]) -> FlankFaces:
    """Faces that lie where a member's flanks may be and look where they look.

    Parameters
    ----------
    pair : PairGeometry
        Of the member, for a better message.
    member : MemberGeometry
    faces : sequence of FaceSamples
        All faces of a model, coarsely.

    Raises
    ------
    GeometryError
        None is a flank of this member, with the reason.
    """
    found = _found(member, faces)
    if not found.indices:
        raise GeometryError(
            f"none of the {len(faces)} faces is a flank of this {member.name}; {_reason(pair, member, faces)}"
        )
    return found


def outward(member: MemberGeometry, sampled: FaceSamples, shift: float) -> FaceSamples:
    """The points of a flank's face that look as its theory does, their normals turned out of the metal."""
    alike, side = _alike(member, sampled, shift)
    chosen = np.abs(alike[side]) > _ALIKE
    sign = np.where(alike[side][chosen].sum() < 0, -1.0, 1.0)
    return FaceSamples(sampled.points[chosen], sign * sampled.normals[chosen], sampled.areas[chosen])


def _found(member: MemberGeometry, faces: Sequence[FaceSamples]) -> FlankFaces:
    shift = _shift(member, faces)
    chosen = [index for index, face in enumerate(faces) if _share(member, face, shift) >= _LEAST_SHARE]
    return FlankFaces(tuple(chosen), shift)


def _share(member: MemberGeometry, face: FaceSamples, shift: float) -> float:
    """Part of a face's area that is like a flank."""
    if not len(face.points):
        return 0.0
    alike, side = _alike(member, face, shift)
    return float(face.areas[np.abs(alike[side]) > _ALIKE].sum() / face.areas.sum())


def _alike(member: MemberGeometry, face: FaceSamples, shift: float) -> tuple[Floats, int]:
    """Cosines between normals and theory's for each side, shape (2, n), 0 beside the flanks; and the better side."""
    alike = np.stack([_cosines(member, side, face, shift) for side in (1, -1)])
    likeness = np.sum((np.abs(alike) > _ALIKE) * np.abs(alike) * face.areas, axis=1)
    return alike, int(np.argmax(likeness))


def _cosines(member: MemberGeometry, side: int, face: FaceSamples, shift: float) -> Floats:
    """Cosine between each normal and the flank's at this place, wherever about the axis it is; 0 beside the flanks."""
    flank, points = flank_on(member, side), face.points - np.array([0.0, 0.0, shift])
    with np.errstate(all="ignore"):
        along, across = places(member, points)
        near = (np.abs(along - 0.5) <= 0.5 + _SLACK) & (across >= 0) & (across <= 1 + _SLACK)
    found = np.zeros(len(points))
    if np.any(near):
        rho, delta, phi = flank.locate(points[near])
        base = flank.member.base_angle
        above = np.clip(delta, base, np.pi - base)
        normals = flank.normals_at(*flank.natural_at(rho, above))
        turn = phi - flank.azimuth(rho, above)
        c, s = np.cos(turn), np.sin(turn)
        turned = np.stack(
            [c * normals[:, 0] - s * normals[:, 1], s * normals[:, 0] + c * normals[:, 1], normals[:, 2]], axis=-1
        )
        found[near] = np.sum(turned * face.normals[near], axis=-1)
    return found


def _shift(member: MemberGeometry, faces: Sequence[FaceSamples]) -> float:
    """Where along the axis most of the model's area is like flanks; 0 where that is about as good [mm]."""
    whole = FaceSamples(
        *(np.concatenate([getattr(face, name) for face in faces]) for name in ("points", "normals", "areas"))
    )
    every = max(1, len(whole.points) // _SEARCHED_POINTS)
    some = FaceSamples(whole.points[::every], whole.normals[::every], whole.areas[::every])
    height = whole.points[:, 2]
    low, high = (member.inner_cone_distance * np.cos(member.tip_angle), member.outer_cone_distance)
    first, last = height.min() - high, height.max() - low
    count = min(_MOST_SHIFTS, int(np.ceil((last - first) / (_STEP_MODULES * member.module))) + 1)
    step = (last - first) / max(count - 1, 1)
    best, area = _best_shift(member, some, np.linspace(first, last, count))
    best, area = _best_shift(member, some, best + step * np.linspace(-1.0, 1.0, _FINER))
    return 0.0 if _like_area(member, some, 0.0) >= _STAYS * area else best


def _best_shift(member: MemberGeometry, some: FaceSamples, shifts: Floats) -> tuple[float, float]:
    areas = [_like_area(member, some, shift) for shift in shifts]
    best = int(np.argmax(areas))
    return float(shifts[best]), areas[best]


def _like_area(member: MemberGeometry, some: FaceSamples, shift: float) -> float:
    """Area that is like flanks, the closer the more of it."""
    cosines = np.abs([_cosines(member, side, some, shift) for side in (1, -1)]).max(axis=0)
    return float(np.sum(some.areas * np.exp((np.minimum(cosines, 1.0) ** 2 - 1) / _CLOSE**2)))


def _reason(pair: PairGeometry, member: MemberGeometry, faces: Sequence[FaceSamples]) -> str:
    """The likeliest reason: what makes most of the model's area like flanks."""
    mate = pair.wheel if member is pair.pinion else pair.pinion
    guesses = [(f"some are flanks of the {mate.name}", mate, 1.0, _AS_IT_IS)]
    guesses += [
        (f"some are in {unit}: give the file the right unit", member, factor, _AS_IT_IS) for factor, unit in _UNITS
    ]
    guesses += [("some are flanks of a gear of the other hand", member, 1.0, np.diag([1.0, -1.0, 1.0]))]
    guesses += [
        (f"the gear's axis lies along {axis}, turn it to +z", member, 1.0, turn) for axis, turn in _TURNS.items()
    ]
    areas = [_found_area(tried, _seen(faces, factor, turn)) for _, tried, factor, turn in guesses]
    best = int(np.argmax(areas))
    return guesses[best][0] if areas[best] > 0 else "it is a model of another gear, or its axis is not the z axis"


def _seen(faces: Sequence[FaceSamples], factor: float, turn: Floats) -> list[FaceSamples]:
    """The model enlarged and turned; the areas stay as they are."""
    return [replace(face, points=factor * face.points @ turn.T, normals=face.normals @ turn.T) for face in faces]


def _found_area(member: MemberGeometry, faces: Sequence[FaceSamples]) -> float:
    return float(sum(faces[index].areas.sum() for index in _found(member, faces).indices))
