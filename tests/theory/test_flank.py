"""Flanks: symmetries of the tooth, limits, normals and derivatives."""

from __future__ import annotations

import numpy as np
import pytest

from gearstudio.design import Design
from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry, pair_geometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.involute_flank import InvoluteFlank, involute_flank
from tests.theory.members import DESIGNS, MEMBERS, about_axis, made

U, V = np.linspace(0.0, 1.0, 9)[:, None], np.linspace(0.0, 1.0, 7)[None, :]
over_flanks = pytest.mark.parametrize(
    "flank",
    [involute_flank(member, name) for member in MEMBERS.values() for name in FLANKS],
    ids=[f"{member} {name}" for member in MEMBERS for name in FLANKS],
)


def spherical(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Cone distance and polar angle."""
    rho = np.linalg.norm(points, axis=-1)
    return rho, np.arctan2(np.hypot(points[..., 0], points[..., 1]), points[..., 2])


@over_flanks
def test_edges_lie_on_the_cones_and_ends_of_the_tooth(flank: InvoluteFlank) -> None:
    m, points = flank.member, flank.points(U, V)
    rho, delta = spherical(points)
    if m.ends == "sphere":
        ends = rho
    else:  # back cones stand square to the pitch element
        radius, height = np.hypot(points[..., 0], points[..., 1]), points[..., 2]
        ends = radius * np.sin(m.pitch_angle) + height * np.cos(m.pitch_angle)
    assert ends[:, 0] == pytest.approx(np.full(9, m.outer_cone_distance - m.face_width), rel=1e-13)
    assert ends[:, -1] == pytest.approx(np.full(9, m.outer_cone_distance), rel=1e-13)
    assert delta[0] == pytest.approx(np.full(7, max(m.root_angle, m.base_angle)), abs=1e-13)
    # The face cone: a straight line in the axial plane, through the tip at the heel's pitch circle.
    tip = m.outer_cone_distance * np.exp(1j * m.pitch_angle) + m.addendum * 1j * np.exp(1j * m.pitch_angle)
    across = np.imag((rho[-1] * np.exp(1j * delta[-1]) - tip) * np.exp(-1j * m.tip_angle))
    assert np.abs(across).max() < 1e-12 * m.outer_cone_distance
    assert np.all(np.diff(delta, axis=0) > 0)


@over_flanks
def test_a_surface_is_explicit_in_azimuth(flank: InvoluteFlank) -> None:
    points = flank.points(U, V)
    rho, delta, phi = flank.locate(points)
    m = flank.member
    again = np.stack([rho * np.sin(delta) * np.cos(phi), rho * np.sin(delta) * np.sin(phi), rho * np.cos(delta)], -1)
    assert np.abs(again - points).max() < 1e-13 * m.outer_cone_distance
    explicit = flank.azimuth(rho, np.maximum(delta, m.base_angle))
    wrapped = np.remainder(phi - explicit + np.pi, 2 * np.pi) - np.pi
    assert np.abs(wrapped * rho * np.sin(delta)).max() < 2e-11 * max(1.0, m.outer_cone_distance / 250)


@over_flanks
def test_the_other_flank_is_the_mirror_image_in_every_section(flank: InvoluteFlank) -> None:
    """A section's middle is turned by theta(rho); about it the two flanks are mirror images, not turned copies."""
    m = flank.member
    other = InvoluteFlank(m, -flank.side)
    here, there = flank.points(U, V), other.points(U, V)
    rho, _ = spherical(here)
    turn = m.lengthwise.azimuth(rho)

    def from_the_middle(points: np.ndarray) -> np.ndarray:
        x, y = points[..., 0], points[..., 1]
        return np.stack([x * np.cos(turn) + y * np.sin(turn), y * np.cos(turn) - x * np.sin(turn)], -1)

    assert np.abs(from_the_middle(here) - from_the_middle(there) * [1, -1]).max() < 1e-12 * m.outer_cone_distance


@over_flanks
def test_tangents_and_normals(flank: InvoluteFlank) -> None:
    psi, rho = flank.coordinates(np.linspace(0.1, 1.0, 5)[:, None], V)
    scale = flank.member.outer_cone_distance
    derivatives = flank.derivatives_at(psi, rho)
    h, k = 1e-5, 1e-5 * scale

    def first(psi: np.ndarray, rho: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Central differences of fourth order of the points alone."""
        along = [flank.at(psi + n * h, rho) for n in (-2, -1, 1, 2)]
        across = [flank.at(psi, rho + n * k) for n in (-2, -1, 1, 2)]
        return tuple((a - 8 * b + 8 * c - d) / (12 * step) for (a, b, c, d), step in ((along, h), (across, k)))

    def exact(psi: np.ndarray, rho: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return flank.derivatives_at(psi, rho)[:2]

    x_psi, x_rho = first(psi, rho)
    steep = 1 + np.abs(rho * flank.member.lengthwise.azimuth_slope(rho)).max() ** 2
    assert np.abs(derivatives[0] - x_psi).max() < 1e-9 * scale * steep
    assert np.abs(derivatives[1] - x_rho).max() < 1e-9 * steep**2
    by_psi = [(p - m) / (2 * h) for m, p in zip(exact(psi - h, rho), exact(psi + h, rho), strict=True)]
    by_rho = (exact(psi, rho + k)[1] - exact(psi, rho - k)[1]) / (2 * k)
    for found, expected in zip(derivatives[2:], (*by_psi, by_rho), strict=True):
        assert np.abs(found - expected).max() < 1e-7 * max(1.0, np.abs(expected).max())
    normals = flank.normals_at(psi, rho)
    assert np.linalg.norm(normals, axis=-1) == pytest.approx(np.ones(psi.shape), abs=1e-14)
    for tangent in (x_psi, x_rho):
        unit = tangent / np.linalg.norm(tangent, axis=-1, keepdims=True)
        assert np.abs(np.sum(unit * normals, axis=-1)).max() < 1e-8


@over_flanks
def test_normals_point_out_of_the_metal(flank: InvoluteFlank) -> None:
    """Seen from the middle of the tooth, at the same cone distance and polar angle."""
    points, normals = flank.points(U, V), flank.normals(U, V)
    rho, delta = spherical(points)
    middle = flank.member.lengthwise.azimuth(rho)
    inside = np.stack([np.sin(delta) * np.cos(middle), np.sin(delta) * np.sin(middle), np.cos(delta)], -1)
    outward = points / rho[..., None] - inside
    assert np.all(np.sum(outward * normals, axis=-1) > 0)


@pytest.mark.parametrize("member", MEMBERS.values(), ids=MEMBERS)
def test_between_a_tooth_and_the_next_there_is_a_space(member: MemberGeometry) -> None:
    ahead, behind = InvoluteFlank(member, 1), InvoluteFlank(member, -1)
    next_tooth = behind.points(U, V) @ about_axis(2 * np.pi / member.teeth).T
    assert np.all(ahead.deviation(next_tooth) > 0)
    assert np.all(behind.deviation(ahead.points(U, V)) < 0)


@pytest.mark.parametrize("name", DESIGNS)
def test_the_other_hand_is_the_mirrored_gear(name: str) -> None:
    design = DESIGNS[name]
    hand = "left" if design.pair.pinion_hand == "right" else "right"
    mirrored = design.model_copy(update={"pair": design.pair.model_copy(update={"pinion_hand": hand})})
    for side in ("pinion", "wheel"):
        member, other = pair_geometry(design).member(side), pair_geometry(mirrored).member(side)
        for flank_name in FLANKS:
            points = involute_flank(member, flank_name).points(U, V)
            image = involute_flank(other, flank_name).points(U, V)
            assert np.abs(points * [1, -1, 1] - image).max() < 1e-13 * member.outer_cone_distance


@pytest.mark.parametrize("name", DESIGNS)
@pytest.mark.parametrize("factor", [0.25, 0.7])
def test_lengths_scale_with_the_module(name: str, factor: float) -> None:
    design = DESIGNS[name]
    scaled = made(
        **{
            **design.pair.model_dump(exclude={"offset", "face_width", "outer_module"}),
            **design.lengthwise.model_dump(exclude={"spiral_angle_of", "cutter_radius"}),
            **design.tooth.model_dump(exclude={"limit_pressure_angle_factor", "backlash"}),
            "outer_module": factor * design.pair.outer_module,
            "face_width": None if design.pair.face_width is None else factor * design.pair.face_width,
            "cutter_radius": factor * design.lengthwise.cutter_radius,
            "backlash": factor * design.tooth.backlash,
        }
    )
    for side in ("pinion", "wheel"):
        member, larger = pair_geometry(design).member(side), pair_geometry(scaled).member(side)
        for flank_name in FLANKS:
            points = involute_flank(member, flank_name).points(U, V)
            larger_points = involute_flank(larger, flank_name).points(U, V)
            assert np.abs(points * factor - larger_points).max() < 1e-12 * larger.outer_cone_distance


@pytest.mark.parametrize("curve", ["archimedean", "logarithmic"])
def test_without_a_spiral_angle_teeth_are_straight(curve: str) -> None:
    pair = pair_geometry(made(curve=curve, spiral_angle_deg=0.0))
    for member in (pair.pinion, pair.wheel):
        for name in FLANKS:
            flank = involute_flank(member, name)
            heel = flank.points_at(member.outer_cone_distance, np.linspace(member.base_angle, member.tip_angle, 9))
            toe = flank.points_at(member.inner_cone_distance, np.linspace(member.base_angle, member.tip_angle, 9))
            assert np.abs(np.cross(heel, toe)).max() < 1e-11  # elements run through the apex


def test_zerol_teeth_have_no_spiral_angle_at_the_mean_only() -> None:
    member = pair_geometry(made(spiral_angle_deg=0.0, cutter_radius=60.0)).wheel
    angles = member.lengthwise.spiral_angle(np.linspace(member.inner_cone_distance, member.outer_cone_distance, 3))
    assert angles[1] == pytest.approx(0.0, abs=1e-15)
    assert angles[0] < -0.05 and angles[2] > 0.05


def test_teeth_get_thinner_by_the_backlash_at_the_heel() -> None:
    widths = []
    for backlash in (0.0, 0.2):
        member = pair_geometry(made(backlash=backlash, ends="sphere")).wheel
        pitch_points = [InvoluteFlank(member, side).trace(1.0) for side in (1, -1)]
        azimuths = [np.arctan2(p[1], p[0]) for p in pitch_points]
        widths.append((azimuths[0] - azimuths[1]) * member.outer_cone_distance * np.sin(member.pitch_angle))
    assert widths[0] - widths[1] == pytest.approx(0.1, abs=1e-12)  # half of it from each member


def test_concave_is_the_side_of_the_hand() -> None:
    for hand, sides in (("right", (1, -1)), ("left", (-1, 1))):
        member = pair_geometry(made(pinion_hand=hand)).pinion
        assert tuple(involute_flank(member, name).side for name in FLANKS) == sides
        for name in FLANKS:
            assert involute_flank(member, name).name == name
            flank = involute_flank(member, name)
            # Lengthwise the concave flank bends away from its own normal's side.
            trace, middle = flank.trace([0.0, 1.0]), flank.trace(0.5)
            bend = (trace.mean(axis=0) - middle) @ flank.normals_at(
                *(float(x) for x in (np.arccos(np.cos(member.pitch_angle) / np.cos(member.base_angle)), 74.0))
            )
            assert np.sign(bend) == (1 if name == "concave" else -1)


def test_below_the_base_cone_there_is_no_flank() -> None:
    flank = involute_flank(pair_geometry(Design()).pinion, "concave")
    with pytest.raises(GeometryError):
        flank.points_at(70.0, flank.member.base_angle - 1e-6)


@pytest.mark.parametrize("member", MEMBERS.values(), ids=MEMBERS)
def test_even_division_is_even(member: MemberGeometry) -> None:
    points = involute_flank(member, "convex").evenly_divided(7, 5)
    rho, delta = spherical(points)
    ends = rho if member.ends == "sphere" else rho * np.cos(delta - member.pitch_angle)
    assert np.diff(ends, axis=1) == pytest.approx(np.full((7, 4), member.face_width / 4), rel=1e-11)
    steps = np.diff(delta, axis=0)
    assert steps == pytest.approx(np.broadcast_to(steps[0], steps.shape), rel=1e-9)
