"""Lengths and angles as the user wants to see them; the one place where the window converts millimetres.

The design, its file and every computation stay in millimetres and degrees; only what is shown and typed is converted.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import Literal

from ui.formatting import fixed, number_text, significant, typed
from ui.words import tr

LengthUnit = Literal["mm", "in"]
MM_PER_INCH = 25.4
AUTOMATIC = 0
INCH_EXTRA = 2
"""Further decimals in inches: an inch has 25 times as much in a digit."""


_MILLIMETRES = re.compile(
    r"“[^“”\n]*”|„[^„“\n]*“"  # a line of a file
    r"|(?<![\w.])(?P<size>[-−]?\d+(?:\.\d+)?) mm(?!\w|\.\w)"
)


@dataclass(frozen=True)
class Display:
    """How numbers are shown.

    Attributes
    ----------
    length : {"mm", "in"}
    decimals : int
        Of a length in mm and of an angle in degrees; `AUTOMATIC` leaves it to each place, in inches two more.
    """

    length: LengthUnit = "mm"
    decimals: int = AUTOMATIC


_shown = Display()


def display() -> Display:
    """How numbers are shown now."""
    return _shown


def use(shown: Display) -> None:
    """Show numbers in this way from now on; what is on the screen must be shown again."""
    global _shown
    _shown = replace(shown)


def factor(unit: str) -> float:
    """What a value in a unit of the design is divided by to be shown: 25.4 for mm shown in inches, else 1."""
    return MM_PER_INCH if unit == "mm" and _shown.length == "in" else 1.0


def unit_shown(unit: str) -> str:
    """The unit in which a quantity of the design is shown."""
    return _shown.length if unit == "mm" else unit


def to_shown(value: float, unit: str) -> float:
    """A value of the design in the unit shown; a value that needs no conversion stays what it is."""
    scale = factor(unit)
    return value if scale == 1 else float(f"{value / scale:.12g}")


def from_shown(value: float, unit: str) -> float:
    """A value in the unit shown back in the design's unit, to twelve digits, so that 0.25 in is 6.35 mm."""
    scale = factor(unit)
    return value if scale == 1 else float(f"{value * scale:.12g}")


def shown_text(value: float, unit: str) -> str:
    """A value of the design as the user would type it, in the unit shown, without the unit; in inches to 8 digits."""
    return number_text(value) if factor(unit) == 1 else typed(to_shown(value, unit), 8)


def value_text(value: float, unit: str, decimals: int = 3) -> str:
    """A value of the design for reading, without the unit: ``12.500``.

    `decimals` holds where the user left it automatic.
    """
    chosen = decimals if _shown.decimals == AUTOMATIC or unit not in ("mm", "°") else _shown.decimals
    return fixed(value / factor(unit), chosen + (INCH_EXTRA if factor(unit) != 1 else 0))


def with_unit(value: float, unit: str, decimals: int = 3) -> str:
    """A value of the design for reading, with the unit: ``12.500 mm``, ``35.000°``."""
    return f"{value_text(value, unit, decimals)}{spaced(unit)}"


def small_text(millimetres: float) -> str:
    """A small length that one measures on a gear, as a backlash: in µm, or in inches where lengths are."""
    return f"{significant(millimetres * 1e3)} µm" if factor("mm") == 1 else with_unit(millimetres, "mm", 3)


def per_length(unit: str) -> tuple[str, float]:
    """Unit in which a curvature (``1/mm``, ``1/mm²``) is shown, and what to multiply its values with."""
    if not unit.startswith("1/mm") or factor("mm") == 1:
        return unit, 1.0
    power = 2 if unit.endswith("²") else 1
    return unit.replace("mm", _shown.length), factor("mm") ** power


def in_sentence(text: str) -> str:
    """A sentence in which lengths in mm become inches where lengths are shown so, with two digits more.

    What stands in quotes, as a line of a file, stays as it is.
    """
    if factor("mm") == 1:
        return text

    def converted(found: re.Match[str]) -> str:
        if found["size"] is None:
            return found[0]
        number = found["size"].replace("−", "-")
        digits = len(number.replace(".", "").lstrip("-0")) + 2
        shown = f"{float(number) / MM_PER_INCH:.{digits}g}"
        return f"{shown if 'e' not in shown else fixed(float(shown), 9)} {_shown.length}"

    return _MILLIMETRES.sub(converted, text)


def spaced(unit: str) -> str:
    """The unit shown with the space that goes before it."""
    shown = tr(unit_shown(unit))
    return shown if shown in ("", "°") else f" {shown}"
