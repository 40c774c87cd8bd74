"""The point of a solid at a place of the picture: its face, tooth, place and deviation.

The ray meets the coarse mesh, whose triangles are few; from there it goes on to the face of theory that is nearest.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF

from gearstudio.analysis.gear_deviation import GearTheory
from gearstudio.errors import GearStudioError
from gearstudio.theory.blank import BlankSizes
from gearstudio.theory.chamfer import end_chamfers
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.profile import profile_of
from ui.measuring import Picked, pick
from ui.picking import Hover
from ui.solid_faces import located
from ui.solid_words import spot_words

if TYPE_CHECKING:
    from ui.solid_view import SolidView
    from ui.solids import Built

Floats = NDArray[np.float64]


class SolidSpots:
    """Answers for the solids in sight."""

    def __init__(self, view: SolidView) -> None:
        self._view = view
        self.built: dict[str, Built] = {}
        self._theories: dict[str, tuple[Built, GearTheory | None]] = {}

    def at(self, position: QPointF) -> tuple[Hover, Floats] | None:
        """What is at a place of the views, and that point in the frame of the view; None off the solids."""
        view = self._view
        _, x, y = view.grid.viewport.pane_at(position)
        coarse = tuple(layer for layer in view.layers if layer.body and layer.level == "coarse")
        ray = view.grid.viewport.look.ray(x, y)
        found = pick(coarse, view.frames, ray, view.plane)
        if found is None or found.member not in self.built:
            return None
        return self._described(found, ray[1])

    def place(self, hover: Hover) -> Floats | None:
        """Where a point of a gear is in the view now; None when its gear is not in sight."""
        frame = self._view.frames.get(hover.member)
        return None if frame is None else frame.turn.after(frame.base).of(np.array(hover.xyz))

    def _described(self, found: Picked, direction: Floats) -> tuple[Hover, Floats]:
        frame = self._view.frames[found.member]
        place = frame.turn.after(frame.base)
        theory = self._theory(found.member)
        if found.hit is None or theory is None:
            face = "cut face" if found.hit is None else ""
            return _hover(found.member, face, None, found.local, None), found.point
        face, tooth, local = located(theory, found.local, direction, place)
        return _hover(found.member, face, tooth, local, self._deviation(found)), place.of(local)

    def _deviation(self, found: Picked) -> float | None:
        """Of the solid's flank there [µm]; None on another face."""
        hit = found.hit
        if hit is None or not hit.layer.part.startswith(f"{found.member} flanks"):
            return None
        gear = next(gear for gear in self._view.gears if gear.member == found.member)
        return float(hit.weights @ gear.coarse.deviation_um[hit.corners])

    def _theory(self, member: str) -> GearTheory | None:
        """The gear of theory, made once for each solid; None where there is none of its kind."""
        built = self.built[member]
        if member not in self._theories or self._theories[member][0] is not built:
            try:
                geometry = pair_geometry(built.design).member(member)
                sizes = BlankSizes(**getattr(built.design.blank, member).model_dump())
                chamfers = end_chamfers(geometry, sizes.end_chamfer)
                theory = GearTheory(geometry, profile_of(geometry), built.result.outline, chamfers)
            except GearStudioError:
                theory = None
            self._theories[member] = built, theory
        return self._theories[member][1]


def _hover(member: str, face: str, tooth: int | None, local: Floats, deviation_um: float | None) -> Hover:
    """Coordinates are the gear's own."""
    x, y, z = (float(value) for value in local)
    rho, delta = float(np.linalg.norm(local)), float(np.degrees(np.arctan2(np.hypot(x, y), z)))
    words = spot_words(member, face, tooth, float(np.degrees(np.arctan2(y, x))))
    return Hover(
        "solid", words, (x, y, z), rho, delta, deviation_um if face.endswith("flank") else None,
        member=member, face=face, tooth=tooth,
    )  # fmt: skip
