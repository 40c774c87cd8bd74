"""The solid mode of the window: which solids there are to be, and what their panel says; its state is the mode."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from PySide6.QtCore import QObject, QTimer, Signal

from ui.session import ALL, Key, Session
from ui.solid_words import state
from ui.solids import Solids

if TYPE_CHECKING:
    from ui.main_window import MainWindow
    from ui.presenter import Presenter
    from ui.runner import JobRunner
    from ui.solid_sight import Look, SolidSight

Mode = Literal["flanks", "gear", "pair"]
PAIR = ("pinion", "wheel")
REDRAW_PAUSE_MS = 15


class SolidMode(QObject):
    """Has whole gears made and shown while the mode is not ``flanks``; in ``sight`` once there are views.

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
        self.sight: SolidSight | None = None
        self._leaving = QTimer(self, singleShot=True, interval=0)
        self._leaving.timeout.connect(self._show_flanks)
        self._redraw = QTimer(self, singleShot=True, interval=REDRAW_PAUSE_MS)
        self._redraw.timeout.connect(self.redraw)
        self._panel.build_requested.connect(self.solids.build)
        self._panel.automatic_switched.connect(self.solids.set_automatic)
        self._panel.construction_chosen.connect(self.solids.set_construction)
        self.solids.changed.connect(self.redraw_soon)

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
        from ui.solid_sight import SolidSight

        self.sight = SolidSight(self._session, self._window, self.solids, lambda: self.keys, self)
        self.redraw()

    def close(self) -> None:
        """Stop what moves and let the thread of this window end; the solids may go on in another window."""
        self._redraw.stop()
        self._leaving.stop()
        if self.sight is not None:
            self.sight.close()

    # ---- mode ------------------------------------------------------------------------------------------

    def keep_state(self) -> tuple[Mode, tuple[Look, Look | None] | None]:
        """Mode, and where one looks from; for `take_state`."""
        return self.mode, None if self.sight is None else self.sight.keep_looks()

    def take_state(self, state: tuple[Mode, tuple[Look, Look | None] | None]) -> None:
        """Be in the mode of another window, and look from there once the solids are in sight."""
        mode, looks = state
        self.set_mode(mode)
        if mode != "flanks" and looks is not None and self.sight is not None:
            self.sight.take_looks(looks)

    def set_mode(self, mode: Mode) -> None:
        """Show flanks, one gear or the pair."""
        if mode == self.mode:
            return
        before, self.mode = self.mode, mode
        sight = self.sight
        if before == "flanks" and sight is not None:
            sight.leave_flanks()
        self._presenter.active = mode == "flanks"
        self._window.show_solid_mode(mode != "flanks")
        self._window.commands.show_mode(mode)
        self.follow_selection()
        if sight is not None:
            sight.begin()
        if mode == "flanks":
            self._leaving.start()
        else:
            self._leaving.stop()
            self._panel.section.set_axis("y", 0.0)
            if sight is not None:
                sight.choose_side()
            self.redraw_soon()
        self.mode_changed.emit(mode)

    def build(self, mode: Mode) -> None:
        """Show a gear or the pair, and build what of it is not current."""
        self.set_mode(mode)
        self.solids.build()

    def _show_flanks(self) -> None:
        if self.sight is not None:
            self.sight.leave_solids(self._presenter.redraw)

    def follow_selection(self) -> None:
        """Member, method or variant may be another: ask for its solids; a solid is of one method."""
        bar, session, solid = self._window.method_bar, self._session, self.mode != "flanks"
        bar.methods.button(ALL).setEnabled(not solid)
        bar.members.setEnabled(self.mode != "pair")
        bar.show_selection(session.member, session.visible_methods[0] if solid else session.method, session.variant)
        if self.sight is not None and self.mode == "gear" and self.keys != self.solids.wanted:
            self.sight.fit_next()
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
        built = self.solids.built
        self._panel.show_state(*state(self.solids, self.keys))
        self._panel.properties.show_results({k.member: built[k].result if k in built else None for k in self.keys})
        if self.sight is not None:
            self.sight.show()
