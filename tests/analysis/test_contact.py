"""Tooth contact: the perfect pair, invariances, known ease-offs, misalignments, independent distances."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from scipy.optimize import least_squares

from gearstudio.analysis.contact import contact_analysis, contact_table
from gearstudio.analysis.contact_grid import pinion_grid
from gearstudio.analysis.contact_placing import FlankMesh, Misalignment, flank_mesh
from gearstudio.analysis.contact_result import DIRECTIONS, ContactResult
from gearstudio.analysis.contact_roll import Roll
from gearstudio.analysis.ease_off import ease_off
from gearstudio.design import Design
from gearstudio.errors import GeometryError
from gearstudio.theory.cones import PairGeometry, pair_geometry
from gearstudio.theory.flank import FLANKS, FlankName
from gearstudio.theory.pair import (
    about_axis,
    pinion_placement,
    transverse_contact_ratio,
    wheel_placement,
)
from gearstudio.validation import check
from tests.designs import GOLDEN
from tests.strategies import designs

Floats = np.ndarray
DEFAULT = Design()
PAIR = pair_geometry(DEFAULT)
OTHERS = {
    "constant clearance": {"tooth": {"tip_cone": "constant_clearance", "profile_shift": 0.3}},
    "backlash": {"tooth": {"backlash": 0.2}},
    "logarithmic, right": {"pair": {"pinion_hand": "right"}, "lengthwise": {"curve": "logarithmic"}},
    "large module": {"pair": {"outer_module": 30.0}, "lengthwise": {"cutter_radius": 600.0}},
}
DESIGNS = {name: design for name, (design, _) in GOLDEN.items()} | {
    name: Design.model_validate(data) for name, data in OTHERS.items()
}
MISALIGNMENTS = [
    Misalignment(offset=0.05),
    Misalignment(pinion_axial=-0.04),
    Misalignment(wheel_axial=0.06),
    Misalignment(0.03, 0.05, -0.02, 0.04),
]


def crowned(
    lengthwise_um: float, profile_um: float = 0.0, member: str = "pinion", of: Design = DEFAULT
) -> PairGeometry:
    """A pair with both flanks of a member crowned by given heights."""
    one = {"lengthwise_crowning_um": lengthwise_um, "profile_crowning_um": profile_um}
    modifications = {member: dict.fromkeys(FLANKS, one)}
    return pair_geometry(Design.model_validate({**of.model_dump(), "modifications": modifications}))


@pytest.mark.parametrize("name", DESIGNS)
def test_perfect_pair_has_no_transmission_error(name: str) -> None:
    pair = pair_geometry(DESIGNS[name])
    result = contact_analysis(pair)
    for direction in DIRECTIONS:
        side = result.direction(direction)
        assert side.peak_to_peak_arcsec <= 0.01
        assert np.ptp(side.turn_deg) == pytest.approx(3 * 360 / pair.pinion.teeth)
        assert np.abs(side.error_arcsec).max() <= 0.01
        assert side.roll.lag.min() >= flank_mesh(pair, side.pinion.flank).play - 1e-9, "the flanks cross"
        assert side.pattern_share == 1
        assert side.path.edges == ()
    assert result.warnings == ()


@pytest.mark.parametrize("name", DESIGNS)
def test_ease_off_of_the_perfect_pair_is_flat(name: str) -> None:
    for side in (contact_analysis(pair_geometry(DESIGNS[name])).direction(d) for d in DIRECTIONS):
        assert np.abs(side.ease_off_um[np.isfinite(side.pinion.gap_um)]).max() < 1e-5 * max(1.0, side.pinion.rho.max())


@pytest.mark.parametrize("name", DESIGNS)
def test_contact_ratio_is_the_one_of_theory(name: str) -> None:
    pair = pair_geometry(DESIGNS[name])
    wheel = pair.wheel
    rho = np.linspace(wheel.inner_cone_distance, wheel.outer_cone_distance, 501)
    theory = transverse_contact_ratio(pair) + np.ptp(wheel.lengthwise.azimuth(rho)) / wheel.pitch
    found = [contact_analysis(pair).direction(direction).contact_ratio for direction in DIRECTIONS]
    if DESIGNS[name].tooth.tip_cone == "common_apex":
        assert found == pytest.approx([theory, theory], rel=0.015)
    else:
        assert max(found) < theory


@pytest.mark.parametrize("name", ["default", "obtuse-logarithmic"])
def test_contact_turn_is_where_the_flanks_touch(name: str) -> None:
    pair = pair_geometry(DESIGNS[name])
    for flank in FLANKS:
        mesh = flank_mesh(pair, flank)
        u, v = np.meshgrid(np.linspace(0.4, 1, 7), np.linspace(0.1, 0.9, 5), indexing="ij")
        turn = mesh.contact_turn(*mesh.pinion_flank.coordinates(u, v))
        lag = [mesh.meet(mesh.pinion_flank.points(u, v), turn + d).lag for d in (-1e-3, 0, 1e-3)]
        assert np.abs(lag[1]).max() < 1e-13
        assert np.all(lag[0] > 0) and np.all(lag[2] > 0)


def test_placing_agrees_with_the_pair_of_theory() -> None:
    """Built a second time from rotation matrices: the world azimuth of the point less that of the wheel's flank."""
    for flank in FLANKS:
        mesh = flank_mesh(PAIR, flank)
        points = mesh.pinion_flank.points(np.linspace(0.3, 1, 5), np.linspace(0, 1, 5))
        for turn in (-0.2, 0.1):
            world = points @ pinion_placement(PAIR, turn).T
            own = world @ wheel_placement(PAIR, turn) @ about_axis(-(1 + mesh.side) / 2 * PAIR.wheel.pitch)
            rho, delta, phi = mesh.wheel_flank.locate(own)
            lag = mesh.side * (phi - mesh.wheel_flank.azimuth(rho, delta))
            assert mesh.meet(points, turn).lag == pytest.approx(lag, abs=1e-13)


