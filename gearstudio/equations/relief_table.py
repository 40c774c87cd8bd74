"""Equations of micro-geometry, and of the contact that it changes."""

from __future__ import annotations

from gearstudio.equations import relief_numbers as numbers
from gearstudio.equations.records import Equation

_RELIEF, _CONTACT = "Micro-geometry", "Contact"

RELIEF: tuple[Equation, ...] = (
    Equation(
        "relief", _RELIEF, "Metal taken off a flank", "", "micro-geometry",
        r"e(xi, eta) = c_l xi^2 + c_p eta^2 - (s xi + p eta + b xi eta) / 2 + e_t (eta) + e_r (eta)",
        "Normal to the flank: crowning along the face and over the profile, corrections of spiral and pressure angle, "
        "bias, tip and root relief. ξ runs from −1 at the toe to 1 at the heel, η from −1 at the flank's lower edge to "
        "1 at the tip. D is the drive flank, concave on the pinion and convex on the wheel; C is the coast flank.",
        numbers=numbers.relief, holds="always",
    ),
    Equation(
        "tip_relief", _RELIEF, "Tip relief", "", "micro-geometry",
        r"e_t = c_t ((eta - eta_t) / (1 - eta_t))^3 quad (eta > eta_t), quad eta_t = 2 a_t - 1",
        "A cube, so that slope and curvature have no kink where it starts; a_t is the share of the depth there.",
        numbers=numbers.tip_relief, holds="always",
    ),
    Equation(
        "root_relief", _RELIEF, "Root relief", "", "micro-geometry",
        r"e_r = c_r ((eta_r - eta) / (1 + eta_r))^3 quad (eta < eta_r), quad eta_r = 2 a_r - 1",
        "A cube too, from where it ends down to the flank's lower edge; a_r is the share of the depth there.",
        numbers=numbers.root_relief, holds="always",
    ),
    Equation(
        "places", _RELIEF, "Place on a flank", "", "micro-geometry",
        r"xi = 2 (rho_u - R_m) / B, quad eta = 2 (delta_k - delta_0) / (delta_a - delta_0) - 1",
        "Even in the distance and in the polar angle; δ₀ is the flank's lower edge, on the root cone or the base cone. "
        "With an offset the pinion's flank begins at the start of contact.",
        numbers=numbers.places, holds="always",
    ),
    Equation(
        "modified_flank", _RELIEF, "The modified flank", "", "micro-geometry",
        r"""phi_"mod" = phi - "side" dot e(xi, eta) / lambda, quad """
        r"lambda = (rho sin delta_k) / sqrt(1 + sin^2 delta_k (beta'(delta_k)^2 + (rho theta'(rho))^2))",
        "A point is turned about the axis by as much as moves it by e along the flank's normal: the flank stays "
        "explicit in azimuth. The methods build this flank, and deviation is from it.",
        holds="always",
    ),
    Equation(
        "transmission", _CONTACT, "Transmission error", "", "8",
        r'''q = "side" dot (phi_P - phi(rho, delta_k)), quad "TE"(phi_1) = min_P q, quad '''
        r'''g = (q - "TE") lambda''',
        "Each point P of the pinion, taken to the wheel, needs a turn q to touch. The smallest is the transmission "
        "error; what is left of the others is the gap g. Contact is where g is less than the marking compound's "
        "thickness.",
        holds="always",
    ),
)  # fmt: skip
