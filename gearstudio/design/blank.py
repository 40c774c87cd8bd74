"""The turned bodies: the tables ``blank.pinion`` and ``blank.wheel`` of a design."""

from __future__ import annotations

from typing import Any

from pydantic import Field

from gearstudio.design.fields import Part, Words, number


def _body(title: str, description: str, symbol: str, default: float | None = None) -> Any:
    """A size of a turned body [mm]."""
    return number(default, 0.0, 20000.0, Words(title, description, "mm", symbol, step=1.0, decimals=3))


class BlankMember(Part):
    """The turned body of one member; what is empty is derived from the pair."""

    bore_diameter: float | None = _body(
        "Bore diameter", "Diameter of the bore, 0 for none; leave empty to derive it from the pair.", "d"
    )
    hub_diameter: float | None = _body("Hub diameter", "Outer diameter of the hub, on the side of the apex.", "D_h")
    hub_length: float | None = _body("Hub length", "From the back face toward the apex; the toe limits it.", "L_h")
    mounting_distance: float | None = _body("Mounting distance", "From the apex to the back face.", "t_B")
    web_thickness: float | None = _body("Web thickness", "Of the disc between hub and rim, from the back face.", "b_w")
    shank_diameter: float = _body(
        "Shank diameter",
        "Diameter of a solid shank behind the back face, 0 for none; it replaces the bore.",
        "d_s",
        0.0,
    )
    shank_length: float = _body("Shank length", "Length of the shank behind the back face, 0 for none.", "L_s", 0.0)
    end_chamfer: float = _body(
        "End chamfer",
        "Of the edges between tip and ends of the teeth, turned over all teeth at toe and heel; its legs along the "
        "face cone and along the end, 0 for none.",
        "c",
        0.0,
    )


class Blank(Part):
    """The turned bodies of both members."""

    pinion: BlankMember = Field(default_factory=BlankMember)
    wheel: BlankMember = Field(default_factory=BlankMember)
