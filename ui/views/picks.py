"""The picked point: asks for the values of every method there, and shows them on a card over the views."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from ui.analysis.background import Newest
from ui.session import Key, Session

if TYPE_CHECKING:
    from gearstudio.analysis.probe import Curvature, Probe
    from gearstudio.results import VariantResult
    from gearstudio.theory.cones import MemberGeometry
    from gearstudio.theory.flank import FlankName
    from ui.main_window import MainWindow
    from ui.picking import Hover
    from ui.solid_mode import SolidMode
    from ui.solids import Built
    from ui.view_grid import ViewGrid
    from ui.views.appearance import Appearance
    from ui.views.pick_card import PickCard


@dataclass(frozen=True)
class PickedValues:
    """At a place: of each result what its surface is like there (None where it does not reach), of theory, of a solid.

    Off the flanks there is none of them.
    """

    azimuth_deg: float
    found: Mapping[Key, Probe | None]
    theory: Curvature | None
    solid: Probe | None = None


class Picks(QObject):
    """Keeps the card in step with the marker and the results; the newest question is answered."""

    def __init__(self, session: Session, window: MainWindow, solid_mode: SolidMode, parent: QObject) -> None:
        super().__init__(parent)
        self._session, self._window, self._solid_mode = session, window, solid_mode
        self._grid: ViewGrid | None = None
        self._pin: Hover | None = None
        self._member = ""
        self.card: PickCard | None = None
        self._newest = Newest("picked point", self)
        self._newest.done.connect(self._on_done)
        self._newest.failed.connect(lambda _pin, text, _details: self._on_failed(text))
        session.results_changed.connect(self._ask)
        session.selection_changed.connect(self._drop)
        window.closing.connect(self._newest.close)

    def views_ready(self) -> None:
        """The window has its views now."""
        from ui.views.pick_card import PickCard

        grid = self._window.area.grid
        assert grid is not None
        self._grid = grid
        self.card = PickCard(grid)
        self.card.close_wanted.connect(grid.pointing.drop_pin)
        grid.picked.connect(self._on_picked)

    def show_appearance(self, appearance: Appearance) -> None:
        """Take the unit of deviations."""
        if self.card is not None:
            self.card.set_unit(appearance.unit)

    def _drop(self) -> None:
        """Another member: the point is none of its. Points of solids go with their solid."""
        pin = self._pin
        if self._grid is not None and pin is not None and not pin.member and self._session.member != self._member:
            self._grid.pointing.drop_pin()

    def _on_picked(self, pin: Hover | None) -> None:
        self._pin, self._member = pin, self._session.member
        if pin is None:
            if self.card is not None:
                self.card.hide()
            return
        self._ask()

    def _ask(self) -> None:
        session, pin = self._session, self._pin
        if pin is None or session.pair is None:
            return
        name = pin.member or session.member
        results = {key: one for key, one in session.results.items() if key.member == name}
        member, solid = session.pair.member(name), self._solid_of(pin)
        self._newest.request(pin, lambda: _values(results, member, pin, solid))

    def _solid_of(self, pin: Hover) -> Built | None:
        mode = self._solid_mode
        return next((mode.solids.built.get(key) for key in mode.keys if key.member == pin.member), None)

    def _on_done(self, pin: Hover, values: PickedValues) -> None:
        if pin is self._pin and self.card is not None and self._grid is not None:
            self.card.show_values(pin, values, float(self._grid.overlays.pins[0].geometry().center().y()))

    def _on_failed(self, text: str) -> None:
        self._window.messages.show_message("error", text, topic="pick")


def _values(
    results: Mapping[Key, VariantResult], member: MemberGeometry, pin: Hover, solid: Built | None
) -> PickedValues:
    import numpy as np

    from gearstudio.analysis.probe import probe, theory_at
    from gearstudio.theory.cones import pair_geometry
    from gearstudio.theory.modified import flank_of

    azimuth = float(np.degrees(np.arctan2(pin.xyz[1], pin.xyz[0])))
    if not pin.side:
        return PickedValues(azimuth, {}, None)
    name: FlankName = "concave" if pin.side == "concave" else "convex"
    flank, delta = flank_of(member, name), float(np.radians(pin.delta_deg))
    found = {key: probe(one.flanks[name].surface, flank, pin.rho, delta) for key, one in results.items()}
    of_solid = None
    if solid is not None:
        own = flank_of(pair_geometry(solid.design).member(pin.member), name)
        faces = [face for face in solid.result.faces if face.kind == "flank" and face.side == own.side]
        of_solid = probe(faces[0].surface, own, pin.rho, delta) if faces else None
    return PickedValues(azimuth, found, theory_at(flank, pin.rho, delta), of_solid)
