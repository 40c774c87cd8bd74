"""Whether a pair's flanks are regular and its teeth have tips, and the change that would make them so."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import copysign, degrees

import numpy as np

from gearstudio.errors import GeometryError
from gearstudio.theory.flank import FLANKS, FlankName
from gearstudio.theory.hypoid.bodies import bodies
from gearstudio.theory.hypoid.conjugate import ConjugateFlank, pinion_flank, wheel_flank
from gearstudio.theory.hypoid.depth import tooth_depth
from gearstudio.theory.hypoid.inputs import HypoidError, HypoidInput, MemberName
from gearstudio.theory.hypoid.pair import HypoidPair, hypoid_pair
from gearstudio.theory.hypoid.undercut import LEAST_AREA_RATIO, worst_place

MEMBERS: tuple[MemberName, MemberName] = ("pinion", "wheel")

_STEP, _FINE_STEPS = 0.04, 4
_STEP_DEG, _STEEPEST_DEG = 5.0, 30.0
_RAISED = (3.0, 2.5, 2.25, 2.0, 1.75, 1.5, 1.25, 1.0, 0.75, 0.5, 0.25)
_SHALLOWER = (0.9, 0.75, 0.6)
_COARSE = (0.5, 0.4, 0.3, 0.25, 0.2, 0.1)


def sound_pinion_flank(pair: HypoidPair, name: FlankName, raised: float = 0.0) -> ConjugateFlank:
    """The pinion's conjugate flank, regular over its whole working area.

    Raises
    ------
    HypoidError
        The flank is undercut, or its tip asks for points inside the wheel's base cone: with where, and what cures it.
    """
    side = pair.side("pinion", name)
    wrong = trouble(pair, side, raised)
    if wrong is not None:
        raise HypoidError("depth.mean_addendum_factor", f"the pinion's {name} flank {wrong}; {_cure(pair)}")
    return pinion_flank(pair, name, raised)


def deepest(pair: HypoidPair, side: int) -> float:
    """How far the flank can go on below the start of contact, as `ConjugateFlank.raised` [mm].

    It stays regular and above the pinion's root cone; 0 where it can go no further.
    """
    v = np.linspace(0.0, 1.0, 9)
    for share in _RAISED:
        raised = share * pair.depth.clearance
        if trouble(pair, side, raised) is None:
            flank = pinion_flank(pair, pair.flank_name("pinion", side), raised)
            m = flank.member
            root = m.limit_angle(m.root_limit, m.inner_cone_distance + v * m.face_width)
            if np.all(flank.limits(v)[0] > root):
                return raised
    return 0.0


def is_sound(pair: HypoidPair) -> bool:
    """Whether both conjugate flanks are regular over their working areas and no tooth is pointed."""
    return all(trouble(pair, side, 0.0) is None for side in (1, -1)) and all(
        least_top_land(pair, name) > 0 for name in MEMBERS
    )


def least_top_land(pair: HypoidPair, name: MemberName) -> float:
    """Narrowest place of a member's tip, along its circle from flank to flank [mm]; not positive is pointed.

    Raises
    ------
    GeometryError
        A flank does not reach the tip.
    """
    v = np.linspace(0.0, 1.0, 7)
    widths = []
    for flank in FLANKS:
        edge = (wheel_flank(pair, flank) if name == "wheel" else pinion_flank(pair, flank)).points(1.0, v)
        widths.append(np.hypot(edge[:, 0], edge[:, 1]) * pair.side(name, flank) * np.arctan2(edge[:, 1], edge[:, 0]))
    return float(np.min(widths[0] + widths[1]))


def trouble(pair: HypoidPair, side: int, raised: float = 0.0) -> str | None:
    """What is wrong with the pinion's flank on a side, or None; without the search for a cure."""
    worst = worst_place(pair, side, raised)
    if not worst.harmless:
        end = "toe" if worst.place < 1 / 3 else "heel" if worst.place > 2 / 3 else "middle"
        return (
            f"is undercut near the {end}, {worst.rho:.5g} mm from the pitch apex, polar angle "
            f"{degrees(worst.polar_angle):.5g}° (area ratio {worst.area_ratio:.3g}, must exceed {LEAST_AREA_RATIO:g})"
        )
    flank = pinion_flank(pair, pair.flank_name("pinion", side), raised)
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


def _cure(pair: HypoidPair) -> str:
    """The change that makes both flanks regular, found by search."""
    now = pair.depth.addenda[1] / pair.depth.working_depth

    def shifted(factor: float) -> HypoidInput:
        return replace(pair.given, depth=replace(pair.given.depth, mean_addendum_factor=factor))

    best = _first(lambda factor: _sound_with(pair, shifted(factor)), _away(now, 0.0, 1.0))
    if best is not None:
        step = copysign(_STEP / _FINE_STEPS, now - best)
        back = [round(best + k * step, 3) for k in range(_FINE_STEPS - 1, 0, -1)]
        best = _first(lambda factor: _sound_with(pair, shifted(factor)), back) or best
        shift = pair.given.depth.depth_factor * (0.5 - best)
        return f"use a mean addendum factor of {best:.3f} (a profile shift of the pinion of {shift:.3g})"
    near = sorted(_COARSE, key=lambda x: abs(x - now))
    start = pair.given.pressure_angle_deg
    for angle in np.arange(np.ceil(start / _STEP_DEG + 0.2) * _STEP_DEG, _STEEPEST_DEG + _STEP_DEG / 2, _STEP_DEG):
        for factor in near:
            if _sound_with(pair, replace(shifted(factor), pressure_angle_deg=float(angle))):
                return f"use a pressure angle of {angle:.4g}° with a mean addendum factor of {factor:.3g}"
    for depth in (round(share * pair.given.depth.depth_factor, 2) for share in _SHALLOWER):
        for factor in near:
            wanted = shifted(factor)
            if _sound_with(pair, replace(wanted, depth=replace(wanted.depth, depth_factor=depth))):
                return f"use a depth factor of {depth:.2f} with a mean addendum factor of {factor:.3g}"
    return "use more pinion teeth or a larger spiral angle"


def _away(start: float, low: float, high: float) -> list[float]:
    """Values at growing distance from a start, both ways."""
    grid = np.arange(low, high + _STEP / 2, _STEP)
    return [round(float(x), 3) for x in grid[np.argsort(np.abs(grid - start))] if abs(x - start) > _STEP / 4]


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
    """A pair whose conjugate flanks are both regular and whose teeth are not pointed.

    Raises
    ------
    HypoidError
        As `hypoid_pair` and `sound_pinion_flank`.
    """
    pair = hypoid_pair(given)
    for flank in FLANKS:
        sound_pinion_flank(pair, flank)
    for name in MEMBERS:
        land = least_top_land(pair, name)
        if land <= 0:
            raise HypoidError(
                "depth.mean_addendum_factor",
                f"the {name}'s teeth are pointed ({land:.3g} mm at the tip); {_cure(pair)}",
            )
    return pair
