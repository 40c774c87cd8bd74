"""The faces of a tooth against theory: flanks, fillets, tangency, and the pair in mesh."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from gearstudio.catalogue import METHOD_IDS
from gearstudio.design import Design, with_field
from gearstudio.jobs import ExportJob
from gearstudio.kernel.step import read_flanks_step
from gearstudio.methods.gear import design_tooth, ignore, target_of
from gearstudio.methods.single import tooth_solid
from gearstudio.methods.tooth import Tooth, ToothFace
from gearstudio.nurbs import NurbsSurface, basis_matrix
from gearstudio.presets import PRESETS_BY_KEY
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.pair import about_axis, pinion_placement, wheel_placement
from tests.kernel.gears import off_fillet

pytestmark = pytest.mark.kernel

Floats = NDArray[np.float64]
FINE = np.linspace(0.0, 1.0, 41)
CASES = [("default", "pinion"), ("automotive", "wheel"), ("logarithmic", "pinion"), ("zerol", "wheel")]


@pytest.fixture(params=CASES, ids=lambda case: "-".join(case))
def tooth(request: pytest.FixtureRequest) -> Tooth:
    preset, member = request.param
    return design_tooth(PRESETS_BY_KEY[preset].design, member, "rotating_line", "optimised")


def rising(face: ToothFace) -> tuple[Floats, Floats]:
    """Points and unit normals of a face from the root's side up (u), toe to heel (v)."""
    u = FINE[::-1] if face.side > 0 else FINE
    return face.surface.grid(u, FINE), normals(face.surface, u, FINE)


def normals(s: NurbsSurface, u: Floats, v: Floats) -> Floats:
    bu, bv = basis_matrix(u, s.knots_u, s.degree_u), basis_matrix(v, s.knots_v, s.degree_v)
    du, dv = basis_matrix(u, s.knots_u, s.degree_u, 1), basis_matrix(v, s.knots_v, s.degree_v, 1)
    by_u = np.einsum("ai,ijk,bj->abk", du, s.poles, bv)
    by_v = np.einsum("ai,ijk,bj->abk", bu, s.poles, dv)
    cross = np.cross(by_u, by_v)
    length = np.linalg.norm(cross, axis=-1, keepdims=True)
    return np.asarray(cross / np.where(length > 0, length, 1.0))


def degrees_between(a: Floats, b: Floats) -> float:
    return float(np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b), axis=-1), np.sum(a * b, axis=-1))).max())


def by_kind(tooth: Tooth, side: int) -> dict[str, ToothFace]:
    return {face.kind: face for face in tooth.faces if face.side in (side, 0)}


@pytest.mark.parametrize("side", [-1, 1])
def test_fillets_lie_on_the_circle_of_theory(tooth: Tooth, side: int) -> None:
    points, _ = rising(by_kind(tooth, side)["fillet"])
    assert np.abs(off_fillet(tooth, side, points)).max() < 1e-3 * max(1.0, tooth.member.outer_cone_distance / 250)


@pytest.mark.parametrize("side", [-1, 1])
def test_flank_fillet_and_root_are_tangent(tooth: Tooth, side: int) -> None:
    faces = by_kind(tooth, side)
    names = [name for name in ("fillet", "meridian", "flank") if name in faces]
    for lower, upper in pairwise(names):
        below, above = rising(faces[lower]), rising(faces[upper])
        assert np.abs(below[0][-1] - above[0][0]).max() < 1e-9 * tooth.member.outer_cone_distance
        if not (upper == "flank" and tooth.profile.fillet.on_meridian):
            assert degrees_between(below[1][-1], above[1][0]) < 0.1
    if "root" in faces:
        fillet, root = faces["fillet"], normals(faces["root"].surface, FINE, FINE)
        at_root = root[0] if side > 0 else root[-1] @ about_axis(-tooth.member.pitch).T
        there = normals(fillet.surface, np.array([1.0 if side > 0 else 0.0]), FINE)[0]
        assert degrees_between(there, at_root) < 0.1


