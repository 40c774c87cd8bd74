"""Points made from theory, turned, shifted, with known errors: each comes back; points of another gear do not pass."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np
import pytest

from gearstudio.analysis.measurement import MeasuredPoints, MeasurementResult, measure
from gearstudio.analysis.measurement_errors import NAMED_ERRORS
from gearstudio.analysis.measurement_fit import azimuth_lever, places, turned_back
from gearstudio.catalogue import MEMBERS
from gearstudio.design import Design, with_field
from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry, PairGeometry, pair_geometry
from gearstudio.theory.flank import FLANKS, FlankName
from gearstudio.theory.involute_flank import InvoluteFlank, involute_flank
from tests.designs import GOLDEN

PAIR = pair_geometry(Design())
Errors = Callable[[InvoluteFlank, int, np.ndarray, np.ndarray, np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Part:
    """Points of a made-up part and what they are."""

    points: np.ndarray
    normals: np.ndarray
    side: np.ndarray
    tooth: np.ndarray

    def measured(self, normals: bool = False) -> list[MeasuredPoints]:
        """In chunks of uneven size."""
        cuts = [len(self.points) // 3, len(self.points) // 2]
        both = zip(np.split(self.points, cuts), np.split(self.normals, cuts), strict=True)
        return [MeasuredPoints(points, found if normals else None) for points, found in both]


def part(
    member: MemberGeometry,
    teeth: Iterable[int],
    *,
    flanks: Iterable[FlankName] = FLANKS,
    turn: float = 0.0,
    shift: float = 0.0,
    error: Errors | None = None,
    noise_um: float = 0.0,
    grid: tuple[int, int] = (6, 8),
) -> Part:
    """Points on some flanks of a part that lies turned and shifted, in random order; errors in µm, normal."""
    random = np.random.default_rng(3)
    found = []
    u, v = np.meshgrid(np.linspace(0.03, 0.97, grid[0]), np.linspace(0.03, 0.97, grid[1]), indexing="ij")
    for name in flanks:
        flank = involute_flank(member, name)
        exact, normals = flank.points(u, v).reshape(-1, 3), flank.normals(u, v).reshape(-1, 3)
        face, profile = places(member, exact)
        for tooth in teeth:
            off = noise_um * random.standard_normal(len(exact))
            if error is not None:
                off = off + error(flank, tooth, exact, 2 * face - 1, 2 * profile - 1)
            back = np.full(len(exact), -(tooth + turn / member.pitch))
            points = turned_back(member, exact + off[:, None] * 1e-3 * normals, back) + np.array([0, 0, shift])
            found.append(
                (points, turned_back(member, normals, back), np.full(len(exact), flank.side), 0 * back + tooth)
            )
    order = random.permutation(sum(len(part[0]) for part in found))
    return Part(*(np.concatenate(column)[order] for column in zip(*found, strict=True)))


def assert_found(result: MeasurementResult, made: Part) -> None:
    assert np.array_equal(result.side, made.side)
    assert np.array_equal(result.tooth, made.tooth)
    assert result.beside == 0


@pytest.mark.parametrize("name", GOLDEN)
@pytest.mark.parametrize("normals", [False, True])
def test_turn_and_shift_come_back(name: str, normals: bool) -> None:
    pair = pair_geometry(GOLDEN[name][0])
    for member_name in MEMBERS:
        member = pair.member(member_name)
        for part_of_pitch, modules in ((0.0, 0.0), (0.4, 0.2), (-0.35, -0.4)):
            turn, shift = part_of_pitch * member.pitch, modules * member.module
            made = part(member, range(0, member.teeth, 3), turn=turn, shift=shift)
            result = measure(pair, member_name, made.measured(normals))
            assert np.degrees(abs(result.pose.turn - turn)) < 1e-6
            assert abs(result.pose.shift - shift) < 1e-6
            assert result.statistics.max_um < 1e-4
            assert_found(result, made)


@pytest.mark.parametrize(
    "tooth",
    [{"addendum_factor": 0.1, "clearance_factor": 0.05, "fillet_factor": 0.05}, {"addendum_factor": 0.3}],
)
@pytest.mark.parametrize("face_width_factor", [0.04, 0.3])
def test_thin_and_narrow_teeth_may_be_shifted_too(tooth: dict, face_width_factor: float) -> None:
    design = Design.model_validate({"tooth": tooth, "pair": {"face_width_factor": face_width_factor}})
    pair = pair_geometry(design)
    for member_name in MEMBERS:
        member = pair.member(member_name)
        for modules in (0.2, -0.45):
            made = part(member, range(0, member.teeth, 4), turn=0.3 * member.pitch, shift=modules * member.module)
            result = measure(pair, member_name, made.measured())
            assert result.pose.shift == pytest.approx(modules * member.module, abs=1e-6)
            assert result.statistics.max_um < 1e-4
            assert_found(result, made)


def test_normals_into_the_metal_are_understood() -> None:
    made = part(PAIR.wheel, range(5), turn=0.02)
    inward = [MeasuredPoints(made.points, -made.normals)]
    assert_found(measure(PAIR, "wheel", inward), made)


@pytest.mark.parametrize("flank", FLANKS)
def test_one_flank_of_one_tooth_is_enough(flank: FlankName) -> None:
    made = part(PAIR.pinion, [4], flanks=[flank], turn=0.05, shift=-0.3)
    result = measure(PAIR, "pinion", made.measured())
    assert result.pose.turn == pytest.approx(0.05, abs=1e-8)
    assert result.pose.shift == pytest.approx(-0.3, abs=1e-6)
    assert set(result.flanks) == {flank} == set(result.form)
    assert_found(result, made)


def test_fit_can_be_switched_off() -> None:
    made = part(PAIR.wheel, range(0, 40, 4), turn=0.001, shift=0.02)
    still = measure(PAIR, "wheel", made.measured(), turn=False, shift=False)
    assert (still.pose.turn, still.pose.shift) == (0, 0)
    assert still.statistics.max_um > 10
    turned = measure(PAIR, "wheel", part(PAIR.wheel, range(3), turn=0.001).measured(), shift=False)
    assert turned.pose.turn == pytest.approx(0.001, abs=1e-9) and turned.pose.shift == 0
    shifted = measure(PAIR, "wheel", part(PAIR.wheel, range(3), shift=0.02).measured(), turn=False)
    assert shifted.pose.shift == pytest.approx(0.02, abs=1e-9) and shifted.pose.turn == 0


def test_deviations_are_those_put_in() -> None:
    made = part(PAIR.wheel, range(40), error=lambda flank, tooth, points, x, y: 30 * x * y)
    result = measure(PAIR, "wheel", made.measured(), turn=False, shift=False)
    face, profile = places(PAIR.wheel, turned_back(PAIR.wheel, made.points, made.tooth))
    expected = 30 * (2 * face - 1) * (2 * profile - 1)
    assert result.deviation_um == pytest.approx(expected, abs=0.5)
    assert result.statistics.max_um == pytest.approx(30 * 0.94**2, abs=0.6)


@pytest.mark.parametrize("free", [(True, True), (True, False), (False, True), (False, False)])
def test_angle_errors_and_crowning_come_back(free: tuple[bool, bool]) -> None:
    def error(flank: InvoluteFlank, tooth: int, points: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        if flank.name == "concave":
            return 5 * x - 3 * y - 4 * x**2 - 2 * y**2 + 1.5 * x * y
        return -2 * x + 6 * y - x**2 - 3 * y**2

    made = part(PAIR.wheel, range(0, 40, 2), error=error, turn=0.03 * free[0], shift=0.2 * free[1])
    result = measure(PAIR, "wheel", made.measured(), turn=free[0], shift=free[1])
    concave, convex = result.form["concave"], result.form["convex"]
    assert (concave.spiral_um, convex.spiral_um) == pytest.approx((10, -4), abs=0.01)
    assert (concave.pressure_um, convex.pressure_um) == pytest.approx((-6, 12), abs=0.01)
    assert (concave.lengthwise_crown_um, convex.lengthwise_crown_um) == pytest.approx((4, 1), abs=0.01)
    assert (concave.profile_crown_um, convex.profile_crown_um) == pytest.approx((2, 3), abs=0.01)
    assert (concave.bias_um, convex.bias_um) == pytest.approx((3, 0), abs=0.01)
    assert_found(result, made)


def test_a_spiral_angle_error_is_the_angle() -> None:
    """A gear made with another spiral angle, measured against the nominal one."""
    other = pair_geometry(
        Design.model_validate({"lengthwise": {"spiral_angle_deg": 35.02}, "pair": {"face_width": 20.0}})
    )
    nominal = pair_geometry(Design.model_validate({"pair": {"face_width": 20.0}}))
    made = part(other.wheel, range(0, 40, 4))
    form = measure(nominal, "wheel", made.measured()).form
    for flank in FLANKS:
        leans = 1 if flank == "concave" else -1
        assert leans * form[flank].spiral_deg == pytest.approx(0.02, rel=0.15)


def test_pitch_errors_come_back() -> None:
    index = np.random.default_rng(5).normal(0, 8, 40)
    index -= index.mean()
    radius = PAIR.wheel.mean_cone_distance * np.sin(PAIR.wheel.pitch_angle)

    def error(flank: InvoluteFlank, tooth: int, points: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        return np.asarray(flank.side * index[tooth] / radius * azimuth_lever(flank, points)[1])

    made = part(PAIR.wheel, range(40), error=error, turn=-0.04)
    result = measure(PAIR, "wheel", made.measured())
    for flank in FLANKS:
        pitch = result.pitch[flank]
        assert pitch.index_um == pytest.approx(index, abs=0.01)
        assert pitch.cumulative_um == pytest.approx(index - index[0], abs=0.02)
        assert pitch.single_um == pytest.approx(index - np.roll(index, 1), abs=0.02)
        assert pitch.total_um == pytest.approx(np.ptp(index), abs=0.02)
    assert_found(result, made)


@pytest.mark.parametrize("teeth", [1, 2])
def test_one_tooth_alone_has_no_pitch_to_name(teeth: int) -> None:
    result = measure(PAIR, "wheel", part(PAIR.wheel, range(teeth)).measured())
    for flank in FLANKS:
        values = {error.title: error.of(result.form[flank], result.pitch[flank]) for error in NAMED_ERRORS}
        assert {title for title, value in values.items() if value is None} == (
            {"Pitch, single", "Pitch, total"} if teeth == 1 else set()
        )


def test_pitch_errors_of_some_teeth() -> None:
    pitch = measure(PAIR, "wheel", part(PAIR.wheel, [3, 4, 20]).measured()).pitch["convex"]
    assert pitch.tooth.tolist() == [3, 4, 20]
    assert pitch.single_um == pytest.approx([0, 0, 0], abs=1e-4)


def test_noise_averages_out() -> None:
    made = part(PAIR.wheel, range(40), turn=0.02, shift=0.1, noise_um=3)
    result = measure(PAIR, "wheel", made.measured())
    assert result.statistics.rms_um == pytest.approx(3, rel=0.05)
    assert np.degrees(abs(result.pose.turn - 0.02)) < 2e-4
    assert abs(result.pose.shift - 0.1) < 1e-3
    assert_found(result, made)


@pytest.mark.slow
def test_a_million_points() -> None:
    made = part(PAIR.wheel, range(40), turn=0.02, shift=0.1, noise_um=2, grid=(100, 125))
    assert len(made.points) == 1_000_000
    told: list[float] = []
    result = measure(PAIR, "wheel", made.measured(), report=lambda stage, done: told.append(done))
    assert len(told) > 10 and told == sorted(told)
    assert np.degrees(abs(result.pose.turn - 0.02)) < 1e-5
    assert_found(result, made)


FOREIGN: dict[str, tuple[PairGeometry, str]] = {
    "more teeth": (pair_geometry(Design.model_validate({"pair": {"wheel_teeth": 41}})), "another gear"),
    "other spiral angle": (
        pair_geometry(Design.model_validate({"lengthwise": {"spiral_angle_deg": 31.0}})),
        "another gear",
    ),
    "other hand": (pair_geometry(Design.model_validate({"pair": {"pinion_hand": "right"}})), "other hand"),
    "larger": (pair_geometry(Design.model_validate({"pair": {"outer_module": 6.0}})), "beside the wheel's teeth"),
}


@pytest.mark.parametrize("kind", FOREIGN)
@pytest.mark.parametrize("normals", [False, True])
def test_points_of_another_gear_are_refused(kind: str, normals: bool) -> None:
    pair, reason = FOREIGN[kind]
    made = part(pair.wheel, range(0, pair.wheel.teeth, 5))
    with pytest.raises(GeometryError, match=reason):
        measure(PAIR, "wheel", made.measured(normals))


SIMILAR = {
    "17/43 teeth": {"wheel_teeth": 43},
    "17/38 teeth": {"wheel_teeth": 38},
    "18/40 teeth": {"pinion_teeth": 18},
    "a pressure angle of 22.5°": {"pressure_angle_deg": 22.5},
}


@pytest.mark.parametrize("words", SIMILAR)
def test_points_of_a_similar_gear_are_refused_by_its_name(words: str) -> None:
    similar = pair_geometry(Design.model_validate({"pair": SIMILAR[words]})).pinion
    made = part(similar, range(0, similar.teeth, 4), turn=0.1, shift=0.2, noise_um=2)
    with pytest.raises(GeometryError, match=f"they fit the pinion of a pair with {words}"):
        measure(PAIR, "pinion", made.measured(), design=Design())


OTHER_NUMBERS = [
    ("lengthwise.cutter_radius", 72.0, "a cutter radius of"),
    ("lengthwise.cutter_radius", 88.0, "a cutter radius of"),
    ("tooth.profile_shift", -0.05, "a profile shift of"),
    ("lengthwise.spiral_angle_deg", 35.3, "a spiral angle of"),
]


@pytest.mark.parametrize("member", MEMBERS)
@pytest.mark.parametrize(("field", "value", "words"), OTHER_NUMBERS)
def test_points_that_another_number_explains_are_doubted_with_that_number(
    field: str, value: float, words: str, member: str
) -> None:
    other = pair_geometry(with_field(Design(), field, value)).member(member)
    made = part(other, range(0, other.teeth, 5), turn=0.05, shift=0.1, noise_um=2)
    (doubt,) = measure(PAIR, member, made.measured(), design=Design()).warnings
    assert (doubt.field, doubt.severity) == (field, "warning")
    found = re.search(rf"with {words} (-?[\d.]+)", doubt.message)
    assert found and float(found[1]) == pytest.approx(value, rel=2e-3, abs=5e-4)
    assert "instead of" in doubt.message and "Check that the part is of this design" in doubt.message


def test_points_that_are_refused_are_explained_by_a_number_too() -> None:
    other = pair_geometry(with_field(Design(), "lengthwise.cutter_radius", 60.0)).wheel
    made = part(other, range(0, 40, 9), turn=0.05, noise_um=2)
    with pytest.raises(GeometryError, match=r"with a cutter radius of (59.9|60)\S* mm instead of .*80 mm"):
        measure(PAIR, "wheel", made.measured(), design=Design())


def test_bad_points_that_nothing_explains_are_doubted_all_the_same() -> None:
    """A wave along the face is no gear."""
    made = part(PAIR.wheel, range(0, 40, 9), error=lambda flank, tooth, points, x, y: 60 * np.sin(9 * y) * x)
    (doubt,) = measure(PAIR, "wheel", made.measured(), design=Design()).warnings
    assert doubt.code == "fits_badly" and "µm rms" in doubt.message


@pytest.mark.parametrize("member", MEMBERS)
@pytest.mark.parametrize("seed", range(4))
def test_parts_with_common_errors_are_not_doubted(member: str, seed: int) -> None:
    random = np.random.default_rng(seed)
    c, pitch = 5 * random.standard_normal((2, 5)), 4 * random.standard_normal(40)

    def error(flank: InvoluteFlank, tooth: int, points: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        form = np.stack([x, y, x * x, y * y, x * y])
        return c[int(flank.side > 0)] @ form + pitch[tooth]

    made = part(PAIR.member(member), range(0, 17, 4), error=error, turn=0.1, shift=0.05, noise_um=1)
    assert measure(PAIR, member, made.measured(), design=Design()).warnings == ()


@pytest.mark.parametrize(
    ("form", "both"), [("x", True), ("y", True), ("x", False), ("x * y", True), ("y - y**2", False)]
)
def test_a_part_with_large_errors_is_still_measured(form: str, both: bool) -> None:
    """50 µm of one error, clean and alike on every tooth, as another gear would look."""

    def error(flank: InvoluteFlank, tooth: int, points: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        return 25 * np.asarray(eval(form, {"x": x, "y": y})) * (1 if both or flank.side > 0 else -1)

    made = part(PAIR.pinion, range(0, 17, 6), error=error, turn=0.1)
    assert measure(PAIR, "pinion", made.measured(), design=Design()).statistics.max_um > 5


def test_a_part_that_lies_elsewhere_says_what_to_switch_on() -> None:
    made = part(PAIR.wheel, range(0, 40, 8), shift=1.5)
    with pytest.raises(GeometryError, match="they fit when the best fit may turn and shift"):
        measure(PAIR, "wheel", made.measured(), shift=False)


def test_points_of_the_mate_are_named() -> None:
    with pytest.raises(GeometryError, match="they fit the wheel"):
        measure(PAIR, "pinion", part(PAIR.wheel, range(8)).measured())
    miter = pair_geometry(GOLDEN["miter-archimedean"][0])
    with pytest.raises(GeometryError, match=r"they fit (the wheel|a gear of the other hand)"):
        measure(miter, "pinion", part(miter.wheel, range(20)).measured())


@pytest.mark.parametrize(("factor", "unit"), [(25.4, "inches"), (1000.0, "metres"), (1e-3, "micrometres")])
def test_other_units_are_said(factor: float, unit: str) -> None:
    made = part(PAIR.pinion, range(5), turn=0.1)
    with pytest.raises(GeometryError, match=unit):
        measure(PAIR, "pinion", [MeasuredPoints(made.points / factor)])


def test_too_few_or_too_poor_points_are_refused() -> None:
    made = part(PAIR.wheel, [0])
    with pytest.raises(GeometryError, match="too few"):
        measure(PAIR, "wheel", [MeasuredPoints(made.points[:2])])
    with pytest.raises(GeometryError, match="too few"):
        measure(PAIR, "wheel", [])
    with pytest.raises(GeometryError, match="turning and shifting apart"):
        measure(PAIR, "wheel", [MeasuredPoints(np.repeat(made.points[:1], 9, axis=0))])


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_what_is_not_a_number_is_refused(bad: float) -> None:
    points = part(PAIR.wheel, [0]).points.copy()
    points[5, 1] = bad
    with pytest.raises(GeometryError, match="not a number"):
        measure(PAIR, "wheel", [MeasuredPoints(points)])


def test_points_beside_the_flanks_are_left_out() -> None:
    made = part(PAIR.wheel, range(10))
    points = np.concatenate([made.points, np.array([[0.0, 0.0, 5.0], [10.0, 0.0, 100.0]])])
    result = measure(PAIR, "wheel", [MeasuredPoints(points)])
    assert result.beside == 2 and len(result.points) == len(made.points)
