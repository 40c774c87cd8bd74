"""Rules of pairs with offset axes, and of depths after ISO 23509."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from gearstudio.design import Design, all_field_specs
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.hypoid.design import hypoid_of
from gearstudio.theory.hypoid.inputs import HypoidError
from gearstudio.theory.hypoid.pair import HypoidPair
from gearstudio.theory.hypoid.undercut import trouble
from gearstudio.theory.modified import flank_of
from gearstudio.validation.fillet_rules import FILLETS, RESIZED
from gearstudio.validation.nearest import cure
from gearstudio.validation.rule import Finding, Rule, acting, geometry, members, present
from gearstudio.validation.tooth_rules import POINT_FACTOR

Floats = NDArray[np.float64]

_ALONG = 7
_SCAN = 6
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


@lru_cache(maxsize=64)
def _widths(member: MemberGeometry) -> Floats:
    """Azimuth of a tooth at the lower and the upper edge of its flanks, along the face, and their polar angles."""
    u, v = np.array([[0.0], [1.0]]), np.linspace(0.0, 1.0, _ALONG)
    tooth, delta = np.zeros((2, _ALONG)), np.zeros((2, _ALONG))
    for name in FLANKS:
        flank = flank_of(member, name)
        rho, delta, phi = flank.locate(flank.points(u, v))
        tooth += flank.side * (phi - member.lengthwise.azimuth(rho))
    return np.stack([tooth, delta])


def tip_land(member: MemberGeometry) -> float:
    """Least width of a tooth's tip, brought to the heel [mm]."""
    tooth, delta = _widths(member)[:, 1]
    return float(np.min(tooth * np.sin(delta)) * member.outer_cone_distance)


def foot_space(member: MemberGeometry) -> float:
    """Least width of the tooth space at the lower edge of the flanks, brought to the heel [mm]."""
    tooth, delta = _widths(member)[:, 0]
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


_TEETH = frozenset({"derivable", "no_thickness"})
DERIVABLE = Rule("derivable", "error", _SHAPE, frozenset({"pitch_cone", "face_width"}), "pair.offset", _derivable)
OFFSET_RULES = (
    Rule("undercut", "error", _SHAPE, _TEETH, "tooth.profile_shift", _undercut),
    Rule("pointed_tip", "error", _RELIEVED, _TEETH | {"undercut"}, "tooth.addendum_factor", _pointed),
    Rule("no_space", "error", _RELIEVED, _TEETH | {"undercut"}, "tooth.profile_shift", _closed),
    FILLETS,
    RESIZED,
)
