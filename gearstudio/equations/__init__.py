"""The equations of the theory: as used, as the paper prints them, why they differ, and the numbers of a design."""

from gearstudio.equations.links import equation_for, equations_of_field, equations_of_quantity, fields_of
from gearstudio.equations.listing import EQUATIONS, equation, listed
from gearstudio.equations.records import Equation, Given, Numbers, holds, numbers_of

__all__ = [
    "EQUATIONS",
    "Equation",
    "Given",
    "Numbers",
    "equation",
    "equation_for",
    "equations_of_field",
    "equations_of_quantity",
    "fields_of",
    "holds",
    "listed",
    "numbers_of",
]
