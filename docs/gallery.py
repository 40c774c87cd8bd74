"""Pictures of every panel and dialog, in every language, theme and size, to be looked at.

``python docs/gallery.py [FOLDER]`` on a screen of 1920 x 1080; without one:
``xvfb-run -s "-screen 0 1920x1080x24" .venv/bin/python docs/gallery.py``. ``faults.txt`` of each language lists
what has too little room.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import time
import traceback
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from PySide6.QtCore import QCoreApplication, QStandardPaths, Qt  # noqa: E402
from PySide6.QtGui import QGuiApplication  # noqa: E402
from PySide6.QtWidgets import QApplication  # noqa: E402

from docs.scenes.dialogs import DIALOGS  # noqa: E402
from docs.scenes.pages import PAGES  # noqa: E402
from docs.scenes.panels import PANELS  # noqa: E402
from docs.scenes.stage import Stage  # noqa: E402
from tests.ui.layout_check import faults  # noqa: E402
from ui.app import make_application  # noqa: E402
from ui.language import install  # noqa: E402
from ui.theme import Theme  # noqa: E402

LANGUAGES = ("en", "de", "zh")
THEMES = ("light", "dark")
SIZES = ("1280x720", "1920x1080")
SCENES = {scene.__name__: scene for scene in (*PANELS, *PAGES, *DIALOGS)}


class Photographer:
    """Saves what is on the screen where the window is, and notes what the layout check finds."""

    def __init__(self, folder: Path, prefix: str, size: tuple[int, int]) -> None:
        self._folder, self._prefix, self._size = folder, prefix, size
        self.found: dict[str, list[str]] = {}

    def __call__(self, name: str) -> None:
        """Take a picture of a scene."""
        for _ in range(3):
            QApplication.processEvents()
        shot = QGuiApplication.primaryScreen().grabWindow(0, 0, 0, *self._size)
        shot.save(str(self._folder / f"{self._prefix}-{name}.png"))
        tops = [top for top in QApplication.topLevelWidgets() if top.isVisible()]
        found = [fault for top in tops for fault in faults(top)]
        for fault in found:
            self.found.setdefault(fault, []).append(f"{self._prefix}-{name}")


def take(folder: Path, language: str, options: argparse.Namespace) -> int:
    """All pictures in one language; the number of scenes that could not be played."""
    folder.mkdir(parents=True, exist_ok=True)
    QStandardPaths.setTestModeEnabled(True)
    QCoreApplication.setAttribute(Qt.ApplicationAttribute.AA_DontUseNativeDialogs)
    application = make_application(["gearstudio"])
    install(application, language)
    theme, failures = Theme(application), 0
    theme.choose(Qt.ColorScheme.Light)
    found: dict[str, list[str]] = {}
    with TemporaryDirectory() as own:
        stage = Stage(theme, Path(own), lambda _name: None)
        stage.open()
        for look in options.themes:
            stage.choose_theme(look == "dark")
            for size in options.sizes:
                width, height = (int(part) for part in size.split("x"))
                stage.resize(width, height)
                stage.look = photographer = Photographer(folder, f"{look}-{height}", (width, height))
                photographer.found = found
                failures += play(stage, options.scenes)
        stage.leave()
    lines = [f"{fault}\n    {', '.join(names[:3])} ({len(names)})" for fault, names in sorted(found.items())]
    (folder / "faults.txt").write_text("\n".join([*lines, ""]), encoding="utf-8")
    return failures


def play(stage: Stage, names: list[str]) -> int:
    """The scenes one after the other; how many failed."""
    failures = 0
    for name in names:
        start = time.monotonic()
        try:
            SCENES[name](stage)
        except Exception:
            failures += 1
            print(f"--- {name}", traceback.format_exc(), sep="\n", flush=True)
        stage.close_all()
        print(f"{name}: {time.monotonic() - start:.1f} s", flush=True)
    return failures


def main() -> int:
    """A process for each language."""
    parser = argparse.ArgumentParser(description="Pictures of every panel and dialog")
    parser.add_argument("folder", nargs="?", type=Path, default=ROOT / "out" / "gallery")
    parser.add_argument("--languages", nargs="+", choices=LANGUAGES, default=list(LANGUAGES))
    parser.add_argument("--themes", nargs="+", choices=THEMES, default=list(THEMES))
    parser.add_argument("--sizes", nargs="+", default=list(SIZES), metavar="WxH")
    parser.add_argument("--scenes", nargs="+", choices=list(SCENES), default=list(SCENES))
    options = parser.parse_args()
    if len(options.languages) == 1:
        return take(options.folder / options.languages[0], options.languages[0], options)
    status = 0
    for language in options.languages:
        rest = [part for part in sys.argv[1:] if part not in LANGUAGES and part != "--languages"]
        status += subprocess.run([sys.executable, __file__, *rest, "--languages", language], check=False).returncode
    return int(status > 0)


if __name__ == "__main__":
    left = main()
    sys.stdout.flush()
    import os

    os._exit(left)
