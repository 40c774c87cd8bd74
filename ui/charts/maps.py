"""What a map of flanks drawn flat shows, as plain records; no widget."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ui.charts.records import Table, plain

Floats = NDArray[np.float64]
Colors = Callable[[Floats], NDArray[np.uint8]]
"""From values, NaN where there is nothing, to RGBA, shape (..., 4)."""


@dataclass(frozen=True)
class Line:
    """A polyline over a map, shape (n, 2); with ``pairs`` a stroke from each even point to the next."""

    points: Floats
    color: str
    width: float = 2.0
    pairs: bool = False


@dataclass(frozen=True)
class FlankMap:
    """Values on a flank drawn flat.

    Attributes
    ----------
    image : ndarray, shape (rows, columns)
        Row 0 at the root; NaN outside.
    extent : (x0, y0, width, height)
    outline : ndarray, shape (n, 2)
    describe : callable
        What to say of a value when pointed at.
    reach : float
        How far lines may go beyond the outline, up and down.
    """

    title: str
    image: Floats
    extent: tuple[float, ...]
    outline: Floats
    lines: tuple[Line, ...] = ()
    describe: Callable[[float], str] = plain
    reach: float = 0.0


@dataclass(frozen=True)
class Scale:
    """The ends of the colours, and how they are written."""

    low: float
    high: float
    title: str
    write: Callable[[float], str]


@dataclass(frozen=True)
class MapData:
    """Some maps that are coloured alike.

    ``colors`` is asked again when the theme changes, ``table`` when the numbers are copied or saved.
    """

    name: str
    maps: tuple[FlankMap, ...] = ()
    colors: Colors | None = field(default=None, compare=False)
    across: bool = False
    scale: Scale | None = None
    table: Callable[[], Table] = field(default=lambda: Table((), ()), compare=False)
