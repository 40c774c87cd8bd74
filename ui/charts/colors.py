"""The colours of data in charts, light and dark; roles that name no method fall back on the theme."""

from __future__ import annotations

from PySide6.QtGui import QColor

from ui.theme import is_dark, tokens

# Told apart by every common kind of colour blindness, in lightness too.
_LIGHT = {
    "rotating_line": "#0b62b8",
    "profile_sweep": "#c2570c",
    "point_cloud": "#0f8a6d",
    "pinion": "#0b62b8",
    "wheel": "#c2570c",
    "drive": "#0b62b8",
    "coast": "#c2570c",
    "pattern": "#1f6fd0",
    "path": "#c2185b",
    "concave": "#0b62b8",
    "convex": "#c2570c",
    "added": "#c2480f",
    "missing": "#1f5fc4",
    "contour": "#1d232b",
}
_DARK = {
    "rotating_line": "#6db1ff",
    "profile_sweep": "#ff9f57",
    "point_cloud": "#45cfa8",
    "pinion": "#6db1ff",
    "wheel": "#ff9f57",
    "drive": "#6db1ff",
    "coast": "#ff9f57",
    "pattern": "#5b9dfa",
    "path": "#ff6fa3",
    "concave": "#6db1ff",
    "convex": "#ff9f57",
    "added": "#ff9456",
    "missing": "#6aa8ff",
    "contour": "#1d232b",
}


def chart_color(role: str, alpha: float = 1.0) -> QColor:
    """The colour of a role in the theme in use: a method, a member, or a token's name (``"muted"``)."""
    known = _DARK if is_dark() else _LIGHT
    color = QColor(known.get(role) or getattr(tokens(), role))
    color.setAlphaF(alpha)
    return color
