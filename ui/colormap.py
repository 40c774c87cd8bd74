"""The diverging colour scale of deviations, and its round numbers; no widget.

Blue is metal missing, vermillion metal added, light grey exact. The two hues stay apart for every common
kind of colour blindness, and lightness falls evenly from the middle to both ends.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

Bytes = NDArray[np.uint8]

SIZE = 257
"""Entries of the table; odd, so that zero has its own."""
NANOMETRES_BELOW_UM = 0.5
LIMIT_MIN_UM, LIMIT_MAX_UM = 1e-6, 1e6

_LIMITS = (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)
_STEPS = (1.0, 2.0, 5.0, 10.0)

# Lightness, chroma and hue (degrees) in OKLCH at magnitudes 0, 1/3, 2/3, 1 of either half.
_LOW = ((0.955, 0.004, 250.0), (0.80, 0.085, 248.0), (0.60, 0.145, 254.0), (0.38, 0.130, 262.0))
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


def _half(stops: tuple[tuple[float, float, float], ...], magnitude: NDArray[np.float64]) -> NDArray[np.float64]:
    places = np.linspace(0.0, 1.0, len(stops))
    return _srgb(*(np.interp(magnitude, places, column) for column in zip(*stops, strict=True)))


def table() -> Bytes:
    """The colours from the lowest to the highest deviation, shape (SIZE, 3), uint8."""
    magnitude = np.linspace(0.0, 1.0, SIZE // 2 + 1)
    low, high = _half(_LOW, magnitude), _half(_HIGH, magnitude)
    return np.rint(255 * np.concatenate([low[:0:-1], high])).astype(np.uint8)


def nice_limit(value: float) -> float:
    """The smallest round number not below a value, as the end of a scale; 1 where there is nothing to show."""
    if not math.isfinite(value) or value <= 0:
        return 1.0
    return _round_up(min(max(value, LIMIT_MIN_UM), LIMIT_MAX_UM), _LIMITS)


def _round_up(value: float, choices: tuple[float, ...]) -> float:
    decade = 10.0 ** math.floor(math.log10(value))
    mantissa = next(choice for choice in choices if value <= choice * decade * (1 + 1e-9))
    return float(f"{mantissa * decade:.6g}")


def next_limit(value: float, direction: int) -> float:
    """The neighbouring round limit above (+1) or below (-1) a value."""
    if direction > 0:
        return min(nice_limit(value * 1.001), LIMIT_MAX_UM)
    return max(nice_limit(value * 0.66), LIMIT_MIN_UM)


def ticks(limit: float, at_most: int) -> NDArray[np.float64]:
    """Round places from -limit to limit, zero among them, in steps of 1, 2 or 5."""
    step = _round_up(2 * limit / max(at_most - 1, 2), _STEPS)
    count = math.floor(limit / step * (1 + 1e-9))
    return np.arange(-count, count + 1) * step


def unit_of(limit_um: float) -> tuple[str, float]:
    """Unit for a scale of the given limit and what to multiply micrometres with."""
    return ("nm", 1000.0) if limit_um < NANOMETRES_BELOW_UM else ("µm", 1.0)


def tick_label(value: float, limit: float) -> str:
    """A tick's number with a true minus sign and no more digits than it needs; zero bare, others signed."""
    if abs(value) < 1e-9 * limit:
        return "0"
    text = f"{abs(value):.4g}" if abs(value) < 1e4 else f"{abs(value):.1e}"
    return ("+" if value > 0 else "\N{MINUS SIGN}") + text


def deviation_text(value_um: float, signed: bool = True) -> str:
    """A deviation with three digits and its unit: ``+1.24 µm``, ``−38.1 nm``."""
    size = abs(value_um)
    unit, factor = unit_of(size)
    number = size * factor
    digits = 0 if number >= 99.95 else 1 if number >= 9.995 else 2
    text = f"{number:.{digits}f} {unit}" if number >= 0.005 or number == 0 else f"{number:.1e} {unit}"
    if not signed or size == 0:
        return text
    return ("+" if value_um > 0 else "\N{MINUS SIGN}") + text
