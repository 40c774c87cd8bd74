"""Colours of the groups of faces in files of triangles."""

from __future__ import annotations

Color = tuple[float, float, float]

_LINEAR: dict[str, Color] = {
    "concave": (0.10, 0.32, 0.62),
    "convex": (0.68, 0.27, 0.09),
    "fillet": (0.45, 0.48, 0.52),
    "meridian": (0.45, 0.48, 0.52),
    "root": (0.38, 0.40, 0.44),
    "tip": (0.55, 0.58, 0.62),
}
_PLAIN: Color = (0.48, 0.50, 0.54)


def linear_color(group: str) -> Color:
    """Red, green, blue in proportion to the light, 0 to 1."""
    return _LINEAR.get(group, _PLAIN)


def face_color(group: str) -> Color:
    """The same as screens are told it (sRGB), 0 to 1."""
    red, green, blue = (12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055 for x in linear_color(group))
    return red, green, blue
