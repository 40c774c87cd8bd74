"""Method 1: the generating line, moved rigidly as its plane rolls on the base cone (paper section 3, theory 5.1)."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gearstudio import catalogue
from gearstudio.catalogue import MethodInfo, Variant
from gearstudio.kernel.convert import CONFUSION_MM
from gearstudio.kernel.surfaces import curve_through, reconstructed, skin
from gearstudio.methods.base import SAFETY, Construction, Refinement, Target, between, node_errors
from gearstudio.nurbs import NurbsSurface
from gearstudio.results import ConstructionCurve
from gearstudio.theory.flank import Flank, InvoluteFlank
from gearstudio.theory.hypoid.conjugate import ConjugateFlank
from gearstudio.theory.involute import generating_line, tangent_plane

Floats = NDArray[np.float64]

PUBLISHED_POSITIONS = 5
WITHOUT_MODIFICATIONS = {"modifications": "left out"}
"""Setting of a result whose flank has micro-geometry that the line cannot sweep."""
BEST_LINE = {"line": "best fit"}
"""Setting of a result whose flank, conjugate to a wheel on an offset axis, no rigid line sweeps at all."""
_CURVE_DEGREE = 5
_PUBLISHED_POINTS = 15
_PUBLISHED_CUT = (21, 21)
_PUBLISHED_SKIN = 1e-6
_FIRST_POINTS = 11
_FIRST_POSITIONS = 9
_FIRST_CUT = (11, 11)
_DRAWN_POINTS = 60
_SKIN_SHARE = 0.02
_FINEST_PATCH = 2.5 * CONFUSION_MM
_LIMIT_SAMPLES = 65


@dataclass(frozen=True)
class RolledPatch:
    """The surface that the whole line sweeps: more than the flank, with a cuspidal edge on the base cone.

    Attributes
    ----------
    flank : InvoluteFlank
    rho : (float, float)
        Ends of the generating line [mm].
    roll : (float, float)
        First and last contact azimuth of the plane [rad].
    surface : NurbsSurface
        u in [0, 1] along the line, v in [0, 1] with the roll.
    """

    flank: InvoluteFlank
    rho: tuple[float, float]
    roll: tuple[float, float]
    surface: NurbsSurface

    def parameters(self, u: Floats, v: Floats) -> tuple[Floats, Floats]:
        """Where on the patch the working flank's point (u, v) lies."""
        psi, rho = self.flank.coordinates(u, v)
        roll = self.flank.contact_azimuth(psi, rho)
        along = self.flank.member.lengthwise.share(*self.rho, rho)
        return along, (roll - self.roll[0]) / (self.roll[1] - self.roll[0])

    def points(self, u: Floats, v: Floats) -> Floats:
        """The patch's points at the working flank's (u, v)."""
        return self.surface.points(*self.parameters(u, v))


@dataclass(frozen=True)
class RotatingLine:
    """A skin through rigid positions of the generating line, cut off at tip, root (or base) cone, heel and toe.

    ``published``: 5 positions. ``optimised``: as many positions, points and cut nodes as the tolerance asks.

    The cut is a reparametrisation: every point of the result lies on the rolled patch, its four natural
    edges are the limits of the flank, and no part of the patch beyond the cuspidal edge remains.

    A rigid line sweeps no flank with micro-geometry, nor the pinion's of a pair with offset axes. The nearest that it
    does sweep is modelled: the flank without micro-geometry; for that pinion the best fit of base cone and line.
    ``settings`` say so, and the deviation shows by how much the flank that is wanted is missed.
    """

    info: MethodInfo = catalogue.ROTATING_LINE

    def build(self, flank: Flank, variant: Variant, target: Target) -> Construction:
        """See `Method.build`."""
        return _said(flank, self._swept(flank.swept, variant, target))

    def build_with(self, flank: Flank, count: int, target: Target) -> Construction:
        """See `Method.build_with`; line and cut have as many points as positions, or enough for the degree."""
        points = max(count, _CURVE_DEGREE + 1)
        patch, line = _roll(flank.swept, points, count, _SKIN_SHARE * target.tolerance)
        u, v = (np.linspace(0.0, 1.0, points) for _ in range(2))
        settings = {"positions": count, "points": points, "cut": [points, points]}
        return _said(flank, Construction(_cut(patch, u, v), line, settings))

    def _swept(self, flank: InvoluteFlank, variant: Variant, target: Target) -> Construction:
        if variant == "published":
            patch, line = _roll(flank, _PUBLISHED_POINTS, PUBLISHED_POSITIONS, _PUBLISHED_SKIN)
            u, v = (np.linspace(0.0, 1.0, n) for n in _PUBLISHED_CUT)
            return Construction(_cut(patch, u, v), line, {"positions": PUBLISHED_POSITIONS})
        patch, positions = self._accurate_patch(flank, target)

        def attempt(counts: tuple[int, ...]) -> tuple[Construction, tuple[float, ...]]:
            u, v = (np.linspace(0.0, 1.0, n) for n in counts)
            surface = _cut(patch, u, v)
            settings = {**positions.settings, "cut": list(counts)}
            return Construction(surface, positions.curves, settings), node_errors(flank, surface, u, v)

        goal = SAFETY * target.tolerance
        return Refinement(self.info.id, goal, (_CURVE_DEGREE + 1,) * 2).run(_FIRST_CUT, attempt)

    def _accurate_patch(self, flank: InvoluteFlank, target: Target) -> tuple[RolledPatch, Construction]:
        found: list[RolledPatch] = []

        def attempt(counts: tuple[int, ...]) -> tuple[Construction, tuple[float, ...]]:
            points, positions = counts
            patch, line = _roll(flank, points, positions, _SKIN_SHARE * target.tolerance)
            found[:] = [patch]
            settings = {"positions": positions, "points": points}
            return Construction(patch.surface, line, settings), _patch_errors(patch, points, positions)

        goal = max(SAFETY * target.tolerance / 4, _FINEST_PATCH)
        positions = Refinement(self.info.id, goal, (_CURVE_DEGREE + 1, 7)).run(
            (_FIRST_POINTS, _FIRST_POSITIONS), attempt
        )
        return found[0], positions


