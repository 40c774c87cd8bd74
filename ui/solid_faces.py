"""What the face of a gear at a point is called: tooth by tooth as theory names it, the turned body by its places."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.gear_deviation import GearTheory
from gearstudio.theory.place import Place

Floats = NDArray[np.float64]

TOOTHLESS = frozenset({"toe", "heel", "bore", "hub", "shank", "rim", "back face", "front face", "cut face", ""})
"""Faces that belong to no tooth."""
FLANKS = ("concave", "convex")
_LEVEL = 1e-6


def face_name(theory: GearTheory, name: str, point: Floats) -> str:
    """The name of a face of theory, more narrowly at a point (3,) in the gear's own frame [mm]."""
    if name in FLANKS:
        return f"{name} flank"
    if name == "end":
        return _end_name(theory, point)
    return _body_name(theory.outline, point) if name == "body" and theory.outline is not None else name


def _end_name(theory: GearTheory, point: Floats) -> str:
    member = theory.member
    rho = float(np.linalg.norm(point))
    delta = float(np.arctan2(np.hypot(*point[:2]), point[2]))
    place = float(member.end_distance(np.array(rho), np.array(delta)))
    return "toe" if place - member.inner_cone_distance < member.outer_cone_distance - place else "heel"


def _body_name(outline: Floats, point: Floats) -> str:
    """By the nearest side of the outline, which runs from the heel round the body to the toe."""
    flat = np.array([np.hypot(*point[:2]), point[2]])
    start, way = outline[:-1], np.diff(outline, axis=0)
    offset = flat - start
    share = np.einsum("ij,ij->i", offset, way) / np.maximum(np.einsum("ij,ij->i", way, way), 1e-300)
    gap = np.linalg.norm(offset - np.clip(share, 0.0, 1.0)[:, None] * way, axis=1)
    index = int(np.argmin(gap))
    radial, axial = way[index] / max(float(np.linalg.norm(way[index])), 1e-300)
    if abs(axial) < _LEVEL:
        return "back face" if radial < 0 else "front face"
    if abs(radial) > _LEVEL:
        return "toe" if index == len(way) - 1 else "heel"
    if axial < 0:
        return "bore"
    back = float(outline[np.argmin(np.abs(outline[:, 0] - outline[0, 0])), 1])
    if index == 0:
        return "rim"
    return "shank" if start[index, 1] >= back - _LEVEL * abs(back) else "hub"


def on_face(theory: GearTheory, name: str, tooth: int, start: Floats, way: Floats) -> Floats:
    """Where a ray through a point meets a face of theory; the point itself where it does not."""
    size = theory.member.outer_cone_distance
    point, step = start, 1e-6 * size
    for _ in range(4):
        both = theory.to_first(np.stack([point, point + step * way]), tooth)
        here, there = theory.distance(name, both)
        if abs(there - here) < 1e-3 * step:
            return start
        point = point - here * step / (there - here) * way
    return point if np.linalg.norm(point - start) < 1e-2 * size else start


def located(theory: GearTheory, local: Floats, direction: Floats, place: Place) -> tuple[str, int | None, Floats]:
    """Face, tooth (from 1, None where it is of none) and the exact point of a face near a point of a mesh.

    Parameters
    ----------
    theory : GearTheory
    local : ndarray, shape (3,)
        In the gear's own frame [mm].
    direction : ndarray, shape (3,)
        Of the ray, in the frame of the view.
    place : Place
        Of the gear in the view.
    """
    tooth = int(theory.teeth_of(local[None])[0])
    name = theory.names[int(theory.nearest(theory.to_first(local[None], tooth))[0][0])]
    point = on_face(theory, name, tooth, local, direction @ place.matrix)
    face = face_name(theory, name, point)
    if face in TOOTHLESS:
        return face, None, point
    behind = theory.member.pitch / 2 if name == "root" else 0.0
    return face, 1 + int(theory.teeth_of(point[None], behind)[0]), point
