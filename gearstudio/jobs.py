"""The jobs of the CAD process, as frozen records that carry themselves out.

The window sends them to its CAD process, the command line runs them directly. Importing this module loads
neither numpy nor the CAD kernel, so that a new process is alive at once; running a job does.
"""

from __future__ import annotations

import contextlib
import os
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar, Literal

from gearstudio.errors import FileError
from gearstudio.files import named_errors
from gearstudio.formats import FORMATS, SOLID_FORMATS, USUAL, ExportOptions

if TYPE_CHECKING:
    from gearstudio.analysis.convergence import ConvergencePoint
    from gearstudio.catalogue import MemberName, Variant
    from gearstudio.checks import FileCheck
    from gearstudio.design import Design
    from gearstudio.exchange.measured_step import SampledModel
    from gearstudio.results import SolidResult, VariantResult

Report = Callable[[str, float], None]
"""Takes the stage that begins and the fraction done, 0 to 1."""

Purpose = Literal["build", "solid", "export", "sample", "study", "report"]

CONSTRUCTIONS = ("assemble", "cut")


class Job(ABC):
    """Something to do in the CAD process.

    ``purpose`` decides what a newer request does to it: it replaces a ``build``, never an ``export``.
    """

    purpose: ClassVar[Purpose] = "build"

    @property
    def label(self) -> str:
        """A few words for the status bar."""
        return type(self).__name__

    @abstractmethod
    def run(self, report: Report) -> object:
        """Carry the job out; the result must be picklable."""

    def clear_up(self, process_id: int) -> None:  # noqa: B027 - most jobs leave nothing
        """Remove what this job left half-made in a process that was killed."""


@dataclass(frozen=True)
class BuildJob(Job):
    """Build both flanks of a member by one variant of one method and measure them."""

    design: Design
    member: MemberName
    method: str
    variant: Variant
    samples: tuple[int, int] = (49, 49)

    @property
    def label(self) -> str:
        return f"{self.member}, {self.method}, {self.variant}"

    def run(self, report: Report) -> VariantResult:
        from gearstudio.analysis.comparison import build_variant

        report("building", 0.0)
        return build_variant(self.design, self.member, self.method, self.variant, self.samples)


@dataclass(frozen=True)
class GearJob(Job):
    """Build a member's whole solid, check it and weigh it."""

    purpose: ClassVar[Purpose] = "solid"

    design: Design
    member: str
    method: str
    variant: Variant
    construction: str = "assemble"

    @property
    def label(self) -> str:
        return f"{self.member} gear, {self.method}, {self.variant}"

    def run(self, report: Report) -> SolidResult:
        from gearstudio.methods.gear import solid_result

        return solid_result(self.design, self.member, self.method, self.variant, self.construction, report)


@dataclass(frozen=True)
class StudyJob(Job):
    """Build both flanks of a member by one method with a given effort: one point of a study of convergence."""

    purpose: ClassVar[Purpose] = "study"

    design: Design
    member: str
    method: str
    count: int

    @property
    def label(self) -> str:
        return f"studying {self.method}, {self.count}"

    def run(self, report: Report) -> ConvergencePoint:
        from gearstudio.analysis.convergence import convergence_point

        report("building", 0.0)
        return convergence_point(self.design, self.member, self.method, self.count)


@dataclass(frozen=True)
class SampleJob(Job):
    """Take points to measure from the flanks in a STEP file; ``spacing`` is how far apart they are [mm]."""

    purpose: ClassVar[Purpose] = "sample"

    design: Design
    member: str
    path: Path
    spacing: float | None = None

    @property
    def label(self) -> str:
        return f"taking points of {Path(self.path).name}"

    def run(self, report: Report) -> SampledModel:
        from gearstudio.exchange.measured_step import sample_step
        from gearstudio.theory.cones import pair_geometry

        return sample_step(Path(self.path), pair_geometry(self.design), self.member, self.spacing, report)


@dataclass(frozen=True)
class ExportedFile:
    """A file that an export wrote, what was found when it was read back, and the record of it that lies beside it."""

    path: Path
    format: str
    size: int
    check: FileCheck
    record: Path | None = None


