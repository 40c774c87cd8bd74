"""How long the search for remedies may take: a window that judges every edit has less patience than a file."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

_ends: ContextVar[float] = ContextVar("ends", default=float("inf"))


@contextmanager
def within(seconds: float) -> Iterator[None]:
    """Searches inside stop looking when so much time has gone by."""
    token = _ends.set(time.monotonic() + seconds)
    try:
        yield
    finally:
        _ends.reset(token)


def seconds_left() -> float:
    """What is left of the patience [s]."""
    return _ends.get() - time.monotonic()


def is_late() -> bool:
    """Whether a search must make do with what it has."""
    return seconds_left() < 0
