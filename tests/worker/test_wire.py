"""Messages in frames: whole, in order, and an end that comes too early."""

from __future__ import annotations

import multiprocessing
import pickle
import threading
from collections.abc import Iterator
from multiprocessing.connection import Connection

import numpy as np
import pytest

from gearstudio import wire

Ends = tuple[Connection, Connection]


@pytest.fixture
def ends() -> Iterator[Ends]:
    ours, theirs = multiprocessing.Pipe(duplex=True)
    with ours, theirs:
        yield ours, theirs


@pytest.mark.parametrize("message", ["text", {"a": (1, 2.5)}, np.arange(6.0).reshape(2, 3), b"x" * 200_000, []])
def test_small_messages_arrive_as_they_were(ends: Ends, message: object) -> None:
    wire.send(ends[0], message)
    np.testing.assert_equal(wire.Receiver(ends[1]).receive(), message)


@pytest.mark.parametrize("count", [wire.KEPT_APART // 8 - 1, wire.KEPT_APART // 8, wire.SLICE // 8, 1_000_003])
def test_arrays_of_any_size_arrive_exactly_and_can_be_written(ends: Ends, count: int) -> None:
    sent = {"first": np.arange(count, dtype=np.float64), "second": np.ones(count), "fortran": np.ones((3, 40_000)).T}
    threading.Thread(target=wire.send, args=(ends[0], sent), daemon=True).start()
    received = wire.Receiver(ends[1]).receive()
    assert isinstance(received, dict)
    for name, array in sent.items():
        np.testing.assert_array_equal(received[name], array)
        received[name][0] = 7.0


def test_no_frame_is_long(ends: Ends) -> None:
    assert max(len(frame) for frame in wire.pack(np.zeros(1_000_000))) <= wire.SLICE


def test_the_reader_can_pause_between_frames(ends: Ends) -> None:
    threading.Thread(target=wire.send, args=(ends[0], np.zeros(500_000)), daemon=True).start()
    receiver = wire.Receiver(ends[1])
    steps = [receiver.step()]
    while steps[-1] is None:
        steps.append(receiver.step())
    assert len(steps) > 10
    assert isinstance(steps[-1], np.ndarray)


def test_messages_keep_their_order(ends: Ends) -> None:
    for number in range(5):
        wire.send(ends[0], number)
    receiver = wire.Receiver(ends[1])
    assert [receiver.receive() for _ in range(5)] == [0, 1, 2, 3, 4]


def test_what_cannot_be_pickled_sends_nothing(ends: Ends) -> None:
    with pytest.raises((pickle.PicklingError, AttributeError)):
        wire.send(ends[0], lambda: None)
    assert not ends[1].poll()


@pytest.mark.parametrize("frames_sent", [0, 1, 2])
def test_an_end_inside_a_message_is_seen(ends: Ends, frames_sent: int) -> None:
    wire.send_frames(ends[0], wire.pack(np.zeros(100_000))[:frames_sent])
    ends[0].close()
    with pytest.raises(EOFError):
        wire.Receiver(ends[1]).receive()


def _refuse() -> None:
    raise ValueError("poison")


class Poison:
    def __reduce__(self) -> tuple[object, ...]:
        return _refuse, ()


def test_an_unreadable_message_does_not_spoil_the_next(ends: Ends) -> None:
    wire.send(ends[0], Poison())
    wire.send(ends[0], "next")
    receiver = wire.Receiver(ends[1])
    with pytest.raises(wire.UnreadableMessageError, match="poison"):
        receiver.receive()
    assert receiver.receive() == "next"
