"""The solid mode of the window: connects solids, views, panel and animation; its state is the mode."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Literal

from PySide6.QtCore import QObject, QTimer, Signal

from ui.session import ALL, Key, Session
from ui.solid_words import state, titles
from ui.solids import Solids

if TYPE_CHECKING:
    from ui.camera import Camera
    from ui.main_window import MainWindow
    from ui.picking import Hover
    from ui.presenter import Presenter
    from ui.runner import JobRunner
    from ui.solid_measure import SolidMeasure
    from ui.solid_pointer import SolidPointer
    from ui.solid_stage import Motion, SolidStage
    from ui.solid_view import SolidView
    from ui.solid_workshop import Order

Mode = Literal["flanks", "gear", "pair"]
PAIR = ("pinion", "wheel")
STILL_MS = 160
REDRAW_PAUSE_MS = 15


class SolidMode(QObject):
    """Shows whole gears in the views while the mode is not ``flanks``.

    Signals
    -------
    mode_changed(str)
    """

    mode_changed = Signal(str)

    def __init__(
        self,
        session: Session,
        window: MainWindow,
        presenter: Presenter,
        parent: QObject,
        solids: Solids | None = None,
    ) -> None:
        super().__init__(parent)
        self._session, self._window, self._presenter = session, window, presenter
        self._panel = window.solid_panel
        self.solids = solids or Solids(session)
        self.solids.setParent(self)
        self.mode: Mode = "flanks"
        self.view: SolidView | None = None
        self._stage: SolidStage | None = None
        self.measuring: SolidMeasure | None = None
        self.pointer: SolidPointer | None = None
        self._flank_view: tuple[Camera, str] | None = None
        self._to_look: tuple[Camera, str] | None = None
        self._to_fit = False
        self._motion: Motion = ""
        self._fitted: Camera | None = None
        self._leaving = QTimer(self, singleShot=True, interval=0)
        self._leaving.timeout.connect(self._show_flanks)
        self._redraw = QTimer(self, singleShot=True, interval=REDRAW_PAUSE_MS)
        self._redraw.timeout.connect(self.redraw)
        self._still = QTimer(self, singleShot=True, interval=STILL_MS)
        self._still.timeout.connect(self._on_still)
        self._panel.build_requested.connect(self.solids.build)
        self._panel.automatic_switched.connect(self.solids.set_automatic)
        self._panel.construction_chosen.connect(self.solids.set_construction)
        self._panel.looks_changed.connect(self.redraw)
        self._panel.section.changed.connect(self._on_section)
        self._panel.section.side_wanted.connect(self._choose_side)
        self._panel.measure_switched.connect(self._on_measure)
        self.solids.changed.connect(self.redraw_soon)
        session.design_changed.connect(self.redraw_soon)

    @property
    def keys(self) -> tuple[Key, ...]:
        """The solids in sight."""
        if self.mode == "flanks":
            return ()
        members = PAIR if self.mode == "pair" else (self._session.member,)
        return tuple(Key(member, self._session.visible_methods[0], self._session.variant) for member in members)

    def use_runner(self, runner: JobRunner) -> None:
        """The CAD process can be started."""
        self.solids.use(runner)

    def views_ready(self) -> None:
        """The window has its views now."""
        from ui.solid_measure import SolidMeasure
        from ui.solid_pointer import SolidPointer
        from ui.solid_stage import SolidStage
        from ui.solid_view import SolidView

        area = self._window.area
        assert area.grid is not None and area.mesh_bar is not None
        self.view = SolidView(area.grid)
        self._stage = SolidStage(self.view, lambda: titles(self.solids, self.keys), self)
        self._stage.changed.connect(self._on_shown)
        say = self._window.messages.show_message
        self._stage.failed.connect(lambda text, details: say("error", text, details, topic="solid"))
        self.measuring = SolidMeasure(self.view, self._panel.show_measure, self)
        self._panel.units_shown.connect(self.measuring.show_units)
        self._panel.snapping.toggled.connect(self.measuring.set_snapping)
        self.pointer = SolidPointer(self.view, self._on_pointed, self)
        area.mesh_bar.turned.connect(self._on_turned)
        area.grid.viewport.drawing.connect(self._on_drawing)
        self._show_mode()
        if self.mode != "flanks":
            self.redraw()

    def close(self) -> None:
        """Stop what moves and let the thread of this window end; the solids may go on in another window."""
        for timer in (self._still, self._redraw, self._leaving):
            timer.stop()
        if self._stage is not None:
            self._stage.close()

    # ---- mode ------------------------------------------------------------------------------------------

    def keep_state(self) -> tuple[Mode, tuple[Camera, str] | None, tuple[Camera, str] | None]:
        """Mode, where one looks from now, and where one looked at the flanks from; for `take_state`."""
        now = None if self.view is None else self.view.grid.keep_view()
        return self.mode, now, self._flank_view

    def take_state(self, state: tuple[Mode, tuple[Camera, str] | None, tuple[Camera, str] | None]) -> None:
        """Be in the mode of another window, and look from there once the solids are in sight."""
        mode, now, flanks = state
        self.set_mode(mode)
        if mode != "flanks":
            self._flank_view, self._to_look = flanks, now

    def set_mode(self, mode: Mode) -> None:
        """Show flanks, one gear or the pair."""
        if mode == self.mode:
            return
        before, self.mode = self.mode, mode
        if before == "flanks" and self.view is not None:
            self._flank_view = self.view.grid.keep_view()
            self.view.grid.pointing.drop_pin()
        self._to_fit = True
        self._presenter.active = mode == "flanks"
        self._show_mode()
        self.follow_selection()
        if self.measuring is not None:
            self.measuring.clear()
        if self._stage is not None:
            self._stage.forget()
        if mode == "flanks":
            self._leaving.start()
        else:
            self._leaving.stop()
            self._panel.section.set_axis("y", 0.0)
            self._choose_side()
            self.redraw_soon()
        self.mode_changed.emit(mode)

    def build(self, mode: Mode) -> None:
        """Show a gear or the pair, and build what of it is not current."""
        self.set_mode(mode)
        self.solids.build()

    def _show_flanks(self) -> None:
        if self.view is None or self.pointer is None:
            return
        self.view.close()
        self.pointer.show_solids({})
        if self._window.area.color_bar is not None:
            self._window.area.color_bar.show()
        self._presenter.redraw()
        if self._flank_view is not None:
            self.view.grid.restore_view(self._flank_view)

    def _show_mode(self) -> None:
        window, solid = self._window, self.mode != "flanks"
        window.show_solid_mode(solid)
        window.commands.show_mode(self.mode)
        if self.measuring is not None:
            self._on_measure(self._panel.measuring)
        area = window.area
        if area.roll_slider is not None and area.mesh_bar is not None:
            area.roll_slider.pause()
            area.roll_slider.setVisible(not solid)
            area.mesh_bar.pause()
            area.mesh_bar.setVisible(self.mode == "pair")

    def follow_selection(self) -> None:
        """Member, method or variant may be another: ask for its solids; a solid is of one method."""
        bar, session, solid = self._window.method_bar, self._session, self.mode != "flanks"
        bar.methods.button(ALL).setEnabled(not solid)
        bar.members.setEnabled(self.mode != "pair")
        bar.show_selection(session.member, session.visible_methods[0] if solid else session.method, session.variant)
        self._to_fit = self._to_fit or (self.mode == "gear" and self.keys != self.solids.wanted)
        self.solids.want(self.keys)
        self.redraw_soon()

    # ---- drawing ---------------------------------------------------------------------------------------

    def redraw_soon(self) -> None:
        """Several things may change at once; draw them together."""
        if self.mode != "flanks" and not self._redraw.isActive():
            self._redraw.start()

    def redraw(self) -> None:
        """Show the solids as they are now."""
        self._redraw.stop()
        if self.mode == "flanks" or self._session.pair is None:
            return
        self._show_panel()
        if self._stage is not None:
            self._stage.show(self._session.pair, self.keys, self.solids.built, self._panel, self._motion)

    def _on_shown(self, order: Order, other_gears: bool) -> None:
        assert self.view is not None
        grid = self.view.grid
        if other_gears:
            self._to_fit = self._to_fit or grid.viewport.look is self._fitted
            if self.measuring is not None:
                self.measuring.clear()
        if self.pointer is not None:
            self.pointer.show_solids({key.member: built for key, built in order.built.items()})
        if (extent := self.view.extent(self._panel.section.axis)) is not None:
            self._panel.section.set_range(*extent)
        self._show_colors()
        if self._to_fit:
            self._to_fit = len(self.view.gears) < len(self.keys)
            grid.set_view("pair" if self.mode == "pair" else "iso")
            self._fitted = grid.viewport.look
        if self._to_look is not None:
            grid.restore_view(self._to_look)
            self._to_look = None

    def _show_panel(self) -> None:
        built = self.solids.built
        self._panel.show_state(*state(self.solids, self.keys))
        self._panel.properties.show_results({k.member: built[k].result if k in built else None for k in self.keys})
        bar, pair = self._window.area.mesh_bar, self._session.pair
        if bar is not None and pair is not None:
            bar.set_pair(pair.pinion.teeth, pair.wheel.teeth)

    def _show_colors(self) -> None:
        color_bar, colored = self._window.area.color_bar, self._panel.deviation
        if color_bar is not None:
            color_bar.setVisible(colored)
            color_bar.show_exaggeration(1)
            limits = [self.solids.built[key].largest_um for key in self.keys if key in self.solids.built]
            if colored and limits:
                color_bar.set_data_limit(max(limits))

    # ---- turning, cutting, measuring -------------------------------------------------------------------

    def _on_turned(self, degrees: float) -> None:
        if self.mode != "pair" or self.view is None:
            return
        if self.pointer is not None:
            self.pointer.clear()
        if self._motion != "turning":
            self._motion = "turning"
            if self.measuring is not None:
                self.measuring.clear()
            if self.view.plane is not None:
                self.redraw()
        self.view.turn(math.radians(degrees))
        self._still.start()

    def _on_still(self) -> None:
        self._motion = ""
        if self.view is not None and self.view.plane is not None:
            self.redraw()

    def _on_pointed(self, hover: Hover | None) -> None:
        self._window.status.show_hover(hover)
        if self._window.area.color_bar is not None and self._panel.deviation:
            self._window.area.color_bar.set_marker(None if hover is None else hover.deviation_um)

    def _on_drawing(self, _hurried: bool) -> None:
        if self._window.area.mesh_bar is not None and self.view is not None:
            self._window.area.mesh_bar.frame_ms = self.view.grid.viewport.frame_ms

    def _on_section(self) -> None:
        if self.view is not None and self.mode != "flanks":
            self._motion = "sliding"
            self._still.start()
            self.view.grid.viewport.set_moving()
            self.redraw()

    def _choose_side(self) -> None:
        """Take away the side that one looks at."""
        if self.view is not None:
            self._panel.section.set_side(1 if self.view.grid.viewport.look.back[self._panel.section.axis] >= 0 else -1)

    def _on_measure(self, on: bool) -> None:
        if self.measuring is not None and self.pointer is not None:
            self.measuring.switch(on and self.mode != "flanks")
            self.pointer.pins = not on