@dataclass(frozen=True)
class ExportJob(Job):
    """Build a part of a member, or of the pair in mesh, and write it as ``MEMBER-PART.EXT``, once per format.

    A file appears under its name only when it is complete; one of that name is replaced. ``records`` asks for a
    record of what was made and found beside each file.
    """

    purpose: ClassVar[Purpose] = "export"

    design: Design
    member: MemberName | Literal["pair"]
    part: str
    method: str
    variant: Variant
    formats: Sequence[str]
    directory: Path
    construction: str = "assemble"
    options: ExportOptions = USUAL
    records: bool = False

    @property
    def label(self) -> str:
        return f"{self.member}-{self.part}, {', '.join(self.formats)}"

    def run(self, report: Report) -> tuple[ExportedFile, ...]:
        """Write the files.

        Raises
        ------
        FileError
            A part or format that is not offered, or a file that cannot be written there.
        ModellingError
            The method could not make the part.
        """
        self._check()
        report("building", 0.0)
        from gearstudio.exchange.record import Subject, write_record
        from gearstudio.exchange.solids import Product
        from gearstudio.exchange.verify import product

        subject = Subject(self.member, self.part, self.method, self.variant, self.construction, self.options)
        made = product(self.design, subject)
        if isinstance(made, Product) and any(format_ in SOLID_FORMATS for format_ in self.formats):
            made.solids(report)
        files = []
        for index, format_ in enumerate(self.formats):
            report(f"writing {format_}", (index + 1) / (len(self.formats) + 1))
            target = self._path(format_)
            with _complete_or_absent(target, self._unfinished(format_, os.getpid())) as path:
                check = made.write(path, format_)
            record = write_record(target, format_, self.design, subject, check) if self.records else None
            files.append(ExportedFile(target, format_, target.stat().st_size, check, record))
        return tuple(files)

    def clear_up(self, process_id: int) -> None:
        for format_ in self.formats:
            with contextlib.suppress(OSError):
                self._unfinished(format_, process_id).unlink()

    def _path(self, format_: str) -> Path:
        return Path(self.directory) / f"{self.member}-{self.part}.{format_}"

    def _unfinished(self, format_: str, process_id: int) -> Path:
        return self._path(format_).with_name(f".{process_id}-{self.member}-{self.part}.{format_}")

    def _check(self) -> None:
        """Refuse what cannot succeed before time is spent on building."""
        offered = FORMATS.get(self.part, ())
        for format_ in self.formats:
            path = self._path(format_)
            if not offered:
                raise FileError(path, f"the part {self.part!r} is not offered; parts: {', '.join(FORMATS)}")
            if format_ not in offered:
                raise FileError(path, f"{self.part} cannot be written as {format_!r}; formats: {', '.join(offered)}")
            if self.member == "pair" and self.part != "gear":
                raise FileError(path, f"of a pair only the part 'gear' is written, not {self.part!r}")
            if self.construction not in CONSTRUCTIONS:
                raise FileError(path, f"no construction {self.construction!r}; use {' or '.join(CONSTRUCTIONS)}")
            with named_errors(path):
                path.parent.mkdir(parents=True, exist_ok=True)
                if path.is_dir():
                    raise FileError(path, "there is a folder of this name")
                trial = self._unfinished(format_, os.getpid())
                trial.touch()
                trial.unlink()


def warm_up() -> None:
    """Import everything that jobs need, which takes seconds, before the first one comes."""
    import gearstudio.analysis.comparison
    import gearstudio.exchange.solids  # noqa: F401


@contextlib.contextmanager
def _complete_or_absent(path: Path, unfinished: Path) -> Iterator[Path]:
    """Yield a name to write to; what is written there becomes ``path`` as a whole, or vanishes."""
    try:
        with named_errors(path):
            try:
                yield unfinished
            except FileError as error:
                raise FileError(path, error.reason) from error
            with open(unfinished, "rb+") as file:
                os.fsync(file.fileno())
            os.replace(unfinished, path)
    finally:
        with contextlib.suppress(OSError):
            unfinished.unlink()
