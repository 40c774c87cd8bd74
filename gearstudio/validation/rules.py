"""The table of geometry rules: what fields together must satisfy to make a gear.

Each rule names the fields it reads, so that it still runs when other fields are unusable, and the rules
without which it has no meaning.
"""

from __future__ import annotations

from gearstudio.design import Design
from gearstudio.errors import GeometryError, Issue
from gearstudio.validation.mesh_rules import MESH_RULES
from gearstudio.validation.pair_rules import PAIR_RULES
from gearstudio.validation.relief_rules import RELIEF_RULES
from gearstudio.validation.rule import Rule
from gearstudio.validation.tooth_rules import TOOTH_RULES

RULES: tuple[Rule, ...] = (*PAIR_RULES, *TOOTH_RULES, *RELIEF_RULES, *MESH_RULES)


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
    for rule in RULES:
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
        return [Issue(rule.code, finding.field, finding.message, rule.severity) for finding in rule.find(design)]
    except GeometryError as error:
        return [Issue(rule.code, rule.blames, f"these values make no gear: {error}")]


def _is_within(path: str, unusable: frozenset[str]) -> bool:
    return any(path == bad or path.startswith(f"{bad}.") for bad in unusable)
