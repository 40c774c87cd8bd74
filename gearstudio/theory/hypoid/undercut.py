"""Undercut of the pinion: where the conjugate flank folds back, and what would cure it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import degrees

import numpy as np
from numpy.typing import NDArray

from gearstudio.errors import GeometryError
from gearstudio.theory.flank import FlankName
from gearstudio.theory.hypoid.bodies import bodies
from gearstudio.theory.hypoid.conjugate import ConjugateFlank, envelope, pinion_flank
from gearstudio.theory.hypoid.depth import tooth_depth
from gearstudio.theory.hypoid.inputs import HypoidError, HypoidInput
from gearstudio.theory.hypoid.pair import HypoidPair, hypoid_pair
from gearstudio.theory.involute import roll_arc

Floats = NDArray[np.float64]

LEAST_AREA_RATIO = 0.01
_ALONG, _ACROSS = 41, 25
_BEYOND = 0.15
_FINEST = 0.005
_STEEPEST = 30.0


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

    Raises
    ------
    GeometryError
        Points of the wheel's flank never touch the pinion.

    Notes
    -----
    The wheel's whole flank is looked at, from its lower edge to its tip, as far as it generates points between the
    pinion's ends and inside its face cone: a folded part has an image there too.
    """
    generator, pinion = envelope(pair, side), pair.member("pinion", pair.flank_name("pinion", side))
    wheel = generator.wheel.member
    near, far = wheel.lengthwise.reach
    low = max(wheel.inner_cone_distance - _BEYOND * wheel.face_width, near)
    high = min(wheel.outer_cone_distance + _BEYOND * wheel.face_width, far)
    rho = np.linspace(low, high, _ALONG)
    tip = replace(wheel.tip_limit, offset=wheel.tip_limit.offset + raised).at_sphere(rho)
    root = np.maximum(wheel.root_limit.at_sphere(rho), wheel.base_angle)
    psi = roll_arc(root, wheel.base_angle)
    share = np.linspace(0.0, 1.0, _ACROSS)[:, None] ** 0.5
    made = generator.at(psi + share * (roll_arc(tip, wheel.base_angle) - psi), rho)
    distance = np.linalg.norm(made.point, axis=-1)
    delta = np.arctan2(np.hypot(made.point[..., 0], made.point[..., 1]), made.point[..., 2])
    place = (pinion.end_distance(distance, delta) - pinion.inner_cone_distance) / pinion.face_width
    inside = (place >= 0) & (place <= 1) & (delta <= pinion.tip_limit.at_sphere(distance))
    ratio = np.where(inside, made.area_ratio, np.inf)
    worst = np.unravel_index(np.argmin(ratio), ratio.shape)
    return Undercut(side, float(ratio[worst]), float(distance[worst]), float(delta[worst]), float(place[worst]))


def sound_pinion_flank(pair: HypoidPair, name: FlankName, raised: float = 0.0) -> ConjugateFlank:
    """The pinion's conjugate flank, regular over its whole working area.

    Raises
    ------
    HypoidError
        The flank is undercut, or its tip asks for points inside the wheel's base cone: with where, and what cures it.
    """
    side = pair.side("pinion", name)
    trouble = _trouble(pair, side, raised)
    if trouble is not None:
        raise HypoidError("depth.mean_addendum_factor", f"the pinion's {name} flank {trouble}; {_cure(pair)}")
    return pinion_flank(pair, name, raised)


def deepest(pair: HypoidPair, side: int) -> float:
    """How far the flank can go on below the start of contact and stay regular, as `ConjugateFlank.raised` [mm].

    At most the clearance, where it reaches the root.
    """
    shares = np.linspace(1.0, 0.0, 9)
    for share in shares:
        raised = float(share) * pair.depth.clearance
        if _trouble(pair, side, raised) is None:
            return raised
    return 0.0


def is_sound(pair: HypoidPair) -> bool:
    """Whether both conjugate flanks are regular over their working areas."""
    return all(_trouble(pair, side, 0.0) is None for side in (1, -1))


def _trouble(pair: HypoidPair, side: int, raised: float) -> str | None:
    """What is wrong with the flank on a side, or None."""
    try:
        worst = worst_place(pair, side, raised)
    except GeometryError as error:
        return f"does not exist everywhere: {error}"
    if not worst.harmless:
        end = "toe" if worst.place < 1 / 3 else "heel" if worst.place > 2 / 3 else "middle"
        return (
            f"is undercut by the wheel's tips near the {end}, {worst.rho:.5g} mm from the pitch apex at a polar angle "
            f"of {degrees(worst.polar_angle):.5g}° (area ratio {worst.area_ratio:.3g}, must exceed {LEAST_AREA_RATIO:g})"
        )
    flank = pinion_flank(pair, pair.flank_name("pinion", side), raised)
    try:
        psi, _ = flank.coordinates(np.linspace(0.0, 1.0, 5)[:, None], np.linspace(0.0, 1.0, 7))
    except GeometryError as error:
        return f"does not reach everywhere: {error}"
    if np.min(psi) < 0:
        return "meets the wheel inside its base cone with its tips"
    return None


def _cure(pair: HypoidPair) -> str:
    """The change that makes both flanks regular, found by search."""
    now = pair.depth.addenda[1] / pair.depth.working_depth

    def shifted(factor: float) -> HypoidInput:
        return replace(pair.given, depth=replace(pair.given.depth, mean_addendum_factor=factor))

    best = _first(lambda factor: _sound_with(pair, shifted(factor)), _away(now, 0.0, 1.0))
    if best is not None:
        shift = pair.given.depth.depth_factor * (0.5 - best)
        return f"use a mean addendum factor of {best:.3f} (a profile shift of the pinion of {shift:.3g})"
    start = pair.given.pressure_angle_deg
    for factor in (now, 0.3, 0.2, 0.1):
        wanted = shifted(factor)
        steeper = _first(
            lambda angle, wanted=wanted: _sound_with(pair, replace(wanted, pressure_angle_deg=angle)),  # type: ignore[misc]
            list(np.arange(np.ceil(start) + 1, _STEEPEST + 1)),
        )
        if steeper is not None:
            return f"use a pressure angle of {steeper:.4g}° with a mean addendum factor of {factor:.3g}"
    return "use more pinion teeth, a smaller depth factor or a larger spiral angle"


def _away(start: float, low: float, high: float) -> list[float]:
    """Values at growing distance from a start, both ways."""
    grid = np.arange(low, high + _FINEST / 2, 4 * _FINEST)
    return [float(x) for x in grid[np.argsort(np.abs(grid - start))] if abs(x - start) > _FINEST]


def _first(works: Callable[[float], bool], values: list[float]) -> float | None:
    return next((float(value) for value in values if works(float(value))), None)


def _sound_with(pair: HypoidPair, given: HypoidInput) -> bool:
    """Whether the pair with other depths or pressure angles, which leave its pitch cones alone, is sound."""
    try:
        depth = tooth_depth(given, pair.cones)
        return is_sound(HypoidPair(given, pair.cones, depth, bodies(given, pair.cones, depth)))
    except GeometryError:
        return False


def sound_pair(given: HypoidInput) -> HypoidPair:
    """A pair whose conjugate flanks are both regular.

    Raises
    ------
    HypoidError
        As `hypoid_pair` and `sound_pinion_flank`.
    """
    pair = hypoid_pair(given)
    for name in ("concave", "convex"):
        sound_pinion_flank(pair, name)
    return pair
