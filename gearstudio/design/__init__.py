"""The design of a pair as its file gives it: fields, limits and words in one source."""

from gearstudio.design.fields import FieldSpec
from gearstudio.design.model import (
    FOLDED_GROUPS,
    FORMAT,
    Design,
    all_field_specs,
    design_mapping,
    field_specs,
    field_value,
    with_field,
)
from gearstudio.design.modifications import FlankModification

__all__ = [
    "FOLDED_GROUPS",
    "FORMAT",
    "Design",
    "FieldSpec",
    "FlankModification",
    "all_field_specs",
    "design_mapping",
    "field_specs",
    "field_value",
    "with_field",
]
