"""Numbers computed elsewhere: the project's own golden values, and values printed in standards and catalogues."""

from __future__ import annotations

import numpy as np
import pytest

from gearstudio.design import Design
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.involute_flank import InvoluteFlank
from gearstudio.theory.pair import tip_half_azimuth
from tests.designs import GOLDEN

ANGLES = ("pitch_angle", "base_angle", "tip_angle", "root_angle", "transverse_pressure_angle", "gamma")
LENGTHS = ("outer_cone_distance", "face_width", "base_radius")


@pytest.mark.parametrize("member_name", ["pinion", "wheel"])
@pytest.mark.parametrize("name", GOLDEN)
def test_derived_values(name: str, member_name: str) -> None:
    design, record = GOLDEN[name]
    member, expected = pair_geometry(design).member(member_name), record[member_name]
    for angle in (*ANGLES, "half_tooth_azimuth"):
        assert np.degrees(getattr(member, angle)) == pytest.approx(expected[angle], abs=1e-12), angle
    for length in LENGTHS:
        assert getattr(member, length) == pytest.approx(expected[length], abs=1e-11), length
    ends = member.lengthwise.azimuth([member.inner_cone_distance, member.outer_cone_distance])
    assert np.degrees(ends) == pytest.approx([expected["theta_toe"], expected["theta_heel"]], abs=1e-11)
    tip = np.degrees(tip_half_azimuth(member, member.outer_cone_distance))
    assert tip == pytest.approx(expected["tip_half_azimuth"], abs=1e-11)


@pytest.mark.parametrize("member_name", ["pinion", "wheel"])
@pytest.mark.parametrize("name", GOLDEN)
def test_flank_points(name: str, member_name: str) -> None:
    design, record = GOLDEN[name]
    member = pair_geometry(design).member(member_name)
    points = record[member_name]["flank"]
    assert {point["side"] for point in points} == {1, -1}
    for point in points:
        flank = InvoluteFlank(member, point["side"])
        delta = max(np.radians(point["delta"]), member.base_angle)
        found = flank.points_at(point["rho"], delta)
        assert np.abs(found - point["xyz"]).max() < 1e-11


def test_gleason_pair_of_a_catalogue() -> None:
    """KHK gear technical reference: 20/40 teeth, module 3, 35 degrees, face width 20."""
    design = Design.model_validate(
        {
            "pair": {"pinion_teeth": 20, "wheel_teeth": 40, "outer_module": 3.0, "face_width": 20.0},
            "lengthwise": {"spiral_angle_deg": 35.0, "cutter_radius": 80.0},
            "tooth": {
                "addendum_factor": 0.85,
                "clearance_factor": 0.188,
                "profile_shift": 0.2925,
                "tip_cone": "constant_clearance",
            },
        }
    )
    pair = pair_geometry(design)
    printed = {
        "pinion": (26.56505, 3.4275, 2.2365, 29.97024, 24.65553, 66.1313, 58.4672, 17.3563, 46.1140),
        "wheel": (63.43495, 1.6725, 3.9915, 65.34447, 60.02976, 121.4959, 28.5041, 8.3479, 85.1224),
    }
    for name, (pitch, addendum, dedendum, face, root, outside, crown, width, inside) in printed.items():
        member = pair.member(name)
        assert member.outer_cone_distance == pytest.approx(67.08204, abs=5e-6)
        assert np.degrees(member.pitch_angle) == pytest.approx(pitch, abs=5e-6)
        assert (member.addendum, member.dedendum) == pytest.approx((addendum, dedendum), abs=1e-9)
        assert np.degrees([member.tip_angle, member.root_angle]) == pytest.approx([face, root], abs=5e-6)
        heel = _on_end(member, member.outer_cone_distance)
        toe = _on_end(member, member.inner_cone_distance)
        assert (2 * heel[0], heel[1]) == pytest.approx((outside, crown), abs=1e-4)
        # The catalogue measures the axial face width as b cos(delta_a) / cos(theta_a), between the tip's corners.
        assert heel[1] - toe[1] == pytest.approx(width, abs=1e-4)
        assert 2 * toe[0] == pytest.approx(inside, abs=1e-4)


def _on_end(member, rho_u: float) -> tuple[float, float]:
    """Radius and height of the tip on a back cone."""
    delta = float(member.limit_angle(member.tip_limit, rho_u))
    rho = float(member.cone_distance(rho_u, delta))
    return rho * np.sin(delta), rho * np.cos(delta)


def test_sample_of_the_standard() -> None:
    """ISO 23509:2016, sample F.2: 14/39 teeth, wheel's outer pitch diameter 176.893, face width 25.4."""
    design = Design.model_validate(
        {
            "pair": {"pinion_teeth": 14, "wheel_teeth": 39, "outer_module": 176.893 / 39, "face_width": 25.4},
            "lengthwise": {"spiral_angle_deg": 35.0, "cutter_radius": 114.3},
        }
    )
    pair = pair_geometry(design)
    assert np.degrees([pair.pinion.pitch_angle, pair.wheel.pitch_angle]) == pytest.approx([19.747, 70.253], abs=5e-4)
    wheel = pair.wheel
    distances = (wheel.mean_cone_distance, wheel.outer_cone_distance, wheel.inner_cone_distance)
    assert distances == pytest.approx((81.273, 93.973, 68.573), abs=6e-4)
    spiral = np.degrees(wheel.lengthwise.spiral_angle([distances[1], distances[2]]))
    assert spiral == pytest.approx([36.846, 33.946], abs=6e-4)
    assert pair.mean_normal_module == pytest.approx(3.213, abs=6e-4)
    for member, mean, inner in ((pair.pinion, 54.918, 46.337), (wheel, 152.987, 129.080)):
        diameters = 2 * np.sin(member.pitch_angle) * np.array([member.mean_cone_distance, member.inner_cone_distance])
        assert diameters == pytest.approx([mean, inner], abs=6e-4)
