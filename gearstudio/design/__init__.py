"""The design of a pair as its file gives it: fields, limits and words in one source."""

from gearstudio.design.fields import FieldSpec
from gearstudio.design.model import (
    FORMAT,
    RESERVED_KEYS,
    Design,
    all_field_specs,
    design_mapping,
    field_specs,
    field_value,
    with_field,
)

__all__ = [
    "FORMAT",
    "RESERVED_KEYS",
    "Design",
    "FieldSpec",
    "all_field_specs",
    "design_mapping",
    "field_specs",
    "field_value",
    "with_field",
]
