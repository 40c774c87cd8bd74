"""A contact analysis and the maps of it that are looked at, made in a thread; no widget."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

from gearstudio.analysis.contact import contact_analysis, edge_warnings, one_direction
from gearstudio.analysis.contact_placing import Misalignment
from gearstudio.analysis.contact_result import ContactResult, Direction
from gearstudio.theory.cones import PairGeometry
from ui.analysis.contact_view import PatternMap, patterns
from ui.analysis.ease_off_view import EaseOffMaps, ease_off_maps

Shown = Literal["pattern", "ease_off"]


@dataclass(frozen=True)
class Case:
    """What the contact is analysed for; while a slider moves only the direction that is looked at is."""

    pair: PairGeometry
    misalignment: Misalignment
    thickness_um: float
    sliding: bool = False


@dataclass(frozen=True)
class ContactView:
    """One analysis, and of one direction the maps that are shown: patterns or ease-off."""

    case: Case
    result: ContactResult
    side: Direction
    patterns: tuple[PatternMap, PatternMap] | None = None
    ease_off: EaseOffMaps | None = None


def analyse(
    case: Case, side: Direction = "drive", shown: Shown = "pattern", known: ContactView | None = None
) -> ContactView:
    """Analyse the contact, unless that is known already, and draw what is looked at.

    Raises
    ------
    GeometryError
        There is no contact.
    """
    if known is not None and known.case == case:
        result = known.result
    elif known is not None and case.sliding and known.case.pair is case.pair:
        result = _renewed(known.result, case, side)
    else:
        result = contact_analysis(case.pair, case.misalignment, thickness_um=case.thickness_um)
    one = result.direction(side)
    if shown == "ease_off":
        return ContactView(case, result, side, ease_off=ease_off_maps(case.pair, one))
    return ContactView(case, result, side, patterns=patterns(case.pair, one))


def _renewed(known: ContactResult, case: Case, side: Direction) -> ContactResult:
    """One direction analysed again; the other is as it was, and the backlash, which takes both, is not known."""
    fresh = one_direction(case.pair, side, case.misalignment, case.thickness_um)
    both = {"drive": known.drive, "coast": known.coast, side: fresh}
    return replace(
        known,
        misalignment=case.misalignment,
        thickness_um=case.thickness_um,
        play_mm=float("nan"),
        warnings=tuple(edge_warnings(fresh)),
        **both,
    )
