"""Whether a draft is good: judged in a thread, so that a design that takes long to judge holds nothing up."""

from __future__ import annotations

import threading
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal

from gearstudio.errors import GeometryError, Issue
from ui.analysis.background import Newest

if TYPE_CHECKING:
    from gearstudio.design import Design
    from gearstudio.theory.cones import PairGeometry

AT_ONCE_S = 0.01
"""What is judged in this time is there when the edit of a field ends."""

_PATIENCE_S = 0.3
"""Longest search for remedies after an edit [s]."""


@dataclass(frozen=True)
class Verdict:
    """All that is wrong with a draft; the design and its geometry where it can be used, else None."""

    issues: tuple[Issue, ...]
    design: Design | None = None
    pair: PairGeometry | None = None


def judge(draft: Mapping[str, Any]) -> Verdict:
    """Judge a draft (a design file's tables)."""
    from gearstudio.theory.cones import pair_geometry
    from gearstudio.validation import read_design

    design, issues = read_design(draft, _PATIENCE_S)
    if design is None:
        return Verdict(issues)
    try:
        return Verdict(issues, design, pair_geometry(design))
    except GeometryError as error:
        return Verdict((*issues, Issue("geometry", "", str(error))))


class Case:
    """A draft, and its verdict when there is one."""

    def __init__(self, draft: Mapping[str, Any]) -> None:
        self._draft = draft
        self._done = threading.Event()
        self.verdict: Verdict | None = None

    def work(self) -> None:
        """Judge, whoever waits for it."""
        self.verdict = judge(self._draft)
        self._done.set()

    def wait(self, seconds: float) -> Verdict | None:
        """The verdict, if it is there in time."""
        self._done.wait(seconds)
        return self.verdict


class Judging(QObject):
    """Judges drafts one at a time, the newest next.

    Signals
    -------
    judged(object)
        A Case that has its verdict now, or has none because judging broke down.
    """

    judged = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._work = Newest("judge", self)
        self._work.done.connect(lambda case, _: self.judged.emit(case))
        self._work.failed.connect(lambda case, *_: self.judged.emit(case))

    def take(self, draft: Mapping[str, Any]) -> Case:
        """A case for a draft, to be judged next."""
        case = Case(draft)
        self._work.request(case, case.work)
        return case

    def close(self) -> None:
        """Take no more cases."""
        self._work.close()
