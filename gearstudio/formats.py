"""The formats of exports and how each may be written; dialog and command line follow from the tables here."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, fields
from typing import Any, Literal

SOLID_FORMATS = ("step", "iges", "brep")
MESH_FORMATS = ("stl", "3mf", "glb")
FORMATS = {
    "flanks": ("step",),
    "tooth": (*SOLID_FORMATS, *MESH_FORMATS),
    "gear": (*SOLID_FORMATS, *MESH_FORMATS),
}
"""Parts that can be written, and how."""

Kind = Literal["choice", "number", "switch"]


@dataclass(frozen=True)
class ExportOptions:
    """How files are written.

    Attributes
    ----------
    chord : float or None
        Farthest that triangles may lie from the surfaces [mm]; None for 1e-4 of the outer cone distance.
    angle_deg : float or None
        Largest angle between neighbouring chords [degrees]; None for no limit.
    step_schema : {"ap242", "ap214", "ap203"}
    step_unit, iges_unit : {"mm", "inch"}
    iges_bodies : {"solid", "surfaces"}
        Boundary representations (types 186 and 510), or trimmed surfaces (144) without topology.
    brep_encoding, stl_encoding : {"text", "binary"}
    threemf_unit : {"millimeter", "inch", "micron"}
    glb_up : {"y", "z"}
    glb_unit : {"m", "mm"}
        Of one unit of length in the file.
    colors, names : bool
        Of parts and faces, where a format has them.
    """

    chord: float | None = None
    angle_deg: float | None = None
    step_schema: str = "ap242"
    step_unit: str = "mm"
    iges_bodies: str = "solid"
    iges_unit: str = "mm"
    brep_encoding: str = "text"
    stl_encoding: str = "binary"
    threemf_unit: str = "millimeter"
    glb_up: str = "y"
    glb_unit: str = "m"
    colors: bool = True
    names: bool = True

    def record(self) -> dict[str, Any]:
        """As a table of plain values."""
        return asdict(self)

    @staticmethod
    def from_record(values: Mapping[str, Any]) -> ExportOptions:
        """The inverse of `record`; ValueError when a value is none of its choices."""
        known = {field.name for field in fields(ExportOptions)}
        for name, value in values.items():
            spec = OPTIONS.get(name)
            if name not in known or spec is None or not spec.allows(value):
                raise ValueError(f"{name} = {value!r}")
        return ExportOptions(**values)


@dataclass(frozen=True)
class OptionSpec:
    """One option: the formats that have it, its choices (value and words) or limits, and what it means."""

    name: str
    title: str
    formats: tuple[str, ...]
    help: str
    choices: tuple[tuple[str, str], ...] = ()
    unit: str = ""
    limits: tuple[float, float] = (0.0, 0.0)

    @property
    def kind(self) -> Kind:
        """What it is chosen by; a number may be left out."""
        return "choice" if self.choices else "number" if self.unit else "switch"

    @property
    def flag(self) -> str:
        """Of the command line."""
        name = {"angle_deg": "angle", "threemf_unit": "3mf-unit"}.get(self.name, self.name.replace("_", "-"))
        return f"--no-{name}" if self.kind == "switch" else f"--{name}"

    @property
    def default(self) -> Any:
        """What holds when nothing is said."""
        return getattr(USUAL, self.name)

    def allows(self, value: object) -> bool:
        """Whether the option can have this value."""
        if self.kind == "choice":
            return value in [choice for choice, _ in self.choices]
        if self.kind == "switch":
            return isinstance(value, bool)
        if value is None:
            return True
        low, high = self.limits
        return isinstance(value, int | float) and not isinstance(value, bool) and low <= value <= high


_LENGTHS = (("mm", "mm"), ("inch", "inch"))
_ENCODINGS = (("binary", "binary"), ("text", "text"))
_SPECS = (
    OptionSpec(
        "chord",
        "Triangles within",
        MESH_FORMATS,
        "How far triangles may lie from the surfaces; left empty, 1e-4 of the outer cone distance",
        unit="mm",
        limits=(1e-5, 100.0),
    ),
    OptionSpec(
        "angle_deg",
        "Angle at most",
        MESH_FORMATS,
        "Largest angle between neighbouring chords; left empty, the distance alone decides",
        unit="°",
        limits=(0.5, 90.0),
    ),
    OptionSpec(
        "step_schema",
        "STEP schema",
        ("step",),
        "AP242 is today's; AP214 and AP203 are for older programs",
        (("ap242", "AP242"), ("ap214", "AP214"), ("ap203", "AP203")),
    ),
    OptionSpec("step_unit", "STEP unit", ("step",), "Unit of length in the file; the gear keeps its size", _LENGTHS),
    OptionSpec(
        "iges_bodies",
        "IGES bodies",
        ("iges",),
        "Solids know which faces meet; trimmed surfaces are for programs that know no solids",
        (("solid", "solids"), ("surfaces", "surfaces")),
    ),
    OptionSpec("iges_unit", "IGES unit", ("iges",), "Unit of length in the file; the gear keeps its size", _LENGTHS),
    OptionSpec("brep_encoding", "BREP as", ("brep",), "Binary is smaller and quicker, text can be read", _ENCODINGS),
    OptionSpec("stl_encoding", "STL as", ("stl",), "Binary is five times smaller, text can be read", _ENCODINGS),
    OptionSpec(
        "threemf_unit",
        "3MF unit",
        ("3mf",),
        "Unit of length in the file; the gear keeps its size",
        (("millimeter", "mm"), ("inch", "inch"), ("micron", "µm")),
    ),
    OptionSpec(
        "glb_up",
        "GLB up",
        ("glb",),
        "The axis that viewers take as up is y, as glTF asks; z keeps the gear's own axes",
        (("y", "y"), ("z", "z")),
    ),
    OptionSpec(
        "glb_unit",
        "GLB unit",
        ("glb",),
        "One unit of the file is a metre, as glTF asks; mm is for programs that do not scale",
        (("m", "m"), ("mm", "mm")),
    ),
    OptionSpec("colors", "Colours", ("step", "iges", "3mf", "glb"), "Colours of the members and of their flanks"),
    OptionSpec("names", "Names", ("step", "iges", "3mf", "glb"), "Names of the members and of every face"),
)
OPTIONS = {spec.name: spec for spec in _SPECS}
USUAL = ExportOptions()
"""Every option as it is when nothing is said."""


def options_of(formats: Iterable[str]) -> tuple[OptionSpec, ...]:
    """The options that any of these formats has."""
    chosen = set(formats)
    return tuple(spec for spec in _SPECS if chosen & set(spec.formats))
