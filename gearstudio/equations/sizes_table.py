"""Equations of the sizes on a drawing: depths, diameters, thicknesses, and the margins that are left."""

from __future__ import annotations

from gearstudio.equations import sizes_numbers as numbers
from gearstudio.equations.records import Equation

_SIZES = "Sizes of the teeth"

SIZES: tuple[Equation, ...] = (
    Equation(
        "mean_module", _SIZES, "Mean normal module", "", "6", r"m_n = m R_m / R cos beta_m",
        "Of the section square to the tooth at the mean point.",
        numbers=numbers.mean_module,
    ),
    Equation(
        "own_depth", _SIZES, "Depths from the module", "", "2",
        r"h_(a e) = m (h_a^* + x), quad h_(f e) = m (h_a^* + c^* - x), quad x_2 = -x_1",
        "At the heel, square to the pitch cone; the profile shift x is the pinion's, the wheel has its negative.",
        numbers=numbers.own_depth, holds="own depth",
    ),
    Equation(
        "heights", _SIZES, "Depths along the tooth", "", "2",
        r"h_a (R') = h_(a e) - (R - R') tan theta_a, quad h_f (R') = R' tan theta_f",
        "At a cone distance R'; θ_a and θ_f lie between pitch cone and face cone, and pitch cone and root cone.",
        numbers=numbers.heights, holds="own depth",
    ),
    Equation(
        "tip_parallel", _SIZES, "Face cone at constant clearance", "", "2",
        r"delta_a = delta + (delta' - delta'_f)",
        "The tips run parallel to the mate's root cone, through the tip's corner at the heel; the face cone has an "
        "apex of its own.",
        numbers=numbers.tip_parallel, holds="own depth",
    ),
    Equation(
        "diameters", _SIZES, "Diameters", "", "2",
        r"d = 2 R sin delta, quad d_a = d + 2 h_a cos delta, quad d_f = d - 2 h_f cos delta",
        "Of pitch, tip and root circle, with cone distance and depths of the place; the numbers are those of the heel.",
        numbers=numbers.diameters, holds="always",
    ),
    Equation(
        "crown", _SIZES, "Crown to crossing point", "", "ISO 23509",
        r"t_(x o) = R cos delta - t_z - h_(a e) sin delta",
        "Along the axis, from the largest corner of the tip. t_z is how far the pitch apex lies beyond the crossing "
        "point; 0 without an offset.",
        numbers=numbers.crown, holds="always",
    ),
    Equation(
        "ends", _SIZES, "Back cones", "", "6", r"rho = rho_u / cos(delta_k - delta)",
        "The teeth end square to the pitch cone: ρ_u is the cone distance there, and points above and below are "
        "farther from the apex.",
        numbers=numbers.ends, holds="always",
    ),
    Equation(
        "thickness", _SIZES, "Thickness and chord", "", "5",
        r'd_e = 2 R sin delta, quad s_(e t) = d_e dot "half", quad s_(m n) = d_m dot "half" cos beta_m, quad '
        r"s_(m n c) = d_v sin s_(m n) / d_v, quad d_v = d_m / (cos delta cos^2 beta_m)",
        "Along the pitch circle at the heel; in the normal section at the mean point; the chord of that, which a gear "
        "tooth caliper measures.",
        numbers=numbers.thickness,
    ),
    Equation(
        "tip_land", _SIZES, "Tip land", "", "8",
        r's_a = 2 rho sin delta_a ["half" + beta(delta) - beta(delta_a)]',
        "Thickness of the tip; where it is not positive the tooth is pointed.",
        numbers=numbers.tip_land,
    ),
    Equation(
        "undercut", _SIZES, "Undercut margin", "", "8",
        r"gamma + gamma' - psi'_a > 0, quad psi'_a = arccos (cos delta'_a) / (cos delta'_b)",
        "The mate's tip must not roll beyond the start of the flank on the base cone.",
        numbers=numbers.undercut,
    ),
)  # fmt: skip
