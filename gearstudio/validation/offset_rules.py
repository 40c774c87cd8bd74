"""Rules of pairs with offset axes, and of depths after ISO 23509."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from gearstudio.design import Design, all_field_specs
from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.hypoid.design import hypoid_of
from gearstudio.theory.hypoid.inputs import HypoidError
from gearstudio.theory.hypoid.pair import HypoidPair
from gearstudio.theory.hypoid.soundness import trouble
from gearstudio.theory.modified import flank_of
from gearstudio.theory.profile import profile_of
from gearstudio.validation.nearest import cure
from gearstudio.validation.patience import seconds_left
from gearstudio.validation.rule import Finding, Rule, acting, fields, geometry, members, present
from gearstudio.validation.tooth_rules import POINT_FACTOR

Floats = NDArray[np.float64]

_ALONG = 7
_SCAN = 6
_SLOW_S = 1.0
_SHAPE = frozenset(
    path
    for path in all_field_specs()
    if path.split(".")[0] in ("pair", "lengthwise", "tooth", "depth") and path != "tooth.fillet_factor"
)
_RELIEVED = _SHAPE | frozenset(path for path in all_field_specs() if path.startswith("modifications."))


def _derivable(design: Design) -> Iterator[Finding]:
    try:
        hypoid_of(design)
    except HypoidError as error:
        yield Finding(acting(design, error.field), error.reason)


@lru_cache(maxsize=64)
def _troubles(pair: HypoidPair) -> tuple[tuple[int, str], ...]:
    found = ((side, trouble(pair, side)) for side in (1, -1))
    return tuple((side, words) for side, words in found if words is not None)


def _undercut(design: Design) -> Iterator[Finding]:
    pair = hypoid_of(design)
    wrong = _troubles(pair)
    if not wrong:
        return
    found = cure(design, lambda changed: not _troubles(hypoid_of(changed)), _CURES, _SCAN)
    flanks = " and ".join(f"{pair.flank_name('pinion', side)} flank {words}" for side, words in wrong)
    field = found.field or acting(design, "tooth.profile_shift")
    yield Finding(
        field,
        f"{present(design, field)} makes no conjugate pinion: its {flanks}; "
        f"use {found.text or 'more pinion teeth, a larger spiral angle or shallower teeth'}",
    )


_CURES = (
    ("tooth.profile_shift", 1.0),
    ("tooth.profile_shift", -0.5),
    ("tooth.addendum_factor", 0.5),
    ("pair.pressure_angle_deg", 30.0),
    ("pair.offset", 0.0),
)


def _width(member: MemberGeometry, u: float) -> Floats:
    """Azimuth of a tooth on a line u = constant of its flanks, along the face, and that line's polar angle (2, n)."""
    v = np.linspace(0.0, 1.0, _ALONG)
    tooth, delta = np.zeros(_ALONG), np.zeros(_ALONG)
    for name in FLANKS:
        flank = flank_of(member, name)
        rho, delta, phi = flank.locate(flank.points(u, v))
        tooth += flank.side * (phi - member.lengthwise.azimuth(rho))
    return np.stack([tooth, delta])


def tip_land(member: MemberGeometry) -> float:
    """Least width of a tooth's tip, brought to the heel [mm]."""
    tooth, delta = _width(member, 1.0)
    return float(np.min(tooth * np.sin(delta)) * member.outer_cone_distance)


def foot_space(member: MemberGeometry) -> float:
    """Least width of the tooth space at the lower edge of the flanks, brought to the heel [mm]."""
    tooth, delta = _width(member, 0.0)
    return float(np.min((member.pitch - tooth) * np.sin(delta)) * member.outer_cone_distance)


def _narrow(
    design: Design, width: Callable[[MemberGeometry], float], words: str, cures: tuple[tuple[str, float], ...]
) -> Iterator[Finding]:
    for member in members(design):
        if width(member) > POINT_FACTOR * member.module:
            continue

        def works(changed: Design, name: str = member.name) -> bool:
            other = geometry(changed).member(name)
            return width(other) > POINT_FACTOR * other.module

        found = cure(design, works, cures, _SCAN)
        field = found.field or acting(design, cures[0][0])
        yield Finding(
            field,
            f"{present(design, field)} {words.format(name=member.name)} ({width(member):.3g} mm); "
            f"use {found.text or 'smaller modifications, or other depths'}",
        )


def _pointed(design: Design) -> Iterator[Finding]:
    cures = (
        ("tooth.addendum_factor", 0.3),
        ("tooth.profile_shift", 0.0),
        ("tooth.backlash", 0.0),
        ("pair.pressure_angle_deg", 10.0),
    )
    yield from _narrow(design, tip_land, "makes the {name}'s teeth pointed", cures)


def _closed(design: Design) -> Iterator[Finding]:
    cures = (("tooth.profile_shift", 0.0), ("tooth.addendum_factor", 0.3), ("pair.pressure_angle_deg", 10.0))
    yield from _narrow(design, foot_space, "leaves the {name} no tooth space at the foot of the flanks", cures)


def _fillets(design: Design) -> Iterator[Finding]:
    if seconds_left() < _SLOW_S:  # those who make the teeth are told of it then
        return
    for member in members(design):
        reason = _no_profile(member)
        if reason is None:
            continue

        def works(changed: Design, name: str = member.name) -> bool:
            return _no_profile(geometry(changed).member(name)) is None

        found = cure(design, works, [("tooth.fillet_factor", 0.01), ("tooth.clearance_factor", 0.5)], _SCAN)
        field = found.field or "tooth.fillet_factor"
        remedy = found.text or ("" if "use " in reason else "a larger clearance or shallower teeth")
        yield Finding(
            field,
            f"{present(design, field)} leaves the {member.name} no root: {reason}{remedy and f'; use {remedy}'}",
        )


def _no_profile(member: MemberGeometry) -> str | None:
    try:
        profile_of(member)
    except GeometryError as error:
        return str(error)
    return None


_TEETH = frozenset({"derivable", "no_thickness"})
DERIVABLE = Rule("derivable", "error", _SHAPE, frozenset({"pitch_cone", "face_width"}), "pair.offset", _derivable)
FILLETS = Rule(
    "fillet", "error", _RELIEVED | fields("tooth", "fillet_factor"), _TEETH | {"undercut", "pointed_tip", "no_space"},
    "tooth.fillet_factor", _fillets,
)  # fmt: skip
OFFSET_RULES = (
    Rule("undercut", "error", _SHAPE, _TEETH, "tooth.profile_shift", _undercut),
    Rule("pointed_tip", "error", _RELIEVED, _TEETH | {"undercut"}, "tooth.addendum_factor", _pointed),
    Rule("no_space", "error", _RELIEVED, _TEETH | {"undercut"}, "tooth.profile_shift", _closed),
    FILLETS,
)
