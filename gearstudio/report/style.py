"""How the report's figures look; the only door to the drawing library.

Axes are put where they belong by their sizes in inches: fitting them around their letters would take most of the time.
"""

from __future__ import annotations

import io
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from gearstudio.report.fonts import cjk_family
from gearstudio.report.language import CJK, notation, number, spoken

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TEXT_WIDTH = 6.69
"""Of the page [inch]."""
COLORS = {"rotating_line": "#0b62b8", "profile_sweep": "#c2570c", "point_cloud": "#0f8a6d"}
SIDES = {"concave": "#0b62b8", "convex": "#c2570c", "drive": "#0b62b8", "coast": "#c2570c"}
DIVERGING, SEQUENTIAL, PATTERN = "RdBu_r", "viridis", "YlGnBu_r"

_LOOK: dict[str, Any] = {
    "font.size": 7.5,
    "font.family": "DejaVu Sans",
    "axes.linewidth": 0.6,
    "axes.titlesize": 7.5,
    "axes.titlelocation": "left",
    "axes.titlepad": 4.0,
    "axes.titley": 1.0,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.formatter.useoffset": False,
    "grid.linewidth": 0.3,
    "grid.color": "#c8ccd2",
    "lines.linewidth": 1.1,
    "xtick.major.width": 0.5,
    "ytick.major.width": 0.5,
    "xtick.major.size": 2.5,
    "ytick.major.size": 2.5,
    "legend.frameon": False,
    "legend.fontsize": 7,
    "svg.fonttype": "path",
    "svg.hashsalt": "gearstudio",
    "figure.dpi": 150,
}
_BAR, _BAR_GAP, _BAR_TEXT = 0.08, 0.05, 0.33
_SHADES = 48
_RIGHT, _RIGHT_OF_TICKS, _TOP, _BOTTOM = 0.06, 0.16, 0.2, 0.37


@dataclass(frozen=True)
class Frame:
    """How a figure is divided.

    Attributes
    ----------
    height : float
        Of the figure [inch]; it is as wide as the text.
    rows, columns : int
    bars : "none", "each" or "row"
        Room for a colour scale to the right of each axes, or of the last in a row.
    foot : float
        Room below the axes, beyond their own letters [inch].
    own_x, own_y : bool
        Every axes has a scale of its own there; else they share one.
    left : float
        Room to the left of the axes for long numbers [inch].
    """

    height: float
    rows: int = 1
    columns: int = 1
    bars: Literal["none", "each", "row"] = "none"
    foot: float = 0.0
    own_x: bool = False
    own_y: bool = False
    left: float = 0.52


@contextmanager
def figure(frame: Frame) -> Iterator[tuple[Figure, Any]]:
    """A figure with its axes as an array (rows, columns)."""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    side = _BAR + _BAR_GAP + _BAR_TEXT if frame.bars != "none" else 0.0
    right = _RIGHT + side if side else _RIGHT_OF_TICKS
    wide = (TEXT_WIDTH - frame.left - right) / frame.columns
    gap = (side if frame.bars == "each" else 0.0) + (0.38 if frame.own_y else 0.3 if frame.own_x else 0.14)
    high = (frame.height - _TOP - _BOTTOM - frame.foot) / frame.rows
    fall = 0.42 if frame.own_x else 0.24
    width = wide - gap * (frame.columns - 1) / frame.columns
    length = high - fall * (frame.rows - 1) / frame.rows
    with mpl.rc_context(_look()):
        drawn = Figure(figsize=(TEXT_WIDTH, frame.height))
        axes = drawn.subplots(
            frame.rows, frame.columns, squeeze=False, sharex=not frame.own_x, sharey=not frame.own_y,
            gridspec_kw={
                "left": frame.left / TEXT_WIDTH, "right": 1 - right / TEXT_WIDTH,
                "top": 1 - _TOP / frame.height, "bottom": (_BOTTOM + frame.foot) / frame.height,
                "wspace": gap / width, "hspace": fall / length,
            },
        )  # fmt: skip
        yield drawn, axes


