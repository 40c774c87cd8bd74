"""What a geometry rule is, and the sets of fields that rules read."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from gearstudio.design import Design, all_field_specs
from gearstudio.errors import Severity
from gearstudio.theory.cones import MemberGeometry, PairGeometry, pair_geometry

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
DEPTH = SIZE | fields("tooth", "addendum_factor", "clearance_factor", "profile_shift")
TIP = DEPTH | fields("tooth", "tip_cone")
PROFILE = PRESSURE | TIP | fields("tooth", "ends")
THICKNESS = PROFILE | fields("tooth", "backlash")
BLANKS = frozenset(path for path in all_field_specs() if path.startswith("blank."))
ARC = WIDTH | SPIRAL | fields("lengthwise", "cutter_radius")


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
