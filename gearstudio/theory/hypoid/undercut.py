"""Undercut of the pinion: where the conjugate flank folds back."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from gearstudio.theory.hypoid.conjugate import envelope
from gearstudio.theory.hypoid.pair import HypoidPair
from gearstudio.theory.involute import roll_arc

LEAST_AREA_RATIO = 0.01
_ALONG, _ACROSS = 41, 25
_BEYOND = 0.15


@dataclass(frozen=True)
class Undercut:
    """The worst place of a pinion flank.

    Attributes
    ----------
    side : {+1, -1}
    area_ratio : float
        Smallest J on the flank; 0 and less is undercut.
    rho, polar_angle : float
        Where, about the pinion's pitch apex [mm, rad].
    place : float
        Along the face, 0 at the toe to 1 at the heel.
    """

    side: int
    area_ratio: float
    rho: float
    polar_angle: float
    place: float

    @property
    def harmless(self) -> bool:
        """Whether the flank is regular everywhere."""
        return self.area_ratio > LEAST_AREA_RATIO


def worst_place(pair: HypoidPair, side: int, raised: float = 0.0) -> Undercut:
    """Where the pinion's flank on a side is nearest to undercut, or beyond.

    Parameters
    ----------
    pair : HypoidPair
    side : {+1, -1}
    raised : float
        As of `ConjugateFlank`.

    Notes
    -----
    The wheel's whole flank is looked at, from its lower edge to its tip, as far as it generates points between the
    pinion's ends and inside its face cone: a folded part has an image there too.
    """
    generator, pinion = envelope(pair, side), pair.member("pinion", pair.flank_name("pinion", side))
    wheel = generator.wheel.member
    beyond = _BEYOND * wheel.face_width
    rho = np.linspace(wheel.inner_cone_distance - beyond, wheel.outer_cone_distance + beyond, _ALONG)
    tip = replace(wheel.tip_limit, offset=wheel.tip_limit.offset + raised).at_sphere(rho)
    root = np.maximum(wheel.root_limit.at_sphere(rho), wheel.base_angle)
    psi = roll_arc(root, wheel.base_angle)
    share = np.linspace(0.0, 1.0, _ACROSS)[:, None] ** 0.5
    made = generator.made(psi + share * (roll_arc(tip, wheel.base_angle) - psi), rho)
    distance = np.linalg.norm(made.point, axis=-1)
    delta = np.arctan2(np.hypot(made.point[..., 0], made.point[..., 1]), made.point[..., 2])
    place = (pinion.end_distance(distance, delta) - pinion.inner_cone_distance) / pinion.face_width
    inside = (place >= 0) & (place <= 1) & (delta <= pinion.tip_limit.at_sphere(distance))
    ratio = np.where(inside, made.area_ratio, np.inf)
    worst = np.unravel_index(np.argmin(ratio), ratio.shape)
    return Undercut(side, float(ratio[worst]), float(distance[worst]), float(delta[worst]), float(place[worst]))
