"""Micro-geometry of members with offset axes: places are measured on each flank's own working area."""

from __future__ import annotations

from dataclasses import replace
from math import atan2, cos, sin

from gearstudio.design import FlankModification
from gearstudio.theory.flank import FlankName
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
        frame = replace(frame, low=_start_of_contact(pair, flank))
    return flank_relief(given, frame)


def _start_of_contact(pair: HypoidPair, name: FlankName) -> Edge:
    """The cone through both ends of the edge where contact starts on the pinion."""
    flank = pinion_flank(pair, name)
    rho, delta, _ = (part.tolist() for part in flank.locate(flank.points(0.0, [0.0, 1.0])))
    radius, height = ([r * turn(d) for r, d in zip(rho, delta, strict=True)] for turn in (sin, cos))
    angle = atan2(radius[1] - radius[0], height[1] - height[0])
    return Edge(angle, rho[1] * sin(delta[1] - angle))
