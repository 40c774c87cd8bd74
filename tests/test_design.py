"""The design model and its fields: one source of defaults, limits and words."""

from __future__ import annotations

import math
import pickle
from typing import Any

import pytest
from pydantic import ValidationError

from gearstudio.cli.info import info
from gearstudio.design import (
    Design,
    FieldSpec,
    all_field_specs,
    design_mapping,
    field_specs,
    field_value,
    with_field,
)
from gearstudio.validation import read_design

NUMBERS = [spec for spec in field_specs() if spec.kind in ("int", "float")]
CHOICES = [spec for spec in field_specs() if spec.kind == "choice"]
DEFAULTS = {
    "name": "Default spiral bevel pair",
    "pair.pinion_teeth": 17,
    "pair.wheel_teeth": 40,
    "pair.shaft_angle_deg": 90.0,
    "pair.outer_module": 4.0,
    "pair.pressure_angle_deg": 20.0,
    "pair.pressure_angle_kind": "normal",
    "pair.face_width_factor": 0.30,
    "pair.face_width": None,
    "pair.pinion_hand": "left",
    "pair.offset": 0.0,
    "lengthwise.curve": "circular_arc",
    "lengthwise.spiral_angle_deg": 35.0,
    "lengthwise.spiral_angle_at": "mean",
    "lengthwise.cutter_radius": 80.0,
    "lengthwise.spiral_angle_of": "pinion",
    "tooth.addendum_factor": 1.0,
    "tooth.clearance_factor": 0.25,
    "tooth.profile_shift": 0.0,
    "tooth.backlash": 0.0,
    "tooth.fillet_factor": 0.3,
    "tooth.tip_cone": "common_apex",
    "tooth.ends": "back_cone",
    "tooth.limit_pressure_angle_factor": 1.0,
    **{
        f"blank.{member}.{size}": default
        for member in ("pinion", "wheel")
        for size, default in {
            "bore_diameter": None,
            "hub_diameter": None,
            "hub_length": None,
            "mounting_distance": None,
            "web_thickness": None,
            "shank_diameter": 0.0,
            "shank_length": 0.0,
            "end_chamfer": 0.0,
        }.items()
    },
    **{
        f"modifications.{member}.{flank}.{key}": value
        for member in ("pinion", "wheel")
        for flank in ("concave", "convex")
        for key, value in {
            "lengthwise_crowning_um": 0.0,
            "profile_crowning_um": 0.0,
            "spiral_angle_correction_um": 0.0,
            "pressure_angle_correction_um": 0.0,
            "bias_um": 0.0,
            "tip_relief_um": 0.0,
            "tip_relief_start": 0.7,
            "root_relief_um": 0.0,
            "root_relief_end": 0.3,
        }.items()
    },
    "depth.system": "outer_module",
    "depth.taper": "standard",
    "depth.depth_factor": 2.0,
    "depth.clearance_factor": 0.125,
    "depth.mean_addendum_factor": None,
    "depth.thickness_factor": 0.0,
    "depth.addendum_angle_deg": None,
    "depth.dedendum_angle_deg": None,
    "methods.tolerance_um": 0.05,
    "methods.point_cloud_degree": 3,
}
STATED_LIMITS = {
    "pair.pinion_teeth": (5, 200),
    "pair.wheel_teeth": (5, 200),
    "pair.outer_module": (0.1, 100),
    "lengthwise.spiral_angle_deg": (0, 55),
    "pair.pressure_angle_deg": (10, 35),
    "pair.shaft_angle_deg": (30, 150),
    "methods.tolerance_um": (0.001, 100),
}
# Fields without effect on the derived geometry: the label, what the methods are asked for, the bodies; and the
# micro-geometry, whose effect on the flanks has tests of its own.
NOT_IN_INFO = {path for path in DEFAULTS if path.split(".")[0] in ("name", "methods", "blank", "modifications")}


def by_path(spec: FieldSpec) -> str:
    return spec.path


def just_beyond(spec: FieldSpec, limit: float, direction: int) -> float | int:
    return int(limit) + direction if spec.kind == "int" else math.nextafter(limit, direction * math.inf)


def test_a_new_design_has_the_defaults_of_the_file_format() -> None:
    design = Design()
    assert {path: field_value(design, path) for path in all_field_specs()} == DEFAULTS


@pytest.mark.parametrize("path", STATED_LIMITS)
def test_limits_are_the_stated_ones(path: str) -> None:
    spec = all_field_specs()[path]
    assert (spec.minimum, spec.maximum) == STATED_LIMITS[path]
    assert not spec.above_minimum


@pytest.mark.parametrize("spec", NUMBERS, ids=by_path)
def test_the_model_refuses_what_lies_beyond_the_limits_that_it_states(spec: FieldSpec) -> None:
    assert spec.minimum is not None and spec.maximum is not None
    kind = int if spec.kind == "int" else float
    least = just_beyond(spec, spec.minimum, 1) if spec.above_minimum else kind(spec.minimum)
    for inside in (least, kind(spec.maximum)):
        assert field_value(with_field(Design(), spec.path, inside), spec.path) == inside
    below = spec.minimum if spec.above_minimum else just_beyond(spec, spec.minimum, -1)
    for outside in (below, just_beyond(spec, spec.maximum, 1)):
        with pytest.raises(ValidationError):
            with_field(Design(), spec.path, outside)


