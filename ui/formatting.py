"""Numbers and words as the window shows them; the one place that decides how its language writes a number.

What a file holds is none of this: there the decimal sign is a point in every language.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from html import escape
from typing import Any

from gearstudio.catalogue import METHOD_INFOS
from gearstudio.design.choices import choice_title as choice_title
from gearstudio.words import POINT, with_decimal
from ui.language import decimal
from ui.words import tr

MINUS = "\N{MINUS SIGN}"
WIDE = dict(zip(range(0xFF01, 0xFF5F), range(0x21, 0x7F), strict=True))
"""Digits and signs as Chinese input may write them, to those of ASCII."""
NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?", re.ASCII)

METHOD_TITLES = {info.id: info.title for info in METHOD_INFOS}
VARIANT_TITLES = {"published": "Published", "optimised": "Optimised"}
MEMBER_TITLES = {"pinion": "Pinion", "wheel": "Wheel"}
CONSTRUCTION_TITLES = {"assemble": "Assembled from its faces", "cut": "Cut from the blank (slow)"}


def written(text: str) -> str:
    """A text with its numbers as the window's language writes them: with a decimal comma in German."""
    return with_decimal(text, decimal())


def number(value: float, spec: str = ".6g") -> str:
    """A number formatted in Python's way, as the window's language writes it, with a true minus sign."""
    return written(f"{value:{spec}}").replace("-", MINUS)


def listed(texts: Iterable[str]) -> str:
    """Values one after the other, parted by what no number holds: commas, semicolons where those are decimal signs."""
    return (", " if decimal() == POINT else "; ").join(texts)


def significant(value: float, digits: int = 3, most_decimals: int = 9) -> str:
    """A number with so many significant digits and no exponent; a true minus sign before negatives."""
    if not math.isfinite(value):
        return "–"
    if value == 0:
        return "0"
    rounded = float(f"{value:.{digits - 1}e}")
    decimals = min(max(0, digits - 1 - math.floor(math.log10(abs(rounded)))), most_decimals)
    return fixed(rounded, decimals)


def micrometres(value_um: float) -> str:
    """A deviation in the unit that reads best: ``54.6 µm``, ``31.2 nm``, ``0.054 nm``, ``< 0.001 nm``."""
    if 0 < abs(value_um) < 5e-7:
        return written("< 0.001 nm")
    unit, factor = _unit(value_um)
    return f"{significant(value_um * factor, most_decimals=3)} {unit}"


def span(lowest_um: float, highest_um: float) -> str:
    """Two signed deviations in one unit: ``−46.7 … +42.7 µm``."""
    unit, factor = _unit(max(abs(lowest_um), abs(highest_um)))
    low, high = (significant(value * factor, most_decimals=3) for value in (lowest_um, highest_um))
    return f"{low} … {'+' if highest_um > 0 else ''}{high} {unit}"


def _unit(largest_um: float) -> tuple[str, float]:
    return ("µm", 1.0) if abs(largest_um) >= 0.1 else ("nm", 1e3)


def seconds(value: float) -> str:
    """A duration: ``12 ms``, ``1.24 s``."""
    return f"{significant(value * 1e3, 2 if value < 0.1 else 3)} ms" if value < 1 else f"{significant(value)} s"


def subscripts(symbol: str) -> str:
    """A symbol as rich text: ``R_m`` with its index below, in the way theory writes it."""
    return re.sub(r"_(\w)", r"<sub>\1</sub>", escape(symbol))


def fixed(value: float, decimals: int) -> str:
    """A derived value with fixed decimals; never ``-0.000``."""
    text = f"{value:.{decimals}f}"
    return written(text.lstrip("-") if float(text) == 0 else text.replace("-", MINUS))


def settings_text(settings: Mapping[str, Any]) -> str:
    """What a construction took, in one line: ``positions 9, samples 12 × 14``."""
    return listed(f"{tr(key.replace('_', ' '))} {_setting(value)}" for key, value in settings.items())


def shortcoming(method: str, settings: Mapping[str, Any]) -> str:
    """What a method could not follow, as a short sentence; empty where it models the flank that is wanted."""
    if settings.get("modifications") == "left out":
        return tr("{method}: modifications left out", method=tr(METHOD_TITLES[method]))
    if settings.get("line") == "best fit":
        return tr("{method}: the nearest flank that a rigid line sweeps", method=tr(METHOD_TITLES[method]))
    return ""


def _setting(value: Any) -> str:
    if isinstance(value, bool):
        return tr("yes") if value else tr("no")
    if isinstance(value, float):
        return number(value, ".4g")
    if isinstance(value, list | tuple):
        return " × ".join(_setting(item) for item in value)
    if isinstance(value, Mapping):
        return f"({settings_text(value)})"
    return tr(value) if isinstance(value, str) else str(value)


def number_text(value: float | int) -> str:
    """A number as the user would type it: the shortest text that reads back as the same value."""
    return str(value) if isinstance(value, int) else typed(value, 12)


def typed(value: float, digits: int) -> str:
    """A number as the user would type it, with so many significant digits."""
    return written(f"{value:.{digits}g}")


def parse_number(text: str) -> int | float | str:
    """What was typed as a number, or the text itself when it is none.

    Decimal point and comma both count, also wide ones; a whole number comes back as int. Nothing is clamped or rounded.
    """
    plain = text.translate(WIDE).strip().replace(MINUS, "-")
    if not NUMBER.fullmatch(plain) or len(plain) > 40:
        return text
    value = float(plain.replace(",", "."))
    if not math.isfinite(value):
        return text
    return int(plain) if plain.lstrip("+-").isdigit() else value
