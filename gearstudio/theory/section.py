"""What the profile of a tooth is to those who make faces of it, whether it is the same along the face or not.

A section is a tooth at one place along its face, on the end surface through that place. Polar angle and azimuth,
from which theta(rho) is taken, are its coordinates; curves that touch in them belong to faces that are tangent.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import Flank

Floats = NDArray[np.float64]
Segment = Literal["root", "fillet", "meridian", "flank", "tip"]
Shift = Callable[[Floats, Floats], Floats]
"""Azimuth [rad] by which points at cone distances and polar angles are turned."""


class Profile(Protocol):
    """The faces of a tooth in theory, section by section.

    A place along the face is told by rho_u [mm] of its end surface (theory 6), a side by +1 or -1.
    """

    @property
    def member(self) -> MemberGeometry:
        """Whose teeth they are; its base cone may be that of one flank only."""
        ...

    @property
    def has_root(self) -> bool:
        """Whether the fillets of a space leave a root between them."""
        ...

    def below(self, side: int) -> tuple[Segment, ...]:
        """Faces between root and flank, from the root up: ``fillet``, ``meridian``.

        The last is a great circle in every section, be it a meridian or the tangent of a flank that ends above it.
        """
        ...

    def flank(self, side: int) -> Flank:
        """The flank, down to where the face below it begins."""
        ...

    def shift_on(self, side: int) -> Shift | None:
        """By how much micro-geometry turns the faces of a side; None where there is none."""
        ...

    def places(self, share: Floats) -> Floats:
        """rho_u at shares in [0, 1] of the way from toe to heel, spaced as the flanks are."""
        ...

    def rising(self, name: Segment, side: int, x: Floats, rho_u: Floats) -> tuple[Floats, Floats]:
        """Polar angle and azimuth [rad] on a face below the flank, x from 0 at the root's side to 1."""
        ...

    def across(self, name: Segment, rho_u: Floats) -> tuple[Floats, Floats, Floats]:
        """Polar angle of tip or root, and the azimuths of its edges, the smaller first [rad]."""
        ...

    def foot_angle(self, side: int, rho_u: Floats) -> Floats:
        """Polar angle where the fillet ends [rad]."""
        ...

    def flank_foot(self, side: int, rho_u: Floats) -> Floats:
        """Polar angle where the flank begins [rad]."""
        ...

    def off_straight(self, side: int, rho: Floats, delta: Floats, phi: Floats) -> Floats:
        """Distance of points from the great circle of ``meridian``, positive beyond the metal [mm]; phi as below."""
        ...

    def off_fillet(self, side: int, rho: Floats, delta: Floats, phi: Floats) -> Floats:
        """Distance of points from the circle of the fillet, positive inside it [mm]; phi without theta(rho)."""
        ...

    def extended(self, member: MemberGeometry) -> Profile:
        """The same teeth on a member that is longer and higher."""
        ...

    def unmodified(self, flanks: dict[int, Flank]) -> Profile:
        """The profile that belongs to other flanks, which a method made instead."""
        ...


def on_circle(x: Floats, radius: Floats, centre_angle: Floats, foot_angle: Floats) -> tuple[Floats, Floats]:
    """Points of circles on the unit sphere, from the one nearest to the axis (x = 0) to a polar angle (x = 1).

    Returns
    -------
    delta, phi : ndarray
        Polar angle, and azimuth from that of the centre, at smaller azimuth [rad]; all arrays broadcast.
    """
    cos_r, sin_r, cos_c, sin_c = np.cos(radius), np.sin(radius), np.cos(centre_angle), np.sin(centre_angle)
    cosine = (np.cos(foot_angle) - cos_r * cos_c) / (sin_r * sin_c)
    turn = x * np.arccos(np.clip(cosine, -1.0, 1.0))
    along, across = sin_r * np.cos(turn), -sin_r * np.sin(turn)
    out, up = cos_r * sin_c - along * cos_c, cos_r * cos_c + along * sin_c
    return np.arctan2(np.hypot(out, across), up), np.arctan2(across, out)


def off_circle(radius: Floats, centre_angle: Floats, delta: Floats, phi: Floats) -> Floats:
    """How far points lie inside circles on the unit sphere [rad]; phi is from the centre's azimuth."""
    haversine = np.sin((delta - centre_angle) / 2) ** 2 + np.sin(delta) * np.sin(centre_angle) * np.sin(phi / 2) ** 2
    return np.asarray(radius - 2 * np.arcsin(np.sqrt(np.clip(haversine, 0.0, 1.0))))


def faded(value: Floats, slope: Floats, delta: Floats, root: Floats, low: Floats) -> Floats:
    """A turn that goes on below a flank's foot with the same value and slope and ends, slope included, at the root.

    Parameters
    ----------
    value, slope : ndarray
        At the polar angle ``delta``, or at ``low`` below it [rad].
    delta, root, low : ndarray
        Polar angles of places, of the root cone and of the foot [rad].
    """
    depth = low - root
    t = np.clip((delta - root) / depth, 0.0, 1.0)
    return np.where(delta < low, t**2 * (value * (3 - 2 * t) + slope * depth * (t - 1)), value)
