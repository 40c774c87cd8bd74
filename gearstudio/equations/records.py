"""What an equation is, and the numbers of a design put into it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from gearstudio.theory.cones import MemberGeometry, PairGeometry

Unit = Literal["mm", "in", "µm", "°", "rad", ""]
Holds = Literal["always", "no offset", "own depth", "standard depth", "offset"]
"""For which pairs an equation holds: all; those whose axes meet; of these, those with depths from the module; those
with depths after ISO 23509 or with an offset; those with an offset."""
_UNITS: dict[Unit, str] = {
    "": "", "°": '"°"', "mm": ' thin "mm"', "in": ' thin "in"', "µm": ' thin "µm"', "rad": ' thin "rad"',
}  # fmt: skip


@dataclass(frozen=True)
class Given:
    """A symbol (typst mathematics), its value, and the unit; lengths of a design come in mm or µm, never in inches."""

    symbol: str
    value: float
    unit: Unit

    def mathematics(self, digits: int) -> str:
        """Symbol, value and unit as typst mathematics; whole numbers without a unit have no point."""
        whole = not self.unit and self.value == int(self.value)
        value = f"{self.value:.0f}" if whole else f"{self.value:.{digits}g}"
        return f"{self.symbol} = {value}{_UNITS[self.unit]}"


@dataclass(frozen=True)
class Numbers:
    """What went into an equation and what came out."""

    inputs: tuple[Given, ...]
    outputs: tuple[Given, ...]


@dataclass(frozen=True)
class Subject:
    """A member in its pair, with what equations often ask for; angles in radians."""

    pair: PairGeometry
    member: MemberGeometry

    @property
    def mate(self) -> MemberGeometry:
        """The other member."""
        return self.pair.wheel if self.member is self.pair.pinion else self.pair.pinion

    @property
    def is_conjugate(self) -> bool:
        """Whether the member's flanks are envelopes of the mate's, on no base cone and along no curve of their own."""
        return self.pair.has_offset and self.member is self.pair.pinion


@dataclass(frozen=True)
class Equation:
    """One equation of the theory.

    Attributes
    ----------
    key : str
        Unique name.
    group, title : str
    paper : str
        Number in the paper; empty when it is not printed there.
    section : str
        Section of the theory, or the standard or part of the program that it belongs to.
    used : str
        As it is computed, typst mathematics.
    printed : str
        As the paper prints it where that differs, typst mathematics; else empty.
    meaning : str
        What it says, in a sentence or two.
    departure, evidence : str
        Why the printed form is not used and what shows it; else empty.
    numbers : callable, optional
        From a member in its pair to the numbers put in and got out; None where the member has none.
    holds : Holds
        For which pairs it holds; for others it takes no numbers.
    """

    key: str
    group: str
    title: str
    paper: str
    section: str
    used: str
    meaning: str
    printed: str = ""
    departure: str = ""
    evidence: str = ""
    numbers: Callable[[Subject], Numbers | None] | None = None
    holds: Holds = "no offset"

    @property
    def where(self) -> str:
        """Where it stands beside the paper: ``theory, section 5``, ``ISO 23509``, ``offset axes``."""
        return f"theory, section {self.section}" if self.section[:1].isdigit() else self.section


def holds(equation: Equation, pair: PairGeometry) -> bool:
    """Whether an equation is one of those that a pair is made by."""
    return {
        "always": True,
        "no offset": not pair.has_offset,
        "own depth": pair.hypoid is None,
        "standard depth": pair.hypoid is not None,
        "offset": pair.has_offset,
    }[equation.holds]


def numbers_of(equation: Equation, pair: PairGeometry, member: str) -> Numbers | None:
    """The numbers of a member put into an equation.

    None for an equation that stands without numbers, and where it does not hold: for a pair with an offset those of
    bevel pairs, and so on.
    """
    if equation.numbers is None or not holds(equation, pair):
        return None
    return equation.numbers(Subject(pair, pair.member(member)))


def deg(symbol: str, angle: float) -> Given:
    """An angle [rad] to be shown in degrees."""
    return Given(symbol, float(np.degrees(angle)), "°")


def rad(symbol: str, angle: float) -> Given:
    """An angle to be shown in radians."""
    return Given(symbol, float(angle), "rad")


def mm(symbol: str, length: float) -> Given:
    """A length."""
    return Given(symbol, float(length), "mm")


def um(symbol: str, length: float) -> Given:
    """A length [mm] to be shown in µm."""
    return Given(symbol, float(length) * 1e3, "µm")


def pure(symbol: str, value: float) -> Given:
    """A number without unit."""
    return Given(symbol, float(value), "")
