"""Every method and variant on both members: how far from theory, where the edges are, what refining does."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from gearstudio.analysis.comparison import build_variant
from gearstudio.catalogue import MEMBERS, VARIANTS
from gearstudio.design import Design, with_field
from gearstudio.errors import ModellingError
from gearstudio.methods import METHODS, Target
from gearstudio.methods.base import Refinement
from gearstudio.methods.rolled import rolled, stretches_of
from gearstudio.nurbs import NurbsSurface
from gearstudio.presets import PRESETS
from gearstudio.results import FlankResult
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.involute import generating_line
from gearstudio.theory.involute_flank import InvoluteFlank, involute_flank
from tests.designs import GOLDEN
from tests.strategies import is_valid
from tests.theory.members import CORNERS, made

pytestmark = pytest.mark.kernel

# Offset axes have tests of their own: tests/hypoid.
DESIGNS = {name: design for name, (design, _) in GOLDEN.items()}
DESIGNS |= {p.key: p.design for p in PRESETS if not p.design.pair.offset}
# A tooth much higher than wide, an arc that all but misses the heel, teeth that wind round a needle, a flat wheel.
DESIGNS |= CORNERS | {
    "high": made(pinion_teeth=5, wheel_teeth=5, shaft_angle_deg=150.0, outer_module=100.0, face_width_factor=0.01,
                 pressure_angle_deg=35.0, addendum_factor=0.3, clearance_factor=0.1, cutter_radius=1e5, ends="sphere"),
    "grazing": made(pinion_teeth=14, wheel_teeth=99, shaft_angle_deg=30.0, outer_module=10.0, face_width_factor=0.5,
                    spiral_angle_deg=41.0, cutter_radius=500.0, addendum_factor=0.5),
    "winding": made(pinion_teeth=5, wheel_teeth=112, shaft_angle_deg=30.0, curve="archimedean", spiral_angle_deg=55.0,
                    face_width_factor=0.48, addendum_factor=0.3, pressure_angle_deg=25.0),
}  # fmt: skip
over_methods = pytest.mark.parametrize("method", METHODS, ids=[m.info.id for m in METHODS])
over_members = pytest.mark.parametrize("member", MEMBERS)
over_designs = pytest.mark.parametrize("name", DESIGNS)

# Not the places that a build looks at: denser, of another spacing, all edges and close to them.
FINE = np.unique(np.r_[np.linspace(0.0, 1.0, 97) ** 1.07, 1e-5, 1e-3, 1 - 1e-5, 1 - 1e-3])


def allowed_um(design: Design) -> float:
    """The tolerance, in proportion beyond an outer cone distance of 250 mm."""
    outer = pair_geometry(design).pinion.outer_cone_distance
    return design.methods.tolerance_um * max(1.0, outer / 250.0)


def flank_of(design: Design, member: str, result: FlankResult) -> InvoluteFlank:
    return involute_flank(pair_geometry(design).member(member), result.flank)


def worst_um(flank: InvoluteFlank, surface: NurbsSurface) -> tuple[float, float]:
    """Largest deviation and farthest edge, looked at finely."""
    points = surface.grid(FINE, FINE)
    return float(np.abs(flank.deviation(points)).max()) * 1e3, flank.edge_deviation(points) * 1e3


@over_methods
@over_members
@over_designs
def test_optimised_is_within_tolerance_up_to_its_edges(name: str, member: str, method) -> None:
    design = DESIGNS[name]
    result = build_variant(design, member, method.info.id, "optimised")
    assert set(result.flanks) == set(FLANKS)
    for flank_result in result.flanks.values():
        flank = flank_of(design, member, flank_result)
        deviation, edge = worst_um(flank, flank_result.surface)
        assert deviation <= allowed_um(design)
        assert edge <= allowed_um(design)
        assert flank_result.statistics.max_um <= allowed_um(design)
        delta = flank.locate(flank_result.surface.grid(FINE, FINE))[1]
        below_um = (flank.member.base_angle - delta.min()) * flank.member.outer_cone_distance * 1e3
        assert below_um <= allowed_um(design)  # nothing beyond the cuspidal edge


@over_methods
@over_members
@over_designs
def test_published_is_built_and_measured(name: str, member: str, method) -> None:
    """On ordinary designs, wrong by more than a tenth of the module would be another flank or another place."""
    design = DESIGNS[name]
    result = build_variant(design, member, method.info.id, "published")
    for flank_result in result.flanks.values():
        assert np.all(np.isfinite(flank_result.deviation_um))
    if name not in ("needle", "grazing", "winding", "steep"):
        assert 0 < result.statistics.max_um < 100 * design.pair.outer_module


@over_designs
def test_the_designs_of_these_tests_are_valid(name: str) -> None:
    assert is_valid(DESIGNS[name])


@over_methods
@over_members
@pytest.mark.parametrize("variant", VARIANTS)
def test_the_result_says_what_was_built(method, member: str, variant: str) -> None:
    design = Design()
    result = build_variant(design, member, method.info.id, variant, samples=(41, 43))
    assert (result.member, result.method, result.variant) == (member, method.info.id, variant)
    values = np.concatenate([f.deviation_um.ravel() for f in result.flanks.values()])
    assert result.statistics.max_um == np.abs(values).max()
    assert result.statistics.mean_um == pytest.approx(np.abs(values).mean())
    assert result.statistics.rms_um == pytest.approx(np.sqrt((values**2).mean()))
    assert (result.statistics.lowest_um, result.statistics.highest_um) == (values.min(), values.max())
    assert result.seconds > 0 and result.settings
    for flank_result in result.flanks.values():
        surface, flank = flank_result.surface, flank_of(design, member, flank_result)
        assert flank_result.points.shape == (41, 43, 3)
        assert surface.bounds == (0.0, 1.0, 0.0, 1.0)
        corners = surface.grid([0.0, 1.0], [0.0, 1.0])
        assert np.abs(corners - flank.points([[0.0], [1.0]], [[0.0, 1.0]])).max() < 0.3  # root to tip, toe to heel
        assert surface.poles.shape[0] <= result.poles[0] or surface.poles.shape[1] <= result.poles[1]
        assert flank_result.curves


@over_methods
@over_members
def test_normals_of_the_surface_point_one_way(method, member: str) -> None:
    """No fold anywhere, also next to the base cone where the profile's derivative vanishes."""
    for variant in VARIANTS:
        result = build_variant(Design(), member, method.info.id, variant)
        for flank_result in result.flanks.values():
            flank = flank_of(Design(), member, flank_result)
            points = flank_result.surface.grid(FINE, FINE)
            across, along = np.diff(points, axis=0)[:, :-1], np.diff(points, axis=1)[:-1]
            faced = np.sum(np.cross(across, along) * flank.normals(0.5, 0.5), axis=-1)
            assert np.all(faced * np.sign(faced.sum()) > 0), variant


