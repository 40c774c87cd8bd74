"""The application: starts Qt, shows the window at once, then brings in the heavy parts one after the other."""

from __future__ import annotations

import argparse
import logging
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, QObject, QSettings, Qt, QTimer, Slot
from PySide6.QtGui import QGuiApplication, QSurfaceFormat
from PySide6.QtWidgets import QApplication

from ui.actions import TIP
from ui.collecting import Collector
from ui.controller import Controller
from ui.diagnostics import CrashCatcher, log_path, log_tail, note_fact, start_logging, versions
from ui.files import Files
from ui.graphics import MODES, advice, graphics_mode, prepare, probe
from ui.habits import Habits
from ui.judging import Judging
from ui.language import Language, chosen_language, meant
from ui.loading import Loader
from ui.main_window import MainWindow
from ui.messages import ReportDialog
from ui.preferences import LANGUAGES, Choices
from ui.projects.desk import Desk, data_folder
from ui.reading import Reading
from ui.session import Session
from ui.settings_file import open_settings, reset_settings
from ui.succession import succeed
from ui.theme import Theme, is_dark
from ui.upkeep import Upkeep
from ui.words import told, tr

if TYPE_CHECKING:
    from ui.inheritance import Inheritance
    from ui.runner import JobRunner

log = logging.getLogger(__name__)


def prepare_qt() -> None:
    """What must be set before there is an application: shared contexts, and a format that VTK can draw with."""
    QCoreApplication.setAttribute(Qt.ApplicationAttribute.AA_ShareOpenGLContexts)
    surface = QSurfaceFormat()
    surface.setRenderableType(QSurfaceFormat.RenderableType.OpenGL)
    surface.setProfile(QSurfaceFormat.OpenGLContextProfile.CoreProfile)
    surface.setVersion(3, 2)
    surface.setDepthBufferSize(24)
    surface.setStencilBufferSize(8)
    surface.setSamples(0)
    QSurfaceFormat.setDefaultFormat(surface)
    policy = Qt.HighDpiScaleFactorRoundingPolicy.PassThrough
    QGuiApplication.setHighDpiScaleFactorRoundingPolicy(policy)


def make_application(argv: Sequence[str]) -> QApplication:
    """The one QApplication, named for settings and log."""
    prepare_qt()
    application = QApplication([argv[0] if argv else "gearstudio"])
    application.setApplicationName("GearStudio")
    application.setOrganizationName("GearStudio")
    application.setDesktopFileName("gearstudio")
    QSettings.setDefaultFormat(QSettings.Format.IniFormat)  # one file of settings
    return application


