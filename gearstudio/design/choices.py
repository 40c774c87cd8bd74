"""Choices of the design file in words."""

from __future__ import annotations

_TITLES = {
    "normal": "Normal, mean point",
    "transverse": "Transverse",
    "left": "Left hand",
    "right": "Right hand",
    "archimedean": "Archimedean spiral",
    "circular_arc": "Circular arc (milled)",
    "logarithmic": "Logarithmic spiral",
    "mean": "Mean, pitch cone",
    "toe": "Toe, base cone",
    "common_apex": "Common apex",
    "constant_clearance": "Constant clearance",
    "back_cone": "Back cones",
    "sphere": "Spheres",
    "iso23509": "ISO 23509",
}


def choice_title(value: str) -> str:
    """A choice of the design file in words."""
    return _TITLES.get(value, value.replace("_", " ").capitalize())