@over_methods
def test_published_takes_no_notice_of_the_tolerance(method) -> None:
    built = [
        build_variant(with_field(Design(), "methods.tolerance_um", t), "pinion", method.info.id, "published")
        for t in (0.001, 5.0)
    ]
    for name in FLANKS:
        assert np.array_equal(built[0].flanks[name].surface.poles, built[1].flanks[name].surface.poles)
    assert built[0].settings == built[1].settings


@over_methods
@over_members
def test_a_tighter_tolerance_gives_a_smaller_deviation(method, member: str) -> None:
    reached = []
    for tolerance in (20.0, 0.5, 0.02, 0.001):
        design = with_field(Design(), "methods.tolerance_um", tolerance)
        result = build_variant(design, member, method.info.id, "optimised")
        worst = [worst_um(flank_of(design, member, f), f.surface) for f in result.flanks.values()]
        assert np.max(worst) <= tolerance
        reached.append(result.statistics.max_um)
    assert all(later <= earlier for earlier, later in pairwise(reached))
    assert reached[-1] < reached[0]


@pytest.mark.parametrize("degree", [2, 3, 4, 5, 8])
def test_degree_of_the_point_cloud(degree: int) -> None:
    design = with_field(Design(), "methods.point_cloud_degree", degree)
    result = build_variant(design, "pinion", "point_cloud", "optimised")
    assert result.degree == (degree, degree)
    for flank_result in result.flanks.values():
        assert max(worst_um(flank_of(design, "pinion", flank_result), flank_result.surface)) <= 0.05


