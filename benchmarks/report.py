"""The whole report of the default design, every section: computed, drawn and typeset as the window has it done."""

from __future__ import annotations

from collections.abc import Callable

from benchmarks.measurement import timed

TARGET = 3.0


def make() -> int:
    """Size of the PDF in bytes."""
    from gearstudio.design import Design
    from gearstudio.report.job import ReportJob
    from gearstudio.report.sections import SECTION_KEYS

    return len(ReportJob(Design(), SECTION_KEYS, "wheel").run(lambda stage, fraction: None).pdf)


def ratios(peer: Callable[[], object], rounds: int = 3) -> list[float]:
    """Time of a report over that of a peer, in turn, so that a busy machine slows both alike."""
    make()
    peer()
    return [timed(make, 1)[0] / timed(peer, 1)[0] for _ in range(rounds)]


if __name__ == "__main__":
    print(timed(make, 3), make())
