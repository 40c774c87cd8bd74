"""Whole gears in the real window: how long the event loop ever stands still while they come, go and are cut."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from benchmarks.opening import opened
from benchmarks.window import Watch, is_settled, pause, wait_until, watch_drawing

if TYPE_CHECKING:
    from ui.app import Studio

ROUNDS = 3
STEPS = 24
_REST_MS = 400
_STEP_MS = 15


@dataclass(frozen=True)
class Gaps:
    """Longest time without a turn of the event loop [ms], frames left out and with them."""

    name: str
    alone: float
    with_frames: float


def measure(rounds: int = ROUNDS) -> list[Gaps]:
    """Open the window, then show, cut and leave solids so many times."""
    watch = Watch()
    watch_drawing(watch)
    with opened() as studio:
        wait_until(lambda: is_settled(studio))
        pause(_REST_MS)
        ticker = watch.ticking(studio)
        made = [gaps for index in range(rounds) for gaps in _round(studio, watch, index)]
        ticker.stop()
        return made


def _round(studio: Studio, watch: Watch, index: int) -> list[Gaps]:
    mode, panel = studio.controller.solid_mode, studio.window.solid_panel

    def settled() -> bool:
        return all(mode.solids.is_current(key) for key in mode.keys)

    def watched(name: str, act: Callable[[], None]) -> Gaps:
        watch.clear()
        act()
        wait_until(settled)
        pause(_REST_MS)
        return Gaps(name, 1e3 * max(watch.gaps(watch.frames)), 1e3 * max(watch.gaps()))

    def drag() -> None:
        slider = panel.section.slider
        for step in range(STEPS):
            slider.setValue(round(slider.maximum() * (0.25 + 0.5 * step / STEPS)))
            pause(_STEP_MS)

    first = index == 0
    made = [
        watched("gear, built" if first else "gear, there", lambda: mode.set_mode("gear")),
        watched("flanks again", lambda: mode.set_mode("flanks")),
        watched("pair, built" if first else "pair, there", lambda: mode.set_mode("pair")),
        watched("section on", lambda: panel.section.box.setChecked(True)),
        watched("section dragged", drag),
        watched("section off", lambda: panel.section.box.setChecked(False)),
    ]
    mode.set_mode("flanks")
    pause(_REST_MS)
    return made


if __name__ == "__main__":
    for gaps in measure():
        print(f"{gaps.name:18s} {gaps.alone:5.0f} ms, with frames {gaps.with_frames:5.0f} ms")