@pytest.mark.parametrize("name", DESIGNS)
@pytest.mark.parametrize("member", ["pinion", "wheel"])
@pytest.mark.parametrize("height", [15.0, -8.0])
def test_lengthwise_crown_comes_back_in_the_ease_off(name: str, member: str, height: float) -> None:
    pair = crowned(height, member=member, of=DESIGNS[name])
    result = contact_analysis(pair, points=(13, 21), positions=12)
    for direction in DIRECTIONS:
        side = result.direction(direction)
        pattern = side.pinion if member == "pinion" else side.wheel
        own = pair.member(member)
        place = own.end_distance(pattern.rho, np.radians(pattern.delta_deg)) - own.mean_cone_distance
        expected = height * (2 * place / own.face_width) ** 2
        meets = np.isfinite(side.pinion.gap_um)
        assert np.abs(side.ease_off_um - expected)[meets].max() < 0.01
        assert np.abs(side.ease_off_um)[meets].max() == pytest.approx(abs(height), rel=0.2)


def test_ease_offs_of_both_members_add_up() -> None:
    heights = [
        contact_analysis(pair, points=(13, 21), positions=12).drive.ease_off_um
        for pair in (crowned(15.0, 6.0), crowned(15.0, 6.0, "wheel"))
    ]
    one = {"lengthwise_crowning_um": 15.0, "profile_crowning_um": 6.0}
    both = {member: dict.fromkeys(FLANKS, one) for member in ("pinion", "wheel")}
    pair = pair_geometry(Design.model_validate({"modifications": both}))
    together = contact_analysis(pair, points=(13, 21), positions=12).drive
    meets = np.isfinite(together.pinion.gap_um)
    assert together.ease_off_um[meets] == pytest.approx((heights[0] + heights[1])[meets], abs=0.05)


