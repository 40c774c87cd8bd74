"""What can colour a CAD flank: its name, unit and kind of scale; no widget."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ui import colormap
from ui.formatting import number
from ui.units import per_length
from ui.views.appearance import Appearance

Floats = NDArray[np.float64]

CURVATURES = (
    ("gaussian", "Gaussian curvature", "1/mm²"),
    ("mean", "Mean curvature", "1/mm"),
    ("largest", "Principal 1 (largest)", "1/mm"),
    ("smallest", "Principal 2 (smallest)", "1/mm"),
)
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_TYPICAL = (1.0, 99.0)
"""Percentiles that the colours of a curvature reach from and to: beside the base cone it grows without bound."""


@dataclass(frozen=True)
class Quantity:
    """A quantity with its unit.

    Attributes
    ----------
    id, title, unit : str
    symmetric : bool
        Its scale runs from -limit to +limit.
    """

    id: str
    title: str
    unit: str
    symmetric: bool

    @property
    def is_deviation(self) -> bool:
        """Whether it is the deviation [µm], which has units to choose from."""
        return self.id == "deviation"

    def shown(self, limit: float, unit: str = "auto") -> tuple[str, float]:
        """Unit for a scale that reaches so far, and what to multiply its values with."""
        if self.is_deviation:
            return colormap.unit_of(limit, unit)
        name, factor = per_length(self.unit)
        if name == "%" or limit <= 0 or not math.isfinite(limit):
            return name, factor
        power = 3 * math.floor(math.log10(limit * factor) / 3 + 1e-9)
        if power == 0:
            return name, factor
        return f"10{str(power).translate(_SUPERSCRIPTS)}{name.removeprefix('1')}", factor * 10.0**-power

    def text(self, value: float, unit: str = "auto") -> str:
        """A value with its unit."""
        if self.is_deviation:
            return colormap.deviation_text(value, unit=unit)
        name, factor = self.shown(abs(value))
        return f"{number(value * factor, '.4g')}{_joined(name)}"

    def span_text(self, low: float, high: float) -> str:
        """From where to where values run."""
        name, factor = self.shown(max(abs(low), abs(high)))
        return f"{number(low * factor, '.4g')} … {number(high * factor, '.4g')}{_joined(name)}"


def _joined(unit: str) -> str:
    return f"·{unit}" if unit.startswith("10") else f" {unit}"


DEVIATION = Quantity("deviation", "Deviation", "µm", True)


def quantity_of(appearance: Appearance) -> Quantity:
    """What the flanks are coloured by."""
    for name, title, unit in CURVATURES:
        if name == appearance.quantity:
            if appearance.against == "relative":
                return Quantity(f"{name}/relative", title, "%", True)
            if appearance.against:
                return Quantity(f"{name}/absolute", title, unit, True)
            return Quantity(name, title, unit, False)
    return DEVIATION


def typical_range(quantity: Quantity, values: list[Floats]) -> tuple[tuple[float, float], tuple[float, float]] | None:
    """From where to where the colours of these values should run, and their least and greatest.

    None when there is nothing to show.
    """
    everything = np.concatenate([value.ravel() for value in values]) if values else np.empty(0)
    everything = everything[np.isfinite(everything)]
    if not len(everything):
        return None
    extent = float(everything.min()), float(everything.max())
    low, high = (float(x) for x in np.percentile(everything, _TYPICAL))
    if quantity.symmetric:
        limit = colormap.nice_limit(max(abs(low), abs(high)), least=1e-12)
        return (-limit, limit), extent
    return nice_range(low, high), extent


def nice_range(low: float, high: float) -> tuple[float, float]:
    """Round numbers just beyond two values; zero stays an end if it is one."""
    span = high - low
    if span <= 1e-9 * max(abs(low), abs(high)):
        span = max(abs(low), abs(high), 1e-12) * 0.1
        low, high = low - span / 2, high + span / 2
    step = 10.0 ** math.floor(math.log10(span / 5))
    return math.floor(low / step + 1e-9) * step, math.ceil(high / step - 1e-9) * step
