"""What there is to look at in some panels: where the camera aims."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ui.camera import Focus
from ui.layers import Layer, Panel

_FLANK_IDS = ("deviation", "cad_flank")
CONTEXT_IDS = ("tooth", "gear")
_ENOUGH_TO_AIM = 3_000


def focus_of(panels: Sequence[Panel]) -> Focus | None:
    """What the panels let one look at; None when they show nothing."""
    layers = tuple({id(x): x for panel in panels for x in panel.layers if len(x.points)}.values())
    whole = tuple(x for x in layers if x.layer_id in CONTEXT_IDS) or layers
    if not whole:
        return None
    around = np.concatenate([thinned(x.points) for x in whole])
    flanks = {x.part: x for x in layers if x.layer_id in _FLANK_IDS and x.normals is not None}
    flanks |= {x.part: x for x in layers if x.layer_id == "theory_flank" and x.normals is not None}
    centre, radius = sphere_around(whole)
    if not flanks:
        return Focus(centre, radius, around, centre, radius, around, {})
    tooth_centre, tooth_radius = sphere_around(tuple(flanks.values()))
    normals = {name: x.normals.mean(axis=0) for name, x in flanks.items() if x.normals is not None}
    points = np.concatenate([x.points for x in flanks.values()])
    return Focus(centre, radius, around, tooth_centre, tooth_radius, points, normals)


def thinned(points: np.ndarray) -> np.ndarray:
    """As many of these points as it takes to aim at them, shape (n, 3)."""
    return points[:: 1 + len(points) // _ENOUGH_TO_AIM]


def sphere_around(layers: Sequence[Layer]) -> tuple[np.ndarray, float]:
    """Centre of the box around layers, and the distance from it to the box's corner."""
    boxes = [layer.bounds for layer in layers if len(layer.points)]
    if not boxes:
        return np.zeros(3), 1.0
    low, high = np.min([b[0] for b in boxes], axis=0), np.max([b[1] for b in boxes], axis=0)
    return (low + high) / 2, max(float(np.linalg.norm(high - low)) / 2, 1e-9)
