"""What every command shares: text and JSON to a file or standard output, tables, progress, problems."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from gearstudio.files import write_text

STANDARD_OUTPUT = "-"
_BAR = 24


def write_output(target: str, text: str) -> None:
    """Write UTF-8 text to a file, or to standard output for ``-``; raises FileError."""
    if target != STANDARD_OUTPUT:
        write_text(Path(target), text)
        return
    sys.stdout.flush()
    binary = getattr(sys.stdout, "buffer", None)
    if binary is None:
        sys.stdout.write(text)
    else:
        binary.write(text.encode("utf-8"))
        binary.flush()


def write_json(target: str, data: Mapping[str, Any]) -> None:
    """Write tables of plain values as JSON; arrays become lists."""
    write_output(target, json.dumps(data, indent=2, ensure_ascii=False, default=_plain) + "\n")


def problem(text: str) -> None:
    """One line about one problem on standard error."""
    line = "".join(letter if letter.isprintable() else " " for letter in text)
    print(line, file=sys.stderr)


def table(rows: Sequence[Sequence[str]], left: Iterable[int] = (0,)) -> str:
    """Text of aligned columns; those named by ``left`` start at their left edge, the others end at their right."""
    lefts = set(left)
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    lines = (
        "  ".join(
            cell.ljust(w) if k in lefts else cell.rjust(w) for k, (cell, w) in enumerate(zip(row, widths, strict=True))
        )
        for row in rows
    )
    return "\n".join(line.rstrip() for line in lines)


class Progress:
    """A bar on standard error when that is a terminal; nothing otherwise."""

    def __init__(self) -> None:
        self._shown = sys.stderr.isatty()

    def __call__(self, stage: str, fraction: float) -> None:
        """Show the stage that begins and the fraction done, 0 to 1."""
        if self._shown:
            done = round(_BAR * min(max(fraction, 0.0), 1.0))
            print(f"\r\x1b[K[{'#' * done}{'.' * (_BAR - done)}] {stage}", end="", file=sys.stderr, flush=True)

    def clear(self) -> None:
        """Take the bar away."""
        if self._shown:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)


def _plain(value: object) -> object:
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, Mapping):
        return dict(value)
    return str(value)
