"""Methods 0 and 1 of ISO 23509 as written, for comparison with the exact cones of `exact`."""

from __future__ import annotations

from math import asin, atan, cos, pi, sin, tan

from gearstudio.theory.cones import pitch_angles
from gearstudio.theory.hypoid.inputs import HypoidError, HypoidInput
from gearstudio.theory.hypoid.pitch import PitchCones, Touching, assemble

_SCAN = 60


def bevel_pitch_angles(given: HypoidInput) -> tuple[float, float]:
    """Pitch cone angles of the same teeth without offset [rad]."""
    return pitch_angles(given.pinion_teeth, given.wheel_teeth, given.shaft_angle_deg * pi / 180)


def method_0(given: HypoidInput) -> PitchCones:
    """Cones of a bevel pair: a = 0, one apex, one spiral angle, the mean point in the middle of the face."""
    pinion, wheel = bevel_pitch_angles(given)
    spiral = given.spiral_angle_deg * pi / 180
    radius = given.wheel_outer_pitch_diameter / 2 - given.face_width / 2 * sin(wheel)
    return assemble(given, Touching(pinion, wheel, spiral, spiral, 0.0, 0.0), radius)


def method_1(given: HypoidInput, tolerance: float = 1e-12) -> PitchCones:
    """Cones by the recursion of Method 1, on the angle eta until the limit radius is the cutter's.

    Parameters
    ----------
    given : HypoidInput
        With the pinion's spiral angle; it is met within some hundredths of a degree only, as is the middle of the face.
    tolerance : float
        Of |r_c0 / rho_lim - 1| below which the angle is taken; the standard accepts 0.01. Above it, the root is found.

    Raises
    ------
    HypoidError
        The recursion finds no cones.
    """
    wheel_start = _start_angle(given)
    radius = (given.wheel_outer_pitch_diameter - given.face_width * sin(wheel_start)) / 2
    start = _start_eta(given, wheel_start, radius)

    def cones(eta: float) -> PitchCones:
        return assemble(given, _step(given, radius, eta, wheel_start), radius)

    def excess(eta: float) -> float:
        try:
            return given.cutter_radius * cones(eta).limit_curvature - 1
        except (ValueError, ZeroDivisionError):
            return float("nan")

    if abs(excess(start)) <= tolerance:
        return cones(start)
    places = [start * (0.2 + 1.8 * k / _SCAN) for k in range(_SCAN + 1)]
    values = [excess(eta) for eta in places]
    crossings = [k for k in range(_SCAN) if values[k] * values[k + 1] <= 0]
    if not crossings:
        raise HypoidError("pair.offset", "the recursion of ISO 23509 Method 1 finds no pitch cones for this pair")
    from scipy.optimize import brentq

    nearest = min(crossings, key=lambda k: abs(places[k] - start))
    eta = brentq(excess, places[nearest], places[nearest + 1], xtol=1e-15, rtol=1e-14)
    return cones(float(eta))


def _start_angle(given: HypoidInput) -> float:
    tilt = given.shaft_angle_deg * pi / 180 - pi / 2
    return atan(given.ratio * cos(tilt) / (1.2 * (1 - given.ratio * sin(tilt))))


def _wanted(given: HypoidInput, wheel_start: float, radius: float) -> tuple[float, float, float]:
    """Wanted pinion spiral angle beta_D1, K_1 and the approximate pinion radius r_mn1."""
    spiral = given.spiral_angle_deg * pi / 180
    sine = given.offset * sin(wheel_start) / radius
    widening = tan(spiral) * sine + cos(asin(sine))
    return spiral, widening, radius * widening / given.ratio


def _start_eta(given: HypoidInput, wheel_start: float, radius: float) -> float:
    tilt = given.shaft_angle_deg * pi / 180 - pi / 2
    _, _, pinion_radius = _wanted(given, wheel_start, radius)
    return atan(given.offset / (radius * (tan(wheel_start) * cos(tilt) - sin(tilt)) + pinion_radius))


def _step(given: HypoidInput, radius: float, eta: float, wheel_start: float) -> Touching:
    """One pass of the recursion at a trial eta: every iterate touches exactly, relations (a) to (e)."""
    tilt = given.shaft_angle_deg * pi / 180 - pi / 2
    spiral, widening, pinion_radius = _wanted(given, wheel_start, radius)
    second = asin((given.offset - pinion_radius * sin(eta)) / radius)
    angle = atan(sin(eta) / (tan(second) * cos(tilt)) + tan(tilt) * cos(eta))
    in_plane = asin(sin(second) * cos(tilt) / cos(angle))
    trial = atan((widening - cos(in_plane)) / sin(in_plane))
    more = sin(in_plane) * (tan(spiral) - tan(trial))
    grown = radius * more / given.ratio
    first = asin(sin(second) - grown / radius * sin(eta))
    pinion = atan(sin(eta) / (tan(first) * cos(tilt)) + tan(tilt) * cos(eta))
    plane = asin(sin(first) * cos(tilt) / cos(pinion))
    pinion_spiral = atan((widening + more - cos(plane)) / sin(plane))
    wheel = atan(sin(first) / (tan(eta) * cos(tilt)) + cos(first) * tan(tilt))
    return Touching(pinion, wheel, pinion_spiral, pinion_spiral - plane, first, plane)
