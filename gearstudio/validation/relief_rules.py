"""Rules of micro-geometry: what is taken off or added must leave flanks, tips and tooth spaces."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from gearstudio.design import Design, all_field_specs, field_value, with_field
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.involute import involute_azimuth
from gearstudio.theory.modified import azimuth_shift, relief_on
from gearstudio.theory.pair import tip_half_azimuth
from gearstudio.theory.relief import flank_relief
from gearstudio.validation.nearest import Cure, cure
from gearstudio.validation.rule import ARC, THICKNESS, Finding, Holds, Rule, members
from gearstudio.validation.tooth_rules import POINT_FACTOR, TOOTHED

Floats = NDArray[np.float64]

STEEPEST_UM_PER_MM = 200.0
"""Most by which micro-geometry may rise along a flank."""
_GRID = 13
_MOST_CANDIDATES = 3
RELIEF = frozenset(path for path in all_field_specs() if path.startswith("modifications."))


def _is_modified(member: MemberGeometry) -> bool:
    return member.reliefs != (None, None)


def steepness(member: MemberGeometry) -> float:
    """Most by which micro-geometry rises along a member's flanks [µm/mm]."""
    frame = member.relief_frame
    rho = np.linspace(member.inner_cone_distance, member.outer_cone_distance, _GRID)[:, None]
    low, tip = frame.low.at(rho)[0], frame.tip.at(rho)[0]
    delta = low + np.linspace(0.0, 1.0, _GRID) * (tip - low)
    slopes = [0.0]
    for relief in member.reliefs:
        if relief is not None:
            _, by_rho, by_delta, *_ = relief.derivatives(rho, delta)
            slopes.append(1e3 * float(np.hypot(by_rho, by_delta / rho).max()))
    return max(slopes)


def _taken(member: MemberGeometry, rho: Floats, delta: Floats) -> Floats:
    """Azimuth by which the tooth is thinner than without micro-geometry [rad]."""
    return np.asarray(sum(-side * azimuth_shift(member, side, relief_on(member, side), rho, delta) for side in (1, -1)))


def tip_land(member: MemberGeometry) -> float:
    """Least width of the tooth's tip, brought to the heel [mm]."""
    rho = np.linspace(member.inner_cone_distance, member.outer_cone_distance, _GRID)
    delta = member.tip_limit.at_sphere(rho)
    width = 2 * tip_half_azimuth(member, rho) - _taken(member, rho, delta)
    return float(np.min(width * np.sin(delta)) * member.outer_cone_distance)


def foot_space(member: MemberGeometry) -> float:
    """Least width of the tooth space at the lower edge of the flanks, brought to the heel [mm]."""
    rho = np.linspace(member.inner_cone_distance, member.outer_cone_distance, _GRID)
    delta = np.full_like(rho, max(member.root_angle, member.base_angle))
    betas = involute_azimuth([member.pitch_angle, float(delta[0])], member.base_angle)
    tooth = 2 * (member.half_tooth_azimuth + betas[0] - betas[1]) - _taken(member, rho, delta)
    return float(np.min((member.pitch - tooth) * np.sin(delta)) * member.outer_cone_distance)


def _is_gentle(member: MemberGeometry) -> bool:
    return steepness(member) <= STEEPEST_UM_PER_MM


def _has_tip(member: MemberGeometry) -> bool:
    return tip_land(member) > POINT_FACTOR * member.module


def _has_space(member: MemberGeometry) -> bool:
    return foot_space(member) > POINT_FACTOR * member.module


def _amounts(design: Design, member: str) -> list[str]:
    """Fields of a member's micro-geometry that are not 0, the largest first."""
    paths = [path for path in RELIEF if path.startswith(f"modifications.{member}.") and path.endswith("_um")]
    used = [path for path in sorted(paths) if field_value(design, path) != 0.0]
    return sorted(used, key=lambda path: -abs(field_value(design, path)))


def _cured(design: Design, member: MemberGeometry, holds: Holds) -> Cure:
    frame = member.relief_frame

    def works(changed: Design) -> bool:
        flanks = getattr(changed.modifications, member.name)
        reliefs = (flank_relief(flanks.concave, frame), flank_relief(flanks.convex, frame))
        return holds(replace(member, reliefs=reliefs))

    paths = _amounts(design, member.name)[:_MOST_CANDIDATES]
    return cure(design, works, [(path, 0.0) for path in paths if works(with_field(design, path, 0.0))])


def _findings(design: Design, holds: Holds, words: Callable[[MemberGeometry], str]) -> Iterator[Finding]:
    for member in members(design):
        bare = replace(member, reliefs=(None, None))
        if not _is_modified(member) or holds(member) or not holds(bare):
            continue
        found = _cured(design, member, holds)
        field = found.field or _amounts(design, member.name)[0]
        flank = next(name for name in FLANKS if f".{name}." in field)
        yield Finding(
            field,
            f"{field_value(design, field):.10g} µm on the {member.name}'s {flank} flank {words(member)}; "
            f"use {found.text or 'smaller amounts on both flanks of this member'}",
        )


def _steep(design: Design) -> Iterator[Finding]:
    yield from _findings(
        design,
        _is_gentle,
        lambda member: (
            f"makes its micro-geometry rise by up to {steepness(member):.4g} µm per mm of the flank, "
            f"more than {STEEPEST_UM_PER_MM:g}"
        ),
    )


def _pointed(design: Design) -> Iterator[Finding]:
    yield from _findings(
        design,
        _has_tip,
        lambda member: (
            f"leaves the tip of its teeth {max(tip_land(member), 0.0):.3g} mm wide at the heel, "
            f"less than {POINT_FACTOR * member.module:.3g} mm: they are pointed"
        ),
    )


def _closed(design: Design) -> Iterator[Finding]:
    yield from _findings(
        design,
        _has_space,
        lambda member: (
            f"leaves {max(foot_space(member), 0.0):.3g} mm of the tooth space at the foot of the flanks, "
            f"less than {POINT_FACTOR * member.module:.3g} mm"
        ),
    )


_INPUTS = THICKNESS | ARC | RELIEF
_NEEDS = TOOTHED | {"pointed_tip", "no_space", "cutter_arc"}
RELIEF_RULES = (
    Rule("steep_relief", "error", _INPUTS, _NEEDS, "modifications.pinion.concave.tip_relief_um", _steep),
    Rule("pointed_relief", "error", _INPUTS, _NEEDS, "modifications.pinion.concave.tip_relief_um", _pointed),
    Rule("closed_relief", "error", _INPUTS, _NEEDS, "modifications.pinion.concave.bias_um", _closed),
)
