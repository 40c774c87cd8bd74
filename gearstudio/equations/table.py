"""The paper's equations, in the order of the theory; departures from it as section 9 of the theory has them."""

from __future__ import annotations

from gearstudio.equations import numbers
from gearstudio.equations.records import Equation

_CONES, _INVOLUTE, _LENGTHWISE = "Cones", "Spherical involute", "Along the face"
_FLANK, _PROFILE, _POINTS, _PAIR = "Flank", "Tooth profile", "Points and surfaces", "The pair"

PAPER: tuple[Equation, ...] = (
    Equation(
        "pitch_angle", _CONES, "Pitch cone angle", "3", "2",
        r"delta = arctan (sin Sigma) / (z' \/ z + cos Sigma)",
        "The pitch cones of two gears with crossing axes roll on each other; z' are the mate's teeth. "
        "For a right angle it is the paper's arctan z / z'.",
        numbers=numbers.pitch_angle,
    ),
    Equation(
        "transverse_angle", _CONES, "Transverse pressure angle", "", "2",
        r"tan alpha = (tan alpha_n) / (cos beta_m)",
        "Standards give the pressure angle in the normal section at the mean point, the paper in the transverse one.",
        numbers=numbers.transverse_angle,
    ),
    Equation(
        "base_radius", _CONES, "Base radius", "4", "2", r"R_b = (m z cos alpha) / 2",
        "Radius of the back plane of the base cone.",
        r"R_b = (m z cos alpha) / (2 cos delta)", "The division by the cosine does not agree with equation (7).",
        "With the printed form equation (7) gives R = 222.2 mm instead of 86.9 mm (17/40 teeth, m = 4 mm, "
        "transverse 20°, wheel).",
        numbers.base_radius, "always",
    ),
    Equation(
        "base_angle", _CONES, "Base cone angle", "5", "2",
        r"delta_b = arctan sqrt((sin^2 delta) / (tan^2 alpha + cos^2 delta)), quad sin delta_b = sin delta cos alpha",
        "The cone on which the generating plane rolls.",
        r"delta_b = arctan sqrt((sin^2 delta) / (tan^2 alpha + tan^2 delta))",
        "A misprint under the root: the spherical right triangle gives cos²δ.",
        "Printed 21.1°; used 59.863°, which equals arcsin(sin δ cos α) (17/40 teeth, m = 4 mm, transverse 20°, wheel).",
        numbers.base_angle, "always",
    ),
    Equation(
        "element_angle", _CONES, "Angle between pitch and base element", "6", "2",
        r"gamma = arccos (cos delta) / (cos delta_b)",
        "Measured in the tangent plane; it is the arc ψ at which the involute crosses the pitch cone.",
        numbers=numbers.element_angle, holds="always",
    ),
    Equation(
        "cone_distance", _CONES, "Outer cone distance", "7", "2", r"R = R_b / (sin delta_b)",
        "Radius of the tangent circular plane, which is the heel sphere's.", numbers=numbers.cone_distance,
    ),
    Equation(
        "depths", _CONES, "Face and root cone angles", "", "2",
        r"tan(delta_a - delta) = h_(a e) / R, quad tan(delta - delta_f) = h_(f e) / R",
        "Standard depth with a common apex; with constant clearance the face cone is turned parallel to the mate's "
        "root cone instead.",
        numbers=numbers.depths, holds="own depth",
    ),
    Equation(
        "involute", _INVOLUTE, "Spherical involute", "1", "3",
        r"beta_k = 1 / (sin delta_b) arccos (cos delta_k) / (cos delta_b) - arccos (tan delta_b) / (tan delta_k)",
        "Azimuth, from where it started, of a point of the plane that rolls on the base cone without slip.",
        r"beta_k = (arccos (cos delta_k) / (cos delta_b) - arccos (tan delta_b) / (tan delta_k)) / (sin delta_b)",
        "Only the rolled arc is divided by sin δ_b: the second term is an angle about the axis already.",
        "Rolling construction at δ_k = 68°: azimuth 0.0413879 rad, as the used form; the printed form gives "
        "−0.0838 rad (17/40 teeth, transverse 20°, wheel).",
        numbers.involute, "always",
    ),
    Equation(
        "point", _INVOLUTE, "Point in spherical coordinates", "2", "1",
        r"bold(K)(rho, delta_k, phi) = rho vec(sin delta_k cos phi, sin delta_k sin phi, cos delta_k)",
        "Apex at the origin, axis along +z, teeth at z > 0.",
        holds="always",
    ),
    Equation(
        "roll_range", _INVOLUTE, "Roll angle from root to tip", "11", "3",
        r"Theta(delta_k) = 1 / (sin delta_b) arccos (cos delta_k) / (cos delta_b), quad "
        r"Theta = Theta_f + (Theta_a - Theta_f) t",
        "How far the plane has rolled. It starts at 0 where the root lies below the base cone.",
        r"theta_a = (arccos (cos delta_a) / (cos delta_b) - arccos (tan delta_b) / (tan delta_a)) / (sin delta_b)",
        "The azimuth β is where the point is, the roll angle Θ is how far the plane rolled: not the same angle.",
        "The generating line, rolled by Θ, lies on the flank to 4·10⁻¹⁴ mm.",
        numbers.roll_range, "own depth",
    ),
    Equation(
        "base_spiral", _LENGTHWISE, "Base cone spiral", "8", "5.1",
        r"bold(K)_n = R_n vec(sin delta_b cos theta_n, sin delta_b sin theta_n, cos delta_b)",
        "Where the involutes start; the generating line is this curve unrolled into the tangent plane.",
        holds="always",
    ),
    Equation(
        "spiral_start", _LENGTHWISE, "Turn of the spiral from toe to heel", "9", "4",
        r"0 <= theta_n <= (B tan beta_0) / ((R - B) sin delta_b)",
        "For the Archimedean spiral with β₀ at the toe; for other curves the same difference θ(R) − θ(R − B).",
        r"0 <= theta_n <= (R cot delta_b tan beta_0) / (R_b - B tan delta_b)",
        "The printed bound does not return the spiral angle it is made from.",
        "Printed 0.963 rad; used 0.286 rad, which gives back β₀ at the toe (17/40 teeth, m = 4 mm, wheel).",
        numbers.spiral_start,
    ),
    Equation(
        "face", _LENGTHWISE, "Along the face", "10", "4", r"R - B <= R_n <= R", "From the toe to the heel.",
        numbers=numbers.face, holds="always",
    ),
    Equation(
        "turn", _LENGTHWISE, "Lengthwise curve", "", "4",
        r'theta(rho) = "hand" dot (psi_t (rho)) / (sin delta), quad tan beta(rho) = rho psi_t^prime (rho)',
        "A section at ρ is turned by θ(ρ). ψ_t is the tooth trace's polar angle in the developed pitch plane, 0 at the "
        "mean point: of an Archimedean spiral, of the cutter's arc or of a logarithmic spiral. The hand is +1 for a "
        "right-hand spiral; the mate has the other.",
        numbers=numbers.turn, holds="always",
    ),
    Equation(
        "toe_spiral", _LENGTHWISE, "Spiral angle at the toe", "", "4",
        r"tan beta_0 = (R - B) sin delta_b abs(theta'(R - B)) = (sin delta_b) / (sin delta) tan beta_i",
        "On the base cone, as the paper gives it; β_i is the spiral angle on the pitch cone there.",
        numbers=numbers.toe_spiral,
    ),
    Equation(
        "trace", _LENGTHWISE, "Tooth trace of a cutter", "20", "4",
        r"sin beta' = (R'^2 + 2 r_0 R_m sin beta_m - R_m^2) / (2 r_0 R')",
        "Spiral angle at the cone distance R' of a tooth trace that is an arc of the cutter's radius r₀.",
        r"sin beta' = 1 / (2 R') [R'^2 + 2 r_0 R sin beta - R^2]", "The cutter's radius is missing below the line.",
        "The printed form is a length, not a number; the used one meets tan β = ρ ψ′(ρ) to 10⁻⁸.",
        numbers.spiral_angle, "always",
    ),
    Equation(
        "half_thickness", _FLANK, "Half the tooth's thickness", "", "5",
        r'"half" = (pi \/ 2 + 2 x tan alpha) / z - j_t / (2 m z)',
        "As an azimuth on the pitch cone, with profile shift x and transverse backlash j_t.",
        numbers=numbers.half_thickness, holds="own depth",
    ),
    Equation(
        "flank", _FLANK, "The flank", "12", "5",
        r'phi(rho, delta_k) = "side" dot ["half" + beta(delta) - beta(delta_k)] + theta(rho)',
        "The theoretical surface, explicit in azimuth: the deviation of any point from it needs no search.",
        numbers=numbers.flank,
    ),
    Equation(
        "mirror", _FLANK, "The opposite flank", "13, 16", "6", r'"side" -> -"side"',
        "The other flank of the tooth is the mirror image about the tooth's middle.",
        r"phi = beta_k - (360 \/ z - phi_b)", "The paper turns the flank.",
        "A turned copy is the same flank of another tooth.",
    ),
    Equation(
        "generating", _FLANK, "The rolling plane's point", "", "5.1",
        r"bold(K)(rho; a) = rho [cos psi bold(e)_t (a) + sin psi bold(e)_phi (a)], quad "
        r"psi = (phi_0 (rho) - a) sin delta_b",
        "All points of the generating line share the azimuth a of the line of contact: the plane is a rigid body.",
        holds="always",
    ),
    Equation(
        "deviation", _FLANK, "Deviation of a point", "", "5",
        r"e = (phi_P - phi) (rho sin delta_k) / sqrt(1 + sin^2 delta_k (beta'(delta_k)^2 + (rho theta'(rho))^2))",
        "Normal to the flank, positive where metal is added; exact to second order, beyond which the foot point is "
        "iterated.",
        holds="always",
    ),
    Equation(
        "tip", _PROFILE, "Tip and root", "14, 15", "6", r"delta_k = delta_a, quad delta_k = delta_f",
        "Arcs of the tip and root circles between the flanks.",
    ),
    Equation(
        "toe", _PROFILE, "Profile at the toe", "17", "5", r"rho = R - B, quad phi' = phi + theta(rho)",
        "The tooth is self-similar: every section is the heel's, scaled by ρ and turned by θ(ρ).",
    ),
    Equation(
        "fillet", _PROFILE, "Fillet radius", "18, 19", "6", r"R_f = f m_n, quad epsilon = R_f / R",
        "A circle on the sphere, tangent to root and flank (or to the meridian below the base cone); it scales with ρ. "
        "The paper's factor f is 0.3.",
        numbers=numbers.fillet, holds="always",
    ),
    Equation(
        "guide", _PROFILE, "Guide curve along the tip", "21", "7", r"phi = phi(rho, delta_a)",
        "Guide curves follow the flank on tip and root.",
        r"phi = beta_k", "The turn θ(ρ) is missing.", "Without it the guide leaves the flank of a spiral tooth.",
    ),
    Equation(
        "division", _POINTS, "Places along the generating line", "22, 23", "7",
        r"rho_n = R - B + B n / (N - 1), quad n = 0, ..., N - 1",
        "Evenly divided; by arc length or denser at the ends on request.",
        r"N = (R_0 R_t) / (R_n R_(n+1))", "The printed form is a ratio of lengths, not a count.",
        "A ratio that changes with n cannot be the count of points.",
        holds="always",
    ),
    Equation(
        "nurbs", _POINTS, "NURBS surface", "24", "7",
        r"bold(S)(u, v) = (sum_i sum_j N_(i,k_u)(u) N_(j,k_v)(v) w_(i j) bold(p)_(i j)) / "
        r"(sum_i sum_j N_(i,k_u)(u) N_(j,k_v)(v) w_(i j))",
        "Weights above and below the line.",
        r"bold(S)(u, v) = (sum_i sum_j bold(p)_(i j) N_(i,k_u)(u) N_(j,k_v)(v)) / "
        r"(sum_i sum_j w_(i j) N_(i,k_u)(u) N_(j,k_v)(v))",
        "The weights are missing above the line.", "The basis functions then do not add up to one.",
        holds="always",
    ),
    Equation(
        "contact_ratio", _PAIR, "Contact ratios", "", "8",
        r"epsilon_alpha = z_1 / (2 pi sin delta_(b 1)) sum_(i=1)^2 [arccos (cos delta_(a i)) / (cos delta_(b i)) - "
        r"gamma_i], quad epsilon_beta = (z abs(theta(R) - theta(R - B))) / (2 pi)",
        "Transverse contact ratio on the heel sphere, and overlap ratio.",
        numbers=numbers.contact_ratio,
    ),
    Equation(
        "placing", _PAIR, "The pair in mesh", "", "8",
        r"bold(x) = R_y (Sigma) R_z (pi) R_z (phi_1) bold(x)_1, quad phi_2 = - phi_1 z_1 / z_2",
        "Wheel axis along +z; the flanks are exactly conjugate.",
    ),
)  # fmt: skip
