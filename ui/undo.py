"""Undo and redo of edits, by snapshots of the whole draft."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

Draft = Mapping[str, Any]
LIMIT = 500


@dataclass(frozen=True)
class Step:
    """One edit: what it is called, the draft before it and after it, and what it is typed in."""

    label: str
    before: Draft
    after: Draft
    thread: str = ""


class History:
    """Past and undone edits."""

    def __init__(self) -> None:
        self._past: list[Step] = []
        self._future: list[Step] = []

    @property
    def undo_label(self) -> str:
        """What would be undone; empty when nothing can."""
        return self._past[-1].label if self._past else ""

    @property
    def redo_label(self) -> str:
        """What would be done again; empty when nothing can."""
        return self._future[-1].label if self._future else ""

    def record(self, label: str, before: Draft, after: Draft, thread: str = "") -> None:
        """Remember an edit that has happened.

        Edits of one thread (a field that is being typed in) that follow each other make one step, named after the
        last; :meth:`seal` ends it. Back at the start there is no step.
        """
        if before == after:
            return
        self._future.clear()
        last = self._past[-1] if self._past else None
        if last is not None and thread and last.thread == thread and last.after == before:
            before = self._past.pop().before
        if before != after:
            self._past.append(Step(label, dict(before), dict(after), thread))
            del self._past[:-LIMIT]

    def seal(self) -> None:
        """What comes next is a step of its own."""
        if self._past:
            self._past[-1] = replace(self._past[-1], thread="")

    def undo(self) -> Draft | None:
        """The draft before the last edit, or None."""
        if not self._past:
            return None
        self._future.append(self._past.pop())
        return self._future[-1].before

    def redo(self) -> Draft | None:
        """The draft after the edit undone last, or None."""
        if not self._future:
            return None
        self._past.append(self._future.pop())
        return self._past[-1].after

    def clear(self) -> None:
        """Forget everything, as for another file."""
        self._past.clear()
        self._future.clear()
