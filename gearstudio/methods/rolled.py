"""What the generating line sweeps as its plane rolls on the base cone (theory 5.1), skinned by the kernel."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.kernel.surfaces import curve_through, reconstructed, skin
from gearstudio.methods.base import between
from gearstudio.nurbs import NurbsSurface
from gearstudio.results import ConstructionCurve
from gearstudio.theory.involute import generating_line, tangent_plane
from gearstudio.theory.involute_flank import InvoluteFlank

Floats = NDArray[np.float64]
Span = tuple[float, float]

DEGREE = 5
_DRAWN_POINTS = 60
_LIMIT_SAMPLES = 64
_PROFILE_SAMPLES = 9
_LONGEST_STRETCH = 2 * np.pi


@dataclass(frozen=True)
class Stretch:
    """What a piece of the line sweeps during a part of the roll: more than the flank, with a cuspidal edge.

    Attributes
    ----------
    flank : InvoluteFlank
    rho : (float, float)
        Ends of the piece [mm].
    roll : (float, float)
        First and last contact azimuth of the plane [rad].
    surface : NurbsSurface
        u in [0, 1] along the line, v in [0, 1] with the roll.
    """

    flank: InvoluteFlank
    rho: Span
    roll: Span
    surface: NurbsSurface

    def at(self, rho: Floats, roll: Floats) -> Floats:
        """Points of the surface, shape (..., 3)."""
        along = self.flank.member.lengthwise.share(*self.rho, rho)
        return self.surface.points(along, (roll - self.roll[0]) / (self.roll[1] - self.roll[0]))

    def errors(self, points: int, positions: int) -> Floats:
        """Distance from what is exactly swept between the line's points, and between the positions, shape (2,) [mm]."""
        u, v = np.linspace(0.0, 1.0, points), np.linspace(0.0, 1.0, positions)
        return np.array([self._gap(between(u), v), self._gap(u, between(v))])

    def _gap(self, u: Floats, v: Floats) -> float:
        flank = self.flank
        rho = flank.member.lengthwise.divided(*self.rho, u)
        roll = self.roll[0] + v * (self.roll[1] - self.roll[0])
        exact = generating_line(flank.member, flank.side, rho[:, None], roll[None, :])
        return float(np.linalg.norm(self.surface.grid(u, v) - exact, axis=-1).max())


@dataclass(frozen=True)
class RolledPatch:
    """The stretches of a whole roll, of equal length; each holds the part of the flank that it makes."""

    flank: InvoluteFlank
    roll: Span
    stretches: tuple[Stretch, ...]
    positions: tuple[ConstructionCurve, ...]

    def points(self, u: Floats, v: Floats) -> Floats:
        """The patch's points at the working flank's (u, v), shape (..., 3)."""
        psi, rho = self.flank.coordinates(u, v)
        roll = self.flank.contact_azimuth(psi, rho)
        count = len(self.stretches)
        share = (roll - self.roll[0]) / (self.roll[1] - self.roll[0])
        index = np.clip(np.floor(share * count).astype(int), 0, count - 1)
        found = np.empty((*rho.shape, 3))
        for number, stretch in enumerate(self.stretches):
            here = index == number
            if np.any(here):
                found[here] = stretch.at(rho[here], roll[here])
        return found

    def errors(self, points: int, positions: int) -> tuple[float, float]:
        """The largest of `Stretch.errors`."""
        first, second = np.max([stretch.errors(points, positions) for stretch in self.stretches], axis=0)
        return float(first), float(second)


def stretches_of(flank: InvoluteFlank) -> int:
    """How many stretches of at most a turn the roll of a flank takes; more than one where teeth wind round a needle.

    The line is many turns long there and only a short piece of it is at the flank at a time.
    """
    low, high = _roll_span(flank, _LIMIT_SAMPLES)[2]
    return max(1, int(np.ceil((high - low) / _LONGEST_STRETCH)))


def rolled(flank: InvoluteFlank, points: int, positions: int, tolerance: float, count: int = 1) -> RolledPatch:
    """Skins through rigid positions of one curve, together wide enough to hold the whole working flank.

    Parameters
    ----------
    flank : InvoluteFlank
    points : int
        On the line, or on the piece of it that a stretch takes.
    positions : int
        In each stretch, both ends included.
    tolerance : float
        Within which the skin meets the positions [mm].
    count : int
        Number of stretches.
    """
    rho, roll, span = _roll_span(flank, _LIMIT_SAMPLES * count)
    bounds = np.linspace(*span, count + 1)
    stretches, drawn = [], []
    for first, last in zip(bounds[:-1].tolist(), bounds[1:].tolist(), strict=True):
        made = np.flatnonzero((roll.min(axis=0) <= last) & (roll.max(axis=0) >= first))
        piece = rho[:, max(made[0] - 1, 0) : made[-1] + 2]
        ends = (float(piece.min()), float(piece.max()))
        azimuths = np.linspace(first, last, positions)
        along = np.linspace(0.0, 1.0, points)
        start = curve_through(along, _line(flank, ends, first, along), DEGREE)
        motions = [_rolling_motion(flank.member.base_angle, first, azimuth) for azimuth in azimuths]
        surface = skin([start.moved(motion) for motion in motions], tolerance)
        stretches.append(Stretch(flank, ends, (first, last), surface))
        shown = azimuths if last == bounds[-1] else azimuths[:-1]
        drawn += [_line(flank, ends, azimuth, np.linspace(0.0, 1.0, _DRAWN_POINTS)) for azimuth in shown]
    return RolledPatch(flank, span, tuple(stretches), tuple(ConstructionCurve("position", line) for line in drawn))


def cut(patch: RolledPatch, u: Floats, v: Floats) -> NurbsSurface:
    """The working flank cut out of the patch by reparametrisation, through its points at u and shares v."""
    points = patch.points(u[:, None], patch.flank.along(v)[None, :])
    return reconstructed(u, v, points, DEGREE, patch.flank.starts_on_base)


def _roll_span(flank: InvoluteFlank, samples: int) -> tuple[Floats, Floats, Span]:
    """Cone distances and contact azimuths over the flank, (n, samples + 1) each; the roll's span.

    Between root and tip a toe on the front cone comes as near to the apex as the member's inner cone distance.
    """
    psi, rho = flank.coordinates(np.linspace(0.0, 1.0, _PROFILE_SAMPLES)[:, None], np.linspace(0.0, 1.0, samples + 1))
    roll, rho = flank.contact_azimuth(psi, rho), np.array(rho)
    rho[0, 0] = min(rho[:, 0].min(), flank.member.inner_cone_distance)
    return rho, roll, (float(roll.min()), float(roll.max()))


def _line(flank: InvoluteFlank, ends: Span, azimuth: float, along: Floats) -> Floats:
    return generating_line(flank.member, flank.side, flank.member.lengthwise.divided(*ends, along), azimuth)


def _rolling_motion(base_angle: float, start: float, azimuth: float) -> Floats:
    """Rotation, shape (3, 3), of the plane that rolls from one line of contact to another without slip."""
    first, last = (np.stack(tangent_plane(base_angle, a), axis=-1) for a in (start, azimuth))
    slip_free = (start - azimuth) * np.sin(base_angle)
    c, s = np.cos(slip_free), np.sin(slip_free)
    in_plane = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    return np.asarray(last @ in_plane @ first.T)
