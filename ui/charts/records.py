"""What a chart shows, as plain records; no widget."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ui.formatting import number, typed
from ui.units import to_shown, unit_shown
from ui.words import noted, told, tr

Floats = NDArray[np.float64]
Stroke = Literal["solid", "dash", "dot"]
ORDERS_APART = 30.0
"""From this ratio of the largest to the smallest curve on, a logarithmic axis reads better."""


DIGITS = 12
"""Of the numbers of a table."""
UNIT = re.compile(r"(.+) \[(.+)\]")
"""A heading with a unit."""
HEADINGS = (
    noted("series"), noted("method"), noted("count"), noted("poles"), noted("seconds"), noted("max"), noted("mean"),
    noted("rms"), noted("tooth"), noted("flank"), noted("member"), noted("face 0-1"), noted("profile 0-1"),
    noted("deviation"), noted("gap"), noted("ease-off"), noted("curvature"),
)  # fmt: skip
"""English headings of tables, as files have them; a copy for a spreadsheet has them in the window's language."""


def plain(value: float) -> str:
    """A number as short as it can be, with a true minus sign."""
    return number(value)


@dataclass(frozen=True)
class Axis:
    """Title, unit, whether it is logarithmic, and how a tick is written."""

    title: str
    unit: str = ""
    log: bool = False
    write: Callable[[float], str] = plain

    @property
    def heading(self) -> str:
        """Title and unit, as on the axis and in a table's head."""
        return f"{self.title} [{self.unit}]" if self.unit else self.title


@dataclass(frozen=True)
class Series:
    """A curve, or with ``steps`` the outline of a histogram: then x has the edges, one more than y.

    ``color`` is a role of :mod:`ui.charts.colors`. Gaps are NaN.
    """

    name: str
    x: Floats
    y: Floats
    color: str
    stroke: Stroke = "solid"
    width: float = 1.6
    symbols: bool = False
    steps: bool = False
    filled: bool = False


@dataclass(frozen=True)
class Reference:
    """A line across the chart at a value, with a label where there is room."""

    value: float
    label: str
    color: str = "muted"
    upright: bool = False
    below: bool = False


@dataclass(frozen=True)
class Band:
    """A shaded range of values with a label."""

    low: float
    high: float
    label: str


@dataclass(frozen=True)
class Entry:
    """One line of a legend."""

    text: str
    color: str
    stroke: Stroke = "solid"


@dataclass(frozen=True)
class ChartData:
    """Everything that one chart shows.

    Attributes
    ----------
    name : str
        For file names.
    note : str
        Shown in place of curves where there are none.
    ticks : sequence of (value, text), optional
        Of the x axis, where it is not a scale of numbers.
    span_x, span_y : (float, float), optional
        What must be in sight, at least.
    """

    name: str
    x: Axis
    y: Axis
    series: tuple[Series, ...] = ()
    references: tuple[Reference, ...] = ()
    bands: tuple[Band, ...] = ()
    legend: tuple[Entry, ...] = ()
    note: str = ""
    ticks: Sequence[tuple[float, str]] | None = None
    span_x: tuple[float, float] | None = None
    span_y: tuple[float, float] | None = None
    table: Table | None = field(default=None, compare=False)

    def looks_like(self, other: ChartData) -> bool:
        """Whether only the numbers of the curves differ."""

        def look(data: ChartData) -> object:
            spans = (data.span_x is None, data.span_y is None)
            rest = replace(data, name="", series=(), span_x=None, span_y=None)
            return (
                rest,
                spans,
                [(c.name, c.color, c.stroke, c.width, c.symbols, c.steps, c.filled) for c in data.series],
            )

        return look(self) == look(other)

    @property
    def numbers(self) -> Table:
        """The curves as a table: one line for each point."""
        return self.table or _table_of(self)


@dataclass(frozen=True)
class Table:
    """Columns of numbers under headings, as a file holds them."""

    head: tuple[str, ...]
    rows: Sequence[Sequence[object]]

    def shown(self) -> Table:
        """For a spreadsheet: headings, names and numbers in the window's language, lengths in its unit."""
        parts = [UNIT.fullmatch(title) for title in self.head]
        units = [part[2] if part else "" for part in parts]
        titles = [tr(part[1] if part else title) for part, title in zip(parts, self.head, strict=True)]
        head = [
            f"{title} [{tr(unit_shown(unit))}]" if unit else title for title, unit in zip(titles, units, strict=True)
        ]
        rows = [[_shown_cell(value, unit) for value, unit in zip(row, units, strict=True)] for row in self.rows]
        return Table(tuple(head), rows)

    def text(self, delimiter: str = ",") -> str:
        """As CSV (or, for a spreadsheet's clipboard, with tabs), numbers with 12 digits."""
        file = io.StringIO()
        writer = csv.writer(file, delimiter=delimiter, lineterminator="\n")
        writer.writerow(self.head)
        writer.writerows([_cell(value) for value in row] for row in self.rows)
        return file.getvalue()


def _cell(value: object) -> str:
    return f"{value:.{DIGITS}g}" if isinstance(value, float | np.floating) else str(value)


def _shown_cell(value: object, unit: str) -> object:
    if isinstance(value, str):
        return told(value)
    return typed(to_shown(float(value), unit), DIGITS) if isinstance(value, float | np.floating) else value


def _table_of(data: ChartData) -> Table:
    """Side by side where all curves share their x, else one below the other."""
    steps = [(series, series.x[:-1] if series.steps else series.x) for series in data.series]
    if steps and all(np.array_equal(x, steps[0][1]) for _, x in steps):
        head = (data.x.heading, *(f"{series.name} [{data.y.unit or data.y.title}]" for series, _ in steps))
        return Table(head, list(zip(steps[0][1], *(series.y for series, _ in steps), strict=True)))
    rows = [(series.name, x, y) for series, places in steps for x, y in zip(places, series.y, strict=True)]
    return Table(("series", data.x.heading, data.y.heading), rows)


def orders_apart(curves: Sequence[Floats]) -> bool:
    """Whether curves are so different in size that a logarithmic axis is needed to see them all."""
    sizes = [float(np.nanmax(np.abs(curve))) for curve in curves if np.size(curve) and np.any(np.isfinite(curve))]
    sizes = [size for size in sizes if size > 0]
    return bool(sizes) and max(sizes) > ORDERS_APART * min(sizes)


def micrometre_tick(value_um: float) -> str:
    """A deviation on an axis in the unit that reads best: ``10 µm``, ``0.1 nm``."""
    size = abs(value_um)
    if size == 0:
        return "0"
    unit, number = (
        ("µm", value_um) if size >= 0.1 else ("nm", value_um * 1e3) if size >= 1e-4 else ("pm", value_um * 1e6)
    )
    return f"{plain(round(number, 9))} {unit}"
