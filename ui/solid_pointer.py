"""The point of a solid under the pointer: its face, tooth, place and deviation, with a marker over the picture.

The ray meets the coarse mesh, whose triangles are few; from there it goes on to the face of theory that is nearest.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, QPointF, QTimer

from gearstudio.analysis.gear_deviation import GearTheory
from gearstudio.errors import GearStudioError
from gearstudio.theory.blank import BlankSizes
from gearstudio.theory.chamfer import end_chamfers
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.profile import profile_of
from ui.formatting import MEMBER_TITLES, fixed
from ui.measure_overlay import MeasureOverlay
from ui.measuring import Picked, pick
from ui.picking import Hover
from ui.words import tr

if TYPE_CHECKING:
    from ui.solid_view import SolidView
    from ui.solids import Built

Floats = NDArray[np.float64]

_STEPS = 4
_PROBE = 1e-6
_TOOTHLESS = ("end", "body")


class SolidPointer(QObject):
    """Follows the pointer while it is on; ``say`` is told a `picking.Hover`, or None off the solids."""

    def __init__(self, view: SolidView, say: Callable[[Hover | None], None], parent: QObject) -> None:
        super().__init__(parent)
        self._view, self._say = view, say
        self._on = False
        self._built: dict[str, Built] = {}
        self._theories: dict[str, tuple[Built, GearTheory | None]] = {}
        self._position: QPointF | None = None
        self._point: Floats | None = None
        self._overlay = MeasureOverlay(view.grid)
        self._timer = QTimer(self, singleShot=True, interval=0)
        self._timer.timeout.connect(self._update)
        viewport = view.grid.viewport
        viewport.pointer_moved.connect(self._on_moved)
        viewport.pointer_left.connect(self.clear)
        viewport.drawing.connect(lambda _hurried: self._place())

    def show_solids(self, built: dict[str, Built]) -> None:
        """The solids in sight, by member; none switches it off."""
        self._built, self._on = built, bool(built)
        if not self._on:
            self.clear()

    def clear(self) -> None:
        """Nothing is under the pointer."""
        self._timer.stop()
        self._position = None
        self._tell(None, None)

    # ---- parts -----------------------------------------------------------------------------------------

    def _on_moved(self, position: QPointF) -> None:
        if self._on:
            self._position = position
            if not self._timer.isActive():
                self._timer.start()

    def _update(self) -> None:
        if self._position is None or not self._on:
            return
        view = self._view
        _, x, y = view.grid.viewport.pane_at(self._position)
        coarse = tuple(layer for layer in view.layers if layer.body and layer.level == "coarse")
        ray = view.grid.viewport.look.ray(x, y)
        found = pick(coarse, view.frames, ray, view.plane)
        if found is None or found.member not in self._built:
            self._tell(None, None)
            return
        self._tell(*self._described(found, ray[1]))

    def _described(self, found: Picked, direction: Floats) -> tuple[Hover, Floats]:
        frame = self._view.frames[found.member]
        place = frame.turn.after(frame.base)
        theory = self._theory(found.member)
        member, local = MEMBER_TITLES[found.member], found.local
        if found.hit is None or theory is None:
            words = tr("{member}, cut face", member=tr(member)) if found.hit is None else tr(member)
            return self._hover(words, local, None), found.point
        tooth = int(theory.teeth_of(local[None])[0])
        name = theory.names[int(theory.nearest(theory.to_first(local[None], tooth))[0][0])]
        local = _on_face(theory, name, tooth, local, direction @ place.matrix)
        number = 1 + (int(theory.teeth_of(local[None], theory.member.pitch / 2)[0]) if name == "root" else tooth)
        words = f"{tr(member)}, {tr(name)}"
        if name not in _TOOTHLESS:
            words = tr("{member}, {face}, tooth {number}", member=tr(member), face=tr(name), number=number)
        return self._hover(words, local, self._deviation(found)), place.of(local)

    def _hover(self, words: str, local: Floats, deviation_um: float | None) -> Hover:
        """Coordinates are the gear's own."""
        x, y, z = (float(value) for value in local)
        azimuth = fixed(float(np.degrees(np.arctan2(y, x))), 3)
        rho, delta = float(np.linalg.norm(local)), float(np.degrees(np.arctan2(np.hypot(x, y), z)))
        return Hover("solid", f"{words}    φ {azimuth}°", (x, y, z), rho, delta, deviation_um)

    def _deviation(self, found: Picked) -> float | None:
        """Of the solid's flank there [µm]; None on another face."""
        hit = found.hit
        if hit is None or not hit.layer.part.startswith(f"{found.member} flanks"):
            return None
        gear = next(gear for gear in self._view.gears if gear.member == found.member)
        return float(hit.weights @ gear.coarse.deviation_um[hit.corners])

    def _theory(self, member: str) -> GearTheory | None:
        """The gear of theory, made once for each solid; None where there is none of its kind."""
        built = self._built[member]
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

    def _tell(self, hover: Hover | None, point: Floats | None) -> None:
        if hover is not None or self._point is not None:
            self._point = point
            self._say(hover)
            self._place()

    def _place(self) -> None:
        viewport = self._view.grid.viewport
        if self._point is None:
            self._overlay.show_points((), "")
            return
        x, y = viewport.look.project(self._point)
        self._overlay.show_points((viewport.place_of(0, float(x), float(y)),), "")


def _on_face(theory: GearTheory, name: str, tooth: int, start: Floats, way: Floats) -> Floats:
    """Where a ray through a point meets a face of theory; the point itself where it does not."""
    point, step = start, _PROBE * theory.member.outer_cone_distance
    for _ in range(_STEPS):
        both = theory.to_first(np.stack([point, point + step * way]), tooth)
        here, there = theory.distance(name, both)
        if abs(there - here) < 1e-3 * step:
            return start
        point = point - here * step / (there - here) * way
    return point if np.linalg.norm(point - start) < 1e-2 * theory.member.outer_cone_distance else start
