"""How the report's figures look; the only door to the drawing library."""

from __future__ import annotations

import io
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

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
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.linewidth": 0.3,
    "grid.color": "#c8ccd2",
    "lines.linewidth": 1.1,
    "xtick.major.width": 0.5,
    "ytick.major.width": 0.5,
    "legend.frameon": False,
    "legend.fontsize": 7,
    "svg.fonttype": "path",
    "figure.dpi": 200,
}


@contextmanager
def figure(height: float, rows: int = 1, columns: int = 1, **kwargs: Any) -> Iterator[tuple[Figure, Any]]:
    """A figure as wide as the text and `height` inches high, with its axes as an array (rows, columns)."""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    with mpl.rc_context(_LOOK):
        drawn = Figure(figsize=(TEXT_WIDTH, height), layout="constrained")
        yield drawn, drawn.subplots(rows, columns, squeeze=False, **kwargs)


def svg(drawn: Figure) -> bytes:
    """The figure as a drawing; maps inside it are pictures, everything else lines."""
    import matplotlib as mpl

    out = io.BytesIO()
    with mpl.rc_context(_LOOK):
        drawn.savefig(out, format="svg", metadata={"Date": None})
    return out.getvalue()
