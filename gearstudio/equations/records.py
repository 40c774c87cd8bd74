"""What an equation is, and the numbers of a design put into it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from gearstudio.theory.cones import MemberGeometry, PairGeometry

Unit = Literal["mm", "°", "rad", ""]
_UNITS: dict[Unit, str] = {"": "", "°": '"°"', "mm": ' thin "mm"', "rad": ' thin "rad"'}


@dataclass(frozen=True)
class Given:
    """A symbol (typst mathematics), its value in `unit`, and the unit: mm, °, rad or none."""

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
        Section of the theory.
    used : str
        As it is computed, typst mathematics.
    printed : str
        As the paper prints it where that differs, typst mathematics; else empty.
    meaning : str
        What it says, in a sentence or two.
    departure, evidence : str
        Why the printed form is not used and what shows it; else empty.
    numbers : callable, optional
        From a member in its pair to the numbers put in and got out.
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
    numbers: Callable[[Subject], Numbers] | None = None


def numbers_of(equation: Equation, pair: PairGeometry, member: str) -> Numbers | None:
    """The numbers of a member put into an equation.

    None for an equation that stands without numbers, and for all of them where the cones follow from an offset or
    from depths of ISO 23509: the equations are those of the paper's bevel pairs.
    """
    if equation.numbers is None or pair.hypoid is not None:
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


def pure(symbol: str, value: float) -> Given:
    """A number without unit."""
    return Given(symbol, float(value), "")
