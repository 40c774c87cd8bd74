"""Fields that have no effect because the pair has an offset, or has none; and what its empty fields stand for."""

from __future__ import annotations

from collections.abc import Mapping
from math import degrees
from typing import TYPE_CHECKING, Any

from ui.formatting import fixed
from ui.words import tr

if TYPE_CHECKING:
    from gearstudio.theory.cones import PairGeometry


def idle_by_offset(draft: Mapping[str, Any]) -> dict[str, str]:
    """Fields without effect, each with the reason."""
    if not draft.get("pair.offset"):
        none = tr("It needs a pair with an offset.")
        return {"lengthwise.spiral_angle_of": none, "tooth.limit_pressure_angle_factor": none}
    idle: dict[str, str] = {}
    if draft.get("lengthwise.spiral_angle_at") == "mean":
        idle["lengthwise.spiral_angle_at"] = tr("With an offset the spiral angle is given at the mean point.")
    if draft.get("pair.pressure_angle_kind") == "normal":
        idle["pair.pressure_angle_kind"] = tr("With an offset the pressure angle is the normal one.")
    if draft.get("depth.system") == "outer_module":
        idle["tooth.tip_cone"] = tr("With an offset the tips run parallel to the mate's root: no apex is common.")
    return idle


def depth_hints(pair: PairGeometry) -> dict[str, str]:
    """Values that the standard gives to empty fields of the depth."""
    if pair.hypoid is None:
        return {}
    depth = pair.hypoid.depth
    return {
        "depth.mean_addendum_factor": fixed(depth.addenda[1] / depth.working_depth, 4),
        "depth.addendum_angle_deg": f"{fixed(degrees(depth.addendum_angle), 4)}°",
        "depth.dedendum_angle_deg": f"{fixed(degrees(depth.dedendum_angle), 4)}°",
    }
