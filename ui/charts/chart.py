"""A chart of curves that can be read, copied and saved."""

from __future__ import annotations

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QPointF
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QWidget

from ui.charts.canvas import Canvas
from ui.charts.colors import chart_color
from ui.charts.parts import ChartAxis, curve, legend_text, pen
from ui.charts.records import Axis, ChartData, Reference, Series, Table

GRID_ALPHA = 40
LABEL_GAP_PX = 13
REACH_PX = 40.0
LEAST_FILLED = 0.5
"""While the curves fill this part of the height, the scale stays as they move."""


class Chart(Canvas):
    """Axes, curves and legend of a :class:`ChartData`; the wheel zooms, a double click shows everything again."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.data = ChartData("chart", Axis(""), Axis(""))
        self._view.ci.layout.setContentsMargins(4, 4, 8, 2)
        self._view.ci.layout.setVerticalSpacing(0)
        self._legend = self._view.addLabel("", row=0, col=0, justify="left")
        self._axes = {side: ChartAxis(side) for side in ("bottom", "left")}
        self.plot = self._view.addPlot(row=1, col=0, axisItems=self._axes)
        self.plot.setMenuEnabled(False)
        self.plot.hideButtons()
        self._note = pg.TextItem(anchor=(0.5, 0.5))
        self._readout = pg.TextItem(anchor=(0, 1))
        self._marker = pg.ScatterPlotItem(size=8)
        self._lines: list[tuple[pg.InfiniteLine, Reference]] = []
        self._curves: list[pg.PlotDataItem] = []
        self._spans: list[pg.PlotDataItem] = []
        self._held = False
        self._view.scene().sigMouseMoved.connect(self._on_moved)
        self._view.scene().sigMouseClicked.connect(self._on_clicked)
        self.plot.vb.sigRangeChangedManually.connect(self._on_zoomed)
        self.plot.vb.sigRangeChanged.connect(lambda *_: self._declutter())
        self.plot.vb.sigResized.connect(lambda *_: self._declutter())
        self.setMinimumSize(220, 140)
        self.refresh_theme()

    # ---- what is shown -------------------------------------------------------------------------------

    def show_data(self, data: ChartData) -> None:
        """Show other data; the scale follows it, unless the user has chosen one and only numbers have changed."""
        before, self.data = self.data, data
        if data.looks_like(before) and self._curves:
            self._move()
        else:
            self._fill()
            self.plot.enableAutoRange()

    def view_all(self) -> None:
        """Scale to everything there is."""
        self.plot.enableAutoRange()

    def refresh_theme(self) -> None:
        """Take the colours of the theme in use."""
        self._view.setBackground(chart_color("surface"))
        text, line = chart_color("muted"), chart_color("border_strong")
        for axis in self._axes.values():
            axis.setPen(pen(line))
            axis.setTextPen(text)
            axis.setTickFont(self.font())
            axis.label.setFont(self.font())
            axis.setGrid(GRID_ALPHA)
        self._fill()

    @property
    def table(self) -> Table:
        """The numbers shown."""
        return self.data.numbers

    # ---- drawing -------------------------------------------------------------------------------------

    def _fill(self) -> None:
        data, plot = self.data, self.plot
        plot.clear()
        self._lines, self._spans = [], []
        plot.setLogMode(x=data.x.log, y=data.y.log)
        for side, axis in (("bottom", data.x), ("left", data.y)):
            self._axes[side].show_axis(axis)
        self._axes["bottom"].setTicks(None if data.ticks is None else [list(data.ticks)])
        self._legend.setText(legend_text(data.legend))
        for axis in self._axes.values():
            axis.setStyle(showValues=bool(data.series))
        for band in data.bands:
            self._add_band(band.low, band.high, band.label)
        for reference in data.references:
            self._add_line(reference)
        self._curves = [curve(series) for series in data.series]
        self._spans = [pg.PlotDataItem(*places, pen=pen(QColor(0, 0, 0, 0))) for places in self._span_places()]
        for item in (*self._curves, *self._spans):
            plot.addItem(item)
        self._marker.setData([], [])
        for item in (self._marker, self._readout, self._note):
            plot.addItem(item, ignoreBounds=True)
        self._readout.setText("")
        self._note.setText(data.note, color=chart_color("muted"))
        self._declutter()

    def _move(self) -> None:
        """Give the curves other numbers."""
        for item, series in zip(self._curves, self.data.series, strict=True):
            item.setData(series.x, series.y)
        for item, places in zip(self._spans, self._span_places(), strict=True):
            item.setData(*places)
        self._hold_scale()

    def _hold_scale(self) -> None:
        """Leave the scale as it is while the curves fit it well: a slider then moves curves, not axes."""
        box = self.plot.vb
        if not (self._held or box.autoRangeEnabled()[1]):
            return
        found = [item.dataBounds(1) for item in (*self._curves, *self._spans)]
        ends = [end for low_high in found for end in low_high if end is not None]
        low, high = box.viewRange()[1]
        fits = bool(ends) and low <= min(ends) and max(ends) <= high
        self._held = fits and max(ends) - min(ends) >= LEAST_FILLED * (high - low)
        box.enableAutoRange(box.YAxis, not self._held)

    def _span_places(self) -> list[tuple[list[float], list[float]]]:
        """Unseen strokes, so that the scale reaches over the spans."""
        first = next((s for s in self.data.series if s.y.size), None)
        x, y = (1.0, 1.0) if first is None else (float(first.x[0]), float(first.y[0]))
        strokes = []
        if self.data.span_x is not None:
            strokes.append((list(self.data.span_x), [y, y]))
        if self.data.span_y is not None:
            strokes.append(([x, x], list(self.data.span_y)))
        return strokes

    def _add_band(self, low: float, high: float, label: str) -> None:
        ends = np.log10([low, high]) if self.data.y.log else (low, high)
        region = pg.LinearRegionItem(
            ends, "horizontal", brush=chart_color("warning", 0.12), pen=pen(chart_color("warning", 0.5)), movable=False
        )
        text = pg.InfLineLabel(region.lines[1], label, position=0.01, anchors=[(0, 1), (0, 1)])
        text.setColor(chart_color("warning"))
        text.setFont(self.font())
        self.plot.addItem(region)

    def _add_line(self, reference: Reference) -> None:
        upright = reference.upright
        logarithmic = self.data.x.log if upright else self.data.y.log
        beside = (1, 0) if reference.below else (1, 1)
        line = pg.InfiniteLine(
            np.log10(reference.value) if logarithmic else reference.value,
            90 if upright else 0,
            pen(chart_color(reference.color, 0.8), "dot", 1.2),
            label=reference.label,
            labelOpts={"position": 0.99, "anchors": [beside, beside], "color": chart_color(reference.color)},
        )
        line.label.setFont(self.font())
        self.plot.addItem(line)
        self._lines.append((line, reference))

    def _declutter(self) -> None:
        """Hide labels that would lie on one another, and put the note in the middle."""
        box = self.plot.vb
        range_x, range_y = box.viewRange()
        self._note.setPos(sum(range_x) / 2, sum(range_y) / 2)
        pixel_x, pixel_y = box.viewPixelSize()
        for upright, pixel in ((True, pixel_x), (False, pixel_y)):
            lines = [(line, reference) for line, reference in self._lines if reference.upright == upright]
            places = sorted(line.value() / pixel - LABEL_GAP_PX * one.below for line, one in lines) if pixel else []
            room = bool(places) and all(np.diff(places) >= LABEL_GAP_PX)
            for line, _ in lines:
                line.label.setVisible(room)

    # ---- pointing ------------------------------------------------------------------------------------

    def _on_zoomed(self, *_: object) -> None:
        self._held = False

    def _on_clicked(self, event: object) -> None:
        if event.double():  # type: ignore[attr-defined]
            self.view_all()

    def _on_moved(self, place: QPointF) -> None:
        box = self.plot.vb
        found = None if not box.sceneBoundingRect().contains(place) else self._nearest(box.mapSceneToView(place))
        if found is None:
            self._readout.setText("")
            self._marker.setData([], [])
            return
        series, x, y = found
        shown_x, shown_y = (np.log10(x) if self.data.x.log else x), (np.log10(y) if self.data.y.log else y)
        color = chart_color(series.color)
        self._marker.setData([shown_x], [shown_y], pen=pen(chart_color("surface"), width=1.5), brush=color)
        range_x, range_y = box.viewRange()
        left, low = shown_x < sum(range_x) / 2, shown_y < sum(range_y) / 2
        self._readout.setAnchor((0 if left else 1, 1 if low else 0))
        self._readout.setPos(shown_x, shown_y)
        self._readout.fill = pg.mkBrush(chart_color("surface", 0.9))
        places = [f"{axis.title} {_shown(axis, value)}" for axis, value in ((self.data.x, x), (self.data.y, y))]
        self._readout.setText(f"{series.name}\n{' · '.join(places)}", color=chart_color("text"))

    def _nearest(self, place: QPointF) -> tuple[Series, float, float] | None:
        """The point of a curve nearest to a place, if it is within reach."""
        pixel_x, pixel_y = self.plot.vb.viewPixelSize()
        best, reach = None, REACH_PX
        for series in self.data.series:
            x = (series.x[1:] + series.x[:-1]) / 2 if series.steps else series.x
            with np.errstate(divide="ignore", invalid="ignore"):
                across = ((np.log10(x) if self.data.x.log else x) - place.x()) / pixel_x
                up = ((np.log10(series.y) if self.data.y.log else series.y) - place.y()) / pixel_y
            distance = np.nan_to_num(np.hypot(across, up), nan=np.inf)
            index = int(np.argmin(distance)) if distance.size else -1
            if index >= 0 and distance[index] < reach:
                best, reach = (series, float(x[index]), float(series.y[index])), float(distance[index])
        return best


def _shown(axis: Axis, value: float) -> str:
    text = axis.write(float(f"{value:.4g}"))
    return f"{text} {axis.unit}".rstrip()
