"""Measuring between two points of solids: what is picked, and what lies between; numpy alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.place import Place
from ui.layers import Layer
from ui.picking import Hit, first_hit
from ui.section import Plane

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Picked:
    """A point of a solid in the frame of the view, and in the gear's own.

    Attributes
    ----------
    member : str
    point, local : ndarray, shape (3,)
        [mm].
    normal : ndarray, shape (3,), optional
        Out of the metal, in the gear's own frame; of a cut face, that of the plane; None where faces meet.
    hit : Hit, optional
        The triangle, in the frame that the layers were made in; None on a cut face.
    """

    member: str
    point: Floats
    local: Floats
    normal: Floats | None
    hit: Hit | None = None


@dataclass(frozen=True)
class Frame:
    """How a member stands in the view: what its layers were placed by, and how it has moved since."""

    base: Place
    turn: Place


@dataclass(frozen=True)
class Measure:
    """Between two points [mm, degrees]; radial, axial and azimuth only for two points of one gear."""

    distance: float
    across: tuple[float, float, float]
    radial: float | None
    axial: float | None
    azimuth: float | None
    normals: float | None


def measure(one: Picked, other: Picked) -> Measure:
    """What lies between two points."""
    across = other.point - one.point
    x, y, z = (float(value) for value in across)
    distance = float(np.linalg.norm(across))
    if one.member != other.member:
        return Measure(distance, (x, y, z), None, None, None, None)
    radii = [float(np.hypot(*p.local[:2])) for p in (one, other)]
    azimuths = [float(np.arctan2(p.local[1], p.local[0])) for p in (one, other)]
    turn = float(np.angle(np.exp(1j * (azimuths[1] - azimuths[0]))))
    axial, between = float(other.local[2] - one.local[2]), None
    if one.normal is not None and other.normal is not None:
        between = float(np.degrees(np.arccos(np.clip(one.normal @ other.normal, -1.0, 1.0))))
    return Measure(distance, (x, y, z), radii[1] - radii[0], axial, float(np.degrees(turn)), between)


def pick(
    layers: Sequence[Layer],
    frames: Mapping[str, Frame],
    ray: tuple[Floats, Floats],
    plane: Plane | None = None,
) -> Picked | None:
    """The point of a solid under the pointer, also on a cut face.

    Parameters
    ----------
    layers : sequence of Layer
        Surfaces of bodies, as placed before anything turned.
    frames : mapping
        By body.
    ray : (start, direction)
        In the frame of the view.
    plane : Plane, optional
        What lies beyond is not there.
    """
    start, direction = ray
    entered = None
    if plane is not None and plane.beyond(start) > 0:
        closing = -float(direction @ plane.normal)
        if closing <= 0:
            return None
        entered = start = start + float(plane.beyond(start)) / closing * direction
    best: tuple[float, Picked] | None = None
    for member, frame in frames.items():
        own = tuple(x for x in layers if x.body == member and x.kind == "surface")
        hit = first_hit(own, frame.turn.back(start), direction @ frame.turn.matrix)
        if hit is None or hit.layer.normals is None or (best is not None and hit.distance >= best[0]):
            continue
        normal = frame.turn.matrix @ (hit.weights @ hit.layer.normals[hit.corners])
        point, distance = frame.turn.of(hit.point), hit.distance
        if entered is not None and normal @ direction > 0:  # the ray came through the cut face
            point, normal, distance, hit = entered, plane.normal, 0.0, None  # type: ignore[union-attr]
        elif plane is not None and plane.beyond(point) > 0:
            continue
        whole = frame.turn.after(frame.base)
        own_normal = normal / np.linalg.norm(normal) @ whole.matrix
        best = (distance, Picked(member, point, whole.back(point), own_normal, hit))
    return None if best is None else best[1]
