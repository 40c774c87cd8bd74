"""Pitch cones that meet every input exactly: spiral angle, mean point in the middle of the face, curvature."""

from __future__ import annotations

from collections.abc import Callable
from math import asin, copysign, cos, isnan, nan, pi, radians, sin

from gearstudio.theory.hypoid.inputs import HypoidInput
from gearstudio.theory.hypoid.method1 import bevel_pitch_angles, method_0
from gearstudio.theory.hypoid.pitch import PitchCones, Touching, assemble, trace_curvature

STEEPEST_WHEEL = radians(88.0)
MIDDLE = 0.5
_SCAN = 90
_INNER_SCAN = 12
_LOWEST_WHEEL = radians(1.0)
_TINY_OFFSET = 1e-6  # of the wheel's diameter: below it the closing curvature is 0/0 and its effect is as small


def exact_cones(given: HypoidInput) -> PitchCones | None:
    """Pitch cones in exact contact, or None where there are none.

    Notes
    -----
    For a wheel angle d2, the inner root of (c) gives zeta; the outer root makes the limit curvature that of the
    wheel's tooth trace. The mean point divides the wheel's face width in halves (c_be2 = 0.5).
    """
    if given.offset == 0:
        return method_0(given)
    if abs(given.offset) < _TINY_OFFSET * given.wheel_outer_pitch_diameter:
        return _at(given, bevel_pitch_angles(given)[1])

    def excess(wheel: float) -> float:
        cones = _at(given, wheel)
        if cones is None:
            return nan
        trace = trace_curvature(given, cones.wheel.mean_cone_distance, cones.wheel.spiral_angle)
        return (cones.limit_curvature - trace) * cones.wheel.mean_cone_distance

    step = (STEEPEST_WHEEL - _LOWEST_WHEEL) / _SCAN
    places = [_LOWEST_WHEEL + step * k for k in range(_SCAN + 1)]
    values = [excess(place) for place in places]
    roots = [_root(excess, places[k], places[k + 1]) for k in range(_SCAN) if values[k] * values[k + 1] <= 0]
    found = [cones for root in roots if (cones := _at(given, root)) is not None and abs(excess(root)) < 1e-6]
    expected = bevel_pitch_angles(given)[1]
    return min(found, key=lambda cones: abs(cones.wheel.angle - expected), default=None)


def _at(given: HypoidInput, wheel: float) -> PitchCones | None:
    """Cones in contact with a wheel of this pitch angle, the curvature left open."""
    radius = given.wheel_outer_pitch_diameter / 2 - MIDDLE * given.face_width * sin(wheel)
    if radius <= 0:
        return None
    sign = copysign(1.0, given.offset)
    farthest = asin(min(1.0, abs(given.offset) / radius))

    def gap(turn: float) -> float:
        touching = _touching(given, wheel, sign * turn)
        if touching is None:
            return nan
        grown = cos(touching.wheel_spiral) / cos(touching.pinion_spiral) / given.ratio
        reach = radius * (1 + grown * cos(wheel) / cos(touching.pinion_angle))
        return abs(given.offset) - sin(turn) * reach

    before = 0.0
    if isnan(gap(before)):
        return None
    for k in range(1, _INNER_SCAN + 1):
        turn = farthest * k / _INNER_SCAN
        value = gap(turn)
        if value <= 0:
            touching = _touching(given, wheel, sign * _root(gap, before, turn))
            return None if touching is None else assemble(given, touching, radius)
        if value != value:
            return None
        before = turn
    return None


def _touching(given: HypoidInput, wheel: float, axial: float) -> Touching | None:
    """Relations (a), (b) and (d); None where the cones cannot touch or a tooth would lean 90 degrees and more."""
    shaft, spiral = given.shaft_angle_deg * pi / 180, given.spiral_angle_deg * pi / 180
    sin_pinion = cos(axial) * sin(shaft) * cos(wheel) - cos(shaft) * sin(wheel)
    if not 0 < sin_pinion < 1:
        return None
    pinion = asin(sin_pinion)
    sin_plane = sin(shaft) * sin(axial) / cos(pinion)
    if abs(sin_plane) >= 1:
        return None
    plane = asin(sin_plane)
    first = spiral if given.spiral_angle_of == "pinion" else spiral + plane
    if max(abs(first), abs(first - plane)) >= pi / 2:
        return None
    return Touching(pinion, wheel, first, first - plane, axial, plane)


def _root(function: Callable[[float], float], low: float, high: float) -> float:
    from scipy.optimize import brentq

    return float(brentq(function, low, high, xtol=1e-15, rtol=1e-14))