class Studio(QObject):
    """A window with everything behind it; the heavy parts come after the first paint.

    ``data`` is the folder of recovery files and backups; without one there are none. ``graphics`` is a mode of
    `ui.graphics`.
    """

    def __init__(
        self,
        theme: Theme,
        settings: QSettings | None = None,
        design: str | None = None,
        data: Path | None = None,
        graphics: str = "auto",
        language: Language | None = None,
    ) -> None:
        super().__init__()
        self._theme, self._design, self._graphics = theme, design, graphics
        self._settings, self._data = settings, data
        self.language = language or Language(QApplication.instance())
        self._judging = Judging(self)
        self.session = Session(self, self._judging)
        self.loader = Loader(parent=self)
        self._dialogs: list[ReportDialog] = []
        self.loader.loaded.connect(self._on_loaded)
        self.loader.failed.connect(self._on_failed)
        self.loader.finished.connect(self._on_finished)
        self.make_window()
        chosen = self.habits.preferences.choices
        self._use_preferences(replace(Choices(), language=chosen.language), chosen)  # it speaks one already
        self.habits.preferences.changed.connect(self._use_preferences)
        self.window.first_painted.connect(self.loader.start)
        theme.changed.connect(self._on_theme_changed)
        theme.apply()
        self.window.restore_layout()

    def speak(self, language: str) -> None:
        """Take a new window with the words of another language in place of this one; everything else goes on."""
        if language == self.language.spoken:
            return
        for dialog in self._dialogs[:]:
            dialog.reject()
        succeed(self, language)

    def make_window(self, inheritance: Inheritance | None = None) -> None:
        """The window with all that belongs to it alone; it dies with the window."""
        session = self.session
        self.window = MainWindow(session, self._settings)
        self.files = Files(session, self.window, inheritance, Reading(self.window))
        self.controller = Controller(session, self.window, self.files, inheritance)
        autosave = inheritance.autosave if inheritance else None
        edits = self.controller.edits
        self.desk = Desk(session, self.window, self.files, edits, self._data, self.window, autosave)
        self.upkeep = Upkeep(self.window)
        self.habits = Habits(self.controller, self._theme, inheritance.preferences if inheritance else None)
        self._inherited_runner = inheritance.runner if inheritance else None
        self.window.closing.connect(self.end)
        self._connect_help()

    @Slot(str)
    def report_crash(self, report: str) -> None:
        """Tell the user of an unexpected error; the window goes on."""
        words = tr(
            "Something unexpected went wrong. The window goes on, and the design is still there: "
            "save it under a new name to be safe. The report below helps to mend the fault; it is "
            "also in {path}.",
            path=log_path(),
        )
        if not any(dialog.isVisible() for dialog in self._dialogs):
            self._show_report(tr("Unexpected error"), words, report)

    def _use_preferences(self, before: Choices, now: Choices) -> None:
        """What concerns neither form nor theme: when unsaved work is copied, and how much memory the CAD may have."""
        if self.desk.autosave is not None and now.autosave_seconds != before.autosave_seconds:
            self.desk.autosave.set_pause(now.autosave_seconds)
        if now.memory_limit_mb != before.memory_limit_mb:
            self.upkeep.memory.set_limit(now.memory_limit_mb)
        if now.language != before.language:
            QTimer.singleShot(0, self, lambda: self.speak(meant(self.habits.preferences.choices.language)))

    def end(self) -> None:
        """The window closes for good."""
        self._theme.changed.disconnect(self._on_theme_changed)
        self.loader.stop()
        self._judging.close()

    def _on_finished(self) -> None:
        self.desk.offer_recovery()
        self.habits.keys.entries()

    def _on_theme_changed(self, _tokens: object) -> None:
        self.controller.refresh_theme(is_dark())

    def _on_loaded(self, stage: str) -> None:
        log.info("loaded: %s", stage)
        if stage == "core":
            self._fill_presets()
            self.controller.begin(self._design)
            self._design = None
        elif stage == "worker":
            runner = self._inherited_runner or self._make_runner()
            self.controller.use_runner(runner)
            self.upkeep.use_runner(runner)
        elif stage == "views":
            self._make_views()
        elif stage == "charts":
            self.controller.charts_ready()

    def _make_runner(self) -> JobRunner:
        from ui.runner import JobRunner

        log_file = log_path().with_name("cad.log")
        return JobRunner(self, log=str(log_file) if log_file.parent.is_dir() else None)

    def _on_failed(self, stage: str, text: str, details: str) -> None:
        if stage == "views":
            self.window.area.placeholder.set_text(tr("The 3D view could not be loaded."), waiting=False)
        if stage == "charts":
            self.window.analysis.show_failure(tr("The analysis could not be loaded."))
        self.window.messages.show_message(
            "error", tr("A part of GearStudio could not be loaded: {text}", text=told(text)), details
        )

    def _make_views(self) -> None:
        from ui.color_bar import ColorBar
        from ui.mesh_bar import MeshBar
        from ui.roll_slider import RollSlider
        from ui.view_grid import ViewGrid

        found = probe(self._graphics)
        note_fact("Graphics", str(found))
        if found.problem:
            self.window.area.placeholder.set_text(advice(found, self._graphics), waiting=False)
            return
        grid = ViewGrid()
        grid.set_theme(is_dark())
        self.window.area.adopt(grid, ColorBar(), RollSlider(), MeshBar())
        self.controller.views_ready()

    def _fill_presets(self) -> None:
        from gearstudio.presets import PRESETS

        menu = self.window.commands.presets
        menu.setToolTipsVisible(True)
        for preset in PRESETS:
            action = menu.addAction(tr(preset.title))
            action.setToolTip(tr(preset.description))
            action.setStatusTip(tr(preset.description))
            action.setProperty(TIP, tr(preset.description))
            action.setObjectName(f"presets.{preset.key}")
            action.triggered.connect(lambda _checked=False, chosen=preset: self.files.open_preset(chosen))
            reset = self.window.commands.resets.addAction(tr(preset.title))
            reset.setObjectName(f"resets.{preset.key}")
            reset.setStatusTip(tr(preset.description))
            reset.triggered.connect(lambda _checked=False, chosen=preset: self.controller.edits.take_preset(chosen))

    def _connect_help(self) -> None:
        commands, clipboard = self.window.commands, QGuiApplication.clipboard()
        commands["about"].triggered.connect(self._show_about)
        commands["diagnostics"].triggered.connect(lambda: clipboard.setText(self._diagnostics()))
        commands["copy_table"].triggered.connect(lambda: clipboard.setText(self.window.table.text_table()))
        commands["copy_derived"].triggered.connect(lambda: clipboard.setText(self.window.derived.text_table()))

    def _show_about(self) -> None:
        words = (
            "<b>GearStudio</b><br>"
            + tr(
                "Spiral bevel gears from the exact spherical involute: three ways to model the tooth flanks, side by "
                "side, and how far each is from theory."
            )
            + "<br>Apache License 2.0"
        )
        self._show_report(tr("About GearStudio"), words, versions())

    def _diagnostics(self) -> str:
        draft = "\n".join(f"{field} = {value!r}" for field, value in self.session.draft.items())
        return f"{versions()}\n\n{draft}\n\n{log_tail()}"

    def _show_report(self, title: str, words: str, report: str) -> None:
        dialog = ReportDialog(title, words, report, self.window)
        dialog.finished.connect(lambda _result: self._dialogs.remove(dialog))
        self._dialogs.append(dialog)
        dialog.open()


