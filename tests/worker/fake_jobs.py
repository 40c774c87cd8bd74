"""Jobs and warm-ups that sleep, fail and crash in a chosen phase of the CAD process."""

from __future__ import annotations

import ctypes
import os
import signal
import time
from collections.abc import Sequence
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from typing import ClassVar

from gearstudio import wire
from gearstudio.errors import ModellingError
from gearstudio.jobs import Job, Purpose, Report

Crash = int
"""A signal's number, or minus an exit status."""


def crash(how: Crash) -> None:
    if how <= 0:
        os._exit(-how)
    os.kill(os.getpid(), how)
    time.sleep(60)  # the signal may arrive a moment later


@dataclass(frozen=True)
class Fuse:
    """Lets a crash happen a number of times over all processes, counted in a folder."""

    folder: Path
    how: Crash = signal.SIGKILL
    times: int = 1

    def burn(self) -> None:
        for count in range(self.times):
            try:
                (self.folder / f"crash-{count}").touch(exist_ok=False)
            except FileExistsError:
                continue
            crash(self.how)


def no_warm_up() -> None:
    """Ready at once."""


@dataclass(frozen=True)
class SlowWarmUp:
    seconds: float

    def __call__(self) -> None:
        time.sleep(self.seconds)


@dataclass(frozen=True)
class CrashingWarmUp:
    fuse: Fuse

    def __call__(self) -> None:
        self.fuse.burn()


def failing_warm_up() -> None:
    raise ImportError("libGL.so.1: cannot open shared object file")


@dataclass(frozen=True)
class CrashingStart:
    """Crashes while the new process unpickles its arguments, before it runs a line of its own."""

    fuse: Fuse

    def __call__(self) -> None:
        """Nothing to warm up."""

    def __reduce__(self) -> tuple[object, ...]:
        return _burnt_start, (self.fuse,)


def _burnt_start(fuse: Fuse) -> CrashingStart:
    fuse.burn()
    return CrashingStart(fuse)


@dataclass(frozen=True)
class Echo(Job):
    value: object

    def run(self, report: Report) -> object:
        return self.value


@dataclass(frozen=True)
class Sleep(Job):
    """Sleeps as the kernel would: the first half says nothing."""

    seconds: float
    value: object = None

    def run(self, report: Report) -> object:
        report("sleeping", 0.0)
        time.sleep(self.seconds / 2)
        report("sleeping on", 0.5)
        time.sleep(self.seconds / 2)
        return self.value


@dataclass(frozen=True)
class Hoard(Job):
    """Takes so many megabytes and keeps them for a while."""

    megabytes: int
    purpose: ClassVar[Purpose] = "build"
    label: ClassVar[str] = "hoarding"

    def run(self, report: Report) -> object:
        held = bytearray(self.megabytes << 20)
        held[::4096] = b"x" * len(held[::4096])
        time.sleep(30)
        return len(held)


@dataclass(frozen=True)
class Export(Job):
    purpose: ClassVar[Purpose] = "export"

    seconds: float
    value: object = None
    litter: Path | None = None

    def run(self, report: Report) -> object:
        if self.litter is not None:
            self._unfinished(os.getpid()).touch()
        time.sleep(self.seconds)
        return self.value

    def clear_up(self, process_id: int) -> None:
        if self.litter is not None:
            self._unfinished(process_id).unlink(missing_ok=True)

    def _unfinished(self, process_id: int) -> Path:
        assert self.litter is not None
        return self.litter / f"unfinished-{process_id}"


@dataclass(frozen=True)
class Chatter(Job):
    """Reports far more often than anyone can look."""

    count: int

    def run(self, report: Report) -> object:
        for index in range(self.count):
            report("chatting", index / self.count)
        return self.count


@dataclass(frozen=True)
class Expected(Job):
    def run(self, report: Report) -> object:
        raise ModellingError("point_cloud", "interpolation", "the points coincide")


@dataclass(frozen=True)
class Bug(Job):
    def run(self, report: Report) -> object:
        return 1 // 0


@dataclass(frozen=True)
class Arrays(Job):
    """A large result: floats that the receiver can check."""

    megabytes: int

    def run(self, report: Report) -> object:
        import numpy as np

        return {"points": np.arange(self.megabytes * 125_000, dtype=np.float64), "small": np.ones((3, 3))}


@dataclass(frozen=True)
class Unpicklable(Job):
    def run(self, report: Report) -> object:
        return lambda: None


@dataclass(frozen=True)
class Unreadable(Job):
    """Its result can be pickled but not unpickled by the receiver."""

    def run(self, report: Report) -> object:
        return _Poison()


class _Poison:
    def __reduce__(self) -> tuple[object, ...]:
        return _refuse, (os.getpid(),)


def _refuse(home: int) -> None:
    raise ValueError("poison")


@dataclass(frozen=True)
class Unsendable(Job):
    """Cannot be pickled itself."""

    hook: object = lambda: None

    def run(self, report: Report) -> object:
        return None


class Unloadable(Job):
    """Can be pickled, but the CAD process cannot unpickle it."""

    def run(self, report: Report) -> object:
        return None

    def __reduce__(self) -> tuple[object, ...]:
        return _refuse, (os.getpid(),)


@dataclass(frozen=True)
class CrashOnArrival(Job):
    """Crashes the process that unpickles it."""

    fuse: Fuse

    def run(self, report: Report) -> object:
        return "arrived"

    def __reduce__(self) -> tuple[object, ...]:
        return _burnt_arrival, (self.fuse,)


def _burnt_arrival(fuse: Fuse) -> CrashOnArrival:
    fuse.burn()
    return CrashOnArrival(fuse)


@dataclass(frozen=True)
class CrashWhileBusy(Job):
    fuse: Fuse

    def run(self, report: Report) -> object:
        report("about to crash", 0.5)
        self.fuse.burn()
        return "survived"


@dataclass(frozen=True)
class CrashingSend:
    """A warm-up after which the process crashes when half of a large message is on its way."""

    fuse: Fuse

    def __call__(self) -> None:
        whole = wire.send_frames

        def in_halves(connection: Connection, frames: Sequence[bytes | memoryview]) -> None:
            if len(frames) > 3:
                whole(connection, frames[: len(frames) // 2])
                self.fuse.burn()
                frames = frames[len(frames) // 2 :]
            whole(connection, frames)

        wire.send_frames = in_halves


@dataclass(frozen=True)
class HoldsTheLock(Job):
    """Sleeps in C without releasing Python's lock, as the kernel does."""

    seconds: int

    def run(self, report: Report) -> object:
        return ctypes.PyDLL(None).sleep(self.seconds)


def loud_warm_up() -> None:
    print("printed by Python")
    os.write(1, b"printed past Python\n")
