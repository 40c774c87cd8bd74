"""The design of a bevel gear pair, as a drawing gives it: mm, degrees, and nothing derived.

`Design` is the one source of the design file, of the limits and messages, and of the window's form.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator
from functools import cache
from typing import Any, Literal

from pydantic import BaseModel, Field, field_validator

from gearstudio.design.depths import OWN, Depth
from gearstudio.design.fields import FieldSpec, Part, Words, number, specify, text, word
from gearstudio.design.modifications import Modifications

FORMAT = 1
Hand = Literal["left", "right"]


class Pair(Part):
    """Both members together."""

    pinion_teeth: int = number(
        17,
        5,
        200,
        Words("Pinion teeth", "Number of teeth of the pinion.", "teeth", "z₁", "δ₁ = atan2(sin Σ, z₂/z₁ + cos Σ)"),
    )
    wheel_teeth: int = number(
        40, 5, 200, Words("Wheel teeth", "Number of teeth of the wheel.", "teeth", "z₂", "δ₂ = Σ − δ₁")
    )
    shaft_angle_deg: float = number(
        90.0, 30.0, 150.0,
        Words(
            "Shaft angle", "Angle between the two axes; both pitch cones must stay below 90°.",
            "°", "Σ", "Σ = δ₁ + δ₂", 1.0, 3,
        ),
    )  # fmt: skip
    outer_module: float = number(
        4.0, 0.1, 100.0,
        Words(
            "Outer module", "Outer transverse module: heel pitch diameter over teeth.",
            "mm", "m", "R = m z₁ / (2 sin δ₁)", 0.25, 4,
        ),
    )  # fmt: skip
    pressure_angle_deg: float = number(
        20.0, 10.0, 35.0,
        Words("Pressure angle", "Pressure angle of both flanks.", "°", "α", "tan α = tan αₙ / cos βₘ", 0.5, 3),
    )  # fmt: skip
    pressure_angle_kind: Literal["normal", "transverse"] = word(
        "normal",
        Words(
            "Pressure angle is",
            "Normal: in the normal section at the mean point, as standards give it. Transverse: as the paper gives it.",
            symbol="αₙ, α",
            equation="tan α = tan αₙ / cos βₘ",
        ),
    )
    face_width_factor: float = number(
        0.30, 0.0, 0.5,
        Words(
            "Face width factor", "Face width over outer cone distance; a face width that is given wins over it.",
            "", "B/R", "B = (B/R) R", 0.01, 4,
        ),
        above_minimum=True,
    )  # fmt: skip
    face_width: float | None = number(
        None, 0.0, 10000.0,
        Words(
            "Face width", "Face width along the pitch cone; leave empty to take the factor.",
            "mm", "B", "0 < B ≤ 0.5 R", 0.5, 4,
        ),
        above_minimum=True,
    )  # fmt: skip
    pinion_hand: Hand = word(
        "left",
        Words(
            "Hand of the pinion",
            "Hand of spiral of the pinion; the wheel has the other.",
            symbol="hand₁",
            equation="hand₂ = −hand₁",
        ),
    )
    offset: float = number(
        0.0, -5000.0, 5000.0,
        Words(
            "Offset",
            "Distance between the axes of a hypoid pair; 0 is a bevel pair. Positive makes the pinion's spiral angle "
            "the larger one. With an offset the outer module and the face width are the wheel's.",
            "mm", "a", "a = r₂ sin ζ + r₁ sin η", 1.0, 4,
        ),
    )  # fmt: skip


class LengthwiseCurve(Part):
    """How a tooth runs along the face width."""

    curve: Literal["archimedean", "circular_arc", "logarithmic"] = word(
        "circular_arc",
        Words(
            "Lengthwise curve",
            "Archimedean: the paper's spiral on the base cone. Circular arc: the cutter's path. "
            "Logarithmic: the same spiral angle everywhere.",
            symbol="ψₜ(ρ)",
            equation="θ(ρ) = hand · ψₜ(ρ) / sin δ",
        ),
    )
    spiral_angle_deg: float = number(
        35.0, 0.0, 55.0,
        Words(
            "Spiral angle", "Spiral angle; 0 gives straight teeth, or zerol teeth with the circular arc.",
            "°", "β", "tan β(ρ) = ρ ψₜ′(ρ)", 1.0, 3,
        ),
    )  # fmt: skip
    spiral_angle_at: Literal["mean", "toe"] = word(
        "mean",
        Words(
            "Spiral angle at",
            "Mean: at the mean point on the pitch cone. Toe: at the toe on the base cone, as the paper gives it.",
            symbol="βₘ, β₀",
            equation="tan β₀ = (R − B) sin δ_b |dθ/dρ|",
        ),
    )
    cutter_radius: float = number(
        80.0, 0.1, 100000.0,
        Words(
            "Cutter radius", "Radius of the cutter whose arc the tooth follows.", "mm", "r₀",
            "sin β(ρ) = (ρ² + 2 r₀ Rₘ sin βₘ − Rₘ²) / (2 r₀ ρ)", 1.0, 4, ("lengthwise.curve", "circular_arc"),
        ),
    )  # fmt: skip
    spiral_angle_of: Literal["pinion", "wheel"] = word(
        "pinion",
        Words(
            "Spiral angle of",
            "Member whose mean spiral angle is given; both have the same without an offset.",
            symbol="βₘ₁, βₘ₂",
            equation="βₘ₁ = βₘ₂ + ζₘₚ",
        ),
    )


class Tooth(Part):
    """The profile of the teeth."""

    addendum_factor: float = number(
        1.0, 0.1, 2.0,
        Words(
            "Addendum factor", "Addendum at the heel over outer module, before profile shift.",
            "", "hₐ*", "hₐₑ = m (hₐ* + x)", 0.05, 4, OWN,
        ),
    )  # fmt: skip
    clearance_factor: float = number(
        0.25, 0.0, 1.0,
        Words(
            "Clearance factor", "Tip clearance at the heel over outer module.",
            "", "c*", "h_fe = m (hₐ* + c* − x)", 0.01, 4, OWN,
        ),
    )  # fmt: skip
    profile_shift: float = number(
        0.0, -1.5, 1.5,
        Words(
            "Profile shift", "Profile shift factor of the pinion; the wheel takes the negative.",
            "", "x₁", "x₂ = −x₁", 0.05, 4, OWN,
        ),
    )  # fmt: skip
    backlash: float = number(
        0.0, 0.0, 100.0,
        Words(
            "Backlash", "Transverse backlash at the heel pitch circle, half from each member.",
            "mm", "jₜ", "half = (π/2 + 2 x tan α)/z − jₜ/(2 m z)", 0.01, 4,
        ),
    )  # fmt: skip
    fillet_factor: float = number(
        0.3, 0.01, 1.0,
        Words(
            "Fillet factor", "Fillet radius on the heel sphere over mean normal module.",
            "", "R_f/mₙ", "R_f = 0.3 mₙ, mₙ = m (Rₘ/R) cos βₘ", 0.01, 4,
        ),
    )  # fmt: skip
    tip_cone: Literal["common_apex", "constant_clearance"] = word(
        "common_apex",
        Words(
            "Tip cone",
            "Common apex: all cones share the apex, as in the paper. "
            "Constant clearance: the tip runs parallel to the mate's root.",
            symbol="δₐ",
            equation="δₐ₁ = δ₁ + (δ₂ − δ_f2)",
            used_when=OWN,
        ),
    )
    ends: Literal["back_cone", "sphere"] = word(
        "back_cone",
        Words(
            "Tooth ends",
            "Back cone: as blanks are turned. Sphere: as in the paper.",
            symbol="ρᵤ",
            equation="ρ = ρᵤ / cos(δₖ − δ)",
        ),
    )
    limit_pressure_angle_factor: float = number(
        1.0, 0.0, 2.0,
        Words(
            "Limit pressure angle factor",
            "Share of the limit pressure angle that the drive flank gains and the coast flank loses; "
            "no effect without an offset.",
            "", "f_αlim", "αₙ = α ± f_αlim α_lim", 0.1, 3,
        ),
    )  # fmt: skip


def _body(title: str, description: str, symbol: str, default: float | None = None) -> Any:
    """A size of a turned body [mm]."""
    return number(default, 0.0, 20000.0, Words(title, description, "mm", symbol, step=1.0, decimals=3))


class BlankMember(Part):
    """The turned body of one member; what is empty is derived from the pair."""

    bore_diameter: float | None = _body(
        "Bore diameter", "Diameter of the bore, 0 for none; leave empty to derive it from the pair.", "d"
    )
    hub_diameter: float | None = _body("Hub diameter", "Outer diameter of the hub, on the side of the apex.", "D_h")
    hub_length: float | None = _body("Hub length", "From the back face toward the apex; the toe limits it.", "L_h")
    mounting_distance: float | None = _body("Mounting distance", "From the apex to the back face.", "t_B")
    web_thickness: float | None = _body("Web thickness", "Of the disc between hub and rim, from the back face.", "b_w")
    shank_diameter: float = _body(
        "Shank diameter",
        "Diameter of a solid shank behind the back face, 0 for none; it replaces the bore.",
        "d_s",
        0.0,
    )
    shank_length: float = _body("Shank length", "Length of the shank behind the back face, 0 for none.", "L_s", 0.0)
    end_chamfer: float = _body(
        "End chamfer",
        "Of the edges between tip and ends of the teeth, turned over all teeth at toe and heel; its legs along the "
        "face cone and along the end, 0 for none.",
        "c",
        0.0,
    )


class Blank(Part):
    """The turned bodies of both members."""

    pinion: BlankMember = Field(default_factory=BlankMember)
    wheel: BlankMember = Field(default_factory=BlankMember)


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
    """The fields that a form shows, in its order."""
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
