"""The involute pinion on its own base cones: the same flank without offset, far off with it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearstudio.theory.flank import FLANKS, FlankName
from gearstudio.theory.hypoid.conjugate import pinion_flank
from gearstudio.theory.hypoid.own_cone import own_cone_ease_off, own_cone_flank
from gearstudio.theory.hypoid.pair import hypoid_pair
from gearstudio.theory.involute import roll_arc
from tests.theory.hypoid.pairs import PAIRS, REFERENCE, reference_input


@pytest.mark.parametrize("name", FLANKS)
def test_no_ease_off_without_offset(name: FlankName) -> None:
    assert np.abs(own_cone_ease_off(hypoid_pair(PAIRS["bevel"]), name).metal).max() < 1e-10


@pytest.mark.parametrize(
    ("index", "drive", "coast", "extreme"),
    [(1, 54, 57, 193), (2, 129, 137, 552), (4, 119, 133, 554), (5, 99, 109, 372)],
)
def test_known_ease_off(index: int, drive: float, coast: float, extreme: float) -> None:
    """Within the mesh area the figures are 10 to 35 % below those of the whole flank."""
    pair = hypoid_pair(reference_input(REFERENCE[index]))
    found = [own_cone_ease_off(pair, name) for name in ("concave", "convex")]
    assert drive < 1e3 * found[0].rms < 1.4 * drive and coast < 1e3 * found[1].rms < 1.4 * coast
    assert max(abs(1e3 * e.extreme) for e in found) == pytest.approx(extreme, rel=0.06)
    assert found[0].extreme > 0  # too much metal on the drive flank: interference, not relief


def test_touches_at_the_mean_point() -> None:
    for offset in (15.0, -10.0):
        pair = hypoid_pair(replace(PAIRS["axle"], offset=offset))
        for name in FLANKS:
            own = own_cone_flank(pair, name)
            ease = own_cone_ease_off(pair, name, 3, 3)
            point = own.points_at(pair.cones.pinion.mean_cone_distance, pair.cones.pinion.angle)
            conjugate = pinion_flank(pair, name)
            assert conjugate.deviation(point) == pytest.approx(0.0, abs=1e-12)
            normal = own.normals_at(roll_arc(pair.cones.pinion.angle, own.member.base_angle), own.locate(point)[0])
            assert np.abs(conjugate.normals_at(*conjugate.natural(point)) - normal).max() < 1e-10
            assert abs(ease.extreme) > 1e-3
