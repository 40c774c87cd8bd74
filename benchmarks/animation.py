"""A frame of the turning pair against a plain repaint of the same scene, in the real window."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass
from time import perf_counter
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, QEventLoop

from benchmarks.opening import opened
from benchmarks.window import is_settled, pause, wait_until

if TYPE_CHECKING:
    from ui.app import Studio

TARGET = 1.5
FRAMES, ROUNDS = 12, 7
_STEP_DEG = 0.7


@dataclass(frozen=True)
class Frame:
    """Milliseconds of one frame: turning, repainting as it is while it moves, and standing still."""

    turning: float
    moving: float
    standing: float


def measure(rounds: int = ROUNDS) -> list[Frame]:
    """Open the window, build the pair, and time frames in turn, so that a busy machine spoils all of them alike."""
    with opened() as studio:
        wait_until(lambda: is_settled(studio))
        mode = studio.controller.solid_mode
        mode.set_mode("pair")
        wait_until(lambda: all(mode.solids.is_current(key) for key in mode.keys))
        pause(800)
        return [_round(studio) for _ in range(rounds + 1)][1:]


def _round(studio: Studio) -> Frame:
    grid, bar = studio.window.area.grid, studio.window.area.mesh_bar
    assert grid is not None and bar is not None
    viewport = grid.viewport

    angles = itertools.count(1)

    def turn() -> None:
        bar.turned.emit(_STEP_DEG * next(angles) % 360)

    def repaint_moving() -> None:
        viewport.set_moving()
        viewport.update()

    turning = _per_frame(viewport, turn)
    moving = _per_frame(viewport, repaint_moving)
    pause(500)
    standing = _per_frame(viewport, viewport.update)
    return Frame(turning, moving, standing)


def _per_frame(viewport: object, ask: Callable[[], None]) -> float:
    """Milliseconds from asking for a frame until it is drawn and composed, on average."""
    start = perf_counter()
    for _ in range(FRAMES):
        drawn = viewport.frames  # type: ignore[attr-defined]
        ask()
        while viewport.frames == drawn:  # type: ignore[attr-defined]
            QCoreApplication.processEvents(QEventLoop.ProcessEventsFlag.AllEvents)
    return 1e3 * (perf_counter() - start) / FRAMES


if __name__ == "__main__":
    for frame in measure():
        print(f"turning {frame.turning:.1f} ms, repaint moving {frame.moving:.1f} ms, standing {frame.standing:.1f} ms")
