"""Method 1: the generating line, moved rigidly as its plane rolls on the base cone (paper section 3, theory 5.1)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from gearstudio import catalogue
from gearstudio.catalogue import MethodInfo, Variant
from gearstudio.kernel.convert import CONFUSION_MM
from gearstudio.methods.base import SAFETY, Construction, Refinement, Target, node_errors
from gearstudio.methods.rolled import DEGREE, RolledPatch, cut, rolled, stretches_of
from gearstudio.theory.flank import Flank
from gearstudio.theory.hypoid.conjugate import ConjugateFlank
from gearstudio.theory.involute_flank import InvoluteFlank

PUBLISHED_POSITIONS = 5
WITHOUT_MODIFICATIONS = {"modifications": "left out"}
"""Setting of a result whose flank has micro-geometry that the line cannot sweep."""
BEST_LINE = {"line": "best fit"}
"""Setting of a result whose flank, conjugate to a wheel on an offset axis, no rigid line sweeps at all."""
_PUBLISHED_POINTS = 15
_PUBLISHED_CUT = (21, 21)
_PUBLISHED_SKIN = 1e-6
_FIRST_POINTS = 11
_FIRST_POSITIONS = 9
_FIRST_CUT = (11, 11)
_SKIN_SHARE = 0.02
_FINEST_PATCH = 2.5 * CONFUSION_MM


@dataclass(frozen=True)
class RotatingLine:
    """A skin through rigid positions of the generating line, cut off at tip, root (or base) cone, heel and toe.

    ``published``: 5 positions. ``optimised``: as many positions, points and cut nodes as the tolerance asks.

    The cut is a reparametrisation: every point of the result lies on the rolled patch, its four natural
    edges are the limits of the flank, and no part of the patch beyond the cuspidal edge remains. Where the plane rolls
    more than once round, it is skinned in stretches of at most a turn, each with the piece of the line that it needs.

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
        points = max(count, DEGREE + 1)
        patch = rolled(flank.swept, points, count, _SKIN_SHARE * target.tolerance)
        u, v = (np.linspace(0.0, 1.0, points) for _ in range(2))
        settings = {"positions": count, "points": points, "cut": [points, points]}
        return _said(flank, Construction(cut(patch, u, v), patch.positions, settings))

    def _swept(self, flank: InvoluteFlank, variant: Variant, target: Target) -> Construction:
        if variant == "published":
            patch = rolled(flank, _PUBLISHED_POINTS, PUBLISHED_POSITIONS, _PUBLISHED_SKIN)
            u, v = (np.linspace(0.0, 1.0, n) for n in _PUBLISHED_CUT)
            return Construction(cut(patch, u, v), patch.positions, {"positions": PUBLISHED_POSITIONS})
        patch, settings = self._accurate_patch(flank, target)

        def attempt(counts: tuple[int, ...]) -> tuple[Construction, tuple[float, ...]]:
            u, v = (np.linspace(0.0, 1.0, n) for n in counts)
            surface = cut(patch, u, v)
            made = Construction(surface, patch.positions, {**settings, "cut": list(counts)})
            return made, node_errors(flank, surface, u, v)

        goal = SAFETY * target.tolerance
        return Refinement(self.info.id, goal, (DEGREE + 1,) * 2).run(_FIRST_CUT, attempt)

    def _accurate_patch(self, flank: InvoluteFlank, target: Target) -> tuple[RolledPatch, Mapping[str, Any]]:
        """The patch, and what it took."""
        found: list[RolledPatch] = []
        stretches = stretches_of(flank)

        def attempt(counts: tuple[int, ...]) -> tuple[Construction, tuple[float, ...]]:
            points, positions = counts
            patch = rolled(flank, points, positions, _SKIN_SHARE * target.tolerance, stretches)
            found[:] = [patch]
            settings = {"positions": len(patch.positions), "points": points}
            return Construction(patch.stretches[0].surface, settings=settings), patch.errors(points, positions)

        goal = max(SAFETY * target.tolerance / 4, _FINEST_PATCH)
        refinement = Refinement(self.info.id, goal, (DEGREE + 1, 7))
        made = refinement.run((_FIRST_POINTS, _FIRST_POSITIONS), attempt)
        return found[0], made.settings


def _said(flank: Flank, built: Construction) -> Construction:
    """With a word in its settings where another flank was modelled than the one wanted."""
    if flank.swept is flank:
        return built
    word = BEST_LINE if isinstance(flank, ConjugateFlank) else WITHOUT_MODIFICATIONS
    return replace(built, settings={**word, **built.settings}, instead=flank.swept)
