"""The report as a job of the CAD process."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

from gearstudio.jobs import Job, Purpose

if TYPE_CHECKING:
    from gearstudio.catalogue import MemberName
    from gearstudio.design import Design
    from gearstudio.report.measuring import MeasuredFile


@dataclass(frozen=True)
class Reported:
    """A report: the PDF, its pages as PNG pictures when they were asked for, and what to know about it."""

    pdf: bytes
    pages: tuple[bytes, ...] = ()
    warnings: tuple[str, ...] = ()


@dataclass(frozen=True)
class ReportJob(Job):
    """Compute, draw and typeset the report of a design.

    ``member`` is the one whose flanks the maps show, ``pictures`` are PNG pictures by name, ``missing``
    says why others are not there, ``preview`` is the resolution of the pages' pictures [dots per inch], 0 for none,
    ``folder`` is where the project is, ``language`` a code of `gearstudio.words.LANGUAGES`, and ``measured`` are
    points for the section about them.
    """

    purpose: ClassVar[Purpose] = "report"

    design: Design
    sections: tuple[str, ...]
    member: MemberName
    pictures: tuple[tuple[str, bytes], ...] = ()
    preview: int = 0
    folder: Path | None = None
    missing: tuple[str, ...] = ()
    language: str = "en"
    measured: MeasuredFile | None = None

    @property
    def label(self) -> str:
        """A few words for the status bar."""
        return f"report of {self.design.name}"

    def run(self, report: Callable[[str, float], None]) -> Reported:
        """Make the report; raises ModellingError when its pages cannot be set."""
        from gearstudio.report.content import Beside
        from gearstudio.report.document import Order, compose, typeset
        from gearstudio.report.store import Taken

        taken = Taken(dict(self.pictures), self.missing)
        order = Order(self.sections, self.member, self.language, Beside(self.folder, self.measured))
        pages = compose(self.design, order, lambda: taken, report)
        report("setting the pages", 0.9)
        shown = typeset(pages, self.preview) if self.preview else ()
        return Reported(typeset(pages)[0], shown, pages.warnings)