@pytest.mark.parametrize("method", METHOD_IDS)
@pytest.mark.parametrize("preset", ["default", "automotive", "zerol"])
def test_a_flank_leaves_the_base_cone_tangentially(preset: str, method: str) -> None:
    """There its first derivative vanishes, so the kernel's normals are looked at on the way to the edge."""
    tooth = design_tooth(PRESETS_BY_KEY[preset].design, "pinion", method, "optimised")
    assert tooth.profile.fillet.on_meridian
    for side in (-1, 1):
        faces = by_kind(tooth, side)
        lower, flank = faces["meridian" if "meridian" in faces else "fillet"], faces["flank"]
        top, foot = (1.0, 0.0) if side < 0 else (0.0, 1.0)
        below = kernel_normals(lower, top)
        angles = [degrees_between(below, kernel_normals(flank, abs(foot - share))) for share in (1e-2, 1e-3, 1e-4)]
        assert angles[0] < 1.0
        assert angles[1] < 0.15 * angles[0]
        assert angles[2] < 0.02


def kernel_normals(face: ToothFace, u: float) -> Floats:
    """Unit normals along the face at u, as the kernel has them."""
    from OCP.GeomLProp import GeomLProp_SLProps

    from gearstudio.kernel.convert import to_surface

    surface = to_surface(face.surface)
    found = [GeomLProp_SLProps(surface, u, v, 1, 1e-12).Normal() for v in FINE.tolist()]
    return np.array([(n.X(), n.Y(), n.Z()) for n in found])


@pytest.mark.parametrize("method", METHOD_IDS)
def test_flanks_in_the_file_of_a_whole_gear_are_those_of_theory(method: str, tmp_path: Path) -> None:
    design = with_field(Design(), "pair.wheel_teeth", 18)
    (file,) = ExportJob(design, "wheel", "gear", method, "optimised", ("step",), tmp_path).run(ignore)
    assert file.check is not None
    assert (file.check.valid, file.check.closed, file.check.solids) == (True, True, 1)
    faces = read_flanks_step(file.path)
    member = pair_geometry(design).wheel
    tooth = design_tooth(design, "wheel", method, "optimised")
    assert sum(name.endswith(" concave") for name in faces) == 18
    for side in (-1, 1):
        flank = tooth.profile.flank(side)
        for number in (1, 7):
            points = (
                faces[f"tooth {number} {flank.name}"].uniform_grid(31, 31) @ about_axis(-(number - 1) * member.pitch).T
            )
            assert np.abs(flank.deviation(points)).max() < 1e-4


def test_teeth_in_mesh_touch_but_do_not_cut() -> None:
    """With backlash the solids share no volume; a little turn makes them."""
    design = with_field(Design(), "tooth.backlash", 0.04)
    pair = pair_geometry(design)
    solids = {}
    for name in ("pinion", "wheel"):
        tooth = design_tooth(design, name, "profile_sweep", "optimised")
        solids[name] = tooth_solid(tooth, target_of(design, tooth.member)).solid
    step = 2 * np.pi / 40
    for turn in (-0.1, 0.0, 0.07):
        for index in (-1, 0):
            wheel = wheel_placement(pair, turn) @ about_axis(index * step)
            assert shared_volume(solids, pinion_placement(pair, turn), wheel) < 1e-6
    turned = pinion_placement(pair, np.radians(0.5))
    shared = [shared_volume(solids, turned, wheel_placement(pair) @ about_axis(i * step)) for i in (-1, 0)]
    assert max(shared) > 1e-2


def shared_volume(solids: dict[str, object], pinion: Floats, wheel: Floats) -> float:
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Common
    from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform

    from gearstudio.kernel.document import location
    from gearstudio.kernel.solids import solid_volume
    from gearstudio.theory.place import Place

    placed = [
        BRepBuilderAPI_Transform(solids[name], location(Place(matrix)).Transformation(), True).Shape()
        for name, matrix in (("pinion", pinion), ("wheel", wheel))
    ]
    return abs(solid_volume(BRepAlgoAPI_Common(*placed).Shape()))
