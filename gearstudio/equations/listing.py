"""All equations, and those that concern a pair."""

from __future__ import annotations

from gearstudio.equations.records import Equation, holds
from gearstudio.equations.relief_table import RELIEF
from gearstudio.equations.sizes_table import SIZES
from gearstudio.equations.standard_table import STANDARD
from gearstudio.equations.table import PAPER
from gearstudio.theory.cones import PairGeometry

EQUATIONS: tuple[Equation, ...] = (*PAPER, *SIZES, *STANDARD, *RELIEF)

_BY_KEY = {one.key: one for one in EQUATIONS}


def equation(key: str) -> Equation:
    """The equation of a key.

    Raises
    ------
    KeyError
        There is none.
    """
    return _BY_KEY[key]


def listed(pair: PairGeometry) -> tuple[Equation, ...]:
    """Equations to show with a pair: all of the paper's, and of the others those that hold for it."""
    return tuple(one for one in EQUATIONS if one in PAPER or holds(one, pair))
