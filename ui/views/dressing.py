"""What surface quality adds to the layers of a result: other colours, exact normals, combs, arrows; no renderer."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from gearstudio.results import VariantResult
from ui import layers as look
from ui.grids import path_segments
from ui.layers import Layer, Style
from ui.views.appearance import Appearance
from ui.views.quality import FlankQuality
from ui.views.quantities import quantity_of

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]

COLORED = "deviation"
"""Layer of the flanks that are coloured by a quantity."""
SURFACES = frozenset({COLORED, "cad_flank"})
COMB_LINES, COMB_TEETH = 6, 20
COMB_SHARE = 0.16
"""Typical length of a comb's teeth, of the length of the flank's diagonal, at a scale of 1."""
LONGEST = 3.0
"""Teeth are cut off at so many typical lengths."""
_ARROWS = (6, 10)
_ARROW_SHARE, _BARB_SHARE = 0.07, 0.35
_COMB_OUT = Style(look.GREEN, width=1.2, lift=3)
_COMB_IN = Style(look.MAGENTA, width=1.2, lift=3)
_ARROW = Style(look.INK, width=1.3, lift=3)
_EMPTY = np.empty((0, 3))


def dressed(
    layers: Sequence[Layer],
    result: VariantResult,
    quality: Mapping[str, FlankQuality] | None,
    appearance: Appearance,
    typical: float,
) -> tuple[Layer, ...]:
    """The layers of a result as the appearance wants them.

    Parameters
    ----------
    layers : sequence of Layer
        From `scene.result_layers`.
    result : VariantResult
    quality : mapping of flank to FlankQuality, or None
        None while it is computed: then nothing is told by colours that are not those of the deviation.
    appearance : Appearance
    typical : float
        Curvature [1/mm] that is drawn with the typical length; the same for everything side by side.
    """
    quantity = quantity_of(appearance)
    made = []
    for layer in layers:
        if layer.kind != "surface" or layer.layer_id not in SURFACES:
            made.append(layer)
            continue
        deviation, scalars, normals = layer.scalars, layer.scalars, layer.normals
        if layer.layer_id == COLORED and not quantity.is_deviation:
            scalars = np.full(len(layer.points), np.nan)
        if quality is not None and layer.part in quality:
            one = quality[layer.part]
            if layer.true_points is None:
                normals = _facing_like(one.normals.reshape(-1, 3), layer.normals)
            if layer.layer_id == COLORED and not quantity.is_deviation:
                scalars = one.values(appearance.quantity, appearance.against).ravel()
        made.append(replace(layer, scalars=scalars, normals=normals, deviation=deviation))
    if quality is not None:
        drawn = {layer.part: layer.points for layer in layers if layer.kind == "surface" and layer.layer_id == COLORED}
        for name, one in quality.items():
            points = result.flanks[name].points
            points = drawn[name].reshape(points.shape) if name in drawn else points
            made += combs(name, points, one, appearance, typical)
            made.append(arrows(name, points, one.normals))
    return tuple(layer for layer in made if len(layer.points))


def _facing_like(normals: Floats, drawn: Floats | None) -> Floats:
    """Exact normals to the side that the layer's triangles are turned to."""
    return -normals if drawn is not None and np.sum(normals * drawn) < 0 else normals


def typical_curvature(qualities: Sequence[Mapping[str, FlankQuality]], along: str) -> float:
    """The curvature that most of these flanks stay below [1/mm]."""
    values = [np.abs(_line(one, along)).ravel() for quality in qualities for one in quality.values()]
    everything = np.concatenate(values) if values else np.empty(0)
    everything = everything[np.isfinite(everything)]
    return float(np.percentile(everything, 85)) if len(everything) else 0.0


def combs(name: str, points: Floats, quality: FlankQuality, appearance: Appearance, typical: float) -> list[Layer]:
    """Teeth that stand on parameter lines, as long as the line is curved there; green where convex, else magenta."""
    along = appearance.combs
    curvature = _line(quality, along)
    size = float(np.linalg.norm(points[-1, -1] - points[0, 0]))
    if typical <= 0:
        return []
    length = np.abs(curvature) / typical * COMB_SHARE * size * appearance.comb_scale
    length = np.minimum(length, LONGEST * COMB_SHARE * size * appearance.comb_scale)
    tips = points + length[..., None] * quality.normals
    if along == "profile":
        feet, tips, curvature = (np.swapaxes(x, 0, 1) for x in (points, tips, curvature))
    else:
        feet = points
    rows = np.unique(np.rint(np.linspace(0, len(feet) - 1, COMB_LINES)).astype(int))
    every = max(1, len(feet[0]) // COMB_TEETH)
    lines = [_comb(feet[row], tips[row], curvature[row], every) for row in rows]
    made = []
    for part, style, index in (("convex", _COMB_OUT, 0), ("hollow", _COMB_IN, 1)):
        segments = np.concatenate([line[index] for line in lines])
        made.append(_segments("combs", f"{name} {part} lines", segments, style))
    return made


def _comb(feet: Floats, tips: Floats, curvature: Floats, every: int) -> tuple[Floats, Floats]:
    """Teeth and the line over their tips, where convex and where hollow, shape (n, 2, 3) each."""
    good = np.isfinite(curvature)
    feet, tips, hollow = feet[good], tips[good], curvature[good] < 0
    teeth, bent = np.stack([feet, tips], axis=1)[::every], hollow[::every]
    over = np.stack([tips[:-1], tips[1:]], axis=1)
    both = hollow[:-1] & hollow[1:]
    return np.concatenate([teeth[~bent], over[~both]]), np.concatenate([teeth[bent], over[both]])


def arrows(name: str, points: Floats, normals: Floats) -> Layer:
    """Arrows along the normals, with heads of two barbs."""
    rows, cols = (
        np.unique(np.rint(np.linspace(0, count - 1, number)).astype(int))
        for count, number in zip(points.shape[:2], _ARROWS, strict=True)
    )
    pick = np.ix_(rows, cols)
    feet, out = points[pick].reshape(-1, 3), normals[pick].reshape(-1, 3)
    size = _ARROW_SHARE * float(np.linalg.norm(points[-1, -1] - points[0, 0]))
    aside = np.gradient(points, axis=1)[pick].reshape(-1, 3)
    aside = aside / np.linalg.norm(aside, axis=-1, keepdims=True)
    tips = feet + size * out
    barbs = [tips - _BARB_SHARE * size * (out + sign * 0.5 * aside) for sign in (1, -1)]
    segments = np.concatenate([np.stack([feet, tips], axis=1), *(np.stack([tips, barb], axis=1) for barb in barbs)])
    return _segments("normals", f"{name} arrows", segments, _ARROW)


def _line(quality: FlankQuality, along: str) -> Floats:
    return quality.profile if along == "profile" else quality.lengthwise


def _segments(layer_id: str, part: str, segments: Floats, style: Style) -> Layer:
    cells: Indices = path_segments((2,) * len(segments)) if len(segments) else np.empty((0, 2), dtype=np.int64)
    return Layer(layer_id, part, "lines", segments.reshape(-1, 3) if len(segments) else _EMPTY, style, cells)
