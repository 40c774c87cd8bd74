"""Maps of flanks drawn flat, one or more below one another or side by side, with toe, heel, root and tip named."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pyqtgraph as pg
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QWidget

from ui.charts.canvas import Canvas
from ui.charts.colors import chart_color
from ui.charts.maps import Colors, FlankMap, MapData, Scale
from ui.charts.parts import pen
from ui.charts.records import Table
from ui.theme import is_dark
from ui.words import tr

MOST_LINES, LEAST_BLOCKS, BAR_BLOCKS, BAR_MARGIN = 4, 4, 14, 24
LEAST_ASIDE = 0.05
"""Room left and right of a map, as a share of its width."""


class MapChart(Canvas):
    """Shows a :class:`MapData`, true to scale.

    Signals
    -------
    pointed(str)
        What is under the pointer; empty when nothing is.
    """

    pointed = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.data = MapData("map")
        self._view.ci.layout.setContentsMargins(2, 2, 2, 2)
        self._view.ci.layout.setSpacing(2)
        self._plots: list[_MapPlot] = []
        self._bar: pg.LabelItem | None = None
        self._view.scene().sigMouseMoved.connect(self._on_moved)
        self.setMinimumSize(160, 120)
        self.refresh_theme()

    def show_data(self, data: MapData) -> None:
        """Show other maps; the scale stays while their places are the same."""
        before, self.data = self.data, data
        look = (len(data.maps), data.across, data.scale is None)
        if look != (len(self._plots), before.across, before.scale is None):
            self._view.clear()
            self._plots = [_MapPlot() for _ in data.maps]
            for index, plot in enumerate(self._plots):
                self._view.addItem(plot, *((0, index) if data.across else (index, 0)))
            if data.scale is not None:
                below = (1, 0, 1, len(data.maps)) if data.across else (len(data.maps), 0)
                self._bar = self._view.addLabel("", *below)
        self._fill()

    def refresh_theme(self) -> None:
        """Take the colours of the theme in use."""
        self._view.setBackground(chart_color("surface"))
        self._fill()

    @property
    def table(self) -> Table:
        """The numbers shown."""
        return self.data.table()

    def _fill(self) -> None:
        if self.data.colors is not None:
            for plot, one in zip(self._plots, self.data.maps, strict=True):
                plot.show_map(one, self.data.colors(one.image))
            self._fill_bar()

    def _fill_bar(self) -> None:
        """The scale below the maps, with as many blocks of colour as there is room for."""
        scale, colors = self.data.scale, self.data.colors
        if scale is None or colors is None or self._bar is None:
            return
        metrics = self.fontMetrics()
        words = metrics.horizontalAdvance(f"{scale.title}: {scale.write(scale.low)}  {scale.write(scale.high)}")
        blocks = (self.width() - words - BAR_MARGIN) // max(metrics.horizontalAdvance("█"), 1)
        self._bar.setText(_bar_text(scale, colors, min(max(blocks, LEAST_BLOCKS), BAR_BLOCKS)))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fill_bar()

    def _on_moved(self, place: QPointF) -> None:
        for plot, one in zip(self._plots, self.data.maps, strict=True):
            if plot.vb.sceneBoundingRect().contains(place):
                value = _value_at(one, plot.vb.mapSceneToView(place))
                self.pointed.emit(f"{one.title}: {one.describe(value)}" if value is not None else "")
                return
        self.pointed.emit("")


class _MapPlot(pg.PlotItem):
    """One map without axes."""

    def __init__(self) -> None:
        super().__init__()
        for side in ("left", "bottom"):
            self.hideAxis(side)
        self.hideButtons()
        self.setMenuEnabled(False)
        self.setMouseEnabled(False, False)
        self.vb.setAspectLocked(True)
        self.vb.setDefaultPadding(0.02)
        self._picture = pg.ImageItem(axisOrder="row-major")
        self._outline = pg.PlotCurveItem()
        self._words = [pg.TextItem(tr(text), anchor=anchor) for text, anchor in _WORDS]
        self._lines = [pg.PlotCurveItem() for _ in range(MOST_LINES)]
        self._drawn: tuple[object, ...] = ()
        self._inside = QRectF()
        self.vb.sigResized.connect(lambda *_: self._fit())
        for item in (self._picture, self._outline, *self._lines, *self._words):
            self.addItem(item)

    def show_map(self, one: FlankMap, colors: NDArray[np.uint8]) -> None:
        """Draw a map; words and edge only when they are others."""
        self._picture.setImage(colors, autoLevels=False)
        self._picture.setRect(QRectF(*one.extent))
        for index, item in enumerate(self._lines):
            line = one.lines[index] if index < len(one.lines) else None
            points = np.empty((0, 2)) if line is None else line.points
            look = None if line is None else pen(chart_color(line.color), width=line.width)
            item.setData(*points.T, pen=look, connect="pairs" if line is not None and line.pairs else "all")
        drawn = (one.title, one.outline.tobytes(), is_dark())
        if drawn != self._drawn:
            self._drawn = drawn
            self._frame(one)

    def _frame(self, one: FlankMap) -> None:
        self.setTitle(one.title, color=chart_color("text"), size="9pt")
        self._outline.setData(*one.outline.T, pen=pen(chart_color("muted"), width=1.2))
        (x, y), (width, height) = one.outline.min(axis=0), np.ptp(one.outline, axis=0)
        middle, beyond = x + width / 2, 0.7 * one.reach
        places = (x, y + height / 2), (x + width, y + height / 2), (middle, y - beyond), (middle, y + height + beyond)
        for word, place in zip(self._words, places, strict=True):
            word.setPos(*place)
            word.setColor(chart_color("muted"))
        low, high = y - max(0.12 * height, one.reach), y + height + max(0.12 * height, one.reach)
        self._inside = QRectF(x, low, width, high - low)
        self._fit()

    def _fit(self) -> None:
        """Show the map with room for the words beside it."""
        if self._inside.isEmpty():
            return
        words, room = max(word.boundingRect().width() for word in self._words[:2]) + 4, self.vb.width()
        share = words / (room - 2 * words) if room > 4 * words else 0.5
        aside = max(share, LEAST_ASIDE) * self._inside.width()
        self.vb.setRange(self._inside.adjusted(-aside, 0, aside, 0), padding=0)


_WORDS: Sequence[tuple[str, tuple[float, float]]] = (
    ("toe", (1, 0.5)),
    ("heel", (0, 0.5)),
    ("root", (0.5, 0.35)),
    ("tip", (0.5, 0.65)),
)


def _value_at(one: FlankMap, place: QPointF) -> float | None:
    x, y, width, height = one.extent
    rows, columns = one.image.shape
    row, column = int((place.y() - y) / height * rows), int((place.x() - x) / width * columns)
    if not (0 <= row < rows and 0 <= column < columns) or np.isnan(one.image[row, column]):
        return None
    return float(one.image[row, column])


def _bar_text(scale: Scale, colors: Colors, blocks: int) -> str:
    """The colours of a scale in a line of text, between its ends."""
    shades = colors(np.linspace(scale.low, scale.high, blocks))[:, :3]
    bar = "".join(f'<span style="color:#{r:02x}{g:02x}{b:02x}">█</span>' for r, g, b in shades)
    low, high = scale.write(scale.low), scale.write(scale.high)
    return f'<span style="color:{chart_color("muted").name()}">{scale.title}: {low}&nbsp;{bar}&nbsp;{high}</span>'