@pytest.mark.parametrize(
    ("misalignment", "urad", "centre"),
    [
        (Misalignment(), 54.6, (0.49, 0.50)),
        (Misalignment(offset=0.05), 46.0, (0.41, 0.46)),
        (Misalignment(pinion_axial=0.05), 41.6, (0.51, 0.44)),
        (Misalignment(wheel_axial=0.05), 54.1, (0.53, 0.55)),
        (Misalignment(shaft_angle_deg=2 / 60), 54.3, (0.49, 0.50)),
    ],
)
def test_crowned_pair_against_an_independent_program(
    misalignment: Misalignment, urad: float, centre: tuple[float, float]
) -> None:
    """Its depths are of the mean normal module; it takes the range over 13 turns of a pitch, centres in polar angle."""
    factor = float(np.cos(np.radians(35.0)))
    design = Design.model_validate(
        {
            "pair": {"face_width": 26.0, "pressure_angle_deg": 23.957, "pressure_angle_kind": "transverse"},
            "tooth": {"addendum_factor": factor, "clearance_factor": 0.25 * factor, "ends": "sphere"},
        }
    )
    side = contact_analysis(crowned(20.0, 10.0, of=design), misalignment, positions=47).drive
    assert side.roll.per_pitch == 13
    assert np.ptp(side.roll.shared_lag()) * 1e6 == pytest.approx(urad, rel=0.03)
    touched, delta = side.pinion.gap_um <= 6.35, side.pinion.delta_deg
    depth = (delta - delta[0]) / (delta[-1] - delta[0])
    weight = touched * np.gradient(depth, axis=0)
    along = np.broadcast_to(np.linspace(0.0, 1.0, delta.shape[1]), delta.shape)
    found = [np.sum(weight * place) / np.sum(weight) for place in (along, depth)]
    assert found == pytest.approx(centre, abs=0.025)


def test_crowned_pair_does_not_depend_on_the_grid() -> None:
    coarse = contact_analysis(crowned(20, 10), Misalignment(0.02, 0.01), points=(31, 51)).drive
    fine = contact_analysis(crowned(20, 10), Misalignment(0.02, 0.01), points=(121, 181)).drive
    assert coarse.peak_to_peak_arcsec == pytest.approx(fine.peak_to_peak_arcsec, rel=1e-4)
    assert coarse.pattern_share == pytest.approx(fine.pattern_share, abs=0.02)


@pytest.mark.parametrize("misalignment", MISALIGNMENTS)
def test_edge_contact_does_not_depend_on_the_grid(misalignment: Misalignment) -> None:
    results = [contact_analysis(PAIR, misalignment, points=points) for points in ((31, 51), (60, 100), (101, 161))]
    for direction in DIRECTIONS:
        errors = [result.direction(direction).peak_to_peak_arcsec for result in results]
        assert np.ptp(errors) < 5e-3 * max(errors)


def test_shaft_angle_leaves_the_motion_alone() -> None:
    """Base cones that share an apex roll at any shaft angle: backlash grows, the transmission stays exact."""
    result = contact_analysis(PAIR, Misalignment(shaft_angle_deg=0.05))
    assert result.drive.peak_to_peak_arcsec < 1e-4
    assert result.coast.peak_to_peak_arcsec < 1e-4
    assert result.play_mm > 0.05


def test_mirrored_pair_has_mirrored_contact() -> None:
    mirrored = crowned(20, 10, of=Design.model_validate({"pair": {"pinion_hand": "right"}}))
    given = Misalignment(0.03, 0.02, -0.01, 0.02)
    ours, theirs = (contact_analysis(pair, given) for pair in (crowned(20, 10), mirrored))
    for direction in DIRECTIONS:
        a, b = ours.direction(direction), theirs.direction(direction)
        assert a.ease_off_um == pytest.approx(b.ease_off_um, abs=1e-8)
        assert a.pattern_centre == pytest.approx(b.pattern_centre, abs=1e-9)
        assert a.peak_to_peak_arcsec == pytest.approx(b.peak_to_peak_arcsec, rel=1e-3)


