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


@dataclass(frozen=True)
class Reported:
    """A report: the PDF, and its pages as PNG pictures when they were asked for."""

    pdf: bytes
    pages: tuple[bytes, ...] = ()


@dataclass(frozen=True)
class ReportJob(Job):
    """Compute, draw and typeset the report of a design.

    ``member`` is the one whose flanks the maps show, ``pictures`` are PNG pictures by name, ``missing``
    says why others are not there, ``preview`` is the resolution of the pages' pictures [dots per inch], 0 for none,
    and ``folder`` is where the project is.
    """

    purpose: ClassVar[Purpose] = "report"

    design: Design
    sections: tuple[str, ...]
    member: MemberName
    pictures: tuple[tuple[str, bytes], ...] = ()
    preview: int = 0
    folder: Path | None = None
    missing: tuple[str, ...] = ()

    @property
    def label(self) -> str:
        """A few words for the status bar."""
        return f"report of {self.design.name}"

    def run(self, report: Callable[[str, float], None]) -> Reported:
        """Make the report; raises ModellingError when its pages cannot be set."""
        from gearstudio.report.document import compose, typeset
        from gearstudio.report.store import Taken

        taken = Taken(dict(self.pictures), self.missing)
        pages = compose(self.design, self.sections, self.member, lambda: taken, report, self.folder)
        report("setting the pages", 0.9)
        shown = typeset(pages, self.preview) if self.preview else ()
        return Reported(typeset(pages)[0], shown)
