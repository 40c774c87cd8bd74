"""The involute pinion on its own base cones: the same flank without offset, far off with it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearstudio.theory.flank import FLANKS, FlankName
from gearstudio.theory.hypoid.conjugate import pinion_flank
from gearstudio.theory.hypoid.pair import HypoidPair, hypoid_pair
from gearstudio.theory.involute import roll_arc
from gearstudio.theory.involute_flank import InvoluteFlank
from tests.theory.hypoid.pairs import PAIRS, REFERENCE, reference_input


def own_cone_flank(pair: HypoidPair, name: FlankName) -> InvoluteFlank:
    """The pinion's flank as a spherical involute on a base cone of its own."""
    return InvoluteFlank(pair.member("pinion", name), pair.side("pinion", name))


def ease_off(pair: HypoidPair, name: FlankName, n_u: int = 15, n_v: int = 21) -> np.ndarray:
    """How far it departs from the conjugate flank [mm], plus is metal added, at places above its base cone."""
    own, conjugate = own_cone_flank(pair, name), pinion_flank(pair, name)
    rho, delta, _ = conjugate.locate(conjugate.points(np.linspace(0.0, 1.0, n_u)[:, None], np.linspace(0.0, 1.0, n_v)))
    above = delta >= own.member.base_angle
    return conjugate.deviation(own.points_at(rho[above], delta[above]))


def rms(metal: np.ndarray) -> float:
    return float(np.sqrt(np.mean(metal**2)))


def extreme(metal: np.ndarray) -> float:
    """The largest, with its sign."""
    return float(metal[np.argmax(np.abs(metal))])


@pytest.mark.parametrize("name", FLANKS)
def test_no_ease_off_without_offset(name: FlankName) -> None:
    assert np.abs(ease_off(hypoid_pair(PAIRS["bevel"]), name)).max() < 1e-10


@pytest.mark.parametrize(
    ("index", "drive", "coast", "largest"),
    [(1, 54, 57, 193), (2, 129, 137, 552), (4, 119, 133, 554), (5, 99, 109, 372)],
)
def test_known_ease_off(index: int, drive: float, coast: float, largest: float) -> None:
    """Within the mesh area the figures are 10 to 35 % below those of the whole flank."""
    pair = hypoid_pair(reference_input(REFERENCE[index]))
    found = [ease_off(pair, name) for name in ("concave", "convex")]
    assert drive < 1e3 * rms(found[0]) < 1.4 * drive and coast < 1e3 * rms(found[1]) < 1.4 * coast
    assert max(abs(1e3 * extreme(metal)) for metal in found) == pytest.approx(largest, rel=0.06)
    assert extreme(found[0]) > 0  # too much metal on the drive flank: interference, not relief


def test_touches_at_the_mean_point() -> None:
    for offset in (15.0, -10.0):
        pair = hypoid_pair(replace(PAIRS["axle"], offset=offset))
        for name in FLANKS:
            own = own_cone_flank(pair, name)
            point = own.points_at(pair.cones.pinion.mean_cone_distance, pair.cones.pinion.angle)
            conjugate = pinion_flank(pair, name)
            assert conjugate.deviation(point) == pytest.approx(0.0, abs=1e-12)
            normal = own.normals_at(roll_arc(pair.cones.pinion.angle, own.member.base_angle), own.locate(point)[0])
            assert np.abs(conjugate.normals_at(*conjugate.natural(point)) - normal).max() < 1e-10
            assert abs(extreme(ease_off(pair, name, 3, 3))) > 1e-3
