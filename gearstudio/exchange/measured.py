"""Measured points from a file (CSV, ``.dat``, columns with normals), and the nominal grid for measuring machines."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.measurement import MeasuredPoints
from gearstudio.errors import FileError
from gearstudio.exchange.points import point_cloud
from gearstudio.files import named_errors
from gearstudio.theory.cloud import Spacing
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.flank import FLANKS
from gearstudio.theory.modified import flank_of

Floats = NDArray[np.float64]

NOMINAL_HEADER = "x,y,z,nx,ny,nz,flank,row,column"
MODEL_SUFFIXES = (".step", ".stp")
_AXES = ("x", "y", "z")
_NORMALS = ("nx", "ny", "nz")
_ALIASES = {"i": "nx", "j": "ny", "k": "nz", "n_x": "nx", "n_y": "ny", "n_z": "nz"}
_LINES_AT_ONCE = 5_000
_NO_DATA = re.compile(r"\s*($|#|!|//|open\b|begin\b|end\b)", re.IGNORECASE)
_COLUMN = re.compile(r"\s*\"?\s*([a-z_]+)\s*(?:[\[(]\s*([^\])]*?)\s*[\])])?\s*\"?\s*$", re.IGNORECASE)
_OTHER_UNITS = {"in": "inches", "inch": "inches", "inches": "inches", '"': "inches", "m": "metres", "cm": "centimetres"}


def is_model(path: str | Path) -> bool:
    """Whether a file's name says that it is a CAD model, of which points are taken, and not a file of points."""
    return Path(path).suffix.lower() in MODEL_SUFFIXES


@dataclass(frozen=True)
class _Layout:
    """How the lines of a file are to be read."""

    delimiter: str | None
    decimal_comma: bool
    columns: tuple[int, ...]


def read_measured(path: str | Path, report: Callable[[float], None] | None = None) -> Iterator[MeasuredPoints]:
    """Read measured points, some at a time.

    Parameters
    ----------
    path : path
        Numbers in mm, separated by commas, semicolons, tabs or blanks. A header may name the columns (x, y, z and
        nx, ny, nz; others are skipped); without one there are 3 columns, or 6 with normals.
    report : callable, optional
        Told the part of the file read.

    Raises
    ------
    FileError
        The file cannot be read, has other columns, other units, or something that is not a number, with its line.
    """
    path = Path(path)
    with named_errors(path, reading=True), open(path, encoding="utf-8-sig", errors="replace") as file:
        size, done, number = max(path.stat().st_size, 1), 0, 0
        layout: _Layout | None = None
        while lines := list(islice(file, _LINES_AT_ONCE)):
            done += sum(map(len, lines))
            if layout is None:
                layout, skipped = _layout(path, lines)
                data = lines[skipped:] if layout else []
                number += skipped
            else:
                data = lines
            if layout is not None:
                numbered = [(number + i, line) for i, line in enumerate(data, 1) if not _NO_DATA.match(line)]
                if numbered:
                    yield _points(_table(path, layout, numbered))
                number += len(data)
            if report is not None:
                report(min(done / size, 1.0))
        if layout is None:
            raise FileError(path, "there are no points in it")


def nominal_grid_text(member: MemberGeometry, rows: int, cols: int, spacing: Spacing = "uniform") -> str:
    """The nominal points and normals of both flanks of the tooth at azimuth 0, as CSV.

    Rows run from toe to heel, columns from root (or base cone) to tip, edges included; normals point out of the
    metal. `read_measured` reads it back.
    """
    lines = [NOMINAL_HEADER]
    for name in FLANKS:
        cloud = point_cloud(flank_of(member, name), rows, cols, spacing)
        table = np.concatenate([cloud.points, cloud.normals], axis=-1)
        for (row, column), values in zip(np.ndindex(rows, cols), table.reshape(-1, 6), strict=True):
            numbers = ",".join(f"{value:.17g}" for value in values)
            lines.append(f"{numbers},{name},{row + 1},{column + 1}")
    return "\n".join(lines) + "\n"


def _points(table: Floats) -> MeasuredPoints:
    return MeasuredPoints(table[:, :3], table[:, 3:] if table.shape[1] == 6 else None)


def _layout(path: Path, lines: Sequence[str]) -> tuple[_Layout | None, int]:
    """The layout that the first line of data has, and the lines before the data."""
    for index, line in enumerate(lines):
        header = _header(path, line.lstrip(" \t#!"))
        if header is not None:
            return header, index + 1
        if not _NO_DATA.match(line):
            return _headless(path, line, index + 1), index
    return None, len(lines)


def _header(path: Path, line: str) -> _Layout | None:
    """The layout by the names of a header line; None where the line is none."""
    delimiter = _delimiter(line)
    matches = [_COLUMN.match(cell) for cell in line.strip().split(delimiter)]
    names = [_ALIASES.get(match[1].lower(), match[1].lower()) if match else "" for match in matches]
    if not set(_AXES) & set(names):
        return None
    missing = [axis for axis in _AXES if axis not in names]
    if missing:
        raise FileError(path, f"the header names no column {' and '.join(missing)}; it needs x, y and z")
    for match in matches:
        unit = (match[2] or "").lower() if match else ""
        if unit in _OTHER_UNITS:
            raise FileError(path, f"the header says {_OTHER_UNITS[unit]}; convert the points to mm")
    wanted = (*_AXES, *_NORMALS) if set(_NORMALS) <= set(names) else _AXES
    return _Layout(delimiter, delimiter == ";", tuple(names.index(name) for name in wanted))


def _headless(path: Path, line: str, number: int) -> _Layout:
    delimiter = _delimiter(line)
    cells = line.strip().rstrip(delimiter).split(delimiter)
    if len(cells) not in (3, 6):
        raise FileError(
            path,
            f"line {number} has {len(cells)} column{'s' * (len(cells) != 1)}; give x, y, z or x, y, z, nx, ny, nz, "
            "or name the columns in a header line",
        )
    return _Layout(delimiter, delimiter != "," and "," in line, tuple(range(len(cells))))


def _delimiter(line: str) -> str | None:
    """The separator of a line's cells; None for blanks."""
    for delimiter in (";", "\t"):
        if delimiter in line.strip():
            return delimiter
    if "," in line and not re.search(r"\d,\d+\s+[-+\d]", line):
        return ","
    return None


def _table(path: Path, layout: _Layout, numbered: Sequence[tuple[int, str]]) -> Floats:
    """The wanted columns of some lines, shape (n, 3 or 6)."""
    lines = [line.replace(",", ".") if layout.decimal_comma else line for _, line in numbered]
    try:
        table = np.loadtxt(lines, delimiter=layout.delimiter, usecols=layout.columns, ndmin=2, comments=None)
    except ValueError:
        table = np.full((1, 1), np.nan)
    if np.all(np.isfinite(table)):
        return np.asarray(table, dtype=np.float64)
    raise FileError(path, _first_problem(layout, numbered, lines))


def _first_problem(layout: _Layout, numbered: Sequence[tuple[int, str]], lines: Sequence[str]) -> str:
    for (number, _), line in zip(numbered, lines, strict=True):
        cells = [cell.strip() for cell in line.strip().split(layout.delimiter)]
        if len(cells) <= max(layout.columns):
            return f"line {number} has {len(cells)} columns, where {max(layout.columns) + 1} or more are needed"
        for column in layout.columns:
            try:
                value = float(cells[column])
            except ValueError:
                return f"line {number}: {cells[column][:40]!r} is not a number"
            if not np.isfinite(value):
                return f"line {number}: {cells[column][:40]!r} is not a finite number"
    return "it holds something that is not a number"
