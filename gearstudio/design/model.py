"""The design of a bevel gear pair, as a drawing gives it: mm, degrees, and nothing derived.

`Design` is the one source of the design file, of the limits and messages, and of the window's form.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator
from functools import cache
from typing import Any

from pydantic import BaseModel, Field, field_validator

from gearstudio.design.blank import Blank
from gearstudio.design.depths import Depth
from gearstudio.design.fields import FieldSpec, Part, Words, number, specify, text
from gearstudio.design.lengthwise import LengthwiseCurve
from gearstudio.design.modifications import Modifications
from gearstudio.design.pair import Pair
from gearstudio.design.tooth import Tooth

FORMAT = 1


class MethodSettings(Part):
    """What the methods are asked for."""

    tolerance_um: float = number(
        0.05, 0.001, 100.0,
        Words(
            "Tolerance", "The optimised variants refine until they expect to be below it.",
            "µm", step=0.01, decimals=3,
        ),
    )  # fmt: skip
    point_cloud_degree: int = number(
        3,
        2,
        8,
        Words("Point cloud degree", "Degree of the surface through the point cloud.", "", "p", "S = Σ Nᵢ Nⱼ pᵢⱼ"),
    )


class Design(Part):
    """A pair as its design file gives it; `Design()` is the default pair.

    The constructor checks types and the limits of single fields; whether the fields together make a gear is
    for `gearstudio.validation.check`.
    """

    name: str = text("Default spiral bevel pair", 120, Words("Name", "What this design is called.", symbol=""))
    pair: Pair = Field(default_factory=Pair)
    lengthwise: LengthwiseCurve = Field(default_factory=LengthwiseCurve)
    tooth: Tooth = Field(default_factory=Tooth)
    modifications: Modifications = Field(default_factory=Modifications)
    blank: Blank = Field(default_factory=Blank)
    depth: Depth = Field(default_factory=Depth)
    methods: MethodSettings = Field(default_factory=MethodSettings)

    @field_validator("name")
    @classmethod
    def _one_line(cls, value: str) -> str:
        if any(unicodedata.category(letter) in {"Cc", "Cs", "Zl", "Zp"} for letter in value):
            raise ValueError("control characters")
        return value


GROUPS = {
    "": "Design",
    "pair": "Pair",
    "lengthwise": "Lengthwise curve",
    "tooth": "Tooth",
    "modifications.pinion.concave": "Micro-geometry: pinion, concave",
    "modifications.pinion.convex": "Micro-geometry: pinion, convex",
    "modifications.wheel.concave": "Micro-geometry: wheel, concave",
    "modifications.wheel.convex": "Micro-geometry: wheel, convex",
    "blank.pinion": "Pinion blank",
    "blank.wheel": "Wheel blank",
    "depth": "Depth",
    "methods": "Methods",
}
# Groups of the form that are folded until they are asked for: many fields that most designs leave alone.
FOLDED_GROUPS = frozenset(title for path, title in GROUPS.items() if path.startswith("modifications."))


@cache
def all_field_specs() -> dict[str, FieldSpec]:
    """Every field that a design file may hold, by its dotted key, in the order of the file."""
    return {spec.path: spec for spec in _walk(Design, "")}


@cache
def field_specs() -> tuple[FieldSpec, ...]:
    """Every field, in the order of the file and of the form."""
    return tuple(all_field_specs().values())


def field_value(design: Design, path: str) -> Any:
    """Value of the field with a dotted key."""
    value: Any = design
    for key in path.split("."):
        value = getattr(value, key)
    return value


def with_field(design: Design, path: str, value: Any) -> Design:
    """The design with one field changed and checked again.

    Raises
    ------
    pydantic.ValidationError
        The value is outside the field's own limits.
    """
    head, _, rest = path.partition(".")
    part = getattr(design, head)
    data = dict(design)
    data[head] = with_field(part, rest, value) if rest else value
    return type(design)(**data)


def design_mapping(design: Design) -> dict[str, Any]:
    """The design as nested plain tables, every field present: what `validation.read_design` reads back."""
    return design.model_dump()


def _walk(model: type[BaseModel], prefix: str) -> Iterator[FieldSpec]:
    for key, info in model.model_fields.items():
        part = info.annotation
        if isinstance(part, type) and issubclass(part, BaseModel):
            yield from _walk(part, f"{prefix}{key}.")
        else:
            yield specify(f"{prefix}{key}", GROUPS[prefix.rstrip(".")], info)
