"""What a flank is to methods, analysis and views, whatever curve it comes from."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.vectors import spherical

if TYPE_CHECKING:
    from gearstudio.theory.involute_flank import InvoluteFlank

Floats = NDArray[np.float64]
FlankName = Literal["concave", "convex"]
FLANKS: tuple[FlankName, FlankName] = ("concave", "convex")


def side_of(hand: int, name: str) -> int:
    """+1 or -1: on which side of a tooth of a hand its flank is; concave is side = hand (theory 4)."""
    return hand if name == "concave" else -hand


def name_of(hand: int, side: int) -> FlankName:
    """``concave`` or ``convex``: the flank on a side of a tooth of a hand; the inverse of `side_of`."""
    return "concave" if side == hand else "convex"


class Flank(Protocol):
    """A theoretical flank.

    u in [0, 1] runs from the root (or base cone) to the tip, v in [0, 1] from toe to heel; the unit square
    is the working flank, and the map is analytic a little beyond it. Natural coordinates are those in which the
    flank is given in closed form, whatever they are; `coordinates` leads to them.
    """

    @property
    def name(self) -> FlankName:
        """``concave`` or ``convex``."""
        ...

    @property
    def member(self) -> MemberGeometry:
        """Whose flank it is."""
        ...

    @property
    def side(self) -> int:
        """+1 or -1: at larger or smaller azimuth of the tooth centred at azimuth 0."""
        ...

    @property
    def starts_on_base(self) -> bool:
        """Whether the first derivative by u vanishes on the lower edge."""
        ...

    @property
    def swept(self) -> InvoluteFlank:
        """The nearest flank that one rigid line sweeps; the flank itself where it is such a one."""
        ...

    def points(self, u: ArrayLike, v: ArrayLike) -> Floats:
        """Points, shape (..., 3) [mm]."""
        ...

    def normals(self, u: ArrayLike, v: ArrayLike) -> Floats:
        """Unit normals out of the metal, shape (..., 3)."""
        ...

    def along(self, share: ArrayLike) -> Floats:
        """Places v at which shares in [0, 1] divide the face for an interpolation."""
        ...

    def evenly_divided(self, n_u: int, n_v: int) -> Floats:
        """Points at evenly spaced polar angles and places along the face, shape (n_u, n_v, 3)."""
        ...

    def trace(self, v: ArrayLike) -> Floats:
        """Points on the pitch cone, shape (..., 3)."""
        ...

    def limits(self, v: ArrayLike) -> tuple[Floats, Floats]:
        """Polar angles of the lower and upper edge [rad]."""
        ...

    def points_at(self, rho: ArrayLike, polar_angle: ArrayLike) -> Floats:
        """Points at cone distance [mm] and polar angle [rad], shape (..., 3); raises GeometryError beyond the flank."""
        ...

    def lower_angle(self, rho: ArrayLike) -> Floats:
        """Polar angle of the lower edge at cone distances [rad]."""
        ...

    def locate(self, points: ArrayLike) -> tuple[Floats, Floats, Floats]:
        """Spherical coordinates rho, delta_k, phi of points."""
        ...

    def deviation(self, points: ArrayLike) -> Floats:
        """Signed normal distance of points, positive where metal is added [mm]."""
        ...

    def edge_deviation(self, points: Floats) -> float:
        """Farthest that the border of a surface (n_u, n_v, 3) lies from the edges [mm]."""
        ...

    def coordinates(self, u: ArrayLike, v: ArrayLike) -> tuple[Floats, Floats]:
        """Natural coordinates at (u, v)."""
        ...

    def natural(self, points: ArrayLike) -> tuple[Floats, Floats]:
        """Natural coordinates at points on or near the flank."""
        ...

    def natural_at(self, rho: ArrayLike, polar_angle: ArrayLike) -> tuple[Floats, Floats]:
        """Natural coordinates at places on the flank, or of the nearest one not far beyond its edges."""
        ...

    def azimuth(self, rho: ArrayLike, polar_angle: ArrayLike) -> Floats:
        """phi(rho, delta_k) [rad]."""
        ...

    def lever(self, rho: Floats, polar_angle: Floats) -> Floats:
        """Normal distance per difference in azimuth [mm/rad]."""
        ...

    def at(self, first: ArrayLike, second: ArrayLike, /) -> Floats:
        """Points at natural coordinates, shape (..., 3)."""
        ...

    def derivatives_at(self, first: ArrayLike, second: ArrayLike, /) -> tuple[Floats, Floats, Floats, Floats, Floats]:
        """First and second derivatives by the natural coordinates, shape (..., 3) each."""
        ...

    def normals_at(self, first: ArrayLike, second: ArrayLike, /) -> Floats:
        """Unit normals out of the metal at natural coordinates, shape (..., 3)."""
        ...


def border_gap(flank: Flank, points: Floats) -> float:
    """How far the border of a surface lies from the edges of a flank, for `Flank.edge_deviation`."""
    m = flank.member
    rho, delta, _ = spherical(points)
    place = m.face_share(m.end_distance(rho, delta))
    ends = max(np.abs(place[:, 0]).max(), np.abs(place[:, -1] - 1.0).max()) * m.face_width
    root = np.abs(delta[0] - flank.limits(place[0])[0]) * rho[0]
    tip = np.abs(delta[-1] - flank.limits(place[-1])[1]) * rho[-1]
    return float(max(ends, root.max(), tip.max()))
