"""From a layer's style to what VTK draws with."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from ui.layers import Ink, Layer, Style
from ui.views.appearance import LayerLook


def chosen_style(layer: Layer, looks: Mapping[str, LayerLook]) -> Style:
    """A layer's style with what the user changed of it."""
    chosen, style = looks.get(layer.layer_id), layer.style
    if chosen is None:
        return style
    if chosen.color is not None:
        style = replace(style, ink=Ink(chosen.color, chosen.color))
    return style if chosen.opacity is None else replace(style, opacity=chosen.opacity)


def apply_style(look: Any, layer: Layer, style: Style, dark: bool, pixel_ratio: float) -> None:
    """Set a VTK property for a layer."""
    ink = style.ink.dark if dark else style.ink.light
    look.SetColor(*rgb(ink))
    look.SetOpacity(style.opacity)
    lit = layer.kind == "surface" and not style.flat
    look.SetLighting(lit)
    look.SetAmbient((0.70 if layer.scalars is not None else 0.40) if lit else 1.0)
    look.SetDiffuse((0.34 if layer.scalars is not None else 0.66) if lit else 0.0)
    look.SetSpecular(style.gloss if lit else 0.0)
    look.SetSpecularPower(28.0)
    if layer.normals is None:
        look.SetInterpolationToFlat()
    else:
        look.SetInterpolationToPhong()
    look.SetLineWidth(style.width * pixel_ratio)
    look.SetPointSize(style.width * pixel_ratio)
    look.SetRenderPointsAsSpheres(layer.kind == "points")


def rgb(color: str) -> tuple[float, ...]:
    """``#rrggbb`` in [0, 1]."""
    return tuple(int(color[i : i + 2], 16) / 255 for i in (1, 3, 5))