def test_published_settings_are_those_of_the_paper() -> None:
    settings = {m.info.id: build_variant(Design(), "wheel", m.info.id, "published").settings for m in METHODS}
    assert settings["rotating_line"]["positions"] == 5
    assert settings["profile_sweep"]["sections"] == 2
    assert settings["point_cloud"]["grid"] == [7, 7]
    assert build_variant(Design(), "wheel", "point_cloud", "optimised").settings["grid"] == [12, 14]


@over_methods
@pytest.mark.parametrize("curve", ["archimedean", "logarithmic"])
@pytest.mark.parametrize("wheel_teeth", [112, 200])
def test_teeth_of_many_turns_are_followed_to_a_nanometre(wheel_teeth: int, curve: str, method) -> None:
    design = made(pinion_teeth=5, wheel_teeth=wheel_teeth, shaft_angle_deg=30.0, curve=curve, spiral_angle_deg=55.0,
                  face_width_factor=0.5, addendum_factor=0.6, clearance_factor=0.2)  # fmt: skip
    assert is_valid(design)
    member = pair_geometry(design).pinion
    flank, target = involute_flank(member, "convex"), Target.for_cone_distance(0.001, member.outer_cone_distance)
    surface = method.build(flank, "optimised", target).surface
    points = surface.grid(np.linspace(0.0, 1.0, 23) ** 1.05, np.linspace(0.0, 1.0, 3001))
    assert np.abs(flank.deviation(points)).max() <= target.tolerance
    assert flank.edge_deviation(points) <= target.tolerance


def test_stretches_of_the_roll_meet_and_take_short_pieces_of_the_line() -> None:
    flank = involute_flank(pair_geometry(DESIGNS["winding"]).pinion, "concave")
    count = stretches_of(flank)
    patch = rolled(flank, 11, 15, 1e-6, count)
    assert count == len(patch.stretches) > 5
    assert len(patch.positions) == 14 * count + 1
    width = flank.member.face_width
    for first, second in pairwise(patch.stretches):
        assert first.roll[1] == second.roll[0]
        assert max(s.rho[1] - s.rho[0] for s in (first, second)) < 0.5 * width
        rho = np.linspace(second.rho[0], first.rho[1], 9)
        exact = generating_line(flank.member, flank.side, rho, first.roll[1])
        for stretch in (first, second):
            assert np.abs(stretch.at(rho, np.full(9, first.roll[1])) - exact).max() < 5e-5
    assert stretches_of(involute_flank(pair_geometry(Design()).pinion, "concave")) == 1


@over_methods
def test_positions_and_sections_lie_on_the_flank_they_are_made_from(method) -> None:
    flank = involute_flank(pair_geometry(Design()).wheel, "concave")
    for variant in VARIANTS:
        built = method.build(flank, variant, Target(5e-5))
        for curve in built.curves:
            if curve.kind != "position":  # positions of the generating line reach beyond the flank
                assert np.abs(flank.deviation(curve.points)).max() < 1e-10


def test_one_to_two_hundred_and_fifty_millimetres_share_a_tolerance() -> None:
    assert Target.for_cone_distance(0.05, 1.0).tolerance == pytest.approx(5e-5)
    assert Target.for_cone_distance(0.05, 250.0).tolerance == pytest.approx(5e-5)
    assert Target.for_cone_distance(0.05, 1000.0).tolerance == pytest.approx(2e-4)


def test_a_goal_out_of_reach_is_said() -> None:
    refinement = Refinement("point_cloud", 1e-9, (2,))
    with pytest.raises(ModellingError, match="remained with 1600 nodes"):
        refinement.run((10,), lambda counts: (None, (1.0,)))  # type: ignore[arg-type,return-value]
