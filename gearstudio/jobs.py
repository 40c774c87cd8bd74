"""The jobs of the CAD process, as frozen records that carry themselves out.

The window sends them to its CAD process, the command line runs them directly. Importing this module loads
neither numpy nor the CAD kernel, so that a new process is alive at once; running a job does.
"""

from __future__ import annotations

import contextlib
import errno
import os
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar, Literal

from gearstudio.errors import FileError

if TYPE_CHECKING:
    from gearstudio.catalogue import MemberName, Variant
    from gearstudio.design import Design
    from gearstudio.nurbs import NurbsSurface
    from gearstudio.results import SolidResult, VariantResult

Report = Callable[[str, float], None]
"""Takes the stage that begins and the fraction done, 0 to 1."""

Purpose = Literal["build", "solid", "export"]

FLANK_FORMATS = ("step",)
_EXPORT_SAMPLES = (9, 9)
_READ_BACK_MM = 1e-6
_REASONS = {
    errno.EACCES: "no permission to write there",
    errno.EPERM: "no permission to write there",
    errno.EROFS: "the disk is read-only",
    errno.ENOENT: "the folder cannot be made",
    errno.EFBIG: "the file is too large for this disk",
    errno.ENOSPC: "the disk is full",
    errno.EDQUOT: "the disk quota is used up",
    errno.ENOTDIR: "a part of the path is a file, not a folder",
    errno.EEXIST: "there is a file where the folder should be",
    errno.EISDIR: "there is a folder of this name",
    errno.ENAMETOOLONG: "the name is too long",
}


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
class ExportedFile:
    """A file that an export wrote."""

    path: Path
    format: str
    size: int


@dataclass(frozen=True)
class ExportJob(Job):
    """Build a part of a member and write it as ``MEMBER-PART.EXT``, once per format.

    A file appears under its name only when it is complete; one of that name is replaced.
    """

    purpose: ClassVar[Purpose] = "export"

    design: Design
    member: MemberName
    part: str
    method: str
    variant: Variant
    formats: Sequence[str]
    directory: Path

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
        from gearstudio.analysis.comparison import build_variant

        self._check()
        report("building", 0.0)
        result = build_variant(self.design, self.member, self.method, self.variant, _EXPORT_SAMPLES)
        surfaces = {flank: made.surface for flank, made in result.flanks.items()}
        name = f"{self.member}-{self.part}"
        files = []
        for index, format_ in enumerate(self.formats):
            report(f"writing {format_}", (index + 1) / (len(self.formats) + 1))
            with _complete_or_absent(self._path(format_), self._unfinished(format_, os.getpid())) as path:
                _write_flanks(path, surfaces, name)
            files.append(ExportedFile(self._path(format_), format_, self._path(format_).stat().st_size))
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
        for format_ in self.formats:
            path = self._path(format_)
            if self.part != "flanks":
                raise FileError(path, f"the part {self.part!r} is not offered; parts: flanks")
            if format_ not in FLANK_FORMATS:
                raise FileError(path, f"flanks cannot be written as {format_!r}; formats: {', '.join(FLANK_FORMATS)}")
            with _named(path):
                path.parent.mkdir(parents=True, exist_ok=True)
                if path.is_dir():
                    raise IsADirectoryError(errno.EISDIR, "is a directory")
                trial = self._unfinished(format_, os.getpid())
                trial.touch()
                trial.unlink()


def warm_up() -> None:
    """Import everything that jobs need, which takes seconds, before the first one comes."""
    import gearstudio.analysis.comparison
    import gearstudio.kernel.step  # noqa: F401


def _write_flanks(path: Path, surfaces: Mapping[str, NurbsSurface], name: str) -> None:
    """Write the flanks and make sure that the file holds them."""
    import numpy as np

    from gearstudio.kernel.step import read_flanks_step, write_flanks_step

    write_flanks_step(path, surfaces, name)
    read = read_flanks_step(path)
    if set(read) != set(surfaces):
        raise FileError(path, "the file is not complete after writing; the disk may be full")
    for flank, surface in surfaces.items():
        if np.abs(read[flank].uniform_grid(9, 9) - surface.uniform_grid(9, 9)).max() > _READ_BACK_MM:
            raise FileError(path, f"the {flank} flank is not the same after reading the file back")


@contextlib.contextmanager
def _complete_or_absent(path: Path, unfinished: Path) -> Iterator[Path]:
    """Yield a name to write to; what is written there becomes ``path`` as a whole, or vanishes."""
    try:
        with _named(path):
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


@contextlib.contextmanager
def _named(path: Path) -> Iterator[None]:
    """Turn what the operating system refuses into a FileError about the file that the user asked for."""
    try:
        yield
    except OSError as error:
        raise FileError(path, _REASONS.get(error.errno or 0, error.strerror or str(error))) from error