@pytest.mark.parametrize("spec", NUMBERS, ids=by_path)
@pytest.mark.parametrize("nonsense", [True, "17", math.nan, math.inf, -math.inf, 10**400, [], {}])
def test_the_model_refuses_nonsense_for_numbers(spec: FieldSpec, nonsense: Any) -> None:
    with pytest.raises(ValidationError):
        with_field(Design(), spec.path, nonsense)


@pytest.mark.parametrize("spec", [s for s in NUMBERS if s.kind == "int"], ids=by_path)
def test_whole_numbers_are_whole(spec: FieldSpec) -> None:
    for value in (17.5, 17.0):
        with pytest.raises(ValidationError):
            with_field(Design(), spec.path, value)


@pytest.mark.parametrize("spec", CHOICES, ids=by_path)
def test_every_choice_is_accepted_and_no_other_word(spec: FieldSpec) -> None:
    for choice in spec.choices:
        assert field_value(with_field(Design(), spec.path, choice), spec.path) == choice
    with pytest.raises(ValidationError):
        with_field(Design(), spec.path, spec.choices[0].upper())


@pytest.mark.parametrize("spec", field_specs(), ids=by_path)
def test_every_field_of_the_form_has_its_words(spec: FieldSpec) -> None:
    assert spec.title and spec.group and spec.description.endswith(".")
    assert spec.kind in ("choice", "text") or (spec.step > 0 and spec.decimals >= 0)
    if spec.used_when is not None:
        path, value = spec.used_when
        assert value in all_field_specs()[path].choices


def test_designs_are_frozen_values() -> None:
    design = Design()
    with pytest.raises(ValidationError):
        design.pair.pinion_teeth = 18  # type: ignore[misc]
    assert design == Design() and hash(design) == hash(Design())
    assert with_field(design, "pair.pinion_teeth", 18) != design
    assert design.pair.pinion_teeth == 17
    assert pickle.loads(pickle.dumps(design)) == design


def test_a_design_reads_back_from_its_mapping() -> None:
    design = with_field(with_field(Design(), "blank.wheel.bore_diameter", 25.0), "pair.face_width", 20.0)
    assert read_design(design_mapping(design)) == (design, ())


OFFSET = {"pair.offset": 10.0}
ISO = {"depth.system": "iso23509"}
# A setting under which the field acts, and another value of it.
ACTING: dict[str, tuple[dict[str, Any], Any]] = {
    "pair.pinion_teeth": ({}, 18),
    "pair.wheel_teeth": ({}, 41),
    "pair.shaft_angle_deg": ({}, 85.0),
    "pair.outer_module": ({}, 4.1),
    "pair.pressure_angle_deg": ({}, 21.0),
    "pair.pressure_angle_kind": ({}, "transverse"),
    "pair.face_width_factor": ({}, 0.25),
    "pair.face_width": ({}, 20.0),
    "pair.pinion_hand": ({}, "right"),
    "lengthwise.curve": ({}, "logarithmic"),
    "lengthwise.spiral_angle_deg": ({}, 30.0),
    "lengthwise.spiral_angle_at": ({"lengthwise.curve": "archimedean"}, "toe"),
    "lengthwise.cutter_radius": ({}, 90.0),
    "tooth.addendum_factor": ({}, 0.9),
    "tooth.clearance_factor": ({}, 0.2),
    "tooth.profile_shift": ({}, 0.1),
    "tooth.backlash": ({}, 0.1),
    "tooth.fillet_factor": ({}, 0.2),
    "tooth.tip_cone": ({}, "constant_clearance"),
    "tooth.ends": ({}, "sphere"),
    "pair.offset": ({}, 10.0),
    "lengthwise.spiral_angle_of": (OFFSET, "wheel"),
    "tooth.limit_pressure_angle_factor": (OFFSET, 0.5),
    "depth.system": ({}, "iso23509"),
    "depth.taper": (ISO, "uniform"),
    "depth.depth_factor": (ISO, 1.9),
    "depth.clearance_factor": (ISO, 0.15),
    "depth.mean_addendum_factor": (ISO, 0.4),
    "depth.thickness_factor": (ISO, 0.05),
    "depth.addendum_angle_deg": (ISO, 2.0),
    "depth.dedendum_angle_deg": (ISO, 3.0),
}


@pytest.mark.parametrize("path", [s.path for s in field_specs() if s.path not in NOT_IN_INFO])
def test_every_field_changes_what_is_derived(path: str) -> None:
    setting, value = ACTING[path]
    design = Design()
    for other, other_value in setting.items():
        design = with_field(design, other, other_value)
    assert info(with_field(design, path, value)) != info(design)
