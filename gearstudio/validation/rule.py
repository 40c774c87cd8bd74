"""What a geometry rule is, and the sets of fields that rules read."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from gearstudio.design import Design, all_field_specs, field_value, with_field
from gearstudio.errors import Severity
from gearstudio.theory.cones import MemberGeometry, PairGeometry, pair_geometry
from gearstudio.theory.hypoid.design import hypoid_of

Holds = Callable[[MemberGeometry], bool]


@dataclass(frozen=True)
class Finding:
    """One way in which a design breaks a rule: the field to change, and what is wrong with a remedy."""

    field: str
    message: str


@dataclass(frozen=True)
class Rule:
    """A rule of geometry.

    Attributes
    ----------
    code : str
        Of its issues.
    severity : {"error", "warning"}
    inputs : frozenset of str
        Dotted names of every field that can change its outcome.
    needs : frozenset of str
        Codes of rules that must hold before this one can be asked.
    blames : str
        Field of the issue when the geometry cannot be computed at all.
    find : callable
        The findings in a design; may raise GeometryError.
    """

    code: str
    severity: Severity
    inputs: frozenset[str]
    needs: frozenset[str]
    blames: str
    find: Callable[[Design], Iterable[Finding]]


def fields(table: str, *keys: str) -> frozenset[str]:
    """Dotted names of keys of one table."""
    return frozenset(f"{table}.{key}" for key in keys)


RATIO = fields("pair", "pinion_teeth", "wheel_teeth", "shaft_angle_deg")
SIZE = RATIO | fields("pair", "outer_module")
WIDTH = SIZE | fields("pair", "face_width", "face_width_factor")
SPIRAL = fields("lengthwise", "curve", "spiral_angle_deg", "spiral_angle_at")
PRESSURE = WIDTH | SPIRAL | fields("pair", "pressure_angle_deg", "pressure_angle_kind")
DEPTHS = frozenset(path for path in all_field_specs() if path.startswith("depth."))
DEPTH = SIZE | DEPTHS | fields("tooth", "addendum_factor", "clearance_factor", "profile_shift")
TIP = DEPTH | fields("tooth", "tip_cone")
PROFILE = PRESSURE | TIP | fields("tooth", "ends")
THICKNESS = PROFILE | fields("tooth", "backlash")
BLANKS = frozenset(path for path in all_field_specs() if path.startswith("blank."))
ARC = WIDTH | SPIRAL | fields("lengthwise", "cutter_radius")


_IN_ISO = {
    "tooth.addendum_factor": "depth.depth_factor",
    "tooth.clearance_factor": "depth.clearance_factor",
    "tooth.profile_shift": "depth.mean_addendum_factor",
    "tooth.tip_cone": "depth.taper",
}


def acting(design: Design, path: str) -> str:
    """The field that does with a design's depth system what another one does with the other system."""
    if design.depth.system == "outer_module":
        return {iso: own for own, iso in _IN_ISO.items()}.get(path, path)
    return _IN_ISO.get(path, path)


def explicit(design: Design) -> Design:
    """The design with its mean addendum factor written out where it is left to the program."""
    if design.depth.system == "outer_module" or design.depth.mean_addendum_factor is not None:
        return design
    depth = hypoid_of(design).depth
    return with_field(design, "depth.mean_addendum_factor", depth.addenda[1] / depth.working_depth)


def present(design: Design, path: str) -> str:
    """The value of a field, or of the one that stands for it, as messages quote it."""
    value = field_value(explicit(design), acting(design, path))
    return f"{value:.10g}" if isinstance(value, int | float) else str(value)


@lru_cache(maxsize=256)
def geometry(design: Design) -> PairGeometry:
    """`pair_geometry`, remembered: most rules ask for the same design."""
    with np.errstate(invalid="ignore", divide="ignore"):  # rules that need a sound width or angle ask for it
        return pair_geometry(design)


def members(design: Design) -> tuple[MemberGeometry, MemberGeometry]:
    """Pinion and wheel of a design."""
    pair = geometry(design)
    return pair.pinion, pair.wheel


def mate_of(pair: PairGeometry, member: MemberGeometry) -> MemberGeometry:
    """The other member of a pair."""
    return pair.wheel if member.name == "pinion" else pair.pinion
