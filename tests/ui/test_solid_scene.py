"""Meshes of whole gears: closed, outward, as exact as asked for, and cut by planes."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np
import pytest

from gearstudio.design import Design
from gearstudio.presets import PRESETS
from gearstudio.results import SolidResult
from gearstudio.theory.chamfer import end_chamfers
from gearstudio.theory.cones import MemberGeometry, PairGeometry, pair_geometry
from gearstudio.theory.involute_flank import InvoluteFlank
from gearstudio.theory.pair import pinion_placement, wheel_placement
from tests.ui.made_up_solid import solid_of
from tests.volume import gear_volume
from ui.meshes import Mesh, joined, stitched
from ui.section import Plane, filled, outline
from ui.solid_layers import PlacedGear, SolidOptions, base_place, gear_layers, motion, put
from ui.solid_scene import COARSE, FINE, GearMesh, gear_mesh, gear_radius

DESIGNS = {
    "default": {},
    "straight": {"lengthwise": {"curve": "archimedean", "spiral_angle_deg": 0.0}},
    "spheres": {"tooth": {"ends": "sphere", "tip_cone": "constant_clearance"}, "pair": {"pinion_hand": "right"}},
    "web and shank": {
        "blank": {
            "wheel": {"web_thickness": 9.0, "hub_length": 22.0, "bore_diameter": 30.0},
            "pinion": {"shank_diameter": 18.0, "shank_length": 30.0},
        }
    },
    "many teeth": {"pair": {"pinion_teeth": 40, "wheel_teeth": 150}},
}
EVERY = [(name, member) for name in DESIGNS for member in ("pinion", "wheel")]


@lru_cache
def design(name: str) -> Design:
    return Design.model_validate(DESIGNS[name])


@lru_cache
def pair(name: str) -> PairGeometry:
    return pair_geometry(design(name))


@lru_cache
def solid(name: str, member: str) -> tuple[SolidResult, MemberGeometry]:
    return solid_of(design(name), member), pair(name).member(member)


@lru_cache
def mesh(name: str, member: str, fineness: float = FINE) -> GearMesh:
    return gear_mesh(*solid(name, member), fineness)


def areas(part: Mesh) -> np.ndarray:
    a, b, c = np.moveaxis(part.points[part.cells], 1, 0)
    return np.cross(b - a, c - a) / 2


@pytest.mark.parametrize(("name", "member"), EVERY)
def test_the_meshes_close_each_other(name: str, member: str) -> None:
    """Area vectors of a closed surface add up to nothing, and its volume is the same seen from anywhere."""
    whole = joined([mesh(name, member).flanks, mesh(name, member).teeth, mesh(name, member).body])
    vectors = areas(whole)
    total = np.linalg.norm(vectors, axis=1).sum()
    assert np.abs(vectors.sum(axis=0)).max() < 1e-6 * total
    moved = Mesh(whole.points + 1000.0, whole.normals, whole.cells)
    assert moved.enclosed == pytest.approx(whole.enclosed, rel=1e-4)


@pytest.mark.parametrize(("name", "member"), EVERY)
def test_triangles_turn_outward_as_the_normals_say(name: str, member: str) -> None:
    made = mesh(name, member)
    assert made.volume > 0
    for part in (made.flanks, made.teeth, made.body):
        assert np.allclose(np.linalg.norm(part.normals, axis=1), 1.0, atol=1e-9)
        vectors = areas(part)
        agree = np.einsum("ij,ij->i", vectors, part.normals[part.cells].mean(axis=1))
        assert agree[agree < 0].sum() > -5e-3 * agree.sum()


@pytest.mark.parametrize(("name", "member"), EVERY)
def test_a_coarse_mesh_is_off_by_no_more_than_its_tolerance(name: str, member: str) -> None:
    fine, coarse = mesh(name, member, 2e-5), mesh(name, member, COARSE)
    area = sum(np.linalg.norm(areas(part), axis=1).sum() for part in (fine.flanks, fine.teeth, fine.body))
    tolerance = COARSE * gear_radius(solid(name, member)[0])
    assert abs(coarse.volume - fine.volume) < tolerance * area
    assert coarse.triangles < mesh(name, member).triangles < fine.triangles


@pytest.mark.parametrize("member", ["pinion", "wheel"])
def test_flanks_lie_on_theory_with_its_normals(member: str) -> None:
    result, geometry = solid("default", member)
    made = mesh("default", member)
    assert np.abs(made.deviation_um).max() < 0.5
    assert len(made.deviation_um) == len(made.flanks.points)
    flank, count = InvoluteFlank(geometry, 1), len(made.flanks.points) // result.teeth
    points, normals = made.flanks.points[:count], made.flanks.normals[:count]
    rho, delta, phi = flank.locate(points)
    own = (phi > geometry.lengthwise.azimuth(rho)) & (delta > geometry.base_angle + 1e-6)
    psi = np.arccos(np.cos(delta[own]) / np.cos(geometry.base_angle))
    exact = flank.normals_at(psi, rho[own])
    assert own.sum() > 20
    assert np.einsum("ij,ij->i", exact, normals[own]).min() > 1 - 1e-6


def test_edges_lie_on_the_surface_and_go_all_round() -> None:
    made = mesh("default", "wheel")
    used = made.edges[np.unique(made.segments)]
    everything = joined([made.flanks, made.teeth, made.body]).points
    found = {tuple(p) for p in np.round(everything, 6)}
    assert np.mean([tuple(p) in found for p in np.round(used, 6)]) > 0.98
    azimuth = np.sort(np.arctan2(used[:, 1], used[:, 0]))
    assert np.diff(azimuth).max() < 0.1


@pytest.mark.kernel
@pytest.mark.parametrize("member", ["pinion", "wheel"])
def test_the_mesh_encloses_what_the_kernel_weighs(member: str) -> None:
    from gearstudio.jobs import GearJob

    chosen = next(preset.design for preset in PRESETS if preset.key == "automotive")
    result = GearJob(chosen, member, "point_cloud", "optimised").run(lambda _stage, _fraction: None)
    geometry = pair_geometry(chosen).member(member)
    for fineness in (FINE, COARSE):
        made = gear_mesh(result, geometry, fineness)
        tolerance = fineness * gear_radius(result)
        assert abs(made.volume - result.properties.volume) < tolerance * result.properties.area
    assert np.abs(gear_mesh(result, geometry).deviation_um).max() < 0.2


# ---- stitching and sections --------------------------------------------------------------------------------


@pytest.mark.parametrize(("n", "m"), [(3, 3), (5, 17), (40, 7), (13, 13)])
def test_two_loops_are_stitched_without_gaps(n: int, m: int) -> None:
    rng = np.random.default_rng(n * m)
    one, other = (np.sort(rng.uniform(-np.pi, np.pi, count)) for count in (n, m))
    cells = stitched(one, other)
    assert len(cells) == n + m
    edges = np.concatenate([cells[:, [0, 1]], cells[:, [1, 2]], cells[:, [2, 0]]])
    keys, counts = np.unique(np.sort(edges, axis=1), axis=0, return_counts=True)
    rims = counts == 1
    assert rims.sum() == n + m and np.all(counts[~rims] == 2)
    assert all((a < n) == (b < n) for a, b in keys[rims])


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_areas_of_sections_add_up_to_the_volume(axis: int) -> None:
    made = mesh("web and shank", "wheel")
    parts = (made.flanks, made.teeth, made.body)
    points = joined(list(parts)).points[:, axis]
    places = np.linspace(points.min(), points.max(), 301)
    middles = (places[1:] + places[:-1]) / 2
    sections = [filled(outline(parts, Plane(axis, float(place))), Plane(axis, float(place))) for place in middles]
    total = sum(np.linalg.norm(areas(part), axis=1).sum() for part in sections) * (places[1] - places[0])
    assert total == pytest.approx(made.volume, rel=3e-3)


def test_a_section_lies_in_its_plane_and_looks_at_what_is_taken_away() -> None:
    made = mesh("default", "pinion")
    for sign in (1, -1):
        plane = Plane(1, 3.0, sign)
        face = filled(outline((made.flanks, made.teeth, made.body), plane), plane)
        assert np.allclose(face.points[:, 1], 3.0) and np.allclose(face.normals, [0, sign, 0])
        assert plane.beyond(np.array([0.0, 3.0 + sign, 0.0])) == 1.0
    nothing = Plane(1, 1e6)
    assert not len(outline((made.body,), nothing)) and not len(filled(np.empty((0, 2, 3)), nothing).cells)


# ---- the pair ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["default", "straight", "spheres"])
@pytest.mark.parametrize("turn", [0.0, 0.05, -0.11, 1.3])
def test_the_pair_touches_on_both_sides_and_nothing_crosses(name: str, turn: float) -> None:
    geometry = pair(name)
    wheel = geometry.wheel
    into_wheel = wheel_placement(geometry, turn).T @ pinion_placement(geometry, turn)
    made = mesh(name, "pinion")
    near = []
    points = made.flanks.points @ into_wheel.T
    rho, delta, phi = InvoluteFlank(wheel, 1).locate(points)
    rho_u = wheel.end_distance(rho, delta)
    inside = (rho_u > wheel.inner_cone_distance) & (rho_u < wheel.outer_cone_distance)
    inside &= (delta > wheel.base_angle + 0.002) & (delta < wheel.limit_angle(wheel.tip_limit, rho_u))
    turned = phi - wheel.lengthwise.azimuth(rho)
    tooth = np.round(turned / wheel.pitch) * wheel.pitch
    for side in (1, -1):
        beside = inside & (np.sign(np.angle(np.exp(1j * (turned - tooth)))) == side)
        back = tooth[beside]
        x, y, z = points[beside].T
        own = np.stack([x * np.cos(back) + y * np.sin(back), y * np.cos(back) - x * np.sin(back), z], axis=-1)
        gap = InvoluteFlank(wheel, side).deviation(own)
        near.append(gap.min())
    assert max(abs(gap) for gap in near) < 4e-3 * wheel.module, near
    assert min(near) > -1e-4


def test_a_placed_gear_turns_as_the_placement_says() -> None:
    geometry = pair("default")
    for member, place in (("pinion", pinion_placement), ("wheel", wheel_placement)):
        made = mesh("default", member)
        gear = put(PlacedGear(member, made, made), base_place(geometry, member))
        turned = motion(geometry, member, 0.7).of(gear.fine.flanks.points)
        assert np.allclose(turned, made.flanks.points @ place(geometry, 0.7).T, atol=1e-9)
        still = motion(geometry, member, 0.0)
        assert np.allclose(still.matrix, np.eye(3)) and np.allclose(still.shift, 0)


def test_both_levels_are_layers_that_move_and_only_flanks_carry_the_deviation() -> None:
    gear = PlacedGear("wheel", mesh("default", "wheel"), mesh("default", "wheel", COARSE))
    layers = gear_layers(gear, SolidOptions(edges=True, deviation=True))
    assert {layer.level for layer in layers} == {"fine", "coarse"} and {layer.body for layer in layers} == {"wheel"}
    assert len({layer.key for layer in layers}) == len(layers) == 8
    colored = [layer for layer in layers if layer.scalars is not None]
    assert [layer.part for layer in colored] == ["wheel flanks fine", "wheel flanks coarse"]
    plain = gear_layers(gear, SolidOptions(edges=False))
    assert all(layer.kind == "surface" and layer.scalars is None for layer in plain)


@pytest.mark.parametrize("ends", ["back_cone", "sphere"])
def test_chamfers_are_drawn_and_all_meshes_still_close_each_other(ends: str) -> None:
    data = design("default").model_dump()
    data["tooth"]["ends"] = ends
    made = Design.model_validate(data)
    geometry = pair_geometry(made).pinion
    plain, chamfered = (replace(solid_of(made, "pinion"), end_chamfer=length) for length in (0.0, 3.0))
    whole, cut = (gear_mesh(result, geometry) for result in (plain, chamfered))
    wanted = [gear_volume(geometry, plain.outline, end_chamfers(geometry, length)) for length in (0.0, 3.0)]
    assert cut.volume / whole.volume == pytest.approx(wanted[1] / wanted[0], abs=5e-4)
    assert wanted[1] < 0.995 * wanted[0]
    for chamfer in end_chamfers(geometry, 3.0):
        assert chamfer.beyond(cut.flanks.points).max() < 1e-5 < chamfer.beyond(whole.flanks.points).max()
    vectors = sum((areas(part).sum(axis=0) for part in (cut.flanks, cut.teeth, cut.body)), np.zeros(3))
    assert np.abs(vectors).max() < 1e-3
