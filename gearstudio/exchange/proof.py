"""What was read from an exported file against theory, face by face; numpy alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.gear_deviation import GearTheory
from gearstudio.checks import FaceCheck
from gearstudio.methods.tooth import Tooth
from gearstudio.results import Mesh
from gearstudio.theory.place import Place

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

FACE_POINTS = 9
"""Points along each parameter of a face that are held against theory."""
_OWN_POINTS = 25
_PROBES = 16
_MOST_TRIANGLES = 20_000
_ROUNDING = 3e-7
_ALLOWANCE = 1.02
_NO_TOOTH = ("end", "body")


@dataclass(frozen=True)
class Wanted:
    """A member as a file should hold it.

    Attributes
    ----------
    name : str
    theory : GearTheory
    place : Place
        Where it stands in the file.
    limits_um : mapping of face name to float
        Farthest that each kind of face may lie from theory: as its surfaces do before they are written.
    single : bool
        One tooth, not a gear.
    """

    name: str
    theory: GearTheory
    place: Place
    limits_um: Mapping[str, float]
    single: bool = False

    def limit(self, face: str) -> float:
        """For a face [µm]."""
        return self.limits_um.get(face, max(self.limits_um.values()))


def wanted(tooth: Tooth, outline: Floats | None, place: Place, tolerance_um: float, single: bool = False) -> Wanted:
    """What to expect of a member: each kind of face may lie as far from theory as the tooth's own surfaces do.

    Parameters
    ----------
    tooth : Tooth
    outline : ndarray, shape (n, 2), or None
        Of the turned body [mm].
    place : Place
    tolerance_um : float
        What every face is allowed at least.
    """
    theory = GearTheory(tooth.member, tooth.profile, outline, tooth.chamfers)
    points = np.stack([f.surface.uniform_grid(_OWN_POINTS, _OWN_POINTS).reshape(-1, 3) for f in tooth.faces])
    rounding = 1e3 * _ROUNDING * tooth.member.outer_cone_distance
    limits = {name: tolerance_um + rounding for name in theory.names}
    for face, index in zip(points, theory.names_of(points), strict=True):
        name = theory.names[index]
        own = 1e3 * float(np.abs(theory.distance(name, face)).max())
        limits[name] = max(limits[name], _ALLOWANCE * own + rounding)
    return Wanted(tooth.member.name, theory, place, limits, single)


def check_faces(samples: Sequence[Floats], part: Wanted) -> tuple[FaceCheck, ...]:
    """Every face of a solid against the face of theory that it lies nearest to.

    Parameters
    ----------
    samples : sequence of ndarray, shape (n, 3)
        Points of each face as they stand in the file [mm].
    part : Wanted
    """
    placed = [part.place.back(points) for points in samples if len(points)]
    if not placed:
        return ()
    theory = part.theory
    middles = np.stack([points[len(points) // 2] for points in placed])
    probes = np.stack([points[np.linspace(0, len(points) - 1, _PROBES).astype(np.int64)] for points in placed])
    teeth = theory.teeth_of(middles)
    names = theory.names_of(theory.to_first(probes, teeth[:, None]))
    behind = theory.teeth_of(middles, theory.member.pitch / 2)
    found: list[FaceCheck] = []
    for points, tooth, after, index in zip(placed, teeth.tolist(), behind.tolist(), names.tolist(), strict=True):
        name = theory.names[index]
        largest = 1e3 * float(np.abs(theory.distance(name, theory.to_first(points, tooth))).max())
        number = 0 if name in _NO_TOOTH or part.single else 1 + (after if name == "root" else tooth)
        found.append(FaceCheck(part.name, name, number, largest, part.limit(name)))
    return tuple(sorted(found, key=lambda face: (face.tooth == 0, face.tooth, face.name)))


def check_mesh(mesh: Mesh, part: Wanted) -> tuple[tuple[FaceCheck, ...], float]:
    """Every corner of a mesh against theory, by tooth and face, and how far middles of triangles lie from it [µm].

    Of more than 20 000 triangles so many are looked at, evenly spread.
    """
    points = part.place.back(mesh.points)
    theory = part.theory
    teeth, faces, far = _nearest(theory, points)
    count = len(theory.names)
    largest = np.full(theory.member.teeth * count, -1.0)
    np.maximum.at(largest, teeth * count + faces, 1e3 * far)
    worst: dict[tuple[str, int], float] = {}
    for place in np.flatnonzero(largest >= 0).tolist():
        tooth, index = divmod(place, count)
        name = theory.names[index]
        key = name, 0 if name in _NO_TOOTH or part.single else tooth + 1
        worst[key] = max(worst.get(key, 0.0), float(largest[place]))
    found = tuple(FaceCheck(part.name, name, tooth, um, part.limit(name)) for (name, tooth), um in worst.items())
    return found, _chord_um(theory, points, mesh.triangles)


def _chord_um(theory: GearTheory, points: Floats, triangles: Ints) -> float:
    step = max(len(triangles) // _MOST_TRIANGLES, 1)
    corners = points[triangles[::step]]
    middles = [corners.mean(axis=1), *((corners[:, k] + corners[:, k - 1]) / 2 for k in range(3))]
    return 1e3 * float(_nearest(theory, np.concatenate(middles))[2].max(initial=0.0))


def _nearest(theory: GearTheory, points: Floats) -> tuple[Ints, Ints, Floats]:
    """Tooth, face and distance [mm] of points (n, 3)."""
    teeth = theory.teeth_of(points)
    faces, far = theory.nearest(theory.to_first(points, teeth))
    return teeth, faces, far
