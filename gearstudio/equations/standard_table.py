"""Equations of depths after ISO 23509, and of pairs with offset axes."""

from __future__ import annotations

from gearstudio.equations import standard_numbers as numbers
from gearstudio.equations.records import Equation

_ISO, _DEPTH, _OFFSET = "ISO 23509", "Depth after ISO 23509", "Offset axes"

STANDARD: tuple[Equation, ...] = (
    Equation(
        "working_depth", _DEPTH, "Working depth and clearance", "", _ISO,
        r"h_(m w) = k_d m_(m n), quad c = k_c h_(m w)",
        "At the mean point. With the outer module as depth system of a pair with an offset the factors are those that "
        "give the depths of the module at the wheel's heel.",
        numbers=numbers.working_depth, holds="standard depth",
    ),
    Equation(
        "mean_depths", _DEPTH, "Mean addendum and dedendum", "", _ISO,
        r"h_(a m 2) = c_(h a m) h_(m w), quad h_(a m 1) = h_(m w) - h_(a m 2), quad h_(f m) = h'_(a m) + c, quad "
        r"x_(h m 1) = k_d (1 \/ 2 - c_(h a m))",
        "Shared between both members; without a factor of its own c_ham is 0.21 + 0.29/u₉₀², the standard's proposal.",
        numbers=numbers.mean_depths, holds="standard depth",
    ),
    Equation(
        "taper", _DEPTH, "Taper of the wheel", "", _ISO,
        r"theta_(a 2) = arctan h_(f m 1) / R_(m 2), quad theta_(f 2) = arctan h_(f m 2) / R_(m 2), quad "
        r"delta_(a 2) = delta_2 + theta_(a 2), quad delta_(f 2) = delta_2 - theta_(f 2)",
        "The standard taper: root lines through the pitch apex. With uniform depth both angles are 0; duplex and "
        "tilted root divide another sum of the dedendum angles as the depth is divided; an angle that is given wins.",
        numbers=numbers.taper, holds="standard depth",
    ),
    Equation(
        "duplex", _DEPTH, "Constant slot width", "", _ISO,
        r"Sigma theta_f = pi / 2 (2 sin delta_2) / z_2 (1 - R_(m 2) kappa sin beta_(m 2)) / "
        r"(tan alpha_d cos beta_(m 2)), quad kappa = 1 / r_0",
        "The sum of the dedendum angles for which both slots keep their width along the face; κ is the tooth trace's "
        "curvature. A tilted root line takes at most 1.3 times the standard sum.",
        numbers=numbers.duplex, holds="standard depth",
    ),
    Equation(
        "touching_cones", _DEPTH, "Face and root cone of the pinion", "", _ISO,
        r"sin delta_(a 1) = sin Sigma cos delta_(f 2) cos zeta_R - cos Sigma sin delta_(f 2), quad "
        r"sin delta_(f 1) = sin Sigma cos delta_(a 2) cos zeta_o - cos Sigma sin delta_(a 2)",
        "The face cone touches a plane on the wheel's root cone, the root cone one on its face cone, both the "
        "clearance away.",
        numbers=numbers.touching_cones, holds="standard depth",
    ),
    Equation(
        "normal_thickness", _DEPTH, "Mean normal thickness", "", _ISO,
        r"s_(m n) = m_(m n) (pi / 2 + 2 (x_(s m) + x_(h m) tan alpha_d)), quad x_(s m 1) = k_t / 2",
        "The thickness factor makes the pinion's teeth thicker and the wheel's thinner; x_sm has the backlash's share.",
        numbers=numbers.normal_thickness, holds="standard depth",
    ),
    Equation(
        "pitch_cones", _OFFSET, "Pitch cones in contact", "", _ISO,
        r"sin delta_1 = cos zeta_m sin Sigma cos delta_2 - cos Sigma sin delta_2, quad "
        r"sin zeta_(m p) = (sin Sigma sin zeta_m) / (cos delta_1)",
        "Both cones touch at the mean point; ζ_m is the offset angle about the wheel's axis, ζ_mp that in the pitch "
        "plane. One number is left free, which the limit radius closes.",
        numbers=numbers.pitch_cones, holds="standard depth",
    ),
    Equation(
        "offset_arms", _OFFSET, "The offset", "", _ISO,
        r"a = r_2 sin zeta_m + r_1 sin eta, quad a_p = R_(m 2) sin zeta_(m p)",
        "The shortest distance between the axes, from the mean point's radii; a_p is the part in the pitch plane.",
        numbers=numbers.offset_arms, holds="standard depth",
    ),
    Equation(
        "spiral_angles", _OFFSET, "Spiral angles of both members", "", _ISO,
        r"beta_(m 1) = beta_(m 2) + zeta_(m p)",
        "The teeth run along each other at the mean point, the cones' elements do not.",
        numbers=numbers.spiral_angles, holds="standard depth",
    ),
    Equation(
        "mean_radii", _OFFSET, "Mean radii", "", _ISO,
        r"r_1 = r_2 / u (cos beta_(m 2)) / (cos beta_(m 1)), quad R_m = r / (sin delta), quad "
        r"m_(m n) = (2 r_2 cos beta_(m 2)) / z_2",
        "Both members have the same normal module, but not the same transverse one.",
        numbers=numbers.mean_radii, holds="standard depth",
    ),
    Equation(
        "limit_angle", _OFFSET, "Limit pressure angle", "", _ISO,
        r"tan alpha_lim = -(tan delta_1 tan delta_2) / (cos zeta_(m p)) dot "
        r"(R_(m 1) sin beta_(m 1) - R_(m 2) sin beta_(m 2)) / (R_(m 1) tan delta_1 + R_(m 2) tan delta_2)",
        "The inclination of the flank that would slide along the tooth alone: drive and coast flank lie equally far "
        "from it.",
        numbers=numbers.limit_angle, holds="standard depth",
    ),
    Equation(
        "limit_radius", _OFFSET, "Limit radius", "", _ISO,
        r"rho_lim = (tan beta_(m 1) - tan beta_(m 2)) / (cos alpha_lim (1 / (R_(m 1) cos beta_(m 1)) - "
        r"1 / (R_(m 2) cos beta_(m 2)) - tan alpha_lim ((tan beta_(m 1)) / (R_(m 1) tan delta_1) + "
        r"(tan beta_(m 2)) / (R_(m 2) tan delta_2))))",
        "The pitch angles are those for which it is the radius of the wheel's tooth trace: r₀ for a cutter's arc.",
        numbers=numbers.limit_radius, holds="offset",
    ),
    Equation(
        "flank_angles", _OFFSET, "Pressure angles and base cones of both flanks", "", _ISO,
        r"alpha_(n D) = alpha_d + f alpha_lim, quad alpha_(n C) = alpha_d - f alpha_lim, quad "
        r"tan alpha_t = (tan alpha_n) / (cos beta_m), quad sin delta_b = sin delta cos alpha_t",
        "D is the drive flank, concave on the pinion and convex on the wheel; C is the coast flank. Each flank of the "
        "wheel is a spherical involute on a base cone of its own.",
        numbers=numbers.flank_angles, holds="standard depth",
    ),
    Equation(
        "apexes", _OFFSET, "Pitch apex", "", _ISO, r"t_z = R_m cos delta - t_(z m)",
        "How far it lies beyond the crossing point; t_zm is the mean point's distance along the axis.",
        numbers=numbers.apexes, holds="standard depth",
    ),
    Equation(
        "envelope", _OFFSET, "The pinion's conjugate flank", "", "offset axes",
        r"bold(N) dot (bold(v)_1 - bold(v)_2) = A cos Phi + B sin Phi + C = 0, quad "
        r'Phi = "atan2"(B, A) plus.minus arccos (-C) / sqrt(A^2 + B^2)',
        "A point of the wheel's flank touches the pinion where its normal stands square to the relative velocity. That "
        "is linear in the cosine and the sine of its azimuth Φ: the envelope has a closed form.",
        holds="offset",
    ),
    Equation(
        "area_ratio", _OFFSET, "Undercut of the pinion", "", "offset axes",
        r"J = (dif A_1) / (dif A_2) > 0",
        "Area of the pinion's flank over that of the wheel's which generates it; 0 is a cusp, less than 0 undercut. "
        "The numbers are the smallest of both flanks, and where.",
        numbers=numbers.area_ratio, holds="offset",
    ),
    Equation(
        "contact_turns", _OFFSET, "Contact ratios with an offset", "", "offset axes",
        r"epsilon = (z_2 Delta phi_2) / (2 pi)",
        "The turn of the wheel over its pitch: while contact moves over the profile in the middle of the face (ε_α), "
        "along the face at half the depth (ε_β), and over the whole flank (ε_γ).",
        numbers=numbers.contact_turns, holds="offset",
    ),
)  # fmt: skip
