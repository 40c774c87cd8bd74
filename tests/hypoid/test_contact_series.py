"""The series of a flank against the flank itself, and the grid that no misalignment changes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings

from gearstudio.analysis.contact import one_direction
from gearstudio.analysis.contact_grid import pinion_grid
from gearstudio.analysis.contact_placing import Misalignment, flank_mesh
from gearstudio.analysis.contact_series import flank_series
from gearstudio.design import Design
from gearstudio.presets import PRESETS
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.modified import flank_of, swept_on
from tests.strategies import offset_designs

BY_KEY = {preset.key: preset.design for preset in PRESETS}
TAKEN = {"lengthwise_crowning_um": 30.0, "bias_um": -8.0, "tip_relief_um": 20.0, "tip_relief_start": 0.7}
RANDOM = np.random.default_rng(5)
U, V = RANDOM.random((7, 30)), RANDOM.random((7, 30))


def relieved(design: Design) -> Design:
    """The design with micro-geometry on both members' flanks."""
    both = {member: dict.fromkeys(FLANKS, TAKEN) for member in ("pinion", "wheel")}
    return Design.model_validate({**design.model_dump(), "modifications": both})


@pytest.mark.parametrize("modify", [False, True])
@pytest.mark.parametrize("key", ["default", "zerol", "hypoid-car", "hypoid-truck", "hypoid-negative"])
def test_a_series_is_its_flank(key: str, modify: bool) -> None:
    design = relieved(BY_KEY[key]) if modify else BY_KEY[key]
    pinion = pair_geometry(design).pinion
    for name in FLANKS:
        for flank in (flank_of(pinion, name), swept_on(pinion, 1)):
            series = flank_series(flank)
            assert series is not None
            assert np.abs(series.points(U, V) - flank.points(U, V)).max() < 1e-12 * pinion.outer_cone_distance


@settings(max_examples=8, deadline=None, suppress_health_check=list(HealthCheck))
@given(offset_designs())
def test_series_of_random_conjugate_flanks(design: Design) -> None:
    pinion = pair_geometry(design).pinion
    for name in FLANKS:
        flank = flank_of(pinion, name)
        series = flank_series(flank)
        if series is not None:
            assert np.abs(series.points(U, V) - flank.points(U, V)).max() < 2e-12 * pinion.outer_cone_distance


def test_a_flank_that_polynomials_do_not_follow_is_asked_itself() -> None:
    """The root cone of this one leaves the base cone at the toe: the rolled arc grows as a square root."""
    pair = pair_geometry(BY_KEY["uniform-depth"])
    assert flank_series(flank_of(pair.pinion, "concave")) is None
    grid = pinion_grid(flank_mesh(pair, "concave"), (5, 7))
    assert np.array_equal(grid.points_near(U, V), grid.flank.points(U, V))


@pytest.mark.parametrize("key", ["default", "hypoid-car"])
def test_a_grid_is_laid_once_for_all_misalignments(key: str) -> None:
    pair = pair_geometry(BY_KEY[key])
    still, moved = (pinion_grid(flank_mesh(pair, "concave", m), (9, 11)) for m in (None, Misalignment(offset=0.1)))
    assert still.nodes is moved.nodes and not still.nodes.flags.writeable
    assert moved.mesh.misalignment == Misalignment(offset=0.1)
    assert pinion_grid(flank_mesh(pair, "convex"), (9, 11)).nodes is not still.nodes


@pytest.mark.parametrize("key", ["default", "hypoid-car"])
def test_series_and_flank_give_the_same_contact(key: str, monkeypatch: pytest.MonkeyPatch) -> None:
    pair, misalignment = pair_geometry(relieved(BY_KEY[key])), Misalignment(0.03, -0.02, 0.01, 0.02)
    with_series = one_direction(pair, "drive", misalignment, points=(21, 31), positions=16)
    monkeypatch.setattr("gearstudio.analysis.contact_grid.PinionGrid.points_near", lambda grid, u, v: grid.points(u, v))
    without = one_direction(pair, "drive", misalignment, points=(21, 31), positions=16)
    assert with_series.error_arcsec == pytest.approx(without.error_arcsec, abs=1e-7)
    assert with_series.pattern_share == without.pattern_share


def test_relief_changes_the_grid() -> None:
    plain = pair_geometry(BY_KEY["default"])
    other = replace(plain, pinion=pair_geometry(relieved(BY_KEY["default"])).pinion)
    grids = [pinion_grid(flank_mesh(pair, "concave"), (9, 11)) for pair in (plain, other)]
    assert np.abs(grids[0].nodes - grids[1].nodes).max() > 1e-3
