"""Rolling a pair numerically from the points of its flanks and the members' places, by nothing else."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.hypoid.conjugate import pinion_flank, wheel_flank
from gearstudio.theory.hypoid.pair import HypoidPair
from gearstudio.theory.involute_flank import InvoluteFlank
from tests.theory.hypoid.pairs import in_world

Floats = NDArray[np.float64]
ARCSEC = np.pi / 180 / 3600


@dataclass(frozen=True)
class Roll:
    """One side of a pair rolled through its mesh.

    Attributes
    ----------
    error : list of float
        Least angle [rad] by which the wheel would have to turn to touch, per position.
    overlap : float
        Deepest that any pinion point is inside the wheel [mm], negative, or the least gap.
    """

    error: list[float]
    overlap: float


def lag(pair: HypoidPair, wheel: InvoluteFlank, points: Floats, turn: float) -> tuple[Floats, Floats]:
    """Angle [rad] by which the wheel must turn to touch pinion points, and the height over it [mm] per such angle.

    Points outside the wheel's tooth get infinity.
    """
    world = in_world(pair.axes, points, turn)
    matrix, shift = pair.axes.wheel_placement(pair.given.wheel_teeth, -turn / pair.ratio)
    rho, delta, phi = wheel.locate((world - shift) @ matrix)
    member, side = wheel.member, wheel.side
    place = (member.end_distance(rho, delta) - member.inner_cone_distance) / member.face_width
    low, tip = wheel.limits(np.clip(place, 0.0, 1.0))
    inside = (place >= 0) & (place <= 1) & (delta <= tip) & (delta >= low)
    gap = side * (phi - wheel.azimuth(rho, np.clip(delta, member.base_angle, np.pi / 2)))
    gap += (1 + side) / 2 * member.pitch  # the space stands between tooth 0 and the one before it
    gap = np.remainder(gap + np.pi, 2 * np.pi) - np.pi
    return np.where(inside, gap, np.inf), rho * np.sin(delta)


def roll(pair: HypoidPair, side: int, positions: int = 9, shape: tuple[int, int] = (31, 41)) -> Roll:
    """Roll a side; the deepest points of every column are refined by parabolas."""
    pinion = pinion_flank(pair, pair.flank_name("pinion", side))
    wheel = wheel_flank(pair, pair.flank_name("wheel", side))
    u, v = np.linspace(0.0, 1.0, shape[0]), np.linspace(0.0, 1.0, shape[1])
    psi, rho = pinion.coordinates(u[:, None], v)
    points = pinion.at(psi, rho)
    on_wheel = (rho > wheel.member.inner_cone_distance) & (rho < wheel.member.outer_cone_distance)
    turns = -pair.ratio * pinion.envelope.at(psi, rho).wheel_turn[on_wheel]
    errors, overlap = [], np.inf
    for turn in np.quantile(turns, np.linspace(0.03, 0.97, positions)):
        gap, lever = lag(pair, wheel, points, float(turn))
        overlap = min(overlap, float(np.min(gap * lever)))
        best = u[np.clip(np.argmin(gap, axis=0), 1, shape[0] - 2)]
        step, least = 1 / (shape[0] - 1), np.min(gap)
        for _ in range(4):
            near = np.stack([best - step, best, best + step])
            a, b, c = lag(pair, wheel, pinion.points(near, v), float(turn))[0]
            with np.errstate(invalid="ignore", divide="ignore"):
                move = step * (a - c) / (2 * (a - 2 * b + c))
            best = np.clip(best + np.where(np.isfinite(move), np.clip(move, -step, step), 0.0), step, 1 - step)
            step = step / 6
        errors.append(float(min(least, np.min(lag(pair, wheel, pinion.points(best, v), float(turn))[0]))))
    return Roll(errors, overlap)
