"""Bounding boxes are those of the metal: of bodies with formulas, and of gears against their own meshes."""

from __future__ import annotations

import numpy as np
import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepBuilderAPI import BRepBuilderAPI_NurbsConvert, BRepBuilderAPI_Transform
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCylinder, BRepPrimAPI_MakeSphere, BRepPrimAPI_MakeTorus
from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt, gp_Trsf

from gearstudio.kernel.boxes import bounding_box
from gearstudio.methods.gear import Gear, build_gear
from gearstudio.methods.gear_mesh import gear_mesh
from tests.kernel.gears import Changes, changed

pytestmark = pytest.mark.kernel

BODIES = {
    "sphere": (BRepPrimAPI_MakeSphere(3.0), [[-3, -3, -3], [3, 3, 3]]),
    "half a sphere": (BRepPrimAPI_MakeSphere(3.0, 0.0, np.pi / 2), [[-3, -3, 0], [3, 3, 3]]),
    "zone": (BRepPrimAPI_MakeSphere(5.0, np.arcsin(0.6), np.arcsin(0.8)), [[-4, -4, 3], [4, 4, 4]]),
    "torus": (BRepPrimAPI_MakeTorus(5.0, 1.0), [[-6, -6, -1], [6, 6, 1]]),
    "cylinder": (BRepPrimAPI_MakeCylinder(2.0, 6.0), [[-2, -2, 0], [2, 2, 6]]),
}


@pytest.mark.parametrize("as_spline", [False, True])
@pytest.mark.parametrize("name", BODIES)
def test_bodies_reach_as_far_as_their_formulas_say(name: str, as_spline: bool) -> None:
    maker, wanted = BODIES[name]
    shape = BRepBuilderAPI_NurbsConvert(maker.Shape()).Shape() if as_spline else maker.Shape()
    assert bounding_box(shape) == pytest.approx(np.array(wanted, dtype=float), abs=1e-6)


def test_a_turned_cylinder_reaches_beyond_its_corners() -> None:
    turn = gp_Trsf()
    turn.SetRotation(gp_Ax1(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(0.0, 1.0, 0.0)), np.pi / 4)
    box = bounding_box(BRepBuilderAPI_Transform(BRepPrimAPI_MakeCylinder(2.0, 6.0).Shape(), turn, True).Shape())
    assert box * np.sqrt(2) == pytest.approx(np.array([[-2, -np.sqrt(8), -2], [8, np.sqrt(8), 8]]), abs=1e-6)


def test_a_sphere_cut_off_reaches_to_the_cut() -> None:
    knife = BRepPrimAPI_MakeBox(gp_Pnt(2.0, -9.0, -9.0), gp_Pnt(9.0, 9.0, 9.0)).Shape()
    box = bounding_box(BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(3.0).Shape(), knife).Shape())
    assert box == pytest.approx(np.array([[-3, -3, -3], [2, 3, 3]], dtype=float), abs=1e-6)


GEARS: list[tuple[Changes, str]] = [
    ({}, "pinion"),
    ({"blank.pinion.end_chamfer": 1.0, "tooth.ends": "sphere"}, "pinion"),
    ({"blank.wheel.end_chamfer": 1.0}, "wheel"),
    ({"pair.pinion_teeth": 5, "tooth.profile_shift": 0.4, "tooth.addendum_factor": 0.9}, "pinion"),
    ({"pair.shaft_angle_deg": 110.0, "tooth.ends": "sphere", "pair.wheel_teeth": 37}, "wheel"),
]


@pytest.mark.parametrize(("changes", "member"), GEARS)
def test_gears_reach_as_far_as_their_meshes(changes: Changes, member: str) -> None:
    """Poles reach up to 1.5 % farther."""
    gear = build_gear(changed(changes), member, "point_cloud", "optimised")
    chord = 1e-3
    mesh = gear_mesh(gear.tooth, gear.outline.points, chord).points
    box = bounding_box(gear.solid)
    assert box == pytest.approx(np.stack([mesh.min(axis=0), mesh.max(axis=0)]), abs=2 * chord)
    assert box[1, 2] - box[0, 2] == pytest.approx(np.ptp(mesh[:, 2]), abs=1e-5)
    assert_within(gear, box)


def assert_within(gear: Gear, box: np.ndarray) -> None:
    """No point of a tooth, turned to every pitch, lies outside by more than the gap."""
    share = np.linspace(0.0, 1.0, 41)
    for face in gear.tooth.faces:
        points = face.surface.grid(share, share).reshape(-1, 3)
        for chamfer in gear.outline.chamfers:
            points = points[chamfer.beyond(points) <= 0]
        radius, azimuth = np.hypot(points[:, 0], points[:, 1]), np.arctan2(points[:, 1], points[:, 0])
        turned = azimuth[:, None] + np.arange(gear.member.teeth) * gear.member.pitch
        x, y = radius[:, None] * np.cos(turned), radius[:, None] * np.sin(turned)
        assert max((box[0, :2] - [x.min(), y.min()]).max(), ([x.max(), y.max()] - box[1, :2]).max()) < 1e-5
