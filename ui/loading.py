"""Imports what is heavy in a thread, after the window has been painted.

``module:function`` is also called, so that what it keeps is there when it is wanted.
"""

from __future__ import annotations

import importlib
import logging
import threading
import traceback
from collections.abc import Mapping, Sequence

from PySide6.QtCore import QObject, Qt, Signal, Slot

STAGES: Mapping[str, tuple[str, ...]] = {
    "core": ("gearstudio.validation", "gearstudio.theory.cones", "gearstudio.project", "ui.sentences:templates"),
    "worker": ("gearstudio.jobs", "ui.runner"),
    "views": (
        "pyvista",
        "vtkmodules.vtkRenderingOpenGL2",
        "pyvistaqt",
        "ui.scene",
        "ui.color_bar",
        "ui.roll_slider",
        "ui.mesh_bar",
        "ui.solid_measure",
        "ui.solid_pointer",
        "ui.solid_stage",
        "ui.view_grid",
    ),
    "charts": ("pyqtgraph", "ui.analysis.pages"),
}
QT = ("QtCore", "QtGui", "QtWidgets", "QtSvg", "QtOpenGL", "QtOpenGLWidgets", "QtTest")
"""Modules of Qt that the stages need."""

_SPARE = 400
log = logging.getLogger(__name__)


def make_qt_classes() -> None:
    """Have all classes of Qt made now, to be called in the window's thread.

    Each is made when it is first asked for, and the library that binds Python to Qt notes it in a table, which the
    window's thread reads without the interpreter's lock whenever Qt asks an object for its class. When the imports made
    hundreds of classes in their thread, the table was moved under the reader now and then, and the program ended.
    Spare classes, which go at once, make room in it for those that the window derives: it never shrinks.
    """
    for name in QT:
        __import__(f"PySide6.{name}", None, None, ("*",), 0)
    for number in range(_SPARE):
        type(f"Spare{number}", (QObject,), {})


class Loader(QObject):
    """Imports modules in stages; its signals come in the thread that it lives in.

    Signals
    -------
    loaded(str)
        A stage is complete.
    failed(str, str, str)
        Stage, a line for the user, and the traceback.
    finished()
        Every stage was tried.
    """

    loaded = Signal(str)
    failed = Signal(str, str, str)
    finished = Signal()
    _imported = Signal(str)
    _broke = Signal(str, str, str)
    _ended = Signal()

    def __init__(self, stages: Mapping[str, Sequence[str]] = STAGES, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._stages = stages
        self._told: list[tuple[str, ...]] = []
        self.has_finished = False
        self._thread = threading.Thread(target=self._run, name="imports", daemon=True)
        self._stop = threading.Event()
        self._imported.connect(self._on_imported, Qt.ConnectionType.QueuedConnection)
        self._broke.connect(self._on_broke, Qt.ConnectionType.QueuedConnection)
        self._ended.connect(self._on_ended, Qt.ConnectionType.QueuedConnection)

    @Slot()
    def start(self) -> None:
        """Begin."""
        make_qt_classes()
        self._thread.start()

    def stop(self) -> None:
        """Ask it to end after the module it is at, and wait for that; no signal comes afterwards."""
        self._stop.set()
        if self._thread.is_alive():
            self._thread.join()

    def tell_again(self) -> None:
        """Tell once more what has been loaded and what has failed, for a window that has just been made."""
        for stage, *trouble in self._told:
            if trouble:
                self.failed.emit(stage, *trouble)
            else:
                self.loaded.emit(stage)

    def _run(self) -> None:
        for stage, modules in self._stages.items():
            try:
                for module in modules:
                    if self._stop.is_set():
                        return
                    name, _, function = module.partition(":")
                    found = importlib.import_module(name)
                    if function:
                        getattr(found, function)()
            except Exception as error:
                log.exception("importing %s failed", stage)
                self._broke.emit(stage, f"{type(error).__name__}: {error}", traceback.format_exc())
                continue
            self._imported.emit(stage)
        self._ended.emit()

    @Slot(str)
    def _on_imported(self, stage: str) -> None:
        if not self._stop.is_set():
            self._told.append((stage,))
            self.loaded.emit(stage)

    @Slot(str, str, str)
    def _on_broke(self, stage: str, text: str, details: str) -> None:
        if not self._stop.is_set():
            self._told.append((stage, text, details))
            self.failed.emit(stage, text, details)

    @Slot()
    def _on_ended(self) -> None:
        if not self._stop.is_set():
            self.has_finished = True
            self.finished.emit()
