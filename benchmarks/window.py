"""Edits in the real window: how long until the three views show them, and how long the event loop ever stands still."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from time import perf_counter
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QEvent, QEventLoop, Qt, QTimer

from benchmarks.frames import is_complete, on_frame
from benchmarks.opening import opened
from ui.main_window import MainWindow

if TYPE_CHECKING:
    from ui.app import Studio

FIELD = "lengthwise.spiral_angle_deg"
TICK_MS = 5
PATIENCE_MS = 60_000


@dataclass(frozen=True)
class Edit:
    """One edit: seconds to the three views; longest gaps of the event loop until all six variants are there."""

    seconds: float
    gap_ms: float
    gap_with_frames_ms: float


@dataclass
class Watch:
    """Ticks of a timer and the spans in which the window drew itself, in seconds."""

    ticks: list[float] = field(default_factory=list)
    frames: list[tuple[float, float]] = field(default_factory=list)

    def clear(self) -> None:
        self.ticks[:] = [perf_counter()]
        self.frames.clear()

    def tick(self) -> None:
        self.ticks.append(perf_counter())

    def ticking(self, studio: Studio) -> QTimer:
        """A timer that ticks until it is stopped."""
        ticker = QTimer(studio, interval=TICK_MS, timerType=Qt.TimerType.PreciseTimer)
        ticker.timeout.connect(self.tick)
        ticker.start()
        return ticker

    def gaps(self, leave_out: Sequence[tuple[float, float]] = ()) -> list[float]:
        """Time between ticks beyond the timer's own interval, less what lies in the spans left out."""
        spans = zip(self.ticks, self.ticks[1:], strict=False)
        return [b - a - sum(max(0.0, min(b, end) - max(a, start)) for start, end in leave_out) for a, b in spans]


def measure(times: int = 20) -> list[Edit]:
    """Open the window, wait until everything is built, then edit so many times; two edits before are not counted."""
    watch, shown = Watch(), list[float]()
    watch_drawing(watch)
    with opened() as studio:
        on_frame(studio, lambda complete: shown.append(perf_counter()) if complete else None)
        wait_until(lambda: is_complete(studio) and bool(shown) and not studio.session.missing_keys())
        ticker = watch.ticking(studio)
        edits = [_edit(studio, watch, shown, 30.0 + index % 5) for index in range(times + 2)]
        ticker.stop()
        return edits[2:]


def _edit(studio: Studio, watch: Watch, shown: list[float], value: float) -> Edit:
    shown.clear()
    watch.clear()
    start = perf_counter()
    studio.window.form.field_edited.emit(FIELD, value)
    wait_until(lambda: bool(shown) and not studio.session.missing_keys())
    seconds = shown[0] - start
    pause(300)
    return Edit(seconds, 1e3 * max(watch.gaps(watch.frames)), 1e3 * max(watch.gaps()))


def watch_drawing(watch: Watch) -> None:
    """Note when the window draws itself: Qt paints and composes what has changed in one such event."""
    inherited = MainWindow.event

    def event(window: MainWindow, one: QEvent) -> bool:
        if one.type() != QEvent.Type.UpdateRequest:
            return inherited(window, one)
        start = perf_counter()
        answer = inherited(window, one)
        watch.frames.append((start, perf_counter()))
        return answer

    MainWindow.event = event  # type: ignore[method-assign]


def is_settled(studio: Studio) -> bool:
    """Whether the views are there and everything that they show of the design of now is built."""
    return studio.window.area.grid is not None and studio.session.pair is not None and not studio.session.missing_keys()


def wait_until(ready: Callable[[], Any]) -> None:
    """Run the event loop until something holds."""
    loop, poll, limit = QEventLoop(), QTimer(interval=10), QTimer(interval=PATIENCE_MS, singleShot=True)
    poll.timeout.connect(lambda: loop.quit() if ready() else None)
    limit.timeout.connect(loop.quit)
    poll.start()
    limit.start()
    loop.exec()
    if not ready():
        raise TimeoutError("the window did not come to rest")


def pause(milliseconds: int) -> None:
    loop = QEventLoop()
    QTimer.singleShot(milliseconds, loop.quit)
    loop.exec()
