"""Rules of the pair: cones, face width, lengthwise curve."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gearstudio.design import Design
from gearstudio.theory.cones import face_width, outer_cone_distance, pitch_angles
from gearstudio.validation.nearest import cure, round_toward
from gearstudio.validation.rule import ARC, DEPTH, PRESSURE, PROFILE, RATIO, SPIRAL, WIDTH, Finding, Rule, members

LEAST_WIDTH_FACTOR = 0.001
MOST_WIDTH_FACTOR = 0.5
MOST_MEAN_SPIRAL_DEG = 70.0
MOST_ARC_SPIRAL_DEG = 80.0


def _pitch_cones(design: Design) -> Iterator[Finding]:
    pair = design.pair
    angles = np.degrees(pitch_angles(pair.pinion_teeth, pair.wheel_teeth, np.radians(pair.shaft_angle_deg)))
    for name, angle in zip(("pinion", "wheel"), angles, strict=True):
        if angle >= 90 - 1e-9:
            fewer, more = sorted((pair.pinion_teeth, pair.wheel_teeth))
            most = round_toward(float(np.degrees(np.arccos(-fewer / more))) - 1e-6, up=False)
            yield Finding(
                "pair.shaft_angle_deg",
                f"{pair.shaft_angle_deg:.10g}° gives the {name} a pitch cone of {angle:.4g}°, and it must stay below "
                f"90°; use at most {most:.10g}°, or numbers of teeth nearer to each other",
            )


def _larger_pinion(design: Design) -> Iterator[Finding]:
    pair = design.pair
    if pair.pinion_teeth > pair.wheel_teeth:
        yield Finding(
            "pair.pinion_teeth",
            f"{pair.pinion_teeth} is more than the wheel's {pair.wheel_teeth} teeth; "
            "the pinion is the member with fewer: exchange them",
        )


def _face_width(design: Design) -> Iterator[Finding]:
    pair, outer = design.pair, outer_cone_distance(design)
    width = face_width(design)
    least, most = LEAST_WIDTH_FACTOR * outer, MOST_WIDTH_FACTOR * outer
    if least * (1 - 1e-12) <= width <= most * (1 + 1e-12):
        return
    if pair.face_width is None:
        yield Finding(
            "pair.face_width_factor",
            f"{pair.face_width_factor:.4g} is too narrow to make a tooth; use at least {LEAST_WIDTH_FACTOR}",
        )
    elif width > most:
        yield Finding(
            "pair.face_width",
            f"{width:.10g} mm is more than half the outer cone distance of {outer:.6g} mm; "
            f"use at most {round_toward(most, up=False):.10g} mm",
        )
    else:
        yield Finding(
            "pair.face_width",
            f"{width:.4g} mm is too narrow to make a tooth at an outer cone distance of {outer:.6g} mm; "
            f"use at least {round_toward(least, up=True):.10g} mm",
        )


def _toe_curve(design: Design) -> Iterator[Finding]:
    lengthwise = design.lengthwise
    if lengthwise.spiral_angle_at == "toe" and lengthwise.curve != "archimedean":
        yield Finding(
            "lengthwise.spiral_angle_at",
            f'"toe" is defined for the Archimedean curve only, and the curve is "{lengthwise.curve}"; '
            'use "mean", or the curve "archimedean"',
        )


def _mean_spiral_deg(design: Design) -> float:
    """Mean spiral angle that follows from a toe angle; 90 where there is none."""
    pair, outer, width = design.pair, outer_cone_distance(design), face_width(design)
    reach = np.tan(np.radians(design.lengthwise.spiral_angle_deg)) * (outer - width / 2) / (outer - width)
    if pair.pressure_angle_kind == "normal" and reach * np.tan(np.radians(pair.pressure_angle_deg)) >= 1:
        return 90.0
    return float(np.degrees(members(design)[0].lengthwise.mean_spiral_angle))


def _toe_angle(design: Design) -> Iterator[Finding]:
    if design.lengthwise.spiral_angle_at != "toe" or _mean_spiral_deg(design) <= MOST_MEAN_SPIRAL_DEG:
        return
    found = cure(design, lambda d: _mean_spiral_deg(d) <= MOST_MEAN_SPIRAL_DEG, [("lengthwise.spiral_angle_deg", 0.0)])
    yield Finding(
        "lengthwise.spiral_angle_deg",
        f"{design.lengthwise.spiral_angle_deg:.10g}° at the toe makes the mean spiral angle more than "
        f"{MOST_MEAN_SPIRAL_DEG:g}°; use {found.text or 'a narrower face width'}",
    )


def cutter_radius_range(
    mean: float, mean_spiral: float, inner: float, outer: float, steepest: float
) -> tuple[float, float]:
    """Cutter radii [mm] whose arc keeps its spiral angle below a limit from one cone distance to another.

    From sin(beta) = (rho^2 + 2 r_0 R_m sin(beta_m) - R_m^2) / (2 r_0 rho) of theory 4, whose extremes are at
    the ends; inner <= mean <= outer [mm], angles in rad. An empty range has its ends reversed.
    """
    sine, limit = mean * np.sin(mean_spiral), np.sin(steepest)
    inside, outside = (mean**2 - inner**2) / 2, (outer**2 - mean**2) / 2
    heel = outer * limit - sine
    least = max(outside / heel if heel > 0 else np.inf, inside / (inner * limit + sine))
    toe = sine - inner * limit
    return float(least), float(inside / toe) if toe > 0 else np.inf


def _arc_findings(design: Design, inner: float, outer: float, where: str) -> Iterator[Finding]:
    lengthwise = design.lengthwise
    mean = outer_cone_distance(design) - face_width(design) / 2
    least, most = cutter_radius_range(
        mean, np.radians(lengthwise.spiral_angle_deg), inner, outer, np.radians(MOST_ARC_SPIRAL_DEG)
    )
    if least <= lengthwise.cutter_radius <= most:
        return
    least, most = round_toward(least, up=True) if np.isfinite(least) else least, _down(most)
    if least > most:
        remedy = "no radius does: use a narrower face width or a smaller spiral angle"
    elif lengthwise.cutter_radius < least:
        remedy = f"use at least {least:.10g} mm"
    else:
        remedy = f"use at most {most:.10g} mm"
    yield Finding(
        "lengthwise.cutter_radius",
        f"the arc of {lengthwise.cutter_radius:.10g} mm does not cross {where} from {inner:.6g} to {outer:.6g} mm "
        f"at less than {MOST_ARC_SPIRAL_DEG:g}°; {remedy}",
    )


def _down(value: float) -> float:
    return round_toward(value, up=False) if np.isfinite(value) else value


def _cutter_arc(design: Design) -> Iterator[Finding]:
    if design.lengthwise.curve == "circular_arc":
        outer = outer_cone_distance(design)
        yield from _arc_findings(design, outer - face_width(design), outer, "the whole face width")


def _cutter_arc_corners(design: Design) -> Iterator[Finding]:
    if design.lengthwise.curve == "circular_arc" and design.tooth.ends == "back_cone":
        outer = outer_cone_distance(design)
        height = max(max(abs(m.addendum), abs(m.dedendum)) for m in members(design))
        reach = float(np.hypot(outer, height))
        yield from _arc_findings(design, outer - face_width(design), reach, "the teeth up to their heel corners")


PAIR_RULES = (
    Rule("pitch_cone", "error", RATIO, frozenset(), "pair.shaft_angle_deg", _pitch_cones),
    Rule("larger_pinion", "warning", RATIO, frozenset(), "pair.pinion_teeth", _larger_pinion),
    Rule("face_width", "error", WIDTH, frozenset({"pitch_cone"}), "pair.face_width", _face_width),
    Rule("toe_curve", "error", SPIRAL, frozenset(), "lengthwise.spiral_angle_at", _toe_curve),
    Rule(
        "toe_angle", "error", PRESSURE, frozenset({"face_width", "toe_curve"}),
        "lengthwise.spiral_angle_deg", _toe_angle,
    ),
    Rule("cutter_arc", "error", ARC, frozenset({"face_width", "toe_curve"}), "lengthwise.cutter_radius", _cutter_arc),
    Rule(
        "cutter_arc_corner", "error", ARC | PROFILE | DEPTH, frozenset({"cutter_arc", "toe_angle"}),
        "lengthwise.cutter_radius", _cutter_arc_corners,
    ),
)  # fmt: skip
