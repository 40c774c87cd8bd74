"""Micro-geometry through the methods: who follows it, who says that it does not, and the teeth made from it."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, given, settings

from gearstudio.analysis.comparison import build_variant
from gearstudio.catalogue import MEMBERS, METHOD_IDS, VARIANTS
from gearstudio.cli.compare import variant_record
from gearstudio.design import Design, with_field
from gearstudio.kernel.solids import check_solid
from gearstudio.methods import Target, method
from gearstudio.methods.gear import build_gear, design_tooth, target_of
from gearstudio.methods.single import tooth_solid
from gearstudio.methods.tooth import Tooth, ToothFace
from gearstudio.nurbs import NurbsSurface, basis_matrix
from gearstudio.presets import PRESETS_BY_KEY
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.modified import flank_of, flank_on
from tests.strategies import modified_designs
from tests.theory.test_modified import modified
from tests.volume import gear_volume

pytestmark = pytest.mark.kernel

Floats = np.ndarray
FINE = np.unique(np.r_[np.linspace(0.0, 1.0, 61) ** 1.07, 1e-4, 1e-3, 1 - 1e-4, 1 - 1e-3])
EVEN = np.linspace(0.0, 1.0, 41)
FOLLOWING = [id for id in METHOD_IDS if id != "rotating_line"]
PRESETS = ["default", "zerol", "automotive", "logarithmic"]


@pytest.mark.parametrize("method_id", FOLLOWING)
@pytest.mark.parametrize("member", MEMBERS)
@pytest.mark.parametrize("preset", PRESETS)
def test_optimised_reaches_the_tolerance_on_the_modified_flank(preset: str, member: str, method_id: str) -> None:
    design = modified(PRESETS_BY_KEY[preset].design)
    result = build_variant(design, member, method_id, "optimised")
    assert result.statistics.max_um <= design.methods.tolerance_um
    assert "modifications" not in result.settings
    for name in FLANKS:
        flank = flank_of(pair_geometry(design).member(member), name)
        points = result.flanks[name].surface.grid(FINE, FINE)
        assert 1e3 * np.abs(flank.deviation(points)).max() <= design.methods.tolerance_um
        assert 1e3 * flank.edge_deviation(points) <= design.methods.tolerance_um


@pytest.mark.parametrize("member", MEMBERS)
@pytest.mark.parametrize("variant", VARIANTS)
def test_the_rotating_line_misses_by_what_is_taken_off_and_says_so(member: str, variant: Any) -> None:
    design = modified(Design())
    plain, result = (build_variant(d, member, "rotating_line", variant) for d in (Design(), design))
    assert result.settings["modifications"] == "left out"
    assert "modifications" not in plain.settings
    assert variant_record(result)["settings"]["modifications"] == "left out"
    for name in FLANKS:
        assert np.array_equal(result.flanks[name].surface.poles, plain.flanks[name].surface.poles)
        flank = flank_of(pair_geometry(design).member(member), name)
        taken = 1e3 * flank.relief.value(*flank.locate(result.flanks[name].points)[:2])  # type: ignore[attr-defined]
        extra = result.flanks[name].deviation_um - plain.flanks[name].deviation_um
        assert extra == pytest.approx(taken, rel=0.05, abs=0.3)  # one is along the modified normal


def by_kind(tooth: Tooth, side: int) -> dict[str, ToothFace]:
    return {face.kind: face for face in tooth.faces if face.side in (side, 0)}


def normals(face: ToothFace, end: float, row: float = 0.0) -> Floats:
    """Normals of a face along an edge: of its lower (0) or upper (1) end, from the root up."""
    u = np.array([abs(end - row)])
    s: NurbsSurface = face.surface
    if face.side > 0:
        u = 1 - u
    by_u = np.einsum(
        "ai,ijk,bj->abk", basis_matrix(u, s.knots_u, s.degree_u, 1), s.poles, basis_matrix(EVEN, s.knots_v, s.degree_v)
    )
    by_v = np.einsum(
        "ai,ijk,bj->abk", basis_matrix(u, s.knots_u, s.degree_u), s.poles, basis_matrix(EVEN, s.knots_v, s.degree_v, 1)
    )
    cross = np.cross(by_u, by_v)[0]
    return np.asarray(cross / np.linalg.norm(cross, axis=-1, keepdims=True))


@pytest.mark.parametrize("method_id", METHOD_IDS)
@pytest.mark.parametrize(("preset", "member"), [("default", "pinion"), ("zerol", "wheel"), ("logarithmic", "pinion")])
def test_faces_of_a_modified_tooth_join_and_are_tangent(preset: str, member: str, method_id: str) -> None:
    tooth = design_tooth(modified(PRESETS_BY_KEY[preset].design), member, method_id, "optimised")
    for side in (-1, 1):
        faces = by_kind(tooth, side)
        names = [name for name in ("fillet", "meridian", "flank") if name in faces]
        for lower, upper in pairwise(names):
            # on the base cone the flank's first derivative vanishes, so its normal is taken a little above
            on_base = upper == "flank" and tooth.profile.fillet.on_meridian
            below, above = normals(faces[lower], 1.0), normals(faces[upper], 0.0, 0.02 if on_base else 0.0)
            angle = np.degrees(np.arccos(np.clip(np.sum(below * above, axis=-1), -1.0, 1.0))).max()
            assert angle < (1.5 if on_base else 0.1), (lower, upper)


@pytest.mark.parametrize("method_id", METHOD_IDS)
@pytest.mark.parametrize("variant", VARIANTS)
@pytest.mark.parametrize(("preset", "member"), [("default", "pinion"), ("automotive", "wheel")])
def test_modified_teeth_are_valid_solids(preset: str, member: str, method_id: str, variant: Any) -> None:
    design = modified(PRESETS_BY_KEY[preset].design)
    tooth = design_tooth(design, member, method_id, variant)
    check = check_solid(tooth_solid(tooth, target_of(design, tooth.member)).solid)
    assert check.valid and check.closed
    flanks = [face for face in tooth.faces if face.kind == "flank"]
    member_geometry = pair_geometry(design).member(member)
    for face in flanks:
        missed = 1e3 * flank_on(member_geometry, face.side).deviation(face.surface.uniform_grid(21, 21))
        if method_id != "rotating_line" and variant == "optimised":
            assert np.abs(missed).max() < design.methods.tolerance_um


def test_a_modified_gear_weighs_what_theory_says() -> None:
    few = with_field(Design(), "pair.pinion_teeth", 9)
    design = modified(few)
    gear = build_gear(design, "pinion", "point_cloud", "optimised")
    check = check_solid(gear.solid)
    assert check.valid and check.closed
    plain = pair_geometry(few).pinion
    wanted, unmodified = (gear_volume(m, gear.outline.points) for m in (gear.member, plain))
    assert check.volume == pytest.approx(wanted, rel=1e-6)
    assert unmodified - wanted > 1e-4 * wanted


@pytest.mark.timeout(300)
@settings(
    max_examples=10,
    deadline=None,
    derandomize=True,
    database=None,
    phases=(Phase.generate,),
    suppress_health_check=list(HealthCheck),
)
@given(modified_designs())
def test_random_modified_flanks_are_followed(design: Design) -> None:
    for name in MEMBERS:
        member = pair_geometry(design).member(name)
        target = Target.for_cone_distance(0.05, member.outer_cone_distance)
        for method_id in FOLLOWING:
            for flank_name in FLANKS:
                flank = flank_of(member, flank_name)
                points = method(method_id).build(flank, "optimised", target).surface.grid(FINE, FINE)
                assert np.abs(flank.deviation(points)).max() <= target.tolerance, (name, method_id)
                assert flank.edge_deviation(points) <= target.tolerance, (name, method_id)
