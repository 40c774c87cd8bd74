"""The whole report of the default design, every section: computed, drawn and typeset as the window has it done."""

from __future__ import annotations

from benchmarks.measurement import timed

TARGET = 3.0


def make() -> int:
    """Size of the PDF in bytes."""
    from gearstudio.design import Design
    from gearstudio.report.job import ReportJob
    from gearstudio.report.sections import SECTION_KEYS

    return len(ReportJob(Design(), SECTION_KEYS, "wheel").run(lambda stage, fraction: None).pdf)


if __name__ == "__main__":
    print(timed(make, 3), make())
