"""The equations of the theory: as used, as the paper prints them, why they differ, and the numbers of a design."""

from gearstudio.equations.records import Equation, Given, Numbers, numbers_of
from gearstudio.equations.table import EQUATIONS, equation

__all__ = ["EQUATIONS", "Equation", "Given", "Numbers", "equation", "numbers_of"]
