"""Importing in a thread: stages in order, failures in words, and silence after the end."""

from __future__ import annotations

import gc
import subprocess
import sys
import threading
import types
from pathlib import Path
from typing import ClassVar

import pytest

from ui.collecting import Collector
from ui.loading import Loader

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def heard() -> list[tuple[str, ...]]:
    return []


def listen(loader: Loader, heard: list[tuple[str, ...]]) -> None:
    def note(*said: str) -> None:
        assert threading.current_thread() is threading.main_thread()
        heard.append(said)

    loader.loaded.connect(note)
    loader.failed.connect(note)


def test_stages_come_in_order_and_a_failed_one_stops_no_other(qtbot, heard) -> None:
    loader = Loader({"first": ("json",), "broken": ("no_such_module",), "last": ("csv", "json")})
    listen(loader, heard)
    loader.start()
    qtbot.waitUntil(lambda: len(heard) == 3, timeout=5000)
    assert heard[0] == ("first",) and heard[2] == ("last",)
    assert heard[1][0] == "broken" and "no_such_module" in heard[1][1] and "Traceback" in heard[1][2]


def test_the_end_is_told_last(qtbot, heard) -> None:
    loader = Loader({"first": ("json",), "broken": ("no_such_module",)})
    listen(loader, heard)
    loader.finished.connect(lambda: heard.append(("finished",)))
    loader.start()
    qtbot.waitUntil(lambda: len(heard) == 3, timeout=5000)
    assert heard[-1] == ("finished",)


def test_what_is_loaded_is_not_looked_through_again(qapp) -> None:
    collector = Collector()
    collector.begin()
    assert not gc.isenabled() and gc.get_freeze_count() > 0
    gc.unfreeze()


class Knot:
    """Garbage that only a collector can free, and that tells where it ended."""

    ended: ClassVar[list[threading.Thread]] = []

    def __init__(self) -> None:
        self.itself = self

    def __del__(self) -> None:
        self.ended.append(threading.current_thread())


def test_garbage_ends_in_the_thread_of_the_windows_though_another_is_busy(qtbot) -> None:
    Knot.ended.clear()
    collector = Collector()
    collector.begin()

    def work() -> None:
        for _ in range(20):
            Knot()
            hoard.append([[] for _ in range(2000)])

    hoard: list[object] = []
    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert not Knot.ended
    qtbot.waitUntil(lambda: len(Knot.ended) == 20, timeout=10_000)
    assert set(Knot.ended) == {threading.main_thread()}
    gc.unfreeze()


def test_nothing_is_said_after_stopping(qtbot, heard) -> None:
    loader = Loader({"first": ("json",), "second": ("csv",)})
    listen(loader, heard)
    loader.start()
    loader.stop()
    qtbot.wait(100)
    assert heard == []


def test_stopping_before_the_start_is_harmless(heard) -> None:
    loader = Loader({"first": ("json",)})
    loader.stop()
    assert not loader._thread.is_alive()


def test_a_function_after_a_colon_is_called_in_the_thread(qtbot) -> None:
    callers: list[str] = []
    module = types.ModuleType("made_up_to_warm")
    module.warm = lambda: callers.append(threading.current_thread().name)  # type: ignore[attr-defined]
    sys.modules[module.__name__] = module
    loader = Loader({"one": (f"{module.__name__}:warm",)})
    with qtbot.waitSignal(loader.finished, timeout=5000):
        loader.start()
    del sys.modules[module.__name__]
    assert callers == ["imports"]


TABLE_GROWS = 1109, 2357
"""Numbers of classes at which the standard library's hash table moves to a larger place."""

IMPORTS = """
import gc, importlib, sys
import PySide6.QtCore
import ui.app
gc.disable()
from ui.loading import STAGES, make_qt_classes
make_qt_classes()
def known():
    return {(name, key) for name in list(sys.modules) if name.startswith("PySide6.Qt")
            for key, value in vars(sys.modules[name]).items() if isinstance(value, type)}
def count():
    return sum(isinstance(one, type(PySide6.QtCore.QObject)) for one in gc.get_objects())
before, first = known(), count()
for modules in STAGES.values():
    for module in modules:
        importlib.import_module(module.partition(":")[0])
print(sorted(known() - before), first, count(), sep="\\n")
"""


def test_the_thread_makes_no_classes_of_qt() -> None:
    """Where it did, the window's thread could crash in the middle of any event."""
    command = [sys.executable, "-c", IMPORTS]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=120, check=True)
    made, first, last = done.stdout.splitlines()[-3:]
    assert made == "[]"
    assert TABLE_GROWS[0] < int(first) < int(last) < TABLE_GROWS[1]
