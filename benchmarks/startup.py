"""From starting the program to its first paint and to its first picture, each time in a process of its own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from time import perf_counter
from typing import Any

HEAVY = ("vtk", "vtkmodules", "pyvista", "pyvistaqt", "OCP", "build123d")


@dataclass(frozen=True)
class Start:
    """Seconds after the start of the process, and the heavy modules that were loaded at the first paint."""

    first_paint: float
    exact_flanks: float
    all_methods: float
    loaded_at_first_paint: tuple[str, ...]


def measure(times: int = 5) -> list[Start]:
    """Start the program so many times; one start before is not counted."""
    return [_start() for _ in range(times + 1)][1:]


def _start() -> Start:
    with tempfile.TemporaryDirectory() as settings:
        environment = os.environ | {"XDG_CONFIG_HOME": settings, "XDG_STATE_HOME": settings}
        command = [sys.executable, "-m", "benchmarks.startup", repr(perf_counter())]
        done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=120, env=environment)
    told: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    return Start(**told | {"loaded_at_first_paint": tuple(told["loaded_at_first_paint"])})


def child(origin: float) -> int:
    """Run the program as ``main.py`` does, note when things appear, and leave."""
    from PySide6.QtCore import QTimer

    import main
    import ui.app
    from benchmarks.frames import on_frame

    told: dict[str, Any] = {}

    class Watched(ui.app.Studio):
        def __init__(self, *arguments: Any) -> None:
            super().__init__(*arguments)
            self.window.first_painted.connect(self._on_first_paint)

        def _on_first_paint(self) -> None:
            told["first_paint"] = perf_counter() - origin
            told["loaded_at_first_paint"] = [name for name in HEAVY if name in sys.modules]

        def _make_views(self) -> None:
            on_frame(self, self._on_frame)
            super()._make_views()

        def _on_frame(self, complete: bool) -> None:
            told.setdefault("exact_flanks", perf_counter() - origin)
            if complete and "all_methods" not in told:
                told["all_methods"] = perf_counter() - origin
                print(json.dumps(told), flush=True)
                QTimer.singleShot(0, self.window.close)

    ui.app.Studio = Watched  # type: ignore[misc]
    return main.main([])


if __name__ == "__main__":
    sys.exit(child(float(sys.argv[1])))
