"""Importing in a thread: stages in order, failures in words, and silence after the end."""

from __future__ import annotations

import gc
import sys
import threading
import types

import pytest

from ui.collecting import keep_what_is_loaded
from ui.loading import Loader


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


def test_what_is_loaded_is_not_looked_through_again() -> None:
    gc.disable()
    keep_what_is_loaded()
    assert gc.isenabled() and gc.get_freeze_count() > 0
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
