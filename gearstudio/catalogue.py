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
METHOD_INFOS = (ROTATING_LINE, PROFILE_SWEEP, POINT_CLOUD)
METHOD_IDS = tuple(info.id for info in METHOD_INFOS)
