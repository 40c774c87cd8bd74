"""Work in a thread: the newest request counts, and no object of Qt ends in the thread or hears of it after its end."""

from __future__ import annotations

import gc
import threading
import weakref
from collections.abc import Callable, Iterator

import pytest
import shiboken6
from PySide6.QtCore import QCoreApplication, QObject

from gearstudio.errors import GearStudioError
from ui.analysis import background
from ui.analysis.background import Newest


class Place(QObject):
    """Notes in which thread it ends."""

    def __init__(self, ends: list[threading.Thread]) -> None:
        super().__init__()
        weakref.finalize(self, lambda: ends.append(threading.current_thread()))

    def one(self) -> int:
        return 1

    def fail(self) -> int:
        raise GearStudioError("cannot be done")


class Heard(list[tuple[object, ...]]):
    """What a `Newest` said, in order."""

    def __init__(self, newest: Newest) -> None:
        super().__init__()
        for name in ("done", "failed", "stopped", "idle"):
            getattr(newest, name).connect(lambda *values, name=name: self.append((name, *values)))

    @property
    def names(self) -> list[object]:
        return [name for name, *_ in self]


@pytest.fixture
def newest(qapp) -> Iterator[Newest]:
    made = Newest("a test")
    yield made
    made.close()


@pytest.fixture
def gate() -> Iterator[threading.Event]:
    """Work that waits for it is let go at the end, whatever happens."""
    made = threading.Event()
    yield made
    made.set()


def threads() -> list[threading.Thread]:
    return [thread for thread in threading.enumerate() if thread.name == "a test"]


def held_up(gate: threading.Event, begun: threading.Event) -> Callable[[], bool]:
    def work() -> bool:
        begun.set()
        return gate.wait(10)

    return work


def test_the_newest_request_takes_the_place_of_the_one_that_waits(newest, gate, qtbot) -> None:
    heard, begun = Heard(newest), threading.Event()
    newest.request("first", held_up(gate, begun))
    assert begun.wait(10) and newest.busy
    newest.request("second", lambda: 2)
    newest.request("third", lambda: 3)
    gate.set()
    qtbot.waitUntil(lambda: "idle" in heard.names, timeout=10_000)
    assert heard == [("done", "first", True), ("done", "third", 3), ("idle",)] and not newest.busy


def test_what_was_cancelled_ends_when_it_asks(newest, gate, qtbot) -> None:
    heard, begun = Heard(newest), threading.Event()

    def work() -> None:
        begun.set()
        gate.wait(10)
        newest.go_on()

    newest.request("it", work)
    assert begun.wait(10)
    newest.cancel()
    gate.set()
    qtbot.waitUntil(lambda: "idle" in heard.names, timeout=10_000)
    assert heard == [("stopped", "it"), ("idle",)]


@pytest.mark.parametrize("work", ["one", "fail"])
def test_what_a_request_holds_ends_in_the_thread_that_asked(newest, qtbot, work: str) -> None:
    """Its last reference may be the request's own; to end in the other thread could bring Qt down."""
    heard, ends = Heard(newest), list[threading.Thread]()
    for number in range(5):
        place = Place(ends)
        newest.request(number, getattr(place, work))
        del place
        qtbot.waitUntil(lambda count=number + 1: heard.names.count("idle") == count, timeout=10_000)
        heard[:] = [("idle",)] * (number + 1)
    newest.request("last", lambda: None)
    qtbot.waitUntil(lambda: len(ends) == 5, timeout=10_000)
    assert set(ends) == {threading.main_thread()}


def test_nothing_is_told_after_the_end_not_even_what_was_on_its_way(newest, qtbot) -> None:
    heard, done = Heard(newest), threading.Event()
    newest.request("it", done.set)
    assert done.wait(10)
    newest.close()
    QCoreApplication.processEvents()
    newest.request("late", lambda: 1)
    QCoreApplication.processEvents()
    assert heard == [] and not threads()


@pytest.mark.parametrize("way", ["deleted", "with its parent", "forgotten"])
def test_a_thread_ends_quietly_when_what_it_works_for_has_gone(qapp, gate, monkeypatch, way: str) -> None:
    broken: list[object] = []
    monkeypatch.setattr(threading, "excepthook", broken.append)
    parent = QObject()
    newest = Newest("a test", parent if way == "with its parent" else None)
    begun = threading.Event()
    newest.request("it", held_up(gate, begun))
    assert begun.wait(10)
    (thread,) = threads()
    if way != "forgotten":
        shiboken6.delete(parent if way == "with its parent" else newest)
    del newest
    gc.collect()
    gate.set()
    thread.join(5)
    assert not thread.is_alive() and not broken


def test_closing_waits_for_what_is_being_done_but_not_for_ever(newest, gate, monkeypatch) -> None:
    monkeypatch.setattr(background, "PATIENCE_S", 0.05)
    begun = threading.Event()
    newest.request("it", held_up(gate, begun))
    assert begun.wait(10)
    newest.close()
    (thread,) = threads()
    gate.set()
    thread.join(5)
    assert not thread.is_alive()
