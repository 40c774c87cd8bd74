"""Random valid designs over the whole range that the design file permits."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from hypothesis import assume
from hypothesis import strategies as st

from gearstudio.design import Design
from gearstudio.theory.cones import face_width, outer_cone_distance
from gearstudio.validation import check
from gearstudio.validation.pair_rules import MOST_ARC_SPIRAL_DEG, cutter_radius_range

_TAME = {"addendum_factor": 0.6, "clearance_factor": 0.2, "profile_shift": 0.0, "backlash": 0.0, "fillet_factor": 0.2}
_SHARES = (1.0, 0.6, 0.3, 0.1, 0.0)


def is_valid(design: Design) -> bool:
    """Whether nothing worse than a warning is known against a design."""
    return all(issue.severity != "error" for issue in check(design))


def between(low: float, high: float) -> st.SearchStrategy[float]:
    """Evenly, ends included."""
    return st.floats(0.0, 1.0).map(lambda share: min(low + share * (high - low), high))


def log_between(low: float, high: float) -> st.SearchStrategy[float]:
    """Evenly in the logarithm, ends included."""
    return st.floats(0.0, 1.0).map(lambda share: min(max(low * (high / low) ** share, low), high))


def teeth() -> st.SearchStrategy[int]:
    """5 to 200, as many of either end."""
    return log_between(5, 200).map(round)


@st.composite
def designs(draw: st.DrawFn) -> Design:
    """A design without errors: every field over its permitted range.

    The proportions of the tooth are drawn over their whole range too; where they make no tooth they move towards
    tame ones, so many designs lie near the end of what is possible.
    """
    pair = draw(_pairs())
    lengthwise = draw(_lengthwise())
    wild = {
        "addendum_factor": draw(between(0.1, 2.0)),
        "clearance_factor": draw(between(0.0, 1.0)),
        "profile_shift": draw(between(-1.5, 1.5)),
        "backlash": pair["outer_module"] * draw(between(0.0, 0.5)),
        "fillet_factor": draw(log_between(0.01, 1.0)),
    }
    kinds = {
        "tip_cone": draw(st.sampled_from(["common_apex", "constant_clearance"])),
        "ends": draw(st.sampled_from(["back_cone", "sphere"])),
    }
    cutter = draw(st.floats(0.0, 1.0))
    for share in _SHARES:
        tooth = {key: share * wild[key] + (1 - share) * tame for key, tame in _TAME.items()}
        design = Design.model_validate({"pair": pair, "lengthwise": lengthwise, "tooth": {**tooth, **kinds}})
        design = _with_cutter(design, cutter)
        if is_valid(design):
            return design
    assume(False)
    raise AssertionError("not reached")


@st.composite
def _pairs(draw: st.DrawFn) -> dict[str, Any]:
    first, second = sorted((draw(teeth()), draw(teeth())))
    widest = min(150.0, math.degrees(math.acos(-first / second)) - 1e-3) if first < second else 150.0
    return {
        "pinion_teeth": first,
        "wheel_teeth": second,
        "shaft_angle_deg": draw(between(30.0, widest)),
        "outer_module": draw(log_between(0.1, 100.0)),
        "pressure_angle_deg": draw(between(10.0, 35.0)),
        "pressure_angle_kind": draw(st.sampled_from(["normal", "transverse"])),
        "face_width_factor": draw(st.one_of(between(0.1, 0.5), log_between(0.005, 0.5))),
        "pinion_hand": draw(st.sampled_from(["left", "right"])),
    }


@st.composite
def _lengthwise(draw: st.DrawFn) -> dict[str, Any]:
    curve, at = draw(
        st.sampled_from(
            [("circular_arc", "mean"), ("archimedean", "mean"), ("archimedean", "toe"), ("logarithmic", "mean")]
        )
    )
    return {"curve": curve, "spiral_angle_at": at, "spiral_angle_deg": draw(between(0.0, 55.0))}


def _with_cutter(design: Design, share: float) -> Design:
    """A cutter from the smallest that crosses the face width to one a hundred times as large."""
    if design.lengthwise.curve != "circular_arc":
        return design
    outer, tooth = outer_cone_distance(design), design.tooth
    height = design.pair.outer_module * (tooth.addendum_factor + tooth.clearance_factor + abs(tooth.profile_shift))
    least, most = cutter_radius_range(
        outer - face_width(design) / 2,
        math.radians(design.lengthwise.spiral_angle_deg),
        outer - face_width(design),
        float(np.hypot(outer, height)),
        math.radians(MOST_ARC_SPIRAL_DEG),
    )
    least, most = max(1.001 * least, 0.1), min(100 * least, 0.999 * most, 100_000.0)
    assume(least < most)
    lengthwise = design.lengthwise.model_copy(update={"cutter_radius": least * (most / least) ** share})
    return design.model_copy(update={"lengthwise": lengthwise})


@st.composite
def offset_designs(draw: st.DrawFn) -> Design:
    """A design with an offset of either sign and without errors, of a size that gears with an offset have."""
    pinion_teeth = draw(st.integers(7, 20))
    wheel_teeth = max(round(pinion_teeth * draw(between(1.5, 5.0))), pinion_teeth + 1)
    diameter = draw(between(80.0, 450.0))
    sign = draw(st.sampled_from([-1.0, 1.0]))
    pair = {
        "pinion_teeth": pinion_teeth,
        "wheel_teeth": wheel_teeth,
        "shaft_angle_deg": draw(between(70.0, 100.0)),
        "outer_module": diameter / wheel_teeth,
        "pressure_angle_deg": draw(between(18.0, 24.0)),
        "face_width": diameter * draw(between(0.09, 0.155)),
        "pinion_hand": draw(st.sampled_from(["left", "right"])),
        "offset": sign * diameter * draw(between(0.01, 0.16 if sign > 0 else 0.1)),
    }
    lengthwise = {
        "curve": draw(st.sampled_from(["circular_arc", "circular_arc", "archimedean", "logarithmic"])),
        "spiral_angle_deg": draw(between(38.0, 50.0) if sign > 0 else between(22.0, 35.0)),
        "cutter_radius": diameter * draw(between(0.36, 0.6)),
    }
    tooth = {
        "backlash": 0.001 * diameter * draw(st.floats(0.0, 1.0)),
        "ends": draw(st.sampled_from(["back_cone", "sphere"])),
        "fillet_factor": 0.25,
        "limit_pressure_angle_factor": draw(between(0.0, 1.0)),
    }
    depth = {"system": "iso23509", "taper": draw(st.sampled_from(["standard", "uniform", "duplex", "tilted_root"]))}
    design = Design.model_validate({"pair": pair, "lengthwise": lengthwise, "tooth": tooth, "depth": depth})
    assume(all(issue.severity != "error" for issue in check(design, 0.0)))
    return design


@st.composite
def modified_designs(draw: st.DrawFn) -> Design:
    """A design of `designs` with micro-geometry on some flanks, in proportion to the module up to what is permitted."""
    design = draw(designs())
    wild = {
        member: {name: draw(_flank_modifications(design.pair.outer_module)) for name in ("concave", "convex")}
        for member in ("pinion", "wheel")
    }
    for share in (1.0, 0.3, 0.1, 0.03, 0.01):
        modifications = {
            member: {
                name: {key: value * share if key.endswith("_um") else value for key, value in fields.items()}
                for name, fields in flanks.items()
            }
            for member, flanks in wild.items()
        }
        modified = Design.model_validate({**design.model_dump(), "modifications": modifications})
        if is_valid(modified):
            return modified
    assume(False)
    raise AssertionError("not reached")


@st.composite
def _flank_modifications(draw: st.DrawFn, module: float) -> dict[str, float]:
    most = min(30.0 * module, 1000.0)
    either = [
        "lengthwise_crowning_um",
        "profile_crowning_um",
        "spiral_angle_correction_um",
        "pressure_angle_correction_um",
        "bias_um",
    ]
    chosen = {key: draw(between(-most, most)) for key in either if draw(st.booleans())}
    for amount, place in (("tip_relief_um", "tip_relief_start"), ("root_relief_um", "root_relief_end")):
        if draw(st.booleans()):
            chosen |= {amount: draw(between(0.0, most)), place: draw(between(0.05, 0.95))}
    return chosen
