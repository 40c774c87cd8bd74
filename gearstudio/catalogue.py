"""The names of members, methods and variants, for whoever offers a choice; loads no CAD kernel."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

MemberName = Literal["pinion", "wheel"]
Variant = Literal["published", "optimised"]

MEMBERS: tuple[MemberName, MemberName] = ("pinion", "wheel")
VARIANTS: tuple[Variant, Variant] = ("published", "optimised")


@dataclass(frozen=True)
class MethodInfo:
    """What a method is called and where it comes from."""

    id: str
    title: str
    paper_section: str
    summary: str


ROTATING_LINE = MethodInfo(
    "rotating_line",
    "Rotating line",
    "section 3",
    "The generating line, moved rigidly as the tangent plane rolls on the base cone",
)
PROFILE_SWEEP = MethodInfo(
    "profile_sweep",
    "Profile sweep",
    "section 4",
    "The tooth profile, swept from heel to toe along the tooth trace",
)
POINT_CLOUD = MethodInfo(
    "point_cloud",
    "Point cloud",
    "section 5",
    "A NURBS surface through discrete points on U and V lines",
)
PAPER_MEANS_UM = {ROTATING_LINE.id: 54.6, PROFILE_SWEEP.id: 60.3, POINT_CLOUD.id: 52.9}
PAPER_RANGE_UM = (43.4, 71.3)
"""What the paper states of its own gear, whose data it does not print (theory 9)."""
METHOD_INFOS = (ROTATING_LINE, PROFILE_SWEEP, POINT_CLOUD)
METHOD_IDS = tuple(info.id for info in METHOD_INFOS)
