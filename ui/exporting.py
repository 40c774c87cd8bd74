"""Exports of the window: has the CAD process write them, and tells what was written."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject

from gearstudio.jobs import ExportedFile
from ui.formatting import number
from ui.units import spaced, to_shown
from ui.words import retold, told, tr

if TYPE_CHECKING:
    from gearstudio.jobs import Job
    from ui.files import Files
    from ui.messages import MessageBar
    from ui.runner import JobRunner


class Exporting(QObject):
    """What `Files` requests goes to the CAD process, and what became of it to the messages."""

    def __init__(self, files: Files, messages: MessageBar, parent: QObject) -> None:
        super().__init__(parent)
        self._messages = messages
        self._runner: JobRunner | None = None
        files.export_requested.connect(self._submit)

    def use_runner(self, runner: JobRunner) -> None:
        """The CAD process can be started."""
        self._runner = runner
        runner.job_done.connect(self._on_done)
        runner.job_failed.connect(self._on_failed)

    def _submit(self, job: Job) -> None:
        if self._runner is not None:
            self._runner.submit((job,))

    def _on_done(self, job: Job, files: Any) -> None:
        if job.purpose == "export":
            self._messages.show_message("info", *export_report(files), topic="export")

    def _on_failed(self, job: Job, text: str, details: str) -> None:
        if job.purpose == "export":
            words = tr("The export failed: {text}", text=told(text))
            self._messages.show_message("error", words, details, topic="export")


def export_report(files: tuple[ExportedFile, ...]) -> tuple[str, str]:
    """What an export wrote: a line, and what was found on reading each file back."""
    folder = str(files[0].path.parent) if files else ""
    line = tr("Wrote {names} to {folder}; read back and checked", names=_names(files), folder=folder)
    return line, _details(files)


@retold
def _names(files: tuple[ExportedFile, ...]) -> str:
    return ", ".join(f"{file.path.name} ({_size(file.size)})" for file in files)


@retold
def _details(files: tuple[ExportedFile, ...]) -> str:
    return "\n".join(map(_found, files))


def _found(file: ExportedFile) -> str:
    check = file.check
    lines = [f"{file.path.name}: {told(check)}"]
    low, high = check.box
    box = " × ".join(number(to_shown(b - a, "mm")) for a, b in zip(low, high, strict=True)) + spaced("mm")
    lines.append(tr("box {box} · read by {kernel}", box=box, kernel=check.kernel))
    for face in check.worst:
        words = tr("{member} {face}: within {largest} µm of theory ({limit} µm allowed)",
                   member=tr(face.member), face=told(face.title), largest=number(face.largest_um, ".4f"),
                   limit=number(face.limit_um, ".4f"))  # fmt: skip
        lines.append(words)
    if check.chord_um is not None and check.chord_limit_um is not None:
        lines.append(
            tr("triangles within {um} µm of theory ({limit} µm allowed)",
               um=number(check.chord_um, ".4g"), limit=number(check.chord_limit_um, ".4g"))
        )  # fmt: skip
    lines += map(told, check.remarks)
    if file.record is not None:
        lines.append(tr("record: {name}", name=file.record.name))
    return "\n  ".join(lines)


def _size(size: int) -> str:
    return f"{number(size / 1e6, '.1f')} MB" if size >= 1e6 else f"{max(size / 1e3, 1):.0f} kB"
