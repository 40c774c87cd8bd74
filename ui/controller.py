"""The only place that connects: what the user does to the session, and the session to what is shown."""

from __future__ import annotations

import logging
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal

from ui.analysis.presenter import AnalysisPresenter
from ui.applicability import derived_hints
from ui.blanks import Blanks
from ui.builds import Builds
from ui.edits import Edits
from ui.exporting import Exporting
from ui.help.desk import HelpDesk
from ui.kernel_messages import KernelMessages
from ui.presenter import Presenter, view_title
from ui.reporting.reporting import Reporting
from ui.session import Key, Session
from ui.solid_mode import SolidMode
from ui.views.display import Display
from ui.words import told, tr

if TYPE_CHECKING:
    from ui.files import Files
    from ui.inheritance import Inheritance
    from ui.main_window import MainWindow
    from ui.runner import JobRunner

log = logging.getLogger(__name__)


class Controller(QObject):
    """Wires a window to a session.

    The heavy parts are handed in when they are loaded, in this order: the core (:meth:`begin`), the CAD
    process (:meth:`use_runner`), the views (:meth:`views_ready`).

    Signals
    -------
    settled()
        Nothing of the chosen member remains to be built.
    """

    settled = Signal()

    def __init__(
        self, session: Session, window: MainWindow, files: Files, inheritance: Inheritance | None = None
    ) -> None:
        super().__init__(window)
        self.session, self.window, self.files = session, window, files
        self.succeeded = False
        self.worker_state = inheritance.worker_state if inheritance else ("starting", "")
        self.edits = Edits(session, window, self, inheritance.history if inheritance else None)
        self.builds = inheritance.builds if inheritance else Builds(session)
        self.builds.setParent(self)
        self.presenter = Presenter(session, window.area, self)
        self.analysis = AnalysisPresenter(session, window.analysis, self)
        self.blanks = Blanks(session, window.form, self)
        self.solid_mode = SolidMode(session, window, self.presenter, self, inheritance.solids if inheritance else None)
        self.display = Display(session, window, self.presenter, self.solid_mode, self)
        self.reporting = Reporting(session, window, self.solid_mode, self)
        self.exporting = Exporting(files, window.messages, self)
        self.help = HelpDesk(session, window)
        self.kernel_messages = KernelMessages(window.messages, self)
        self.runner: JobRunner | None = None
        self._connect_form()
        self._connect_selection()
        self._connect_results()
        self._connect_commands()
        self._on_selection_changed()
        self._on_document_changed()

    # ---- heavy parts arrive --------------------------------------------------------------------------

    def begin(self, name: str | None = None) -> None:
        """The core is loaded: judge the default design, or open a file."""
        self.window.layer_panel.fill()
        if self.session.pair is None:
            self.session.restore(self.session.draft)
        else:
            self.session.announce()
        if name is not None:
            self.files.open_named(name)

    def use_runner(self, runner: JobRunner) -> None:
        """The CAD process can be started."""
        self.runner = runner
        self.kernel_messages.use(runner)
        self._on_worker_state_changed(*self.worker_state)
        runner.worker_state_changed.connect(self._on_worker_state_changed)
        self.builds.use(runner)
        self.builds.announce()
        self.solid_mode.use_runner(runner)
        self.analysis.use_runner(runner)
        self.reporting.use_runner(runner)
        self.exporting.use_runner(runner)
        runner.start()
        self.builds.build_missing()

    def views_ready(self) -> None:
        """The window has its views now."""
        area, panel = self.window.area, self.window.layer_panel
        grid, bar, slider = area.grid, area.color_bar, area.roll_slider
        assert grid is not None and bar is not None and slider is not None
        grid.hovered.connect(self._on_hovered)
        bar.range_changed.connect(self.presenter.apply_color_range)
        slider.rolled.connect(self.presenter.set_roll)
        self.window.commands.fill_layers()
        self.window.commands.layers.triggered.connect(lambda a: grid.set_layer_visible(a.data(), a.isChecked()))
        panel.layer_switched.connect(grid.set_layer_visible)
        panel.set_chosen.connect(grid.set_visible_layers)
        grid.visible_changed.connect(self._show_layers)
        self._show_layers()
        self.window.commands.views.triggered.connect(lambda action: grid.set_view(action.data()))
        self.display.views_ready()
        self.presenter.redraw()
        self.solid_mode.views_ready()

    def charts_ready(self) -> None:
        """The charts' library is loaded."""
        self.analysis.use_charts()

    def refresh_theme(self, dark: bool) -> None:
        """The colours have changed."""
        self.window.refresh_theme()
        if self.window.area.grid is not None:
            self.window.area.grid.set_theme(dark)

    def close(self) -> None:
        """Let go of the window; end the work in progress and the CAD process, unless another window goes on with it."""
        self.presenter.close()
        self.solid_mode.close()
        self.reporting.close()
        if self.succeeded:
            return
        self.builds.pause.cancel()
        self.solid_mode.solids.close()
        if self.runner is not None:
            self.runner.close()

    # ---- wiring --------------------------------------------------------------------------------------

    def _connect_form(self) -> None:
        session, window = self.session, self.window
        session.issues_changed.connect(window.form.show_issues)
        session.design_changed.connect(self._on_design_changed)
        session.document_changed.connect(self._on_document_changed)
        self.files.opened.connect(self.edits.clear)
        self.files.opened.connect(self._on_document_changed)

    def _connect_selection(self) -> None:
        session, bar, commands = self.session, self.window.method_bar, self.window.commands
        bar.member_chosen.connect(lambda member: session.select(member=member))
        bar.method_chosen.connect(lambda method: session.select(method=method))
        bar.variant_chosen.connect(lambda variant: session.select(variant=variant))
        self.window.table.row_chosen.connect(lambda method, variant: session.select(method=method, variant=variant))
        commands.members.triggered.connect(lambda action: session.select(member=action.data()))
        commands.methods.triggered.connect(lambda action: session.select(method=action.data()))
        commands.variants.triggered.connect(lambda action: session.select(variant=action.data()))
        commands.flanks.triggered.connect(lambda action: self.presenter.set_flank(action.data()))
        commands.modes.triggered.connect(lambda action: self.solid_mode.set_mode(action.data()))
        session.selection_changed.connect(self._on_selection_changed)

    def _connect_results(self) -> None:
        self.session.results_changed.connect(self._on_results_changed)
        self.analysis.said.connect(lambda kind, text: self.window.messages.show_message(kind, text, topic="analysis"))
        self.builds.work_changed.connect(self._on_work_changed)
        self.window.status.cancel_requested.connect(self._cancel)

    def _connect_commands(self) -> None:
        window, files, commands = self.window, self.files, self.window.commands
        handlers = {
            "new": files.new,
            "open": files.open,
            "save": files.save,
            "save_as": files.save_as,
            "export": files.export,
            "report": self.reporting.open,
            "screenshot": self.display.take_picture,
            "film": self.display.make_film,
            "quit": window.close,
            "build_gear": lambda: self.solid_mode.build("gear"),
            "build_pair": lambda: self.solid_mode.build("pair"),
            "rebuild": self.builds.rebuild,
            "cancel": self._cancel,
            "restart": self._restart,
            "reset_layout": window.reset_layout,
        }
        for name, handler in handlers.items():
            commands[name].triggered.connect(lambda _checked=False, run=handler: run())
        window.design_dropped.connect(files.open_path)
        window.may_close = files.may_discard
        window.closing.connect(self.close)
        commands["cancel"].setEnabled(False)

    # ---- what the user does --------------------------------------------------------------------------

    def _cancel(self) -> None:
        self.builds.pause.cancel()
        if self.runner is not None:
            self.runner.cancel()

    def _restart(self) -> None:
        if self.runner is not None:
            self.runner.restart()

    # ---- what is shown -------------------------------------------------------------------------------

    def _on_design_changed(self, design: object) -> None:
        session, window = self.session, self.window
        assert session.pair is not None
        window.derived.show_pair(session.pair)
        window.form.set_hints(derived_hints(session.design, session.pair))
        self.presenter.redraw_soon()
        window.table.refresh()
        self.builds.build_soon()

    def _on_selection_changed(self) -> None:
        session, window = self.session, self.window
        window.method_bar.show_selection(session.member, session.method, session.variant)
        window.commands.show_selection(session.member, session.method, session.variant)
        window.table.mark(session.method, session.variant)
        self.presenter.redraw_soon()
        self.builds.build_missing()
        self.solid_mode.follow_selection()

    def _on_results_changed(self, key: Key | None) -> None:
        session = self.session
        self.window.table.refresh()
        if key is None or key in session.visible_keys:
            self.presenter.redraw_soon()
        failed = [k for k in session.visible_keys if k in session.failures and not session.failures[k].cancelled]
        if key in failed:
            failure = session.failures[key]
            text = tr("{view}: {problem}", view=view_title(key), problem=told(failure.message))
            self.window.messages.show_message("error", text, failure.details, topic="build")
        elif not failed:
            self.window.messages.clear("build")
        if not session.missing_keys():
            self.settled.emit()

    def _on_work_changed(self, text: str | None, fraction: float) -> None:
        self.window.status.show_work(text, fraction)
        self.window.commands["cancel"].setEnabled(text is not None)

    def _on_worker_state_changed(self, state: str, reason: str) -> None:
        log.info("CAD process: %s %s", state, reason)
        self.worker_state = (state, reason)
        self.window.status.show_worker(state)
        self.kernel_messages.show_state(state, reason)

    def _show_layers(self) -> None:
        grid = self.window.area.grid
        assert grid is not None
        self.window.layer_panel.show_visible(grid.visible_layers)
        self.window.commands.show_layers(grid.visible_layers)

    def _on_hovered(self, hover: Any) -> None:
        self.window.status.show_hover(hover)
        if self.window.area.color_bar is not None:
            self.window.area.color_bar.set_marker(None if hover is None else hover.value)

    def _on_document_changed(self) -> None:
        self.window.show_document(self.session.title, self.session.unsaved)
