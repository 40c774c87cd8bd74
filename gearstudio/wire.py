"""Messages over a connection between processes, in frames small enough never to hold a thread for long.

A message is pickled with its large arrays kept apart, so that neither end copies them as a whole. First
comes a frame with the length of each part, then the parts in slices; the reader takes one frame at a
time and can look after other things in between.
"""

from __future__ import annotations

import mmap
import pickle
import struct
from collections import deque
from collections.abc import Iterable
from multiprocessing.connection import Connection

SLICE = 1 << 18
KEPT_APART = 1 << 16


class UnreadableMessageError(Exception):
    """A message arrived whole but could not be unpickled; the connection is still good."""


def pack(message: object) -> list[bytes | memoryview]:
    """Frames of a message; raises whatever pickling it raises, before anything is sent."""
    parts: list[memoryview] = []

    def stays_within(buffer: pickle.PickleBuffer) -> bool:
        raw = buffer.raw()
        if raw.nbytes < KEPT_APART:
            return True
        parts.append(raw)
        return False

    body = pickle.dumps(message, protocol=5, buffer_callback=stays_within)
    parts.insert(0, memoryview(body))
    frames: list[bytes | memoryview] = [struct.pack(f"!{len(parts)}Q", *(part.nbytes for part in parts))]
    frames.extend(part[at : at + SLICE] for part in parts for at in range(0, part.nbytes, SLICE))
    return frames


def send_frames(connection: Connection, frames: Iterable[bytes | memoryview]) -> None:
    """Send what `pack` made; OSError if the other end has gone."""
    for frame in frames:
        connection.send_bytes(frame)


def send(connection: Connection, message: object) -> None:
    """Pack a message and send it."""
    send_frames(connection, pack(message))


class Receiver:
    """Puts messages together from the frames of a connection."""

    def __init__(self, connection: Connection) -> None:
        self._connection = connection
        self._parts: list[bytearray | mmap.mmap] = []
        self._missing: deque[memoryview] = deque()

    def step(self) -> object | None:
        """Take one frame; the message when this was its last frame, otherwise None.

        Raises
        ------
        EOFError, OSError
            The other end has gone.
        UnreadableMessageError
            The message is whole but cannot be unpickled.
        """
        if self._missing:
            self._connection.recv_bytes_into(self._missing.popleft())
        else:
            self._expect(self._connection.recv_bytes())
        if self._missing:
            return None
        parts, self._parts = self._parts, []
        try:
            message: object = pickle.loads(parts[0], buffers=parts[1:])
        except Exception as error:
            raise UnreadableMessageError(f"{type(error).__name__}: {error}") from error
        return message

    def receive(self) -> object:
        """Wait for a whole message."""
        while (message := self.step()) is None:
            pass
        return message

    def _expect(self, header: bytes) -> None:
        self._parts = [_room(size) for size in struct.unpack(f"!{len(header) // 8}Q", header)]
        views = [memoryview(part) for part in self._parts]
        self._missing.extend(view[at : at + SLICE] for view in views for at in range(0, len(view), SLICE))


def _room(size: int) -> bytearray | mmap.mmap:
    """Memory to receive into; a lot of it is taken from the system as it fills, not cleared all at once."""
    return bytearray(size) if size < KEPT_APART else mmap.mmap(-1, size)
