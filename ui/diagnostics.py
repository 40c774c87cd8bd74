"""Where things went wrong and with which versions: log file, crash reports, versions."""

from __future__ import annotations

import logging
import logging.handlers
import platform
import sys
import threading
import traceback
from pathlib import Path
from types import TracebackType

from PySide6.QtCore import QObject, QStandardPaths, QtMsgType, Signal, qInstallMessageHandler, qVersion
from PySide6.QtGui import QGuiApplication

import gearstudio

PACKAGES = (
    "PySide6-Essentials",
    "vtk",
    "pyvista",
    "pyvistaqt",
    "pyqtgraph",
    "build123d",
    "cadquery-ocp-novtk",
    "numpy",
    "scipy",
    "pydantic",
    "typst",
)
HARMLESS = ("Setting a new default format", "propagateSizeHints")
LOG_SIZE = 500_000
log = logging.getLogger(__name__)
_facts: dict[str, str] = {}


def note_fact(name: str, value: str) -> None:
    """Remember something found out while the program runs (what draws, the kernel's version) for `versions`."""
    _facts[name] = value
    log.info("%s: %s", name, value)


def log_path() -> Path:
    """The log file."""
    place = QStandardPaths.writableLocation(QStandardPaths.StandardLocation.AppLocalDataLocation)
    return Path(place) / "gearstudio.log"


def start_logging() -> None:
    """Log to a file that does not grow for ever; what Qt says goes there too. Without a file, to stderr."""
    handler: logging.Handler
    try:
        log_path().parent.mkdir(parents=True, exist_ok=True)
        handler = logging.handlers.RotatingFileHandler(log_path(), maxBytes=LOG_SIZE, backupCount=1, encoding="utf-8")
    except OSError:
        handler = logging.StreamHandler()
    handler.setFormatter(logging.Formatter("%(asctime)s %(levelname)s %(name)s: %(message)s"))
    logging.basicConfig(level=logging.INFO, handlers=[handler], force=True)
    qInstallMessageHandler(_on_qt_message)


def versions() -> str:
    """Versions of the program and of everything that its results depend on."""
    from importlib import metadata

    lines = [f"GearStudio {gearstudio.__version__}", f"Python {platform.python_version()}, {platform.platform()}"]
    lines.append(f"Qt {qVersion()}, {QGuiApplication.platformName()}")
    for package in PACKAGES:
        try:
            lines.append(f"{package} {metadata.version(package)}")
        except metadata.PackageNotFoundError:
            lines.append(f"{package} not installed")
    lines += [f"{name}: {value}" for name, value in _facts.items()]
    return "\n".join(lines)


def log_tail(lines: int = 60) -> str:
    """The end of the log file."""
    try:
        return "\n".join(log_path().read_text(encoding="utf-8", errors="replace").splitlines()[-lines:])
    except OSError:
        return "(no log file)"


class CrashCatcher(QObject):
    """Takes every exception that nobody expected, from any thread, to the log and to the window's thread.

    Signals
    -------
    crashed(str)
        The report, with traceback and versions; once for each error, however often it comes.
    """

    crashed = Signal(str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._told: set[str] = set()

    def install(self) -> None:
        """Become the interpreter's hook for uncaught exceptions."""
        sys.excepthook = self._on_exception
        threading.excepthook = self._on_thread_exception

    def _on_exception(self, kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        if issubclass(kind, KeyboardInterrupt):
            sys.__excepthook__(kind, error, trace)
            return
        text = "".join(traceback.format_exception(kind, error, trace))
        log.critical("unexpected error\n%s", text)
        if text not in self._told:
            self._told.add(text)
            self.crashed.emit(f"{text}\n{versions()}")

    def _on_thread_exception(self, args: threading.ExceptHookArgs) -> None:
        if args.exc_value is not None:
            self._on_exception(args.exc_type, args.exc_value, args.exc_traceback)


def _on_qt_message(kind: QtMsgType, context: object, message: str) -> None:
    if any(words in message for words in HARMLESS):
        return
    levels = {QtMsgType.QtDebugMsg: logging.DEBUG, QtMsgType.QtInfoMsg: logging.INFO}
    levels[QtMsgType.QtWarningMsg] = logging.WARNING
    logging.getLogger("qt").log(levels.get(kind, logging.ERROR), message)
