"""The conjugate pinion flank: independent numbers, derivatives by differences, the inverse, the bevel pair as limit."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearstudio.theory.flank import FLANKS, Flank, FlankName
from gearstudio.theory.hypoid.conjugate import ConjugateFlank, envelope, pinion_flank, wheel_flank
from gearstudio.theory.hypoid.inputs import HypoidInput
from gearstudio.theory.hypoid.pair import hypoid_pair
from gearstudio.theory.involute import roll_arc
from gearstudio.theory.involute_flank import InvoluteFlank
from tests.theory.hypoid.curvatures import curvatures
from tests.theory.hypoid.pairs import AXLE, PAIRS, REFERENCE, Record, reference_input

U, V = np.meshgrid(np.linspace(0.0, 1.0, 9), np.linspace(0.0, 1.0, 11), indexing="ij")


def flanks(given: HypoidInput) -> list[ConjugateFlank]:
    """Both conjugate flanks of a pair."""
    pair = hypoid_pair(given)
    return [pinion_flank(pair, name) for name in FLANKS]


@pytest.mark.parametrize("record", REFERENCE, ids=lambda r: r["name"])
def test_reference(record: Record) -> None:
    pair = hypoid_pair(reference_input(record))
    for wanted in record["flanks"]:
        side = wanted["side"]
        name = pair.flank_name("wheel", side)
        assert np.degrees(pair.normal_pressure_angle(side)) == pytest.approx(wanted["alpha_n_deg"], abs=1e-8)
        assert pair.member("wheel", name).base_angle == pytest.approx(wanted["delta_b2"], abs=1e-10)
        assert pair.transverse_pressure_angle("wheel", side) == pytest.approx(wanted["alpha_t2"], abs=1e-10)
        assert pair.transverse_pressure_angle("pinion", side) == pytest.approx(wanted["alpha_t1_own"], abs=1e-10)
        assert pair.is_drive(side) == wanted["kind"].startswith("drive")
        points = {key: np.array([point[key] for point in wanted["points"]]) for key in wanted["points"][0]}
        made = envelope(pair, side)
        psi = roll_arc(points["dk2"], made.wheel.member.base_angle)
        own = made.wheel.at(psi, points["rho2"])
        matrix, _ = pair.axes.wheel_placement(pair.given.wheel_teeth)
        if side > 0:  # the reference's tooth stands before the space, ours behind it
            turn = -2 * np.pi / pair.given.wheel_teeth
            c, s = np.cos(turn), np.sin(turn)
            matrix = matrix @ np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
        assert np.abs(own @ matrix.T - points["wheel_xyz"]).max() < 1e-9
        found = made.at(psi, points["rho2"])
        assert np.abs(found.point - points["pinion_xyz"]).max() < 1e-9
        assert np.abs(found.wheel_turn - points["phi2"]).max() < 1e-10
        assert np.abs(found.area_ratio - points["J"]).max() < 1e-10
        assert_inverse(pinion_flank(pair, pair.flank_name("pinion", side)), wanted["inverse"])


def assert_inverse(flank: ConjugateFlank, wanted: Record) -> None:
    """The point of a place on the pinion."""
    rho, delta, phi = wanted["pinion_rho"], wanted["pinion_dk"], wanted["pinion_phi"]
    ring = np.sin(delta) * np.array([np.cos(phi), np.sin(phi), 1 / np.tan(delta)])
    psi, along = flank.natural(rho * ring)
    assert along == pytest.approx(wanted["wheel_rho"], abs=1e-9)
    assert psi == pytest.approx(roll_arc(wanted["wheel_dk"], flank.envelope.wheel.member.base_angle), abs=1e-10)
    assert flank.deviation(rho * ring) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("curve", ["circular_arc", "archimedean", "logarithmic"])
@pytest.mark.parametrize("hand", ["left", "right"])
@pytest.mark.parametrize("teeth", [(17, 40, 90.0, 35.0), (13, 42, 75.0, 20.0), (11, 23, 105.0, 0.0)])
def test_without_offset_it_is_the_involute_pinion(teeth: tuple[int, int, float, float], hand: str, curve: str) -> None:
    z1, z2, shaft, spiral = teeth
    given = HypoidInput(z1, z2, 0.0, 160.0, 26.0, spiral, 80.0, shaft_angle_deg=shaft, pinion_hand=hand, curve=curve)  # type: ignore[arg-type]
    for flank in flanks(replace(given, backlash=0.1)):
        psi, rho = flank.coordinates(U, V)
        own = InvoluteFlank(flank.member, flank.side)
        points = flank.at(psi, rho)
        at, delta, _ = flank.locate(points)
        assert np.abs(points - own.points_at(at, delta)).max() < 1e-11
        assert np.abs(flank.normals(U, V) - own.normals_at(roll_arc(delta, own.member.base_angle), at)).max() < 1e-11


@pytest.mark.parametrize("hand", ["left", "right"])
@pytest.mark.parametrize("given", PAIRS.values(), ids=PAIRS)
def test_derivatives_by_differences(given: HypoidInput, hand: str) -> None:
    for flank in flanks(replace(given, pinion_hand=hand)):
        psi, rho = flank.coordinates(U, V)
        p = flank.envelope.at(psi, rho)
        by = [
            (flank.at(psi + 1e-5, rho) - flank.at(psi - 1e-5, rho)) / 2e-5,
            (flank.at(psi, rho + 1e-3) - flank.at(psi, rho - 1e-3)) / 2e-3,
        ]
        assert np.abs(by[0] - p.by_psi).max() < 1e-6 and np.abs(by[1] - p.by_rho).max() < 1e-8
        cross = np.cross(*by)
        area = np.linalg.norm(cross, axis=-1)
        assert np.abs(np.abs(np.sum(cross * p.normal, axis=-1)) / area - 1).max() < 1e-12
        wheel = flank.envelope.wheel
        first, second, *_ = wheel.derivatives_at(psi, rho)
        before = np.linalg.norm(np.cross(first, second), axis=-1)
        assert np.abs(area / before - np.abs(p.area_ratio)).max() < 1e-7
        outward = np.sign(np.sum(p.normal * np.stack([-p.point[..., 1], p.point[..., 0], 0 * psi], axis=-1), axis=-1))
        assert np.all(outward == flank.side)
        turned = (flank.normals_at(psi, rho + 1e-3) - flank.normals_at(psi, rho - 1e-3)) / 2e-3
        assert np.abs(turned - p.normal_by_rho).max() < 1e-9
        assert_curvatures(flank, psi, rho, p.normal)


def assert_curvatures(flank: ConjugateFlank, psi: np.ndarray, rho: np.ndarray, normal: np.ndarray) -> None:
    """The closed form against the second derivatives."""
    a, b, aa, ab, bb = flank.derivatives_at(psi, rho)
    first = np.stack([[np.sum(x * y, -1) for y in (a, b)] for x in (a, b)])
    second = -np.stack([[np.sum(x * normal, -1) for x in row] for row in ((aa, ab), (ab, bb))])
    shape = np.linalg.solve(np.moveaxis(first, (0, 1), (-2, -1)), np.moveaxis(second, (0, 1), (-2, -1)))
    wanted = np.sort(np.linalg.eigvals(shape).real, axis=-1)
    high, low = curvatures(flank, psi, rho)
    assert np.abs(np.stack([low, high], axis=-1) - wanted).max() < 1e-8


@pytest.mark.parametrize("given", PAIRS.values(), ids=PAIRS)
def test_grid_and_deviation(given: HypoidInput) -> None:
    for flank in flanks(given):
        points, normals, m = flank.points(U, V), flank.normals(U, V), flank.member
        rho, delta, _ = flank.locate(points)
        low, high = flank.limits(V)
        assert np.abs(delta - low - U * (high - low)).max() < 1e-12
        assert np.abs(m.end_distance(rho, delta) - m.inner_cone_distance - V * m.face_width).max() < 1e-10
        assert np.all(low > m.limit_angle(m.root_limit, m.end_distance(rho, delta)))
        assert flank.edge_deviation(points) < 1e-10
        assert flank.evenly_divided(9, 11) == pytest.approx(points, abs=1e-10)
        for gap in (0.0, 1e-4, -0.02, 0.3):
            assert np.abs(flank.deviation(points + gap * normals) - gap).max() < 1e-9
        trace = flank.trace(V[0])
        assert np.abs(flank.locate(trace)[1] - m.pitch_angle).max() < 1e-12
        assert np.abs(flank.deviation(trace)).max() < 1e-9
        beyond = flank.points(np.array([-0.02, 1.05, 0.5, 0.5]), np.array([0.5, 0.5, -0.05, 1.05]))
        assert np.abs(flank.deviation(beyond)).max() < 1e-9
        assert np.all(np.diff(flank.along(np.linspace(0, 1, 7))) > 0)
        assert flank.along([0.0, 1.0]) == pytest.approx([0.0, 1.0])


def test_both_members_flanks_are_flanks() -> None:
    pair = hypoid_pair(AXLE)
    both: list[tuple[FlankName, Flank, Flank]] = [(n, pinion_flank(pair, n), wheel_flank(pair, n)) for n in FLANKS]
    for name, pinion, wheel in both:
        assert pinion.name == wheel.name == name
        assert pinion.side == -wheel.side
        assert pinion.points(U, V).shape == wheel.points(U, V).shape == (*U.shape, 3)
        assert not pinion.starts_on_base


@pytest.mark.parametrize("given", [PAIRS["axle"], PAIRS["below"]], ids=["axle", "below"])
def test_hands_are_mirror_images(given: HypoidInput) -> None:
    mirrored = replace(given, pinion_hand={"left": "right", "right": "left"}[given.pinion_hand])  # type: ignore[arg-type]
    for one, other in zip(flanks(given), flanks(mirrored), strict=True):
        assert one.side == -other.side
        assert np.abs(one.points(U, V) * [1, -1, 1] - other.points(U, V)).max() < 1e-10