def _look() -> dict[str, Any]:
    """With a font for the characters of the report's language."""
    family = cjk_family() if spoken().code in CJK else None
    return _LOOK if family is None else {**_LOOK, "font.family": ["DejaVu Sans", family]}


def svg(drawn: Figure) -> bytes:
    """The figure as a drawing; maps inside it are pictures, everything else lines."""
    import matplotlib as mpl
    from matplotlib.backends.backend_svg import FigureCanvasSVG

    out = io.BytesIO()
    for ax in drawn.axes if spoken().decimal != "." else ():
        for axis in (ax.xaxis, ax.yaxis):
            axis.set_major_formatter(_written(axis.get_major_formatter()))
    with mpl.rc_context(_look()):
        FigureCanvasSVG(drawn).print_svg(out, metadata={"Date": None})
    return out.getvalue()


def _written(formatter: Any) -> Any:
    """A formatter of ticks whose numbers are as the report's language writes them."""
    from matplotlib.ticker import Formatter

    class Written(Formatter):
        """Ticks of another formatter."""

        def __call__(self, value: float, position: int | None = None) -> str:
            return notation(formatter(value, position))

        def format_ticks(self, values: Any) -> list[str]:
            return [notation(text) for text in formatter.format_ticks(values)]

    return Written()


def scale(drawn: Figure, ax: Any, shown: Any, unit: str, ticks: Sequence[float]) -> None:
    """The colour scale of a map to the right of its axes, with the unit above it."""
    from matplotlib.collections import PolyCollection
    from matplotlib.patches import Rectangle

    box = ax.get_position()
    low, high = shown.get_clim()
    x0, x1 = (box.x1 + part / TEXT_WIDTH for part in (_BAR_GAP, _BAR_GAP + _BAR))
    edges = np.linspace(box.y0, box.y1, _SHADES + 1)
    cells = [((x0, a), (x1, a), (x1, b), (x0, b)) for a, b in pairwise(edges)]
    colors = shown.get_cmap()((np.arange(_SHADES) + 0.5) / _SHADES)
    drawn.add_artist(
        PolyCollection(cells, facecolors=colors, edgecolors=colors, linewidths=0.2, transform=drawn.transFigure)
    )
    frame = Rectangle((x0, box.y0), x1 - x0, box.height, fill=False, lw=0.4, ec="#30343a", transform=drawn.transFigure)
    drawn.add_artist(frame)
    for tick in ticks:
        y = box.y0 + box.height * (tick - low) / (high - low)
        drawn.text(x1 + 0.03 / TEXT_WIDTH, y, number(tick, "g"), fontsize=6, va="center_baseline")
    drawn.text(x0, box.y1 + 0.05 / drawn.get_figheight(), unit, fontsize=6, va="bottom")


def rounded_up(value: float) -> float:
    """The next of 1, 1.5, 2, 3, 5, 8 times a power of ten, for ends of scales."""
    power = 10.0 ** np.floor(np.log10(value))
    return float(power * next((step for step in (1, 1.5, 2, 3, 5, 8, 10) if step >= value / power * (1 - 1e-9)), 10))


def length_unit(largest_um: float) -> tuple[str, float]:
    """The unit that a small length reads best in, and its factor to µm."""
    return ("µm", 1.0) if largest_um >= 0.1 else ("nm", 1e3) if largest_um >= 1e-4 else ("pm", 1e6)


def few_ticks(axis: Any, low: float, high: float) -> None:
    """Ticks 1, 2, 5 of each power on a logarithmic axis that spans little, whole powers on another one."""
    steps = (1, 2, 5) if high / low < 300 else (1,)
    first, last = int(np.floor(np.log10(low))), int(np.ceil(np.log10(high)))
    ticks = [s * 10.0**p for p in range(first, last + 1) for s in steps if low <= s * 10.0**p <= high]
    axis.set_ticks(ticks, [np.format_float_positional(tick, precision=9, trim="-") for tick in ticks])
    axis.set_ticks([], minor=True)