def _said(flank: Flank, built: Construction) -> Construction:
    """With a word in its settings where another flank was modelled than the one wanted."""
    if flank.swept is flank:
        return built
    word = BEST_LINE if isinstance(flank, ConjugateFlank) else WITHOUT_MODIFICATIONS
    return replace(built, settings={**word, **built.settings}, instead=flank.swept)


def _roll(
    flank: InvoluteFlank, points: int, positions: int, tolerance: float
) -> tuple[RolledPatch, tuple[ConstructionCurve, ...]]:
    """Skin through rigid positions of one curve, wide enough to hold the whole working flank."""
    edge = np.linspace(0.0, 1.0, _LIMIT_SAMPLES)
    psi, rho = flank.coordinates(np.array([[0.0], [1.0]]), edge)
    roll = flank.contact_azimuth(psi, rho)
    ends, span = (rho.min(), rho.max()), (roll.min(), roll.max())
    along = np.linspace(0.0, 1.0, points)
    start = curve_through(along, _line(flank, ends, span[0], along), _CURVE_DEGREE)
    azimuths = np.linspace(*span, positions)
    motions = [_rolling_motion(flank.member.base_angle, span[0], azimuth) for azimuth in azimuths]
    surface = skin([start.moved(motion) for motion in motions], tolerance)
    drawn = np.linspace(0.0, 1.0, _DRAWN_POINTS)
    lines = tuple(ConstructionCurve("position", _line(flank, ends, azimuth, drawn)) for azimuth in azimuths)
    return RolledPatch(flank, ends, span, surface), lines


def _line(flank: InvoluteFlank, ends: tuple[float, float], azimuth: float, along: Floats) -> Floats:
    return generating_line(flank.member, flank.side, flank.member.lengthwise.divided(*ends, along), azimuth)


def _rolling_motion(base_angle: float, start: float, azimuth: float) -> Floats:
    """Rotation, shape (3, 3), of the plane that rolls from one line of contact to another without slip."""
    first, last = (np.stack(tangent_plane(base_angle, a), axis=-1) for a in (start, azimuth))
    slip_free = (start - azimuth) * np.sin(base_angle)
    c, s = np.cos(slip_free), np.sin(slip_free)
    in_plane = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    return np.asarray(last @ in_plane @ first.T)


def _patch_errors(patch: RolledPatch, points: int, positions: int) -> tuple[float, float]:
    """Distance of the skin from the exact rolled patch between the line's points and between the positions [mm]."""

    def gap(u: Floats, v: Floats) -> float:
        flank = patch.flank
        rho = flank.member.lengthwise.divided(*patch.rho, u)
        roll = patch.roll[0] + v * (patch.roll[1] - patch.roll[0])
        exact = generating_line(flank.member, flank.side, rho[:, None], roll[None, :])
        return float(np.linalg.norm(patch.surface.grid(u, v) - exact, axis=-1).max())

    u, v = np.linspace(0.0, 1.0, points), np.linspace(0.0, 1.0, positions)
    return gap(between(u), v), gap(u, between(v))


def _cut(patch: RolledPatch, u: Floats, v: Floats) -> NurbsSurface:
    points = patch.points(u[:, None], patch.flank.along(v)[None, :])
    return reconstructed(u, v, points, _CURVE_DEGREE, patch.flank.starts_on_base)
