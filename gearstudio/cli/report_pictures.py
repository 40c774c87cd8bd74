"""Pictures for the report, taken by the program's own ``screenshot`` in processes beside the other work."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from gearstudio.catalogue import MemberName
from gearstudio.words import noted

if TYPE_CHECKING:
    from gearstudio.report.store import Taken

_PICTURES = {
    "pair.png": ("--mode", "pair", "--size", "860x520", "--scale", "2", "--no-labels", "--transparent"),
    "views.jpg": ("--size", "780x300", "--scale", "3"),
}
_PATIENCE_S = 300.0
_NO_REASON, _TOO_LONG = noted("it ended without a reason"), noted("it took too long")


class Photographers:
    """Processes that take pictures of a design meanwhile.

    Parameters
    ----------
    design : str
        As on the command line.
    member : {"pinion", "wheel"}
    folder : Path
        For the pictures.
    language : str
        Of the words in them.
    """

    def __init__(self, design: str, member: MemberName, folder: Path, language: str) -> None:
        self._at_work: dict[str, tuple[Path, subprocess.Popen[bytes]]] = {}
        for name, options in _PICTURES.items():
            path = folder / name
            words = [*_this_program(), "screenshot", design, "--out", str(path), "--member", member, *options]
            words += ["--language", language]
            with _said(path).open("wb") as said:
                self._at_work[path.stem] = (path, subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=said))

    def taken(self) -> Taken:
        """The pictures, waited for, and why others are missing."""
        from gearstudio.report.store import Taken

        pictures, problems = {}, []
        for name, (path, process) in self._at_work.items():
            try:
                process.wait(_PATIENCE_S)
            except subprocess.TimeoutExpired:
                problems.append(f"{name}: {_TOO_LONG}")
                continue
            if process.returncode == 0 and path.is_file():
                pictures[name] = path.read_bytes()
            else:
                problems.append(f"{name}: {_last_line(_said(path).read_bytes())}")
        return Taken(pictures, tuple(problems))

    def close(self) -> None:
        """End those that are still at work."""
        for _, process in self._at_work.values():
            process.kill()
            process.wait()


@contextmanager
def photographers(design: str, member: MemberName, language: str) -> Iterator[Photographers]:
    """Processes at work, ended with the block."""
    with tempfile.TemporaryDirectory(prefix="gearstudio-pictures-") as folder:
        made = Photographers(design, member, Path(folder), language)
        try:
            yield made
        finally:
            made.close()


def _said(path: Path) -> Path:
    return path.with_suffix(".txt")


def _last_line(said: bytes) -> str:
    lines = said.decode("utf-8", "replace").strip().splitlines()
    return lines[-1].strip() if lines else _NO_REASON


def _this_program() -> list[str]:
    if getattr(sys, "frozen", False):
        return [sys.executable]
    return [sys.executable, str(Path(__file__).parents[2] / "main.py")]