def main(argv: Sequence[str] | None = None) -> int:
    """Open the window on a design (a file or ``preset:KEY``), or leave a picture of it with ``--demo DIR``.

    Returns
    -------
    int
        The exit status.
    """
    arguments = list(sys.argv[1:] if argv is None else argv)
    parser = argparse.ArgumentParser(prog="gearstudio", description="Desktop studio for spiral bevel gears")
    parser.add_argument("design", nargs="?", help="design file (.gear.toml), or preset:KEY")
    parser.add_argument("--demo", type=Path, metavar="DIR", help="save a picture of the window in DIR and leave")
    parser.add_argument("--graphics", choices=MODES, help="what draws the 3D views: software needs no graphics card")
    languages = [code for code, _ in LANGUAGES if code]
    parser.add_argument("--language", choices=languages, help="language of this window, whatever the preferences say")
    parser.add_argument("--reset-settings", action="store_true", help="forget layout, lists and preferences and leave")
    options = parser.parse_args(arguments)
    if options.reset_settings:
        kept = reset_settings()
        print(f"The settings are reset; the old ones are kept as {kept}" if kept else "There were no settings")
        return 0
    opened = open_settings()
    mode = graphics_mode(opened.settings, options.graphics)
    prepare(mode)
    application = make_application(sys.argv)
    collector = Collector(application)
    language = Language(application, chosen_language(opened.settings, options.language))
    start_logging()
    theme = Theme(application)
    if options.demo is not None:
        from ui.demo import run_and_leave

        return run_and_leave(options.demo, theme, options.design)
    studio = Studio(theme, opened.settings, options.design, data_folder(), mode, language)
    if opened.complaint:
        studio.window.messages.show_message("warning", opened.complaint, topic="settings")
    studio.loader.finished.connect(collector.begin)
    if options.design is None:
        studio.loader.finished.connect(lambda: studio.controller.help.tour.offer())
    catcher = CrashCatcher(application)
    catcher.crashed.connect(studio.report_crash, Qt.ConnectionType.QueuedConnection)  # errors come while painting too
    catcher.install()
    studio.window.show()
    return application.exec()
