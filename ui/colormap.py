"""The diverging colour scale of deviations, and its round numbers; no widget.

Blue is metal missing, vermillion metal added, light grey exact. The two hues stay apart for every common
kind of colour blindness, and lightness falls evenly from the middle to both ends.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ui.formatting import MINUS, written

Bytes = NDArray[np.uint8]
Stop = tuple[float, float, float]

SIZE = 257
"""Entries of the table; odd, so that zero has its own."""
NANOMETRES_BELOW_UM = 0.5
LIMIT_MIN_UM, LIMIT_MAX_UM = 1e-6, 1e6

UNITS: dict[str, tuple[str, float]] = {"um": ("µm", 1.0), "nm": ("nm", 1000.0), "uin": ("µin", 1000.0 / 25.4)}
"""Units of a deviation and how many of them make a micrometre."""

_LIMITS = (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)
_STEPS = (1.0, 2.0, 5.0, 10.0)

# Lightness, chroma and hue (degrees) in OKLCH at magnitudes 0, 1/3, 2/3, 1 of either half.
_LOW = ((0.955, 0.004, 250.0), (0.80, 0.085, 248.0), (0.60, 0.145, 254.0), (0.38, 0.130, 262.0))
_GREEN = ((0.955, 0.004, 150.0), (0.82, 0.10, 145.0), (0.62, 0.13, 148.0), (0.40, 0.10, 152.0))
_PURPLE = ((0.955, 0.004, 310.0), (0.80, 0.085, 312.0), (0.59, 0.145, 308.0), (0.37, 0.150, 302.0))
_DUSK = ((0.28, 0.10, 290.0), (0.42, 0.10, 262.0), (0.58, 0.10, 205.0), (0.76, 0.14, 150.0), (0.93, 0.16, 104.0))
_GREYS = ((0.25, 0.0, 0.0), (0.96, 0.0, 0.0))
_HIGH = ((0.955, 0.004, 60.0), (0.82, 0.105, 64.0), (0.66, 0.170, 46.0), (0.42, 0.135, 34.0))


def _srgb(lightness: ArrayLike, chroma: ArrayLike, hue_deg: ArrayLike) -> NDArray[np.float64]:
    """OKLCH to sRGB in [0, 1], clipped to the gamut, shape (..., 3)."""
    lightness, chroma, hue = np.broadcast_arrays(lightness, chroma, np.radians(hue_deg))
    a, b = chroma * np.cos(hue), chroma * np.sin(hue)
    long = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3
    medium = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3
    short = (lightness - 0.0894841775 * a - 1.2914855480 * b) ** 3
    linear = np.stack(
        [
            4.0767416621 * long - 3.3077115913 * medium + 0.2309699292 * short,
            -1.2684380046 * long + 2.6097574011 * medium - 0.3413193965 * short,
            -0.0041960863 * long - 0.7034186147 * medium + 1.7076147010 * short,
        ],
        axis=-1,
    ).clip(0.0, 1.0)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


def _half(stops: tuple[Stop, ...], magnitude: NDArray[np.float64]) -> NDArray[np.float64]:
    places = np.linspace(0.0, 1.0, len(stops))
    return _srgb(*(np.interp(magnitude, places, column) for column in zip(*stops, strict=True)))


def table(name: str = "balance", steps: int = 0) -> Bytes:
    """A colour map from its lowest to its highest end, shape (SIZE, 3), uint8.

    Parameters
    ----------
    name : str
        Of `MAPS`.
    steps : int
        Number of colours; 0 for a smooth run.
    """
    made = MAPS[name]()
    if steps:
        shades = made[np.rint(np.linspace(0, SIZE - 1, steps)).astype(int)]
        made = shades[np.minimum(np.arange(SIZE) * steps // SIZE, steps - 1)]
    return made


def _diverging(low_stops: tuple[Stop, ...], high_stops: tuple[Stop, ...]) -> Bytes:
    magnitude = np.linspace(0.0, 1.0, SIZE // 2 + 1)
    low, high = _half(low_stops, magnitude), _half(high_stops, magnitude)
    return np.rint(255 * np.concatenate([low[:0:-1], high])).astype(np.uint8)


def _sequential(stops: tuple[Stop, ...]) -> Bytes:
    return np.rint(255 * _half(stops, np.linspace(0.0, 1.0, SIZE))).astype(np.uint8)


MAPS: dict[str, Callable[[], Bytes]] = {
    "balance": lambda: _diverging(_LOW, _HIGH),
    "purple_green": lambda: _diverging(_PURPLE, _GREEN),
    "dusk": lambda: _sequential(_DUSK),
    "grey": lambda: _sequential(_GREYS),
}
"""Colour maps by name; lightness runs evenly in each, so that all can be read without seeing hues."""


def suited(name: str, symmetric: bool) -> str:
    """The colour map chosen, or the one that suits the kind of scale."""
    return ("balance" if symmetric else "dusk") if name == "auto" else name


def nice_limit(value: float, least: float = LIMIT_MIN_UM) -> float:
    """The smallest round number not below a value, as the end of a scale; 1 where there is nothing to show."""
    if not math.isfinite(value) or value <= 0:
        return 1.0
    return _round_up(min(max(value, least), LIMIT_MAX_UM), _LIMITS)


def _round_up(value: float, choices: tuple[float, ...]) -> float:
    decade = 10.0 ** math.floor(math.log10(value))
    mantissa = next(choice for choice in choices if value <= choice * decade * (1 + 1e-9))
    return float(f"{mantissa * decade:.6g}")


def next_limit(value: float, direction: int) -> float:
    """The neighbouring round limit above (+1) or below (-1) a value."""
    if direction > 0:
        return min(nice_limit(value * 1.001), LIMIT_MAX_UM)
    return max(nice_limit(value * 0.66), LIMIT_MIN_UM)


def ticks(low: float, high: float, at_most: int) -> NDArray[np.float64]:
    """Round places from low to high in steps of 1, 2 or 5; zero is one of them if it lies between."""
    step = _round_up((high - low) / max(at_most - 1, 2), _STEPS)
    play = 1e-9 * max(abs(low), abs(high)) / step
    first, last = math.ceil(low / step - play), math.floor(high / step + play)
    return np.arange(first, last + 1) * step


def unit_of(limit_um: float, unit: str = "auto") -> tuple[str, float]:
    """Unit for a scale of the given limit and what to multiply micrometres with."""
    if unit == "auto":
        unit = "nm" if limit_um < NANOMETRES_BELOW_UM else "um"
    return UNITS[unit]


def tick_label(value: float, limit: float, signed: bool = True) -> str:
    """A tick's number with a true minus sign and no more digits than it needs; zero bare, others signed if wanted."""
    if abs(value) < 1e-9 * limit:
        return "0"
    text = written(f"{abs(value):.4g}" if abs(value) < 1e4 else f"{abs(value):.1e}")
    return (("+" if signed else "") if value > 0 else MINUS) + text


def deviation_text(value_um: float, signed: bool = True, unit: str = "auto") -> str:
    """A deviation with three digits and its unit: ``+1.24 µm``, ``−38.1 nm``."""
    size = abs(value_um)
    name, factor = unit_of(size, unit)
    number = size * factor
    digits = 0 if number >= 99.95 else 1 if number >= 9.995 else 2
    text = written(f"{number:.{digits}f} {name}" if number >= 0.005 or number == 0 else f"{number:.1e} {name}")
    if not signed or size == 0:
        return text
    return ("+" if value_um > 0 else MINUS) + text
