"""Random designs over the whole permitted range: the promise of the optimised variants, kept everywhere."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, given, settings

from gearstudio.catalogue import MEMBERS
from gearstudio.design import Design
from gearstudio.methods import METHODS, Target
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.involute_flank import involute_flank
from tests.strategies import designs

pytestmark = pytest.mark.kernel

FINE = np.unique(np.r_[np.linspace(0.0, 1.0, 53) ** 1.05, 1e-4, 1 - 1e-4])
unhurried = {
    "deadline": None,
    "derandomize": True,
    "database": None,
    "phases": (Phase.generate,),
    "suppress_health_check": list(HealthCheck),
}


@pytest.mark.timeout(600)
@settings(max_examples=200, **unhurried)
@given(designs())
def test_optimised_is_within_tolerance(design: Design) -> None:
    for name in MEMBERS:
        member = pair_geometry(design).member(name)
        target = Target.for_cone_distance(0.05, member.outer_cone_distance)
        limit = 5e-5 * max(1.0, member.outer_cone_distance / 250.0)
        for method in METHODS:
            for flank_name in FLANKS:
                flank = involute_flank(member, flank_name)
                points = method.build(flank, "optimised", target).surface.grid(FINE, FINE)
                assert np.abs(flank.deviation(points)).max() <= limit, (name, method.info.id)
                assert flank.edge_deviation(points) <= limit, (name, method.info.id)


@pytest.mark.timeout(300)
@settings(max_examples=25, **unhurried)
@given(designs())
def test_published_can_be_built_and_measured(design: Design) -> None:
    member = pair_geometry(design).pinion
    for method in METHODS:
        flank = involute_flank(member, "convex")
        built = method.build(flank, "published", Target(5e-5))
        points = built.surface.grid(FINE, FINE)
        assert np.all(np.isfinite(points))
        assert np.all(np.isfinite(flank.deviation(points)))
