"""Method 2: sweeping the tooth profile from heel to toe along the tooth trace (paper section 4)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio import catalogue
from gearstudio.catalogue import MethodInfo, Variant
from gearstudio.kernel.surfaces import Curve, curve_through, oriented, pipe, skin
from gearstudio.methods.base import SAFETY, Construction, Refinement, Target, node_errors
from gearstudio.results import ConstructionCurve
from gearstudio.theory.flank import Flank
from gearstudio.theory.involute_flank import InvoluteFlank

Floats = NDArray[np.float64]

_CURVE_DEGREE = 5
_PUBLISHED_POINTS = 15
_SPINE_POINTS = 31
_FIRST = (11, 7)
_FIRST_ELSE = (15, 9)
"""Points and sections to begin with, for an involute flank, and for another."""
_DRAWN_POINTS = 60
_GUIDE_PLACES = (0.0, 0.5, 1.0)
_SKIN_SHARE = 0.02
_PIPE_TOLERANCE = 1e-8


@dataclass(frozen=True)
class ProfileSweep:
    """``published``: heel and toe profile joined by a pipe along the tooth trace.

    ``optimised``: a skin through a string of interpolated sections, as many as it takes for it to follow the
    exact flank between them. The guide curves (root, middle and tip) are what it is held against and are
    drawn; they are no input to the kernel's skin.
    """

    info: MethodInfo = catalogue.PROFILE_SWEEP

    def build(self, flank: Flank, variant: Variant, target: Target) -> Construction:
        """See `Method.build`."""
        return self._published(flank) if variant == "published" else self._optimised(flank, target)

    def _published(self, flank: Flank) -> Construction:
        profiles = _sections(flank, np.array([1.0, 0.0]), _PUBLISHED_POINTS)
        places = np.linspace(0.0, 1.0, _SPINE_POINTS)
        trace = flank.trace(1.0 - places)
        spine = curve_through(places, trace, _CURVE_DEGREE)
        swept = pipe(profiles, spine, _PIPE_TOLERANCE * flank.member.outer_cone_distance)
        surface = oriented(swept, flank.points([[0.0], [1.0]], [[0.0, 1.0]]))
        curves = (*_drawn_sections(flank, np.array([0.0, 1.0])), ConstructionCurve("guide", trace))
        return Construction(surface, curves, {"sections": 2, "guides": 1, "sweep": "pipe along the tooth trace"})

    def build_with(self, flank: Flank, count: int, target: Target) -> Construction:
        """See `Method.build_with`; a section has as many points as there are sections, or enough for its degree."""
        return self._attempt(flank, (max(count, _CURVE_DEGREE + 1), count), target)[0]

    def _optimised(self, flank: Flank, target: Target) -> Construction:
        refinement = Refinement(self.info.id, SAFETY * target.tolerance, (_CURVE_DEGREE + 1, 7))
        first = _FIRST if isinstance(flank, InvoluteFlank) else _FIRST_ELSE
        return refinement.run(first, lambda counts: self._attempt(flank, counts, target))

    def _attempt(self, flank: Flank, counts: tuple[int, ...], target: Target) -> tuple[Construction, tuple[float, ...]]:
        points, sections = counts
        shares = np.linspace(0.0, 1.0, sections)
        v = flank.along(shares)
        skinned = skin(_sections(flank, v, points), _SKIN_SHARE * target.tolerance)
        surface = oriented(skinned, flank.points([[0.0], [1.0]], [[0.0, 1.0]]))
        curves = (*_drawn_sections(flank, v), *_drawn_guides(flank))
        settings = {"sections": sections, "points": points, "guides": len(_GUIDE_PLACES), "sweep": "skin"}
        construction = Construction(surface, curves, settings)
        return construction, node_errors(flank, surface, np.linspace(0.0, 1.0, points), shares)


def _sections(flank: Flank, v: Floats, points: int) -> list[Curve]:
    u = np.linspace(0.0, 1.0, points)
    flat = flank.starts_on_base
    return [curve_through(u, row, _CURVE_DEGREE, flat) for row in flank.points(u, v[:, None])]


def _drawn_sections(flank: Flank, v: Floats) -> tuple[ConstructionCurve, ...]:
    u = np.linspace(0.0, 1.0, _DRAWN_POINTS)
    return tuple(ConstructionCurve("section", row) for row in flank.points(u, v[:, None]))


def _drawn_guides(flank: Flank) -> tuple[ConstructionCurve, ...]:
    v = np.linspace(0.0, 1.0, _DRAWN_POINTS)
    return tuple(ConstructionCurve("guide", row) for row in flank.points(np.array(_GUIDE_PLACES)[:, None], v))
