"""Undercut of the pinion, where the conjugate flank folds back, and what else keeps it from being a flank."""

from __future__ import annotations

from dataclasses import dataclass
from math import degrees

import numpy as np

from gearstudio.errors import GeometryError
from gearstudio.theory.hypoid.conjugate import envelope, pinion_flank
from gearstudio.theory.hypoid.pair import HypoidPair
from gearstudio.theory.involute import roll_arc
from gearstudio.theory.vectors import spherical

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


def worst_place(pair: HypoidPair, side: int) -> Undercut:
    """Where the pinion's flank on a side is nearest to undercut, or beyond.

    Parameters
    ----------
    pair : HypoidPair
    side : {+1, -1}

    Notes
    -----
    The wheel's whole flank is looked at, from its lower edge to its tip, as far as it generates points between the
    pinion's ends and inside its face cone: a folded part has an image there too.
    """
    generator, pinion = envelope(pair, side), pair.member("pinion", pair.flank_name("pinion", side))
    wheel = generator.wheel.member
    beyond = _BEYOND * wheel.face_width
    rho = np.linspace(wheel.inner_cone_distance - beyond, wheel.outer_cone_distance + beyond, _ALONG)
    tip = wheel.tip_limit.at_sphere(rho)
    root = np.maximum(wheel.root_limit.at_sphere(rho), wheel.base_angle)
    psi = roll_arc(root, wheel.base_angle)
    share = np.linspace(0.0, 1.0, _ACROSS)[:, None] ** 0.5
    made = generator.made(psi + share * (roll_arc(tip, wheel.base_angle) - psi), rho)
    distance, delta, _ = spherical(made.point)
    place = pinion.face_share(pinion.end_distance(distance, delta))
    inside = (place >= 0) & (place <= 1) & (delta <= pinion.tip_limit.at_sphere(distance))
    ratio = np.where(inside, made.area_ratio, np.inf)
    worst = np.unravel_index(np.argmin(ratio), ratio.shape)
    return Undercut(side, float(ratio[worst]), float(distance[worst]), float(delta[worst]), float(place[worst]))


def trouble(pair: HypoidPair, side: int) -> str | None:
    """What is wrong with the pinion's flank on a side, or None."""
    worst = worst_place(pair, side)
    if not worst.harmless:
        end = "toe" if worst.place < 1 / 3 else "heel" if worst.place > 2 / 3 else "middle"
        return (
            f"is undercut near the {end}, {worst.rho:.5g} mm from the pitch apex, polar angle "
            f"{degrees(worst.polar_angle):.5g}° (area ratio {worst.area_ratio:.3g}, must exceed {LEAST_AREA_RATIO:g})"
        )
    flank = pinion_flank(pair, pair.flank_name("pinion", side))
    wheel = flank.envelope.wheel.member
    tips = wheel.limit_angle(wheel.tip_limit, np.array([wheel.inner_cone_distance, wheel.outer_cone_distance]))
    if np.min(tips) <= wheel.base_angle:
        return "has nothing to mesh with at an end, where the wheel's tips lie inside its base cone"
    try:
        psi, _ = flank.coordinates(np.linspace(0.0, 1.0, 5)[:, None], np.linspace(0.0, 1.0, 7))
    except GeometryError as error:
        return f"does not reach everywhere: {error}"
    if np.min(psi) < 0:
        return "meets the wheel inside its base cone with its tips"
    return None
