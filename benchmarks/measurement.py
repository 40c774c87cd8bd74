"""One promise about time, what was measured, and how it is printed."""

from __future__ import annotations

import statistics
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from time import perf_counter


@dataclass(frozen=True)
class Measurement:
    """Repeated readings of one quantity against its target.

    Attributes
    ----------
    title : str
    readings : sequence of float
    target : float or None
        The reading may be this large; None for a quantity that only informs.
    unit : str
        Empty for a ratio.
    decimals : int
    judged : "median" or "maximum"
        Which of the readings has to meet the target.
    """

    title: str
    readings: Sequence[float]
    target: float | None = None
    unit: str = ""
    decimals: int = 3
    judged: str = "median"

    @property
    def median(self) -> float:
        return statistics.median(self.readings)

    @property
    def passed(self) -> bool:
        value = self.median if self.judged == "median" else max(self.readings)
        return self.target is None or value <= self.target

    def __str__(self) -> str:
        def text(value: float) -> str:
            return f"{value:.{self.decimals}f}{' ' * bool(self.unit)}{self.unit}"

        verdict, wanted = "", ""
        if self.target is not None:
            verdict = "PASS" if self.passed else "FAIL"
            wanted = f"{self.judged} ≤ {text(self.target)}"
        spread = f"median {text(self.median)}   {text(min(self.readings))} … {text(max(self.readings))}"
        return f"{verdict:4}  {self.title:<58} {wanted:<22} {spread}   ({len(self.readings)} times)"


@dataclass(frozen=True)
class Remark:
    """A line among the measurements that promises nothing."""

    text: str
    passed: bool = True

    def __str__(self) -> str:
        return f"      {self.text}"


def timed(action: Callable[[], object], times: int) -> list[float]:
    """Seconds that the action took, each time."""
    readings = []
    for _ in range(times):
        start = perf_counter()
        action()
        readings.append(perf_counter() - start)
    return readings


def ratios(action: Callable[[], object], peer: Callable[[], object], rounds: int, times: int = 1) -> list[float]:
    """Time of an action (the median of so many) over that of a peer, in turn: a busy machine slows both alike.

    One of either before is not counted.
    """
    action()
    peer()
    return [statistics.median(timed(action, times)) / timed(peer, 1)[0] for _ in range(rounds)]
