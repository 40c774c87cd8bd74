"""Whole gears in mesh: their surfaces touch, and neither enters the other."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance

from gearstudio.design import Design
from gearstudio.methods.gear import blank_sizes, design_tooth
from gearstudio.methods.gear_mesh import gear_mesh
from gearstudio.presets import PRESETS_BY_KEY
from gearstudio.results import Mesh
from gearstudio.theory.blank import blank_outline
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.pair import pinion_placement, wheel_placement
from tests.kernel.gears import Changes, changed

pytestmark = pytest.mark.kernel

Floats = NDArray[np.float64]
CHORD = 0.01
TURNS = (0.0, 0.13, -0.21)
CASES: list[tuple[str, Changes]] = [
    ("default", {}),
    ("default", {"tooth.backlash": 0.08, "blank.pinion.end_chamfer": 1.0, "blank.wheel.end_chamfer": 1.0}),
    ("default", {"tooth.ends": "sphere", "pair.shaft_angle_deg": 75.0, "pair.pinion_hand": "left"}),
    ("logarithmic", {"tooth.backlash": 0.02}),
    ("zerol", {}),
]


class Body:
    """A gear's triangles, and how deep points lie inside."""

    def __init__(self, design: Design, member: str) -> None:
        tooth = design_tooth(design, member, "point_cloud", "optimised")
        outline = blank_outline(tooth.member, blank_sizes(design, member))
        self.mesh = gear_mesh(tooth, outline.points, CHORD)
        self.polar = np.sort([tooth.member.root_angle, tooth.member.tip_angle])
        self.inside = vtkImplicitPolyDataDistance()
        self.inside.SetInput(poly_data(self.mesh))

    def depth(self, points: Floats) -> float:
        """Of the deepest of points (n, 3) in this gear's frame [mm]; negative when all are outside."""
        polar = np.arctan2(np.hypot(points[:, 0], points[:, 1]), points[:, 2])
        near = points[(polar > self.polar[0] - 0.01) & (polar < self.polar[1] + 0.01)]
        assert len(near) > 100
        return -min(self.inside.EvaluateFunction(point) for point in near.tolist())


def poly_data(mesh: Mesh) -> vtkPolyData:
    triangles = np.ascontiguousarray(mesh.triangles, dtype=np.int64)
    points, cells, made = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(mesh.points, deep=True))
    offsets = np.arange(0, triangles.size + 1, 3, dtype=np.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(triangles.ravel(), deep=True))
    made.SetPoints(points)
    made.SetPolys(cells)
    return made


@pytest.mark.parametrize(("preset", "changes"), CASES)
def test_whole_gears_roll_without_entering_each_other(preset: str, changes: Changes) -> None:
    design = changed(changes, PRESETS_BY_KEY[preset].design)
    pair = pair_geometry(design)
    pinion, wheel = Body(design, "pinion"), Body(design, "wheel")

    def depths(turn: float, too_far: float = 0.0) -> tuple[float, float]:
        """Of wheel in pinion and pinion in wheel [mm], the pinion turned too far by an angle [rad]."""
        to_pinion = pinion_placement(pair, turn + too_far).T @ wheel_placement(pair, turn)
        return pinion.depth(wheel.mesh.points @ to_pinion.T), wheel.depth(pinion.mesh.points @ to_pinion)

    for turn in TURNS:
        assert max(depths(turn)) < 2 * CHORD
    gap = design.tooth.backlash / pair.pinion.outer_cone_distance / np.sin(pair.pinion.pitch_angle)
    for way in (-1, 1):
        assert max(depths(0.0, way * (gap + 0.02))) > 5 * CHORD
