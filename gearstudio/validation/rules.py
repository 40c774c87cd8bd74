"""The table of geometry rules: what fields together must satisfy to make a gear.

Each rule names the fields it reads, so that it still runs when other fields are unusable, and the rules
without which it has no meaning.
"""

from __future__ import annotations

from dataclasses import replace

from gearstudio.design import Design
from gearstudio.errors import GeometryError, Issue
from gearstudio.validation.fillet_rules import FILLETS, RESIZED
from gearstudio.validation.mesh_rules import MESH_RULES
from gearstudio.validation.offset_rules import DERIVABLE, OFFSET_RULES
from gearstudio.validation.pair_rules import PAIR_RULES
from gearstudio.validation.relief_rules import RELIEF_RULES
from gearstudio.validation.rule import Rule, acting
from gearstudio.validation.tooth_rules import TOOTH_RULES

RULES: tuple[Rule, ...] = (*PAIR_RULES, *TOOTH_RULES, *RELIEF_RULES, *MESH_RULES)
_OF_EVERY_PAIR = frozenset({"pitch_cone", "larger_pinion", "face_width", "toe_curve"})
_OF_OFFSET_PAIRS = frozenset({"no_thickness", "steep_relief", "face_cone", "contact_ratio", "blank"})


def rules_of(design: Design) -> tuple[Rule, ...]:
    """The rules that have a meaning for a kind of pair, in their order."""
    if design.pair.offset == 0 and design.depth.system == "outer_module":
        return RULES
    first = tuple(rule for rule in RULES if rule.code in _OF_EVERY_PAIR)
    rest = [rule for rule in RULES if rule.code not in _OF_EVERY_PAIR]
    if design.pair.offset == 0:
        needing = (replace(rule, needs=rule.needs | {DERIVABLE.code}) for rule in rest)
        return (*first, DERIVABLE, *needing, FILLETS, RESIZED)
    known = {rule.code for rule in OFFSET_RULES} | _OF_OFFSET_PAIRS | _OF_EVERY_PAIR
    kept = [rule for rule in rest if rule.code in _OF_OFFSET_PAIRS]
    thickness, *others = (replace(rule, needs=rule.needs & known | {DERIVABLE.code}) for rule in kept)
    meshing = (replace(rule, needs=rule.needs | {"undercut"}) for rule in others)
    return (*first, DERIVABLE, thickness, *OFFSET_RULES, *meshing)


def broken_rules(design: Design, unusable: frozenset[str]) -> list[Issue]:
    """Issues of every rule that a design breaks.

    Parameters
    ----------
    design : Design
    unusable : frozenset of str
        Fields or whole tables whose values in the design are stand-ins; rules that read them are left out.
    """
    issues: list[Issue] = []
    failed: set[str] = set()
    for rule in rules_of(design):
        if failed & rule.needs or any(_is_within(path, unusable) for path in rule.inputs):
            failed.add(rule.code)
            continue
        found = _apply(rule, design)
        issues += found
        if any(issue.severity == "error" for issue in found):
            failed.add(rule.code)
    return issues


def _apply(rule: Rule, design: Design) -> list[Issue]:
    try:
        found = list(rule.find(design))
        return [Issue(rule.code, acting(design, one.field), one.message, rule.severity) for one in found]
    except GeometryError as error:
        return [Issue(rule.code, acting(design, rule.blames), f"these values make no gear: {error}")]


def _is_within(path: str, unusable: frozenset[str]) -> bool:
    return any(path == bad or path.startswith(f"{bad}.") for bad in unusable)
