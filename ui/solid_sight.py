"""The solids in the views: drawn, turned, cut, pointed at and measured; made when the views are there."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer

from ui.solid_measure import SolidMeasure
from ui.solid_pointer import SolidPointer
from ui.solid_stage import Motion, SolidStage
from ui.solid_view import SolidView
from ui.solid_words import titles

if TYPE_CHECKING:
    from ui.camera import Camera
    from ui.main_window import MainWindow
    from ui.picking import Hover
    from ui.session import Key, Session
    from ui.solid_workshop import Order
    from ui.solids import Solids

STILL_MS = 160
Look = tuple["Camera", str]


class SolidSight(QObject):
    """Shows in a window's views the solids that ``keys`` names: one gear, two in mesh, or none beside the flanks."""

    def __init__(
        self,
        session: Session,
        window: MainWindow,
        solids: Solids,
        keys: Callable[[], tuple[Key, ...]],
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        area = window.area
        assert area.grid is not None and area.color_bar is not None
        assert area.mesh_bar is not None and area.roll_slider is not None
        self._session, self._window, self._solids, self._keys = session, window, solids, keys
        self._panel, self._grid, self._color_bar = window.solid_panel, area.grid, area.color_bar
        self._mesh_bar, self._roll_slider = area.mesh_bar, area.roll_slider
        self._flank_look: Look | None = None
        self._to_look: Look | None = None
        self._to_fit = True
        self._fitted: Camera | None = None
        self._motion: Motion = ""
        self._still = QTimer(self, singleShot=True, interval=STILL_MS)
        self._still.timeout.connect(self._on_still)
        self.view = SolidView(self._grid)
        self.stage = SolidStage(self.view, lambda: titles(solids, keys()), self)
        self.stage.changed.connect(self._on_shown)
        say = window.messages.show_message
        self.stage.failed.connect(lambda text, details: say("error", text, details, topic="solid"))
        self.measuring = SolidMeasure(self.view, self._panel.show_measure, self)
        self._pointer = SolidPointer(self.view, self._on_pointed, self)
        self._connect()
        self.begin()

    def _connect(self) -> None:
        panel = self._panel
        panel.looks_changed.connect(self.show)
        panel.section.changed.connect(self._on_section)
        panel.section.side_wanted.connect(self.choose_side)
        panel.measure_switched.connect(self._switch_measuring)
        panel.units_shown.connect(self.measuring.show_units)
        panel.snapping.toggled.connect(self.measuring.set_snapping)
        self._mesh_bar.turned.connect(self._on_turned)
        self._grid.viewport.drawing.connect(self._on_drawing)

    def close(self) -> None:
        """Stop what moves and let the thread end."""
        self._still.stop()
        self.stage.close()

    # ---- what is to be seen ----------------------------------------------------------------------------

    def begin(self) -> None:
        """Solids of another kind are to be seen, or none: nothing of what was under way is put up any more."""
        self._to_fit = True
        self._switch_measuring(self._panel.measuring)
        self.stage.forget()
        self._roll_slider.pause()
        self._roll_slider.setVisible(not self._keys())
        self._mesh_bar.pause()
        self._mesh_bar.setVisible(self._in_mesh)

    def fit_next(self) -> None:
        """Show the next solids whole."""
        self._to_fit = True

    def show(self) -> None:
        """Show the solids as they are now, soon."""
        pair, keys = self._session.pair, self._keys()
        if pair is not None and keys:
            self._mesh_bar.set_pair(pair.pinion.teeth, pair.wheel.teeth)
            self.stage.show(pair, keys, self._solids.built, self._panel, self._motion)

    def leave_flanks(self) -> None:
        """Remember from where one looked at the flanks."""
        self._flank_look = self._grid.keep_view()
        self._grid.pointing.drop_pin()

    def leave_solids(self, show_flanks: Callable[[], None]) -> None:
        """Make room for the flanks, and look at them from where one did."""
        self.view.close()
        self._pointer.show_solids({})
        self._color_bar.show()
        show_flanks()
        if self._flank_look is not None:
            self._grid.restore_view(self._flank_look)

    def keep_looks(self) -> tuple[Look, Look | None]:
        """From where one looks now, and from where one looked at the flanks; for `take_looks`."""
        return self._grid.keep_view(), self._flank_look

    def take_looks(self, looks: tuple[Look, Look | None]) -> None:
        """Look from there once the solids are in sight, and later at the flanks."""
        self._to_look, self._flank_look = looks

    def choose_side(self) -> None:
        """Take away the side of a section that one looks at."""
        section = self._panel.section
        section.set_side(1 if self._grid.viewport.look.back[section.axis] >= 0 else -1)

    @property
    def _in_mesh(self) -> bool:
        return len(self._keys()) > 1

    def _on_shown(self, order: Order, other_gears: bool) -> None:
        grid = self._grid
        if other_gears:
            self._to_fit = self._to_fit or grid.viewport.look is self._fitted
            self.measuring.clear()
        self._pointer.show_solids({key.member: built for key, built in order.built.items()})
        if (extent := self.view.extent(self._panel.section.axis)) is not None:
            self._panel.section.set_range(*extent)
        self._show_colors()
        if self._to_fit:
            self._to_fit = len(self.view.gears) < len(self._keys())
            grid.set_view("pair" if self._in_mesh else "iso")
            self._fitted = grid.viewport.look
        if self._to_look is not None:
            grid.restore_view(self._to_look)
            self._to_look = None

    def _show_colors(self) -> None:
        built, colored = self._solids.built, self._panel.deviation
        self._color_bar.setVisible(colored)
        self._color_bar.show_exaggeration(1)
        limits = [built[key].largest_um for key in self._keys() if key in built]
        if colored and limits:
            self._color_bar.set_data_limit(max(limits))

    # ---- turning, cutting, pointing, measuring ---------------------------------------------------------

    def _on_turned(self, degrees: float) -> None:
        if not self._in_mesh:
            return
        self._pointer.clear()
        if self._motion != "turning":
            self._motion = "turning"
            self.measuring.clear()
            if self.view.plane is not None:
                self.show()
        self.view.turn(math.radians(degrees))
        self._still.start()

    def _on_still(self) -> None:
        self._motion = ""
        if self.view.plane is not None:
            self.show()

    def _on_section(self) -> None:
        if self._keys():
            self._motion = "sliding"
            self._still.start()
            self._grid.viewport.set_moving()
            self.show()

    def _on_pointed(self, hover: Hover | None) -> None:
        self._window.status.show_hover(hover)
        if self._panel.deviation:
            self._color_bar.set_marker(None if hover is None else hover.deviation_um)

    def _on_drawing(self, _hurried: bool) -> None:
        self._mesh_bar.frame_ms = self._grid.viewport.frame_ms

    def _switch_measuring(self, on: bool) -> None:
        self.measuring.switch(on and bool(self._keys()))
        self._pointer.pins = not on
