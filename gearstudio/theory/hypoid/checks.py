"""Pitch cones, or the reason why there are none and the nearest value that works."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from math import asin, degrees, floor, log10, pi, sin

from gearstudio.theory.hypoid.exact import STEEPEST_WHEEL, exact_cones
from gearstudio.theory.hypoid.inputs import DepthInput, HypoidError, HypoidInput
from gearstudio.theory.hypoid.method1 import bevel_pitch_angles
from gearstudio.theory.hypoid.pitch import PitchCones

_BISECTIONS = 24
_STEPS = 8


def pitch_cones(given: HypoidInput) -> PitchCones:
    """Exact pitch cones of a pair; remembered, for pairs that differ in the profile of their teeth share them.

    Raises
    ------
    HypoidError
        There are none, the wheel's cone is too flat, or a tooth would lean against its hand.
    """
    return _of_size(
        replace(
            given, pressure_angle_deg=20.0, limit_pressure_angle_factor=1.0, backlash=0.0, fillet_factor=0.0,
            ends="sphere", depth=DepthInput(),
        )
    )  # fmt: skip


@lru_cache(maxsize=64)
def _of_size(given: HypoidInput) -> PitchCones:
    _refuse_flat_wheel(given)
    _refuse_wide_face(given)
    cones = exact_cones(given)
    if cones is None:
        raise HypoidError("pair.offset", _no_cones(given))
    if min(cones.pinion.spiral_angle, cones.wheel.spiral_angle) < -1e-12:
        raise HypoidError("lengthwise.spiral_angle_deg", _against_hand(given, cones))
    return cones


def _refuse_flat_wheel(given: HypoidInput) -> None:
    pinion, wheel = bevel_pitch_angles(given)
    if not 0 < pinion < pi / 2 or wheel >= STEEPEST_WHEEL:
        # d2 = S - d1 reaches the limit where sin(S - d2) = sin(d2) / u
        limit = degrees(STEEPEST_WHEEL + asin(min(1.0, sin(STEEPEST_WHEEL) / given.ratio)))
        raise HypoidError(
            "pair.shaft_angle_deg",
            f"a shaft angle of {given.shaft_angle_deg:.6g}° makes the wheel's pitch cone "
            f"{degrees(wheel):.4g}°; it must stay below {degrees(STEEPEST_WHEEL):.4g}°: "
            f"use at most {_down(limit):.6g}°",
        )


def _refuse_wide_face(given: HypoidInput) -> None:
    diameter = given.wheel_outer_pitch_diameter
    if given.face_width >= 0.5 * diameter:
        raise HypoidError(
            "pair.face_width",
            f"a face width of {given.face_width:.6g} mm does not fit a wheel of {diameter:.6g} mm; "
            f"use less than {0.5 * diameter:.6g} mm",
        )


def _no_cones(given: HypoidInput) -> str:
    found = nearest(given.offset, 0.0, lambda offset: _usable(replace(given, offset=offset)))
    text = f"an offset of {given.offset:.6g} mm admits no pitch cones for these teeth, spiral angle and cutter"
    if found is None or found == 0:
        return text + "; use an offset of 0 mm"
    return text + f"; use {found:.4g} mm or nearer to 0"


def _against_hand(given: HypoidInput, cones: PitchCones) -> str:
    other = "wheel" if given.spiral_angle_of == "pinion" else "pinion"
    lean = cones.wheel.spiral_angle if other == "wheel" else cones.pinion.spiral_angle
    start = given.spiral_angle_deg
    found = nearest(start, 60.0, lambda angle: _usable(replace(given, spiral_angle_deg=angle)))
    remedy = "use a smaller offset" if found is None else f"use a spiral angle of at least {found:.4g}°"
    return (
        f"a spiral angle of {start:.4g}° on the {given.spiral_angle_of} with an offset of {given.offset:.6g} mm turns "
        f"the {other}'s teeth against their hand, to {degrees(lean):.4g}°; {remedy} or an offset of the other sign"
    )


def _usable(given: HypoidInput) -> bool:
    cones = exact_cones(given)
    return cones is not None and min(cones.pinion.spiral_angle, cones.wheel.spiral_angle) >= 0


def nearest(bad: float, good: float, works: Callable[[float], bool]) -> float | None:
    """The value nearest to ``bad`` on the way to ``good`` that works, to four digits; None where none is found."""
    step = (good - bad) / _STEPS
    first = next((k for k in range(1, _STEPS + 1) if works(bad + k * step)), None)
    if first is None:
        return None
    low, high = bad + (first - 1) * step, bad + first * step
    for _ in range(_BISECTIONS):
        middle = (low + high) / 2
        low, high = (low, middle) if works(middle) else (middle, high)
    return _rounded(high, good)


def _rounded(value: float, towards: float) -> float:
    """The value to four digits, rounded towards another."""
    if value == 0:
        return 0.0
    unit = 10.0 ** (floor(log10(abs(value))) - 3)
    steps = value / unit
    down = floor(steps + 1e-9)
    up = -floor(-steps + 1e-9)
    return (up if towards > value else down) * unit


def _down(value: float) -> float:
    return floor(value * 100) / 100