def test_scale_scales_lengths_and_no_angles() -> None:
    design = Design.model_validate({"pair": {"outer_module": 8.0}, "lengthwise": {"cutter_radius": 160.0}})
    small = contact_analysis(PAIR, Misalignment(0.05, -0.02, 0.03, 0.01)).drive
    large = contact_analysis(pair_geometry(design), Misalignment(0.1, -0.04, 0.06, 0.01)).drive
    assert large.peak_to_peak_arcsec == pytest.approx(small.peak_to_peak_arcsec, rel=1e-6)
    assert large.ease_off_um == pytest.approx(2 * small.ease_off_um, abs=1e-6)


def test_pattern_moves_as_engineers_expect() -> None:
    """On the drive side an offset moves the pattern to the toe, an axial shift of the pinion to its root."""
    still = contact_analysis(crowned(20, 10)).drive.pattern_centre
    offset = contact_analysis(crowned(20, 10), Misalignment(offset=0.05)).drive.pattern_centre
    axial = contact_analysis(crowned(20, 10), Misalignment(pinion_axial=0.05)).drive.pattern_centre
    assert still[0] == pytest.approx(0.5, abs=0.01)
    assert offset[0] < still[0] - 0.05
    assert axial[1] < still[1] - 0.04


def test_backlash_is_the_design_s() -> None:
    result = contact_analysis(pair_geometry(DESIGNS["backlash"]))
    assert result.play_mm == pytest.approx(0.2, abs=1e-9)


def foot(mesh: FlankMesh, point: Floats, turn: float, wheel_turn: float) -> float:
    """Distance of a placed pinion point from the wheel's flank in space, by least squares."""
    m = mesh.misalignment
    shaft = PAIR.shaft_angle + np.radians(m.shaft_angle_deg)
    tilt = np.array([[np.cos(shaft), 0, np.sin(shaft)], [0, 1, 0], [-np.sin(shaft), 0, np.cos(shaft)]])
    world = tilt @ (about_axis(np.pi + turn) @ point + [0, 0, m.pinion_axial])
    world += [0, PAIR.wheel.hand * m.offset, -m.wheel_axial]
    own = about_axis(-wheel_turn) @ world
    fit = least_squares(
        lambda c: mesh.wheel_flank.points(c[0], c[1]) - own, (0.5, 0.5), xtol=1e-15, ftol=1e-15, gtol=1e-15
    )
    return float(np.linalg.norm(fit.fun))


@pytest.mark.parametrize("misalignment", MISALIGNMENTS)
def test_gaps_are_distances_in_space(misalignment: Misalignment) -> None:
    grid = pinion_grid(FlankMesh(PAIR, 1, misalignment), (9, 9))
    mesh, eased = grid.mesh, ease_off(grid)
    points = grid.points(grid.u, grid.v)
    for at in ((4, 3), (5, 5), (6, 6)):
        if not eased.facing[at]:
            continue
        wheel = -eased.turn[at] * 17 / 40 - np.pi / 40 * mesh.side
        gap = abs(eased.lag[at]) * mesh.lever(eased.met.rho[at])
        assert foot(mesh, points[at], float(eased.turn[at]), wheel) == pytest.approx(gap, rel=2e-3)
        assert foot(mesh, points[at], float(eased.turn[at]), wheel + mesh.side * eased.lag[at]) < 1e-9


def test_path_of_contact_lies_on_both_flanks() -> None:
    pair = crowned(20, 10)
    side = contact_analysis(pair, Misalignment(0.02)).drive
    mesh = flank_mesh(pair, side.pinion.flank)
    assert np.abs(mesh.wheel_flank.deviation(side.path.wheel_points)).max() < 1e-9
    assert np.abs(mesh.pinion_flank.deviation(side.path.pinion_points)).max() < 1e-9
    assert side.path.edges == ()


def test_misalignment_gives_edge_contact_and_crowning_cures_it() -> None:
    bare = contact_analysis(PAIR, Misalignment(wheel_axial=0.05))
    cured = contact_analysis(crowned(25, 15), Misalignment(wheel_axial=0.05))
    assert {issue.code for issue in bare.warnings} == {"edge_contact"}
    assert cured.warnings == ()


