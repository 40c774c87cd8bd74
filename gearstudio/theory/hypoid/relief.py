"""Micro-geometry of members with offset axes: places are measured on each flank's own working area."""

from __future__ import annotations

from dataclasses import replace

from gearstudio.design import FlankModification
from gearstudio.theory.flank import FlankName
from gearstudio.theory.hypoid.best_line import edge_cone
from gearstudio.theory.hypoid.conjugate import pinion_flank
from gearstudio.theory.hypoid.inputs import MemberName
from gearstudio.theory.hypoid.pair import HypoidPair
from gearstudio.theory.relief import Edge, FlankRelief, flank_relief


def relief_of(pair: HypoidPair, name: MemberName, flank: FlankName, given: FlankModification) -> FlankRelief | None:
    """What is taken off a flank, or None.

    Raises
    ------
    GeometryError
        The pinion's flank does not reach over its face.
    """
    if given.is_none:
        return None
    frame = pair.member(name, flank).relief_frame
    if name == "pinion" and pair.given.offset != 0:
        start = edge_cone(pinion_flank(pair, flank), 0.0)
        frame = replace(frame, low=Edge(start.angle, start.offset))
    return flank_relief(given, frame)
