"""Surface quality of flanks whose curvature is known: numbers, combs, arrows, contours, and what they are shown by."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearstudio.analysis.curvature import theory_curvature
from gearstudio.analysis.probe import probe, theory_at
from gearstudio.nurbs import NurbsSurface
from gearstudio.results import VariantResult
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.involute_flank import involute_flank
from tests.ui.made_up import member_of, result_of
from ui import colormap
from ui.layers import Layer, Style
from ui.scene import result_layers
from ui.views.appearance import Appearance, LayerLook, from_text, to_text
from ui.views.contours import contour_segments
from ui.views.dressing import LONGEST, combs, dressed, typical_curvature
from ui.views.quality import line_curvatures, variant_quality
from ui.views.quantities import nice_range, quantity_of, typical_range
from ui.views.zebra import Stripes

MEMBERS = ("pinion", "wheel")


@pytest.fixture(scope="module")
def made() -> dict[str, VariantResult]:
    """What the point cloud makes of the default pair."""
    from gearstudio.analysis.comparison import build_variant
    from gearstudio.design import Design

    return {name: build_variant(Design(), name, "point_cloud", "optimised") for name in MEMBERS}


class TestCurvature:
    @pytest.mark.parametrize("name", MEMBERS)
    def test_of_a_good_surface_is_that_of_theory(self, made, name):
        for quality in variant_quality(made[name], member_of("default", name)).values():
            for curvature in ("gaussian", "mean", "largest", "smallest"):
                inner = quality.values(curvature, "relative")[8:]
                assert np.nanpercentile(np.abs(inner), 90) < 2.0
                difference = quality.values(curvature, "absolute")
                share = 100 * difference / np.abs(quality.theory[curvature])
                assert quality.values(curvature, "relative") == pytest.approx(share, nan_ok=True)
                assert difference == pytest.approx(quality.made[curvature] - quality.theory[curvature], nan_ok=True)

    def test_is_not_told_where_it_is_infinite(self, made):
        member = member_of("default", "pinion")
        assert involute_flank(member, "concave").starts_on_base
        for quality in variant_quality(made["pinion"], member).values():
            assert np.all(np.isnan(quality.made["mean"][0])) and np.all(np.isfinite(quality.made["mean"][12:]))
            assert np.linalg.norm(quality.normals, axis=-1) == pytest.approx(1.0)

    def test_parameter_lines_lie_between_the_principal_curvatures(self, made):
        for quality in variant_quality(made["wheel"], member_of("default")).values():
            for line in (quality.profile, quality.lengthwise):
                good = np.isfinite(line)
                assert np.all(line[good] <= quality.made["largest"][good] + 1e-12)
                assert np.all(line[good] >= quality.made["smallest"][good] - 1e-12)

    def test_a_place_is_found_on_every_surface(self, made):
        for name in MEMBERS:
            member = member_of("default", name)
            for side in FLANKS:
                flank = involute_flank(member, side)
                point = flank.points(0.6, 0.3)
                rho, delta, _ = (float(x) for x in flank.locate(point))
                found = probe(made[name].flanks[side].surface, flank, rho, delta)
                assert found is not None and np.linalg.norm(found.point - point) < 1e-5
                assert abs(found.deviation_um) <= made[name].statistics.max_um * 1.01
                exact = theory_curvature(flank, 0.6, 0.3)
                assert theory_at(flank, rho, delta).mean == pytest.approx(float(exact.mean), rel=1e-9)
                assert found.curvature.mean == pytest.approx(float(exact.mean), rel=1e-2)
                assert probe(made[name].flanks[side].surface, flank, 2 * rho, delta) is None


def sphere_patch(radius: float) -> NurbsSurface:
    """An eighth of a sphere around the origin, exactly."""
    corners, middle = np.array([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]), np.array([1.0, np.sqrt(0.5), 1.0])
    (x, y), (r, z) = corners.T[:, :, None], corners.T[:, None, :]
    poles = radius * np.stack([x * r, y * r, np.broadcast_to(z, (3, 3))], axis=-1)
    knots = np.repeat([0.0, 1.0], 3)
    return NurbsSurface(poles, knots, knots, 2, 2, np.outer(middle, middle))


class TestDressing:
    def test_colours_change_and_the_deviation_stays(self, made):
        member, result = member_of("default"), made["wheel"]
        layers = result_layers(result)
        quality = variant_quality(result, member)
        worn = dressed(layers, result, quality, Appearance(quantity="mean"), 1.0)
        colored = {x.part: x for x in worn if x.layer_id == "deviation" and x.kind == "surface"}
        for name, layer in colored.items():
            assert layer.scalars == pytest.approx(quality[name].made["mean"].ravel(), nan_ok=True)
            assert layer.deviation == pytest.approx(result.flanks[name].deviation_um.ravel())
            plain = next(x for x in layers if x.key == layer.key)
            assert np.sum(layer.normals * plain.normals) > 0.99 * len(layer.points)

    def test_colours_tell_nothing_before_the_numbers_are_there(self, made):
        worn = dressed(result_layers(made["wheel"]), made["wheel"], None, Appearance(quantity="gaussian"), 0.0)
        assert all(np.all(np.isnan(x.scalars)) for x in worn if x.scalars is not None)

    @pytest.mark.parametrize("along", ["profile", "lengthwise"])
    def test_combs_are_as_long_as_the_line_is_curved(self, made, along):
        member, result = member_of("default"), made["wheel"]
        quality = variant_quality(result, member)
        typical = typical_curvature([quality], along)
        lengths = {}
        for scale in (1.0, 2.0):
            look = Appearance(combs=along, comb_scale=scale)
            one = quality["concave"]
            found = combs("concave", result.flanks["concave"].points, one, look, typical)
            pieces = np.concatenate([x.points.reshape(-1, 2, 3) for x in found if len(x.points)])
            lengths[scale] = np.linalg.norm(pieces[:, 1] - pieces[:, 0], axis=-1).max()
        assert lengths[2.0] == pytest.approx(2 * lengths[1.0], rel=1e-6)
        diagonal = np.linalg.norm(result.flanks["concave"].points[-1, -1] - result.flanks["concave"].points[0, 0])
        assert 0.02 * diagonal < lengths[1.0] <= LONGEST * 0.16 * diagonal * (1 + 1e-9)

    def test_nothing_is_made_of_results_without_curvature(self):
        member = member_of("straight")
        result = result_of(member, lambda u, v: 0 * u)
        assert dressed(result_layers(result), result, None, Appearance(), 0.0)


def test_contours_lie_where_the_value_is():
    grid = np.stack(np.meshgrid(np.linspace(0, 1, 7), np.linspace(0, 1, 5), indexing="ij"), axis=-1)
    points = np.concatenate([grid, np.zeros((7, 5, 1))], axis=-1).reshape(-1, 3)
    from ui.grids import grid_triangles

    layer = Layer("deviation", "x", "surface", points, Style(None), grid_triangles(7, 5), None, 3 * points[:, 0] - 1)
    segments = contour_segments(layer, (0.0, 1.1, 5.0))
    assert len(segments) and np.unique(np.round(3 * segments[..., 0] - 1, 9)) == pytest.approx([0.0, 1.1])
    total = np.linalg.norm(segments[:, 1] - segments[:, 0], axis=-1).sum()
    assert total == pytest.approx(2.0)
    holes = replace(layer, scalars=np.full(len(points), np.nan))
    assert not len(contour_segments(holes, (0.0,)))


class TestScale:
    def test_a_typical_range_is_round_and_its_extent_honest(self):
        values = np.concatenate([np.linspace(-0.0012, 0.034, 1000), [np.nan, 9.0]])
        (low, high), extent = typical_range(quantity_of(Appearance(quantity="mean")), [values])
        assert low <= -0.0008 and 0.033 < high < 0.04 and extent == (pytest.approx(-0.0012), 9.0)
        (low, high), _ = typical_range(quantity_of(Appearance(quantity="mean", against="relative")), [values])
        assert low == -high
        assert typical_range(quantity_of(Appearance(quantity="mean")), [np.array([np.nan])]) is None

    def test_equal_values_still_have_a_scale(self):
        low, high = nice_range(2.0, 2.0)
        assert low < 2.0 < high

    @pytest.mark.parametrize(("unit", "shown"), [("um", "+1.00 µm"), ("nm", "+1000 nm"), ("uin", "+39.4 µin")])
    def test_deviations_have_units_to_choose_from(self, unit, shown):
        assert quantity_of(Appearance()).text(1.0, unit) == shown

    @pytest.mark.parametrize("name", sorted(colormap.MAPS))
    def test_lightness_tells_all_maps_apart(self, name):
        light = colormap.table(name).astype(float) @ [0.2126, 0.7152, 0.0722]
        halves = np.split(light, [129]) if name in ("balance", "purple_green") else [light]
        assert all(np.all(np.diff(np.sign(np.diff(half[::16]))) == 0) for half in halves)
        assert len(np.unique(colormap.table(name, 8), axis=0)) == 8


class TestAppearance:
    def test_is_remembered(self):
        chosen = Appearance(quantity="mean", zebra=True, stripes=Stripes(12, True, 30.0), ground="black", linked=False)
        chosen = chosen.with_look("tooth", LayerLook("#102030", 0.25))
        assert from_text(to_text(chosen)) == chosen
        assert chosen.with_look("tooth", LayerLook()).looks == {}

    @pytest.mark.parametrize("text", ["", "[]", "{", '{"quantity": "nonsense", "steps": 7, "stripes": {"count": 0}}'])
    def test_nonsense_is_forgotten(self, text):
        assert from_text(text) == Appearance()


def test_stripes_fixed_to_the_camera_stay_and_those_of_the_gear_turn():
    from ui.camera import Camera

    look = Camera(np.zeros(3), np.array([1.0, 0, 0]), np.array([0, 0, -1.0]), 1.0)
    turned = look.turned(0.4, 0.2)
    camera, gear = Stripes(20, False, 30.0), Stripes(20, True, 30.0)
    assert camera.direction(look) == pytest.approx(camera.direction(turned))
    assert not np.allclose(gear.direction(look), gear.direction(turned))
    assert np.linalg.norm(gear.direction(turned)) == pytest.approx(1.0)


def test_lines_on_a_sphere_are_curved_as_the_sphere():
    surface, u, v = sphere_patch(25.0), np.array([0.3, 0.6]), np.array([0.2, 0.5])
    points = surface.grid(u, v)
    assert np.linalg.norm(points, axis=-1) == pytest.approx(25.0)
    for curvature in line_curvatures(surface, u, v, points / 25.0):
        assert curvature == pytest.approx(1 / 25.0)
