"""What a method made of a member, and points of faces: plain records that travel between parts and processes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from gearstudio.nurbs import NurbsSurface

Floats = NDArray[np.float64]

CurveKind = Literal["position", "section", "guide", "u_line", "v_line", "points"]


@dataclass(frozen=True)
class ConstructionCurve:
    """A curve (or, for kind ``points``, a cloud) that the method built its surface from; points (n, 3)."""

    kind: CurveKind
    points: Floats


@dataclass(frozen=True)
class Statistics:
    """Summary of signed deviations [µm].

    ``max_um``, ``mean_um`` and ``rms_um`` are of absolute values; ``lowest_um`` and ``highest_um`` are
    the signed extremes.
    """

    max_um: float
    mean_um: float
    rms_um: float
    lowest_um: float
    highest_um: float


@dataclass(frozen=True)
class FlankResult:
    """One flank of one tooth as a method made it, and how far it is from theory.

    Attributes
    ----------
    flank : {"concave", "convex"}
    surface : NurbsSurface
        u root to tip, v toe to heel; its natural bounds are the edges of the working flank.
    points : ndarray, shape (n_u, n_v, 3)
        Where the deviation was taken.
    deviation_um : ndarray, shape (n_u, n_v)
        Signed, normal, positive where metal is added.
    statistics : Statistics
    edge_um : float
        Farthest that the surface's four edges lie from the edges of the theoretical flank.
    curves : tuple of ConstructionCurve
    """

    flank: str
    surface: NurbsSurface
    points: Floats
    deviation_um: Floats
    statistics: Statistics
    edge_um: float
    curves: tuple[ConstructionCurve, ...] = ()


@dataclass(frozen=True)
class VariantResult:
    """Both flanks of one member by one variant of one method.

    ``settings`` says what the construction took, in words and numbers (positions, sections, grid, ...);
    ``poles`` and ``degree`` are those of the heavier flank; ``seconds`` is the building alone.
    """

    member: str
    method: str
    variant: str
    flanks: Mapping[str, FlankResult]
    statistics: Statistics
    poles: tuple[int, int]
    degree: tuple[int, int]
    seconds: float
    settings: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class FaceResult:
    """One face of a tooth: ``kind`` ("root", "fillet", "meridian", "flank", "tip") and the side it is on."""

    kind: str
    side: int
    surface: NurbsSurface


@dataclass(frozen=True)
class MassProperties:
    """Of a body of unit density: volume [mm^3], area [mm^2], centre [mm], inertia about it [mm^5] (3, 3)."""

    volume: float
    area: float
    centre: tuple[float, float, float]
    inertia: Floats


@dataclass(frozen=True)
class SolidResult:
    """A member's solid, as far as a window needs it: enough to draw it exactly and to say what it is worth.

    Attributes
    ----------
    faces : tuple of FaceResult
        Of one pitch, over [0, 1]², with growing azimuth (u) and from toe to heel (v), in the order of
        azimuth; turned by the pitch they are the other teeth.
    outline : ndarray, shape (n, 2)
        (radius, height) of the turned body from heel to toe [mm].
    spherical_ends : bool
    valid, closed : bool
        The kernel's full check.
    face_count : int
        Of the solid.
    gap : float
        Largest gap between neighbouring faces [mm].
    properties : MassProperties
    box : ndarray, shape (2, 3)
        Least and greatest coordinates [mm].
    seconds : float
        Building and checking alone.
    end_chamfer : float
        Of the edges between tip and ends of the teeth [mm]; the faces go on beyond.
    """

    member: str
    method: str
    variant: str
    construction: str
    teeth: int
    faces: tuple[FaceResult, ...]
    outline: Floats
    spherical_ends: bool
    valid: bool
    closed: bool
    face_count: int
    gap: float
    properties: MassProperties
    box: Floats
    seconds: float
    end_chamfer: float = 0.0


@dataclass(frozen=True)
class Mesh:
    """Closed triangles by group of faces (``concave``, ``convex``, ``fillet``, ``root``, ``tip``, ``body``).

    Attributes
    ----------
    points : ndarray, shape (n, 3)
        [mm]
    groups : mapping of name to ndarray, shape (m, 3)
        Indices of corners, anticlockwise seen from outside.
    """

    points: Floats
    groups: Mapping[str, NDArray[np.int64]]

    @property
    def triangles(self) -> NDArray[np.int64]:
        """All triangles, shape (m, 3)."""
        return np.concatenate(list(self.groups.values()))

    @property
    def volume(self) -> float:
        """Enclosed [mm^3]; negative when the triangles look inward."""
        a, b, c = (self.points[self.triangles[:, k]] for k in range(3))
        return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)

    @property
    def is_closed(self) -> bool:
        """Whether every edge is used exactly twice, once in each direction: watertight and manifold."""
        t, n = self.triangles, len(self.points)
        forward = np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]]) @ np.array([n, 1])
        backward = np.concatenate([t[:, [1, 0]], t[:, [2, 1]], t[:, [0, 2]]]) @ np.array([n, 1])
        forward.sort()
        backward.sort()
        return bool(np.all(np.diff(forward) > 0) and np.array_equal(forward, backward))


@dataclass(frozen=True)
class FaceSamples:
    """Points inside a face.

    Attributes
    ----------
    points : ndarray, shape (n, 3)
        [mm], whatever the file's unit.
    normals : ndarray, shape (n, 3)
        Unit vectors; out of the metal where the face belongs to a solid.
    areas : ndarray, shape (n,)
        About what each point stands for [mm²].
    """

    points: Floats
    normals: Floats
    areas: Floats
