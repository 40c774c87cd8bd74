"""Validation of fillets on a root cone of its own: it passes exactly the designs of which teeth can be made."""

from __future__ import annotations

import re
from typing import Any

import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from gearstudio.design import Design, with_field
from gearstudio.errors import GeometryError, Issue
from gearstudio.methods import Target
from gearstudio.methods.tooth import build_tooth
from gearstudio.presets import PRESETS_BY_KEY
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.hypoid.profile import HypoidProfile
from gearstudio.theory.profile import profile_of
from gearstudio.validation import check
from tests.strategies import between, log_between

QUIET = settings(max_examples=14, deadline=None, suppress_health_check=list(HealthCheck))
LIMIT = re.compile(r"a fillet factor of at most ([\d.]+)")


@st.composite
def filleted(draw: st.DrawFn) -> Design:
    """A pair with an offset and fillets and clearances of any size."""
    teeth = draw(st.integers(7, 20))
    wheel = max(round(teeth * draw(between(1.5, 5.0))), teeth + 1)
    diameter, sign = draw(between(80.0, 450.0)), draw(st.sampled_from([-1.0, 1.0]))
    data: dict[str, Any] = {
        "pair": {
            "pinion_teeth": teeth,
            "wheel_teeth": wheel,
            "shaft_angle_deg": draw(between(70.0, 100.0)),
            "outer_module": diameter / wheel,
            "face_width": diameter * draw(between(0.09, 0.155)),
            "offset": sign * diameter * draw(between(0.01, 0.16 if sign > 0 else 0.1)),
        },
        "lengthwise": {
            "curve": draw(st.sampled_from(["circular_arc", "archimedean", "logarithmic"])),
            "spiral_angle_deg": draw(between(38.0, 50.0) if sign > 0 else between(22.0, 35.0)),
            "cutter_radius": diameter * draw(between(0.36, 0.6)),
        },
        "tooth": {
            "fillet_factor": draw(log_between(0.05, 1.0)),
            "ends": draw(st.sampled_from(["back_cone", "sphere"])),
        },
        "depth": {
            "system": "iso23509",
            "taper": draw(st.sampled_from(["standard", "uniform", "duplex", "tilted_root"])),
            "clearance_factor": draw(between(0.03, 0.3)),
        },
    }
    return Design.model_validate(data)


def errors(design: Design, patience_s: float = 0.0) -> list[Issue]:
    return [issue for issue in check(design, patience_s) if issue.severity == "error"]


def refusal(design: Design) -> str | None:
    """Why no teeth can be made, or None."""
    pair = pair_geometry(design)
    try:
        for member in (pair.pinion, pair.wheel):
            build_tooth(member, "point_cloud", "published", Target(1e-3))
    except GeometryError as error:
        return str(error)
    return None


@QUIET
@given(filleted())
def test_validation_passes_what_can_be_built_and_nothing_else(design: Design) -> None:
    found = errors(design)
    assume(all(issue.code == "fillet" for issue in found))
    assert (refusal(design) is None) == (not found)


@QUIET
@given(filleted())
def test_the_limit_that_is_told_is_the_limit(design: Design) -> None:
    found = errors(with_field(design, "tooth.fillet_factor", 1.0))
    assume(found and all(issue.code == "fillet" for issue in found))
    limit = LIMIT.search(found[0].message)
    assume(limit is not None)
    assert limit is not None and found[0].field == "tooth.fillet_factor"
    factor = float(limit[1])
    assert not errors(with_field(design, "tooth.fillet_factor", factor))
    assert refusal(with_field(design, "tooth.fillet_factor", factor)) is None
    assert errors(with_field(design, "tooth.fillet_factor", 1.01 * factor))


@pytest.mark.parametrize("taper", ["tilted_root", "duplex"])
@pytest.mark.parametrize("factor", [0.02, 0.3, 1.0])
def test_bevel_pairs_with_a_root_cone_of_its_own(taper: str, factor: float) -> None:
    design = Design()
    for path, value in {"depth.system": "iso23509", "depth.taper": taper, "tooth.fillet_factor": factor}.items():
        design = with_field(design, path, value)
    found = errors(design)
    assert all(issue.code == "fillet" for issue in found)
    assert (refusal(design) is None) == (not found)


@pytest.mark.parametrize("key", [key for key, preset in PRESETS_BY_KEY.items() if preset.design.pair.offset])
def test_fillets_that_are_made_of_another_size_are_told(key: str) -> None:
    design = PRESETS_BY_KEY[key].design
    large = with_field(with_field(design, "tooth.fillet_factor", 0.9), "depth.clearance_factor", 0.3)
    large = with_field(large, "depth.system", "iso23509")
    found = check(large, 0.0)
    told = [issue for issue in found if issue.code == "fillet_size"]
    pair = pair_geometry(large)
    for member in (pair.pinion, pair.wheel):
        if any(issue.severity == "error" for issue in found):
            assert not told
            continue
        profile = profile_of(member)
        assert isinstance(profile, HypoidProfile)
        named = [issue for issue in told if member.name in issue.message]
        assert bool(named) == (profile.fillet_radius != pytest.approx(member.fillet_radius, rel=2e-3))
        for issue in named:
            assert issue.severity == "warning" and issue.field == "tooth.fillet_factor"
            assert f"{profile.fillet_radius:.4g} mm" in issue.message
    assert not [issue for issue in check(design, 0.0) if issue.code == "fillet_size"]
