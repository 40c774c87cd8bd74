"""The parts a chart is drawn with: pens, axes, curves, the text of a legend."""

from __future__ import annotations

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPen
from PySide6.QtWidgets import QGraphicsItem

from ui.charts.colors import chart_color
from ui.charts.records import Axis, Entry, Series, Stroke

STROKES = {"solid": Qt.PenStyle.SolidLine, "dash": Qt.PenStyle.DashLine, "dot": Qt.PenStyle.DotLine}
SWATCHES = {"solid": "━━", "dash": "╍╍", "dot": "┈┈"}


def pen(color: QColor, stroke: Stroke = "solid", width: float = 1.0) -> QPen:
    """A pen that keeps its width whatever the scale."""
    made = QPen(color, width, STROKES[stroke])
    made.setCosmetic(True)
    return made


class ChartAxis(pg.AxisItem):
    """An axis whose ticks are written by a function; one label for each decade when it is logarithmic."""

    def __init__(self, side: str) -> None:
        super().__init__(side)
        self.setStyle(tickLength=-5, autoExpandTextSpace=True, hideOverlappingLabels=True)
        self.enableAutoSIPrefix(False)
        self.setCacheMode(QGraphicsItem.CacheMode.DeviceCoordinateCache)
        self._axis = Axis("")

    def show_axis(self, axis: Axis) -> None:
        """Take title and notation."""
        self._axis = axis
        self.setLabel(axis.heading)
        self.picture = None
        self.update()

    def tickStrings(self, values: list[float], scale: float, spacing: float) -> list[str]:
        if self.logMode:
            whole = [abs(value - round(value)) < 1e-6 for value in values]
            return [self._axis.write(10.0**value) if shown else "" for value, shown in zip(values, whole, strict=True)]
        digits = max(0, 3 - int(np.floor(np.log10(spacing)))) if spacing > 0 else 6
        return [self._axis.write(round(value, digits) + 0.0) for value in values]


def curve(series: Series) -> pg.PlotDataItem:
    """The item that draws a curve."""
    color = chart_color(series.color)
    options: dict[str, object] = {"pen": pen(color, series.stroke, series.width), "connect": "finite"}
    if series.steps:
        options |= {"stepMode": "center", "connect": "all"}
    if series.filled:
        options |= {"fillLevel": 0, "brush": chart_color(series.color, 0.14)}
    if series.symbols:
        ground = chart_color("surface") if series.stroke != "solid" else color
        options |= {"symbol": "o", "symbolSize": 6, "symbolBrush": ground, "symbolPen": pen(color, width=1.4)}
    return pg.PlotDataItem(series.x, series.y, **options)


def legend_text(entries: tuple[Entry, ...]) -> str:
    """A legend as rich text in one line."""
    text = chart_color("muted").name()
    parts = [
        f'<span style="color:{chart_color(entry.color).name()}">{SWATCHES[entry.stroke]}</span>'
        f'&nbsp;<span style="color:{text}">{entry.text.replace(" ", "&nbsp;")}</span>'
        for entry in entries
    ]
    return "&nbsp;&nbsp; ".join(parts)