def test_jamming_is_said() -> None:
    codes = {issue.code for issue in contact_analysis(PAIR, Misalignment(shaft_angle_deg=-0.05)).warnings}
    assert "jammed" in codes


@pytest.mark.parametrize(
    "beyond",
    [Misalignment(offset=30), Misalignment(pinion_axial=12), Misalignment(wheel_axial=1e6), Misalignment(0, 0, 0, 60)],
)
def test_no_contact_is_an_error(beyond: Misalignment) -> None:
    with pytest.raises(GeometryError, match="no contact"):
        contact_analysis(PAIR, beyond)


def test_a_roll_with_a_gap_is_an_error() -> None:
    """Three steps to a pitch, and in one of them nothing touches."""
    lag = np.array([0.0, np.inf, 0.0, 1.0, np.inf])
    rolled = Roll(np.arange(5) / 3, lag, lag, lag, 3, 1.0, "give the pair deeper teeth")
    with pytest.raises(GeometryError, match=r"no contact: .*deeper teeth"):
        rolled.shared_lag()


@settings(max_examples=12, deadline=None, suppress_health_check=list(HealthCheck))
@given(designs())
def test_random_pairs_are_conjugate(design: Design) -> None:
    assume(not {"interference", "contact_ratio", "working_depth"} & {issue.code for issue in check(design)})
    result = contact_analysis(pair_geometry(design), points=(25, 31), positions=20)
    for direction in DIRECTIONS:
        side = result.direction(direction)
        assert side.peak_to_peak_arcsec <= 0.01
        assert side.path.edges == () and side.pattern_share == 1


@pytest.mark.parametrize("thickness", [0.0, -1.0, np.nan, np.inf])
def test_marking_compound_needs_a_thickness(thickness: float) -> None:
    with pytest.raises(GeometryError, match="marking compound"):
        contact_analysis(PAIR, thickness_um=thickness)


def test_misalignment_must_be_finite() -> None:
    with pytest.raises(GeometryError, match="finite"):
        contact_analysis(PAIR, Misalignment(offset=np.nan))


def test_thicker_compound_marks_more() -> None:
    shares = [contact_analysis(crowned(20), thickness_um=t).drive.pattern_share for t in (2, 6.35, 15)]
    assert shares == sorted(shares) and shares[0] < shares[2]


def test_table_agrees_with_the_map() -> None:
    given = Misalignment(0.02)
    side = contact_analysis(PAIR, given).drive
    rho, delta, gap = contact_table(PAIR, given, side, (11, 7))
    assert gap.shape == (11, 7) == (len(rho), len(delta))
    row, column = 40, 50
    i = np.argmin(np.abs(np.degrees(delta) - side.pinion.delta_deg[row, column]))
    assert side.pinion.gap_um[row, column] == pytest.approx(gap[5, i], abs=2.0)


def test_result_travels_between_processes() -> None:
    result = contact_analysis(PAIR, points=(9, 11), positions=12)
    again: ContactResult = pickle.loads(pickle.dumps(result))
    assert again.drive.error_arcsec == pytest.approx(result.drive.error_arcsec)


def test_pinion_and_wheel_patterns_are_of_the_flanks_that_meet(pair: PairGeometry = PAIR) -> None:
    result = contact_analysis(pair, points=(9, 11), positions=12)
    named: dict[str, tuple[FlankName, FlankName]] = {"drive": ("concave", "convex"), "coast": ("convex", "concave")}
    for direction in DIRECTIONS:
        side = result.direction(direction)
        assert (side.pinion.flank, side.wheel.flank) == named[direction]
        facing = np.isfinite(side.wheel.gap_um)
        wheel = pair.wheel
        assert side.wheel.rho[facing].max() <= wheel.outer_cone_distance * 1.01
        assert np.degrees(wheel.tip_angle) >= side.wheel.delta_deg[facing].max() - 1e-4
